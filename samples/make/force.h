// SPDX-License-Identifier: GPL-3.0-or-later
// Forces of the made truth. Richer than the smoother's on purpose: EGM96 16x16, Sun and Moon, the solid
// Earth's tide, general relativity, sunlight on a box and a wing in yaw steering with a y-bias, through a
// conical shadow.
#ifndef ORR_SAMPLES_FORCE_H
#define ORR_SAMPLES_FORCE_H

#include "core/astro.h"
#include "samples/make/constellation.h"
#include "samples/make/gravity.h"

// What all satellites share at an instant.
typedef struct orr_sample_sky {
    orr_mat3 itrs_gcrs;
    orr_vec3 sun_m, moon_m; // GCRS
} orr_sample_sky;
// Earth orientation: IERS secular pole, UT1 = UTC, LOD = 0 (core/astro.h's default without a series).
void orr_sample_sky_at(orr_time t, orr_sample_sky *sky);

// Acceleration, GCRS axes, m/s^2.
orr_vec3 orr_sample_acceleration(const orr_sample_gravity *g, const orr_sample_sky *sky,
                                 const orr_sample_body *body, orr_vec3 r_m, orr_vec3 v_mps);
// Part of the Sun's disc that is seen from r: overlap of two discs.
double orr_sample_sunlight(orr_vec3 r_m, orr_vec3 sun_m);

#endif
