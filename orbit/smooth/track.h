// SPDX-License-Identifier: GPL-3.0-or-later
// One stretch of one satellite: the a-priori trajectory on the product's grid, and the instants between which
// the filter steps, with transition matrices and what filter and smoother leave at them. Room-internal.
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

// A point of the grid: the a-priori state from which the next step departs, and the step.
typedef struct orr_grid_point {
    double t_s;
    bool sample;      // on the uniform grid that the product takes its samples from
    bool near_shadow; // the step is, or the satellite has just left it
    orr_vec3 r_m, v_mps;
} orr_grid_point;

// How the step from a point of the grid to the next one answers to small changes.
typedef struct orr_grid_step {
    orr_mat3 axes;       // f0's to integration axes, at mid-step
    double F[6][ORR_NX]; // partial derivatives of the step
} orr_grid_step;

// An instant at which the filter stops: nodes, both ends, and places between that are not far apart.
typedef struct orr_instant {
    double t_s;
    size_t grid;     // its point
    size_t first, n; // nodes (indices into the list) at this instant; n = 0: none
    size_t window;   // of the reference
    bool renew;      // another window begins: ECOM's coefficients are those of another day
    bool step;       // another file begins: its orbit may be elsewhere
    bool noon;       // of GPS time
    bool pulse;      // the velocity may have a step, which the file has at noon
    double shadow;   // the noise near the Earth's shadow is so much more over the next step: 0 as elsewhere
    orr_vec3 r_m, v_mps;      // a-priori state from which the next step departs
    orr_transition_kept next; // to the following instant
    double noise; // factor of qf over the next step; above 1 in long gaps without Earth-orientation data
    double shift[ORR_NX]; // arriving minus departing a-priori state
    double u[ORR_NX];     // the smoother's, of the step that arrives
    double d2,
        log_det; // normalised squares of the innovations, and half ln det of their covariance; of count nodes
    size_t count;
    // Where a gap ends: how far the orbits before and after it are from being one, in units of sigma; 0 elsewhere
    double strain;
    orr_gauss_kept state; // of deviations from the departing state: filtered, and smoothed in its place
} orr_instant;

typedef struct orr_track {
    size_t n, n_grid;
    orr_instant *at;
    orr_grid_point *grid;
    // Steps of the grid's points. A long track does not keep them: they are made again, interval by interval, for
    // whoever asks (orr_track_step).
    struct {
        orr_grid_step *step; // of the points from `first` on, n of them
        size_t first, n;
        bool all;
    } steps;
    double step_s; // of the samples
    size_t n_samples, samples_per_segment;
} orr_track;

// What the reference fit tells of a satellite, by window of time.
typedef struct orr_satellite_reference {
    size_t n_windows;
    const double *border_s; // n_windows + 1
    bool *fitted;
    double (*ecom_nmps2)[ORR_ECOM_TERMS]; // of the a-priori force
    orr_vec3 *state;                      // position and velocity at t_s, where fitted
    double *t_s;
} orr_satellite_reference;

// Noise that the filter reckons with.
typedef struct orr_filter_noise {
    int nx; // ORR_NX, or ORR_NX_PLAIN
    double qf_m2ps5, qv_m2ps3;
    double start_r_m, start_v_mps, f0_sigma_mps2; // at an arc's start
    orr_noise_factor factor;                      // shadow is not used: each instant has its own
} orr_filter_noise;

// What all satellites of a run share, per thread, and what is the satellite's.
typedef struct orr_track_context {
    const orr_smoother_options *options;
    const orr_sky *sky;
    orr_force *force; // the thread's own: ECOM is that of a window
    orr_integrator *integrator;
    bool eop_known;                           // Earth orientation came from data, not from the secular pole
    const struct orr_file_noise *file;        // by input file; NULL: nothing is known of them
    const orr_satellite_reference *reference; // NULL: none
    orr_filter_noise noise;
} orr_track_context;

// An instant of a track in nanoseconds: whole microseconds where a double of its size cannot tell them from
// what it is (after a year seconds are good to four nanoseconds), so that arcs that meet do so to the
// nanosecond.
static inline int64_t orr_track_ns(double t_s)
{
    const int64_t ns = llround(t_s * 1e9), us = llround(t_s * 1e6);
    return (double)llabs(ns - 1000 * us) <= 2e9 * DBL_EPSILON * fabs(t_s) ? 1000 * us : ns;
}

// Grid and instants of a stretch: samples at most options->grid_s apart, commensurate with the nodes' step where that is
// possible, and all nodes that lie within.
// Given:
//   c             context
//   from_s, to_s  first and last sample
//   node_step_s   usual distance of nodes, s
//   list, n       nodes of the satellite
// Returned:
//   out           the track; free with orr_track_free
// Errors: ORR_E_MEMORY.
orr_status orr_track_init(const orr_track_context *c, double from_s, double to_s, double node_step_s,
                          const orr_node *list, size_t n, orr_track *out);
// Frees grid and instants; a zeroed track is allowed.
void orr_track_free(orr_track *t);

// A-priori trajectory: starts from the first valid reference (backwards to the grid's begin if need be),
// restarts at every later one; reference[i] belongs to node list[i]. ORR_E_NUMERIC if it leaves sense,
// ORR_E_NODATA without any reference.
orr_status orr_track_linearise(const orr_track_context *c, const orr_reference *reference, orr_track *t);

// Steps of the longest interval of instants first..last, at least 1.
size_t orr_track_longest(const orr_track *t, size_t first, size_t last);
// The step that departs from point g of the grid of a linearised track; *out stays good until another interval's step is
// asked for. The force is then that of its window. Errors: ORR_E_NUMERIC.
orr_status orr_track_step(const orr_track_context *c, orr_track *t, size_t g, const orr_grid_step **out);

// The window of the reference that an instant lies in.
size_t orr_track_window(const orr_track_context *c, double t_s);
// The force of a window of the reference, ECOM's coefficients changed by `change` (NULL: not).
void orr_track_use_window(const orr_track_context *c, size_t window, const double *change);
// Axes of f0 at an instant, as a matrix to integration axes.
orr_mat3 orr_track_axes(const orr_track_context *c, double t_s, orr_vec3 r_m, orr_vec3 v_mps);

// Measured minus a-priori position of node `n` at instant `at`, integration axes.
orr_vec3 orr_track_measured(const orr_track_context *c, const orr_instant *at, const orr_node *n);

#endif
