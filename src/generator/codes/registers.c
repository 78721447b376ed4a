// SPDX-License-Identifier: MIT
// Codes that linear feedback shift registers make. A register of n stages is an integer: the stage that gives the chip is
// bit 0, the one that is fed bit n - 1; `taps` are the bits that are added to feed it.
#include <string.h>

#include "src/generator/codes/assignments_private.h"
#include "src/generator/codes/codes_private.h"

static unsigned parity(uint32_t x)
{
    x ^= x >> 16;
    x ^= x >> 8;
    x ^= x >> 4;
    return (0x6996u >> (x & 15)) & 1;
}

static int8_t chip_of(unsigned bit) { return bit ? -1 : 1; }

static uint32_t step(uint32_t state, uint32_t taps, unsigned stages)
{
    return (uint32_t)parity(state & taps) << (stages - 1) | state >> 1;
}

// Chips n of a register, the output being the sum of the stages in `out`; multiplied into chips[].
static void times_register(uint32_t state, uint32_t taps, uint32_t out, unsigned stages, size_t n,
                           int8_t *chips)
{
    for (size_t i = 0; i < n; i++) {
        chips[i] = (int8_t)(chips[i] * chip_of(parity(state & out)));
        state = step(state, taps, stages);
    }
}

static void ones(int8_t *chips, size_t n) { memset(chips, 1, n); }

// C/A: G1 = 1 + x^3 + x^10, G2 = 1 + x^2 + x^3 + x^6 + x^8 + x^9 + x^10, G2 delayed (IS-GPS-200N 3.3.2.3).
static void ca(unsigned delay, int8_t *chips)
{
    int8_t g2[1023];
    ones(chips, sizeof g2);
    ones(g2, sizeof g2);
    times_register(0x3ff, 0x081, 1, 10, 1023, chips);
    times_register(0x3ff, 0x197, 1, 10, 1023, g2);
    for (size_t i = 0; i < 1023; i++) chips[i] = (int8_t)(chips[i] * g2[(i + 1023 - delay) % 1023]);
}

static bool ca_of(unsigned prn, int8_t *chips)
{
    if (prn >= 1 && prn <= 63)
        ca(ca_delay[prn - 1], chips);
    else if (prn >= 120 && prn <= 158)
        ca(ca_delay_sbas[prn - 120], chips);
    else if (prn >= 193 && prn <= 202)
        ca(ca_delay_qzss[prn - 193], chips);
    else
        return false;
    return true;
}

// A register that is set back to `begin` after 8190 chips, as XA of L5 and register 1 of B2a are.
static void short_cycled(uint32_t begin, uint32_t taps, int8_t *chips)
{
    ones(chips, 10230);
    times_register(begin, taps, 1, 13, 8190, chips);
    times_register(begin, taps, 1, 13, 10230 - 8190, chips + 8190);
}

// L5: XA = 1 + x^9 + x^10 + x^12 + x^13, short-cycled; XB = 1 + x + x^3 + x^4 + x^6 + x^7 + x^8 + x^12 + x^13, advanced
// (IS-GPS-705J 3.3.2.2, 3.3.2.3).
static void l5(unsigned advance, int8_t *chips)
{
    uint32_t xb = 0x1fff;
    short_cycled(0x1fff, 0x001b, chips);
    for (unsigned i = 0; i < advance; i++) xb = step(xb, 0x16e3, 13);
    times_register(xb, 0x16e3, 1, 13, 10230, chips);
}

static bool l5_of(bool q, unsigned prn, int8_t *chips)
{
    if (prn >= 1 && prn <= 63)
        l5((q ? l5_advance_q : l5_advance_i)[prn - 1], chips);
    else if (prn >= 193 && prn <= 202)
        l5((q ? l5_advance_q_qzss : l5_advance_i_qzss)[prn - 193], chips);
    else
        return false;
    return true;
}

// L2 CM and CL: a modular register of 27 stages, polynomial 1112225171 octal (IS-GPS-200N 3.3.2.4, figure 3-14).
static bool l2_of(bool cl, unsigned prn, int8_t *chips)
{
    uint32_t state;
    if (prn >= 1 && prn <= 63)
        state = (cl ? l2cl_begin : l2cm_begin)[prn - 1];
    else if (prn >= 193 && prn <= 202)
        state = (cl ? l2cl_begin_qzss : l2cm_begin_qzss)[prn - 193];
    else
        return false;
    for (size_t i = 0, n = cl ? 767250 : 10230; i < n; i++) {
        chips[i] = chip_of(state & 1);
        state = (state >> 1) ^ (0x494953cu & (0u - (state & 1)));
    }
    return true;
}

