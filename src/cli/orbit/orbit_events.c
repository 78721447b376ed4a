// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/orbit/orbit_events.h"

#include <math.h>
#include <stdio.h>

const char *orbit_event_name(orr_event_kind kind)
{
    switch (kind) {
    case ORR_EVENT_MANOEUVRE:
        return "manoeuvre";
    case ORR_EVENT_UMBRA:
        return "umbra";
    case ORR_EVENT_PENUMBRA:
        return "penumbra";
    case ORR_EVENT_OUTLIER:
        return "outlier";
    case ORR_EVENT_GAP:
        return "gap";
    case ORR_EVENT_DAY_JUMP:
        return "jump";
    case ORR_EVENT_SHADOW_NOISE:
        return "shadow_noise";
    case ORR_EVENT_NOON_STEP:
        return "noon_step";
    }
    return "unknown";
}

// What the product has in the middle of a gap.
static const char *became_of(const orr_ephemeris *orbit, orr_sat sat, const orr_orbit_event *e)
{
    orr_sat_state state;
    if (orr_ephemeris_eval(orbit, sat, e->t0 + (e->t1 - e->t0) / 2, &state) != ORR_OK)
        return ": left open, longer than is bridged (--max-gap)";
    return (state.flags & ORR_EPH_PREDICTED) != 0 ? ": bridged by broadcast ephemerides, flagged as predicted"
                                                  : ": bridged by the smoothed orbit";
}

bool orbit_event_text(orr_sat sat, const orr_orbit_event *e, const orr_ephemeris *orbit, char *buf, size_t n)
{
    char name[ORR_SAT_TEXT], from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
    orr_sat_text(sat, name);
    orr_time_text(e->t0, from);
    orr_time_text(e->t1, to);
    switch (e->kind) {
    case ORR_EVENT_MANOEUVRE:
        snprintf(buf, n, "%s: a manoeuvre of %.3g m/s between %s and %s", name, e->value, from, to);
        return true;
    case ORR_EVENT_OUTLIER:
        if (e->value > 0)
            snprintf(buf, n, "%s: the position of %s is %.3f m off the orbit and left out", name, from,
                     e->value);
        else
            snprintf(buf, n, "%s: the position of %s is left out, no orbit is near it", name, from);
        return true;
    case ORR_EVENT_GAP:
        snprintf(buf, n, "%s: no positions between %s and %s%s", name, from, to,
                 orbit != NULL ? became_of(orbit, sat, e) : "");
        return true;
    default:
        return false;
    }
}

void orbit_events_count(const orr_orbit_event *e, size_t n, orbit_event_counts *counts)
{
    orr_time shadow_end = ORR_TIME_NONE;
    for (size_t i = 0; i < n; i++) {
        counts->manoeuvres += e[i].kind == ORR_EVENT_MANOEUVRE;
        counts->outliers += e[i].kind == ORR_EVENT_OUTLIER;
        counts->gaps += e[i].kind == ORR_EVENT_GAP;
        counts->jumps += e[i].kind == ORR_EVENT_DAY_JUMP;
        if (e[i].kind != ORR_EVENT_UMBRA && e[i].kind != ORR_EVENT_PENUMBRA) continue;
        counts->eclipses += shadow_end == ORR_TIME_NONE || e[i].t0 - shadow_end > ORR_NS_PER_S;
        shadow_end = e[i].t1;
    }
}

const char *orbit_events_summary(const orbit_event_counts *counts, char *buf, size_t n)
{
    const struct {
        size_t count;
        const char *one, *many;
    } kind[] = {{counts->manoeuvres, "manoeuvre", "manoeuvres"},
                {counts->outliers, "position left out", "positions left out"},
                {counts->gaps, "gap", "gaps"},
                {counts->jumps, "joint of files", "joints of files"},
                {counts->eclipses, "eclipse", "eclipses"}};
    size_t at = 0;
    snprintf(buf, n, "none");
    for (size_t k = 0; k < sizeof kind / sizeof kind[0] && at < n; k++) {
        if (kind[k].count == 0) continue;
        int more = snprintf(buf + at, n - at, "%s%zu %s", at > 0 ? ", " : "", kind[k].count,
                            kind[k].count == 1 ? kind[k].one : kind[k].many);
        at += more > 0 ? (size_t)more : 0;
    }
    return buf;
}
