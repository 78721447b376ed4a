// SPDX-License-Identifier: GPL-3.0-or-later
// Galileo I/NAV (E1-B, E5b-I) and F/NAV (E5a-I) as bits and symbols (Galileo OS SIS ICD 2.1, sections 4.2, 4.3 and 5.1). Pure
// functions. A value that does not fit its field is left in the page's status.
#ifndef ORR_ORBIT_NAVDATA_GALILEO_BITS_H
#define ORR_ORBIT_NAVDATA_GALILEO_BITS_H

#include "ingest/rinex/rinex_nav.h"
#include "orbit/navdata/almanac_kepler.h"
#include "orbit/navdata/nav_utc.h"
#include "orbit/navdata/page.h"

// What a page tells besides the satellite's own set.
typedef struct orr_galileo_page {
    orr_time t;             // begin of the page: WN and TOW
    const orr_nav_eph *eph; // I/NAV's set for I/NAV, F/NAV's for F/NAV
    double ai[3];           // NeQuick-G: sfu, sfu/deg, sfu/deg^2
    orr_nav_utc utc;
    // Almanac: three satellites; number 0 where there is none.
    const orr_almanac *almanac[3];
    int32_t almanac_week; // GPS week of toa
    uint32_t toa_s;
    int iod_a; // 4 bits
} orr_galileo_page;

// One word of I/NAV: 128 bits.
// Given:
//   g      what it tells
//   type   0 (spare word with the time), 1 to 10, 16 (reduced clock and ephemeris), 17 to 20 (Reed-Solomon of words 1 to 4)
// Returned:
//   word   the bits; its status ORR_E_ARG for another type, ORR_E_RANGE where a value does not fit, with a sentence
void orr_inav_word(const orr_galileo_page *g, int type, orr_page *word);
// A nominal page of I/NAV from its word: even and odd part, 2 x 120 bits with CRC and tails.
// Given:
//   word   [128] bits
//   ssp    secondary synchronisation pattern of E1-B, 1 to 3; 0: E5b-I, which has none
// Returned:
//   page   240 bits
void orr_inav_page(const orr_page *word, int ssp, orr_page *page);
// A page of F/NAV: 244 bits with CRC and tail.
// Given:
//   g      what it tells
//   type   1 to 6
// Returned:
//   page   its bits; status as of orr_inav_word
void orr_fnav_page(const orr_galileo_page *g, int type, orr_page *page);

// Symbols of a page of I/NAV: two parts of 10 symbols of synchronisation and 240 that are interleaved.
void orr_inav_symbols(const orr_page *page, orr_page *symbols);
// Symbols of a page of F/NAV: 12 of synchronisation and 488 that are interleaved.
void orr_fnav_symbols(const orr_page *page, orr_page *symbols);

#endif
