// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/cnav_bits.h"

#define GALILEO 1 // of GNSS-ID in message 35

static const orr_navfit_field isc = ORR_SIGNED("ISC", P2(35), 13);

static uint64_t seconds_of_week(orr_time t, int32_t *week)
{
    int64_t ns;
    orr_time_week(t, week, &ns);
    return (uint64_t)(ns / ORR_NS_PER_S);
}

// Preamble, PRN (QZSS' own, 1 to 10, stand for 193 and on in six bits), type, TOW count, alert flag.
static void put_head(const orr_cnav_message *c, int type, orr_page *p)
{
    int32_t week;
    orr_page_put(p, 8, 0x8b);
    orr_page_put(p, 6, (uint64_t)orr_sat_number(c->eph->sat));
    orr_page_put(p, 6, (uint64_t)type);
    orr_page_put(p, 17, seconds_of_week(c->next, &week) / 6);
    orr_page_put(p, 1, 0);
}

static void message_10(const orr_cnav_message *c, orr_page *p)
{
    int32_t week;
    seconds_of_week(c->next - 1, &week); // of the message itself, the last before the next one's begin
    orr_page_put(p, 13, (uint64_t)week);
    orr_page_put(p, 3, c->eph->health != 0 ? 7 : 0); // L1, L2, L5
    orr_modern_top(c->eph, p);
    orr_page_put(p, 5, (uint64_t)(int64_t)c->eph->ura_ed);
    orr_modern_toe(c->eph, p);
    orr_modern_elements_1(c->eph, p);
    orr_page_zeros(p, 1 + 1 + 3); // integrity status, L2C phasing, reserved
}

static void message_11(const orr_cnav_message *c, orr_page *p)
{
    orr_modern_toe(c->eph, p);
    orr_modern_elements_2(c->eph, p);
    orr_page_zeros(p, 7);
}

// top, URA_NED, toc, af0, af1, af2: common to the messages from 30 on.
static void put_clock(const orr_nav_eph *e, orr_page *p)
{
    orr_modern_top(e, p);
    orr_page_put(p, 5, (uint64_t)(int64_t)e->ura_ned[0]);
    orr_page_put(p, 3, (uint64_t)e->ura_ned[1]);
    orr_page_put(p, 3, (uint64_t)e->ura_ned[2]);
    orr_modern_clock(e, p);
}

void orr_cnav_put_delay(double delay_s, orr_page *p) { orr_page_value(p, &isc, delay_s); }

void orr_cnav_put_week_of_prediction(const orr_nav_eph *e, orr_page *p)
{
    int32_t week;
    seconds_of_week(e->transmission, &week);
    orr_page_put(p, 8, (uint64_t)week);
}

static void message_30(const orr_cnav_message *c, orr_page *p)
{
    const orr_nav_delays *d = &c->eph->delay;
    const double delay[] = {d->tgd_s, d->isc_l1ca_s, d->isc_l2c_s, d->isc_l5i5_s, d->isc_l5q5_s};
    put_clock(c->eph, p);
    for (int k = 0; k < 5; k++) orr_cnav_put_delay(delay[k], p);
    orr_page_klobuchar(p, c->alpha, c->beta);
    orr_cnav_put_week_of_prediction(c->eph, p);
    orr_page_zeros(p, 12);
}

static void message_33(const orr_cnav_message *c, orr_page *p)
{
    put_clock(c->eph, p);
    orr_modern_utc(&c->utc, c->eph->sat, p);
    orr_page_zeros(p, 51);
}

static void message_35(const orr_cnav_message *c, orr_page *p)
{
    int32_t week;
    const uint64_t t = seconds_of_week(c->utc.reference, &week);
    put_clock(c->eph, p);
    orr_page_put(p, 16, t / 16);
    orr_page_put(p, 13, (uint64_t)week);
    orr_page_put(p, 3, GALILEO);
    orr_modern_no_offset(p);
    orr_page_zeros(p, 81);
}

void orr_cnav_message_bits(const orr_cnav_message *c, int type, orr_page *p)
{
    orr_page_begin(p, p->diag);
    put_head(c, type, p);
    switch (type) {
    case 10:
        message_10(c, p);
        break;
    case 11:
        message_11(c, p);
        break;
    case 30:
        message_30(c, p);
        break;
    case 33:
        message_33(c, p);
        break;
    case 12:
        orr_modern_reduced(&c->almanacs, ORR_CNAV_REDUCED_ALMANACS, ORR_MODERN_CNAV, p);
        break;
    case 32:
        put_clock(c->eph, p);
        orr_modern_pole_and_ut1(&c->rotation, c->eph->sat, p);
        orr_page_zeros(p, 11);
        break;
    case 37:
        put_clock(c->eph, p);
        orr_modern_midi(&c->almanacs, ORR_MODERN_CNAV, p);
        break;
    default:
        message_35(c, p);
        break;
    }
    orr_page_crc24q(p, 0);
}
