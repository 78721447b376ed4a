// SPDX-License-Identifier: GPL-3.0-or-later
// A frame of fifteen GLONASS strings.
#include <string.h>

#include "orbit/navdata/glonass_bits.h"
#include "orbit/navdata/navframe_private.h"

#define FRAME_NS (30 * ORR_NS_PER_S)
#define STRING_NS (2 * ORR_NS_PER_S)
#define BITS_NS (17 * ORR_NS_PER_S / 10)
#define STRINGS 15

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

// What the modulator makes of a string: the relative code of its 85 bits times the meander, two symbols of 10 ms a bit, and the
// 30 of the time mark (GLONASS ICD L1/L2 edition 5.1, 3.3.2.2).
static void modulated(const orr_glonass_string *s, orr_page *symbols)
{
    unsigned relative = 0;
    orr_page_begin(symbols, NULL);
    for (int k = 0; k < 85; k++) {
        relative ^= (unsigned)s->data[k / 8] >> (7 - k % 8) & 1u;
        orr_page_put(symbols, 2, relative != 0 ? 1 : 2); // the meander begins with 1: 10 times 1 is 01
    }
    orr_page_put(symbols, 30, 0x3e375096); // 111110001101110101000010010110
}

orr_status navframe_glonass(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream, orr_time t,
                            bool coded, orr_navframe *out, orr_diag *diag)
{
    orr_time begin, end;
    utc_half_minute(t, set->leap, &begin, &end);
    const orr_navset_item *item = navframe_item(set, sat, stream, begin, t);
    if (item == NULL) return ORR_E_NODATA;
    const navset_day *day = navset_day_at(set, begin);
    const int frame = orr_glonass_frame(begin, set->leap);
    orr_glonass_immediate im;
    orr_glonass_immediate_of(&item->eph, begin, set->leap, &im);
    out->from = begin, out->to = end;
    out->n = STRINGS;
    for (int k = 1; k <= STRINGS; k++) {
        orr_navframe_piece *p = &out->piece[k - 1];
        orr_glonass_string s;
        orr_status status = glonass_string(day, item, &im, frame, k, &s, diag);
        if (status != ORR_OK) return status;
        *p = (orr_navframe_piece){.t = begin + (k - 1) * STRING_NS,
                                  .length = BITS_NS,
                                  .number = (uint8_t)k,
                                  .page = (uint8_t)frame};
        if (coded) {
            orr_page symbols;
            modulated(&s, &symbols);
            navframe_take(&symbols, p);
            p->length = STRING_NS;
        } else {
            p->bits = 85;
            memcpy(p->data, s.data, sizeof s.data);
        }
    }
    return ORR_OK;
}
