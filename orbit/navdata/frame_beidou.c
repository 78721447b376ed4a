// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of D1: five subframes in 30 s, 24 frames a superframe that begins with the week of BDT (BDS-SIS-ICD-B1I 3.0, 5.2.1); and
// of D2, ten of which take the same 30 s and hold one set: five subframes in 3 s, 120 frames a superframe (5.3.1).
#include <string.h>

#include "orbit/navdata/beidou_bits.h"
#include "orbit/navdata/navframe_private.h"
#include "orbit/navdata/system_week.h"

#define FRAME_NS (30 * ORR_NS_PER_S)
#define SUBFRAME_NS (6 * ORR_NS_PER_S)
#define PAGES 24
#define D2_NS (3 * ORR_NS_PER_S)
#define D2_FRAMES 10 // of a set
#define D2_PAGES 120

// Which satellite's almanac a page holds: 1 to 24 in subframe 4, 25 to 30 in pages 1 to 6 of subframe 5, 31 to 43 in its pages
// 11 to 23; 0 for none.
static int almanac_of(int subframe, int page)
{
    if (subframe == 4) return page;
    return page <= 6 ? 24 + page : page >= 11 && page <= 23 ? 20 + page : 0;
}

// What the subframes that begin at `from` tell.
static orr_beidou_subframe told(const orr_navset *set, const orr_navset_item *item, orr_time from)
{
    const navset_day *day = navset_day_at(set, from);
    const navset_almanacs *a = &day->beidou;
    orr_beidou_subframe d = {.eph = &item->eph,
                             .utc = orr_nav_utc_at(from, day->noon, set->leap),
                             .toa_s = a->toa_s,
                             .almanac_week = a->week,
                             .health = a->health};
    memcpy(d.alpha, set->beidou_alpha, sizeof d.alpha);
    memcpy(d.beta, set->beidou_beta, sizeof d.beta);
    return d;
}

static const orr_almanac *almanac_at(const orr_navset *set, orr_time t, int number)
{
    const navset_almanacs *a = &navset_day_at(set, t)->beidou;
    return a->has[number] ? &a->sat[number] : NULL;
}

orr_status navframe_d1(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream, orr_time t,
                       bool coded, orr_navframe *out, orr_diag *diag)
{
    (void)coded; // BCH and interleaving are part of the bits; the secondary code is the generator's
    const int64_t ns = orr_nav_seconds_of_week(sat, t, NULL);
    const orr_time from = t - ns % FRAME_NS;
    const orr_navset_item *item = navframe_item(set, sat, stream, from, t);
    if (item == NULL) return ORR_E_NODATA;
    const int page = (int)(ns / FRAME_NS % PAGES) + 1;
    orr_beidou_subframe d = told(set, item, from);
    out->from = from, out->to = from + FRAME_NS;
    for (int k = 1; k <= 5; k++) {
        orr_page bits;
        bits.diag = diag;
        d.t = from + (k - 1) * SUBFRAME_NS;
        d.almanac = almanac_at(set, from, k > 3 ? almanac_of(k, page) : 0);
        orr_d1_subframe_bits(&d, k, page, &bits);
        const orr_status s = navframe_add(&bits, d.t, SUBFRAME_NS, k, k > 3 ? page : 0, out);
        if (s != ORR_OK) return s;
    }
    return ORR_OK;
}

orr_status navframe_d2(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream, orr_time t,
                       bool coded, orr_navframe *out, orr_diag *diag)
{
    (void)coded; // as of D1, and there is no secondary code
    const int64_t ns = orr_nav_seconds_of_week(sat, t, NULL);
    const orr_time from = t - ns % FRAME_NS;
    const orr_navset_item *item = navframe_item(set, sat, stream, from, t);
    if (item == NULL) return ORR_E_NODATA;
    const int first = (int)(ns / FRAME_NS * D2_FRAMES % D2_PAGES);
    orr_beidou_subframe d = told(set, item, from);
    out->from = from, out->to = from + FRAME_NS;
    for (int k = 0; k < D2_FRAMES; k++) {
        orr_page bits;
        bits.diag = diag;
        d.t = from + k * D2_NS;
        d.almanac = almanac_at(set, from, orr_d2_almanac_of(first + k + 1));
        orr_d2_frame_bits(&d, k + 1, first + k + 1, &bits);
        const orr_status s = navframe_add(&bits, d.t, D2_NS, k + 1, first + k + 1, out);
        if (s != ORR_OK) return s;
    }
    return ORR_OK;
}
