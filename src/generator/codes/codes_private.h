// SPDX-License-Identifier: MIT
// What the families of codes give to codes.c.
#ifndef ORR_GENERATOR_CODES_CODES_PRIVATE_H
#define ORR_GENERATOR_CODES_CODES_PRIVATE_H

#include "src/generator/codes/codes.h"

// Codes made by shift registers, B1C excepted; false where `prn` has none.
bool orr_gen_registers_fill(orr_gen_code code, unsigned prn, int8_t *chips);
// Codes made of Legendre sequences: B1C.
bool orr_gen_weil_fill(orr_gen_code code, unsigned prn, int8_t *chips);
// Secondary codes made of them: 1800 chips of B1C, 100 of B2a.
size_t orr_gen_weil_secondary(orr_gen_code code, unsigned prn, int8_t *chips);
// Codes of Galileo E1.
bool orr_gen_memory_fill(orr_gen_code code, unsigned prn, int8_t *chips);
// n chips from hexadecimal digits, the first in the highest bit of the first.
void orr_gen_hex_chips(const char *hex, size_t n, int8_t *chips);

#endif
