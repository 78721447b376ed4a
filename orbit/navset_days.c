// SPDX-License-Identifier: GPL-3.0-or-later
// The almanacs of each day of the product.
#include <stdlib.h>

#include "orbit/navset_impl.h"

#define DAY_NS (ORR_S_PER_DAY * ORR_NS_PER_S)
#define TOA_STEP_S 4096
#define NOT_THERE 63 // all ones: "more than one thing is wrong" (IS-GPS-200N table 20-VIII)

// Six bits of health: that of the sets whose transmission begins on the day, healthy if one of them is.
static uint8_t health_of(const orr_navset *set, orr_sat sat, const navset_day *day)
{
    const orr_navset_item *item;
    size_t n = orr_navset_items(set, sat, &item);
    uint8_t health = NOT_THERE;
    for (size_t k = 0; k < n; k++)
        if (item[k].to > day->from && item[k].from < day->to && health != 0)
            health = (uint8_t)(item[k].eph.health & 63);
    return health;
}

static void begin_day(const orr_navset *set, int64_t number, navset_day *day)
{
    int64_t ns;
    day->from = number * DAY_NS;
    day->to = day->from + DAY_NS;
    orr_time_week(day->from + DAY_NS / 2, &day->week, &ns);
    day->toa_s = (uint32_t)((ns / ORR_NS_PER_S + TOA_STEP_S / 2) / TOA_STEP_S * TOA_STEP_S);
    day->glonass_day = day->from + DAY_NS / 2;
    for (int k = 0; k < 32; k++) day->lnav_health[k] = health_of(set, orr_sat_make('G', k + 1), day);
}

orr_status navset_fit_days(const orr_ephemeris *e, const orr_navset_options *o, orr_navset *set)
{
    (void)e, (void)o;
    const int64_t first = set->from / DAY_NS, last = set->to / DAY_NS;
    set->day = calloc((size_t)(last - first + 1), sizeof *set->day);
    if (set->day == NULL) return ORR_E_MEMORY;
    for (int64_t k = first; k <= last; k++) begin_day(set, k, &set->day[set->n_days++]);
    return ORR_OK;
}

const navset_day *navset_day_at(const orr_navset *set, orr_time t)
{
    for (size_t k = 0; k + 1 < set->n_days; k++)
        if (t < set->day[k].to) return &set->day[k];
    return &set->day[set->n_days - 1];
}
