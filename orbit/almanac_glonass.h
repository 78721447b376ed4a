// SPDX-License-Identifier: GPL-3.0-or-later
// GLONASS almanac: the rough orbit that every satellite sends of all others (GLONASS ICD L1/L2 5.1, 4.5).
// Pure functions.
#ifndef ORR_ORBIT_ALMANAC_GLONASS_H
#define ORR_ORBIT_ALMANAC_GLONASS_H

#include "core/time.h"
#include "core/vec.h"

// Table 4.9, superscript A left out. Angles are radians where the message has semicircles.
typedef struct orr_glonass_almanac {
    int number;          // n: slot 1..24
    bool operational;    // C_n: may be used
    int type;            // M_n: 0 GLONASS, 1 GLONASS-M
    int channel;         // H_n: -7..24
    orr_time day;        // N: begin of the almanac's day in Moscow (UTC + 3 h)
    double tau_s;        // tau_n: correction to the satellite's clock, the opposite of af0
    double lambda_rad;   // longitude of the day's first ascending node
    double t_lambda_s;   // its instant, seconds of the day in Moscow
    double delta_i_rad;  // inclination less 63 degrees
    double delta_t_s;    // draconic period less 43200 s
    double delta_t_rate; // its change, s per revolution, per revolution
    double e, omega_rad; // eccentricity, argument of perigee
} orr_glonass_almanac;

#endif
