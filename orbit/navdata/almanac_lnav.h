// SPDX-License-Identifier: GPL-3.0-or-later
// GPS almanac: the rough orbit and clock that every satellite sends of all others (IS-GPS-200N
// 20.3.3.5.1.2, 20.3.3.5.2.1, table 20-VI), fitted to a precise orbit, and evaluated as a receiver does.
#ifndef ORR_ORBIT_NAVDATA_ALMANAC_LNAV_H
#define ORR_ORBIT_NAVDATA_ALMANAC_LNAV_H

#include "orbit/navdata/lnav_bits.h"
#include "orbit/navdata/navfit.h"

// Fits the seven orbital parameters of a GPS almanac (e, i, OMEGADOT, sqrt(A), OMEGA0, omega, M0) to a precise orbit.
// Given:
//   sat       GPS 1 to 32, which alone have a place in the almanac
//   toa       reference time, a multiple of 4096 s of its week, at most half a week outside the window
//   from, to  window of the positions, 2 to 26 h, usually a day about toa; about two hours of it must be known
//   source    position of the satellite, ecef, m
//   user      handed to source
// Returned:
//   almanac   number, toa_s and the orbit on the message's lattice; clock and health are zero and the caller's to set
//   report    the rounded model against the source over the window
//   diag      why it failed; may be NULL
// Errors: ORR_E_ARG (satellite, window, toa), ORR_E_NODATA with less than two hours of positions, ORR_E_RANGE with the
// field's name (e is below 0.03), ORR_E_NUMERIC.
// Notes: the model has no harmonics. What the Earth's flattening does twice a revolution, and to the mean motion, is
// allowed for in the fit and then left out, so that a few hours do not give an orbit of their own (12 km off in the same
// day, otherwise 2.3). OMEGADOT is tied to its theoretical value when the window is short. From a whole day: 0.67 km RMS
// in it, 1.1 km the day after, 10 km six days later, when the Moon has changed the mean motion (real.orbit.almanac).
// Reference: IS-GPS-200N 20.3.3.5.1.2 and table 20-VI.
orr_status orr_almanac_lnav_fit(orr_sat sat, orr_time toa, orr_time from, orr_time to,
                                orr_navfit_source source, void *user, orr_lnav_almanac *almanac,
                                orr_navfit_report *report, orr_diag *diag);

// Fits af0 and af1 of a GPS almanac to the product's clock.
// Given:
//   e         orbit product
//   sat       GPS 1 to 32
//   toa       reference time of the almanac
//   from, to  window of the clock values
// Returned:
//   almanac   af0_s and af1_sps, rounded to 2^-20 s and 2^-38 s/s
//   rms_s     residual, s; may be NULL. The LSBs alone allow 0.3 us
//   diag      why it failed; may be NULL
// Errors: ORR_E_NODATA with fewer than two clock values, ORR_E_RANGE for a clock beyond 0.97 ms.
orr_status orr_almanac_lnav_clock(const orr_ephemeris *e, orr_sat sat, orr_time toa, orr_time from,
                                  orr_time to, orr_lnav_almanac *almanac, double *rms_s, orr_diag *diag);

// Evaluates a GPS almanac as a receiver does.
// Given:
//   a        almanac
//   toa      its reference time as an instant (the week belongs to it)
//   t        instant asked for
// Returned:
//   pos_m    position, ecef, m; may be NULL
//   clock_s  satellite clock, s; may be NULL
// Errors: ORR_E_RANGE further than four weeks from toa, ORR_E_NUMERIC for elements that are no orbit.
// Reference: IS-GPS-200N 20.3.3.5.2.1.
orr_status orr_almanac_lnav_eval(const orr_lnav_almanac *a, orr_time toa, orr_time t, orr_vec3 *pos_m,
                                 double *clock_s);

#endif
