// SPDX-License-Identifier: GPL-3.0-or-later
// What a satellite sends within the 30 s that hold an instant, bit by bit: five LNAV subframes, or a GLONASS
// frame of fifteen strings. A generator that asks every 30 s has the whole stream.
#ifndef ORR_ORBIT_NAVDATA_NAVFRAME_H
#define ORR_ORBIT_NAVDATA_NAVFRAME_H

#include "orbit/navdata/navset.h"

#define ORR_NAVFRAME_PIECES 15
#define ORR_NAVFRAME_BYTES 38

// A subframe (300 bits, 6 s) or a string (85 bits, sent in relative code within 1.7 s of its 2 s; the time
// mark of 0.3 s after it is the generator's).
typedef struct orr_navframe_piece {
    orr_time t;     // begin of its first bit
    uint8_t number; // subframe 1-5, string 1-15
    uint8_t page;   // LNAV: page 1-25 of subframes 4 and 5, 0 otherwise; GLONASS: frame 1-5 of the superframe
    uint16_t bits;  // 300 or 85
    uint8_t data[ORR_NAVFRAME_BYTES]; // first bit in time is the highest of data[0]; what is left of the last
                                      // byte is 0
} orr_navframe_piece;

typedef struct orr_navframe {
    orr_sat sat;
    uint8_t message; // orr_nav_message: LNAV or FDMA
    orr_time from, to;
    uint8_t n; // pieces: 5 or 15
    orr_navframe_piece piece[ORR_NAVFRAME_PIECES];
} orr_navframe;

// The message bits that a satellite sends in the 30 s around an instant.
// Given:
//   set   broadcast data
//   sat   satellite
//   t     instant; frames begin at multiples of 30 s of GPS time (LNAV) or of UTC (GLONASS)
// Returned:
//   out   the pieces of the frame that holds t; ephemeris and clock are those on the air at the frame's begin
//   diag  why it failed; may be NULL
// Errors: ORR_E_NODATA where the satellite has no set, ORR_E_RANGE if a value does not fit its field.
orr_status orr_navframe_at(const orr_navset *set, orr_sat sat, orr_time t, orr_navframe *out, orr_diag *diag);

#endif
