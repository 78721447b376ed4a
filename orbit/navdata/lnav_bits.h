// SPDX-License-Identifier: GPL-3.0-or-later
// LNAV of GPS and QZSS as bits: subframes 1 to 3 of an ephemeris, subframe 4 page 18 (ionosphere and UTC), almanac pages,
// parity (IS-GPS-200N, 20.3; IS-QZSS-PNT-005, 4.1). Pure functions; a subframe is ten words of 30 bits, right-aligned, first bit in
// time the highest.
#ifndef ORR_ORBIT_NAVDATA_LNAV_BITS_H
#define ORR_ORBIT_NAVDATA_LNAV_BITS_H

#include "ingest/rinex/rinex_nav.h"
#include "orbit/navdata/almanac_kepler.h"
#include "orbit/navdata/nav_utc.h"

typedef struct orr_lnav_subframe {
    uint32_t word[10];
} orr_lnav_subframe;

// What TLM and HOW carry besides the subframe's own number.
typedef struct orr_lnav_how {
    uint32_t tow_count; // 6-second epochs of the week at the start of the NEXT subframe, 0..100799 (HOW's
                        // truncated 17 bits)
    bool alert, anti_spoof;
    uint32_t tlm_message; // 14 bits
    int32_t week;         // of subframe 1: the full week it is sent in
    bool qzss;            // pages have QZSS' data ID, and almanacs differ from references of its own
} orr_lnav_how;

// Makes subframe 1, 2 or 3 of a Kepler record.
// Given:
//   eph     GPS or QZSS record
//   number  1 to 3
//   how     TLM and HOW; its week is sent modulo 1024 in subframe 1
// Returned:
//   out     the subframe with its parity
//   diag    why it failed; may be NULL
// Errors: ORR_E_RANGE with the field's name when a value does not fit; ORR_E_ARG for another number or kind of record.
// Notes: the URA index follows from accuracy_m; the fit interval flag is 1 above 4 h, of QZSS above 2 h.
// Reference: IS-GPS-200N 20.3.3.3 and 20.3.3.4.
orr_status orr_lnav_encode_ephemeris(const orr_nav_eph *eph, int number, const orr_lnav_how *how,
                                     orr_lnav_subframe *out, orr_diag *diag);

// Makes subframe 4 page 18: ionosphere and UTC.
// Given:
//   alpha, beta  Klobuchar's coefficients: s, s/semicircle, ...
//   utc          UTC parameters and leap seconds; its reference is a multiple of 4096 s of the week
//   how          TLM and HOW
// Returned:
//   out          the subframe with its parity
//   diag         why it failed; may be NULL
// Errors: ORR_E_RANGE with the field's name, for example "beta1", when a value does not fit.
// Reference: IS-GPS-200N 20.3.3.5.1.6 and 20.3.3.5.1.7.
orr_status orr_lnav_encode_page18(const double alpha[4], const double beta[4], const orr_nav_utc *utc,
                                  const orr_lnav_how *how, orr_lnav_subframe *out, orr_diag *diag);

// Makes the almanac page of one satellite: subframe 5 pages 1 to 24 for satellites 1 to 24, subframe 4 pages 2 to 5 and 7
// to 10 for 25 to 32. QZSS' data ID and the number together are the PRN (193 and on).
// Given:
//   almanac   orbit, clock and health; of QZSS 1 to 10
//   how       TLM and HOW
// Returned:
//   subframe  4 or 5
//   page      1 to 24
//   out       the subframe with its parity
//   diag      why it failed; may be NULL
// Errors: ORR_E_RANGE with the field's name, ORR_E_ARG for another satellite.
// Reference: IS-GPS-200N 20.3.3.5.1.2; IS-QZSS-PNT-005 4.1.2.6.
orr_status orr_lnav_encode_almanac(const orr_almanac *almanac, const orr_lnav_how *how, int *subframe,
                                   int *page, orr_lnav_subframe *out, orr_diag *diag);
// Makes a page of subframe 4 or 5 without content: alternating ones and zeros after its identity.
// Given:
//   subframe  4 or 5
//   sv_id     0 in place of a satellite that does not exist, else the page's own identity of table 20-V (57 for page 1 of
//             subframe 4, ...)
//   how       TLM and HOW
// Returned:
//   out       the subframe with its parity
//   diag      why it failed; may be NULL
// Reference: IS-GPS-200N 20.3.3.5.1.
orr_status orr_lnav_encode_spare(int subframe, uint32_t sv_id, const orr_lnav_how *how,
                                 orr_lnav_subframe *out, orr_diag *diag);
// Makes page 25 of subframe 5 (toa, week, health of satellites 1 to 24) or of subframe 4 (configurations, and health of 25
// to 32).
// Given:
//   number  subframe, 4 or 5
//   toa_s   reference time of the almanac, seconds of week
//   week    its full week
//   config  [32] configurations of satellites 1 to 32 (20.3.3.5.1.4), A-S flag in the highest of four bits; of number 4 alone
//   health  [32] health words of satellites 1 to 32 (QZSS: of 1 to 10, whose page is of subframe 5 alone)
//   how     TLM and HOW
// Returned:
//   out     the subframe with its parity
//   diag    why it failed; may be NULL
// Reference: IS-GPS-200N 20.3.3.5.1.3 and 20.3.3.5.1.4.
orr_status orr_lnav_encode_page25(int number, uint32_t toa_s, int32_t week, const uint8_t config[32],
                                  const uint8_t health[32], const orr_lnav_how *how, orr_lnav_subframe *out,
                                  orr_diag *diag);

#endif
