// SPDX-License-Identifier: GPL-3.0-or-later
// What a set of navigation data holds of a satellite, and what is on the air at an instant.
#include <stdlib.h>

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

size_t orr_navset_items(const orr_navset *set, orr_sat sat, const orr_navset_item **list)
{
    const orr_sat *found = bsearch(&sat, set->sat, set->n_sats, sizeof *set->sat, by_sat);
    if (found == NULL) return 0;
    const navset_satellite *s = &set->sets[found - set->sat];
    *list = s->item;
    return s->n;
}

const orr_navset_item *orr_navset_at(const orr_navset *set, orr_sat sat, orr_time t)
{
    const orr_navset_item *list;
    size_t low = 0, high = orr_navset_items(set, sat, &list);
    while (low < high) { // the first that begins after t
        size_t mid = low + (high - low) / 2;
        if (list[mid].from <= t)
            low = mid + 1;
        else
            high = mid;
    }
    return low > 0 && t < list[low - 1].to ? &list[low - 1] : NULL;
}
