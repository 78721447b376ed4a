// SPDX-License-Identifier: GPL-3.0-or-later
// CNAV of GPS and QZSS (L2C, L5) as bits: messages of 300 bits with CRC (IS-GPS-200N 30.3.3, IS-GPS-705J 20.3.3; IS-QZSS-PNT-005
// 4.3). Pure functions.
#ifndef ORR_ORBIT_NAVDATA_CNAV_BITS_H
#define ORR_ORBIT_NAVDATA_CNAV_BITS_H

#include "orbit/navdata/modern_blocks.h"

// What a message tells besides the satellite's own set.
typedef struct orr_cnav_message {
    const orr_nav_eph *eph;
    orr_time next; // begin of the next message: TOW count
    double alpha[4], beta[4];
    orr_nav_utc utc;
    orr_modern_rotation rotation;
    orr_modern_almanacs almanacs;
} orr_cnav_message;
#define ORR_CNAV_REDUCED_ALMANACS 7 // of message 12

// Makes a message.
// Given:
//   c     what it tells
//   type  10 and 11 (ephemeris), 12 (reduced almanacs), 30 (clock, group delays, ionosphere), 32 (clock, Earth's rotation), 33 (clock,
//         UTC), 35 (clock, offset to Galileo: none), 37 (clock, midi almanac)
// Returned:
//   p     its 300 bits; status ORR_E_RANGE where a value does not fit, with a sentence
void orr_cnav_message_bits(const orr_cnav_message *c, int type, orr_page *p);

// Appends TGD or an inter-signal correction.
void orr_cnav_put_delay(double delay_s, orr_page *p);
// Appends the week of the time of prediction, modulo 256.
void orr_cnav_put_week_of_prediction(const orr_nav_eph *e, orr_page *p);

#endif
