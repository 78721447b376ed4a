// SPDX-License-Identifier: GPL-3.0-or-later
// The times of a run's nodes: what all satellites of a file tell of its epochs, put into their nodes. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_NODE_TIMES_H
#define ORR_ORBIT_SMOOTH_NODE_TIMES_H

#include "orbit/smooth/nodes.h"

// How far the epochs of one file are off.
typedef struct orr_file_times {
    size_t epochs;        // of which that is so; 0: none
    double rms_s, most_s; // of these
} orr_file_times;

// Sets late_s of the nodes from what each satellite tells (told_s). Records that hold another orbit tell nothing.
// Given:
//   table     nodes of all satellites, each smoothed once
//   n_files   input files
// Returned:
//   table     late_s
//   file      [n_files]
// Errors: ORR_E_MEMORY.
orr_status orr_node_times_take(orr_node_table *table, size_t n_files, orr_file_times *file);

#endif