// E5a: register 1 all ones with polynomial 40503 octal, register 2 with 50661 (Galileo OS SIS ICD 2.1, 3.4.1, table 15).
// The polynomial's bit j is the coefficient of x^j; stage 14 gives the chip.
static void e5a(uint16_t begin, int8_t *chips)
{
    ones(chips, 10230);
    uint32_t r[2] = {0x3fff, begin};
    static const uint32_t polynomial[2] = {040503, 050661};
    uint32_t taps[2] = {0, 0};
    for (int k = 0; k < 2; k++)
        for (unsigned j = 1; j <= 14; j++)
            if (polynomial[k] >> j & 1) taps[k] |= 1u << (14 - j);
    for (int k = 0; k < 2; k++) {
        uint32_t state = 0; // start values are printed with stage 1 in the lowest bit
        for (unsigned j = 0; j < 14; j++) state |= (r[k] >> j & 1) << (13 - j);
        times_register(state, taps[k], 1, 14, 10230, chips);
    }
}

// B1I: G1 = 1 + x + x^7 + x^8 + x^9 + x^10 + x^11, G2 = 1 + x + x^2 + x^3 + x^4 + x^5 + x^8 + x^9 + x^11, both from
// 01010101010 (BDS-SIS-ICD-B1I-3.0 4.3.1).
static void b1i(uint16_t out, int8_t *chips)
{
    ones(chips, 2046);
    times_register(0x2aa, 0x41f, 1, 11, 2046, chips);
    times_register(0x2aa, 0x7cd, out, 11, 2046, chips);
}

// Initial values of B2a are printed with stage 1 first, which is fed: the highest bit here.
static void b2a(uint32_t taps1, uint32_t taps2, uint16_t begin, int8_t *chips)
{
    short_cycled(0x1fff, taps1, chips);
    uint32_t state = 0;
    for (unsigned j = 0; j < 13; j++) state |= (uint32_t)(begin >> j & 1) << j;
    times_register(state, taps2, 1, 13, 10230, chips);
}

bool orr_gen_registers_fill(orr_gen_code code, unsigned prn, int8_t *chips)
{
    switch (code) {
    case ORR_GEN_L1CA:
        return ca_of(prn, chips);
    case ORR_GEN_L2CM:
        return l2_of(false, prn, chips);
    case ORR_GEN_L2CL:
        return l2_of(true, prn, chips);
    case ORR_GEN_L5I:
        return l5_of(false, prn, chips);
    case ORR_GEN_L5Q:
        return l5_of(true, prn, chips);
    case ORR_GEN_GLONASS: // 1 + x^5 + x^9, the chip from stage 7 (GLONASS ICD 5.1, 3.3.2.1)
        ones(chips, 511);
        times_register(0x1ff, 0x011, 1u << 2, 9, 511, chips);
        return true;
    default:
        break;
    }
    const bool galileo = code == ORR_GEN_E5AI || code == ORR_GEN_E5AQ;
    if (prn < 1 || prn > (galileo ? 50u : 63u)) return false;
    switch (code) {
    case ORR_GEN_E5AI:
        e5a(e5ai_begin[prn - 1], chips);
        return true;
    case ORR_GEN_E5AQ:
        e5a(e5aq_begin[prn - 1], chips);
        return true;
    case ORR_GEN_B1I:
        b1i(b1i_taps[prn - 1], chips);
        return true;
    // g1 = 1 + x + x^5 + x^11 + x^13, g2 = 1 + x^3 + x^5 + x^9 + x^11 + x^12 + x^13 (BDS-SIS-ICD-B2a-1.0 5.2.1)
    case ORR_GEN_B2A_DATA:
        b2a(0x1105, 0x0517, b2ad_begin[prn - 1], chips);
        return true;
    // g1 = 1 + x^3 + x^6 + x^7 + x^13, g2 = 1 + x + x^5 + x^7 + x^8 + x^12 + x^13
    case ORR_GEN_B2A_PILOT:
        b2a(0x04c1, 0x1163, b2ap_begin[prn - 1], chips);
        return true;
    default:
        return false;
    }
}

size_t orr_gen_secondary_fill(orr_gen_code code, unsigned prn, int8_t *chips)
{
    static const char nh10[] = "0D4", nh20[] = "04D4E";
    switch (code) {
    case ORR_GEN_L5I:
        orr_gen_hex_chips(nh10, 10, chips);
        return 10;    // IS-GPS-705J 3.3.2.2: 0000110101
    case ORR_GEN_L5Q: // 3.3.2.3: 00000100110101001110
    case ORR_GEN_B1I:
        orr_gen_hex_chips(nh20, 20, chips);
        return 20; // BDS-SIS-ICD-B1I-3.0 5.1.2
    case ORR_GEN_E1C:
        orr_gen_hex_chips("380AD90", 25, chips);
        return 25; // Galileo OS SIS ICD 2.1 table 19
    case ORR_GEN_E5AI:
        orr_gen_hex_chips("842E9", 20, chips);
        return 20;
    case ORR_GEN_B2A_DATA:
        orr_gen_hex_chips("10", 5, chips);
        return 5; // BDS-SIS-ICD-B2a-1.0 5.2.2: 00010
    case ORR_GEN_E5AQ:
        if (prn < 1 || prn > 50) return 0;
        orr_gen_hex_chips(e5aq_secondary[prn - 1], 100, chips);
        return 100;
    case ORR_GEN_B1C_PILOT:
    case ORR_GEN_B2A_PILOT:
        return orr_gen_weil_secondary(code, prn, chips);
    default:
        chips[0] = 1;
        return 1;
    }
}
