// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/modern_blocks.h"

#include "orbit/navdata/kepler_lattice.h"
#include "orbit/navdata/system_week.h"

#define BDT_LEAP_S 14 // GPS time - UTC when BDT began
#define ARCSECOND (ORR_RAD_PER_DEG / 3600)
#define DAY_S 86400.0

static const orr_navfit_field a0 = ORR_SIGNED("A0", P2(35), 16), a1 = ORR_SIGNED("A1", P2(51), 13),
                              pole = ORR_SIGNED("PM", ARCSECOND *P2(20), 21),
                              pole_rate = ORR_SIGNED("PM dot", ARCSECOND *P2(21) / DAY_S, 15),
                              ut1 = ORR_SIGNED("delta UT1", P2(24), 31),
                              ut1_rate = ORR_SIGNED("delta UT1 dot", P2(25), 19);

// IS-GPS-800J table 3.5-7, BDS-SIS-ICD-B1C 1.0, table 7-14; in the order of orr_almanac_part.
static const orr_navfit_field midi[] = {ORR_UNSIGNED("sqrt(A)", P2(4), 17),
                                        ORR_UNSIGNED("e", P2(16), 11),
                                        ORR_ANGLE("omega", 15, 16),
                                        ORR_ANGLE("M0", 15, 16),
                                        ORR_SIGNED("delta i", SEMICIRCLE *P2(14), 11),
                                        ORR_ANGLE("OMEGA0", 15, 16),
                                        ORR_SIGNED("OMEGADOT", SEMICIRCLE *P2(33), 11),
                                        ORR_SIGNED("af0", P2(20), 11),
                                        ORR_SIGNED("af1", P2(37), 10)};
// IS-GPS-800J table 3.5-6, BDS-SIS-ICD-B1C 1.0, table 7-16.
static const orr_navfit_field delta_a = ORR_SIGNED("delta A", 512, 8), omega0 = ORR_ANGLE("OMEGA0", 6, 7),
                              phi0 = ORR_ANGLE("PHI0", 6, 7);

void orr_modern_elements_1(const orr_nav_eph *e, orr_page *p)
{
    static const uint8_t list[] = {ORR_KEPLER_SQRT_A, ORR_KEPLER_A_DOT, ORR_KEPLER_DELTA_N, ORR_KEPLER_N_DOT,
                                   ORR_KEPLER_LAMBDA, ORR_KEPLER_EX,    ORR_KEPLER_EY};
    orr_kepler_put(p, e, list, sizeof list);
}

void orr_modern_elements_2(const orr_nav_eph *e, orr_page *p)
{
    static const uint8_t list[] = {ORR_KEPLER_OMEGA0, ORR_KEPLER_I0,  ORR_KEPLER_OMEGA_DOT, ORR_KEPLER_IDOT,
                                   ORR_KEPLER_CIS,    ORR_KEPLER_CIC, ORR_KEPLER_CRS,       ORR_KEPLER_CRC,
                                   ORR_KEPLER_CUS,    ORR_KEPLER_CUC};
    orr_kepler_put(p, e, list, sizeof list);
}

void orr_modern_toe(const orr_nav_eph *e, orr_page *p)
{
    orr_page_value(p, &orr_kepler_lattice_of(e->sat, e->message)->toe, e->kepler.toe_sow_s);
}

void orr_modern_polynomial(const orr_nav_eph *e, orr_page *p)
{
    const orr_kepler_lattice *l = orr_kepler_lattice_of(e->sat, e->message);
    orr_page_value(p, &l->clock[0], e->af0_s);
    orr_page_value(p, &l->clock[1], e->af1_sps);
    orr_page_value(p, &l->clock[2], e->af2_sps2);
}

void orr_modern_clock(const orr_nav_eph *e, orr_page *p)
{
    const double toc_s = (double)(orr_nav_seconds_of_week(e->sat, e->toc, NULL) / ORR_NS_PER_S);
    orr_page_value(p, &orr_kepler_lattice_of(e->sat, e->message)->toc, toc_s);
    orr_modern_polynomial(e, p);
}

void orr_modern_top(const orr_nav_eph *e, orr_page *p)
{
    orr_page_put(p, 11, (uint64_t)(e->kepler.top_sow_s / 300));
}

void orr_modern_utc(const orr_nav_utc *u, orr_sat sat, orr_page *p)
{
    const bool beidou = orr_sat_system(sat) == 'C';
    const int leap = beidou ? BDT_LEAP_S : 0, week_0 = beidou ? ORR_BDT_WEEK_0 : 0,
              week_bits = orr_sat_system(sat) == 'I' ? 10 : 13;
    int32_t week;
    const int64_t tot = orr_nav_seconds_of_week(sat, u->reference, &week) / ORR_NS_PER_S;
    orr_page_value(p, &a0, u->a0_s);
    orr_page_value(p, &a1, u->a1_sps);
    orr_page_zeros(p, 7); // A2
    orr_page_put(p, 8, (uint64_t)(u->leap_s - leap));
    orr_page_put(p, 16, (uint64_t)(tot / 16));
    orr_page_put(p, week_bits, (uint64_t)week);
    orr_page_put(p, week_bits, (uint64_t)(u->week_lsf - week_0));
    if (beidou)
        orr_page_put(p, 3, (uint64_t)(u->day - 1)); // 0 is Sunday
    else
        orr_page_put(p, 4, (uint64_t)u->day);
    orr_page_put(p, 8, (uint64_t)(u->leap_future_s - leap));
}

void orr_modern_no_offset(orr_page *p) { orr_page_zeros(p, 16 + 13 + 7); }

