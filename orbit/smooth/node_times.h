// SPDX-License-Identifier: GPL-3.0-or-later
// The times of a run's nodes: what all satellites of a file tell of its epochs, put into their nodes. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_NODE_TIMES_H
#define ORR_ORBIT_SMOOTH_NODE_TIMES_H

#include "orbit/dynamics/epoch_time.h"
#include "orbit/smooth/nodes.h"

// Sets late_s of the nodes from what each satellite tells (told_s). Records that hold another orbit tell nothing.
// Given:
//   table     nodes of all satellites, each smoothed once
//   n_files   input files
// Returned:
//   table     late_s
//   file      [n_files]
// Errors: ORR_E_MEMORY.
orr_status orr_node_times_take(orr_node_table *table, size_t n_files, orr_epoch_spread *file);

#endif
