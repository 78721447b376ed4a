// SPDX-License-Identifier: GPL-3.0-or-later
// Five subframes of LNAV of GPS (IS-GPS-200N 20.3) and QZSS (IS-QZSS-PNT-005 4.1).
#include <string.h>

#include "orbit/navdata/lnav_bits.h"
#include "orbit/navdata/navframe_private.h"

#define FRAME_NS (30 * ORR_NS_PER_S)
#define SUBFRAME_NS (6 * ORR_NS_PER_S)
#define PAGES 25
#define QZSS_SATELLITES 10

static void pack_subframe(const orr_lnav_subframe *s, orr_navframe_piece *p)
{
    p->bits = 300;
    p->length = SUBFRAME_NS;
    for (int k = 0; k < 300; k++)
        if (s->word[k / 30] >> (29 - k % 30) & 1u) p->data[k / 8] |= (uint8_t)(0x80u >> (k % 8));
}

static orr_status spare_or_almanac(const navset_day *day, int number, const orr_lnav_how *how,
                                   orr_lnav_subframe *out, orr_diag *diag)
{
    int subframe, page;
    if (!day->gps.has[number]) return orr_lnav_encode_spare(number <= 24 ? 5 : 4, 0, how, out, diag);
    return orr_lnav_encode_almanac(&day->gps.sat[number], how, &subframe, &page, out, diag);
}

// "Bad data, satellite temporarily out", and "more than one thing is wrong" of satellites that are not there
// (IS-GPS-200N tables 20-VII and 20-VIII); all of QZSS' six bits.
static orr_status page_25(const navset_day *day, int subframe, const orr_lnav_how *how,
                          orr_lnav_subframe *out, orr_diag *diag)
{
    const uint8_t word[] = {
        [NAVSET_GOOD] = 0, [NAVSET_OUT] = how->qzss ? 0x3f : 0x3c, [NAVSET_NOT_THERE] = 0x3f};
    const navset_almanacs *a = how->qzss ? &day->qzss : &day->gps;
    uint8_t health[32];
    for (int k = 0; k < 32; k++) health[k] = word[a->health[k + 1]];
    return orr_lnav_encode_page25(subframe, a->toa_s, a->week, day->gps_configuration, health, how, out,
                                  diag);
}

static orr_status page_18(const orr_navset *set, const navset_day *day, orr_time t, const orr_lnav_how *how,
                          orr_lnav_subframe *out, orr_diag *diag)
{
    const orr_nav_utc utc = orr_nav_utc_at(t, day->gps.toa, set->leap);
    return orr_lnav_encode_page18(set->alpha, set->beta, &utc, how, out, diag);
}

// Table 20-V.
static orr_status subframe_4(const orr_navset *set, const navset_day *day, orr_time t, int page,
                             const orr_lnav_how *how, orr_lnav_subframe *out, orr_diag *diag)
{
    static const uint8_t identity[PAGES] = {57, 25, 26, 27, 28, 57, 29, 30, 31, 32, 57, 62, 52,
                                            53, 54, 57, 55, 56, 58, 59, 57, 60, 61, 62, 63};
    const uint8_t id = identity[page - 1];
    if (id <= 32) return spare_or_almanac(day, id, how, out, diag);
    if (page == 25) return page_25(day, 4, how, out, diag);
    return page == 18 ? page_18(set, day, t, how, out, diag) : orr_lnav_encode_spare(4, id, how, out, diag);
}

static orr_status subframe_5(const navset_day *day, int page, const orr_lnav_how *how, orr_lnav_subframe *out,
                             orr_diag *diag)
{
    if (page == 25) return page_25(day, 5, how, out, diag);
    return spare_or_almanac(day, page, how, out, diag);
}

// QZSS' pages have no numbers, and what is sent when is the system's choice: every fifth tells of health, the others hold the almanacs
// of the satellites that there are, by turns.
static orr_status qzss_subframe_5(const navset_day *day, int page, const orr_lnav_how *how,
                                  orr_lnav_subframe *out, orr_diag *diag)
{
    int there[QZSS_SATELLITES], n = 0, subframe, place;
    if (page % 5 == 0) return page_25(day, 5, how, out, diag);
    for (int k = 1; k <= QZSS_SATELLITES; k++)
        if (day->qzss.has[k]) there[n++] = k;
    if (n == 0) return orr_lnav_encode_spare(5, 0, how, out, diag);
    const orr_almanac *a = &day->qzss.sat[there[(page - 1 - page / 5) % n]];
    return orr_lnav_encode_almanac(a, how, &subframe, &place, out, diag);
}

orr_status navframe_lnav(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream, orr_time t,
                         bool coded, orr_navframe *out, orr_diag *diag)
{
    const orr_time begin = orr_floor_div(t, FRAME_NS) * FRAME_NS;
    const orr_navset_item *item = navframe_item(set, sat, stream, begin, t);
    if (item == NULL) return ORR_E_NODATA;
    const navset_day *day = navset_day_at(set, begin);
    int32_t week;
    int64_t ns;
    orr_time_week(begin, &week, &ns);
    const int page = (int)(ns / FRAME_NS % PAGES) + 1;
    const bool qzss = orr_sat_system(sat) == 'J';
    (void)coded; // parity is part of the message
    out->from = begin, out->to = begin + FRAME_NS;
    out->n = 5;
    for (int k = 1; k <= 5; k++) {
        orr_navframe_piece *p = &out->piece[k - 1];
        // HOW tells the begin of the next subframe, and 0 for the next week's.
        const orr_lnav_how how = {
            .tow_count = (uint32_t)((ns / SUBFRAME_NS + k) % 100800), .week = week, .qzss = qzss};
        orr_lnav_subframe s;
        orr_status status;
        if (k <= 3)
            status = orr_lnav_encode_ephemeris(&item->eph, k, &how, &s, diag);
        else if (qzss)
            status = k == 4 ? page_18(set, day, begin, &how, &s, diag)
                            : qzss_subframe_5(day, page, &how, &s, diag);
        else
            status = k == 4 ? subframe_4(set, day, begin, page, &how, &s, diag)
                            : subframe_5(day, page, &how, &s, diag);
        if (status != ORR_OK) return status;
        *p = (orr_navframe_piece){.t = begin + (k - 1) * SUBFRAME_NS, .number = (uint8_t)k};
        if (k > 3) p->page = (uint8_t)page;
        pack_subframe(&s, p);
    }
    return ORR_OK;
}
