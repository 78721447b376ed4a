// SPDX-License-Identifier: GPL-3.0-or-later
// The one gravity that generator and navigator share: normal gravitation (or the user's spherical harmonics)
// plus a made disturbance from a track profile, a map or point masses. A pure function of the place.
#ifndef ORR_INERTIAL_GRAVITY_GRAVITY_H
#define ORR_INERTIAL_GRAVITY_GRAVITY_H

#include "core/earth.h"
#include "inertial/motion/trajectory.h"

#define ORR_MPS2_PER_MGAL 1e-5

typedef struct orr_gravity orr_gravity; // NULL everywhere means: normal gravity alone

typedef struct orr_point_mass {
    orr_vec3 r_m;    // ecef
    double gm_m3ps2; // of the extra mass; negative for a lack of it
} orr_point_mass;

// What to add to normal gravity. Arrays are copied. Maps and profiles are disturbances in mGal, positive
// where gravity is stronger than normal, along the ellipsoidal vertical (the normal of the WGS 84 ellipsoid through
// the place), the same at every height.
typedef struct orr_gravity_parts {
    const orr_gravity_model *model; // instead of normal gravitation; borrowed; NULL: normal
    size_t n_masses;
    const orr_point_mass *mass;
    // A profile along the geodesic of the ellipsoid from (lat0, lon0) on the azimuth (clockwise from North): values at
    // ascending distances, joined by a natural cubic spline (the second derivative is 0 at both ends); the same at any
    // distance across, that is along great circles of the ellipsoid's normals that cross the profile's first one
    // at right angles.
    size_t n_profile; // 0 or at least 3
    double profile_lat_rad, profile_lon_rad, profile_azimuth_rad;
    const double *profile_distance_m, *profile_mgal;
    // A map on ascending latitudes and longitudes (radians; longitudes may run past pi), bicubic: mgal[i_lat
    // * n_lon + i_lon].
    size_t n_lat, n_lon; // 0, or at least 4 each
    const double *map_lat_rad, *map_lon_rad, *map_mgal;
    // Profile and map were carried elsewhere with a trajectory: their values are looked up where a place came from
    // (C of orr_polar_rotation). Point masses stand where they are now.
    bool carried;
    orr_mat3 carried_by;
} orr_gravity_parts;

// Errors: ORR_E_ARG with a sentence (too few points, not ascending by a micrometre, not of the Earth),
// ORR_E_MEMORY.
orr_status orr_gravity_make(const orr_gravity_parts *parts, orr_gravity **out, orr_diag *diag);
// Frees a field; NULL is allowed. The model of spherical harmonics is the caller's.
void orr_gravity_free(orr_gravity *g);
// What it was made of, borrowed from it (for writing it down beside readings). A NULL g has no parts.
orr_gravity_parts orr_gravity_parts_view(const orr_gravity *g);

// Gravitation in ecef axes at an ecef place, m/s^2, without the centrifugal part. Outside a profile or map
// its edge value goes on; orr_gravity_covers tells beforehand.
orr_vec3 orr_gravity_gravitation(const orr_gravity *g, orr_vec3 r_m);
// Gravity disturbance: what the field has over normal gravity, downward along the ellipsoidal vertical, mGal.
double orr_gravity_disturbance_mgal(const orr_gravity *g, orr_vec3 r_m);

// ORR_E_RANGE with the first place and time where the trajectory leaves the profile or the map.
orr_status orr_gravity_covers(const orr_gravity *g, const orr_trajectory *tr, orr_diag *diag);

#endif
