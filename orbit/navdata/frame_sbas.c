// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of SBAS, a second each, fifteen a frame. Every even second of six is one of fast corrections (2, 3, 4); the thirty odd
// seconds of a minute hold the ephemeris, the mask, what corrections age by, almanacs, the grid and its mask, service, integrity,
// long-term corrections of 32 satellites and fourteen blocks of the grid: all within the intervals of RTCA DO-229E table A-25.
#include <math.h>
#include <string.h>

#include "orbit/broadcast/broadcast.h"
#include "orbit/navdata/navframe_private.h"
#include "orbit/navdata/sbas_bits.h"

#define MESSAGES 15
#define FRAME_NS (MESSAGES * ORR_NS_PER_S)
#define MINUTE_NS (60 * ORR_NS_PER_S)
#define ALMANAC_STEP_NS (64 * ORR_NS_PER_S)
#define SATELLITES 99

typedef struct slot {
    uint8_t message, part;
} slot;

// What is sent at the k-th odd second of a minute.
static slot slot_of(int k)
{
    static const uint8_t first[8] = {ORR_SBAS_EPHEMERIS,   ORR_SBAS_MASK,     ORR_SBAS_FAST_AGING,
                                     ORR_SBAS_DEGRADATION, ORR_SBAS_ALMANAC,  ORR_SBAS_GRID_MASK,
                                     ORR_SBAS_SERVICE,     ORR_SBAS_INTEGRITY};
    if (k < 8) return (slot){first[k], 0};
    if (k < 16) return (slot){ORR_SBAS_LONG_TERM, (uint8_t)((k - 8) * ORR_SBAS_LONG_TERMS)};
    return (slot){ORR_SBAS_GRID, (uint8_t)(k - 16)};
}

// An unhealthy satellite sends "do not use" in the place of message 2 (A.4.4.1).
static slot message_at(const orr_nav_eph *eph, orr_time t)
{
    const int second = (int)(orr_floor_mod(t, MINUTE_NS) / ORR_NS_PER_S);
    if (second % 2 != 0) return slot_of(second / 2);
    if (second % 6 == 0 && eph->health != 0) return (slot){ORR_SBAS_DO_NOT_USE, 0};
    return (slot){(uint8_t)(ORR_SBAS_FAST_FIRST + second % 6 / 2), 0};
}

// The GPS satellites of the set, and which of their sets is on the air.
static void tell_corrected(const orr_navset *set, orr_time t, orr_sbas_told *d)
{
    for (int k = 0; k < ORR_SBAS_CORRECTED; k++) {
        const orr_sat sat = orr_sat_make('G', k + 1);
        const orr_navset_item *item = orr_navset_at(set, sat, ORR_NAV_LNAV, t), *list;
        d->corrected[k] = orr_navset_items(set, sat, ORR_NAV_LNAV, &list) > 0;
        d->healthy[k] = item != NULL && item->eph.health == 0;
        d->iode[k] = item != NULL ? (uint8_t)item->eph.iode : 0;
    }
}

// Three of the SBAS satellites that there are, by turns from minute to minute.
static void tell_almanacs(const orr_navset *set, orr_time t, orr_sbas_told *d)
{
    orr_sat there[SATELLITES];
    int n = 0;
    for (int k = 1; k <= SATELLITES; k++) {
        const orr_sat sat = orr_sat_make('S', k);
        if (orr_navset_at(set, sat, ORR_NAV_SBAS, t) != NULL) there[n++] = sat;
    }
    const int groups = (n + ORR_SBAS_ALMANACS - 1) / ORR_SBAS_ALMANACS;
    d->almanac_t0 = orr_floor_div(t, ALMANAC_STEP_NS) * ALMANAC_STEP_NS;
    for (int k = 0; k < ORR_SBAS_ALMANACS && groups > 0; k++) {
        const int place = (int)orr_floor_mod(orr_floor_div(t, MINUTE_NS), groups) * ORR_SBAS_ALMANACS + k;
        if (place >= n) break;
        const orr_navset_item *item = orr_navset_at(set, there[place], ORR_NAV_SBAS, t);
        orr_broadcast_state s;
        if (orr_broadcast_eval(&item->eph, d->almanac_t0, &s) != ORR_OK) continue;
        d->almanac[k] = (orr_sbas_almanac){there[place], item->eph.health == 0, s.pos_m, s.vel_mps};
    }
}

static uint8_t message_of(const orr_navset *set, const orr_navset_item *item, orr_time t, orr_page *page)
{
    const orr_nav_eph *eph = &item->eph;
    const slot s = message_at(eph, t);
    orr_sbas_told d = {
        .eph = eph, .t = t, .part = s.part, .longitude_rad = atan2(eph->geo.pos_m.y, eph->geo.pos_m.x)};
    tell_corrected(set, t, &d);
    if (s.message == ORR_SBAS_ALMANAC) tell_almanacs(set, t, &d);
    orr_sbas_message_bits(&d, (orr_sbas_message)s.message, page);
    return s.message;
}

orr_status navframe_sbas(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream, orr_time t,
                         bool coded, orr_navframe *out, orr_diag *diag)
{
    const orr_time from = orr_floor_div(t, FRAME_NS) * FRAME_NS;
    const orr_navset_item *item = navframe_item(set, sat, stream, from, t),
                          *before = navframe_item(set, sat, stream, from - FRAME_NS, from - 1);
    if (item == NULL) return ORR_E_NODATA;
    unsigned state = 0; // the encoder runs on from message to message (A.4.2)
    orr_page page;
    if (coded && before != NULL) {
        page.diag = diag;
        message_of(set, before, from - ORR_NS_PER_S, &page);
        state = orr_page_tail(&page);
    }
    out->from = from, out->to = from + FRAME_NS;
    for (int k = 0; k < MESSAGES; k++) {
        const orr_time begin = from + k * ORR_NS_PER_S;
        orr_page symbols;
        page.diag = diag;
        const uint8_t number = message_of(set, item, begin, &page);
        if (page.status != ORR_OK) return page.status;
        orr_page_begin(&symbols, diag);
        if (coded) orr_page_convolve(&symbols, &page, 0, false, &state);
        const orr_status s = navframe_add(coded ? &symbols : &page, begin, ORR_NS_PER_S, number, 0, out);
        if (s != ORR_OK) return s;
    }
    return ORR_OK;
}
