// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/beidou_bits.h"

#include "orbit/navdata/kepler_lattice.h"
#include "orbit/navdata/modern_blocks.h"
#include "orbit/navdata/system_week.h"

#define PREAMBLE 0x712 // 11100010010
#define BDT_LEAP_S 14  // GPS time - UTC when BDT began
#define INFORMATION 224

static const orr_navfit_field tgd = ORR_SIGNED("TGD", 1e-10, 10), a0 = ORR_SIGNED("A0UTC", P2(30), 32),
                              a1 = ORR_SIGNED("A1UTC", P2(50), 24);

// Health to TGD2, with which D1's subframe 1 and D2's first page begin.
static void put_clock_head(const orr_beidou_subframe *d, orr_page *p)
{
    const orr_nav_eph *e = d->eph;
    const orr_kepler_lattice *l = orr_kepler_lattice_of(e->sat, e->message);
    int32_t week;
    orr_nav_seconds_of_week(e->sat, d->t, &week);
    orr_page_put(p, 1, e->health != 0);
    orr_page_put(p, 5, (uint64_t)e->iodc);
    orr_page_put(p, 4, (uint64_t)orr_nav_ura_index(e->accuracy_m));
    orr_page_put(p, 13, (uint64_t)week);
    orr_page_value(p, &l->toc, (double)(orr_nav_seconds_of_week(e->sat, e->toc, NULL) / ORR_NS_PER_S));
    orr_page_value(p, &tgd, e->delay.tgd_s);
    orr_page_value(p, &tgd, e->delay.tgd2_s);
}

static void subframe_1(const orr_beidou_subframe *d, orr_page *p)
{
    const orr_nav_eph *e = d->eph;
    const orr_kepler_lattice *l = orr_kepler_lattice_of(e->sat, e->message);
    put_clock_head(d, p);
    orr_page_klobuchar(p, d->alpha, d->beta);
    orr_page_value(p, &l->clock[2], e->af2_sps2);
    orr_page_value(p, &l->clock[0], e->af0_s);
    orr_page_value(p, &l->clock[1], e->af1_sps);
    orr_page_put(p, 5, (uint64_t)e->iode);
}

// toe is divided over subframes 2 (two bits) and 3 (fifteen).
static uint64_t toe_of(const orr_nav_eph *e, orr_page *p)
{
    return orr_page_code(p, &orr_kepler_lattice_of(e->sat, e->message)->toe, e->kepler.toe_sow_s);
}

static void subframe_2(const orr_beidou_subframe *d, orr_page *p)
{
    static const uint8_t list[] = {ORR_KEPLER_DELTA_N, ORR_KEPLER_CUC, ORR_KEPLER_LAMBDA, ORR_KEPLER_EX,
                                   ORR_KEPLER_CUS,     ORR_KEPLER_CRC, ORR_KEPLER_CRS,    ORR_KEPLER_SQRT_A};
    orr_kepler_put(p, d->eph, list, sizeof list);
    orr_page_put(p, 2, toe_of(d->eph, p) >> 15);
}

static void subframe_3(const orr_beidou_subframe *d, orr_page *p)
{
    static const uint8_t list[] = {ORR_KEPLER_I0,   ORR_KEPLER_CIC,    ORR_KEPLER_OMEGA_DOT, ORR_KEPLER_CIS,
                                   ORR_KEPLER_IDOT, ORR_KEPLER_OMEGA0, ORR_KEPLER_EY};
    orr_page_put(p, 15, toe_of(d->eph, p));
    orr_kepler_put(p, d->eph, list, sizeof list);
    orr_page_zeros(p, 1);
}

enum { EXPANDED = 3 }; // AmID of pages that hold satellites 31 to 43

static void put_almanac(const orr_beidou_subframe *d, orr_page *p)
{
    static const orr_almanac_part first[] = {ORR_ALMANAC_SQRT_A, ORR_ALMANAC_AF1, ORR_ALMANAC_AF0,
                                             ORR_ALMANAC_OMEGA0, ORR_ALMANAC_E,   ORR_ALMANAC_DELTA_I},
                                  last[] = {ORR_ALMANAC_OMEGA_DOT, ORR_ALMANAC_OMEGA, ORR_ALMANAC_M0};
    const orr_almanac *a = d->almanac;
    const orr_almanac_lattice *l = orr_almanac_lattice_of(d->eph->sat);
    double value[ORR_ALMANAC_PARTS];
    orr_almanac_values(a, value);
    for (size_t k = 0; k < 6; k++) orr_page_value(p, orr_almanac_field(l, first[k]), value[first[k]]);
    orr_page_put(p, 8, d->toa_s / 4096);
    for (size_t k = 0; k < 3; k++) orr_page_value(p, orr_almanac_field(l, last[k]), value[last[k]]);
    orr_page_put(p, 2, a->number > 30 ? EXPANDED : 0);
}

