// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/navic_bits.h"

#include "orbit/navdata/kepler_lattice.h"
#include "orbit/navdata/modern_blocks.h"
#include "orbit/navdata/system_week.h"

#define SYNC 0xeb90
#define DATA 262 // bits ahead of the CRC
#define CRC 24
#define ROWS 8
#define COLUMNS 73
#define TAIL 6

static const orr_navfit_field tgd = ORR_SIGNED("TGD", P2(31), 8);

static double seconds_of(orr_sat sat, orr_time t)
{
    return (double)(orr_nav_seconds_of_week(sat, t, NULL) / ORR_NS_PER_S);
}

// Tables 10 and 12.
static void subframe_1(const orr_navic_subframe *d, orr_page *p)
{
    static const uint8_t list[] = {ORR_KEPLER_CUC, ORR_KEPLER_CUS, ORR_KEPLER_CIC, ORR_KEPLER_CIS,
                                   ORR_KEPLER_CRC, ORR_KEPLER_CRS, ORR_KEPLER_IDOT},
                         delta_n = ORR_KEPLER_DELTA_N;
    const orr_nav_eph *e = d->eph;
    const orr_kepler_lattice *l = orr_kepler_lattice_of(e->sat, e->message);
    int32_t week;
    orr_nav_seconds_of_week(e->sat, d->t, &week);
    orr_page_put(p, 10, (uint64_t)week); // NavIC's weeks began with GPS' second 1024
    orr_modern_polynomial(e, p);
    orr_page_put(p, 4, (uint64_t)orr_nav_ura_index(e->accuracy_m));
    orr_page_value(p, &l->toc, seconds_of(e->sat, e->toc));
    orr_page_value(p, &tgd, e->delay.tgd_s);
    orr_kepler_put(p, e, &delta_n, 1);
    orr_page_put(p, 8, (uint64_t)e->iode);
    orr_page_zeros(p, 10);
    orr_page_put(p, 2, e->health != 0 ? 3 : 0); // flags of L5 and S
    orr_kepler_put(p, e, list, sizeof list);
}

static void subframe_2(const orr_navic_subframe *d, orr_page *p)
{
    static const uint8_t list[] = {ORR_KEPLER_EX, ORR_KEPLER_SQRT_A,    ORR_KEPLER_OMEGA0,
                                   ORR_KEPLER_EY, ORR_KEPLER_OMEGA_DOT, ORR_KEPLER_I0},
                         m0 = ORR_KEPLER_LAMBDA;
    const orr_nav_eph *e = d->eph;
    orr_kepler_put(p, e, &m0, 1);
    orr_page_value(p, &orr_kepler_lattice_of(e->sat, e->message)->toe, e->kepler.toe_sow_s);
    orr_kepler_put(p, e, list, sizeof list);
}

// Message 7 (table 20).
static void put_almanac(const orr_navic_subframe *d, orr_page *p)
{
    const orr_almanac *a = d->almanac;
    const orr_almanac_lattice *l = orr_almanac_lattice_of(d->eph->sat);
    static const uint8_t rest[] = {ORR_ALMANAC_DELTA_I, ORR_ALMANAC_OMEGA_DOT, ORR_ALMANAC_SQRT_A,
                                   ORR_ALMANAC_OMEGA0,  ORR_ALMANAC_OMEGA,     ORR_ALMANAC_M0,
                                   ORR_ALMANAC_AF0,     ORR_ALMANAC_AF1};
    double value[ORR_ALMANAC_PARTS];
    orr_almanac_values(a, value);
    orr_page_put(p, 10, (uint64_t)d->almanac_week);
    orr_page_value(p, orr_almanac_field(l, ORR_ALMANAC_E), a->e);
    orr_page_put(p, 16, (uint64_t)(a->toa_s / orr_almanac_toa_step_s(l)));
    for (size_t k = 0; k < sizeof rest; k++) orr_page_value(p, orr_almanac_field(l, rest[k]), value[rest[k]]);
    orr_page_put(p, 6, (uint64_t)a->number);
}

// Message 9 (table 21). The offset to GPS (GNSS 0) is zero: both are the product's time.
static void put_utc(const orr_navic_subframe *d, orr_page *p)
{
    const orr_nav_utc *u = &d->utc;
    int32_t week;
    const int64_t ns = orr_nav_seconds_of_week(d->eph->sat, u->reference, &week);
    orr_modern_utc(u, d->eph->sat, p);
    orr_modern_no_offset(p);
    orr_page_put(p, 16, (uint64_t)(ns / ORR_NS_PER_S / 16));
    orr_page_put(p, 10, (uint64_t)week);
    orr_page_zeros(p, 3);
}

// Message 11 (table 23): 138 bits of the Earth's orientation, zeros, and the ionosphere's coefficients.
static void put_ionosphere(const orr_navic_subframe *d, orr_page *p)
{
    orr_page_zeros(p, 16 + 21 + 15 + 21 + 15 + 31 + 19);
    orr_page_klobuchar(p, d->alpha, d->beta);
}

static void paged(const orr_navic_subframe *d, orr_navic_message message, orr_page *p)
{
    orr_page_put(p, 6, (uint64_t)message);
    switch (message) {
    case ORR_NAVIC_ALMANAC:
        put_almanac(d, p);
        break;
    case ORR_NAVIC_UTC:
        put_utc(d, p);
        break;
    case ORR_NAVIC_IONOSPHERE:
        put_ionosphere(d, p);
        break;
    case ORR_NAVIC_NULL:
        break;
    }
    orr_page_zeros(p, DATA - 6 - (int)p->n);
    orr_page_put(p, 6, (uint64_t)orr_sat_number(d->eph->sat));
}

void orr_navic_subframe_bits(const orr_navic_subframe *d, int subframe, orr_navic_message message,
                             orr_page *p)
{
    orr_page_begin(p, p->diag);
    orr_page_zeros(p, 8); // TLM
    orr_page_put(p, 17,
                 (uint64_t)(orr_nav_seconds_of_week(d->eph->sat, d->next, NULL) / (12 * ORR_NS_PER_S)));
    orr_page_zeros(p, 2); // alert, autonav
    orr_page_put(p, 2, (uint64_t)(subframe - 1));
    orr_page_zeros(p, 1);
    if (subframe == 1)
        subframe_1(d, p);
    else if (subframe == 2)
        subframe_2(d, p);
    else
        paged(d, message, p);
    orr_page_seal(p, 0, DATA + CRC);
    orr_page_zeros(p, TAIL);
}

void orr_navic_symbols(const orr_page *bits, orr_page *symbols)
{
    unsigned state = 0;
    orr_page_begin(symbols, bits->diag);
    orr_page_put(symbols, 16, SYNC);
    orr_page_convolve(symbols, bits, 0, false, &state);
    orr_page_interleave(symbols, ROWS, COLUMNS);
}
