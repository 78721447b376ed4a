// SPDX-License-Identifier: GPL-3.0-or-later
// Unbroken arcs of one satellite's carrier phases. Every boundary between two epochs is put to one question:
// which pair of whole cycles (n1, n2), most likely (0, 0), explains the step of the geometry-free phase
// (two-sided, a parabola and a step) and of the Melbourne-Wuebben combination (means of either side)? The
// answer is symmetric in time, so a slip is found forward as backward; what is known as n1, n2 is repaired,
// what is only known to have jumped breaks the arc, and every decision is kept for explanation.
#ifndef ORR_IONO_PHASE_ARCS_H
#define ORR_IONO_PHASE_ARCS_H

#include "core/status.h"

// One satellite, n samples in time order; all arrays of n.
typedef struct orr_arc_series {
    size_t n;
    const double *t_s;     // strictly ascending
    const double *gf_tecu; // (38): K (lambda1 Z1 - lambda2 Z2), wind-up taken out; NAN: no sample
    const double *mw_cyc;  // wide-lane cycles; NAN where a code is missing
    const uint8_t
        *lost; // receiver says that lock was lost since the sample before (LLI bit 0 of either phase)
    double gf1_tecu, gf2_tecu; // TECU of one cycle on carrier 1 and 2: K lambda1, K lambda2
} orr_arc_series;

typedef struct orr_arc_options {
    double max_gap_s;  // longer ones always break
    double min_span_s; // shorter arcs are dropped
    size_t min_samples;
    double evidence;  // how much chi-square a slip must explain; 30
    double step_tecu; // of the test after the fit
} orr_arc_options;
orr_arc_options orr_arc_default_options(void); // 300 s, 900 s, 20, 30, 1.0 TECU

typedef enum orr_slip_cause { // bits: who raised the question
    ORR_SLIP_GAP = 1,
    ORR_SLIP_LLI = 2,
    ORR_SLIP_GF = 4,
    ORR_SLIP_MW = 8,
    ORR_SLIP_STEP = 16, // residuals of the fit
} orr_slip_cause;
typedef enum orr_slip_verdict {
    ORR_SLIP_BREAK,    // jumped or cannot be known: a new arc
    ORR_SLIP_REPAIRED, // n1, n2 are known: the arc goes on
    ORR_SLIP_NONE,     // no jump after all: the arc goes on
    ORR_SLIP_OUTLIER,  // one sample off, before and after agree: the sample is dropped
} orr_slip_verdict;
const char *orr_slip_verdict_name(orr_slip_verdict v); // "break", "repaired", "none", "outlier"
// "gap+lli" into buf; returns buf.
char *orr_slip_cause_text(unsigned causes, char buf[40]);

typedef struct orr_slip {
    size_t at; // first sample after (OUTLIER: the sample)
    unsigned causes;
    orr_slip_verdict verdict;
    double gap_s;
    double gf_tecu, gf_sigma_tecu; // measured steps; NAN where they could not be
    double mw_cyc, mw_sigma_cyc;
    int n1, n2; // of REPAIRED
} orr_slip;

typedef struct orr_arc {
    size_t first, last; // samples; those between with arc_of < 0 do not belong
    size_t n;
} orr_arc;

typedef struct orr_arcs {
    size_t n_samples, n_arcs, n_slips, n_dropped; // dropped: samples of arcs too short
    int *arc_of;      // of each sample; -1: no sample, outlier, or in an arc too short
    double *fix_tecu; // to subtract from gf_tecu of each sample: the cycles of repaired slips
    orr_arc *arc;     // in time order
    orr_slip *slip;
} orr_arcs;

// Errors: ORR_E_ARG (times do not ascend), ORR_E_MEMORY. options may be NULL. Free with orr_arcs_free.
orr_status orr_arcs_find(const orr_arc_series *series, const orr_arc_options *options, orr_arcs *out,
                         orr_diag *diag);
// Frees what orr_arcs_find made.
void orr_arcs_free(orr_arcs *a);

// The test after the fit: looks for the largest step in the residuals of one arc against a smooth field.
// Given:
//   t_s            [n] ascending times
//   residual_tecu  [n] residuals
//   n              samples
//   options        step_tecu is used; may be NULL
// Returned: whether there is a step, and if so
//   at             the first sample after it
//   step_tecu      its size
// Notes: the model is a straight line with one step in it over 20 samples either side; a step counts when it exceeds
// options->step_tecu and eight times its sigma, and most of it happens within one interval.
bool orr_arc_step(const double *t_s, const double *residual_tecu, size_t n, const orr_arc_options *options,
                  size_t *at, double *step_tecu);

#endif
