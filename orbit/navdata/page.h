// SPDX-License-Identifier: GPL-3.0-or-later
// A page of a navigation message while it is written, bit after bit, and the codes that protect it: CRC-24Q, BCH(15,11), the
// convolutional code of constraint length 7, block interleaving. Private to the room.
#ifndef ORR_ORBIT_NAVDATA_PAGE_H
#define ORR_ORBIT_NAVDATA_PAGE_H

#include "orbit/navdata/field.h"

#define ORR_PAGE_BITS 2048
typedef struct orr_page {
    size_t n;                   // bits so far
    orr_status status;          // of the first field that failed; nothing is written then that matters
    orr_diag *diag;             // its sentence; may be NULL
    uint8_t bit[ORR_PAGE_BITS]; // 0 or 1, first in time first
} orr_page;

// Begins an empty page.
void orr_page_begin(orr_page *p, orr_diag *diag);
// Appends the lowest n bits of a value, the highest of them first; n up to 64.
void orr_page_put(orr_page *p, int n, uint64_t value);
// Appends n zeros.
void orr_page_zeros(orr_page *p, int n);
// A value as the bits of its field, right-aligned; 0, and p->status, where it does not fit.
uint64_t orr_page_code(orr_page *p, const orr_navfit_field *f, double value);
// Appends a value by its field.
void orr_page_value(orr_page *p, const orr_navfit_field *f, double value);
// Appends Klobuchar's eight coefficients, eight bits each, as all systems send them.
void orr_page_klobuchar(orr_page *p, const double alpha[4], const double beta[4]);
// Appends the bits [from, from + n) of another page.
void orr_page_copy(orr_page *p, const orr_page *other, size_t from, size_t n);
// Appends CRC-24Q over the bits from `from` on (IS-GPS-200N 30.3.5.1).
void orr_page_crc24q(orr_page *p, size_t from);
// Fills a message that began at bit `from` with zeros and ends it with CRC-24Q, so that it has `bits` of them.
void orr_page_seal(orr_page *p, size_t from, size_t bits);
// The last six bits, the last of them lowest: the state of a convolutional encoder that has sent them.
unsigned orr_page_tail(const orr_page *p);
// Appends the symbols of the bits [from, n) of `in` by the code G1 = 171, G2 = 133 (octal), G1 first.
// Given:
//   in, from       the bits
//   invert_second  Galileo inverts the output of G2
//   state          [1] the six bits before, the last of them lowest
// Returned: p, state (the last six).
void orr_page_convolve(orr_page *p, const orr_page *in, size_t from, bool invert_second, unsigned *state);
// Rearranges the last rows * columns symbols: written column by column (rows to a column), read row by row.
void orr_page_interleave(orr_page *p, size_t rows, size_t columns);
// The four parity bits of eleven bits by BCH(15,11,1), generator x^4 + x + 1 (BDS-SIS-ICD-B1I 3.0, 5.1.3).
unsigned orr_page_bch15(unsigned eleven);
// Appends the symbols of a cyclic code that begin with its information, each of the others made by a shift register of those before.
// Given:
//   k, value    the information, k bits, the highest of them first
//   polynomial  of the register; x^j in its bit j
//   n           symbols
// Returned: p
// Reference: IS-GPS-800J 3.2.3.2, BCH(51,8); BDS-SIS-ICD-B1C 1.0, 6.2.2.1, BCH(21,6) and BCH(51,8).
void orr_page_register(orr_page *p, int k, unsigned value, unsigned polynomial, int n);
#define ORR_BCH_21_6 0x57u  // x^6 + x^4 + x^2 + x + 1
#define ORR_BCH_51_8 0x19fu // x^8 + x^7 + x^4 + x^3 + x^2 + x + 1
// The bits as bytes, the first highest; what is left of the last byte is 0.
void orr_page_pack(const orr_page *p, uint8_t *bytes);

#endif
