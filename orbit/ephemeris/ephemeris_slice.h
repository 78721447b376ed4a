// SPDX-License-Identifier: GPL-3.0-or-later
// States of all satellites at instants that follow one another: what they need of the product for a while - polynomials of one
// segment, sigmas of one sample, clocks between two nodes - laid side by side, so that a vector unit evaluates several at
// once. The bits are those of orr_ephemeris_eval_all. Room of one thread's; the product itself is not touched.
#ifndef ORR_ORBIT_EPHEMERIS_EPHEMERIS_SLICE_H
#define ORR_ORBIT_EPHEMERIS_EPHEMERIS_SLICE_H

#include "orbit/ephemeris/ephemeris.h"

typedef struct orr_ephemeris_slice orr_ephemeris_slice;

// Room for the slices of a product, which must outlive it. ORR_E_MEMORY. Free with orr_ephemeris_slice_close.
orr_status orr_ephemeris_slice_open(const orr_ephemeris *e, orr_ephemeris_slice **out, orr_diag *diag);
// Frees it; NULL may be closed.
void orr_ephemeris_slice_close(orr_ephemeris_slice *s);

// All satellites at an instant; returns whether each of them has an arc, borrowed until the next call.
// A segment is laid out when it is asked for the second time in a row. out: orr_ephemeris_satellites states, in their order;
// those without an arc are untouched.
const bool *orr_ephemeris_slice_eval(orr_ephemeris_slice *s, orr_time t, orr_sat_state *out);

#endif
