// SPDX-License-Identifier: GPL-3.0-or-later
// A frame of NavIC: four subframes of 12 s, from multiples of 48 s of the week on (IRNSS SIS ICD for SPS 1.1, 5.2). Subframe 3 holds the
// almanacs of the satellites that there are, by turns; subframe 4 UTC and the ionosphere.
#include <string.h>

#include "orbit/navdata/navframe_private.h"
#include "orbit/navdata/navic_bits.h"
#include "orbit/navdata/system_week.h"

#define SUBFRAMES 4
#define SUBFRAME_NS (12 * ORR_NS_PER_S)
#define FRAME_NS (SUBFRAMES * SUBFRAME_NS)
#define SATELLITES 14

static const orr_almanac *almanac_by_turns(const navset_almanacs *a, int64_t frame)
{
    int there[SATELLITES], n = 0;
    for (int k = 1; k <= SATELLITES; k++)
        if (a->has[k]) there[n++] = k;
    return n > 0 ? &a->sat[there[frame % n]] : NULL;
}

orr_status navframe_navic(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream, orr_time t,
                          bool coded, orr_navframe *out, orr_diag *diag)
{
    const int64_t ns = orr_nav_seconds_of_week(sat, t, NULL), frame = ns / FRAME_NS;
    const orr_time from = t - ns % FRAME_NS;
    const orr_navset_item *item = navframe_item(set, sat, stream, from, t);
    if (item == NULL) return ORR_E_NODATA;
    const navset_day *day = navset_day_at(set, from);
    orr_navic_subframe d = {.eph = &item->eph,
                            .utc = orr_nav_utc_at(from, day->navic.toa, set->leap),
                            .almanac = almanac_by_turns(&day->navic, frame),
                            .almanac_week = day->navic.week};
    memcpy(d.alpha, set->alpha, sizeof d.alpha);
    memcpy(d.beta, set->beta, sizeof d.beta);
    const orr_navic_message message[SUBFRAMES] = {
        [2] = d.almanac != NULL ? ORR_NAVIC_ALMANAC : ORR_NAVIC_NULL,
        [3] = frame % 2 == 0 ? ORR_NAVIC_UTC : ORR_NAVIC_IONOSPHERE};
    out->from = from, out->to = from + FRAME_NS;
    for (int k = 0; k < SUBFRAMES; k++) {
        orr_page bits, symbols;
        bits.diag = diag;
        d.t = from + k * SUBFRAME_NS;
        d.next = d.t + SUBFRAME_NS;
        orr_navic_subframe_bits(&d, k + 1, message[k], &bits);
        if (bits.status != ORR_OK) return bits.status;
        if (coded) orr_navic_symbols(&bits, &symbols);
        const orr_status s =
            navframe_add(coded ? &symbols : &bits, d.t, SUBFRAME_NS, k + 1, (int)message[k], out);
        if (s != ORR_OK) return s;
    }
    return ORR_OK;
}
