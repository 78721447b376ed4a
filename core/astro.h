// SPDX-License-Identifier: GPL-3.0-or-later
// Earth rotation, Sun and Moon, from ERFA (IAU 2006 precession, 2000B nutation unless told otherwise).
// ITRS = ecef of SP3; GCRS = the inertial axes that orbits are integrated in.
#ifndef ORR_CORE_ASTRO_H
#define ORR_CORE_ASTRO_H

#include "core/time.h"
#include "core/vec.h"

// Earth orientation at an instant.
typedef struct orr_eop {
    double xp_rad, yp_rad; // pole
    double ut1_utc_s;
    double lod_s; // excess length of day
    // Of the pole; zero where unknown. 3 mas a day is 4 um/s at a satellite.
    double xp_rate_radps, yp_rate_radps;
} orr_eop;

// A series of them (daily, from an ERP file), ascending in MJD UTC. Their lod_s and rates may be left zero. UTC is that
// of the built-in table of leap seconds: who reads or writes files by another one converts.
typedef struct orr_eop_series {
    size_t n;
    double *mjd_utc;
    orr_eop *value;
} orr_eop_series;

// Inside the series: cubic Hermite with slopes from the neighbours (no kink at a node; straight lines stay
// straight), of UT1 - TAI and hence continuous across leap seconds; UT1 - UTC is returned by `leap` (the run's table,
// NULL: built-in), and whoever turns by it hands on the same. lod_s and the rates are the derivatives
// of what is returned, so that orr_astro_gcrs_to_itrs's dR is the derivative of its R. With NULL or fewer
// than two entries the IERS secular pole xs = 55.0 + 1.677 (t - 2000), ys = 320.5 + 3.460 (t - 2000) mas (t
// in years; IERS Conventions 2010, updated 2018, 7.1.4), and UT1 as the leap seconds tell it: a smooth curve
// through the middle of each step, right to 0.4 s; UT1 - UTC = LOD = 0 from three years after the last one
// on. Before and after a series its last value and slope are carried on, the slope for some ten days; so are both ends
// of a gap of more than three days, and blended. *from_series (may be NULL) tells whether the series covers t.
orr_eop orr_eop_at(const orr_eop_series *s, orr_time t, const orr_leap_table *leap, bool *from_series);
// The same as a node of another series, whose UT1 - UTC is by the built-in table: UT1 itself is that of the run's.
orr_eop orr_eop_node(const orr_eop_series *s, orr_time t, const orr_leap_table *leap);

// The rotation from GCRS to ITRS: r_itrs = R r_gcrs, v_itrs = R v_gcrs + dR r_gcrs.
//   Given:    t      the instant
//             eop    Earth orientation at it (orr_eop_at)
//             leap   table of leap seconds; NULL: built-in
//   Returned: R      the rotation
//             dR     its full time derivative, 1/s: precession-nutation, Earth rotation, LOD and the rates of
//                    the pole; may be NULL
//   Notes:    IAU 2006 precession with IAU 2000B nutation.
void orr_astro_gcrs_to_itrs(orr_time t, const orr_eop *eop, const orr_leap_table *leap, orr_mat3 *R,
                            orr_mat3 *dR);
// The first of the two parts of that rotation, by IAU 2006/2000A (a microarcsecond; 2000B above errs by up to
// 1 mas): GCRS to the celestial intermediate frame, which turns slowly.
orr_mat3 orr_astro_gcrs_to_cirs(orr_time t);
// The second: from the celestial intermediate frame to ITRS, by UT1 and the pole. leap NULL: built-in.
orr_mat3 orr_astro_cirs_to_itrs(orr_time t, const orr_eop *eop, const orr_leap_table *leap);
// GCRS to the true equator and equinox of date (frame of osculating elements).
void orr_astro_gcrs_to_tod(orr_time t, orr_mat3 *R);

// Geocentric positions in GCRS, metres. Sun: eraEpv00 (13 km at most in 1900-2100); Moon: eraMoon98 (some
// km).
orr_vec3 orr_astro_sun(orr_time t);
// The Moon, as above.
orr_vec3 orr_astro_moon(orr_time t);

// Velocity in the inertial sense, in ecef's axes of the instant: v + u x r.
static inline orr_vec3 orr_velocity_inertial(orr_vec3 r_m, orr_vec3 v_mps)
{
    return orr_vec3_add(v_mps, orr_vec3_cross((orr_vec3){0, 0, ORR_EARTH_RATE_RADPS}, r_m));
}

#endif
