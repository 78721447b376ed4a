// SPDX-License-Identifier: GPL-3.0-or-later
// The LDPC codes of CNAV-2 (binary) and of B-CNAV1, 2 and 3 (over GF(64)): systematic codes of rate 1/2, given by their parity
// check matrices. Private to the room.
#ifndef ORR_ORBIT_NAVDATA_LDPC_H
#define ORR_ORBIT_NAVDATA_LDPC_H

#include "orbit/navdata/page.h"

typedef enum orr_ldpc {
    ORR_LDPC_CNAV2_SUBFRAME2,  // (1200, 600)
    ORR_LDPC_CNAV2_SUBFRAME3,  // (548, 274)
    ORR_LDPC_BCNAV1_SUBFRAME2, // 64-ary (200, 100)
    ORR_LDPC_BCNAV1_SUBFRAME3, // 64-ary (88, 44)
    ORR_LDPC_BCNAV2,           // 64-ary (96, 48)
    ORR_LDPC_BCNAV3,           // 64-ary (162, 81)
    ORR_LDPC_N
} orr_ldpc;

#define ORR_LDPC_MOST_ROWS 600
typedef struct orr_ldpc_matrix {
    size_t rows; // of checks; a codeword has twice as many symbols, the first half of them information
    int bits;    // of a symbol: 1 or 6
    const uint16_t *columns; // row after row: how many, then the columns of the elements that are not zero
    const uint8_t *elements; // those elements, row after row; NULL: all are 1
} orr_ldpc_matrix;
// The parity check matrix of a code.
const orr_ldpc_matrix *orr_ldpc_matrix_of(orr_ldpc code);

// The product of two elements of GF(64), whose primitive polynomial is x^6 + x + 1 (BDS-SIS-ICD-B1C 1.0, 6.2.2.2). The elements 0
// and 1 multiply as those of GF(2).
unsigned orr_ldpc_product(unsigned a, unsigned b);

// Appends the codeword of the bits [from, from + k) of `in`, k being as many as the code protects: those bits, then the parity.
// Given:
//   code      which
//   in, from  the information, CRC included; the first bit of a 64-ary symbol is its highest
// Returned:
//   p         2 k bits more
// Notes: the parity symbols follow one from another, since in every row but a few one is new; where none is, one is taken as
// unknown and found when a row closes (Richardson, Urbanke 2001, of which the matrices of IS-GPS-800 are an example).
// Reference: IS-GPS-800J 3.2.3.3, 3.2.3.4; BDS-SIS-ICD-B1C 1.0, 6.2.2; B2a 1.0, 6.2.2; B2b 1.0, 6.2.2.
void orr_ldpc_encode(orr_ldpc code, const orr_page *in, size_t from, orr_page *p);

#endif
