// SPDX-License-Identifier: GPL-3.0-or-later
// Between the parts of the fusion: its normal equations and its code levelling.
#ifndef ORR_IONO_FUSION_FUSION_PRIVATE_H
#define ORR_IONO_FUSION_FUSION_PRIVATE_H

#include "iono/fusion/fusion.h"

// Joint least squares of knots, arc biases and receiver biases over out->arc, out->group; fills them in.
orr_status fusion_solve(const orr_phase_tec *phase, const orr_fusion_options *o, orr_fusion *out,
                        orr_diag *diag);

// code_bias_tecu and group of every arc, and the list of groups.
orr_status fusion_level_codes(const orr_phase_tec *phase, const orr_bias_set *biases, size_t n_biases,
                              orr_fusion *out, orr_diag *diag);

// Samples that enter least squares: visits those of one arc that are at least thin_s apart; start with *i =
// SIZE_MAX.
bool fusion_next_sample(const orr_phase_sat *s, int arc, double thin_s, const double *vtec, size_t *i);

#endif
