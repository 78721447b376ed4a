// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/navframe.h"

#include <string.h>

#include "orbit/navdata/glonass_bits.h"
#include "orbit/navdata/lnav_bits.h"
#include "orbit/navdata/navset_private.h"

#define FRAME_NS (30 * ORR_NS_PER_S)
#define SUBFRAME_NS (6 * ORR_NS_PER_S)
#define STRING_NS (2 * ORR_NS_PER_S)
#define PAGES 25

// The immediate data of a frame: those of its begin, or, in the first frame of a product that begins within
// it, of t.
static const orr_navset_item *item_of(const orr_navset *set, orr_sat sat, orr_time begin, orr_time t)
{
    const orr_navset_item *item = orr_navset_at(set, sat, begin);
    return item != NULL ? item : orr_navset_at(set, sat, t);
}

// --- LNAV ---

static void pack_subframe(const orr_lnav_subframe *s, orr_navframe_piece *p)
{
    p->bits = 300;
    memset(p->data, 0, sizeof p->data);
    for (int k = 0; k < 300; k++)
        if (s->word[k / 30] >> (29 - k % 30) & 1u) p->data[k / 8] |= (uint8_t)(0x80u >> (k % 8));
}

// IERS announces a leap second half a year ahead (Bulletin C, January and July), and only then can page 18
// tell of it: eight bits of WN_LSF reach 127 weeks.
#define ANNOUNCED_DAYS 184

// Leap seconds around t, as page 18 tells them: the one that is announced, or the last one
// (IS-GPS-200N 20.3.3.5.2.4).
static orr_lnav_utc utc_parameters(orr_time t, const navset_day *day, const orr_leap_table *leap)
{
    orr_lnav_utc utc = {
        .tot_s = day->toa_s, .week = day->week, .leap_s = orr_leap_tai_minus_utc(t, leap) - 19};
    int32_t mjd;
    double fraction;
    orr_time_mjd(t, ORR_SCALE_UTC, leap, &mjd, &fraction);
    size_t k = 0;
    while (k + 1 < leap->n && leap->entry[k + 1].mjd <= mjd + ANNOUNCED_DAYS) k++;
    utc.leap_future_s = leap->entry[k].tai_minus_utc_s - 19;
    const int32_t eve =
        leap->entry[k].mjd - 1 - 44244; // days since 1980-01-06 of the day at whose end it takes effect
    utc.week_lsf = (int32_t)orr_floor_div(eve, 7);
    utc.day = eve - 7 * utc.week_lsf + 1;
    return utc;
}

static orr_status spare_or_almanac(const navset_day *day, int number, const orr_lnav_how *how,
                                   orr_lnav_subframe *out, orr_diag *diag)
{
    int subframe, page;
    if (!day->has_lnav[number - 1]) return orr_lnav_encode_spare(number <= 24 ? 5 : 4, 0, how, out, diag);
    return orr_lnav_encode_almanac(&day->lnav[number - 1], how, &subframe, &page, out, diag);
}

// Table 20-V.
static orr_status subframe_4(const orr_navset *set, const navset_day *day, orr_time t, int page,
                             const orr_lnav_how *how, orr_lnav_subframe *out, orr_diag *diag)
{
    static const uint8_t identity[PAGES] = {57, 25, 26, 27, 28, 57, 29, 30, 31, 32, 57, 62, 52,
                                            53, 54, 57, 55, 56, 58, 59, 57, 60, 61, 62, 63};
    const uint8_t id = identity[page - 1];
    if (id <= 32) return spare_or_almanac(day, id, how, out, diag);
    if (page == 25) return orr_lnav_encode_page25(4, day->toa_s, day->week, day->lnav_health, how, out, diag);
    if (page != 18) return orr_lnav_encode_spare(4, id, how, out, diag);
    const orr_lnav_utc utc = utc_parameters(t, day, set->leap);
    return orr_lnav_encode_page18(set->alpha, set->beta, &utc, how, out, diag);
}

static orr_status subframe_5(const navset_day *day, int page, const orr_lnav_how *how, orr_lnav_subframe *out,
                             orr_diag *diag)
{
    if (page == 25) return orr_lnav_encode_page25(5, day->toa_s, day->week, day->lnav_health, how, out, diag);
    return spare_or_almanac(day, page, how, out, diag);
}

static orr_status lnav_frame(const orr_navset *set, orr_sat sat, orr_time t, orr_navframe *out,
                             orr_diag *diag)
{
    const orr_time begin = orr_floor_div(t, FRAME_NS) * FRAME_NS;
    const orr_navset_item *item = item_of(set, sat, begin, t);
    if (item == NULL) return ORR_E_NODATA;
    const navset_day *day = navset_day_at(set, begin);
    int32_t week;
    int64_t ns;
    orr_time_week(begin, &week, &ns);
    const int page = (int)(ns / FRAME_NS % PAGES) + 1;
    *out = (orr_navframe){.sat = sat, .message = ORR_NAV_LNAV, .from = begin, .to = begin + FRAME_NS, .n = 5};
    for (int k = 1; k <= 5; k++) {
        orr_navframe_piece *p = &out->piece[k - 1];
        // HOW tells the begin of the next subframe, and 0 for the next week's.
        const orr_lnav_how how = {.tow_count = (uint32_t)((ns / SUBFRAME_NS + k) % 100800), .week = week};
        orr_lnav_subframe s;
        orr_status status = k <= 3   ? orr_lnav_encode_ephemeris(&item->eph, k, &how, &s, diag)
                            : k == 4 ? subframe_4(set, day, begin, page, &how, &s, diag)
                                     : subframe_5(day, page, &how, &s, diag);
        if (status != ORR_OK) return status;
        *p = (orr_navframe_piece){.t = begin + (k - 1) * SUBFRAME_NS, .number = (uint8_t)k};
        if (k > 3) p->page = (uint8_t)page;
        pack_subframe(&s, p);
    }
    return ORR_OK;
}

