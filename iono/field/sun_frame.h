// SPDX-License-Identifier: GPL-3.0-or-later
// The axes in which the ionosphere stands almost still: latitude from the geomagnetic equator, longitude from
// the meridian of the mean Sun. Both coordinates come from one true rotation (Schaer 1999, 4.3): the pole
// moves to the geomagnetic pole, and longitude is the point's geomagnetic longitude minus that of the mean
// Sun. (Geomagnetic latitude with geographic sun-fixed longitude is not a rotation and fits maps badly:
// docs/ionosphere.md.)
#ifndef ORR_IONO_FIELD_SUN_FRAME_H
#define ORR_IONO_FIELD_SUN_FRAME_H

#include "core/time.h"
#include "core/vec.h"

// The pole that Bernese coefficient files name when they use the dipole: 79 N, 71 W. Any pole does for a file
// that names its own; for a refit it only matters between epochs.
#define ORR_GEOMAGNETIC_POLE_LAT_DEG 79.0
#define ORR_GEOMAGNETIC_POLE_LON_DEG (-71.0)

// Geographic longitude of the mean Sun, pi - UT (24 h of UT are 2 pi), UT taken as UTC; in [-pi, pi).
double orr_mean_sun_lon(orr_time t, const orr_leap_table *leap);
// Rows are the geomagnetic axes: z the pole, x in the meridian through the Earth's pole (longitude 0 on the
// far side from it, as usual for dipole coordinates). Acts on geocentric ecef directions.
orr_mat3 orr_geomagnetic_axes(double pole_lat_rad, double pole_lon_rad);
// Geomagnetic longitude of the point of the equator at geographic longitude lon.
double orr_geomagnetic_lon_of_equator(const orr_mat3 *geomagnetic, double lon_rad);
// Axes turned about the pole so that longitude counts from the geomagnetic longitude `from`.
orr_mat3 orr_axes_turned(const orr_mat3 *axes, double from_rad);

#endif
