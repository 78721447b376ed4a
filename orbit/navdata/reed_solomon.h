// SPDX-License-Identifier: GPL-3.0-or-later
// The Reed-Solomon code of Galileo's words 17 to 20. Private to the room.
#ifndef ORR_ORBIT_NAVDATA_REED_SOLOMON_H
#define ORR_ORBIT_NAVDATA_REED_SOLOMON_H

#include <stddef.h>
#include <stdint.h>

#define ORR_REED_SOLOMON_PARITY 60
// Parity of a shortened RS(255, 195): GF(256) by x^8 + x^4 + x^3 + x^2 + 1, zeros of the generator alpha^1 .. alpha^60.
// Given:
//   information  [n] octets; octet k is the coefficient of x^(60 + k)
//   n            at most 195
// Returned:
//   parity       [60] octets; octet k is the coefficient of x^k
// Reference: Galileo OS SIS ICD 2.1, 5.1.12 and annex D.
void orr_reed_solomon(const uint8_t *information, size_t n, uint8_t parity[ORR_REED_SOLOMON_PARITY]);

#endif
