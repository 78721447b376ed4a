// SPDX-License-Identifier: GPL-3.0-or-later
// A made constellation for tests of the product: Kepler ellipses in axes that turn uniformly, so that
// position, velocity and acceleration in ecef are closed forms at any instant.
#ifndef ORR_TESTS_MADE_ORBIT_H
#define ORR_TESTS_MADE_ORBIT_H

#include "orbit/ephemeris/ephemeris.h"

typedef struct made_satellite {
    orr_sat sat;
    double a_m, e, i_rad, raan_rad, argp_rad, m0_rad;
} made_satellite;

// Satellite k of a mixed constellation: near-circular GPS and GLONASS orbits, and eccentric Galileo ones (e =
// 0.16, as E14 and E18 have).
made_satellite made_satellite_at(size_t k);
// Its state t_s seconds after the made day's midnight, ecef.
void made_state(const made_satellite *m, double t_s, orr_vec3 *pos, orr_vec3 *vel, orr_vec3 *acc);
double made_clock(const made_satellite *m, double t_s); // linear in time

extern const orr_time made_midnight;

// A solution of n_sats satellites over [0, hours] with segments of segment_s made of per_segment samples;
// clock nodes each 300 s; one eclipse and one manoeuvre event each. Free with made_solution_free.
orr_orbit_solution made_solution(size_t n_sats, double hours, double segment_s, size_t per_segment);
void made_solution_free(orr_orbit_solution *s);

#endif
