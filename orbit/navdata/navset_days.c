// SPDX-License-Identifier: GPL-3.0-or-later
// The almanacs of each day of the product.
#include <math.h>
#include <stdlib.h>

#include "core/parallel.h"
#include "orbit/navdata/almanac_glonass.h"
#include "orbit/navdata/almanac_lnav.h"
#include "orbit/navdata/navset_private.h"

#define DAY_NS (ORR_S_PER_DAY * ORR_NS_PER_S)
#define CLOCK_NS (7200 * ORR_NS_PER_S)
#define TOA_STEP_S 4096
#define NOT_THERE 63   // all ones: "more than one thing is wrong" (IS-GPS-200N table 20-VIII)
#define DATA_BAD 0xe0u // the three bits that an almanac has beside: all data are bad (table 20-VII)

// Six bits of health: that of the sets on the air on the day, healthy if one of them is.
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
    day->noon = day->from + DAY_NS / 2;
    orr_time_week(day->noon, &day->week, &ns);
    day->toa_s = (uint32_t)((ns / ORR_NS_PER_S + TOA_STEP_S / 2) / TOA_STEP_S * TOA_STEP_S);
    for (int k = 0; k < 32; k++) day->lnav_health[k] = health_of(set, orr_sat_make('G', k + 1), day);
}

typedef struct work {
    const orr_ephemeris *e;
    const orr_navset_options *o;
    orr_navset *set;
} work;

// So much of the orbit about an instant, moved inward at the product's ends.
static void window_about(const orr_navset *set, orr_time t, int64_t length, orr_time *from, orr_time *to)
{
    *from = t - length / 2;
    *to = t + length / 2;
    if (*to > set->to) *to = set->to, *from = set->to - length;
    if (*from < set->from) *from = set->from, *to = set->from + length;
    if (*to > set->to) *to = set->to;
}

static bool lnav_almanac(const work *w, navset_day *day, orr_sat sat, orr_lnav_almanac *a)
{
    orr_navfit_product source = {.ephemeris = w->e, .sat = sat};
    orr_navfit_report report;
    orr_time from, to, toa = orr_time_from_week(day->week, day->toa_s * ORR_NS_PER_S);
    window_about(w->set, day->noon, DAY_NS, &from, &to);
    if (orr_almanac_lnav_fit(sat, toa, from, to, orr_navfit_from_product, &source, a, &report, NULL) !=
        ORR_OK)
        return false;
    window_about(w->set, toa, CLOCK_NS, &from,
                 &to); // short: a reset elsewhere on the day is none of its business
    orr_status s = orr_almanac_lnav_clock(w->e, sat, toa, from, to, a, NULL, NULL);
    if (s != ORR_OK && !(s == ORR_E_NODATA && w->o->zero_clocks)) return false;
    const uint8_t health = day->lnav_health[orr_sat_number(sat) - 1];
    a->health = health == 0 ? 0 : DATA_BAD | (health & 31u);
    return true;
}

static bool glonass_almanac(const work *w, navset_day *day, orr_sat sat, orr_glonass_almanac *a)
{
    orr_navfit_product source = {.ephemeris = w->e, .sat = sat};
    orr_navfit_report report;
    bool nominal;
    if (orr_glonass_almanac_fit(sat, day->noon, w->o->leap, orr_navfit_from_product, &source, a, &report,
                                NULL) != ORR_OK)
        return false;
    const orr_navset_item *item = orr_navset_at(w->set, sat, day->noon), *list;
    const size_t n = orr_navset_items(w->set, sat, &list);
    for (size_t k = 0; item == NULL && k < n; k++)
        if (list[k].to > day->from && list[k].from < day->to) item = &list[k];
    if (item == NULL || !orr_glonass_channel(w->o->nav, sat, day->noon, &a->channel, &nominal)) return false;
    a->operational = item->eph.health == 0;
    a->type = 1; // GLONASS-M
    a->tau_s = -item->eph.af0_s;
    return fabs(round(a->tau_s / ORR_GLONASS_ALM_TAU_LSB_S)) < 512; // ten bits, a little less than tau_n's
}

static void fit_one(void *user, size_t i)
{
    const work *w = user;
    navset_day *day = &w->set->day[i / w->set->n_sats];
    const orr_sat sat = w->set->sat[i % w->set->n_sats];
    const size_t k = (size_t)orr_sat_number(sat) - 1;
    if (w->o->cancel != NULL && *w->o->cancel) return;
    if (orr_sat_system(sat) == 'G')
        day->has_lnav[k] = lnav_almanac(w, day, sat, &day->lnav[k]);
    else if (k < 24)
        day->has_glonass[k] = glonass_almanac(w, day, sat, &day->glonass[k]);
}

static size_t count(const bool *has, size_t n)
{
    size_t sum = 0;
    for (size_t k = 0; k < n; k++) sum += has[k];
    return sum;
}

// A day of which too little is there to fit sends the almanacs of the nearest day that has some, as real
// satellites send those of days before.
static void borrow(orr_navset *set, navset_day *day)
{
    const navset_day *lnav = NULL, *glonass = NULL;
    for (size_t k = 0; k < set->n_days; k++) {
        const navset_day *d = &set->day[k];
        if (d->fitted_lnav && (lnav == NULL || llabs(d->from - day->from) < llabs(lnav->from - day->from)))
            lnav = d;
        if (d->fitted_glonass &&
            (glonass == NULL || llabs(d->from - day->from) < llabs(glonass->from - day->from)))
            glonass = d;
    }
    if (lnav != NULL && !day->fitted_lnav) {
        day->toa_s = lnav->toa_s, day->week = lnav->week;
        for (int k = 0; k < 32; k++) day->has_lnav[k] = lnav->has_lnav[k], day->lnav[k] = lnav->lnav[k];
    }
    if (glonass != NULL && !day->fitted_glonass)
        for (int k = 0; k < 24; k++)
            day->has_glonass[k] = glonass->has_glonass[k], day->glonass[k] = glonass->glonass[k];
    day->glonass_day = glonass != NULL && !day->fitted_glonass ? glonass->noon : day->noon;
}

orr_status navset_fit_days(const orr_ephemeris *e, const orr_navset_options *o, orr_navset *set)
{
    const int64_t first = set->from / DAY_NS, last = (set->to - 1) / DAY_NS;
    set->day = calloc((size_t)(last - first + 1), sizeof *set->day);
    if (set->day == NULL) return ORR_E_MEMORY;
    for (int64_t k = first; k <= last; k++) begin_day(set, k, &set->day[set->n_days++]);
    work w = {.e = e, .o = o, .set = set};
    orr_parallel_each(set->n_days * set->n_sats, o->jobs, fit_one, &w);
    if (o->cancel != NULL && *o->cancel) return ORR_E_INTERRUPTED;
    for (size_t k = 0; k < set->n_days; k++) {
        set->day[k].fitted_lnav = count(set->day[k].has_lnav, 32) > 0;
        set->day[k].fitted_glonass = count(set->day[k].has_glonass, 24) > 0;
    }
    for (size_t k = 0; k < set->n_days; k++) borrow(set, &set->day[k]);
    return ORR_OK;
}

const navset_day *navset_day_at(const orr_navset *set, orr_time t)
{
    for (size_t k = 0; k + 1 < set->n_days; k++)
        if (t < set->day[k].to) return &set->day[k];
    return &set->day[set->n_days - 1];
}