// --- GLONASS ---

// Begin of the UTC half minute that holds t, and of the next one, 31 s later where a leap second is inserted.
static void utc_half_minute(orr_time t, const orr_leap_table *leap, orr_time *from, orr_time *to)
{
    orr_civil c;
    orr_time_to_civil(t, ORR_SCALE_UTC, leap, &c);
    const int into = c.second >= 30 ? c.second - 30 : c.second; // 23:59:60 is 30 s into the second half
    *from = t - into * ORR_NS_PER_S - c.ns;
    *to = *from + FRAME_NS;
    orr_time_to_civil(*to, ORR_SCALE_UTC, leap, &c);
    if (c.second == 60) *to += ORR_NS_PER_S;
}

// KP: the leap second at the end of the quarter that holds t.
static int leap_of_quarter(orr_time t, const orr_leap_table *leap)
{
    int32_t mjd;
    double fraction;
    int year, month, day, y, m, d;
    orr_time_mjd(t, ORR_SCALE_UTC, leap, &mjd, &fraction);
    orr_date_from_mjd(mjd, &year, &month, &day);
    for (size_t k = 1; k < leap->n; k++) {
        if (leap->entry[k].mjd <= mjd) continue;
        orr_date_from_mjd(leap->entry[k].mjd - 1, &y, &m, &d);
        if (y == year && (m - 1) / 3 == (month - 1) / 3)
            return leap->entry[k].tai_minus_utc_s - leap->entry[k - 1].tai_minus_utc_s;
    }
    return 0;
}

static orr_status glonass_string(const navset_day *day, const orr_navset_item *item,
                                 const orr_glonass_immediate *im, int frame, int string,
                                 orr_glonass_string *out, orr_diag *diag)
{
    if (string <= 4) return orr_glonass_encode_immediate(&item->eph, im, string, out, diag);
    if (string == 5) {
        const orr_glonass_time time = {
            .t_k = im->t_k, .almanac_day = day->glonass_day, .l_n = im->l_n, .leap = im->leap};
        return orr_glonass_encode_time(&time, out, diag);
    }
    const int slot = orr_glonass_almanac_slot(frame, string);
    if (slot == 0) {
        const orr_glonass_utc utc = {.kp = leap_of_quarter(im->t_k, im->leap)};
        return orr_glonass_encode_utc(&utc, string, im->l_n, out, diag);
    }
    const orr_glonass_almanac *almanac = day->has_glonass[slot - 1] ? &day->glonass[slot - 1] : NULL;
    return orr_glonass_encode_almanac(almanac, string, im->l_n, out, diag);
}

static orr_status glonass_frame(const orr_navset *set, orr_sat sat, orr_time t, orr_navframe *out,
                                orr_diag *diag)
{
    orr_time begin, end;
    utc_half_minute(t, set->leap, &begin, &end);
    const orr_navset_item *item = item_of(set, sat, begin, t);
    if (item == NULL) return ORR_E_NODATA;
    const navset_day *day = navset_day_at(set, begin);
    const int frame = orr_glonass_frame(begin, set->leap);
    orr_glonass_immediate im;
    orr_glonass_immediate_of(&item->eph, begin, set->leap, &im);
    *out = (orr_navframe){
        .sat = sat, .message = ORR_NAV_FDMA, .from = begin, .to = end, .n = ORR_NAVFRAME_PIECES};
    for (int k = 1; k <= ORR_NAVFRAME_PIECES; k++) {
        orr_navframe_piece *p = &out->piece[k - 1];
        orr_glonass_string s;
        orr_status status = glonass_string(day, item, &im, frame, k, &s, diag);
        if (status != ORR_OK) return status;
        *p = (orr_navframe_piece){
            .t = begin + (k - 1) * STRING_NS, .number = (uint8_t)k, .page = (uint8_t)frame, .bits = 85};
        memcpy(p->data, s.data, sizeof s.data);
    }
    return ORR_OK;
}

orr_status orr_navframe_at(const orr_navset *set, orr_sat sat, orr_time t, orr_navframe *out, orr_diag *diag)
{
    orr_diag why = {0};
    char name[ORR_SAT_TEXT];
    const bool glonass = orr_sat_system(sat) == 'R';
    orr_status s = glonass ? glonass_frame(set, sat, t, out, &why) : lnav_frame(set, sat, t, out, &why);
    if (s == ORR_OK) return s;
    return orr_diag_set(diag, s, "%s: %.400s", orr_sat_text(sat, name),
                        s == ORR_E_NODATA ? "it sends nothing at that instant" : why.text);
}
