// SPDX-License-Identifier: GPL-3.0-or-later
// What a satellite sends on one signal within the frame of a message that holds an instant, as bits or as the symbols that a
// modulator takes. A generator that asks again at the frame's end has the whole stream.
#ifndef ORR_ORBIT_NAVDATA_NAVFRAME_H
#define ORR_ORBIT_NAVDATA_NAVFRAME_H

#include "orbit/navdata/navset.h"

#define ORR_NAVFRAME_PIECES 15
#define ORR_NAVFRAME_BYTES 226

// A subframe, string, page or message; of D2 a frame of five subframes. Its k-th bit begins at t + k length / bits. GLONASS' strings as bits last 1.7 s of
// their 2 s; the time mark of 0.3 s after them is the generator's, or among the symbols.
typedef struct orr_navframe_piece {
    orr_time t;     // begin of its first bit
    int64_t length; // ns, to the end of its last
    // LNAV, D1: subframe 1-5; D2: page 1-10 of subframe 1; GLONASS: string 1-15; I/NAV: word type; F/NAV: page type; NavIC:
    // subframe 1-4; CNAV, SBAS, B-CNAV2 and 3: message type; CNAV-2 and B-CNAV1: page of subframe 3.
    uint8_t number;
    // LNAV: page 1-25 of subframes 4 and 5, 0 otherwise (D1: 1-24; D2: page 1-120 of subframe 5); GLONASS: frame 1-5 of the
    // superframe; Galileo: sub-frame 1-24 (I/NAV) or 1-12 (F/NAV) of the frame; NavIC: message of subframes 3 and 4.
    uint8_t page;
    uint16_t bits;                    // or symbols
    uint8_t data[ORR_NAVFRAME_BYTES]; // first bit in time is the highest of data[0]; what is left of the last
                                      // byte is 0
} orr_navframe_piece;

typedef struct orr_navframe {
    orr_sat sat;
    const orr_nav_stream *stream;
    bool coded; // symbols
    orr_time from, to;
    uint8_t n; // pieces
    orr_navframe_piece piece[ORR_NAVFRAME_PIECES];
} orr_navframe;

// What a satellite sends in the frame around an instant.
// Given:
//   set     broadcast data
//   sat     satellite
//   stream  which message on which signal; NULL: the satellite's first (orr_navset_streams)
//   t       instant. Frames begin at multiples of 30 s of GPS time (LNAV; I/NAV on E5b, on E1 a second later) or of UTC
//           (GLONASS) or of BDT (D1, D2), of 50 s (F/NAV), of 48 s (NavIC; CNAV on L2C) and 24 s (on L5),
//           of 18 s (CNAV-2, B-CNAV1), 12 s (B-CNAV2) and 15 s (B-CNAV3, SBAS)
//   coded   symbols as they are modulated: with error correction, interleaving and synchronisation; GLONASS' with relative
//           code, meander and time mark. LNAV is the same either way: parity is part of its bits. Secondary codes are the
//           generator's. Without it bits, with the checks that belong to them (parity, CRC) and tails
// Returned:
//   out     the pieces of the frame that holds t; ephemeris and clock are those on the air at the frame's begin
//   diag    why it failed; may be NULL
// Errors: ORR_E_NODATA where the satellite has no set, ORR_E_RANGE if a value does not fit its field.
orr_status orr_navframe_at(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream, orr_time t,
                           bool coded, orr_navframe *out, orr_diag *diag);

#endif
