// SPDX-License-Identifier: GPL-3.0-or-later
// GLONASS almanac: the rough orbit that every satellite sends of all others (GLONASS ICD L1/L2 edition 5.1,
// 2008, 4.5), the receiver's algorithm for it, and its fit to a precise orbit. Pure functions.
#ifndef ORR_ORBIT_NAVDATA_ALMANAC_GLONASS_H
#define ORR_ORBIT_NAVDATA_ALMANAC_GLONASS_H

#include "orbit/navdata/glonass_time.h"
#include "orbit/navdata/navfit.h"

// Table 4.9, superscript A left out. Angles are radians where the message has semicircles.
typedef struct orr_glonass_almanac {
    int number;                 // n: slot 1..24
    bool operational;           // C_n: may be used
    int type;                   // M_n: 0 GLONASS, 1 GLONASS-M
    int channel;                // H_n: -7..24
    orr_time day;               // N: begin of the almanac's day in Moscow (orr_glonass_day)
    double tau_s;               // tau_n: correction to the satellite's clock, the opposite of af0
    double lambda_rad;          // longitude of the day's first ascending node
    double t_lambda_s;          // its instant, seconds of the day in Moscow
    double delta_i_rad;         // inclination less 63 degrees
    double delta_t_s;           // draconic period less 43200 s
    double delta_t_rate;        // its change, s per revolution, per revolution
    double e, omega_rad;        // eccentricity, argument of perigee
    const orr_leap_table *leap; // that days are counted by; NULL: built-in
} orr_glonass_almanac;

// What one bit of a word is worth.
#define ORR_GLONASS_ALM_TAU_LSB_S (1.0 / 262144)         // 2^-18
#define ORR_GLONASS_ALM_ANGLE_LSB_RAD (ORR_PI / 1048576) // 2^-20 semicircles: lambda, delta i
#define ORR_GLONASS_ALM_OMEGA_LSB_RAD (ORR_PI / 32768)   // 2^-15 semicircles
#define ORR_GLONASS_ALM_E_LSB (1.0 / 1048576)            // 2^-20
#define ORR_GLONASS_ALM_T_LAMBDA_LSB_S (1.0 / 32)        // 2^-5
#define ORR_GLONASS_ALM_DELTA_T_LSB_S (1.0 / 512)        // 2^-9
#define ORR_GLONASS_ALM_RATE_LSB (1.0 / 16384)           // 2^-14

// Position and velocity at t, PZ-90 axes turning with the Earth, by A.3.2.2 to the letter: secular terms of
// C20 are added to a motion that has the draconic period already, so that the satellite jumps back by 4.8 km
// at every ascending node (the ICD's own example, A.3.2.3, shows them). The velocity is that of the
// osculating ellipse, within 0.2 m/s of the positions' derivative. ORR_E_NUMERIC for elements that are no
// orbit.
orr_status orr_glonass_almanac_eval(const orr_glonass_almanac *a, orr_time t, orr_vec3 *pos_m,
                                    orr_vec3 *vel_mps);

// Fits an almanac to one day of a precise orbit.
// Given:
//   sat     GLONASS satellite, slot 1 to 24
//   day     any instant of the day in Moscow that the almanac is for
//   leap    table of leap seconds, which has to outlive the almanac; NULL: built-in
//   source  position of the satellite, ecef, m; asked every 15 min of that day
//   user    handed to source
// Returned:
//   a       number, day and orbit; delta_t_rate is zero (one day does not determine it; its field ends at 0.004 s),
//           operational is true. The caller sets tau_s, channel and type
//   report  the almanac against the source over the day
//   diag    why it failed; may be NULL
// Errors: ORR_E_ARG if sat is no slot of GLONASS, ORR_E_NODATA with less than half a day of positions, ORR_E_NUMERIC if they
// are not such an orbit, ORR_E_RANGE if a word does not fit its field.
// Notes: least squares by the algorithm of orr_glonass_almanac_eval; each word is rounded to its LSB in turn and the rest
// fitted again. report->rms_m is about a kilometre: the algorithm's jump at the nodes, spread over the day.
// Reference: GLONASS ICD L1/L2 edition 5.1, 2008, A.3.2.
orr_status orr_glonass_almanac_fit(orr_sat sat, orr_time day, const orr_leap_table *leap,
                                   orr_navfit_source source, void *user, orr_glonass_almanac *a,
                                   orr_navfit_report *report, orr_diag *diag);

#endif
