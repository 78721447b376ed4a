// SPDX-License-Identifier: GPL-3.0-or-later
// The almanacs of each day of the product.
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "core/parallel.h"
#include "orbit/navdata/almanac_glonass.h"
#include "orbit/navdata/almanac_kepler.h"
#include "orbit/navdata/gps_configuration.h"
#include "orbit/navdata/navset_private.h"
#include "orbit/navdata/system_week.h"

#define DAY_NS (ORR_S_PER_DAY * ORR_NS_PER_S)
#define CLOCK_NS (7200 * ORR_NS_PER_S)
#define DATA_BAD                                                                                             \
    0xe0u // the three bits that a GPS almanac has beside: all data are bad (IS-GPS-200N table 20-VII)
#define LNAV_OUT 0x1cu
#define QZSS_OUT 0x1fu // every signal is unhealthy

// Health of the sets on the air on the day: good if one of them is.
static uint8_t health_of(const orr_navset *set, orr_sat sat, const navset_day *day)
{
    const orr_navset_item *item;
    size_t n = orr_navset_items(set, sat, ORR_NAV_NONE, &item);
    uint8_t health = NAVSET_NOT_THERE;
    for (size_t k = 0; k < n; k++)
        if (item[k].to > day->from && item[k].from < day->to && health != NAVSET_GOOD)
            health = item[k].eph.health == 0 ? NAVSET_GOOD : NAVSET_OUT;
    return health;
}

// The toa nearest to noon.
static void begin_almanacs(const orr_navset *set, const navset_day *day, char system, navset_almanacs *a)
{
    const orr_sat first = orr_sat_make(system, 1);
    const int64_t step = orr_almanac_toa_step_s(orr_almanac_lattice_of(first)) * ORR_NS_PER_S;
    const int64_t ns = orr_nav_seconds_of_week(first, day->noon, &a->week);
    const int64_t toa = (ns + step / 2) / step * step;
    a->toa = day->noon + (toa - ns);
    a->toa_s = (uint32_t)(toa / ORR_NS_PER_S);
    for (int k = 1; k < 64; k++) a->health[k] = health_of(set, orr_sat_make(system, k), day);
}

// The Earth's rotation about noon as the product has it. Messages send the reference in units of 16 s, BeiDou 2 s short of it: UT1
// moves by less than its LSB in that time.
static orr_modern_rotation rotation_of(const orr_ephemeris *e, const orr_navset *set, orr_time noon)
{
    orr_modern_rotation r = {.reference = noon};
    const orr_eop eop = orr_eop_at(&orr_ephemeris_rotation(e)->series, noon, set->leap, NULL);
    r.xp_rad = eop.xp_rad, r.xp_rate_radps = eop.xp_rate_radps;
    r.yp_rad = eop.yp_rad, r.yp_rate_radps = eop.yp_rate_radps;
    r.ut1_utc_s = eop.ut1_utc_s, r.ut1_rate_spd = -eop.lod_s;
    return r;
}

static void begin_day(const orr_ephemeris *e, const orr_navset *set, const orr_navset_options *o,
                      int64_t number, navset_day *day)
{
    day->from = number * DAY_NS;
    day->to = day->from + DAY_NS;
    day->noon = day->from + DAY_NS / 2;
    day->rotation = rotation_of(e, set, day->noon);
    begin_almanacs(set, day, 'G', &day->gps);
    begin_almanacs(set, day, 'E', &day->galileo);
    begin_almanacs(set, day, 'C', &day->beidou);
    begin_almanacs(set, day, 'J', &day->qzss);
    begin_almanacs(set, day, 'I', &day->navic);
    for (int k = 0; k < 32; k++)
        day->gps_configuration[k] = orr_gps_configuration(o->antex, orr_sat_make('G', k + 1), day->noon);
}

