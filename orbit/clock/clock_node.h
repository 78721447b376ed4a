// SPDX-License-Identifier: GPL-3.0-or-later
// A clock of a satellite at one instant, and a satellite's clocks as a list: what files give, what the
// product keeps, and what everything about clocks works on.
#ifndef ORR_ORBIT_CLOCK_CLOCK_NODE_H
#define ORR_ORBIT_CLOCK_CLOCK_NODE_H

#include "core/sat.h"
#include "core/time.h"

enum { // flags of samples, clock nodes and states; the wire's STATES uses the same bits
    ORR_EPH_CLOCK_VALID = 1u << 0, // clock_s and clock_rate_sps are there
    ORR_EPH_PREDICTED = 1u << 1,   // input was predicted, or bridged without input
    ORR_EPH_MANOEUVRE = 1u << 2,   // within a manoeuvre's interval
    ORR_EPH_CLOCK_EVENT = 1u << 3, // the product flagged a clock event at a neighbouring node
    ORR_EPH_ECLIPSE = 1u << 4,     // umbra or penumbra of the Earth
    ORR_EPH_GAP = 1u << 5,         // between nodes further apart than twice the usual
    ORR_EPH_JOINT = 1u << 6,       // between the orbits of two input files that do not meet
    ORR_EPH_SHADOW_NOISE =
        1u << 7, // the input's orbits are noisier near the Earth's shadow; sigma is less sure
};

// Between neighbours not further apart than the product's max gap there is a clock; never across a gap.
typedef struct orr_clock_node {
    orr_time t;
    double clock_s;  // as the input product gives it (periodic relativity NOT included, the IGS convention)
    uint32_t flags;  // ORR_EPH_CLOCK_EVENT, ORR_EPH_PREDICTED
    uint16_t source; // tells two nodes at one instant apart: 1 for the second, else 0
    float sigma_s;   // of a predicted node, against what the centre will say; 0 of an observed one
} orr_clock_node;

typedef struct orr_clock_list {
    orr_sat sat;
    size_t n;
    orr_clock_node *node; // ascending in t; two at one instant where files join, the later file's second
} orr_clock_list;

#endif
