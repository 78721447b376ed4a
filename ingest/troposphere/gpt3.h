// SPDX-License-Identifier: GPL-3.0-or-later
// GPT3's grid files (gpt3_5.grd, gpt3_1.grd of TU Wien): what the weather and the mapping functions' first coefficients are over the
// year at points of the Earth.
#ifndef ORR_INGEST_TROPOSPHERE_GPT3_H
#define ORR_INGEST_TROPOSPHERE_GPT3_H

#include "core/status.h"
#include "ingest/input/limits.h"
#include "ingest/troposphere/lattice.h"

// What a point has a season of, in the file's order and in these units.
enum {
    ORR_GPT3_PRESSURE,      // Pa, at the point's height
    ORR_GPT3_TEMPERATURE,   // K
    ORR_GPT3_HUMIDITY,      // specific, kg/kg
    ORR_GPT3_LAPSE,         // K/m
    ORR_GPT3_A_HYDROSTATIC, // of VMF3, for sea level
    ORR_GPT3_A_WET,
    ORR_GPT3_DECREASE,          // water vapour decrease factor
    ORR_GPT3_MEAN,              // mean temperature weighted with water vapour, K
    ORR_GPT3_NORTH_HYDROSTATIC, // gradients, m
    ORR_GPT3_EAST_HYDROSTATIC,
    ORR_GPT3_NORTH_WET,
    ORR_GPT3_EAST_WET,
    ORR_GPT3_SEASONS
};

typedef struct orr_gpt3_point {
    // Mean, then amplitudes of cosine and sine of a year and of half a year, from the first of January.
    float season[ORR_GPT3_SEASONS][5];
    float undulation_m, height_m; // of the geoid above the ellipsoid; of the point above the geoid
} orr_gpt3_point;

typedef struct orr_gpt3 {
    orr_lattice lattice;
    orr_gpt3_point *point; // [lattice.n_lat * lattice.n_lon]
} orr_gpt3;

// Reads a grid in memory.
//   Given:    name       of the file, for messages
//             text, n    its n bytes, decompressed
//             limits     what is refused; NULL: the defaults
//   Returned: out        the grid, to be freed with orr_gpt3_free; empty on failure
//             diag       ORR_E_KIND (GPT2's columns, or none), ORR_E_FORMAT (a line without its 64 numbers, one outside what can be,
//                        points that are no grid), ORR_E_LIMIT, ORR_E_MEMORY
//   Reference: header line of the files; Landskron and Boehm 2018, J. Geod. 92:349
orr_status orr_gpt3_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                          orr_gpt3 *out, orr_diag *diag);
// The same of a file, which may be compressed. Errors also those of orr_input_read_all.
orr_status orr_gpt3_read(const char *path, const orr_read_limits *limits, orr_gpt3 *out, orr_diag *diag);
// Frees all and leaves *x empty.
void orr_gpt3_free(orr_gpt3 *x);

#endif
