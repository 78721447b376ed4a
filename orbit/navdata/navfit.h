// SPDX-License-Identifier: GPL-3.0-or-later
// The way back: broadcast parameters that stand for the precise orbit over a window, quantised as they are
// transmitted, so that a generator modulates data that agree with its ranges.
#ifndef ORR_ORBIT_NAVDATA_NAVFIT_H
#define ORR_ORBIT_NAVDATA_NAVFIT_H

#include "ingest/rinex/rinex_nav.h"
#include "orbit/ephemeris/ephemeris.h"
#include "orbit/force/kepler.h"

// Where a satellite's antenna is at an instant: fits go through this, so that a caller may add the
// phase-centre offset. Returns ORR_OK and fills pos (ecef, m), or says that there is nothing.
typedef orr_status (*orr_navfit_source)(void *user, orr_time t, orr_vec3 *pos_m);

typedef struct orr_navfit_report {
    size_t n;            // positions compared
    double rms_m, max_m; // 3-D, model from the quantised parameters against the source, over the window
    double fit_rms_m;    // the same before quantisation
} orr_navfit_report;

// The window [from, to] is where the orbit is known; it need not be centred on the parameters' instant (toe,
// tb), which may stand at its edge or outside it by no more than its length: at the ends of a product the
// window is shifted inward. Positions are taken at most 300 s apart, in 24 intervals at least, both ends
// included; instants where the source has nothing (a gap) are left out. Whatever happens within the window,
// one smooth orbit is fitted: after a manoeuvre the fit is what it is, and report.max_m tells.
//
// Common errors: ORR_E_ARG (length of the window, instant), ORR_E_NODATA if the source has fewer than 9
// positions in the window, ORR_E_RANGE with the field's name if a parameter does not fit its field,
// ORR_E_NUMERIC where the positions are no such orbit.

// Fits the Kepler parameters of a message to a precise orbit and quantises them.
// Given:
//   sat, message    satellite, and one of the messages with Kepler elements that its system sends
//   toe             reference time, a multiple of the message's step in the system's own week: 16 s (LNAV), 60 s (I/NAV,
//                   F/NAV), 8 s (D1, D2), 300 s (CNAV and its kin)
//   from, to        window of the positions, 1800 to 21600 s long
//   source, user    positions, as above
// Returned:
//   eph             kepler (quantised), toe, toc, week, kind and message; the caller sets clock, delays, issue and health, which
//                   are unknown (NAN, -1) so far
//   report          quantised model against the source
//   diag            why it failed; may be NULL
// Notes: least squares over the window, then, of all values that the message can send, those that together fit best
// (integer least squares, orbit/navdata/lattice.h). What a short window does not determine stays near its usual value with
// weights of millimetres: rates near those caused by the Earth's flattening, harmonics near zero. A rate or harmonic whose
// best value its field cannot hold is kept at the field's end and the rest fitted again.
// Reference: the tables named in kepler_lattice.c.
orr_status orr_navfit_kepler(orr_sat sat, orr_nav_message message, orr_time toe, orr_time from, orr_time to,
                             orr_navfit_source source, void *user, orr_nav_eph *eph,
                             orr_navfit_report *report, orr_diag *diag);

// The fifteen mean elements of the GPS interface's model over a span: six elements, three rates, six amplitudes at twice the argument of
// latitude, none quantised. Angles in ecef axes that stand still as they are at the elements' instant.
typedef struct orr_mean_elements {
    orr_kepler k;                                     // gm of core/constants.h (EGM96)
    double delta_n_radps, idot_radps, raan_dot_radps; // the rate of the node is that in inertial axes
    double crc_m, crs_m, cuc_rad, cus_rad, cic_rad, cis_rad;
    double rms_m; // 3-D, model against the positions
} orr_mean_elements;

