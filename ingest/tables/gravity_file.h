// SPDX-License-Identifier: GPL-3.0-or-later
// Gravity disturbances as tables: a profile (distance in m, mGal) or a map (latitude and longitude in
// degrees, mGal, one value at every crossing of its lines, in any order) as text, or a NetCDF map.
#ifndef ORR_INGEST_TABLES_GRAVITY_FILE_H
#define ORR_INGEST_TABLES_GRAVITY_FILE_H

#include "core/status.h"

typedef struct orr_gravity_file {
    size_t n_profile; // 0: a map
    double *distance_m;
    size_t n_lat, n_lon;
    double *lat_rad, *lon_rad; // lat ascends; lon as in the file (text: ascends)
    double *mgal;              // [n_profile], or [n_lat][n_lon]
} orr_gravity_file;

// Reads a profile or a map. Text: two or three numbers a row, divided by commas, semicolons or blanks; a first row without
// any number and lines of '#' are skipped. NetCDF: variables lat and lon (or latitude, longitude, y, x; degrees, on
// dimensions of their names, latitudes in either direction) and disturbance (or gravity_disturbance, mgal) over (lat, lon).
// Whether distances ascend and values can be is for orr_gravity_make to say.
//   Given:    name        of the file, for messages
//             data, n     its n bytes; text may be compressed; nothing is changed in them
//   Returned: out         the profile or map, to be freed with orr_gravity_file_free; empty on failure
//             diag        ORR_E_KIND, ORR_E_FORMAT with the line, ORR_E_LIMIT, ORR_E_MEMORY
orr_status orr_gravity_file_parse(const char *name, const void *data, size_t n, orr_gravity_file *out,
                                  orr_diag *diag);
// Frees all and leaves *f empty.
void orr_gravity_file_free(orr_gravity_file *f);

#endif
