// SPDX-License-Identifier: GPL-3.0-or-later
// Between the parts of the fusion: the correction, the normal equations, the code levelling, the choice of the model's
// statistics, arcs left out.
#ifndef ORR_IONO_FUSION_FUSION_PRIVATE_H
#define ORR_IONO_FUSION_FUSION_PRIVATE_H

#include "iono/fusion/fusion.h"

// The terms of the correction for a ray, faded beyond its reach.
// Given:
//   c          the correction
//   unit       pierce point
//   vtec_tecu  the field's vertical content there
//   mapping    slant over vertical of the ray
// Returned:
//   term       derivatives of the vertical content by the coefficients
void correction_terms(const orr_correction *c, orr_vec3 unit, double vtec_tecu, double mapping,
                      double term[ORR_CORRECTION_TERMS]);
// A-priori sigma and correlation time of a coefficient.
void correction_prior(const orr_fusion_model *m, int term, double *sigma, double *time_s);
// The knot before t and the weight of the next one; the first and last are held beyond the ends.
void correction_knots(const orr_correction *c, orr_time t, size_t *knot, double *weight_of_next);

// Normal equations of the correction's knots and the receiver's biases, the arcs' biases eliminated.
typedef struct fusion_normal {
    size_t n, groups;     // unknowns; where the receiver's biases start
    double *matrix, *rhs; // [n][n], lower triangle; [n]
    double *part;         // [n] workspace, zeroes between calls
    double square;        // weighted square of the observations
    double log_variances; // of observations, priors and eliminated biases
} fusion_normal;

// Of the size that f needs, cleared. ORR_E_LIMIT, ORR_E_MEMORY.
orr_status fusion_normal_init(const orr_fusion *f, fusion_normal *out, orr_diag *diag);
void fusion_normal_free(fusion_normal *s);
void fusion_normal_clear(fusion_normal *s);
// Adds (sign 1) or takes out (sign -1) what one arc says, under the statistics f->model.
// Given:
//   s      the system
//   phase  the station's phases
//   o      options
//   f      fusion with the field along the arcs
//   arc    one of its arcs
//   sign   1 or -1
// Returned:
//   s      changed
void fusion_normal_add_arc(fusion_normal *s, const orr_phase_tec *phase, const orr_fusion_options *o,
                           const orr_fusion *f, const orr_fused_arc *arc, double sign);
void fusion_normal_add_prior(fusion_normal *s, const orr_fusion *f);
// Clears, then adds the prior and all arcs.
void fusion_normal_build(fusion_normal *s, const orr_phase_tec *phase, const orr_fusion_options *o,
                         const orr_fusion *f);
// Solves: matrix becomes its Cholesky factor, rhs the solution. -2 log of the restricted likelihood but for a constant.
orr_status fusion_normal_factor(fusion_normal *s, double *minus_two_log_likelihood);
// The solution into f->correction.
void fusion_normal_take_correction(const fusion_normal *s, orr_fusion *f);

// Joint least squares under the statistics out->model: fills in correction, biases and their sigmas.
orr_status fusion_solve(const orr_phase_tec *phase, const orr_fusion_options *o, orr_fusion *out,
                        orr_diag *diag);

#define FUSION_MODEL_UNKNOWNS 8 // of orr_fusion_model that are chosen

// What out->model starts from, before the session has been asked; rms_tecu is the field's own over the station.
orr_fusion_model fusion_usual_model(double rms_tecu);
// The statistics out->model that are most likely for the session.
orr_status fusion_choose_model(const orr_phase_tec *phase, const orr_fusion_options *o, orr_fusion *out,
                               orr_diag *diag);

// Fills out->left. Correction and biases are as before afterwards.
orr_status fusion_leave_out(const orr_phase_tec *phase, const orr_fusion_options *o, orr_fusion *out,
                            orr_diag *diag);

// Levelled phase minus field and correction at sample i of an arc, slant.
double fusion_residual(const orr_phase_tec *p, const orr_fusion *f, const orr_fused_arc *a, size_t i);

// code_bias_tecu and group of every arc, and the list of groups.
// Given:
//   phase             the station's phases
//   biases, n_biases  code biases
//   o                 options (the station's own bias may be withheld)
// Returned:
//   out               arcs and groups
//   diag              why it failed
orr_status fusion_level_codes(const orr_phase_tec *phase, const orr_bias_set *biases, size_t n_biases,
                              const orr_fusion_options *o, orr_fusion *out, orr_diag *diag);

// Samples that enter least squares: visits those of one arc that are at least thin_s apart; start with *i =
// SIZE_MAX.
// Given:
//   s       satellite
//   arc     which arc of it
//   thin_s  least distance of samples
//   vtec    [s->n] the field along it, NAN where there is none
//   i       sample visited last
// Returned: false at the end of the arc, else
//   i       the next sample
bool fusion_next_sample(const orr_phase_sat *s, int arc, double thin_s, const double *vtec, size_t *i);

#endif
