// SPDX-License-Identifier: GPL-3.0-or-later
// GLONASS FDMA navigation message as bits: strings 1 to 15 with their check bits (GLONASS ICD L1/L2 edition
// 5.1, 2008, section 4). Relative code, meander and time mark are the modulator's. Pure functions.
//
// A string has 85 bits, numbered 85 (sent first, always 0) down to 1: number of the string in 84-81, data,
// check bits in 8-1. Values with a sign are sent as sign and magnitude. Errors of all encoders: ORR_E_RANGE
// with the word's name when a value does not fit its field, ORR_E_ARG where the string cannot be of that
// kind.
#ifndef ORR_ORBIT_NAVDATA_GLONASS_BITS_H
#define ORR_ORBIT_NAVDATA_GLONASS_BITS_H

#include "ingest/rinex/rinex_nav.h"
#include "orbit/navdata/almanac_glonass.h"
#include "orbit/navdata/glonass_time.h"

typedef struct orr_glonass_string {
    uint8_t data[11]; // bit 85 is the highest of data[0]; the lowest three of data[10] are 0
} orr_glonass_string;

// What strings 1 to 4 carry beside an ephemeris; names are the ICD's (table 4.5).
typedef struct orr_glonass_immediate {
    orr_time t_k;               // begin of the frame: second 0 or 30 of a UTC minute
    int p1_min;                 // P1: time between sets, 0, 30, 45 or 60 min
    bool p3;                    // five almanacs in this frame (frames 1 to 4), not four
    bool p4;                    // ephemeris or clock are new
    int p;                      // P: 0..3, where tau_c and tau_GPS were computed (3: on board)
    int m;                      // M: 0 GLONASS, 1 GLONASS-M
    bool l_n;                   // the satellite is unfit
    int f_t;                    // F_T: 0..15, index of accuracy (table 4.4)
    int e_n_days;               // E_n: 0..31, age of the data
    const orr_leap_table *leap; // that the calendar goes by; NULL: built-in
} orr_glonass_immediate;

// What a record itself says of them: E_n (31 where it does not), F_T (15: none), l_n by its health word; M,
// P, P1 and P4 by the status flags of RINEX 3.05, or else 1, 0, 30 min and 0. P3 follows from t_k
// (orr_glonass_frame). leap may be NULL: built-in.
void orr_glonass_immediate_of(const orr_nav_eph *eph, orr_time t_k, const orr_leap_table *leap,
                              orr_glonass_immediate *out);

// Makes string 1, 2, 3 or 4 of a GLONASS satellite's own data.
// Given:
//   eph     GLONASS record; its toe is t_b, a multiple of 15 min of the day in Moscow (15 to 1425 min) within half a day
//           of im->t_k
//   im      frame time, flags and accuracy
//   string  1 to 4
// Returned:
//   out     the string with its check bits
//   diag    why it failed; may be NULL
// Notes: P2 is the oddness of t_b, N_T the day in Moscow of t_k; tau_n = -af0, gamma_n = af1, delta tau_n is 0 where the
// record has none (the field has no "unknown"), B_n is 0 where the health word is 0, else 4 (the malfunction bit).
// Reference: GLONASS ICD L1/L2 edition 5.1, 2008, 4.4 and table 4.5.
orr_status orr_glonass_encode_immediate(const orr_nav_eph *eph, const orr_glonass_immediate *im, int string,
                                        orr_glonass_string *out, orr_diag *diag);

// String 5: time scales.
typedef struct orr_glonass_time {
    orr_time t_k;         // N_4 is of its day in Moscow
    orr_time almanac_day; // any instant of the day in Moscow that the almanacs are of: N_A
    double tau_c_s;       // GLONASS time to UTC(SU): T_UTC = T_GLONASS + tau_c (less three hours)
    double tau_gps_s;     // T_GPS - T_GLONASS = whole seconds + tau_GPS
    bool l_n;
    const orr_leap_table *leap; // that the calendar goes by; NULL: built-in
} orr_glonass_time;
// Makes string 5 of a frame. ORR_E_RANGE with the word's name where a correction does not fit its field.
// Reference: GLONASS ICD L1/L2 edition 5.1, 2008, 4.5.
orr_status orr_glonass_encode_time(const orr_glonass_time *time, orr_glonass_string *out, orr_diag *diag);

// Makes one of strings 6 to 15: half an almanac, the even string first.
// Given:
//   almanac  the satellite that is described; NULL: an empty almanac (satellite 0, C_n 0)
//   string   6 to 15; its parity tells which half is meant
//   l_n      the transmitting satellite is unfit
// Returned:
//   out      the string with its check bits
//   diag     why it failed; may be NULL
// Reference: GLONASS ICD L1/L2 edition 5.1, 2008, 4.5.
orr_status orr_glonass_encode_almanac(const orr_glonass_almanac *almanac, int string, bool l_n,
                                      orr_glonass_string *out, orr_diag *diag);

// Strings 14 and 15 of the fifth frame.
typedef struct orr_glonass_utc {
    double b1_s;         // B1: UT1 - UTC at the begin of the almanac's day
    double b2_s_per_day; // B2: its change
    int kp;              // KP: leap second at the end of the quarter: 0 none, 1 inserted, -1 left out
} orr_glonass_utc;
// Makes string 14 or 15 of the fifth frame: UT1, and the leap second to come.
// Given:
//   utc     B1, B2 and KP
//   string  14 or 15
//   l_n     the transmitting satellite is unfit
// Returned:
//   out     the string with its check bits
//   diag    why it failed; may be NULL
// Reference: GLONASS ICD L1/L2 edition 5.1, 2008, 4.5.
orr_status orr_glonass_encode_utc(const orr_glonass_utc *utc, int string, bool l_n, orr_glonass_string *out,
                                  orr_diag *diag);

#endif
