// SPDX-License-Identifier: MIT
// Ranging codes of the civil signals, chip by chip, as the interface documents define them; libc alone. A chip is +1 for
// the documents' logical 0 and -1 for 1, which is how the chip multiplies the carrier.
#ifndef ORR_GENERATOR_CODES_CODES_H
#define ORR_GENERATOR_CODES_CODES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum orr_gen_code {
    ORR_GEN_L1CA, // GPS, QZSS, SBAS C/A: 1023 chips in 1 ms
    ORR_GEN_L2CM, // GPS, QZSS: 10230 in 20 ms
    ORR_GEN_L2CL, // 767250 in 1.5 s
    ORR_GEN_L5I,  // GPS, QZSS: 10230 in 1 ms
    ORR_GEN_L5Q,
    ORR_GEN_GLONASS, // C/A of L1OF and L2OF, the same of all satellites: 511 in 1 ms
    ORR_GEN_E1B,     // Galileo: 4092 in 4 ms
    ORR_GEN_E1C,
    ORR_GEN_E5AI, // 10230 in 1 ms
    ORR_GEN_E5AQ,
    ORR_GEN_B1I,      // BeiDou: 2046 in 1 ms
    ORR_GEN_B1C_DATA, // 10230 in 10 ms
    ORR_GEN_B1C_PILOT,
    ORR_GEN_B2A_DATA, // 10230 in 1 ms
    ORR_GEN_B2A_PILOT,
    ORR_GEN_CODES
} orr_gen_code;

#define ORR_GEN_CHIPS_LARGEST 767250
#define ORR_GEN_SECONDARY_LARGEST 1800

// Chips in one period of the primary code.
size_t orr_gen_code_chips(orr_gen_code code);

// One period of the primary code of satellite `prn` into chips[0 .. orr_gen_code_chips(code)). `prn` is the number in
// RINEX (QZSS J01 to J10 are 193 to 202, SBAS S20 to S58 are 120 to 158); false where the document assigns no code to it.
bool orr_gen_code_fill(orr_gen_code code, unsigned prn, int8_t *chips);

// The secondary code, one chip a period of the primary code, into chips[0 .. ORR_GEN_SECONDARY_LARGEST). Returns its length;
// 1 and a chip of +1 where the component has none, 0 where the document assigns none to `prn`. The secondary code of B1I is
// that of D1 (Neumann-Hoffman, 20); of D2, which geostationary satellites send (orr_gen_b1i_is_d2), there is none.
size_t orr_gen_secondary_fill(orr_gen_code code, unsigned prn, int8_t *chips);

// Whether a BeiDou satellite sends D2 on B1I (BDS-SIS-ICD-B1I-3.0 table 4-1: C01 to C05 and C59 to C63).
bool orr_gen_b1i_is_d2(unsigned prn);

#endif
