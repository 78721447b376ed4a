// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/kepler_lattice.h"

#include <string.h>

#define REVOLVING(sqrt_lsb_power)                                                                            \
    ORR_UNSIGNED("sqrt(A)", P2(sqrt_lsb_power), 32), ORR_UNSIGNED("e", P2(33), 32),                          \
        ORR_ANGLE("omega", 31, 32), ORR_ANGLE("M0", 31, 32), ORR_ANGLE("i0", 31, 32),                        \
        ORR_ANGLE("OMEGA0", 31, 32)
#define RATES(omega_power, omega_bits, n_power, n_bits)                                                      \
    ORR_SIGNED("OMEGADOT", SEMICIRCLE *P2(omega_power), omega_bits),                                         \
        ORR_SIGNED("delta n", SEMICIRCLE *P2(n_power), n_bits), ORR_SIGNED("IDOT", SEMICIRCLE *P2(43), 14)
#define HARMONICS(r_power, r_bits, u_power, u_bits, i_power, i_bits)                                         \
    ORR_SIGNED("Crc", P2(r_power), r_bits), ORR_SIGNED("Crs", P2(r_power), r_bits),                          \
        ORR_SIGNED("Cuc", P2(u_power), u_bits), ORR_SIGNED("Cus", P2(u_power), u_bits),                      \
        ORR_SIGNED("Cic", P2(i_power), i_bits), ORR_SIGNED("Cis", P2(i_power), i_bits)
#define CLOCK(power0, bits0, power1, bits1, power2, bits2)                                                   \
    {                                                                                                        \
        ORR_SIGNED("af0", P2(power0), bits0), ORR_SIGNED("af1", P2(power1), bits1),                          \
            ORR_SIGNED("af2", P2(30) * P2((power2)-30), bits2)                                               \
    }
#define TIMES(step_s, bits) .toe = ORR_UNSIGNED("toe", step_s, bits), .toc = ORR_UNSIGNED("toc", step_s, bits)

// IS-GPS-200N tables 20-I and 20-III; IS-QZSS-PNT-005.
static const orr_kepler_lattice lnav = {
    .n = 15,
    .element = {REVOLVING(19), RATES(43, 24, 43, 16), HARMONICS(5, 16, 29, 16, 29, 16)},
    .clock = CLOCK(31, 22, 43, 16, 55, 8),
    TIMES(16, 16)};

// Galileo OS SIS ICD 2.1, tables 60 and 67.
static const orr_kepler_lattice galileo = {
    .n = 15,
    .element = {REVOLVING(19), RATES(43, 24, 43, 16), HARMONICS(5, 16, 29, 16, 29, 16)},
    .clock = CLOCK(34, 31, 46, 21, 59, 6),
    TIMES(60, 14)};

// BDS-SIS-ICD-B1I 3.0, tables 5-7 and 5-10.
static const orr_kepler_lattice d1d2 = {
    .n = 15,
    .element = {REVOLVING(19), RATES(43, 24, 43, 16), HARMONICS(6, 18, 31, 18, 31, 18)},
    .clock = CLOCK(33, 24, 50, 22, 66, 11),
    TIMES(8, 17)};

// IRNSS SIS ICD 1.1, tables 12 and 13.
static const orr_kepler_lattice navic = {
    .n = 15,
    .element = {REVOLVING(19), RATES(41, 22, 41, 22), HARMONICS(4, 15, 28, 15, 28, 15)},
    .clock = CLOCK(31, 22, 43, 16, 55, 8),
    TIMES(16, 16)};

#define MODERN(a_reference, omega_dot)                                                                       \
    {                                                                                                        \
        {"delta A", P2(9), 26, ORR_FIELD_SIGNED, a_reference}, ORR_UNSIGNED("e", P2(34), 33),                \
            ORR_ANGLE("omega", 32, 33), ORR_ANGLE("M0", 32, 33), ORR_ANGLE("i0", 32, 33),                    \
            ORR_ANGLE("OMEGA0", 32, 33), omega_dot, ORR_SIGNED("delta n0", SEMICIRCLE *P2(44), 17),          \
            ORR_SIGNED("IDOT", SEMICIRCLE *P2(44), 15), HARMONICS(8, 24, 30, 21, 30, 16),                    \
            ORR_SIGNED("A dot", P2(21), 25), ORR_SIGNED("delta n0 dot", SEMICIRCLE *P2(57), 23)              \
    }

