// SPDX-License-Identifier: GPL-3.0-or-later
// One stretch of one satellite on the filter's time grid: the a-priori trajectory with its transition
// matrices, and room for what filter and smoother leave at every instant. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_TRACK_H
#define ORR_ORBIT_SMOOTH_TRACK_H

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "orbit/force/integrate.h"
#include "orbit/smooth/kalman.h"
#include "orbit/smooth/nodes.h"

#define ORR_SAMPLES_PER_SEGMENT 6

// A state that the a-priori trajectory is restarted from.
typedef struct orr_reference {
    bool valid;
    bool gross;          // the node is kilometres off any orbit: nothing is to be linearised about it
    orr_vec3 r_m, v_mps; // integration axes
} orr_reference;

// An instant of the grid.
typedef struct orr_instant {
    double t_s;
    bool sample;         // on the uniform grid that the product takes its samples from
    size_t first, n;     // nodes (indices into the list) at this instant; n = 0: none
    orr_vec3 r_m, v_mps; // a-priori state from which the next step departs
    orr_mat3 axes;       // f0 axes to integration axes
    orr_transition next; // to the following instant
    double noise;    // factor of qf over the next step; above 1 in long gaps without Earth-orientation data
    double shift[6]; // arriving minus departing a-priori state
    orr_gauss predicted, filtered, smoothed; // of deviations from the departing state
} orr_instant;

typedef struct orr_track {
    size_t n;
    orr_instant *at;
    double step_s; // of the samples
    size_t n_samples, samples_per_segment;
} orr_track;

// What all satellites of a run share, per thread.
typedef struct orr_track_context {
    const orr_smoother_options *options;
    const orr_sky *sky;
    const orr_force *force;
    orr_integrator *integrator;
    bool eop_known; // Earth orientation came from data, not from the secular pole
} orr_track_context;

// An instant of a track in nanoseconds: whole microseconds where a double of its size cannot tell them from
// what it is (after a year seconds are good to four nanoseconds), so that arcs that meet do so to the
// nanosecond.
static inline int64_t orr_track_ns(double t_s)
{
    const int64_t ns = llround(t_s * 1e9), us = llround(t_s * 1e6);
    return (double)llabs(ns - 1000 * us) <= 2e9 * DBL_EPSILON * fabs(t_s) ? 1000 * us : ns;
}

// Grid from from_s to to_s: samples at most options->grid_s apart, commensurate with node_step_s where that
// is possible, and all nodes list[0..n) that lie within. ORR_E_MEMORY.
orr_status orr_track_init(const orr_track_context *c, double from_s, double to_s, double node_step_s,
                          const orr_node *list, size_t n, orr_track *out);
void orr_track_free(orr_track *t);

// A-priori trajectory: starts from the first valid reference (backwards to the grid's begin if need be),
// restarts at every later one; reference[i] belongs to node list[i]. ORR_E_NUMERIC if it leaves sense,
// ORR_E_NODATA without any reference.
orr_status orr_track_linearise(const orr_track_context *c, const orr_reference *reference, orr_track *t);

// Measured minus a-priori position of node `n` at instant `at`, integration axes.
orr_vec3 orr_track_measured(const orr_track_context *c, const orr_instant *at, const orr_node *n);

#endif
