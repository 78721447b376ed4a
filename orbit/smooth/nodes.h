// SPDX-License-Identifier: GPL-3.0-or-later
// The smoother's input per satellite: positions at nodes and clocks, gathered from SP3 files, decimated, with
// duplicates at day joints told apart. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_NODES_H
#define ORR_ORBIT_SMOOTH_NODES_H

#include "orbit/smooth/smoother.h"

typedef struct orr_node {
    orr_time t;
    double t_s; // since the span's begin
    orr_vec3 ecef_m;
    double sigma_m;
    bool predicted, manoeuvre;
    bool bridge;     // not of an input file: a broadcast position where the files have none
    bool superseded; // another file observed what this one predicted
    bool foreign;    // of a file's first or last record, which holds another orbit (file_noise.h)
    double
        late_s; // the position is that of so much later, as all satellites of the file show (dynamics/epoch_time.h)
    double told_s;   // what this satellite tells of it; NAN: nothing
    uint16_t source; // index of the input file
    uint16_t rank;   // of the file in time
} orr_node;

// A node of an input file that counts.
static inline bool orr_node_counts(const orr_node *n) { return !n->superseded && !n->bridge; }

typedef struct orr_node_list {
    orr_sat sat;
    size_t n_nodes, n_clocks;
    orr_node *node;        // ascending in t, then in file order
    orr_clock_node *clock; // ascending; where stretches of two files meet the later one's comes second
    orr_clock_noise clock_noise;
} orr_node_list;

typedef struct orr_node_table {
    size_t n_sats;
    orr_node_list *list; // ascending in sat
    orr_time from, to;   // of all nodes
    double step_s; // the usual distance of neighbouring nodes: the median of a file's satellites, the longest
                   // of the files
    double clock_step_s, clock_max_gap_s; // likewise of clocks; the longest that one is interpolated over
    orr_clock_events clock_events;
} orr_node_table;

// Gathers the nodes and clocks of all files.
// Given:
//   input, n_inputs  SP3 files, in any order
//   o                options: decimation, exclusion, choice of satellites, broadcast ephemerides, sigmas
// Returned:
//   out              lists by satellite; free with orr_nodes_free
//   warnings         what was left out and why
// Errors: ORR_E_NODATA when nothing is left after decimation and exclusion, ORR_E_MEMORY.
orr_status orr_nodes_collect(const orr_smoother_input *input, size_t n_inputs, const orr_smoother_options *o,
                             orr_node_table *out, orr_warnings *warnings, orr_diag *diag);
// Frees the lists; a zeroed table is allowed.
void orr_nodes_free(orr_node_table *t);

#endif
