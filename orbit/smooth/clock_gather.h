// SPDX-License-Identifier: GPL-3.0-or-later
// The product's clocks from all files that give some: SP3 beside the positions, RINEX CLK before them.
// Room-internal.
#ifndef ORR_ORBIT_SMOOTH_CLOCK_GATHER_H
#define ORR_ORBIT_SMOOTH_CLOCK_GATHER_H

#include "orbit/smooth/nodes.h"

// Gathers, aligns, judges and measures the clocks of a table's satellites.
// Given:
//   input     [n_inputs] SP3 files
//   n_inputs  how many
//   order     [n_inputs] the files that count, by their first epochs
//   o         options
//   midnight  what o->node_step_s counts from (orr_epoch_wanted)
//   table     satellites and span
// Returned:
//   table     clocks, their noise and events, clock_step_s, clock_max_gap_s
//   warnings  what was found; may be NULL
// Errors: ORR_E_MEMORY.
orr_status orr_clocks_gather(const orr_smoother_input *input, size_t n_inputs, const size_t *order,
                             const orr_smoother_options *o, int64_t midnight, orr_node_table *table,
                             orr_warnings *warnings);

#endif