static navset_almanacs *almanacs_of(navset_day *day, orr_sat sat)
{
    if (orr_almanac_lattice_of(sat) == NULL) return NULL;
    switch (orr_sat_system(sat)) {
    case 'G':
        return &day->gps;
    case 'E':
        return &day->galileo;
    case 'J':
        return &day->qzss;
    case 'I':
        return &day->navic;
    default:
        return &day->beidou;
    }
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

static bool kepler_almanac(const work *w, const navset_day *day, const navset_almanacs *of, orr_sat sat,
                           orr_almanac *a)
{
    orr_navfit_product source = {.ephemeris = w->e, .sat = sat};
    orr_navfit_report report;
    orr_time from, to;
    window_about(w->set, day->noon, DAY_NS, &from, &to);
    if (orr_almanac_fit(sat, of->toa, from, to, orr_navfit_from_product, &source, a, &report, NULL) != ORR_OK)
        return false;
    window_about(w->set, of->toa, CLOCK_NS, &from,
                 &to); // short: a reset elsewhere on the day is none of its business
    orr_status s = orr_almanac_clock(w->e, sat, of->toa, from, to, a, NULL, NULL);
    if (s != ORR_OK && !(s == ORR_E_NODATA && w->o->zero_clocks)) return false;
    const bool good = of->health[orr_sat_number(sat)] == NAVSET_GOOD;
    const char system = orr_sat_system(sat);
    a->health = good ? 0 : system == 'G' ? DATA_BAD | LNAV_OUT : system == 'J' ? QZSS_OUT : 1;
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
    const orr_navset_item *item = orr_navset_at(w->set, sat, ORR_NAV_FDMA, day->noon), *list;
    const size_t n = orr_navset_items(w->set, sat, ORR_NAV_FDMA, &list);
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
    const size_t k = (size_t)orr_sat_number(sat);
    navset_almanacs *of = almanacs_of(day, sat);
    if (w->o->cancel != NULL && *w->o->cancel) return;
    if (of != NULL)
        of->has[k] = kepler_almanac(w, day, of, sat, &of->sat[k]);
    else if (orr_sat_system(sat) == 'R' && k <= 24)
        day->has_glonass[k - 1] = glonass_almanac(w, day, sat, &day->glonass[k - 1]);
}

enum { GLONASS_PLACE = offsetof(navset_day, has_glonass) };

static size_t count(const bool *has, size_t n)
{
    size_t sum = 0;
    for (size_t k = 0; k < n; k++) sum += has[k];
    return sum;
}

static navset_almanacs *almanacs_at(navset_day *day, size_t place)
{
    return (navset_almanacs *)((char *)day + place);
}

static bool has_fitted(const orr_navset *set, size_t day, size_t place)
{
    return place == GLONASS_PLACE ? set->day[day].fitted_glonass : almanacs_at(&set->day[day], place)->fitted;
}

static void take_kepler(navset_almanacs *own, const navset_almanacs *from)
{
    own->toa = from->toa, own->toa_s = from->toa_s, own->week = from->week;
    memcpy(own->has, from->has, sizeof own->has);
    memcpy(own->sat, from->sat, sizeof own->sat);
}

static void take_glonass(navset_day *own, const navset_day *from)
{
    own->glonass_day = from->noon;
    memcpy(own->has_glonass, from->has_glonass, sizeof own->has_glonass);
    memcpy(own->glonass, from->glonass, sizeof own->glonass);
}

// Days of which too little is there to fit send the almanacs of the nearest day that has some, the earlier of two as near, as real
// satellites send those of days before. The set of a system is found by its place in navset_day.
static void borrow(orr_navset *set, size_t place)
{
    size_t before = set->n_days, after = 0; // the last fitted day so far, the first that comes
    for (size_t k = 0; k < set->n_days; k++) {
        if (place == GLONASS_PLACE) set->day[k].glonass_day = set->day[k].noon;
        if (has_fitted(set, k, place)) {
            before = k;
            continue;
        }
        if (after <= k) after = k + 1;
        while (after < set->n_days && !has_fitted(set, after, place)) after++;
        const bool has_before = before < set->n_days, has_after = after < set->n_days;
        if (!has_before && !has_after) continue;
        const size_t from = has_before && (!has_after || k - before <= after - k) ? before : after;
        if (place == GLONASS_PLACE)
            take_glonass(&set->day[k], &set->day[from]);
        else
            take_kepler(almanacs_at(&set->day[k], place), almanacs_at(&set->day[from], place));
    }
}

static const size_t places[] = {offsetof(navset_day, gps), offsetof(navset_day, galileo),
                                offsetof(navset_day, beidou), offsetof(navset_day, qzss),
                                offsetof(navset_day, navic)};
enum { N_PLACES = sizeof places / sizeof *places };

orr_status navset_fit_days(const orr_ephemeris *e, const orr_navset_options *o, orr_navset *set)
{
    const int64_t first = set->from / DAY_NS, last = (set->to - 1) / DAY_NS;
    set->day = calloc((size_t)(last - first + 1), sizeof *set->day);
    if (set->day == NULL) return ORR_E_MEMORY;
    for (int64_t k = first; k <= last; k++) begin_day(e, set, o, k, &set->day[set->n_days++]);
    work w = {.e = e, .o = o, .set = set};
    orr_parallel_each(set->n_days * set->n_sats, o->jobs, fit_one, &w);
    if (o->cancel != NULL && *o->cancel) return ORR_E_INTERRUPTED;
    for (size_t k = 0; k < set->n_days; k++) {
        for (size_t i = 0; i < N_PLACES; i++) {
            navset_almanacs *of = almanacs_at(&set->day[k], places[i]);
            of->fitted = count(of->has, 64) > 0;
        }
        set->day[k].fitted_glonass = count(set->day[k].has_glonass, 24) > 0;
    }
    for (size_t i = 0; i < N_PLACES; i++) borrow(set, places[i]);
    borrow(set, GLONASS_PLACE);
    return ORR_OK;
}

const navset_day *navset_day_at(const orr_navset *set, orr_time t)
{
    for (size_t k = 0; k + 1 < set->n_days; k++)
        if (t < set->day[k].to) return &set->day[k];
    return &set->day[set->n_days - 1];
}
