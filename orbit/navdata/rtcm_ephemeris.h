// SPDX-License-Identifier: GPL-3.0-or-later
// Ephemerides as messages of RTCM 3, as base stations and casters send them.
#ifndef ORR_ORBIT_NAVDATA_RTCM_EPHEMERIS_H
#define ORR_ORBIT_NAVDATA_RTCM_EPHEMERIS_H

#include "ingest/rinex/rinex_nav.h"
#include "orbit/navdata/rtcm_frame.h"

// The number of the message that sends records of a satellite's message: 1019 (GPS LNAV), 1020 (GLONASS), 1041 (NavIC), 1042 (BeiDou
// D1 and D2), 1044 (QZSS LNAV), 1045 (F/NAV), 1046 (I/NAV); 0 for those that RTCM has none for.
int orr_rtcm_number(orr_sat sat, orr_nav_message message);

// An ephemeris as a frame.
// Given:
//   eph    a record; what it does not know (delays, issues) is sent as zero
//   leap   table of leap seconds that GLONASS' calendar goes by; NULL: built-in
// Returned:
//   frame  its data[0 .. n)
//   diag   why it failed; may be NULL
// Errors: ORR_E_ARG where RTCM has no message for it, ORR_E_RANGE with the field's name where a value does not fit.
// Notes: GLONASS' almanac health is told as not available, tau_c and tau_GPS are zero; N_A is the day of t_k.
// Reference: RTCM 10403.3, 3.5.12 and 3.5.13 (1019, 1020), amendments for the others; fields are those of the systems' documents.
orr_status orr_rtcm_ephemeris(const orr_nav_eph *eph, const orr_leap_table *leap, orr_rtcm_frame *frame,
                              orr_diag *diag);

#endif
