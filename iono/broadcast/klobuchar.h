// SPDX-License-Identifier: GPL-3.0-or-later
// The eight numbers of the GPS message (IS-GPS-200N 20.3.3.5.2.5 and Figure 20-4; Klobuchar 1987).
#ifndef ORR_IONO_BROADCAST_KLOBUCHAR_H
#define ORR_IONO_BROADCAST_KLOBUCHAR_H

#include "core/time.h"

typedef struct orr_klobuchar {
    double alpha[4], beta[4]; // s, s/semicircle, ..; as broadcast
} orr_klobuchar;

// Slant code delay on L1 (1575.42 MHz) by the broadcast model.
// Given:
//   k                 coefficients
//   t                 instant; the model takes its GPS second of the day
//   lat_rad, lon_rad  receiver, geodetic
//   az_rad, el_rad    satellite, el >= 0
// Returned: the delay, m.
// Notes: pierce point, obliquity and the 5 ns of the night are the algorithm's own.
// Reference: IS-GPS-200N 20.3.3.5.2.5; Klobuchar 1987.
double orr_klobuchar_delay_m(const orr_klobuchar *k, orr_time t, double lat_rad, double lon_rad,
                             double az_rad, double el_rad);
// The model's vertical delay on L1 at a pierce point, metres (obliquity 1).
double orr_klobuchar_vertical_m(const orr_klobuchar *k, orr_time t, double lat_rad, double lon_rad);

// BeiDou's model of eight numbers, which is another one: a cosine whose longest period is 172800 s, the geographic
// latitude of the crossing at 375 km without its sign, a thin shell's obliquity (BDS-SIS-ICD-B1I 3.0, 5.2.4.7).
//   Given:    k               the numbers as D1 and D2 broadcast them
//             t               the instant
//             lat_rad, lon_rad   the receiver, geodetic
//             az_rad, el_rad  direction of the satellite
//   Returned: (value)         slant code delay on B1I (1561.098 MHz), m
double orr_klobuchar_beidou_delay_m(const orr_klobuchar *k, orr_time t, double lat_rad, double lon_rad,
                                    double az_rad, double el_rad);
// Its vertical delay on B1I at a pierce point, m.
double orr_klobuchar_beidou_vertical_m(const orr_klobuchar *k, orr_time t, double lat_rad, double lon_rad);

#endif
