// SPDX-License-Identifier: GPL-3.0-or-later
// What all clocks of a system do together is the doing of the clock that they are referred to: a centre's
// reference clock wanders, steps and ramps, and a centre realigns its time scale at midnight. The common part
// is found epoch by epoch, so that a single satellite's clock can be judged and predicted without it.
#ifndef ORR_ORBIT_CLOCK_CLOCK_COMMON_H
#define ORR_ORBIT_CLOCK_CLOCK_COMMON_H

#include "orbit/clock/clock_node.h"

// One instant of one source.
typedef struct orr_clock_epoch {
    orr_time t;
    uint16_t source;
    size_t n; // satellites that tell how the reference went on from the epoch before; 0: none, or one alone
    double step_s;  // how far: the shared part of what the satellites did beyond their own usual rates
    double value_s; // sum of the steps, 0 at the last epoch
} orr_clock_epoch;

typedef struct orr_clock_common {
    char system;
    size_t n;
    orr_clock_epoch *epoch; // ascending in t, then in source
} orr_clock_common;

// The common part of the clocks of one system. A step is the median over the satellites that have both epochs
// (of two alone the smaller where they have one sign, else nothing: two satellites share only what both do; one alone
// shares nothing). ORR_E_MEMORY. Free with orr_clock_common_free.
orr_status orr_clock_common_find(const orr_clock_list *list, size_t n_lists, char system,
                                 orr_clock_common *out);
// Frees what orr_clock_common_find allocated; c is empty afterwards.
void orr_clock_common_free(orr_clock_common *c);

// Leaves of the common part the steps and ramps that are the reference's doing, epochs at which more than 5 ns and ten
// times the usual was shared; its usual wander is set to zero. ORR_E_MEMORY.
orr_status orr_clock_common_keep_steps(orr_clock_common *c);

// Takes the common part off the clocks of a satellite of that system, or (sign = +1) puts it back.
void orr_clock_common_apply(const orr_clock_common *c, double sign, orr_clock_list *list);

#endif
