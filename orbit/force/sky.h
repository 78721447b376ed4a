// SPDX-License-Identifier: GPL-3.0-or-later
// The sky over a span of time: Earth's rotation and the places of Sun and Moon in the axes orbits are
// integrated in, tabulated once from core/astro and then cheap at any instant and the same for every
// satellite.
#ifndef ORR_ORBIT_FORCE_SKY_H
#define ORR_ORBIT_FORCE_SKY_H

#include "core/astro.h"

typedef enum orr_sky_frame {
    ORR_SKY_GCRS,    // IAU 2006/2000B rotation with polar motion and UT1
    ORR_SKY_UNIFORM, // constant rate u about ecef's axis 3, coinciding with ecef at the span's begin: the
                     // source's (33)
} orr_sky_frame;

// Instant of the table: R maps integration axes to ecef; dR, ddR are its first and second time derivatives.
typedef struct orr_sky_point {
    orr_mat3 R, dR, ddR;
    orr_vec3 sun_m, moon_m; // in integration axes
    double tide[5]; // changes of C20, C21, S21, C22, S22 (orbit/force/tides.h); zero but in a precise sky
} orr_sky_point;

typedef struct orr_sky orr_sky;

// Tabulates the Earth's rotation, Sun and Moon over a span.
// Given:
//   from, to   span
//   frame      integration axes
//   eop        Earth orientation; NULL: the IERS secular pole, and UT1 by the leap seconds
//   leap       the run's table of leap seconds; NULL: built-in
// Returned:
//   out        the table; free with orr_sky_free
//   eop_known  whether the whole span was inside the series; may be NULL
//   diag       why it failed; may be NULL
// Errors: ORR_E_ARG (to < from, more than ten years), ORR_E_MEMORY.
orr_status orr_sky_init(orr_time from, orr_time to, orr_sky_frame frame, const orr_eop_series *eop,
                        const orr_leap_table *leap, orr_sky **out, bool *eop_known, orr_diag *diag);
// A precise sky in GCRS: IAU 2006/2000A, tides of the solid Earth, and a rotation that can be changed. It has
// none before orr_sky_turn. Errors as above.
orr_status orr_sky_init_precise(orr_time from, orr_time to, orr_sky **out, orr_diag *diag);
// Gives it the rotation of a series, to which the ocean's tides are added (core/eop_tides.h). The series
// covers the span, or is carried on.
void orr_sky_turn(orr_sky *sky, const orr_eop_series *eop);
// Frees a sky; NULL is none.
void orr_sky_free(orr_sky *sky);
orr_time orr_sky_origin(const orr_sky *sky); // t_s below counts from here

// Everything at t_s. Interpolation (cubic in 10-minute nodes of what is left of the rotation after a uniform
// one) errs by less than 1e-12 rad in R and 0.1 m in the Moon.
void orr_sky_at(const orr_sky *sky, double t_s, orr_sky_point *out);
// Only R, Sun, Moon and tide: what a force needs.
void orr_sky_force_point(const orr_sky *sky, double t_s, orr_sky_point *out);

// Turns an inertial state into ecef.
// Given:
//   p               the sky at the instant
//   r, v            state, integration axes, m and m/s
// Returned:
//   r_ecef, v_ecef  state, ecef; the velocity is relative to the turning axes
void orr_sky_to_ecef(const orr_sky_point *p, orr_vec3 r, orr_vec3 v, orr_vec3 *r_ecef, orr_vec3 *v_ecef);
// The inverse of orr_sky_to_ecef.
// Given:
//   p               the sky at the instant
//   r_ecef, v_ecef  state, ecef, m and m/s
// Returned:
//   r, v            state, integration axes
void orr_sky_from_ecef(const orr_sky_point *p, orr_vec3 r_ecef, orr_vec3 v_ecef, orr_vec3 *r, orr_vec3 *v);

#endif
