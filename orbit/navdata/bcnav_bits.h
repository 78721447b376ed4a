// SPDX-License-Identifier: GPL-3.0-or-later
// BeiDou's B-CNAV1 (B1C), B-CNAV2 (B2a) and B-CNAV3 (B2b) as bits and as symbols (BDS-SIS-ICD-B1C 1.0, B2a 1.0 and B2b 1.0, sections
// 6 and 7). Pure functions.
#ifndef ORR_ORBIT_NAVDATA_BCNAV_BITS_H
#define ORR_ORBIT_NAVDATA_BCNAV_BITS_H

#include "orbit/navdata/modern_blocks.h"

enum { // pages of B-CNAV1's subframe 3
    ORR_BCNAV1_IONOSPHERE_AND_UTC = 1,
    ORR_BCNAV1_REDUCED_ALMANACS = 2,
    ORR_BCNAV1_ROTATION_AND_OFFSET = 3,
    ORR_BCNAV1_MIDI_ALMANAC = 4
};
enum { // types of messages of B-CNAV2 (all) and B-CNAV3 (10, 30 and 40, which hold more there)
    ORR_BCNAV_EPHEMERIS_1 = 10,
    ORR_BCNAV_EPHEMERIS_2 = 11,
    ORR_BCNAV_CLOCK_AND_IONOSPHERE = 30,
    ORR_BCNAV_CLOCK_AND_REDUCED_ALMANACS = 31,
    ORR_BCNAV_CLOCK_AND_ROTATION = 32,
    ORR_BCNAV_CLOCK_AND_OFFSET = 33,
    ORR_BCNAV_CLOCK_AND_UTC = 34,
    ORR_BCNAV_MIDI_ALMANAC = 40
};

// What a frame or message tells besides the satellite's own set.
typedef struct orr_bcnav_message {
    const orr_nav_eph *eph;
    orr_time t; // begin of it
    double bdgim_tecu[9];
    orr_nav_utc utc;
    orr_modern_rotation rotation;
    orr_modern_almanacs almanacs;
    int offset_to; // system whose offset is told: 1 GPS, 2 Galileo, 3 GLONASS
} orr_bcnav_message;

// The fields of BDGIM's nine coefficients (B1C 1.0, table 7-10).
extern const orr_navfit_field orr_bcnav_bdgim[9];

// Makes a frame of B-CNAV1.
// Given:
//   b      what it tells; t is a multiple of 18 s of BDT
//   page   of subframe 3
//   coded  1800 symbols: BCH(21,6), BCH(51,8), 64-ary LDPC, interleaving; without it 14 + 600 + 264 bits
// Returned:
//   p      the frame; status ORR_E_RANGE where a value does not fit, with a sentence
void orr_bcnav1_frame_bits(const orr_bcnav_message *b, int page, bool coded, orr_page *p);

// Makes a message of B-CNAV2.
// Given:
//   b      what it tells; t is a multiple of 3 s of BDT
//   type   of message
//   coded  600 symbols: preamble, 64-ary LDPC; without it the preamble and 288 bits
// Returned:
//   p      the message; status as above
void orr_bcnav2_message_bits(const orr_bcnav_message *b, int type, bool coded, orr_page *p);

// Makes a message of B-CNAV3.
// Given:
//   b      what it tells; t is a whole second of BDT
//   type   10, 30 or 40
//   coded  1000 symbols: preamble, number, 64-ary LDPC; without it preamble, number, six zeros and 486 bits
// Returned:
//   p      the message; status as above
void orr_bcnav3_message_bits(const orr_bcnav_message *b, int type, bool coded, orr_page *p);

#endif
