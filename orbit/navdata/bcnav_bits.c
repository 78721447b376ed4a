// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/bcnav_bits.h"

#include "orbit/navdata/ldpc.h"
#include "orbit/navdata/system_week.h"

#define HEAD1 14 // bits of B-CNAV1's subframe 1
#define SUBFRAME2 600
#define SUBFRAME3 264
#define ROWS 36 // of B-CNAV1's interleaver
#define COLUMNS 48
#define PREAMBLE2 0xe24de8u
#define PREAMBLE3 0xeb90u
#define MESSAGE2 288
#define MESSAGE3 486

const orr_navfit_field orr_bcnav_bdgim[9] = {
    ORR_UNSIGNED("alpha1", 0.125, 10), ORR_SIGNED("alpha2", 0.125, 8),    ORR_UNSIGNED("alpha3", 0.125, 8),
    ORR_UNSIGNED("alpha4", 0.125, 8),  ORR_UNSIGNED("alpha5", -0.125, 8), ORR_SIGNED("alpha6", 0.125, 8),
    ORR_SIGNED("alpha7", 0.125, 8),    ORR_SIGNED("alpha8", 0.125, 8),    ORR_SIGNED("alpha9", 0.125, 8)};
static const orr_navfit_field group_delay = ORR_SIGNED("TGD", P2(34), 12);

static void put_delay(double delay_s, orr_page *p) { orr_page_value(p, &group_delay, delay_s); }

static int64_t second_of(const orr_bcnav_message *b, int32_t *week)
{
    return orr_nav_seconds_of_week(b->eph->sat, b->t, week) / ORR_NS_PER_S;
}

// --- Blocks ---

// toe, type of orbit and the first half of the elements.
static void put_ephemeris_1(const orr_nav_eph *e, orr_page *p)
{
    orr_modern_toe(e, p);
    orr_page_put(p, 2, (uint64_t)orr_modern_orbit_type(e->sat));
    orr_modern_elements_1(e, p);
}

static void put_health(const orr_nav_eph *e, orr_page *p) { orr_page_put(p, 2, e->health != 0); }

// DIF, SIF and AIF of a signal: set when it is not to be used.
static void put_integrity(const orr_nav_eph *e, orr_page *p) { orr_page_put(p, 3, e->health != 0 ? 7 : 0); }

static void put_monitoring(const orr_nav_eph *e, orr_page *p) { orr_page_put(p, 4, (uint64_t)e->sismai); }

// Accuracy of the orbit across and along.
static void put_accuracy_oe(const orr_nav_eph *e, orr_page *p) { orr_page_put(p, 5, (uint64_t)e->sisai_oe); }

// Time of prediction, accuracy of radius and clock.
static void put_accuracy_oc(const orr_nav_eph *e, orr_page *p)
{
    orr_modern_top(e, p);
    orr_page_put(p, 5, (uint64_t)e->sisai_ocb);
    orr_page_put(p, 3, (uint64_t)e->sisai_oc1);
    orr_page_put(p, 3, (uint64_t)e->sisai_oc2);
}

static void put_issue_of_clock(const orr_nav_eph *e, orr_page *p) { orr_page_put(p, 10, (uint64_t)e->iodc); }

static void put_bdgim(const orr_bcnav_message *b, orr_page *p)
{
    for (int k = 0; k < 9; k++) orr_page_value(p, &orr_bcnav_bdgim[k], b->bdgim_tecu[k]);
}

static void put_rotation(const orr_bcnav_message *b, orr_page *p)
{
    orr_modern_pole_and_ut1(&b->rotation, b->eph->sat, p);
}

static void put_offset(const orr_bcnav_message *b, orr_page *p)
{
    int32_t week;
    const int64_t ns = orr_nav_seconds_of_week(b->eph->sat, b->utc.reference, &week);
    orr_page_put(p, 3, (uint64_t)b->offset_to);
    orr_page_put(p, 13, (uint64_t)week);
    orr_page_put(p, 16, (uint64_t)(ns / ORR_NS_PER_S / 16));
    orr_modern_no_offset(p);
}

// --- B-CNAV1 ---

static void subframe_2(const orr_bcnav_message *b, orr_page *p)
{
    const orr_nav_eph *e = b->eph;
    const size_t begin = p->n;
    int32_t week;
    const int64_t hour = second_of(b, &week) / 3600;
    orr_page_put(p, 13, (uint64_t)week);
    orr_page_put(p, 8, (uint64_t)hour);
    put_issue_of_clock(e, p);
    orr_page_put(p, 8, (uint64_t)e->iode);
    put_ephemeris_1(e, p);
    orr_modern_elements_2(e, p);
    orr_modern_clock(e, p);
    put_delay(e->delay.tgd_b2ap_s, p);
    put_delay(e->delay.isc_b1cd_s, p);
    put_delay(e->delay.tgd_b1cp_s, p);
    orr_page_seal(p, begin, SUBFRAME2);
}