static void put_health(const orr_beidou_subframe *d, int first, int last, orr_page *p)
{
    for (int k = first; k <= last; k++) orr_page_put(p, 9, d->health[k] != 0 ? 0x1ff : 0);
}

// Pages 7 to 10 and 24 of subframe 5.
static void put_tables(const orr_beidou_subframe *d, int page, orr_page *p)
{
    const orr_nav_utc *u = &d->utc;
    switch (page) {
    case 7:
        put_health(d, 1, 19, p);
        break;
    case 8:
        put_health(d, 20, 30, p);
        orr_page_put(p, 8, (uint64_t)d->almanac_week);
        orr_page_put(p, 8, d->toa_s / 4096);
        break;
    case 24:
        put_health(d, 31, 43, p);
        orr_page_put(p, 2, EXPANDED);
        break;
    case 10:
        orr_page_put(p, 8, (uint64_t)(u->leap_s - BDT_LEAP_S));
        orr_page_put(p, 8, (uint64_t)(u->leap_future_s - BDT_LEAP_S));
        orr_page_put(p, 8, (uint64_t)(u->week_lsf - ORR_BDT_WEEK_0));
        orr_page_value(p, &a0, u->a0_s);
        orr_page_value(p, &a1, u->a1_sps);
        orr_page_put(p, 8, (uint64_t)(u->day - 1)); // 0 is Sunday
        break;
    default: // 9: offsets to other systems, all zero
        break;
    }
}

static void paged(const orr_beidou_subframe *d, int subframe, int page, orr_page *p)
{
    orr_page_zeros(p, 1);
    orr_page_put(p, 7, (uint64_t)page);
    if (d->almanac != NULL)
        put_almanac(d, p);
    else if (subframe == 5)
        put_tables(d, page, p);
}

// 224 bits of information as ten words: the first 15 bits of word 1 bare, then blocks of eleven with four of parity, two blocks of
// a word bit by bit in turn (5.1.3).
static void protect(const orr_page *in, orr_page *p)
{
    orr_page_copy(p, in, 0, 15);
    unsigned block = 0;
    for (size_t k = 15; k < 26; k++) block = block << 1 | in->bit[k];
    orr_page_put(p, 15, block << 4 | orr_page_bch15(block));
    for (size_t at = 26; at < INFORMATION; at += 22) {
        unsigned half[2] = {0, 0};
        for (size_t k = 0; k < 22; k++) half[k / 11] = half[k / 11] << 1 | in->bit[at + k];
        for (int h = 0; h < 2; h++) half[h] = half[h] << 4 | orr_page_bch15(half[h]);
        for (int k = 14; k >= 0; k--) {
            orr_page_put(p, 1, half[0] >> k & 1u);
            orr_page_put(p, 1, half[1] >> k & 1u);
        }
    }
}

static void begin_subframe(const orr_beidou_subframe *d, int subframe, orr_page *in)
{
    orr_page_put(in, 11, PREAMBLE);
    orr_page_zeros(in, 4);
    orr_page_put(in, 3, (uint64_t)subframe);
    orr_page_put(in, 20, (uint64_t)(orr_nav_seconds_of_week(d->eph->sat, d->t, NULL) / ORR_NS_PER_S));
}

static void end_subframe(orr_page *in, orr_page *p)
{
    orr_page_zeros(in, (int)(INFORMATION - in->n));
    if (p->status == ORR_OK) p->status = in->status;
    protect(in, p);
}

void orr_d1_subframe_bits(const orr_beidou_subframe *d, int subframe, int page, orr_page *p)
{
    orr_page in;
    orr_page_begin(&in, p->diag);
    begin_subframe(d, subframe, &in);
    if (subframe == 1)
        subframe_1(d, &in);
    else if (subframe == 2)
        subframe_2(d, &in);
    else if (subframe == 3)
        subframe_3(d, &in);
    else
        paged(d, subframe, page, &in);
    orr_page_begin(p, p->diag);
    end_subframe(&in, p);
}

