// SPDX-License-Identifier: GPL-3.0-or-later
// ESRI's ASCII grid: heights of terrain, as digital elevation models such as SRTM's are given out.
#ifndef ORR_INGEST_MAPS_ESRI_GRID_H
#define ORR_INGEST_MAPS_ESRI_GRID_H

#include "core/status.h"
#include "ingest/input/limits.h"

// Nodes at the cells' centres, row by row from the northernmost, each from West to East.
typedef struct orr_esri_grid {
    size_t columns, rows;
    double west_deg, north_deg; // of the first node
    double lon_step_deg, lat_step_deg;
    float *height_m; // [rows][columns]; NAN where the file has none
} orr_esri_grid;

// Reads a grid of geographic coordinates in memory.
//   Given:    name       of the file, for messages
//             text, n    its n bytes, decompressed
//             limits     what is refused; NULL: the defaults
//   Returned: out        the grid, to be freed with orr_esri_grid_free; empty on failure
//             diag       ORR_E_FORMAT (a header without its five keys, fewer or more numbers than it tells, what is no height),
//                        ORR_E_UNSUPPORTED (coordinates that are no degrees: a projection's), ORR_E_LIMIT, ORR_E_MEMORY
//   Reference: Esri ASCII raster format: ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize (or dx and dy),
//              NODATA_value, then the rows
orr_status orr_esri_grid_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                               orr_esri_grid *out, orr_diag *diag);
// The same of a file, which may be compressed. Errors also those of orr_input_read_all.
orr_status orr_esri_grid_read(const char *path, const orr_read_limits *limits, orr_esri_grid *out,
                              orr_diag *diag);
// Frees all and leaves *x empty.
void orr_esri_grid_free(orr_esri_grid *x);

#endif