// IS-GPS-200N tables 30-I and 30-III; IS-GPS-800J tables 3.5-1 and 3.5-2; IS-QZSS-PNT-005 sends differences from the same
// reference of the node's rate, and from 42 164 200 m in the place of 26 559 710.
#define CNAV_RATE                                                                                            \
    {                                                                                                        \
        "OMEGADOT", SEMICIRCLE *P2(44), 17, ORR_FIELD_SIGNED, -2.6e-9 * SEMICIRCLE                           \
    }
static const orr_kepler_lattice cnav = {.n = 17,
                                        .sends_a = true,
                                        .element = MODERN(26559710.0, CNAV_RATE),
                                        .clock = CLOCK(35, 26, 48, 20, 60, 10),
                                        TIMES(300, 11)};
static const orr_kepler_lattice cnav_qzss = {.n = 17,
                                             .sends_a = true,
                                             .element = MODERN(42164200.0, CNAV_RATE),
                                             .clock = CLOCK(35, 26, 48, 20, 60, 10),
                                             TIMES(300, 11)};

// BDS-SIS-ICD-B1C 1.0, tables 7-5 and 7-8: the reference of a is that of the satellite's kind of orbit.
#define BCNAV_RATE ORR_SIGNED("OMEGADOT", SEMICIRCLE *P2(44), 19)
static const orr_kepler_lattice bcnav = {.n = 17,
                                         .sends_a = true,
                                         .element = MODERN(27906100.0, BCNAV_RATE),
                                         .clock = CLOCK(34, 25, 50, 22, 66, 11),
                                         TIMES(300, 11)};
static const orr_kepler_lattice bcnav_high = {.n = 17,
                                              .sends_a = true,
                                              .element = MODERN(42162200.0, BCNAV_RATE),
                                              .clock = CLOCK(34, 25, 50, 22, 66, 11),
                                              TIMES(300, 11)};

// BeiDou-3's geostationary (C59-C63) and inclined geosynchronous satellites (C38-C40), by the system's table of satellites.
bool orr_kepler_is_high(orr_sat sat)
{
    const int n = orr_sat_number(sat);
    return n <= 10 || n == 13 || n == 16 || n == 31 || (n >= 38 && n <= 40) || n == 56 || n >= 59;
}

const orr_kepler_lattice *orr_kepler_lattice_of(orr_sat sat, uint8_t message)
{
    const char system = orr_sat_system(sat);
    switch (message) {
    case ORR_NAV_LNAV:
        return system == 'I' ? &navic : &lnav;
    case ORR_NAV_INAV:
    case ORR_NAV_FNAV:
        return &galileo;
    case ORR_NAV_D1:
    case ORR_NAV_D2:
        return &d1d2;
    case ORR_NAV_CNAV:
        return system == 'J' ? &cnav_qzss : &cnav;
    case ORR_NAV_CNV1:
    case ORR_NAV_CNV3:
        return orr_kepler_is_high(sat) ? &bcnav_high : &bcnav;
    case ORR_NAV_CNV2:
        if (system == 'C') return orr_kepler_is_high(sat) ? &bcnav_high : &bcnav;
        return system == 'J' ? &cnav_qzss : &cnav;
    default:
        return NULL;
    }
}

void orr_kepler_lattice_values(const orr_kepler_lattice *l, const orr_nav_kepler *k,
                               double value[ORR_KEPLER_N])
{
    const double a = k->sqrt_a_sqrtm * k->sqrt_a_sqrtm;
    const double all[ORR_KEPLER_N] = {l->sends_a ? a : k->sqrt_a_sqrtm,
                                      k->e,
                                      k->omega_rad,
                                      k->m0_rad,
                                      k->i0_rad,
                                      k->omega0_rad,
                                      k->omega_dot_radps,
                                      k->delta_n_radps,
                                      k->idot_radps,
                                      k->crc_m,
                                      k->crs_m,
                                      k->cuc_rad,
                                      k->cus_rad,
                                      k->cic_rad,
                                      k->cis_rad,
                                      k->a_dot_mps,
                                      k->delta_n_dot_radps2};
    memcpy(value, all, sizeof all);
}

void orr_kepler_put(orr_page *p, const orr_nav_eph *e, const uint8_t *list, size_t n)
{
    double value[ORR_KEPLER_N];
    const orr_kepler_lattice *l = orr_kepler_lattice_of(e->sat, e->message);
    orr_kepler_lattice_values(l, &e->kepler, value);
    for (size_t i = 0; i < n; i++) orr_page_value(p, &l->element[list[i]], value[list[i]]);
}
