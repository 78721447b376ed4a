// SPDX-License-Identifier: GPL-3.0-or-later
// Hours without precise positions, bridged by the broadcast orbit: nodes of broadcast quality where the SP3
// files have none, calibrated against the precise positions of the same satellite. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_BRIDGE_H
#define ORR_ORBIT_SMOOTH_BRIDGE_H

#include "orbit/smooth/nodes.h"

// Adds nodes (bridge = true, predicted = true) wherever two neighbouring precise nodes are further apart than twice a
// step. From the broadcast positions the mean offset from the precise ones along radius, track and across is taken away
// (antenna offset, frame), and sigma_m of the new nodes is the RMS of what is left, times the root of the number of
// nodes over which a broadcast error stays the same (twelve hours of them).
// Given:
//   nav        broadcast ephemerides
//   origin     instant of which node[].t_s counts
//   step_s     distance of the new nodes, s
//   extend_to  nodes go on beyond the last precise one up to this instant; ORR_TIME_NONE: not
//   list       nodes of a satellite
// Returned:
//   list       with the new nodes among the others; as it was without eight instants that both sources have
// Errors: ORR_E_MEMORY.
orr_status orr_bridge_nodes(const orr_nav *nav, orr_time origin, double step_s, orr_time extend_to,
                            orr_node_list *list);

#endif