static void subframe_3(const orr_bcnav_message *b, int page, orr_page *p)
{
    const orr_nav_eph *e = b->eph;
    const size_t begin = p->n;
    orr_page_put(p, 6, (uint64_t)page);
    put_health(e, p);
    put_integrity(e, p);
    put_monitoring(e, p);
    switch (page) {
    case ORR_BCNAV1_IONOSPHERE_AND_UTC:
        put_accuracy_oe(e, p);
        put_accuracy_oc(e, p);
        put_bdgim(b, p);
        orr_modern_utc(&b->utc, e->sat, p);
        break;
    case ORR_BCNAV1_REDUCED_ALMANACS:
        put_accuracy_oc(e, p);
        orr_modern_reduced(&b->almanacs, 4, ORR_MODERN_BCNAV, p);
        break;
    case ORR_BCNAV1_ROTATION_AND_OFFSET:
        put_accuracy_oe(e, p);
        put_rotation(b, p);
        put_offset(b, p);
        break;
    default:
        put_accuracy_oc(e, p);
        orr_modern_midi(&b->almanacs, ORR_MODERN_BCNAV, p);
        break;
    }
    orr_page_seal(p, begin, SUBFRAME3);
}

// Rows of 48: two of subframe 2 and one of subframe 3 by turns, the last three of subframe 2 (6.2.2.4).
static void interleave(const orr_page *second, const orr_page *third, orr_page *p)
{
    size_t at2 = 0, at3 = 0;
    for (int row = 0; row < ROWS; row++) {
        const bool of_third = row % 3 == 2 && at3 < third->n;
        orr_page_copy(p, of_third ? third : second, of_third ? at3 : at2, COLUMNS);
        *(of_third ? &at3 : &at2) += COLUMNS;
    }
    orr_page_interleave(p, COLUMNS, ROWS); // read column by column
}

void orr_bcnav1_frame_bits(const orr_bcnav_message *b, int page, bool coded, orr_page *p)
{
    const unsigned prn = (unsigned)orr_sat_number(b->eph->sat),
                   soh = (unsigned)(second_of(b, NULL) % 3600 / 18);
    orr_page in, second, third;
    orr_page_begin(&in, p->diag);
    orr_page_put(&in, 6, prn);
    orr_page_put(&in, 8, soh);
    subframe_2(b, &in);
    subframe_3(b, page, &in);
    orr_page_begin(p, p->diag);
    p->status = in.status;
    if (!coded) {
        orr_page_copy(p, &in, 0, in.n);
        return;
    }
    orr_page_register(p, 6, prn, ORR_BCH_21_6, 21);
    orr_page_register(p, 8, soh, ORR_BCH_51_8, 51);
    orr_page_begin(&second, NULL);
    orr_page_begin(&third, NULL);
    orr_ldpc_encode(ORR_LDPC_BCNAV1_SUBFRAME2, &in, HEAD1, &second);
    orr_ldpc_encode(ORR_LDPC_BCNAV1_SUBFRAME3, &in, HEAD1 + SUBFRAME2, &third);
    interleave(&second, &third, p);
}

// --- B-CNAV2 ---

// Integrity of B2a, monitoring, integrity of B1C: in every message.
static void put_status(const orr_nav_eph *e, orr_page *p)
{
    put_integrity(e, p);
    put_monitoring(e, p);
    put_integrity(e, p);
}

// Messages 30 to 34: clock, its issue, and what is behind.
static void message2_clock(const orr_bcnav_message *b, int type, orr_page *p)
{
    const orr_nav_eph *e = b->eph;
    if (type == ORR_BCNAV_CLOCK_AND_UTC) put_accuracy_oc(e, p);
    orr_modern_clock(e, p);
    if (type != ORR_BCNAV_CLOCK_AND_OFFSET) put_issue_of_clock(e, p);
    switch (type) {
    case ORR_BCNAV_CLOCK_AND_IONOSPHERE:
        put_delay(e->delay.tgd_b2ap_s, p);
        put_delay(e->delay.isc_b2ad_s, p);
        put_bdgim(b, p);
        put_delay(e->delay.tgd_b1cp_s, p);
        break;
    case ORR_BCNAV_CLOCK_AND_REDUCED_ALMANACS:
        orr_modern_reduced(&b->almanacs, 3, ORR_MODERN_BCNAV, p);
        break;
    case ORR_BCNAV_CLOCK_AND_ROTATION:
        put_rotation(b, p);
        break;
    case ORR_BCNAV_CLOCK_AND_OFFSET: // the reduced almanac's reference comes behind the issue
        put_offset(b, p);
        orr_modern_reduced_one(b->almanacs.reduced[0], ORR_MODERN_BCNAV, p);
        put_issue_of_clock(e, p);
        orr_modern_reference(&b->almanacs, p);
        break;
    default:
        orr_modern_utc(&b->utc, e->sat, p);
        break;
    }
}

