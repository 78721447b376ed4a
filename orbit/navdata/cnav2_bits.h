// SPDX-License-Identifier: GPL-3.0-or-later
// CNAV-2 of GPS and QZSS (L1C): frames of three subframes in 18 s (IS-GPS-800J 3.2.3 and 3.5; IS-QZSS-PNT-005 4.4), as bits and as
// symbols. Pure functions.
#ifndef ORR_ORBIT_NAVDATA_CNAV2_BITS_H
#define ORR_ORBIT_NAVDATA_CNAV2_BITS_H

#include "orbit/navdata/modern_blocks.h"

#define ORR_CNAV2_FRAME_S 18
#define ORR_CNAV2_REDUCED_ALMANACS 6 // of page 3
enum {                               // pages of subframe 3
    ORR_CNAV2_UTC_AND_IONOSPHERE = 1,
    ORR_CNAV2_OFFSET_AND_ROTATION = 2,
    ORR_CNAV2_REDUCED_ALMANAC = 3,
    ORR_CNAV2_MIDI_ALMANAC = 4
};

// What a frame tells besides the satellite's own set.
typedef struct orr_cnav2_frame {
    const orr_nav_eph *eph;
    orr_time t; // begin of the frame, a multiple of 18 s of GPS time
    double alpha[4], beta[4];
    orr_nav_utc utc;
    orr_modern_rotation rotation;
    orr_modern_almanacs almanacs;
} orr_cnav2_frame;

// Makes a frame.
// Given:
//   c      what it tells
//   page   of subframe 3
//   coded  1800 symbols: BCH(51,8), LDPC, interleaving; without it 9 + 600 + 274 bits
// Returned:
//   p      the frame; status ORR_E_RANGE where a value does not fit, with a sentence
void orr_cnav2_frame_bits(const orr_cnav2_frame *c, int page, bool coded, orr_page *p);

#endif
