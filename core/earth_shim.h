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
void orr_shim_forward(double lat_deg, double lon_deg, double height_m, double r_m[3]);
void orr_shim_reverse(const double r_m[3], double *lat_deg, double *lon_deg, double *height_m);
void orr_shim_normal_gravitation(const double r_m[3], double g_mps2[3]);
double orr_shim_surface_gravity(double lat_deg);
void orr_shim_geodesic_inverse(double lat1_deg, double lon1_deg, double lat2_deg, double lon2_deg,
                               double *dist_m, double *az1_deg, double *az2_deg);
void orr_shim_geodesic_direct(double lat1_deg, double lon1_deg, double az1_deg, double dist_m,
                              double *lat2_deg, double *lon2_deg, double *az2_deg);

// NULL and a sentence in text[n] if the model cannot be had; *no_memory tells that case apart.
void *orr_shim_gravity_open(const char *name, const char *dir, char *text, size_t n, int *no_memory);
void orr_shim_gravity(const void *model, const double r_m[3], double g_mps2[3]);
void orr_shim_gravity_free(void *model);

#ifdef __cplusplus
}
#endif

#endif
