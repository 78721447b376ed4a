// SPDX-License-Identifier: GPL-3.0-or-later
// Values at the nodes of a lattice of time, and between them cubics through nodes with their central differences as slopes: value
// and rate are continuous, and blocks whose length divides the lattice's step hold them exactly.
#ifndef ORR_SCENARIO_EFFECT_SERIES_H
#define ORR_SCENARIO_EFFECT_SERIES_H

#include "core/status.h"
#include "core/time.h"

typedef struct orr_series {
    orr_time from; // of node 1, a multiple of step_ns; node 0 is before it
    int64_t step_ns;
    size_t n;
    double *node; // [n]
} orr_series;

enum { ORR_SERIES_NODES = 20000000 }; // of all series of a kind together, at most

// Room for a series over a span; its nodes are the caller's to fill.
// Given:
//   from, to  span
//   step_ns   of the lattice
//   spare     nodes that may still be made
// Returned:
//   spare     less those of this series
//   out       the series; free with orr_series_free
// Errors: ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_series_open(orr_time from, orr_time to, int64_t step_ns, size_t *spare, orr_series *out);
void orr_series_free(orr_series *s); // leaves it empty
// Value and rate at t, of the span; beyond its end, as a block along live motion may reach, the last cubic goes on.
double orr_series_at(const orr_series *s, orr_time t, double *rate_ps);

#endif
