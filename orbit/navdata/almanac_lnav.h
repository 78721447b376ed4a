// SPDX-License-Identifier: GPL-3.0-or-later
// GPS almanac: the rough orbit and clock that every satellite sends of all others (IS-GPS-200N
// 20.3.3.5.1.2, 20.3.3.5.2.1, table 20-VI), fitted to a precise orbit, and evaluated as a receiver does.
#ifndef ORR_ORBIT_NAVDATA_ALMANAC_LNAV_H
#define ORR_ORBIT_NAVDATA_ALMANAC_LNAV_H

#include "orbit/navdata/lnav_bits.h"
#include "orbit/navdata/navfit.h"

// Seven parameters (e, i, OMEGADOT, sqrt(A), OMEGA0, omega, M0) at toa by least squares over what the source
// has within [from, to], rounded to the lattice together; number and toa_s are filled too, clock and health
// (zero on return) are the caller's. toa is a multiple of 4096 s of its week, at most half a week outside the
// window. [from, to] is usually a day about toa; 2 to 26 h, of which the source must know about two. The
// model has no harmonics: what the Earth's flattening does twice a revolution, and to the mean motion, is
// allowed for in the fit and then left out, so that a few hours do not give an orbit of their own (12 km off
// in the same day, otherwise 2.3). OMEGADOT leans on theory when the window is short. The report compares the
// rounded model with the source over the window. From a whole day: 0.67 km RMS in it, 1.1 km the day after,
// 10 km six days later, when the Moon has changed the mean motion (real.orbit.almanac). Errors: ORR_E_ARG
// (GPS 1-32 alone have a place in the almanac; window; toa), ORR_E_NODATA with less than two hours of
// positions, ORR_E_RANGE with the field's name (e is below 0.03), ORR_E_NUMERIC.
orr_status orr_almanac_lnav_fit(orr_sat sat, orr_time toa, orr_time from, orr_time to,
                                orr_navfit_source source, void *user, orr_lnav_almanac *almanac,
                                orr_navfit_report *report, orr_diag *diag);

// af0 and af1 at toa from the product's clock over [from, to], rounded to 2^-20 s and 2^-38 s/s. *rms_s (may
// be NULL) is what is left; the LSBs alone allow 0.3 us. ORR_E_NODATA with fewer than two clock values,
// ORR_E_RANGE for a clock beyond 0.97 ms.
orr_status orr_almanac_lnav_clock(const orr_ephemeris *e, orr_sat sat, orr_time toa, orr_time from,
                                  orr_time to, orr_lnav_almanac *almanac, double *rms_s, orr_diag *diag);

// Position (ecef) and clock by an almanac whose toa is that instant, as in 20.3.3.5.2.1; either output may be
// NULL. ORR_E_RANGE further than four weeks from toa, ORR_E_NUMERIC for elements that are no orbit.
orr_status orr_almanac_lnav_eval(const orr_lnav_almanac *a, orr_time toa, orr_time t, orr_vec3 *pos_m,
                                 double *clock_s);

#endif
