// SPDX-License-Identifier: GPL-3.0-or-later
// Turbulence of water vapour: a random field of zenith wet delay that the wind carries over the antennas. A pure function of
// scenario, time and place.
#ifndef ORR_SCENARIO_TROPOSPHERE_TURBULENCE_H
#define ORR_SCENARIO_TROPOSPHERE_TURBULENCE_H

#include "core/status.h"
#include "core/time.h"
#include "core/vec.h"
#include "src/config/section_channel.h"

typedef struct orr_turbulence orr_turbulence;

// Prepares the field.
// Given:
//   s        section troposphere.turbulence
//   r_m      its origin, ecef
//   enu      rows: East, North and Up there
// Returned:
//   out      the field; close with orr_turbulence_close
//   diag     ORR_E_MEMORY
// Notes: refractivity with Kolmogorov's structure C^2 r^(2/3) in a layer on the ground, summed up along the vertical, frozen and
// carried by the wind (Treuhaft and Lanyi 1987, Radio Sci. 22:251). It is a sum of plane waves of 100 m to 300 km whose powers are
// those of the layer's two-dimensional spectrum; a ray meets it at half the layer's thickness.
orr_status orr_turbulence_open(const orr_scenario_turbulence *s, orr_vec3 r_m, const orr_mat3 *enu,
                               orr_turbulence **out, orr_diag *diag);
void orr_turbulence_close(orr_turbulence *f); // NULL is allowed

// A ray from an antenna.
typedef struct orr_turbulence_ray {
    orr_vec3 r_m, v_mps;   // antenna, ecef
    orr_vec3 u, u_rate_ps; // East, North and Up of the place: unit vector to the satellite, and its rate
} orr_turbulence_ray;

// Slant delay of a ray at an instant, m, and its rate: that of the zenith above the place where it meets the field, over
// sqrt(sin(el)^2 + 0.03^2), which is the wet mapping to 1 % down to 5 deg. Higher than the origin there is less of it, and none above
// the layer.
double orr_turbulence_slant_m(const orr_turbulence *f, const orr_turbulence_ray *ray, orr_time t,
                              double *rate_mps);

// How long blocks may be for their cubics to hold it to error_m.
int64_t orr_turbulence_block_ns(const orr_turbulence *f, double error_m);

// The structure function of the zenith delay that the field is made for, m^2: mean square of the difference over a distance.
double orr_turbulence_structure_m2(const orr_scenario_turbulence *s, double distance_m);

#endif
