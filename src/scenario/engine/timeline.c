// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/engine/timeline.h"

#include <stdlib.h>

#include "core/array.h"
#include "orbit/spacecraft/eclipses.h"

struct orr_timeline {
    const orr_engine *e;
    orr_span span; // served
    size_t n;
    orr_happening *dated; // [n] ascending
    size_t n_senders;
    orr_sat *sender; // [n_senders] satellites that antennas may see
    bool full;       // out of memory while it was gathered
};

enum { TIMELINE_SATS = 1024 }; // more than a product can have
static const int64_t STEP_FIXED_NS = 10 * ORR_NS_PER_S, STEP_RIDING_NS = ORR_NS_PER_S;

static int by_time(const void *a, const void *b)
{
    const orr_happening *x = a, *y = b;
    if (x->t != y->t) return x->t < y->t ? -1 : 1;
    if (x->kind != y->kind) return x->kind < y->kind ? -1 : 1;
    if (x->sat != y->sat) return x->sat < y->sat ? -1 : 1;
    if (x->antenna != y->antenna) return x->antenna < y->antenna ? -1 : 1;
    if (x->message != y->message) return x->message < y->message ? -1 : 1;
    return x->value < y->value ? -1 : x->value > y->value;
}

// --- What has a date ---

static void date(orr_timeline *l, orr_happening h)
{
    if (!orr_span_holds(l->span, h.t)) return;
    if (ORR_ARRAY_GROW(l->dated, l->n))
        l->dated[l->n++] = h;
    else
        l->full = true;
}

static void date_sat(orr_timeline *l, orr_happening_kind kind, orr_sat sat, orr_time t)
{
    if (t != ORR_TIME_NONE)
        date(l, (orr_happening){.t = t, .kind = kind, .sat = sat, .antenna = ORR_NO_ANTENNA});
}

static void date_orbit(orr_timeline *l, const orr_ephemeris *eph, orr_sat sat)
{
    orr_time from, to;
    const orr_orbit_event *v;
    for (size_t k = 0; orr_ephemeris_arc(eph, sat, k, &from, &to); k++) {
        date_sat(l, ORR_HAPPENS_ARC_BEGIN, sat, from);
        date_sat(l, ORR_HAPPENS_ARC_END, sat, to);
    }
    const size_t n = orr_ephemeris_events(eph, sat, &v);
    for (size_t k = 0; k < n; k++) {
        if (v[k].kind != ORR_EVENT_MANOEUVRE) continue;
        date_sat(l, ORR_HAPPENS_MANOEUVRE_BEGIN, sat, v[k].t0);
        date_sat(l, ORR_HAPPENS_MANOEUVRE_END, sat, v[k].t1);
    }
    const size_t most = orr_eclipses_of(eph, sat, NULL, 0);
    orr_eclipse *x = calloc(most + 1, sizeof *x);
    l->full = l->full || x == NULL;
    if (x != NULL) (void)orr_eclipses_of(eph, sat, x, most);
    for (size_t k = 0; x != NULL && k < most; k++) {
        date_sat(l, ORR_HAPPENS_ECLIPSE_BEGIN, sat, x[k].penumbra_from);
        date_sat(l, ORR_HAPPENS_ECLIPSE_END, sat, x[k].penumbra_to);
    }
    free(x);
}

// Sets of a message: each that differs from the one before.
static void date_message(orr_timeline *l, const orr_navset *set, orr_sat sat, orr_nav_message message)
{
    const orr_navset_item *item;
    const size_t n = orr_navset_items(set, sat, message, &item);
    for (size_t k = 0; k < n; k++) {
        orr_happening h = {.t = item[k].from, .sat = sat, .antenna = ORR_NO_ANTENNA, .message = message};
        h.kind = ORR_HAPPENS_EPHEMERIS;
        h.value = item[k].eph.iode;
        date(l, h);
        if (item[k].eph.health == (k > 0 ? item[k - 1].eph.health : 0)) continue;
        h.kind = ORR_HAPPENS_HEALTH;
        h.value = item[k].eph.health;
        date(l, h);
    }
}

