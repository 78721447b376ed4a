// SPDX-License-Identifier: GPL-3.0-or-later
// A receiver's reading of GLONASS strings, written from tables 4.6, 4.11 and 4.13 of the ICD (L1/L2, 5.1) and
// not from the encoder: words by the numbers of their bits, checksums by the table's lists of bits.
#ifndef ORR_TESTS_GLONASS_DECODER_H
#define ORR_TESTS_GLONASS_DECODER_H

#include "orbit/navdata/glonass_bits.h"

uint32_t glo_bit(const orr_glonass_string *s, int number); // 85 is sent first
uint32_t glo_get(const orr_glonass_string *s, int low, int high);
double glo_signed(const orr_glonass_string *s, int low, int high); // sign and magnitude, in LSBs
bool glo_sums_are_zero(const orr_glonass_string *s);
// The words of an even and the next odd string; day is left zero.
orr_glonass_almanac glo_almanac(const orr_glonass_string *even, const orr_glonass_string *odd);

#endif
