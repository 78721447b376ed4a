// SPDX-License-Identifier: GPL-3.0-or-later
// Made constellations with known truth for tests of the smoother: orbits integrated with the project's forces
// plus an acceleration that the smoother does not know, sampled into an SP3 with its rounding, and then
// spoilt on purpose.
#ifndef ORR_TESTS_MADE_SP3_H
#define ORR_TESTS_MADE_SP3_H

#include "ingest/sp3/sp3.h"
#include "orbit/force/integrate.h"
#include "orbit/smooth/solution.h"

#define MADE_STEP_S 300.0
#define MADE_MAX_EPOCHS 900

typedef struct made_truth { // one satellite, every 300 s, ecef
    orr_sat sat;
    size_t n;
    orr_vec3 r[MADE_MAX_EPOCHS], v[MADE_MAX_EPOCHS];
} made_truth;

typedef struct made_sky {
    orr_time t0;
    size_t n; // epochs of 300 s
    orr_sky *sky;
    orr_force force;
} made_sky;

void made_sky_init(made_sky *m, const char *t0, double days);
void made_sky_free(made_sky *m);
// Near-circular (or not) orbit; `unknown_mps2` is the size of a slowly turning acceleration beyond the
// smoother's model. push (m/s, along the velocity) is given at push_s when push_s >= 0.
void made_orbit(const made_sky *m, orr_sat sat, double a_m, double e, double incl_rad, double raan_rad,
                double u_rad, double unknown_mps2, double push_s, double push_mps, made_truth *out);
// Epochs of the truth every `step` (a multiple of 300 s), rounded to SP3's millimetre; from epoch index
// `from` to `to`.
void made_sp3(const made_sky *m, const made_truth *const *truth, size_t n_sats, size_t from, size_t to,
              size_t step, orr_sp3 *out);
void made_sp3_free(orr_sp3 *sp3);
orr_sp3_record *made_record(orr_sp3 *sp3, orr_sat sat, orr_time t);

// Largest and RMS difference of a satellite's samples from the truth over truth epochs with t0+from_s <= t <=
// t0+to_s that have a sample; returns how many there were.
size_t made_compare(const made_sky *m, const made_truth *truth, const orr_orbit_solution *s, double from_s,
                    double to_s, double *rms_m, double *max_m);
const orr_orbit_sat *made_find(const orr_orbit_solution *s, orr_sat sat);

#endif
