// SPDX-License-Identifier: GPL-3.0-or-later
// How a satellite's clock wanders: white phase noise, white and random-walk frequency noise, told by its own
// second differences over a quarter of an hour to half a day (the Allan variance under another name; Riley
// 2008, "Handbook of Frequency Stability Analysis", NIST SP 1065).
#ifndef ORR_ORBIT_CLOCK_CLOCK_NOISE_H
#define ORR_ORBIT_CLOCK_CLOCK_NOISE_H

#include "orbit/clock/clock_node.h"

#define ORR_CLOCK_HARMONIC_S (43082.0455) // half a sidereal day: the harmonic that satellites' clocks have
#define ORR_CLOCK_LATTICE_S 900.0         // noise and predictions look at nodes so far apart, not nearer

// Over a time tau a clock departs from a line by the variance white + wfm tau + rwfm tau^3 / 3.
typedef struct orr_clock_noise {
    double white_s2;   // of a node's own value
    double wfm_s2ps;   // white frequency noise: a random walk of the clock
    double rwfm_s2ps3; // random walk of frequency
} orr_clock_noise;

// From nodes in ascending order, after a parabola and a half-day harmonic are taken away. ORR_E_NODATA with
// less than twenty nodes on a lattice of a quarter of an hour; ORR_E_MEMORY.
orr_status orr_clock_noise_fit(const orr_clock_node *node, size_t n, orr_clock_noise *out);

// Of the nodes those that are a quarter of an hour apart, counted back from the last: their indices,
// ascending, into index[0..n). Returns how many.
size_t orr_clock_lattice(const orr_clock_node *node, size_t n, double window_s, size_t *index);

#endif