void orr_modern_pole_and_ut1(const orr_modern_rotation *r, orr_sat sat, orr_page *p)
{
    orr_page_put(p, 16, (uint64_t)(orr_nav_seconds_of_week(sat, r->reference, NULL) / ORR_NS_PER_S / 16));
    orr_page_value(p, &pole, r->xp_rad);
    orr_page_value(p, &pole_rate, r->xp_rate_radps);
    orr_page_value(p, &pole, r->yp_rad);
    orr_page_value(p, &pole_rate, r->yp_rate_radps);
    orr_page_value(p, &ut1, r->ut1_utc_s);
    orr_page_value(p, &ut1_rate, r->ut1_rate_spd);
}

int orr_modern_orbit_type(orr_sat sat)
{
    if (orr_nav_beidou_geo(sat)) return 1;
    return orr_kepler_is_high(sat) ? 2 : 3;
}

// The satellite that an almanac is of, first in every one.
static void put_whose(const orr_almanac *a, orr_modern_form form, orr_page *p)
{
    orr_page_put(p, form == ORR_MODERN_CNAV2 ? 8 : 6, (uint64_t)a->number);
    if (form == ORR_MODERN_BCNAV)
        orr_page_put(p, 2, (uint64_t)orr_modern_orbit_type(orr_sat_make('C', a->number)));
}

// Health of an almanac: GPS of L1, L2 and L5; BeiDou of clock, B1C and B2a, five bits reserved.
static void put_health(const orr_almanac *a, orr_modern_form form, orr_page *p)
{
    orr_page_put(p, 3, a->health != 0 ? 7 : 0);
    if (form == ORR_MODERN_BCNAV) orr_page_zeros(p, 5);
}

// Appends an almanac that was written into a page of its own; as many zeros if there is none, or it does not fit.
static void take(const orr_page *own, bool any, size_t bits, orr_page *p)
{
    if (any && own->status == ORR_OK)
        orr_page_copy(p, own, 0, bits);
    else
        orr_page_zeros(p, (int)bits);
}

void orr_modern_reference(const orr_modern_almanacs *a, orr_page *p)
{
    orr_page_put(p, 13, (uint64_t)a->week);
    orr_page_put(p, 8, a->toa_s / 4096);
}

void orr_modern_midi(const orr_modern_almanacs *a, orr_modern_form form, orr_page *p)
{
    static const size_t bits[] = {
        [ORR_MODERN_CNAV] = 128, [ORR_MODERN_CNAV2] = 130, [ORR_MODERN_BCNAV] = 156};
    static const uint8_t gps[] = {ORR_ALMANAC_E,      ORR_ALMANAC_DELTA_I, ORR_ALMANAC_OMEGA_DOT,
                                  ORR_ALMANAC_SQRT_A, ORR_ALMANAC_OMEGA0,  ORR_ALMANAC_OMEGA,
                                  ORR_ALMANAC_M0,     ORR_ALMANAC_AF0,     ORR_ALMANAC_AF1},
                         beidou[] = {ORR_ALMANAC_E,      ORR_ALMANAC_DELTA_I,   ORR_ALMANAC_SQRT_A,
                                     ORR_ALMANAC_OMEGA0, ORR_ALMANAC_OMEGA_DOT, ORR_ALMANAC_OMEGA,
                                     ORR_ALMANAC_M0,     ORR_ALMANAC_AF0,       ORR_ALMANAC_AF1};
    const bool is_beidou = form == ORR_MODERN_BCNAV;
    const uint8_t *order = is_beidou ? beidou : gps;
    orr_page own;
    orr_page_begin(&own, NULL);
    if (!is_beidou) orr_modern_reference(a, p);
    if (a->midi != NULL) {
        double value[ORR_ALMANAC_PARTS];
        orr_almanac_values(a->midi, value);
        put_whose(a->midi, form, &own);
        if (is_beidou)
            orr_modern_reference(a, &own);
        else
            put_health(a->midi, form, &own);
        for (size_t k = 0; k < ORR_ALMANAC_PARTS; k++) orr_page_value(&own, &midi[order[k]], value[order[k]]);
        if (is_beidou) put_health(a->midi, form, &own);
    }
    take(&own, a->midi != NULL, bits[form], p);
}

void orr_modern_reduced_one(const orr_almanac *a, orr_modern_form form, orr_page *p)
{
    static const size_t bits[] = {[ORR_MODERN_CNAV] = 31, [ORR_MODERN_CNAV2] = 33, [ORR_MODERN_BCNAV] = 38};
    const bool is_beidou = form == ORR_MODERN_BCNAV;
    orr_page own;
    orr_page_begin(&own, NULL);
    if (a != NULL) {
        const orr_kepler_lattice *l = orr_kepler_lattice_of(orr_sat_make(is_beidou ? 'C' : 'G', a->number),
                                                            is_beidou ? ORR_NAV_CNV1 : ORR_NAV_CNV2);
        put_whose(a, form, &own);
        orr_page_value(&own, &delta_a,
                       a->sqrt_a_sqrtm * a->sqrt_a_sqrtm - l->element[ORR_KEPLER_SQRT_A].base);
        orr_page_value(&own, &omega0, a->omega0_rad);
        orr_page_value(&own, &phi0, a->m0_rad + a->omega_rad);
        put_health(a, form, &own);
    }
    take(&own, a != NULL, bits[form], p);
}

void orr_modern_reduced(const orr_modern_almanacs *a, size_t n, orr_modern_form form, orr_page *p)
{
    orr_modern_reference(a, p);
    for (size_t k = 0; k < n; k++) orr_modern_reduced_one(a->reduced[k], form, p);
}
