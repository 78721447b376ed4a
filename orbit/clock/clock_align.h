// SPDX-License-Identifier: GPL-3.0-or-later
// Two sets of clocks brought to one reference clock. Room-internal.
#ifndef ORR_ORBIT_CLOCK_CLOCK_ALIGN_H
#define ORR_ORBIT_CLOCK_CLOCK_ALIGN_H

#include "orbit/clock/clock_sources.h"

// Shifts clocks, epoch by epoch and system by system, so that the median difference to others is zero.
// Given:
//   name      of the file whose clocks are shifted, for what is told
//   to        clocks that stay
//   clocks    clocks that are shifted
// Returned:
//   clocks    on the reference of `to`; unchanged where the two share one instant alone, or agree
//   warnings  how far the two were apart and are for single satellites; may be NULL
// Errors: ORR_E_MEMORY.
// Notes: between shared epochs the shift is linear, beyond them constant. A system of which `to` has no clocks is shifted
// as all others together are.
orr_status orr_clock_align(const char *name, const orr_clock_table *to, orr_clock_table *clocks,
                           orr_warnings *warnings);

#endif
