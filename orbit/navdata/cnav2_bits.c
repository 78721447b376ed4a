// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/cnav2_bits.h"

#include "orbit/navdata/cnav_bits.h"
#include "orbit/navdata/ldpc.h"

#define FRAMES 400 // in the two hours that ITOW counts
#define TOI_BITS 9
#define SUBFRAME2 600
#define SUBFRAME3 274
#define ROWS 38 // of the interleaver
#define COLUMNS 46
#define QZSS_PRN 192 // J01 is PRN 193
#define NO_OFFSET 0  // of GNSS ID

static int64_t frame_of_week(const orr_cnav2_frame *c, int32_t *week)
{
    int64_t ns;
    orr_time_week(c->t, week, &ns);
    return ns / (ORR_CNAV2_FRAME_S * ORR_NS_PER_S);
}

// The frame that begins when this one ends, within two hours.
static unsigned toi_of(const orr_cnav2_frame *c)
{
    int32_t week;
    return (unsigned)((frame_of_week(c, &week) + 1) % FRAMES);
}

static void subframe_2(const orr_cnav2_frame *c, orr_page *p)
{
    const orr_nav_eph *e = c->eph;
    const size_t begin = p->n;
    int32_t week;
    const int64_t itow = frame_of_week(c, &week) / FRAMES;
    orr_page_put(p, 13, (uint64_t)week);
    orr_page_put(p, 8, (uint64_t)itow);
    orr_modern_top(e, p);
    orr_page_put(p, 1, e->health != 0);
    orr_page_put(p, 5, (uint64_t)(int64_t)e->ura_ed);
    orr_modern_toe(e, p);
    orr_modern_elements_1(e, p);
    orr_modern_elements_2(e, p);
    orr_page_put(p, 5, (uint64_t)(int64_t)e->ura_ned[0]);
    orr_page_put(p, 3, (uint64_t)e->ura_ned[1]);
    orr_page_put(p, 3, (uint64_t)e->ura_ned[2]);
    orr_modern_polynomial(e, p); // toc is toe
    orr_cnav_put_delay(e->delay.tgd_s, p);
    orr_cnav_put_delay(e->delay.isc_l1cp_s, p);
    orr_cnav_put_delay(e->delay.isc_l1cd_s, p);
    orr_page_put(p, 1, 0); // integrity status
    orr_cnav_put_week_of_prediction(e, p);
    orr_page_zeros(p, 2);
    orr_page_crc24q(p, begin);
}

static void page_1(const orr_cnav2_frame *c, orr_page *p)
{
    const orr_nav_delays *d = &c->eph->delay;
    orr_modern_utc(&c->utc, c->eph->sat, p);
    orr_page_klobuchar(p, c->alpha, c->beta);
    orr_cnav_put_delay(d->isc_l1ca_s, p);
    orr_cnav_put_delay(d->isc_l2c_s, p);
    orr_cnav_put_delay(d->isc_l5i5_s, p);
    orr_cnav_put_delay(d->isc_l5q5_s, p);
}

static void page_2(const orr_cnav2_frame *c, orr_page *p)
{
    int32_t week;
    int64_t ns;
    orr_time_week(c->utc.reference, &week, &ns);
    orr_page_put(p, 3, NO_OFFSET);
    orr_page_put(p, 16, (uint64_t)(ns / ORR_NS_PER_S / 16));
    orr_page_put(p, 13, (uint64_t)week);
    orr_modern_no_offset(p);
    orr_modern_pole_and_ut1(&c->rotation, c->eph->sat, p);
}

static void subframe_3(const orr_cnav2_frame *c, int page, orr_page *p)
{
    const size_t begin = p->n;
    const bool qzss = orr_sat_system(c->eph->sat) == 'J';
    orr_page_put(p, 8, (uint64_t)(orr_sat_number(c->eph->sat) + (qzss ? QZSS_PRN : 0)));
    orr_page_put(p, 6, (uint64_t)page);
    switch (page) {
    case ORR_CNAV2_UTC_AND_IONOSPHERE:
        page_1(c, p);
        break;
    case ORR_CNAV2_OFFSET_AND_ROTATION:
        page_2(c, p);
        break;
    case ORR_CNAV2_REDUCED_ALMANAC:
        orr_modern_reduced(&c->almanacs, ORR_CNAV2_REDUCED_ALMANACS, ORR_MODERN_CNAV2, p);
        break;
    default:
        orr_modern_midi(&c->almanacs, ORR_MODERN_CNAV2, p);
        break;
    }
    orr_page_seal(p, begin, SUBFRAME3);
}

// TOI's highest bit, then the other eight protected, and inverted where that bit is set (3.2.3.2).
static void protect_toi(unsigned toi, orr_page *p)
{
    const unsigned high = toi >> 8;
    orr_page_put(p, 1, high);
    const size_t begin = p->n;
    orr_page_register(p, 8, toi & 0xffu, ORR_BCH_51_8, 51);
    for (size_t k = begin; k < p->n; k++) p->bit[k] ^= (uint8_t)high;
}

void orr_cnav2_frame_bits(const orr_cnav2_frame *c, int page, bool coded, orr_page *p)
{
    orr_page in;
    orr_page_begin(&in, p->diag);
    orr_page_put(&in, TOI_BITS, toi_of(c));
    subframe_2(c, &in);
    subframe_3(c, page, &in);
    orr_page_begin(p, p->diag);
    p->status = in.status;
    if (!coded) {
        orr_page_copy(p, &in, 0, in.n);
        return;
    }
    protect_toi(toi_of(c), p);
    orr_ldpc_encode(ORR_LDPC_CNAV2_SUBFRAME2, &in, TOI_BITS, p);
    orr_ldpc_encode(ORR_LDPC_CNAV2_SUBFRAME3, &in, TOI_BITS + SUBFRAME2, p);
    orr_page_interleave(p, COLUMNS, ROWS); // written row by row, read column by column
}
