// SPDX-License-Identifier: GPL-3.0-or-later
// Segmentation's parts: hypotheses of wrong nodes and pushes are explored in segmentation_trial.c; segmentation.c judges them and makes
// arcs of what they leave.
#ifndef ORR_ORBIT_SMOOTH_SEGMENTATION_PRIVATE_H
#define ORR_ORBIT_SMOOTH_SEGMENTATION_PRIVATE_H

#include "orbit/smooth/leave_out.h"
#include "orbit/smooth/nodes.h"
#include "orbit/smooth/segmentation.h"

typedef struct segment_group { // the usable nodes of one instant
    size_t instant;
    bool manoeuvre; // flagged
    bool joint;     // another file begins
} segment_group;

typedef struct segment_trial { // a hypothesis: which nodes are wrong, where the satellite was pushed
    orr_verdict *verdict;
    size_t wrong, pushes;
    double scale2, chi2, penalty; // penalty in units of a wrong node
    bool good;                    // all is explained
} segment_trial;

typedef struct segment_fitted { // what the track's states are those of
    size_t a, b;                // groups; a == b: of nothing
    uint8_t *verdict;           // of each node
} segment_fitted;

typedef struct segment_work {
    const orr_track_context *c; // with noise as it is reckoned with here
    const orr_node *list;
    size_t n_nodes;
    orr_track *t;
    orr_verdict *verdict; // of the trial at hand
    const segment_group *g;
    double *room;
    double wrong2, one_sided2, floor_m;
    double unit2; // of costs: what a wrong node counts beside a push
    segment_fitted *fitted;
    orr_fresh_start *fresh; // of the track's instants, as find_push asked for them last
} segment_work;

typedef struct segment_look {
    double scale2; // robust: of the used nodes
    size_t used, worst,
        group; // the worst of the used ones that are far enough to be wrong (SIZE_MAX: none), and its group
    orr_left_out of_worst;
    size_t steepest; // group of the one that stands out most, however near
    orr_left_out of_steepest;
    bool noise; // the scale is larger than that of any orbit
} segment_look;

// Whether a node is one to judge: used by the caller, and of the satellite's own orbit.
static inline bool segment_counts(const segment_work *w, size_t i)
{
    return orr_node_counts(&w->list[i]) && !w->list[i].foreign;
}
static inline orr_instant *segment_instant(const segment_work *w, size_t g)
{
    return &w->t->at[w->g[g].instant];
}
// Whether all nodes of a group are rejected.
bool segment_rejected(const segment_work *w, size_t g);
// Whether the track's states are those of an arc with its verdicts.
bool segment_is_fitted(const segment_work *w, const orr_arc_range *arc);
// Filter and smoother over groups [a, b) with the verdicts as they are; nothing is done twice, unless what could begin anew is asked
// for (fresh; may be NULL). Errors: those of orr_smooth_range.
orr_status segment_fit(const segment_work *w, size_t a, size_t b, orr_fresh_start *fresh);
// Nodes of groups [a, b) against the orbit through all others.
segment_look segment_look_at(const segment_work *w, size_t a, size_t b);
// Rejects the nodes of groups [from, to), or takes them in.
void segment_mark(const segment_work *w, size_t from, size_t to, bool rejected);
// Explains what the nodes of groups [a, b) disagree in, one thing after the other: by wrong nodes alone, or by pushes too. The verdicts are
// w->verdict, the hypothesis is *x. Errors: those of segment_fit.
orr_status segment_explore(const segment_work *w, size_t a, size_t b, bool may_push, segment_trial *x);

#endif
