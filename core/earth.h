// SPDX-License-Identifier: GPL-3.0-or-later
// The ellipsoidal Earth (WGS 84 unless told), by GeographicLib through one C++ file; no exception crosses.
// Angles in radians inside the program; latitude positive North, longitude positive East.
#ifndef ORR_CORE_EARTH_H
#define ORR_CORE_EARTH_H

#include "core/status.h"
#include "core/vec.h"

typedef struct orr_geodetic {
    double lat_rad, lon_rad, height_m; // lon in (-pi, pi]
} orr_geodetic;

// Cartesian ecef coordinates of a geodetic place, metres.
orr_vec3 orr_earth_to_ecef(orr_geodetic g);
// The inverse; at the Earth's centre latitude is +pi/2.
orr_geodetic orr_earth_from_ecef(orr_vec3 r_m);
// The upward normal of the ellipsoid that passes through r_m, a unit vector: what from_ecef's angles say, to
// 1e-14 rad above the ground, in a tenth of the time (Bowring 1976, twice).
orr_vec3 orr_earth_up(orr_vec3 r_m);
// Rows are East, North, Up at the point: enu = A (r - r0).
orr_mat3 orr_earth_enu_from_ecef(double lat_rad, double lon_rad);
// Radii of curvature: meridian M and prime vertical N, metres.
void orr_earth_radii(double lat_rad, double *meridian_m, double *normal_m);
// Direction and distance from one point to another.
//   Given:    site_m     the observer, ecef
//             target_m   what is looked at, ecef
//   Returned: az_rad     azimuth clockwise from North, [0, 2 pi)
//             el_rad     elevation above the plane normal to the ellipsoid at the site
//             range_m    distance
void orr_earth_look(orr_vec3 site_m, orr_vec3 target_m, double *az_rad, double *el_rad, double *range_m);

// Normal gravitation of the WGS 84 ellipsoid WITHOUT the centrifugal part, in ecef axes at an ecef point,
// m/s^2 (closed form, GeographicLib NormalGravity::V). Gravity = this + u^2 (x, y, 0).
orr_vec3 orr_earth_normal_gravitation(orr_vec3 r_m);

// The direct problem of geodesy: where a geodesic of given azimuth and length ends.
//   Given:    lat1_rad, lon1_rad   the first point
//             az1_rad              azimuth at it, clockwise from North
//             dist_m               length; negative goes backwards
//   Returned: lat2_rad, lon2_rad   the second point, longitude in (-pi, pi]
//             az2_rad              forward azimuth there
//   Reference: Karney 2013, J. Geodesy 87, 43-55.
void orr_earth_geodesic_direct(double lat1_rad, double lon1_rad, double az1_rad, double dist_m,
                               double *lat2_rad, double *lon2_rad, double *az2_rad);

typedef struct orr_gravity_model orr_gravity_model;
// Opens a spherical-harmonic gravity model in GeographicLib's file format (name.egm + coefficients in folder
// `dir`; NULL: where GeographicLib keeps its own, GEOGRAPHICLIB_GRAVITY_PATH). It is the series and nothing
// else: it also has values below the model's sphere, where it is a continuation that grows with the degree.
// Errors: ORR_E_IO with the library's reason (no such files, no model in them, cut coefficients),
// ORR_E_MEMORY.
orr_status orr_gravity_model_open(const char *name, const char *dir, orr_gravity_model **out, orr_diag *diag);
// The same, of which only terms to `degree` (-1: all) are read and summed.
//   Given:    name, dir   as above
//             degree      highest degree and order; a model that ends before it ends there
//   Returned: out         the model; free with orr_gravity_model_free
//             diag        errors as above
orr_status orr_gravity_model_open_to(const char *name, const char *dir, int degree, orr_gravity_model **out,
                                     orr_diag *diag);
// The highest degree that is summed.
int orr_gravity_model_degree(const orr_gravity_model *m);
// The file (name.egm) that describes the model; its coefficients are in that name with .cof after it. Empty where n is
// too small.
void orr_gravity_model_file(const orr_gravity_model *m, char *path, size_t n);
// Gravitation at an ecef point, m/s^2 in ecef axes, without the centrifugal part.
orr_vec3 orr_gravity_model_gravitation(const orr_gravity_model *m, orr_vec3 r_m);
// NULL is allowed.
void orr_gravity_model_free(orr_gravity_model *m);

typedef struct orr_geoid orr_geoid;
// The height of the geoid over the ellipsoid, from a grid of GeographicLib's (name.pgm in folder `dir`; NULL:
// where GeographicLib keeps its own, GEOGRAPHICLIB_GEOID_PATH), by cubic interpolation. name NULL: egm96-5, or
// the next best that is there. One thread at a time. Errors: ORR_E_IO with the library's reason, ORR_E_MEMORY.
orr_status orr_geoid_open(const char *name, const char *dir, orr_geoid **out, orr_diag *diag);
// Metres to add to a height above sea level; NAN where the file cannot be read.
double orr_geoid_height_m(const orr_geoid *g, double lat_rad, double lon_rad);
const char *orr_geoid_name(const orr_geoid *g); // "egm96-5"
// NULL is allowed.
void orr_geoid_free(orr_geoid *g);

// The Earth's magnetic field: a model of GeographicLib's, or the dipole of the International Geomagnetic Reference Field.
typedef struct orr_magnetic orr_magnetic;
// Opens a model (name.wmm + coefficients in folder `dir`; NULL: where GeographicLib keeps its own, GEOGRAPHICLIB_MAGNETIC_PATH).
// Errors: ORR_E_IO with the library's reason, ORR_E_MEMORY.
orr_status orr_magnetic_open(const char *name, const char *dir, orr_magnetic **out, orr_diag *diag);
// The field at a place, nT, East, North, Up; NAN where the model has none. With m NULL it is the dipole: g10, g11, h11 of IGRF-13 at 2020.0 and
// their rates of change. The dipole is some 10 % off in strength and 10 degrees in direction.
//   Reference: Alken et al. 2021, Earth, Planets and Space 73, 49, table 2.
orr_vec3 orr_magnetic_field_nt(const orr_magnetic *m, double year, orr_geodetic place);
// NULL is allowed.
void orr_magnetic_free(orr_magnetic *m);

#endif
