// SPDX-License-Identifier: GPL-3.0-or-later
// Which epochs of the input are used: decimation and exclusion. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_EPOCH_H
#define ORR_ORBIT_SMOOTH_EPOCH_H

#include "orbit/smooth/smoother.h"

// The clock of a file's own time system, in ns since the GPS epoch's label: what decimation counts in.
int64_t orr_epoch_label_ns(orr_time t, orr_scale scale);

// Whether an epoch is used: a multiple of o->node_step_s from midnight (as orr_epoch_label_ns), and not excluded.
bool orr_epoch_wanted(orr_time t, orr_scale scale, int64_t midnight, const orr_smoother_options *o);

#endif
