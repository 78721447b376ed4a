// SPDX-License-Identifier: GPL-3.0-or-later
// The eight numbers of the GPS message (IS-GPS-200N 20.3.3.5.2.5 and Figure 20-4; Klobuchar 1987).
#ifndef ORR_IONO_FIELD_KLOBUCHAR_H
#define ORR_IONO_FIELD_KLOBUCHAR_H

#include "core/time.h"

typedef struct orr_klobuchar {
    double alpha[4], beta[4]; // s, s/semicircle, ..; as broadcast
} orr_klobuchar;

// Slant code delay on L1 (1575.42 MHz), metres, for a receiver at geodetic latitude and longitude and a
// satellite at azimuth and elevation (el >= 0). The algorithm's own pierce point, obliquity and 5 ns night.
double orr_klobuchar_delay_m(const orr_klobuchar *k, orr_time t, double lat_rad, double lon_rad,
                             double az_rad, double el_rad);
// The model's vertical delay on L1 at a pierce point, metres (obliquity 1).
double orr_klobuchar_vertical_m(const orr_klobuchar *k, orr_time t, double lat_rad, double lon_rad);

#endif
