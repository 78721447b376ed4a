// SPDX-License-Identifier: GPL-3.0-or-later
// Almanacs of Kepler elements: the rough orbit and clock that every satellite sends of all others of its system, fitted to a
// precise orbit (IS-GPS-200N 20.3.3.5.1.2 and table 20-VI; Galileo OS SIS ICD 2.1, 5.1.10; BDS-SIS-ICD-B1I 3.0, 5.2.4.15; IS-QZSS-PNT-005,
// 4.1.2.6).
#ifndef ORR_ORBIT_NAVDATA_ALMANAC_KEPLER_H
#define ORR_ORBIT_NAVDATA_ALMANAC_KEPLER_H

#include "orbit/navdata/field.h"
#include "orbit/navdata/navfit.h"

// One satellite's almanac: reduced-precision elements at toa.
typedef struct orr_almanac {
    int number;
    double e, toa_s,
        i_offset_rad; // from the message's reference: 0.30 semicircles, of Galileo 56 deg, of QZSS 0.25 semicircles,
                      // of geostationary satellites
                      // and of NavIC 0
    double omega_dot_radps, sqrt_a_sqrtm, omega0_rad, omega_rad, m0_rad;
    double af0_s, af1_sps;
    uint32_t health; // the system's own bits
} orr_almanac;

typedef enum orr_almanac_part { // its parameters, in the order of the fit
    ORR_ALMANAC_SQRT_A,
    ORR_ALMANAC_E,
    ORR_ALMANAC_OMEGA,
    ORR_ALMANAC_M0,
    ORR_ALMANAC_DELTA_I,
    ORR_ALMANAC_OMEGA0,
    ORR_ALMANAC_OMEGA_DOT,
    ORR_ALMANAC_AF0,
    ORR_ALMANAC_AF1,
    ORR_ALMANAC_PARTS
} orr_almanac_part;
// An almanac's parameters in that order.
void orr_almanac_values(const orr_almanac *a, double value[ORR_ALMANAC_PARTS]);

// In which fields a system's almanac is sent.
typedef struct orr_almanac_lattice orr_almanac_lattice;
// That of a satellite's system; NULL for satellites that have no place in one.
const orr_almanac_lattice *orr_almanac_lattice_of(orr_sat sat);
// The field of a parameter.
const orr_navfit_field *orr_almanac_field(const orr_almanac_lattice *l, orr_almanac_part part);
// Step in which toa is sent, s of the system's week.
int orr_almanac_toa_step_s(const orr_almanac_lattice *l);

// Inclination of an almanac, rad: the system's reference and what is sent above it.
double orr_almanac_inclination(orr_sat sat, const orr_almanac *a);

// Fits the seven orbital parameters of an almanac (e, i, OMEGADOT, sqrt(A), OMEGA0, omega, M0) to a precise orbit.
// Given:
//   sat       GPS 1 to 32, Galileo 1 to 36, BeiDou 1 to 63, QZSS 1 to 10, NavIC 1 to 14
//   toa       reference time, a multiple of the message's step (4096 s, Galileo 600 s) of its week, at most half a week
//             outside the window
//   from, to  window of the positions, 2 to 26 h, usually a day about toa; about two hours of it must be known
//   source    position of the satellite, ecef, m
//   user      handed to source
// Returned:
//   almanac   number, toa_s and the orbit on the message's lattice; clock and health are zero and the caller's to set
//   report    the rounded model against the source over the window
//   diag      why it failed; may be NULL
// Errors: ORR_E_ARG (satellite, window, toa), ORR_E_NODATA with less than two hours of positions, ORR_E_RANGE with the
// field's name (GPS and Galileo send e below 0.03), ORR_E_NUMERIC.
// Notes: the model has no harmonics. What the Earth's flattening does twice a revolution, and to the mean motion, is
// allowed for in the fit and then left out, so that a few hours do not give an orbit of their own (12 km off in the same
// day, otherwise 2.3). OMEGADOT is tied to its theoretical value when the window is short. From a whole day: 0.67 km RMS
// in it, 1.1 km the day after, 10 km six days later, when the Moon has changed the mean motion (real.orbit.almanac).
// Reference: IS-GPS-200N 20.3.3.5.1.2 and table 20-VI.
orr_status orr_almanac_fit(orr_sat sat, orr_time toa, orr_time from, orr_time to, orr_navfit_source source,
                           void *user, orr_almanac *almanac, orr_navfit_report *report, orr_diag *diag);

// Fits af0 and af1 of an almanac to the product's clock.
// Given:
//   e         orbit product
//   sat       as above
//   toa       reference time of the almanac
//   from, to  window of the clock values
// Returned:
//   almanac   af0_s and af1_sps, on the message's lattice
//   rms_s     residual, s; may be NULL. GPS' LSBs alone allow 0.3 us
//   diag      why it failed; may be NULL
// Errors: ORR_E_NODATA with fewer than two clock values, ORR_E_RANGE for a clock beyond its field (GPS 0.97 ms).
orr_status orr_almanac_clock(const orr_ephemeris *e, orr_sat sat, orr_time toa, orr_time from, orr_time to,
                             orr_almanac *almanac, double *rms_s, orr_diag *diag);

#endif
