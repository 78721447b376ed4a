// SPDX-License-Identifier: GPL-3.0-or-later
// BeiDou D1 as bits: subframes 1 to 5 with BCH(15,11,1) and interleaving (BDS-SIS-ICD-B1I 3.0, 5.1 and 5.2). Pure functions.
#ifndef ORR_ORBIT_NAVDATA_BEIDOU_BITS_H
#define ORR_ORBIT_NAVDATA_BEIDOU_BITS_H

#include "ingest/rinex/rinex_nav.h"
#include "orbit/navdata/almanac_kepler.h"
#include "orbit/navdata/nav_utc.h"
#include "orbit/navdata/page.h"

// What a subframe tells besides the satellite's own set.
typedef struct orr_d1_subframe {
    const orr_nav_eph *eph;
    orr_time t; // begin of the subframe: SOW, and WN of subframe 1
    double alpha[4], beta[4];
    orr_nav_utc utc;
    const orr_almanac *almanac; // of an almanac page; NULL: none
    uint32_t toa_s;
    int32_t almanac_week;  // of BDT
    const uint8_t *health; // [64] of pages 7 and 8 of subframe 5: by number, 0 is good
} orr_d1_subframe;

// Makes a subframe.
// Given:
//   d         what it tells
//   subframe  1 to 5
//   page      1 to 24, of subframes 4 and 5
// Returned:
//   p         300 bits as they are sent; status ORR_E_RANGE where a value does not fit, with a sentence
void orr_d1_subframe_bits(const orr_d1_subframe *d, int subframe, int page, orr_page *p);

#endif
