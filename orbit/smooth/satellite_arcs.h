// SPDX-License-Identifier: GPL-3.0-or-later
// The arcs of one satellite: what the segmentation left whole or parted becomes samples of the solution, and events that tell
// what was found and what was left out. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_SATELLITE_ARCS_H
#define ORR_ORBIT_SMOOTH_SATELLITE_ARCS_H

#include "orbit/smooth/events.h"
#include "orbit/smooth/segmentation.h"
#include "orbit/smooth/smooth_satellite.h"
#include "orbit/smooth/solution.h"

// One satellite as it is worked on.
typedef struct orr_satellite_work {
    orr_track_context *c;
    const orr_node_table *table;
    orr_node *node; // of the satellite
    size_t n;
    orr_reference *ref; // per node
    orr_orbit_sat *out;
    orr_event_list events;
    orr_satellite_report *report;
    double scale;            // real to formal sigma of the last arc that told; 1 before
    orr_noise_factor factor; // before an arc's own is chosen
    bool failed;             // a stretch could not be smoothed
    size_t n_files;
    orr_file_evidence *evidence; // NULL: not asked for
} orr_satellite_work;

// Position of the smoothed orbit at an instant, integration axes, m.
static inline orr_vec3 orr_smoothed_r(const orr_instant *at)
{
    return orr_vec3_add(at->r_m, orr_vec3_make(at->state.x[0], at->state.x[1], at->state.x[2]));
}
// Its velocity, m/s.
static inline orr_vec3 orr_smoothed_v(const orr_instant *at)
{
    return orr_vec3_add(at->v_mps, orr_vec3_make(at->state.x[3], at->state.x[4], at->state.x[5]));
}
// An instant of the track.
static inline orr_time orr_satellite_time(const orr_satellite_work *w, double t_s)
{
    return orr_sky_origin(w->c->sky) + orr_track_ns(t_s);
}
// First and last node (half open) of an arc of the track.
static inline void orr_nodes_of_arc(const orr_track *t, const orr_arc_range *arc, size_t *i0, size_t *i1)
{
    *i0 = t->at[arc->first].first;
    *i1 = t->at[arc->last].first + t->at[arc->last].n;
}

// Adds the arcs of a track and what there is to tell of them.
// Given:
//   w    the satellite
//   t    the track, filtered and smoothed in its arcs
//   seg  the arcs, and a verdict on each node
// Returned:
//   w    out, events, report, and the scale of the noise
// Errors: ORR_E_MEMORY, ORR_E_NUMERIC.
orr_status orr_satellite_arcs(orr_satellite_work *w, orr_track *t, const orr_segmentation *seg);

#endif
