// SPDX-License-Identifier: GPL-3.0-or-later
// One satellite from nodes to arcs: passes of linearisation, verdicts, smoothing, samples. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_SMOOTH_SATELLITE_H
#define ORR_ORBIT_SMOOTH_SMOOTH_SATELLITE_H

#include "orbit/smooth/file_noise.h"
#include "orbit/smooth/nodes.h"
#include "orbit/smooth/track.h"

typedef struct orr_satellite_report {
    size_t nodes_used, nodes_rejected, manoeuvres;
    size_t from_broadcast; // nodes whose a-priori state is a broadcast one
    int passes;
    double residual_m2; // sum of squares over used nodes, 3-D
    char note[256];     // why something was left out; empty if nothing was
} orr_satellite_report;

// Smooths one satellite. A stretch that cannot be smoothed leaves a note, not an error.
// Given:
//   c       context of the thread; the noise is chosen within
//   table   the run's nodes, for their usual distance
//   list    the satellite's own nodes and clocks
//   n_files input files
// Returned:
//   evidence [n_files], zeroed before: what the satellite tells of the files; NULL: not asked for
//   out     satellite, arcs, clocks, nodes, events; free with orr_satellite_free
//   report  what was done
// Errors: ORR_E_MEMORY.
orr_status orr_satellite_smooth(const orr_track_context *c, const orr_node_table *table, orr_node_list *list,
                                size_t n_files, orr_file_evidence *evidence, orr_orbit_sat *out,
                                orr_satellite_report *report);
// Frees what a satellite owns and zeroes it.
void orr_satellite_free(orr_orbit_sat *s);

#endif