// Fits the fifteen mean elements to an orbit of any system.
// Given:
//   t             their instant
//   from, to      span of the positions: a revolution about t makes the elements mean ones
//   source, user  positions, as above
// Returned:
//   out           elements
//   diag          why it failed; may be NULL
// Errors: the common ones above. Notes: what the model leaves of a whole revolution (tens of metres) is rms_m.
// Reference: IS-GPS-200N, table 20-IV.
orr_status orr_navfit_mean(orr_time t, orr_time from, orr_time to, orr_navfit_source source, void *user,
                           orr_mean_elements *out, orr_diag *diag);

// Fits position, velocity and acceleration of a GLONASS record at tb to a precise orbit and quantises them.
// Given:
//   sat           GLONASS satellite
//   tb            reference time
//   from, to      window of the positions, 600 to 7200 s long, usually tb +- 900 s
//   source, user  positions, as above
// Returned:
//   eph           state (quantised: 2^-11 km, 2^-20 km/s, 2^-30 km/s^2); the caller sets clock, channel and health
//   report        quantised model against the source
//   diag          why it failed; may be NULL
// Notes: the acceleration starts from that of Sun and Moon at tb. Positions are PZ-90.11, taken equal to ITRF.
// Reference: GLONASS ICD L1/L2 edition 5.1, 2008, A.3.1.
orr_status orr_navfit_glonass(orr_sat sat, orr_time tb, orr_time from, orr_time to, orr_navfit_source source,
                              void *user, orr_nav_eph *eph, orr_navfit_report *report, orr_diag *diag);

// Fits position, velocity and acceleration of an SBAS record at t0 to an orbit and quantises them.
// Given:
//   sat           SBAS satellite
//   t0            reference time, a multiple of 16 s
//   from, to      window of the positions, 60 to 900 s long
//   source, user  positions, as above
// Returned:
//   eph           state on the lattice of message 9; the caller sets clock, accuracy and health
//   report        quantised model against the source
//   diag          why it failed; may be NULL
// Reference: RTCA DO-229E A.4.4.11.
orr_status orr_navfit_geo(orr_sat sat, orr_time t0, orr_time from, orr_time to, orr_navfit_source source,
                          void *user, orr_nav_eph *eph, orr_navfit_report *report, orr_diag *diag);

// Displaces a fitted GLONASS record at its tb along radius, track and normal of the orbit, the displacement turning with it, and
// quantises it again. Its acceleration stays: no field of the message could hold an orbit so displaced for long, and over a quarter of
// an hour the record drifts by 2 % of a radial displacement.
void orr_navfit_glonass_displace(orr_nav_eph *eph, orr_vec3 displaced_m);

// Fits a clock polynomial to the product's clock and quantises it.
// Given:
//   e         orbit product
//   sat       satellite
//   t0        reference time, within the window or outside
//   from, to  window of the clock values
//   shift_s   added to them: from the clock of the product's signals to that of the message's
//   eph       its message decides on the fields
// Returned:
//   eph       af0 and af1 (af2 = 0)
//   rms_s     residual, s; may be NULL
//   diag      why it failed; may be NULL
// Errors: ORR_E_NODATA with fewer than two clock values in the window, ORR_E_RANGE with its name if af0 does not fit its
// field.
// Notes: GLONASS' and SBAS' parameters contain the periodic relativity, as their messages define. A rate beyond its field stands at
// the field's end.
orr_status orr_navfit_clock(const orr_ephemeris *e, orr_sat sat, orr_time t0, orr_time from, orr_time to,
                            double shift_s, orr_nav_eph *eph, double *rms_s, orr_diag *diag);

// The product's satellite as a source: its centre of mass plus a constant offset in body axes of nominal
// attitude (zero, or the antenna's; X, Y, Z in metres).
typedef struct orr_navfit_product {
    const orr_ephemeris *ephemeris;
    orr_sat sat;
    double offset_m[3];
} orr_navfit_product;
// An orr_navfit_source: `product` is an orr_navfit_product. Errors: those of orr_ephemeris_eval.
orr_status orr_navfit_from_product(void *product, orr_time t, orr_vec3 *pos_m);

#endif
