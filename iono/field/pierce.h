// SPDX-License-Identifier: GPL-3.0-or-later
// One ray through a thin shell: where it pierces, how much longer it is than the vertical, what the electrons
// on it do to a carrier.
#ifndef ORR_IONO_FIELD_PIERCE_H
#define ORR_IONO_FIELD_PIERCE_H

#include "core/earth.h"
#include "core/status.h"
#include "core/vec.h"

// The shell of the IGS maps: 6371 km + 450 km (Schaer 1999; IONEX headers).
#define ORR_SHELL_RADIUS_M (ORR_EARTH_MEAN_RADIUS_M + 450e3)

// A receiver: its place and its local axes (ellipsoidal vertical).
typedef struct orr_iono_site {
    orr_vec3 pos_m;           // ecef
    orr_vec3 east, north, up; // unit vectors, ecef
    orr_geodetic geodetic;
} orr_iono_site;
// The origin and points below 6.2e6 m from it are no receiver: ORR_E_ARG.
orr_status orr_iono_site_at(orr_vec3 pos_m, orr_iono_site *out, orr_diag *diag);

// Where a ray leaves the shell.
typedef struct orr_pierce {
    double az_rad, el_rad;   // clockwise from North [0, 2 pi); above the ellipsoidal horizon
    double lat_rad, lon_rad; // GEOCENTRIC latitude (as maps on a sphere use), longitude (-pi, pi]
    orr_vec3 unit;           // the same as a unit vector, ecef
} orr_pierce;

// Pierce point of the straight ray from a receiver to a satellite, exact.
// Given:
//   site            receiver
//   sat_m           satellite, ecef
//   shell_radius_m  of the sphere, from the Earth's centre
// Returned:
//   out             azimuth, elevation and pierce point
//   diag            why there is none; may be NULL
// Errors: ORR_E_RANGE when the satellite is below the ellipsoidal horizon or the receiver is not inside the shell.
orr_status orr_pierce_ray(const orr_iono_site *site, orr_vec3 sat_m, double shell_radius_m, orr_pierce *out,
                          orr_diag *diag);
// Pierce point of a ray in a given direction.
// Given:
//   site            receiver
//   az_rad          clockwise from North
//   el_rad          above the ellipsoidal horizon
//   shell_radius_m  of the sphere, from the Earth's centre
// Returned:
//   out             azimuth, elevation and pierce point
//   diag            why there is none; may be NULL
// Errors: as orr_pierce_ray.
orr_status orr_pierce_direction(const orr_iono_site *site, double az_rad, double el_rad,
                                double shell_radius_m, orr_pierce *out, orr_diag *diag);

// Mapping functions: slant over vertical TEC, a function of the elevation at the receiver.
typedef enum orr_mapping_kind {
    ORR_MAPPING_NONE,       // 1: what is asked for is vertical
    ORR_MAPPING_THIN_SHELL, // 1/cos z', sin z' = R/(R+H) sin z with R = 6371 km, H = 450 km (Schaer 1999, eq.
                            // (2.20))
    ORR_MAPPING_MSLM, // sin z' = R/(R+H) sin(alpha z), H = 506.7 km, alpha = 0.9782: fits JPL's extended slab
} orr_mapping_kind;   // model up to 10 degrees (AIUB; headers of CODE's maps)
typedef struct orr_mapping {
    orr_mapping_kind kind;
    double ratio; // R / (R + H)
    double alpha;
} orr_mapping;
// The mapping function of a kind with its published constants.
orr_mapping orr_mapping_published(orr_mapping_kind kind);
// "none", "thin-shell" or "mslm"; ORR_E_ARG for any other name.
orr_status orr_mapping_parse(const char *name, orr_mapping_kind *out, orr_diag *diag);
// 1 at the zenith, growing to the horizon. NAN for an elevation outside [0, pi/2].
double orr_mapping_factor(const orr_mapping *m, double el_rad);

#define ORR_IONO_K_M3_PER_S2 40.3e16 // metres of delay for one TECU (1e16 electrons/m^2) at 1 Hz, times Hz^2
// Second order of a code's delay: metres for one TECU and a magnetic field of 1 T along the signal's way at 1 Hz, times Hz^3.
// Bassiri and Hajj 1993, Manuscripta Geodaetica 18:280; IERS Conventions 2010, 9.4.1: 1.1284e12 for a phase, twice that for a code.
#define ORR_IONO_SECOND_M4_PER_S3_T 2.2568e28
typedef enum orr_measurement { ORR_MEASURES_CODE, ORR_MEASURES_PHASE } orr_measurement;
// 40.3e16 E / f^2 metres for a slant content of E TECU: positive for a code, which is late by so much, negative for a
// phase, which is early (Bogdanov 2015, eq. (36)).
static inline double orr_iono_delay_m(double tec_tecu, double freq_hz, orr_measurement what)
{
    double d = ORR_IONO_K_M3_PER_S2 * tec_tecu / (freq_hz * freq_hz);
    return what == ORR_MEASURES_PHASE ? -d : d;
}

#endif
