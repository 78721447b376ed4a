// SPDX-License-Identifier: GPL-3.0-or-later
// What earth.c asks of GeographicLib, in terms that C and C++ share: plain numbers, degrees (GeographicLib's
// unit), and no exception. Only earth.c and earth.cpp include it.
#ifndef ORR_CORE_EARTH_SHIM_H
#define ORR_CORE_EARTH_SHIM_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

// All fill their outputs with NAN where GeographicLib throws.

// Geodetic to ecef coordinates on WGS 84, metres.
void orr_shim_forward(double lat_deg, double lon_deg, double height_m, double r_m[3]);
// Ecef to geodetic coordinates on WGS 84.
void orr_shim_reverse(const double r_m[3], double *lat_deg, double *lon_deg, double *height_m);
// Normal gravitation of WGS 84 in ecef axes, without the centrifugal part.
void orr_shim_normal_gravitation(const double r_m[3], double g_mps2[3]);
// The direct geodesic problem on WGS 84.
//   Given:    lat1_deg, lon1_deg   the first point
//             az1_deg, dist_m      azimuth there, and length
//   Returned: lat2_deg, lon2_deg   the second point
//             az2_deg              forward azimuth there
void orr_shim_geodesic_direct(double lat1_deg, double lon1_deg, double az1_deg, double dist_m,
                              double *lat2_deg, double *lon2_deg, double *az2_deg);

// Opens a gravity model.
//   Given:    name, dir   the model and its folder; dir empty: GeographicLib's own
//             degree      highest degree and order that is read; -1: all
//             n           bytes that `text` has room for
//   Returned: text        the library's reason where the model cannot be had
//             no_memory   1 where the reason is memory, else 0
//             (value)     the model, for the two below; NULL where it cannot be had
void *orr_shim_gravity_open(const char *name, const char *dir, int degree, char *text, size_t n,
                            int *no_memory);
// The degree that is summed.
int orr_shim_gravity_degree(const void *model);
// The file that describes the model, into path[n].
void orr_shim_gravity_file(const void *model, char *path, size_t n);
// Gravitation of a model in ecef axes, without the centrifugal part.
void orr_shim_gravity(const void *model, const double r_m[3], double g_mps2[3]);
// Frees a model; NULL is allowed.
void orr_shim_gravity_free(void *model);
// Opens a geoid of GeographicLib's.
//   Given:    name      of the grid
//             dir       its folder; "": GeographicLib's own
//             n         bytes of text
//   Returned: text      why there is none
//             no_memory whether that was memory
//             NULL if there is none; free with orr_shim_geoid_free
void *orr_shim_geoid_open(const char *name, const char *dir, char *text, size_t n, int *no_memory);
// Height of the geoid over the ellipsoid, m; NAN where the grid cannot be read.
double orr_shim_geoid_height(const void *geoid, double lat_deg, double lon_deg);
// Closes it.
void orr_shim_geoid_free(void *geoid);
// Opens a magnetic model of GeographicLib's.
//   Given:    name      of the model, "wmm2020"
//             dir       its folder; "": GeographicLib's own
//             n         bytes of text
//   Returned: text      why there is none
//             no_memory whether that was memory
//             NULL if there is none; free with orr_shim_magnetic_free
void *orr_shim_magnetic_open(const char *name, const char *dir, char *text, size_t n, int *no_memory);
// The field of a model.
//   Given:    model                       the model
//             year                        with its fraction
//             lat_deg, lon_deg, height_m  the place
//   Returned: enu_nt                      East, North, up, nT; NAN where there is none
void orr_shim_magnetic_field(const void *model, double year, double lat_deg, double lon_deg, double height_m,
                             double enu_nt[3]);
// Closes it; NULL is allowed.
void orr_shim_magnetic_free(void *model);

#ifdef __cplusplus
}
#endif

#endif
