// SPDX-License-Identifier: GPL-3.0-or-later
// The sub-frames of Galileo: fifteen pages of I/NAV in 30 s, five of F/NAV in 50 s (Galileo OS SIS ICD 2.1, 4.2.3, 4.3.3 and
// 4.3.4).
#include <string.h>

#include "orbit/navdata/galileo_bits.h"
#include "orbit/navdata/navframe_private.h"

#define INAV_PAGES 15
#define FNAV_PAGES 5
#define SATELLITES 36

// What all pages of a sub-frame tell.
static void begin(const orr_navset *set, const orr_navset_item *item, const navset_day *day, orr_time t,
                  int64_t triple, orr_galileo_page *g)
{
    const navset_almanacs *a = &day->galileo;
    memset(g, 0, sizeof *g);
    g->eph = &item->eph;
    g->utc =
        orr_nav_utc_at(t, orr_floor_div(day->noon, 3600 * ORR_NS_PER_S) * 3600 * ORR_NS_PER_S, set->leap);
    memcpy(g->ai, set->nequick, sizeof g->ai);
    g->almanac_week = a->week;
    g->toa_s = a->toa_s;
    g->iod_a = (int)orr_floor_mod(orr_floor_div(a->toa, ORR_S_PER_DAY * ORR_NS_PER_S), 16);
    for (int k = 0; k < 3; k++) {
        const int number = (int)orr_floor_mod(triple, SATELLITES / 3) * 3 + k + 1;
        if (a->has[number]) g->almanac[k] = &a->sat[number];
    }
}

// A page into the frame: bits, or the symbols made of them.
static orr_status add(const orr_page *page, void (*code)(const orr_page *, orr_page *), bool coded,
                      orr_time t, int64_t length, int type, int64_t sub_frame, orr_navframe *out)
{
    orr_page symbols;
    if (coded) code(page, &symbols);
    return navframe_add(coded ? &symbols : page, t, length, type, (int)sub_frame, out);
}

// The words of a sub-frame. Almanacs come in two halves, in sub-frames that follow each other; so do the four words of
// Reed-Solomon.
static int inav_type(bool e5b, int page, bool odd)
{
    static const uint8_t e1[INAV_PAGES] = {2, 4, 6, 7, 8, 17, 19, 16, 0, 0, 1, 3, 5, 0, 16},
                         e5[INAV_PAGES] = {1, 3, 5, 7, 8, 0, 0, 0, 0, 0, 2, 4, 6, 0, 0};
    const int type = e5b ? e5[page] : e1[page];
    if (!odd) return type;
    return type == 7 || type == 8 ? type + 2 : type == 17 || type == 19 ? type + 1 : type;
}

orr_status navframe_inav(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream, orr_time t,
                         bool coded, orr_navframe *out, orr_diag *diag)
{
    const bool e5b = strcmp(stream->signals, "E5b") == 0;
    const int64_t length = 2 * ORR_NS_PER_S, all = INAV_PAGES * length;
    const orr_time late = e5b ? 0 : ORR_NS_PER_S; // E1-B begins a second after E5b-I
    const int64_t number = orr_floor_div(t - late, all);
    const orr_time from = number * all + late;
    const orr_navset_item *item = navframe_item(set, sat, stream, from - late, t);
    if (item == NULL) return ORR_E_NODATA;
    orr_galileo_page g;
    begin(set, item, navset_day_at(set, from), from, orr_floor_div(number, 2), &g);
    out->from = from, out->to = from + all;
    for (int k = 0; k < INAV_PAGES; k++) {
        orr_page word = {.diag = diag}, page;
        const int type = inav_type(e5b, k, orr_floor_mod(number, 2) != 0);
        g.t = from + k * length;
        orr_inav_word(&g, type, &word);
        if (word.status != ORR_OK) return word.status;
        orr_inav_page(&word, e5b ? 0 : k % 3 + 1, &page);
        const orr_status s =
            add(&page, orr_inav_symbols, coded, g.t, length, type, orr_floor_mod(number, 24) + 1, out);
        if (s != ORR_OK) return s;
    }
    return ORR_OK;
}

orr_status navframe_fnav(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream, orr_time t,
                         bool coded, orr_navframe *out, orr_diag *diag)
{
    const int64_t length = 10 * ORR_NS_PER_S, all = FNAV_PAGES * length;
    const int64_t number = orr_floor_div(t, all); // 12096 to a week
    const orr_time from = number * all;
    const orr_navset_item *item = navframe_item(set, sat, stream, from, t);
    if (item == NULL) return ORR_E_NODATA;
    orr_galileo_page g;
    begin(set, item, navset_day_at(set, from), from, orr_floor_div(number, 2), &g);
    out->from = from, out->to = from + all;
    for (int k = 0; k < FNAV_PAGES; k++) {
        orr_page page = {.diag = diag};
        const int type = k < 4 ? k + 1 : 5 + (int)orr_floor_mod(number, 2);
        g.t = from + k * length;
        orr_fnav_page(&g, type, &page);
        if (page.status != ORR_OK) return page.status;
        const orr_status s =
            add(&page, orr_fnav_symbols, coded, g.t, length, type, orr_floor_mod(number, 12) + 1, out);
        if (s != ORR_OK) return s;
    }
    return ORR_OK;
}
