// SPDX-License-Identifier: GPL-3.0-or-later
// CNAV in fours: ephemeris (10, 11), clock with group delays and ionosphere (30), and by turns UTC (33), the offset to Galileo (35), midi
// (37) and reduced almanacs (12), the Earth's rotation (32), none of them rarer than IS-GPS-200N table 30-XII allows. On L2C a message
// takes 12 s, on L5 6 s.
#include <string.h>

#include "orbit/navdata/cnav_bits.h"
#include "orbit/navdata/navframe_private.h"

#define MESSAGES 4
#define TURN 12 // fours until the fourth message comes round

static const uint8_t fourth[TURN] = {33, 37, 35, 12, 37, 12, 33, 37, 35, 12, 32, 12};
// Of QZSS, whose almanacs are in LNAV alone.
static const uint8_t fourth_alone[TURN] = {33, 35, 32, 33, 35, 32, 33, 35, 32, 33, 35, 32};

// How many messages of a type GPS has sent as the fourth of a four before this one.
static int64_t sent_before(int type, int64_t four)
{
    const int64_t turn = orr_floor_mod(four, TURN);
    int64_t in_turn = 0, in_all = 0;
    for (int64_t k = 0; k < TURN; k++) {
        if (fourth[k] != type) continue;
        in_all++;
        if (k < turn) in_turn++;
    }
    return orr_floor_div(four, TURN) * in_all + in_turn;
}

typedef struct sender {
    const orr_navset *set;
    orr_sat sat;
    const orr_nav_stream *stream;
    int64_t length; // of a message
} sender;

// The n-th message since 1980 by the set of its four; the type is returned, 0 where there is no set.
static int message_of(const sender *s, const orr_navset_item *item, int64_t n, orr_page *page)
{
    const int64_t four = orr_floor_div(n, MESSAGES), place = orr_floor_mod(n, MESSAGES);
    const orr_time t = n * s->length;
    const navset_day *day = navset_day_at(s->set, t);
    const bool gps = orr_sat_system(s->sat) == 'G' && navset_almanacs_known(&day->gps) > 0;
    const int last = (gps ? fourth : fourth_alone)[orr_floor_mod(four, TURN)];
    const int type = place < 2 ? 10 + (int)place : place == 2 ? 30 : last;
    orr_cnav_message c = {
        .eph = &item->eph,
        .next = t + s->length,
        .utc =
            orr_nav_utc_at(t, orr_floor_div(day->noon, 16 * ORR_NS_PER_S) * 16 * ORR_NS_PER_S, s->set->leap),
        .rotation = day->rotation};
    if (gps)
        navframe_almanacs(&day->gps, sent_before(37, four), sent_before(12, four), ORR_CNAV_REDUCED_ALMANACS,
                          &c.almanacs);
    memcpy(c.alpha, s->set->alpha, sizeof c.alpha);
    memcpy(c.beta, s->set->beta, sizeof c.beta);
    orr_cnav_message_bits(&c, type, page);
    return type;
}

orr_status navframe_cnav(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream, orr_time t,
                         bool coded, orr_navframe *out, orr_diag *diag)
{
    const sender s = {.set = set,
                      .sat = sat,
                      .stream = stream,
                      .length = (strcmp(stream->signals, "L2C") == 0 ? 12 : 6) * ORR_NS_PER_S};
    const int64_t all = MESSAGES * s.length, first = orr_floor_div(t, all) * MESSAGES;
    const orr_time from = first * s.length;
    const orr_navset_item *item = navframe_item(set, sat, stream, from, t),
                          *before = navframe_item(set, sat, stream, from - all, from - 1);
    if (item == NULL) return ORR_E_NODATA;
    out->from = from, out->to = from + all;
    unsigned state = 0; // the encoder runs on from message to message (IS-GPS-200N 3.3.3.1.1)
    orr_page page;
    if (coded && before != NULL) {
        page.diag = diag;
        message_of(&s, before, first - 1, &page);
        state = orr_page_tail(&page);
    }
    for (int k = 0; k < MESSAGES; k++) {
        page.diag = diag;
        const int type = message_of(&s, item, first + k, &page);
        if (page.status != ORR_OK) return page.status;
        orr_page symbols;
        orr_page_begin(&symbols, diag);
        if (coded) orr_page_convolve(&symbols, &page, 0, false, &state);
        const orr_status status =
            navframe_add(coded ? &symbols : &page, from + k * s.length, s.length, type, 0, out);
        if (status != ORR_OK) return status;
    }
    return ORR_OK;
}
