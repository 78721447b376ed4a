// SPDX-License-Identifier: GPL-3.0-or-later
// NavIC's SPS message on L5 and S as bits and symbols: subframes of 292 bits with CRC-24Q, the convolutional code and interleaving
// (IRNSS SIS ICD for SPS 1.1, 2017, chapter 5). Pure functions. A value that does not fit its field is left in the page's status.
#ifndef ORR_ORBIT_NAVDATA_NAVIC_BITS_H
#define ORR_ORBIT_NAVDATA_NAVIC_BITS_H

#include "ingest/rinex/rinex_nav.h"
#include "orbit/navdata/almanac_kepler.h"
#include "orbit/navdata/nav_utc.h"
#include "orbit/navdata/page.h"

// Messages of subframes 3 and 4.
typedef enum orr_navic_message {
    ORR_NAVIC_NULL = 0,
    ORR_NAVIC_ALMANAC = 7,
    ORR_NAVIC_UTC = 9,         // and the offset to GPS
    ORR_NAVIC_IONOSPHERE = 11, // and the Earth's orientation
} orr_navic_message;

// What a subframe tells besides the satellite's own set.
typedef struct orr_navic_subframe {
    const orr_nav_eph *eph;
    orr_time t, next; // begin of the subframe and of the next: WN of subframe 1, TOWC
    double alpha[4], beta[4];
    orr_nav_utc utc;
    const orr_almanac *almanac; // of an almanac
    int32_t almanac_week;       // of GPS
} orr_navic_subframe;

// Makes a subframe.
// Given:
//   d         what it tells
//   subframe  1 to 4
//   message   of subframes 3 and 4
// Returned:
//   p         292 bits with CRC and tail; status ORR_E_RANGE where a value does not fit, with a sentence
void orr_navic_subframe_bits(const orr_navic_subframe *d, int subframe, orr_navic_message message,
                             orr_page *p);
// Its 600 symbols: sixteen of synchronisation (EB90, hexadecimal) and 584 that are coded and interleaved.
void orr_navic_symbols(const orr_page *bits, orr_page *symbols);

#endif
