// SPDX-License-Identifier: GPL-3.0-or-later
// BeiDou D1 and D2 as bits: subframes 1 to 5 with BCH(15,11,1) and interleaving (BDS-SIS-ICD-B1I 3.0, 5.1 to 5.3). Pure functions.
#ifndef ORR_ORBIT_NAVDATA_BEIDOU_BITS_H
#define ORR_ORBIT_NAVDATA_BEIDOU_BITS_H

#include "ingest/rinex/rinex_nav.h"
#include "orbit/navdata/almanac_kepler.h"
#include "orbit/navdata/nav_utc.h"
#include "orbit/navdata/page.h"

// What a subframe tells besides the satellite's own set.
typedef struct orr_beidou_subframe {
    const orr_nav_eph *eph;
    orr_time t; // begin of the subframe, of D2's frame: SOW, and WN of subframe 1
    double alpha[4], beta[4];
    orr_nav_utc utc;
    const orr_almanac *almanac; // of an almanac page; NULL: none
    uint32_t toa_s;
    int32_t almanac_week;  // of BDT
    const uint8_t *health; // [64] of the pages of health: by number, 0 is good
} orr_beidou_subframe;

// Makes a subframe of D1.
// Given:
//   d         what it tells
//   subframe  1 to 5
//   page      1 to 24, of subframes 4 and 5
// Returned:
//   p         300 bits as they are sent; status ORR_E_RANGE where a value does not fit, with a sentence
void orr_d1_subframe_bits(const orr_beidou_subframe *d, int subframe, int page, orr_page *p);

// Makes a frame of D2: five subframes. Integrity and corrections (subframes 2 to 4) are those of no satellite, of the ionospheric
// grid no point is monitored.
// Given:
//   d       what it tells; its almanac is that of orr_d2_almanac_of(page5)
//   page1   1 to 10, of subframe 1
//   page5   1 to 120, of subframe 5
// Returned:
//   p       1500 bits as they are sent; status ORR_E_RANGE where a value does not fit, with a sentence
void orr_d2_frame_bits(const orr_beidou_subframe *d, int page1, int page5, orr_page *p);
// The satellite whose almanac a page of D2's subframe 5 holds; 0 for none (5.3.3.9).
int orr_d2_almanac_of(int page);

#endif
