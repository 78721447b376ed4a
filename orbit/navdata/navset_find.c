// SPDX-License-Identifier: GPL-3.0-or-later
// What a set of navigation data holds of a satellite, and what is on the air at an instant.
#include <stdlib.h>

#include "orbit/broadcast/broadcast.h"
#include "orbit/navdata/navset_private.h"

size_t orr_navset_satellites(const orr_navset *set, const orr_sat **list)
{
    *list = set->sat;
    return set->n_sats;
}

static int by_sat(const void *key, const void *member)
{
    return (int)*(const orr_sat *)key - (int)*(const orr_sat *)member;
}

static const navset_satellite *find(const orr_navset *set, orr_sat sat)
{
    const orr_sat *found = bsearch(&sat, set->sat, set->n_sats, sizeof *set->sat, by_sat);
    return found != NULL ? &set->sets[found - set->sat] : NULL;
}

static const navset_series *find_series(const navset_satellite *s, uint8_t message)
{
    for (size_t k = 0; s != NULL && k < s->n; k++)
        if (s->series[k].n > 0 && (message == ORR_NAV_NONE || s->series[k].message == message))
            return &s->series[k];
    return NULL;
}

size_t orr_navset_streams(const orr_navset *set, orr_sat sat, const orr_nav_stream *list[ORR_NAVSET_STREAMS])
{
    const navset_satellite *s = find(set, sat);
    size_t n, found = 0;
    const orr_nav_stream *all = orr_nav_streams(&n);
    for (size_t k = 0; s != NULL && k < n && found < ORR_NAVSET_STREAMS; k++)
        if (all[k].system == orr_sat_system(sat) && find_series(s, all[k].message) != NULL)
            list[found++] = &all[k];
    return found;
}

size_t orr_navset_items(const orr_navset *set, orr_sat sat, orr_nav_message message,
                        const orr_navset_item **list)
{
    const navset_series *s = find_series(find(set, sat), (uint8_t)message);
    if (s == NULL) return 0;
    *list = s->item;
    return s->n;
}

const orr_navset_item *orr_navset_at(const orr_navset *set, orr_sat sat, orr_nav_message message, orr_time t)
{
    const orr_navset_item *list;
    size_t low = 0, high = orr_navset_items(set, sat, message, &list);
    while (low < high) { // the first that begins after t
        size_t mid = low + (high - low) / 2;
        if (list[mid].from <= t)
            low = mid + 1;
        else
            high = mid;
    }
    return low > 0 && t < list[low - 1].to ? &list[low - 1] : NULL;
}

bool orr_navset_step(const orr_navset_item *last, const orr_navset_item *next, double *step_m,
                     double *clock_step_s)
{
    orr_broadcast_state a, b;
    if (last->to != next->from || last->eph.health != 0 || next->eph.health != 0 ||
        orr_broadcast_eval(&last->eph, next->from, &a) != ORR_OK ||
        orr_broadcast_eval(&next->eph, next->from, &b) != ORR_OK)
        return false;
    *step_m = orr_vec3_norm(orr_vec3_sub(b.pos_m, a.pos_m));
    *clock_step_s = b.clock_s + b.relativity_s - a.clock_s - a.relativity_s;
    return true;
}
