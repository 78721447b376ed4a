// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of B-CNAV. B-CNAV1: one in 18 s. B-CNAV2: messages of 3 s, four of them a frame here: 10, 11, 30 and one of a cycle of 96 s,
// so that the two halves of the elements follow one another and every 12 s hold a whole set. B-CNAV3: messages of a second,
// 10, 30 and 40 five times over.
#include <string.h>

#include "orbit/navdata/bcnav_bits.h"
#include "orbit/navdata/navframe_private.h"
#include "orbit/navdata/system_week.h"

#define MESSAGES2 4
#define CYCLE2 8 // frames of B-CNAV2
#define MESSAGES3 15
#define OFFSETS 3 // systems that offsets are told to

// How many spans of that length since BDT began, at t.
static int64_t count_of(orr_time t, int64_t length)
{
    return orr_floor_div(t - ORR_BDT_BEHIND_GPS_NS, length);
}

// The frame of that length that holds t: its set, and what its messages tell beside.
static const orr_navset_item *begin_frame(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream,
                                          orr_time t, int64_t length, orr_navframe *out, orr_bcnav_message *b)
{
    out->from = count_of(t, length) * length + ORR_BDT_BEHIND_GPS_NS, out->to = out->from + length;
    const orr_navset_item *item = navframe_item(set, sat, stream, out->from, t);
    if (item == NULL) return NULL;
    const navset_day *day = navset_day_at(set, out->from);
    *b = (orr_bcnav_message){.eph = &item->eph,
                             .t = out->from,
                             .utc = orr_nav_utc_at(out->from, day->noon, set->leap),
                             .rotation = day->rotation};
    memcpy(b->bdgim_tecu, set->bdgim, sizeof b->bdgim_tecu);
    return item;
}

static void tell(const orr_navset *set, int64_t midi_turn, int64_t reduced_turn, size_t n,
                 orr_bcnav_message *b)
{
    navframe_almanacs(&navset_day_at(set, b->t)->beidou, midi_turn, reduced_turn, n, &b->almanacs);
}

// Pages of B-CNAV1: ionosphere and UTC every 72 s, a midi almanac in every second frame, by turns the Earth's rotation with an
// offset and reduced almanacs in the fourth.
orr_status navframe_bcnav1(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream, orr_time t,
                           bool coded, orr_navframe *out, orr_diag *diag)
{
    const int64_t length = 18 * ORR_NS_PER_S, n = count_of(t, length);
    orr_bcnav_message b;
    orr_page bits;
    if (begin_frame(set, sat, stream, t, length, out, &b) == NULL) return ORR_E_NODATA;
    const int page = n % 2 == 1   ? ORR_BCNAV1_MIDI_ALMANAC
                     : n % 4 == 0 ? ORR_BCNAV1_IONOSPHERE_AND_UTC
                     : n % 8 == 2 ? ORR_BCNAV1_ROTATION_AND_OFFSET
                                  : ORR_BCNAV1_REDUCED_ALMANACS;
    tell(set, n / 2, n / 8, 4, &b);
    b.offset_to = (int)(n / 8 % OFFSETS) + 1;
    bits.diag = diag;
    orr_bcnav1_frame_bits(&b, page, coded, &bits);
    return navframe_add(&bits, out->from, length, page, 0, out);
}

orr_status navframe_bcnav2(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream, orr_time t,
                           bool coded, orr_navframe *out, orr_diag *diag)
{
    static const uint8_t fourth[CYCLE2] = {
        ORR_BCNAV_CLOCK_AND_UTC,    ORR_BCNAV_MIDI_ALMANAC,       ORR_BCNAV_CLOCK_AND_REDUCED_ALMANACS,
        ORR_BCNAV_MIDI_ALMANAC,     ORR_BCNAV_CLOCK_AND_ROTATION, ORR_BCNAV_MIDI_ALMANAC,
        ORR_BCNAV_CLOCK_AND_OFFSET, ORR_BCNAV_MIDI_ALMANAC};
    const int64_t length = 3 * ORR_NS_PER_S, n = count_of(t, MESSAGES2 * length);
    orr_bcnav_message b;
    if (begin_frame(set, sat, stream, t, MESSAGES2 * length, out, &b) == NULL) return ORR_E_NODATA;
    const int types[MESSAGES2] = {ORR_BCNAV_EPHEMERIS_1, ORR_BCNAV_EPHEMERIS_2,
                                  ORR_BCNAV_CLOCK_AND_IONOSPHERE, fourth[n % CYCLE2]};
    tell(set, n / 2, n / CYCLE2, 3, &b);
    b.offset_to = (int)(n / CYCLE2 % OFFSETS) + 1;
    orr_status s = ORR_OK;
    for (int k = 0; k < MESSAGES2 && s == ORR_OK; k++) {
        orr_page bits;
        bits.diag = diag;
        b.t = out->from + k * length;
        orr_bcnav2_message_bits(&b, types[k], coded, &bits);
        s = navframe_add(&bits, b.t, length, types[k], 0, out);
    }
    return s;
}

orr_status navframe_bcnav3(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream, orr_time t,
                           bool coded, orr_navframe *out, orr_diag *diag)
{
    static const int types[] = {ORR_BCNAV_EPHEMERIS_1, ORR_BCNAV_CLOCK_AND_IONOSPHERE,
                                ORR_BCNAV_MIDI_ALMANAC};
    orr_bcnav_message b;
    if (begin_frame(set, sat, stream, t, MESSAGES3 * ORR_NS_PER_S, out, &b) == NULL) return ORR_E_NODATA;
    orr_status s = ORR_OK;
    for (int k = 0; k < MESSAGES3 && s == ORR_OK; k++) {
        orr_page bits;
        bits.diag = diag;
        b.t = out->from + k * ORR_NS_PER_S;
        const int64_t turn = count_of(b.t, 3 * ORR_NS_PER_S);
        tell(set, turn, turn, 5, &b);
        b.offset_to = (int)(turn % OFFSETS) + 1;
        orr_bcnav3_message_bits(&b, types[k % 3], coded, &bits);
        s = navframe_add(&bits, b.t, ORR_NS_PER_S, types[k % 3], 0, out);
    }
    return s;
}
