// SPDX-License-Identifier: GPL-3.0-or-later
// The orbit product as an object: its memory, what is derived from its contents, and what it tells of itself.
#include "orbit/ephemeris/ephemeris.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "orbit/ephemeris/ephemeris_private.h"

orr_status eph_alloc(const orr_ephemeris *counts, orr_ephemeris **out, orr_diag *diag)
{
    orr_ephemeris *e = calloc(1, sizeof *e);
    *out = NULL;
    if (e == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for an orbit product");
    e->n_sats = counts->n_sats;
    e->n_arcs = counts->n_arcs;
    e->n_segments = counts->n_segments;
    e->n_samples = counts->n_samples;
    e->n_coefs = counts->n_coefs;
    e->n_clocks = counts->n_clocks;
    e->n_nodes = counts->n_nodes;
    e->n_events = counts->n_events;
    e->n_sources = counts->n_sources;
    bool ok = true;
    e->backing = counts->backing;
#define TAKE(member, count) ok &= (e->member = calloc((count) + 1, sizeof *e->member)) != NULL
#define TAKE_LONG(member, count)                                                                             \
    ok &= (e->member = e->backing != NULL ? orr_backing_take(e->backing, ((count) + 1) * sizeof *e->member)  \
                                          : calloc((count) + 1, sizeof *e->member)) != NULL
    TAKE(sat_id, e->n_sats);
    TAKE(sat, e->n_sats);
    TAKE(arc, e->n_arcs);
    TAKE_LONG(meta, e->n_segments);
    TAKE_LONG(sigma, e->n_samples);
    TAKE_LONG(sample_flags, e->n_samples);
    TAKE_LONG(clock, e->n_clocks);
    TAKE_LONG(rate, e->n_clocks);
    TAKE_LONG(node, e->n_nodes);
    TAKE(event, e->n_events);
    TAKE(span, e->n_events);
    TAKE(source, e->n_sources);
#undef TAKE
#undef TAKE_LONG
    // Rows of four doubles on cache lines' bounds, so that no load of a vector crosses one.
    size_t bytes = (e->n_coefs * sizeof *e->coef + 63) / 64 * 64 + 64;
    e->coef = e->backing != NULL ? orr_backing_take(e->backing, bytes) : aligned_alloc(64, bytes);
    if (e->coef != NULL && e->backing == NULL) memset(e->coef, 0, bytes);
    if (!ok || e->coef == NULL) {
        const int why = errno;
        orr_ephemeris_free(e);
        return counts->backing != NULL
                   ? orr_diag_set(diag, ORR_E_IO,
                                  "no room beside the output for an orbit product of %zu segments: %s",
                                  counts->n_segments, strerror(why))
                   : orr_diag_set(diag, ORR_E_MEMORY, "no memory for an orbit product of %zu segments",
                                  counts->n_segments);
    }
    *out = e;
    return ORR_OK;
}

void orr_ephemeris_free(orr_ephemeris *e)
{
    if (e == NULL) return;
    free(e->sat_id);
    free(e->sat);
    free(e->arc);
    if (e->backing == NULL) {
        free(e->coef);
        free(e->meta);
        free(e->sigma);
        free(e->sample_flags);
        free(e->clock);
        free(e->rate);
        free(e->node);
    }
    if (e->owns_backing) orr_backing_free(e->backing);
    free(e->event);
    free(e->span);
    free(e->source);
    free(e->clock_events.item);
    orr_earth_rotation_free(&e->rotation);
    free(e);
}

static uint32_t flag_of(orr_event_kind kind)
{
    switch (kind) {
    case ORR_EVENT_MANOEUVRE:
        return ORR_EPH_MANOEUVRE;
    case ORR_EVENT_UMBRA:
    case ORR_EVENT_PENUMBRA:
        return ORR_EPH_ECLIPSE;
    case ORR_EVENT_GAP:
        return ORR_EPH_GAP;
    case ORR_EVENT_OUTLIER:
    case ORR_EVENT_DAY_JUMP:
    case ORR_EVENT_SHADOW_NOISE:
    case ORR_EVENT_NOON_STEP:
        break;
    }
    return 0;
}

static int by_start(const void *a, const void *b)
{
    orr_time x = ((const eph_span *)a)->t0, y = ((const eph_span *)b)->t0;
    return (x > y) - (x < y);
}

static void make_spans(orr_ephemeris *e, eph_sat *s)
{
    s->span = &e->span[e->n_spans];
    s->n_spans = 0;
    for (size_t k = 0; k < s->n_events; k++) {
        uint32_t flag = flag_of(s->event[k].kind);
        if (flag != 0)
            s->span[s->n_spans++] = (eph_span){.t0 = s->event[k].t0, .t1 = s->event[k].t1, .flag = flag};
    }
    if (s->n_spans > 1) qsort(s->span, s->n_spans, sizeof *s->span, by_start);
    for (size_t k = 0; k < s->n_spans; k++) {
        eph_span *p = &s->span[k];
        p->reach = k > 0 && p[-1].reach > p->t1 ? p[-1].reach : p->t1;
    }
    e->n_spans += s->n_spans;
}

enum { MARKS = 3 }; // kinds of flags that spans set
static const uint32_t mark_flag[MARKS] = {ORR_EPH_MANOEUVRE, ORR_EPH_ECLIPSE, ORR_EPH_GAP};

// Adds the span to the arc's segments: those that it covers are counted in change[segment][mark] (+1 where
// covering begins, -1 behind its end), those that it only touches are mixed.
static void mark(const eph_arc *a, const eph_span *span, eph_meta *meta, int32_t (*change)[MARKS])
{
    if (span->t1 < a->t0 || span->t0 > a->t1) return;
    int64_t last = (int64_t)a->n_segments - 1, L = a->segment_ns;
    int64_t first = span->t0 <= a->t0 ? 0 : (span->t0 - a->t0) / L;
    int64_t end = span->t1 >= a->t1 ? last : (span->t1 - a->t0) / L;
    if (first > last) first = last;
    if (span->t0 > a->t0 + first * L) meta[first++].mixed = 1;
    if (first > end) return;
    if (span->t1 < a->t0 + (end + 1) * L) meta[end--].mixed = 1;
    if (first > end) return;
    for (int m = 0; m < MARKS; m++) {
        if (span->flag != mark_flag[m]) continue;
        change[first][m]++;
        change[end + 1][m]--;
    }
}

// The first span that t may lie in: those before it end before t.
static size_t first_reaching(const eph_sat *s, orr_time t)
{
    size_t low = 0, high = s->n_spans;
    while (low < high) {
        size_t mid = low + (high - low) / 2;
        if (s->span[mid].reach < t)
            low = mid + 1;
        else
            high = mid;
    }
    return low;
}

// Flags of the arc's segments as far as they are the same throughout. One pass over the spans that may touch
// it and one over segments.
static orr_status summarise(orr_ephemeris *e, const eph_sat *s, const eph_arc *a, orr_diag *diag)
{
    int32_t(*change)[MARKS] = calloc(a->n_segments + 1, sizeof *change), now[MARKS] = {0};
    if (change == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the flags of %zu segments", a->n_segments);
    eph_meta *meta = &e->meta[a->first_segment];
    for (size_t k = first_reaching(s, a->t0); k < s->n_spans && s->span[k].t0 <= a->t1; k++)
        mark(a, &s->span[k], meta, change);
    for (size_t i = 0; i < a->n_segments; i++) {
        const uint32_t *f = &e->sample_flags[a->first_sample + i * a->samples_per_segment];
        meta[i].flags = f[0];
        for (size_t k = 1; k < a->samples_per_segment; k++) meta[i].mixed |= f[k] != f[0];
        for (int m = 0; m < MARKS; m++) {
            now[m] += change[i][m];
            if (now[m] > 0) meta[i].flags |= mark_flag[m];
        }
    }
    free(change);
    return ORR_OK;
}

// The usual step of clock nodes: the shortest of the first few, which gaps cannot spoil.
static double clock_rate_of_nodes(const eph_sat *s)
{
    int64_t step = 0;
    for (size_t i = 1; i < s->n_clocks && i < 32; i++) {
        int64_t d = s->clock[i].t - s->clock[i - 1].t;
        if (d > 0 && (step == 0 || d < step)) step = d;
    }
    return step > 0 ? 1.0 / (double)step : 0.0;
}

// Whether nodes i and i + 1 are two files' clocks of one instant that differ by no more than such clocks do: days of one centre
// by 0.1 to 0.5 ns. A satellite has one clock, and its signal does not step at midnight.
static bool files_meet(const eph_sat *s, size_t i)
{
    const double most_s = 30e-9; // what is more is looked at as a jump (clock_judge.h)
    return i + 1 < s->n_clocks && s->clock[i].t == s->clock[i + 1].t &&
           (s->clock[i + 1].flags & ORR_EPH_CLOCK_EVENT) == 0 &&
           fabs(s->clock[i + 1].clock_s - s->clock[i].clock_s) <= most_s;
}

// Clock and variance of node i: where two files meet the mean of both, which is off either by half of what they differ.
static double node_clock_s(const eph_sat *s, size_t i, float *sigma2_s2)
{
    const orr_clock_node *c = &s->clock[i];
    const orr_clock_node *other = files_meet(s, i) ? c + 1 : i > 0 && files_meet(s, i - 1) ? c - 1 : c;
    const double half = (other->clock_s - c->clock_s) / 2;
    *sigma2_s2 = c->sigma_s * c->sigma_s + (float)(half * half);
    return c->clock_s + half;
}

// At a node with a way on both sides the rate is the mean of both; each way bends towards it.
static void bend(eph_sat *s)
{
    for (size_t i = 1; i < s->n_clocks; i++) {
        eph_clock *a = &s->rate[i - 1], *b = &s->rate[i];
        if (i > 1 && files_meet(s, i - 1)) a--; // the way to the first of both nodes
        if (a->flags == 0 || b->flags == 0) continue;
        const double half_step = 0.5 * (b->way.rate_sps - a->way.rate_sps);
        a->way.bend_last_sps = half_step;
        b->way.bend_first_sps = -half_step;
    }
}

// Ways between clock nodes. None where nodes are too far apart, nor where SP3's event flag says that the
// clock jumped between the epoch before and the flagged one (SP3-d, column 75), nor between two nodes at one
// instant, where files join.
static void make_rates(const orr_ephemeris *e, eph_sat *s)
{
    int64_t max_ns = e->clock_max_gap_s < 9e8 ? (int64_t)(e->clock_max_gap_s * 1e9) : INT64_MAX;
    s->rate = &e->rate[s->clock - e->clock];
    for (size_t i = 0; i < s->n_clocks; i++) {
        const orr_clock_node *c = &s->clock[i];
        float s2, next_s2;
        const double clock_s = node_clock_s(s, i, &s2);
        s->rate[i] = (eph_clock){.t = c->t, .way.clock_s = clock_s};
        if (i + 1 == s->n_clocks || (c[1].flags & ORR_EPH_CLOCK_EVENT) != 0) continue;
        int64_t step_ns = c[1].t - c[0].t;
        if (step_ns <= 0 || step_ns > max_ns) continue;
        s->rate[i].way.length_s = (double)step_ns * 1e-9;
        s->rate[i].way.rate_sps = (node_clock_s(s, i + 1, &next_s2) - clock_s) / s->rate[i].way.length_s;
        s->rate[i].per_ns = 1 / (double)step_ns;
        s->rate[i].sigma2_s2 = s2;
        s->rate[i].next_s2 = next_s2;
        s->rate[i].flags = ORR_EPH_CLOCK_VALID | ((c[0].flags | c[1].flags) & EPH_CLOCK_FLAGS);
    }
    bend(s);
}

orr_status eph_finish(orr_ephemeris *e, orr_diag *diag)
{
    for (size_t i = 0; i < sizeof e->slot / sizeof e->slot[0]; i++) e->slot[i] = -1;
    e->from = e->to = ORR_TIME_NONE;
    e->n_spans = 0;
    e->wide = eph_machine_is_wide();
    for (size_t i = 0; i < e->n_sats; i++) {
        eph_sat *s = &e->sat[i];
        if (e->sat_id[i] >= sizeof e->slot / sizeof e->slot[0] || e->slot[e->sat_id[i]] >= 0)
            return orr_diag_set(diag, ORR_E_FORMAT,
                                "satellite %zu of the product has an identity that is wrong or taken", i);
        e->slot[e->sat_id[i]] = (int16_t)i;
        make_spans(e, s);
        make_rates(e, s);
        s->clock_per_ns = clock_rate_of_nodes(s);
        for (size_t k = 0; k < s->n_arcs; k++) {
            eph_arc *a = &s->arc[k];
            a->t1 = a->t0 + (int64_t)a->n_segments * a->segment_ns;
            a->per_segment_ns = 1.0 / (double)a->segment_ns;
            a->dx_dt = 2e9 / (double)a->segment_ns;
            if (e->from == ORR_TIME_NONE || a->t0 < e->from) e->from = a->t0;
            if (e->to == ORR_TIME_NONE || a->t1 > e->to) e->to = a->t1;
            orr_status st = summarise(e, s, a, diag);
            if (st != ORR_OK) return st;
        }
        eph_rest(e);
    }
    if (e->from == ORR_TIME_NONE)
        return orr_diag_set(diag, ORR_E_NODATA, "the product holds no orbit at all");
    return ORR_OK;
}

size_t orr_ephemeris_satellites(const orr_ephemeris *e, const orr_sat **list)
{
    *list = e->sat_id;
    return e->n_sats;
}

void orr_ephemeris_span(const orr_ephemeris *e, orr_time *from, orr_time *to)
{
    *from = e->from;
    *to = e->to;
}

static const eph_sat *find(const orr_ephemeris *e, orr_sat sat)
{
    if (sat >= sizeof e->slot / sizeof e->slot[0] || e->slot[sat] < 0) return NULL;
    return &e->sat[e->slot[sat]];
}

size_t orr_ephemeris_nodes(const orr_ephemeris *e, orr_sat sat, const orr_orbit_node **list)
{
    const eph_sat *s = find(e, sat);
    *list = s != NULL ? s->node : NULL;
    return s != NULL ? s->n_nodes : 0;
}

size_t orr_ephemeris_events(const orr_ephemeris *e, orr_sat sat, const orr_orbit_event **list)
{
    const eph_sat *s = find(e, sat);
    *list = s != NULL ? s->event : NULL;
    return s != NULL ? s->n_events : 0;
}

bool orr_ephemeris_arc(const orr_ephemeris *e, orr_sat sat, size_t k, orr_time *from, orr_time *to)
{
    const eph_sat *s = find(e, sat);
    if (s == NULL || k >= s->n_arcs) return false;
    *from = s->arc[k].t0;
    *to = s->arc[k].t1;
    return true;
}

size_t orr_ephemeris_clock_events(const orr_ephemeris *e, const orr_clock_event **list)
{
    *list = e->clock_events.item;
    return e->clock_events.n;
}

size_t orr_ephemeris_clocks(const orr_ephemeris *e, orr_sat sat, const orr_clock_node **list)
{
    const eph_sat *s = find(e, sat);
    *list = s != NULL ? s->clock : NULL;
    return s != NULL ? s->n_clocks : 0;
}

size_t orr_ephemeris_sources(const orr_ephemeris *e, const orr_orbit_source **list)
{
    *list = e->source;
    return e->n_sources;
}

double orr_ephemeris_node_noise_m(const orr_ephemeris *e, orr_sat sat)
{
    const int slot = sat < sizeof e->slot / sizeof e->slot[0] ? e->slot[sat] : -1;
    return slot >= 0 && e->sat[slot].node_noise_m > 0 ? e->sat[slot].node_noise_m : (double)NAN;
}
double orr_ephemeris_node_step_s(const orr_ephemeris *e) { return e->node_step_s; }
const orr_earth_rotation *orr_ephemeris_rotation(const orr_ephemeris *e) { return &e->rotation; }
const orr_eop_series *orr_ephemeris_eop(const orr_ephemeris *e)
{
    return e->rotation.series.n > 0 ? &e->rotation.series : NULL;
}
const char *orr_ephemeris_options(const orr_ephemeris *e) { return e->options; }
const char *orr_ephemeris_frame(const orr_ephemeris *e) { return e->frame; }

void orr_ephemeris_representation(const orr_ephemeris *e, double *pos_m, double *vel_mps)
{
    *pos_m = e->max_pos_error_m;
    *vel_mps = e->max_vel_error_mps;
}

size_t orr_ephemeris_shortened(const orr_ephemeris *e) { return e->n_shortened; }
