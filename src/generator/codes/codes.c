// SPDX-License-Identifier: MIT
// Which family makes a code, and the codes that are not made but printed.
#include "src/generator/codes/codes.h"

#include "src/generator/codes/codes_private.h"

size_t orr_gen_code_chips(orr_gen_code code)
{
    switch (code) {
    case ORR_GEN_L1CA:
        return 1023;
    case ORR_GEN_L2CL:
        return ORR_GEN_CHIPS_LARGEST;
    case ORR_GEN_GLONASS:
        return 511;
    case ORR_GEN_E1B:
    case ORR_GEN_E1C:
        return 4092;
    case ORR_GEN_B1I:
        return 2046;
    default:
        return 10230;
    }
}

void orr_gen_hex_chips(const char *hex, size_t n, int8_t *chips)
{
    for (size_t i = 0; i < n; i++) {
        const char c = hex[i / 4];
        const unsigned digit = (unsigned)(c <= '9' ? c - '0' : c - 'A' + 10);
        chips[i] = (digit >> (3 - i % 4) & 1) ? -1 : 1;
    }
}

bool orr_gen_memory_fill(orr_gen_code code, unsigned prn, int8_t *chips)
{
    static const char *const e1b[51] = {
#define ORR_E1(component, number, hex) ORR_E1_##component(number, hex)
#define ORR_E1_B(number, hex) [number] = (hex),
#define ORR_E1_C(number, hex)
#include "src/generator/codes/galileo_e1.def"
#undef ORR_E1_B
#undef ORR_E1_C
    };
    static const char *const e1c[51] = {
#define ORR_E1_B(number, hex)
#define ORR_E1_C(number, hex) [number] = (hex),
#include "src/generator/codes/galileo_e1.def"
    };
    if (prn < 1 || prn > 50) return false;
    orr_gen_hex_chips((code == ORR_GEN_E1B ? e1b : e1c)[prn], 4092, chips);
    return true;
}

bool orr_gen_code_fill(orr_gen_code code, unsigned prn, int8_t *chips)
{
    switch (code) {
    case ORR_GEN_E1B:
    case ORR_GEN_E1C:
        return orr_gen_memory_fill(code, prn, chips);
    case ORR_GEN_B1C_DATA:
    case ORR_GEN_B1C_PILOT:
        return orr_gen_weil_fill(code, prn, chips);
    default:
        return orr_gen_registers_fill(code, prn, chips);
    }
}

bool orr_gen_b1i_is_d2(unsigned prn) { return (prn >= 1 && prn <= 5) || (prn >= 59 && prn <= 63); }