static void message2(const orr_bcnav_message *b, int type, orr_page *p)
{
    const orr_nav_eph *e = b->eph;
    const size_t begin = p->n;
    int32_t week;
    orr_page_put(p, 6, (uint64_t)orr_sat_number(e->sat));
    orr_page_put(p, 6, (uint64_t)type);
    orr_page_put(p, 18, (uint64_t)(second_of(b, &week) / 3));
    if (type == ORR_BCNAV_EPHEMERIS_1)
        orr_page_put(p, 13, (uint64_t)week);
    else
        put_health(e, p);
    put_status(e, p);
    if (type == ORR_BCNAV_EPHEMERIS_1) {
        orr_page_put(p, 8, (uint64_t)e->iode);
        put_ephemeris_1(e, p);
    } else if (type == ORR_BCNAV_EPHEMERIS_2)
        orr_modern_elements_2(e, p);
    else if (type == ORR_BCNAV_MIDI_ALMANAC) {
        put_accuracy_oe(e, p);
        put_accuracy_oc(e, p);
        orr_modern_midi(&b->almanacs, ORR_MODERN_BCNAV, p);
    } else
        message2_clock(b, type, p);
    orr_page_seal(p, begin, MESSAGE2);
}

// Bits that are not protected, then the message, protected or not.
static void send(orr_page *message, orr_ldpc code, size_t bits, bool coded, orr_page *p)
{
    if (message->status != ORR_OK) p->status = message->status;
    if (coded)
        orr_ldpc_encode(code, message, 0, p);
    else
        orr_page_copy(p, message, 0, bits);
}

void orr_bcnav2_message_bits(const orr_bcnav_message *b, int type, bool coded, orr_page *p)
{
    orr_page message;
    orr_page_begin(&message, p->diag);
    message2(b, type, &message);
    orr_page_begin(p, p->diag);
    orr_page_put(p, 24, PREAMBLE2);
    send(&message, ORR_LDPC_BCNAV2, MESSAGE2, coded, p);
}

// --- B-CNAV3 ---

static void message3(const orr_bcnav_message *b, int type, orr_page *p)
{
    const orr_nav_eph *e = b->eph;
    const size_t begin = p->n;
    int32_t week;
    orr_page_put(p, 6, (uint64_t)type);
    orr_page_put(p, 20, (uint64_t)second_of(b, &week));
    switch (type) {
    case ORR_BCNAV_EPHEMERIS_1:
        orr_page_zeros(p, 4);
        put_ephemeris_1(e, p);
        orr_modern_elements_2(e, p);
        put_integrity(e, p);
        put_monitoring(e, p);
        break;
    case ORR_BCNAV_CLOCK_AND_IONOSPHERE:
        orr_page_put(p, 13, (uint64_t)week);
        orr_page_zeros(p, 4);
        orr_modern_clock(e, p);
        put_delay(e->delay.tgd_s, p);
        put_bdgim(b, p);
        orr_modern_utc(&b->utc, e->sat, p);
        put_rotation(b, p);
        put_accuracy_oc(e, p);
        put_accuracy_oe(e, p);
        put_health(e, p);
        break;
    default:
        put_offset(b, p);
        orr_modern_midi(&b->almanacs, ORR_MODERN_BCNAV, p);
        orr_modern_reduced(&b->almanacs, 5, ORR_MODERN_BCNAV, p);
        break;
    }
    orr_page_seal(p, begin, MESSAGE3);
}

void orr_bcnav3_message_bits(const orr_bcnav_message *b, int type, bool coded, orr_page *p)
{
    orr_page message;
    orr_page_begin(&message, p->diag);
    message3(b, type, &message);
    orr_page_begin(p, p->diag);
    orr_page_put(p, 16, PREAMBLE3);
    orr_page_put(p, 6, (uint64_t)orr_sat_number(b->eph->sat));
    orr_page_zeros(p, 6);
    send(&message, ORR_LDPC_BCNAV3, MESSAGE3, coded, p);
}
