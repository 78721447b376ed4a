// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/spacecraft/eclipses.h"

#define TOUCH_NS ORR_NS_PER_S // events nearer than that are one passage: boundaries are good to 0.1 s

static bool is_shadow(const orr_orbit_event *e)
{
    return e->kind == ORR_EVENT_UMBRA || e->kind == ORR_EVENT_PENUMBRA;
}

// Whether the arc, not the shadow, sets an event's begin or end.
static bool begins_with_arc(const orr_ephemeris *e, orr_sat sat, const orr_orbit_event *v)
{
    orr_sat_state s;
    return orr_ephemeris_eval(e, sat, v->t0 + (v->t1 - v->t0) / 2, &s) != ORR_OK ||
           v->t0 - s.valid_from < TOUCH_NS / 10;
}
static bool ends_with_arc(const orr_ephemeris *e, orr_sat sat, const orr_orbit_event *v)
{
    orr_sat_state s;
    return orr_ephemeris_eval(e, sat, v->t0 + (v->t1 - v->t0) / 2, &s) != ORR_OK ||
           s.valid_to - v->t1 < TOUCH_NS / 10;
}

// Shadow events first..last of one passage.
static orr_eclipse passage(const orr_ephemeris *e, orr_sat sat, const orr_orbit_event *v, size_t first,
                           size_t last)
{
    orr_eclipse x = {.sat = sat,
                     .penumbra_from = ORR_TIME_NONE,
                     .umbra_from = ORR_TIME_NONE,
                     .umbra_to = ORR_TIME_NONE,
                     .penumbra_to = ORR_TIME_NONE,
                     .from = v[first].t0,
                     .to = v[last].t1};
    const bool cut_begin = begins_with_arc(e, sat, &v[first]), cut_end = ends_with_arc(e, sat, &v[last]);
    if (!cut_begin) x.penumbra_from = v[first].t0;
    if (!cut_end) x.penumbra_to = v[last].t1;
    for (size_t i = first; i <= last; i++) {
        if (v[i].kind != ORR_EVENT_UMBRA) continue;
        if (!x.umbra && !(i == first && cut_begin)) x.umbra_from = v[i].t0;
        x.umbra_to = i == last && cut_end ? ORR_TIME_NONE : v[i].t1;
        x.umbra = true;
    }
    x.umbra_known = x.umbra || (!cut_begin && !cut_end);
    return x;
}

size_t orr_eclipses_of(const orr_ephemeris *e, orr_sat sat, orr_eclipse *out, size_t max)
{
    const orr_orbit_event *v;
    const size_t n_events = orr_ephemeris_events(e, sat, &v);
    size_t n = 0;
    for (size_t i = 0; i < n_events; i++) {
        if (!is_shadow(&v[i])) continue;
        size_t first = i, last = i;
        for (size_t k = i + 1; k < n_events && v[k].t0 - v[last].t1 <= TOUCH_NS; k++)
            if (is_shadow(&v[k])) last = k;
        if (n < max) out[n] = passage(e, sat, v, first, last);
        n++;
        i = last;
    }
    return n;
}
