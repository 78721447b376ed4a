// SPDX-License-Identifier: GPL-3.0-or-later
// SBAS on L1 as bits: messages of 250 bits with CRC-24Q (RTCA DO-229E, appendix A.4). Ranging data are those of the satellite's set;
// corrections are zero, of the ionospheric grid no point is monitored. Pure functions.
#ifndef ORR_ORBIT_NAVDATA_SBAS_BITS_H
#define ORR_ORBIT_NAVDATA_SBAS_BITS_H

#include "ingest/rinex/rinex_nav.h"
#include "orbit/navdata/page.h"

// Numbers of messages.
typedef enum orr_sbas_message {
    ORR_SBAS_DO_NOT_USE = 0,
    ORR_SBAS_MASK = 1,       // of the satellites that are corrected
    ORR_SBAS_FAST_FIRST = 2, // fast corrections of the mask's places 1-13, 14-26, 27-39
    ORR_SBAS_FAST_LAST = 4,
    ORR_SBAS_INTEGRITY = 6,
    ORR_SBAS_FAST_AGING = 7,
    ORR_SBAS_EPHEMERIS = 9,
    ORR_SBAS_DEGRADATION = 10,
    ORR_SBAS_ALMANAC = 17,
    ORR_SBAS_GRID_MASK = 18,
    ORR_SBAS_LONG_TERM = 25,
    ORR_SBAS_GRID = 26,
    ORR_SBAS_SERVICE = 27,
} orr_sbas_message;

#define ORR_SBAS_CORRECTED 32 // GPS satellites
#define ORR_SBAS_ALMANACS 3   // in a message
#define ORR_SBAS_LONG_TERMS 4 // likewise
#define ORR_SBAS_GRID_BLOCKS 14

typedef struct orr_sbas_almanac {
    orr_sat sat; // ORR_SAT_NONE: none
    bool healthy;
    orr_vec3 pos_m, vel_mps; // at t0, ecef
} orr_sbas_almanac;

// What a message tells.
typedef struct orr_sbas_told {
    const orr_nav_eph *eph; // of message 9
    orr_time t;             // begin of the message
    // The GPS satellites that are corrected: [PRN - 1].
    bool corrected[ORR_SBAS_CORRECTED], healthy[ORR_SBAS_CORRECTED];
    uint8_t iode[ORR_SBAS_CORRECTED];
    orr_sbas_almanac almanac[ORR_SBAS_ALMANACS];
    orr_time almanac_t0;
    int part; // message 25: the first of four places of the mask, from 0 on; message 26: block 0 to 13
    double longitude_rad; // of the satellite: the band of the grid beneath it
} orr_sbas_told;

// Makes a message.
// Given:
//   d        what it tells
//   message  its number
// Returned:
//   p        250 bits; status ORR_E_RANGE where a value does not fit, with a sentence
void orr_sbas_message_bits(const orr_sbas_told *d, orr_sbas_message message, orr_page *p);

#endif
