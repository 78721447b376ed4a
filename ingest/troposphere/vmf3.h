// SPDX-License-Identifier: GPL-3.0-or-later
// VMF3's files of TU Wien: coefficients of the mapping functions and zenith delays at instants six hours apart, on a grid
// (VMF3_YYYYMMDD.Hhh, V3GR_YYYYMMDD.Hhh with gradients, and the heights of its points) or of stations (*.vmf3_g, *.v3gr_g and
// likewise _r and _d).
#ifndef ORR_INGEST_TROPOSPHERE_VMF3_H
#define ORR_INGEST_TROPOSPHERE_VMF3_H

#include "core/time.h"
#include "ingest/input/limits.h"
#include "ingest/input/sniff.h"
#include "ingest/troposphere/lattice.h"

typedef struct orr_vmf3_values {
    double a_hydrostatic, a_wet; // of the mapping functions
    double hydrostatic_m, wet_m; // zenith delays
    double north_hydrostatic_m, east_hydrostatic_m, north_wet_m,
        east_wet_m; // gradients; NAN where the file has none
} orr_vmf3_values;

// A grid of one instant. Coefficients are for height 0, delays for the heights of the points.
typedef struct orr_vmf3_grid {
    orr_time t;
    orr_lattice lattice;
    bool gradients;
    orr_vmf3_values *point; // [lattice.n_lat * lattice.n_lon]
} orr_vmf3_grid;

// Reads a grid in memory.
//   Given:    name       of the file, for messages
//             text, n    its n bytes, decompressed
//             limits     what is refused; NULL: the defaults
//   Returned: out        the grid, to be freed with orr_vmf3_grid_free; empty on failure
//             diag       ORR_E_FORMAT (no epoch, a line without its 6 or 10 numbers, one outside what can be, points that are no
//                        grid), ORR_E_LIMIT, ORR_E_MEMORY
orr_status orr_vmf3_grid_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                               orr_vmf3_grid *out, orr_diag *diag);
// Frees all and leaves *x empty.
void orr_vmf3_grid_free(orr_vmf3_grid *x);

// Heights of a grid's points above the ellipsoid (orography_ell_5x5, orography_ell_1x1): as many numbers as it has points, in its
// order.
//   Given:    name       of the file, for messages
//             text, n    its n bytes, decompressed
//             points     how many they are
//   Returned: out        [points] heights, m
//             diag       ORR_E_FORMAT (another count, or what is no height of ground)
orr_status orr_vmf3_heights_parse(const char *name, const char *text, size_t n, size_t points, double *out,
                                  orr_diag *diag);

// A station at an instant; all values are for its own height.
typedef struct orr_vmf3_record {
    char station[16];
    orr_time t;
    orr_vmf3_values v;
} orr_vmf3_record;
typedef struct orr_vmf3_sites {
    size_t n;
    orr_vmf3_record *record; // [n] as they stand in the file
} orr_vmf3_sites;

// Appends the records of a file in memory.
//   Given:    name       of the file, for messages
//             text, n    its n bytes, decompressed
//             limits     what is refused; NULL: the defaults
//             out        records so far
//   Returned: out        with those of the file, to be freed with orr_vmf3_sites_free; on failure some may have been added
//             diag       ORR_E_FORMAT (a line without its numbers, one outside what can be, no line), ORR_E_LIMIT, ORR_E_MEMORY
orr_status orr_vmf3_sites_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                                orr_vmf3_sites *out, orr_diag *diag);
// Frees all and leaves *x empty.
void orr_vmf3_sites_free(orr_vmf3_sites *x);

#endif