static void date_navdata(orr_timeline *l, const orr_navset *set)
{
    const orr_sat *sats;
    const size_t n = set != NULL ? orr_navset_satellites(set, &sats) : 0;
    for (size_t i = 0; i < n; i++) {
        const orr_nav_stream *list[ORR_NAVSET_STREAMS];
        const size_t streams = orr_navset_streams(set, sats[i], list);
        uint32_t done = 0; // signals that carry bits of their own may share a message's sets
        for (size_t k = 0; k < streams; k++) {
            const uint32_t bit = UINT32_C(1) << list[k]->message;
            if ((done & bit) == 0) date_message(l, set, sats[i], list[k]->message);
            done |= bit;
        }
    }
}

static void date_leap_seconds(orr_timeline *l, const orr_leap_table *leap)
{
    for (size_t k = 0; k < leap->n; k++)
        date(l, (orr_happening){.t = orr_time_from_mjd(leap->entry[k].mjd, 0, ORR_SCALE_UTC, leap),
                                .kind = ORR_HAPPENS_LEAP_SECOND,
                                .antenna = ORR_NO_ANTENNA,
                                .value = leap->entry[k].tai_minus_utc_s - ORR_TAI_MINUS_GPS_S});
}

static void date_faults(orr_timeline *l, const orr_channels *c)
{
    orr_channel_fault x;
    for (size_t k = 0; orr_channels_fault(c, k, &x); k++) {
        orr_happening h = {.t = x.from, .sat = x.sat, .antenna = ORR_NO_ANTENNA, .value = (int64_t)x.number};
        h.kind = ORR_HAPPENS_FAULT_BEGIN;
        date(l, h);
        h.t = x.to;
        h.kind = ORR_HAPPENS_FAULT_END;
        date(l, h);
    }
}

static void list_senders(orr_timeline *l, const orr_channels *c)
{
    orr_transmitter x;
    for (size_t k = 0; !l->full && c != NULL && orr_channels_transmitter(c, k, &x); k++)
        if (l->n_senders < TIMELINE_SATS && ORR_ARRAY_GROW(l->sender, l->n_senders))
            l->sender[l->n_senders++] = x.sat;
        else
            l->full = true;
}

