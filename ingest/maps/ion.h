// SPDX-License-Identifier: GPL-3.0-or-later
// Bernese .ION files: spherical-harmonic coefficients of the vertical electron content as CODE publishes them
// (Bernese GNSS Software 5.2 documentation, ionosphere files). One file holds a sequence of models. A model
// without a "to" epoch is a snapshot: content is linear in time between neighbouring snapshots, each taken at
// the current sun-fixed longitude.
#ifndef ORR_INGEST_MAPS_ION_H
#define ORR_INGEST_MAPS_ION_H

#include "core/status.h"
#include "core/time.h"
#include "ingest/input/limits.h"

typedef enum orr_ion_type { ORR_ION_LOCAL = 1, ORR_ION_GLOBAL = 2, ORR_ION_STATION = 3 } orr_ion_type;
typedef enum orr_ion_frame { ORR_ION_GEOGRAPHICAL = 1, ORR_ION_GEOMAGNETIC = 2 } orr_ion_frame;
typedef enum orr_ion_sun { ORR_ION_SUN_MEAN = 1, ORR_ION_SUN_TRUE = 2 } orr_ion_sun;
typedef enum orr_ion_mapping {
    ORR_ION_MAP_NONE = 0,
    ORR_ION_MAP_COSZ = 1,
    ORR_ION_MAP_MSLM = 2, // modified single layer (Schaer 1999)
    ORR_ION_MAP_ESM = 3,  // extended slab
} orr_ion_mapping;

// E(beta, s) = sum P_nm(sin beta) (a_nm cos m s + b_nm sin m s), P fully normalised:
// sqrt((2n+1)(2-d0m)(n-m)!/(n+m)!), without the Condon-Shortley phase (Schaer 1999; Bogdanov 2015, eq. (35)).
typedef struct orr_ion_coefficient {
    int degree;      // n
    int order;       // m >= 0: a_nm (cosine); m < 0: b_n|m| (sine)
    double tecu;     // value
    double rms_tecu; // NAN if blank
} orr_ion_coefficient;

// One model. Header lines that a file leaves out are: numbers -1 or NAN, times ORR_TIME_NONE, texts empty.
typedef struct orr_ion_model {
    char title[81];
    char number[33]; // model number / station name as written, e.g. "0351-00"
    orr_ion_type type;
    int max_degree, max_order;
    orr_ion_frame frame;
    orr_ion_sun sun;
    orr_ion_mapping mapping;
    double layer_height_m, layer_height_rms_m; // above a sphere of 6371 km
    double pole_lat_deg, pole_lon_deg;         // geomagnetic North pole, longitude East
    orr_time from, to;                         // to == ORR_TIME_NONE: a snapshot at `from`
    double lat_south_deg, lat_north_deg;       // band covered
    int n_stations, n_satellites;
    double elevation_cutoff_deg, max_tec_tecu;
    char comment[81];
    size_t n_coefficients;
    orr_ion_coefficient *coefficient; // file order: n, then 0, 1, -1, 2, -2 ...
} orr_ion_model;

typedef struct orr_ion {
    size_t n_models;
    orr_ion_model *model; // ascending in `from` (of one type; unordered files are sorted with a warning)
} orr_ion;

// Reads a whole file in memory. Header lines are known by their label (columns 1-48), whatever their order. Labels that
// are not known are warned of. Epochs are in the GPS scale, as all of Bernese.
//   Given:    name        of the file, for messages
//             text, n     its n bytes, decompressed
//             limits      what is refused; NULL: the defaults
//   Returned: out         the models, to be freed with orr_ion_free; empty on failure
//             warnings    complaints that did not stop the reading; may be NULL
//             diag        ORR_E_KIND, ORR_E_FORMAT, ORR_E_LIMIT, ORR_E_MEMORY
orr_status orr_ion_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                         orr_ion *out, orr_warnings *warnings, orr_diag *diag);
// Frees all models and leaves *x empty.
void orr_ion_free(orr_ion *x);

// Makes a model of every coefficient up to degree and order (value 0, rms 0), file order, other fields as
// "not told". The caller frees its coefficients, or gives it to an orr_ion.
orr_status orr_ion_model_alloc(int max_degree, int max_order, orr_ion_model *out, orr_diag *diag);
// Place of (n, m) in the order of orr_ion_model_alloc: n^2 for m = 0, then cosine and sine by turns; only for
// max_order >= max_degree, where all orders up to n are there.
static inline size_t orr_ion_index(int n, int m)
{
    return (size_t)(n * n) + (m == 0 ? 0 : m > 0 ? (size_t)(2 * m - 1) : (size_t)(-2 * m));
}
// Writes all models; lines of untold fields are left out. Values F18.8, RMS F11.4. "-" is stdout. Atomic.
orr_status orr_ion_write(const orr_ion *x, const char *path, orr_diag *diag);

#endif
