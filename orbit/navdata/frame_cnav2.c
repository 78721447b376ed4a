// SPDX-License-Identifier: GPL-3.0-or-later
// A frame of CNAV-2: subframes 1 to 3 in 18 s, subframe 3 with one page of a cycle of 144 s: UTC, ionosphere and ISC every 72 s,
// midi almanacs in every second frame, by turns the Earth's rotation and reduced almanacs in the fourth.
#include <string.h>

#include "orbit/navdata/cnav2_bits.h"
#include "orbit/navdata/navframe_private.h"

// Page of the n-th frame since 1980; QZSS tells no almanac.
static int page_of(int64_t n, bool almanacs)
{
    if (n % 4 == 0) return ORR_CNAV2_UTC_AND_IONOSPHERE;
    if (n % 4 == 2 && (n % 8 == 2 || !almanacs)) return ORR_CNAV2_OFFSET_AND_ROTATION;
    if (!almanacs) return ORR_CNAV2_UTC_AND_IONOSPHERE;
    return n % 4 == 2 ? ORR_CNAV2_REDUCED_ALMANAC : ORR_CNAV2_MIDI_ALMANAC;
}

orr_status navframe_cnav2(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream, orr_time t,
                          bool coded, orr_navframe *out, orr_diag *diag)
{
    const int64_t length = ORR_CNAV2_FRAME_S * ORR_NS_PER_S, n = orr_floor_div(t, length);
    const orr_time from = n * length;
    const orr_navset_item *item = navframe_item(set, sat, stream, from, t);
    if (item == NULL) return ORR_E_NODATA;
    const navset_day *day = navset_day_at(set, from);
    const bool gps = orr_sat_system(sat) == 'G';
    const int page = page_of(n, gps && navset_almanacs_known(&day->gps) > 0);
    orr_cnav2_frame c = {.eph = &item->eph,
                         .t = from,
                         .utc = orr_nav_utc_at(from, day->noon, set->leap),
                         .rotation = day->rotation};
    if (gps) navframe_almanacs(&day->gps, n / 2, n / 8, ORR_CNAV2_REDUCED_ALMANACS, &c.almanacs);
    memcpy(c.alpha, set->alpha, sizeof c.alpha);
    memcpy(c.beta, set->beta, sizeof c.beta);
    orr_page bits;
    bits.diag = diag;
    orr_cnav2_frame_bits(&c, page, coded, &bits);
    out->from = from, out->to = from + length;
    return navframe_add(&bits, from, length, page, 0, out);
}