// The set's fields behind TGD2 and the ionosphere in the order of D2: pages 3 to 10 of subframe 1 cut them at these bits.
static const struct {
    uint8_t lead; // reserved bits between the page's number and the fields
    uint16_t from, n;
} d2_cut[8] = {{38, 0, 28},  {0, 28, 64},  {0, 92, 64},  {0, 156, 64},
               {0, 220, 64}, {0, 284, 66}, {0, 350, 64}, {0, 414, 19}};

static void d2_fields(const orr_beidou_subframe *d, orr_page *p)
{
    static const uint8_t first[] = {ORR_KEPLER_DELTA_N, ORR_KEPLER_CUC,    ORR_KEPLER_LAMBDA, ORR_KEPLER_CUS,
                                    ORR_KEPLER_EX,      ORR_KEPLER_SQRT_A, ORR_KEPLER_CIC,    ORR_KEPLER_CIS},
                         last[] = {ORR_KEPLER_I0,     ORR_KEPLER_CRC, ORR_KEPLER_CRS, ORR_KEPLER_OMEGA_DOT,
                                   ORR_KEPLER_OMEGA0, ORR_KEPLER_EY,  ORR_KEPLER_IDOT};
    const orr_nav_eph *e = d->eph;
    orr_modern_polynomial(e, p);
    orr_page_put(p, 5, (uint64_t)e->iode);
    orr_kepler_put(p, e, first, sizeof first);
    orr_page_put(p, 17, toe_of(e, p));
    orr_kepler_put(p, e, last, sizeof last);
}

static void d2_page(const orr_beidou_subframe *d, int page, orr_page *p)
{
    orr_page all;
    orr_page_put(p, 4, (uint64_t)page);
    if (page == 1) {
        put_clock_head(d, p);
    } else if (page == 2) {
        orr_page_klobuchar(p, d->alpha, d->beta);
    } else {
        orr_page_begin(&all, p->diag);
        d2_fields(d, &all);
        if (p->status == ORR_OK) p->status = all.status;
        orr_page_zeros(p, d2_cut[page - 3].lead);
        orr_page_copy(p, &all, d2_cut[page - 3].from, d2_cut[page - 3].n);
    }
}

// Subframe 5: D1's tables and almanacs under numbers of D2's own, and the ionospheric grid, of which no point is monitored: nine
// bits of delay and four of GIVEI, all ones (5.3.3.8).
static void d2_paged(const orr_beidou_subframe *d, int page, orr_page *p)
{
    const int of_d1 = page == 35    ? 7
                      : page == 36  ? 8
                      : page == 101 ? 9
                      : page == 102 ? 10
                      : page == 116 ? 24
                                    : 0;
    const bool grid = page <= 13 || (page >= 61 && page <= 73);
    orr_page_zeros(p, 1);
    orr_page_put(p, 7, (uint64_t)page);
    if (d->almanac != NULL)
        put_almanac(d, p);
    else if (grid)
        for (int k = 0; k < 13; k++) orr_page_put(p, 13, 0x1fff);
    else if (of_d1 != 0)
        put_tables(d, of_d1, p);
}

int orr_d2_almanac_of(int page)
{
    if (page >= 37 && page <= 60) return page - 36;
    if (page >= 95 && page <= 100) return page - 70;
    return page >= 103 && page <= 115 ? page - 72 : 0;
}

void orr_d2_frame_bits(const orr_beidou_subframe *d, int page1, int page5, orr_page *p)
{
    orr_page_begin(p, p->diag);
    for (int k = 1; k <= 5; k++) {
        orr_page in;
        orr_page_begin(&in, p->diag);
        begin_subframe(d, k, &in);
        if (k == 1)
            d2_page(d, page1, &in);
        else if (k == 5)
            d2_paged(d, page5, &in);
        else if (k == 2) { // integrity and differential corrections of no satellite
            orr_page_zeros(&in, 1);
            orr_page_put(&in, 4, (uint64_t)((page5 - 1) % 6 + 1));
        }
        end_subframe(&in, p);
    }
}
