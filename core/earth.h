// SPDX-License-Identifier: GPL-3.0-or-later
// The ellipsoidal Earth (WGS 84 unless told), by GeographicLib through one C++ file; no exception crosses.
// Angles in radians inside the program; latitude positive North, longitude positive East.
#ifndef ORR_CORE_EARTH_H
#define ORR_CORE_EARTH_H

#include "core/status.h"
#include "core/vec.h"

#define ORR_WGS84_A_M 6378137.0
#define ORR_WGS84_F (1.0 / 298.257223563)
#define ORR_WGS84_E2 (ORR_WGS84_F * (2.0 - ORR_WGS84_F))
#define ORR_WGS84_GM 3.986004418e14

typedef struct orr_geodetic {
    double lat_rad, lon_rad, height_m; // lon in (-pi, pi]
} orr_geodetic;

orr_vec3 orr_earth_to_ecef(orr_geodetic g);
orr_geodetic orr_earth_from_ecef(orr_vec3 r_m);
// The upward normal of the ellipsoid that passes through r_m, a unit vector: what from_ecef's angles say, to
// 1e-14 rad above the ground, in a tenth of the time (Bowring 1976, twice).
orr_vec3 orr_earth_up(orr_vec3 r_m);
// Rows are East, North, Up at the point: enu = A (r - r0).
orr_mat3 orr_earth_enu_from_ecef(double lat_rad, double lon_rad);
// Radii of curvature: meridian M and prime vertical N, metres.
void orr_earth_radii(double lat_rad, double *meridian_m, double *normal_m);
// Azimuth clockwise from North [0, 2 pi), elevation above the ellipsoidal horizon, range, of `target` from
// `site` (ecef).
void orr_earth_look(orr_vec3 site_m, orr_vec3 target_m, double *az_rad, double *el_rad, double *range_m);

// Normal gravitation of the WGS 84 ellipsoid WITHOUT the centrifugal part, in ecef axes at an ecef point,
// m/s^2 (closed form, GeographicLib NormalGravity::V). Gravity = this + u^2 (x, y, 0).
orr_vec3 orr_earth_normal_gravitation(orr_vec3 r_m);
// Somigliana's surface normal gravity, m/s^2.
double orr_earth_surface_gravity(double lat_rad);

// Geodesic (inverse and direct problem on the ellipsoid); azimuths clockwise from North.
void orr_earth_geodesic_inverse(double lat1_rad, double lon1_rad, double lat2_rad, double lon2_rad,
                                double *dist_m, double *az1_rad, double *az2_rad);
void orr_earth_geodesic_direct(double lat1_rad, double lon1_rad, double az1_rad, double dist_m,
                               double *lat2_rad, double *lon2_rad, double *az2_rad);

// A spherical-harmonic gravity model in GeographicLib's file format (name.egm + coefficients in folder
// `dir`; NULL: where GeographicLib keeps its own, GEOGRAPHICLIB_GRAVITY_PATH). It is the series and nothing
// else: it also has values below the model's sphere, where it is a continuation that grows with the degree.
// Errors: ORR_E_IO with the library's reason (no such files, no model in them, cut coefficients),
// ORR_E_MEMORY.
typedef struct orr_gravity_model orr_gravity_model;
orr_status orr_gravity_model_open(const char *name, const char *dir, orr_gravity_model **out, orr_diag *diag);
orr_vec3 orr_gravity_model_gravitation(const orr_gravity_model *m,
                                       orr_vec3 r_m); // without the centrifugal part, ecef
void orr_gravity_model_free(orr_gravity_model *m);

#endif