orr_status orr_timeline_open(const orr_engine *e, orr_timeline **out, orr_diag *diag)
{
    orr_timeline *l = calloc(1, sizeof *l);
    if (l == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    const orr_sat *sats;
    orr_span motion;
    const size_t n = orr_engine_satellites(e, &sats);
    l->e = e;
    orr_engine_span(e, &l->span.from, &l->span.to);
    for (size_t k = 0; k < n; k++) date_orbit(l, orr_engine_ephemeris(e), sats[k]);
    date_navdata(l, orr_engine_navset(e));
    date_leap_seconds(l, orr_engine_leap(e));
    date_faults(l, orr_engine_channels(e));
    list_senders(l, orr_engine_channels(e));
    if (orr_engine_part_span(e, ORR_PART_MOTION, &motion)) {
        date_sat(l, ORR_HAPPENS_MOTION_BEGIN, ORR_SAT_NONE, motion.from);
        date_sat(l, ORR_HAPPENS_MOTION_END, ORR_SAT_NONE, motion.to);
    }
    if (l->full) {
        orr_timeline_close(l);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    if (l->n > 0) qsort(l->dated, l->n, sizeof *l->dated, by_time);
    *out = l;
    return ORR_OK;
}

void orr_timeline_close(orr_timeline *l)
{
    if (l == NULL) return;
    free(l->dated);
    free(l->sender);
    free(l);
}

// --- Rises and sets ---

// Where happenings go.
typedef struct gathering {
    orr_happening *out;
    size_t n, max;
    bool over; // there are more
} gathering;

static void gather(gathering *g, orr_happening h)
{
    if (g->n < g->max)
        g->out[g->n++] = h;
    else
        g->over = true;
}

// Whether antenna a sees a satellite at t; false where one of them is not there.
static bool sees(const orr_channels *c, size_t a, orr_sat sat, const orr_ephemeris *eph, orr_time t,
                 const orr_antenna_state *at)
{
    orr_sat_state s;
    return at != NULL && orr_ephemeris_eval(eph, sat, t, &s) == ORR_OK &&
           orr_channels_sees(c, a, at, s.pos_m);
}

// The antenna at an instant of the channels' span; NULL where it is not there.
static const orr_antenna_state *stands(const orr_channels *c, size_t a, orr_time t, orr_antenna_state *at)
{
    return orr_span_holds(orr_channels_antenna_span(c, a), t) &&
                   orr_antenna_at(orr_channels_antenna(c, a), t, at) == ORR_ANSWER_OK
               ? at
               : NULL;
}

// First instant after t0, at which it was `before`, at which it is not: it is not at t1.
static orr_time change(const orr_channels *c, size_t a, orr_sat sat, const orr_ephemeris *eph, bool before,
                       orr_time t0, orr_time t1)
{
    orr_antenna_state at;
    while (t1 - t0 > 1) {
        const orr_time mid = t0 + (t1 - t0) / 2;
        if (sees(c, a, sat, eph, mid, stands(c, a, mid, &at)) == before)
            t0 = mid;
        else
            t1 = mid;
    }
    return t1;
}

// One antenna, between neighbours of the lattice; what falls into [from, to).
static void gather_passes(const orr_timeline *l, size_t a, orr_time from, orr_time to, gathering *g)
{
    const orr_channels *c = orr_engine_channels(l->e);
    const orr_ephemeris *eph = orr_engine_ephemeris(l->e);
    const int64_t step = orr_channels_antenna(c, a)->motion != NULL ? STEP_RIDING_NS : STEP_FIXED_NS;
    const orr_time begin = from - 1 - orr_floor_mod(from - 1, step);
    orr_antenna_state at1;
    bool was[TIMELINE_SATS] = {false};
    for (orr_time t1 = begin; t1 < to + step; t1 += step) { // the first only says what was before
        const orr_antenna_state *s1 = stands(c, a, t1, &at1);
        for (size_t k = 0; k < l->n_senders; k++) {
            const orr_sat sat = l->sender[k];
            const bool before = was[k];
            was[k] = sees(c, a, sat, eph, t1, s1);
            if (t1 == begin || was[k] == before) continue;
            const orr_time t = change(c, a, sat, eph, before, t1 - step, t1);
            if (t >= from && t < to)
                gather(g, (orr_happening){.t = t,
                                          .kind = before ? ORR_HAPPENS_SET : ORR_HAPPENS_RISE,
                                          .sat = sat,
                                          .antenna = (uint16_t)a});
        }
    }
}

bool orr_timeline_between(const orr_timeline *l, orr_time from, orr_time to, orr_happening *out, size_t max,
                          size_t *n)
{
    gathering g = {.out = out, .max = max};
    size_t low = 0, high = l->n; // the first that is not before `from`
    while (low < high) {
        const size_t mid = (low + high) / 2;
        if (l->dated[mid].t < from)
            low = mid + 1;
        else
            high = mid;
    }
    for (size_t k = low; k < l->n && l->dated[k].t < to; k++) gather(&g, l->dated[k]);
    if (orr_engine_ephemeris(l->e) != NULL)
        for (size_t a = 0; a < orr_channels_antennas(orr_engine_channels(l->e)); a++)
            gather_passes(l, a, from, to, &g);
    if (g.n > 1) qsort(out, g.n, sizeof *out, by_time);
    *n = g.n;
    return !g.over;
}
