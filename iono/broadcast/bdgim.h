// SPDX-License-Identifier: GPL-3.0-or-later
// BeiDou's global ionospheric delay correction model: nine broadcast coefficients and a part that is forecast by a
// table, both spherical harmonics in sun-fixed geomagnetic axes (BDS-SIS-ICD-B1C 1.0, 7.8; Yuan et al. 2019).
#ifndef ORR_IONO_BROADCAST_BDGIM_H
#define ORR_IONO_BROADCAST_BDGIM_H

#include "core/earth.h"
#include "core/time.h"

// Vertical electron content, TECU, over a point of the shell of 400 km, whose latitude and longitude are those of the
// ray's crossing. alpha_tecu are the nine coefficients as broadcast. It may come out negative.
double orr_bdgim_vertical_tecu(const double alpha_tecu[9], orr_time t, double lat_rad, double lon_rad);
// Slant electron content.
//   Given:    alpha_tecu   the nine coefficients
//             t            the instant
//             site         the receiver, geodetic
//             az_rad, el_rad   direction of the satellite
//   Returned: (value)      TECU, at least 0
double orr_bdgim_slant_tecu(const double alpha_tecu[9], orr_time t, orr_geodetic site, double az_rad,
                            double el_rad);

#endif
