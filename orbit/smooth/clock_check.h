// SPDX-License-Identifier: GPL-3.0-or-later
// Clock nodes that cannot be: one value far off its neighbours is left out, a jump is marked so that nobody
// interpolates across it. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_CLOCK_CHECK_H
#define ORR_ORBIT_SMOOTH_CLOCK_CHECK_H

#include "orbit/smooth/nodes.h"

// What is usual is judged per satellite, from how far its clock nodes are off the line between their
// neighbours: thirty times the median of that, and 30 ns (9 m of range) at least, is wrong. No node of the
// published files that this was measured on comes near it. A value that alone is off goes; where the clock is
// another before and after, the node after the jump gets ORR_EPH_CLOCK_EVENT, as SP3's own flag does; a clock
// that merely changes its rate stays. Neighbours are nodes up to max_gap_s apart. Each finding is a warning.
// ORR_E_MEMORY.
orr_status orr_clock_check(orr_node_list *list, double max_gap_s, orr_warnings *warnings);

#endif
