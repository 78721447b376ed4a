// SPDX-License-Identifier: GPL-3.0-or-later
// Clocks beyond their last node: the curve that suits the kind of clock, through the last value, with a sigma
// that follows from the clock's own noise. Measured on days left out (docs/orbit.md).
#ifndef ORR_ORBIT_CLOCK_CLOCK_PREDICT_H
#define ORR_ORBIT_CLOCK_CLOCK_PREDICT_H

#include "orbit/clock/clock_noise.h"

typedef struct orr_clock_model {
    int degree;      // 1 or 2
    bool harmonic;   // half-day
    double window_s; // of nodes before the last one
} orr_clock_model;

// Galileo and GLONASS: a line through 24 h; BeiDou: a parabola through 48 h. GPS: a parabola through 48 h
// (Block III), with the half-day harmonic (IIF, rubidium), a line and the harmonic through 24 h (Blocks II to
// IIR-M, rubidium), a line through 48 h (caesium). Where `block` (an ANTEX type: "BLOCK IIF"; NULL or "": not
// known) does not tell, the noise does: caesium's random walk is ten times rubidium's, and the older rubidium
// clocks have a white phase noise of 0.1 ns that IIF and III lack, which then share the model of IIF. Other
// systems: a line through 24 h.
orr_clock_model orr_clock_model_choose(orr_sat sat, const char *block, const orr_clock_noise *noise);

typedef struct orr_clock_predictor orr_clock_predictor;

// Makes the predictor of one satellite's clock from its nodes.
// Given:
//   node   [n] clock nodes, ascending in t, without jumps, the common part of their system taken away
//          (orr_clock_common_apply with sign -1; that part is 0 at the last epoch, so that predictions need nothing put back)
//   n      how many
//   model  curve and window (orr_clock_model_choose); lowered to what the nodes carry: less than 18 h a line alone
//   noise  how the clock wanders (orr_clock_noise_fit); it makes the sigma
// Returned:
//   out    the predictor; free with orr_clock_predictor_free
// Errors: ORR_E_NODATA (fewer than two nodes), ORR_E_MEMORY, ORR_E_NUMERIC.
// Notes: the nodes may be freed afterwards. Clocks are in the convention of SP3: periodic relativity is not in them.
orr_status orr_clock_predictor_init(const orr_clock_node *node, size_t n, const orr_clock_model *model,
                                    const orr_clock_noise *noise, orr_clock_predictor **out);
// Frees a predictor; NULL is none.
void orr_clock_predictor_free(orr_clock_predictor *p);

typedef struct orr_clock_prediction {
    double clock_s, rate_sps;
    double sigma_s; // against what the same centre will say, the common part of all satellites apart
} orr_clock_prediction;

// At t, not before the last node (earlier times give what the curve says, with the last node's sigma).
orr_clock_prediction orr_clock_predictor_at(const orr_clock_predictor *p, orr_time t);

#endif
