// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/solution_cut.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "orbit/smooth/smooth_satellite.h"

// Segments [first, end) of an arc that reach into the span; false where none does.
static bool segments_within(const orr_orbit_arc *a, orr_time from, orr_time to, size_t *first, size_t *end)
{
    const int64_t segment_ns = (int64_t)nearbyint(a->step_s * 1e9) * (int64_t)a->samples_per_segment;
    const int64_t n = (int64_t)((a->n - 1) / a->samples_per_segment);
    int64_t begin = orr_floor_div(orr_time_sub_ns(from, a->t0), segment_ns);
    int64_t last = orr_floor_div(orr_time_sub_ns(to, a->t0) - 1,
                                 segment_ns); // a segment that begins at `to` is not needed
    if (begin < 0) begin = 0;
    if (last > n - 1) last = n - 1;
    *first = (size_t)begin;
    *end = (size_t)(last + 1);
    return begin <= last;
}

static void cut_arcs(orr_orbit_sat *s, orr_time from, orr_time to)
{
    size_t kept = 0;
    for (size_t i = 0; i < s->n_arcs; i++) {
        orr_orbit_arc a = s->arc[i];
        size_t first, end;
        if (!segments_within(&a, from, to, &first, &end)) {
            free(a.sample);
            continue;
        }
        const size_t at = first * a.samples_per_segment;
        a.t0 += (int64_t)at * (int64_t)nearbyint(a.step_s * 1e9);
        a.n = (end - first) * a.samples_per_segment + 1;
        memmove(a.sample, a.sample + at, a.n * sizeof *a.sample);
        s->arc[kept++] = a;
    }
    s->n_arcs = kept;
}

static void cut_clocks(orr_orbit_sat *s, orr_time from, orr_time to)
{
    size_t first = 0, end = s->n_clocks;
    while (first + 1 < s->n_clocks && s->clock[first + 1].t <= from) first++;
    while (first > 0 && s->clock[first - 1].t == s->clock[first].t) first--; // both values of a joint
    while (end > first + 1 && s->clock[end - 2].t >= to) end--;
    while (end < s->n_clocks && s->clock[end].t == s->clock[end - 1].t) end++;
    if (s->n_clocks > 0) memmove(s->clock, s->clock + first, (end - first) * sizeof *s->clock);
    s->n_clocks = end - first;
}

static void cut_nodes(orr_orbit_sat *s, orr_time from, orr_time to)
{
    size_t kept = 0;
    for (size_t i = 0; i < s->n_nodes; i++)
        if (s->node[i].t >= from && s->node[i].t <= to) s->node[kept++] = s->node[i];
    s->n_nodes = kept;
    kept = 0;
    for (size_t i = 0; i < s->n_events; i++)
        if (s->event[i].t1 >= from && s->event[i].t0 <= to) s->event[kept++] = s->event[i];
    s->n_events = kept;
}

void orr_orbit_solution_cut(orr_orbit_solution *s, orr_time from, orr_time to)
{
    size_t kept = 0;
    for (size_t i = 0; i < s->n_sats; i++) {
        orr_orbit_sat *sat = &s->sat[i];
        cut_arcs(sat, from, to);
        if (sat->n_arcs == 0) {
            orr_satellite_free(sat);
            continue;
        }
        cut_clocks(sat, from, to);
        cut_nodes(sat, from, to);
        s->sat[kept++] = *sat;
    }
    s->n_sats = kept;
    kept = 0;
    for (size_t i = 0; i < s->clock_events.n; i++) {
        const orr_clock_event *e = &s->clock_events.item[i];
        if (e->t1 >= from && e->t0 <= to) s->clock_events.item[kept++] = *e;
    }
    s->clock_events.n = kept;
    if (s->from < from) s->from = from;
    if (s->to > to) s->to = to;
}
