// SPDX-License-Identifier: GPL-3.0-or-later
// IONEX ionosphere maps, versions 1.0 and 1.1 (Schaer, Gurtner and Feltens 1998, "IONEX: The IONosphere Map
// EXchange Format Version 1"). The format labels its maps in UT: epoch[] is GPS scale like every instant in
// the program, so a daily file of today starts 18 s after midnight GPS and ends 18 s after the next; who
// evaluates at 00:00:00 GPS should hold the edge map for that long. Missing values (9999) are NAN.
#ifndef ORR_INGEST_MAPS_IONEX_H
#define ORR_INGEST_MAPS_IONEX_H

#include "core/sat.h"
#include "core/status.h"
#include "core/time.h"
#include "ingest/input/limits.h"

typedef enum orr_ionex_mapping { // MAPPING FUNCTION
    ORR_IONEX_MAP_UNKNOWN,
    ORR_IONEX_MAP_NONE, // "NONE": none adopted, or one the format has no word for (CODE: MSLM)
    ORR_IONEX_MAP_COSZ, // 1/cos z
    ORR_IONEX_MAP_QFAC, // Q-factor
} orr_ionex_mapping;

// One line of an auxiliary block of differential code biases (P1-P2 unless a comment of the file names
// others).
typedef struct orr_ionex_dcb {
    orr_sat sat;      // ORR_SAT_NONE for a station
    char system;      // 'G', 'R', 'E' ... ; for a station the system its bias belongs to
    char station[32]; // "BOR1 12205M002", as written; empty for a satellite
    double bias_s, rms_s;
} orr_ionex_dcb;

typedef struct orr_ionex {
    double version;     // 1.0, 1.1
    char type;          // 'I'
    char technique[21]; // "GPS", "GNSS", "MIX", "TOPEX", ... as written
    char program[21], run_by[21], date[21];
    orr_ionex_mapping mapping;
    char mapping_text[5];         // as written
    double elevation_cutoff_deg;  // NAN if not told
    char observables[61];         // OBSERVABLES USED
    int n_stations, n_satellites; // as the header says, -1 if not told
    double base_radius_m;
    int dimension;     // MAP DIMENSION 2 or 3
    int exponent;      // header's, -1 if not told: a value v means v 10^exponent TECU
    double interval_s; // header's; 0 where it varies
    // The grid. Maps are [epoch][height][lat][lon], lon fastest; strides follow from the counts.
    size_t n_epochs, n_heights, n_lats, n_lons;
    orr_time *epoch;             // strictly ascending
    double *height_m;            // above base_radius_m; one for two-dimensional maps
    double *lat_deg;             // geocentric, in the file's order (usually 87.5 down to -87.5)
    double *lon_deg;             // East, in the file's order (usually -180 to 180, both ends present)
    double *tec_tecu, *rms_tecu; // NULL where the file has no such maps; NAN where a value is missing
    double *hgt_m;               // height maps: height of the layer above base_radius_m; NULL without them
    size_t n_dcbs;
    orr_ionex_dcb *dcb;
    size_t n_descriptions, n_comments;
    char **description, **comment; // trailing blanks stripped; comments of the header
    const orr_leap_table *leap;    // of labels in UTC; borrowed; NULL: built-in
} orr_ionex;

// Index of a grid point into tec_tecu, rms_tecu, hgt_m.
//   Given:    x           the maps
//             epoch, height, lat, lon   indices along the axes, each from 0
static inline size_t orr_ionex_index(const orr_ionex *x, size_t epoch, size_t height, size_t lat, size_t lon)
{
    return ((epoch * x->n_heights + height) * x->n_lats + lat) * x->n_lons + lon;
}

// Reads a whole file in memory. "24:00" is the next day's 00:00; of two maps at one
// instant the first is kept, with a warning; maps out of order are sorted, with one.
//   Given:    name        of the file, for messages
//             text, n     its n bytes, decompressed
//             limits      what is refused; NULL: the defaults
//   Returned: out         the maps, to be freed with orr_ionex_free; empty on failure
//             warnings    complaints that did not stop the reading; may be NULL
//             diag        ORR_E_KIND (not an IONEX), ORR_E_FORMAT, ORR_E_LIMIT, ORR_E_MEMORY
orr_status orr_ionex_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                           orr_ionex *out, orr_warnings *warnings, orr_diag *diag);
// Frees all and leaves *x empty.
void orr_ionex_free(orr_ionex *x);

// Makes an empty file on a regular grid, maps all NAN.
//   Given:    n_epochs    number of maps
//             t0, step_s  epochs from t0 every step_s seconds (overwrite epoch[] for irregular ones)
//             lat_deg, lon_deg, height_m   the axes as {first, last, step}; a zero step (first == last) means
//                         one value
//             with_rms    allocates rms_tecu too
//   Returned: out         the file, to be freed with orr_ionex_free
//             diag        ORR_E_ARG, ORR_E_LIMIT (more than 9999 points on an axis), ORR_E_MEMORY
orr_status orr_ionex_alloc(size_t n_epochs, orr_time t0, double step_s, const double lat_deg[3],
                           const double lon_deg[3], const double height_m[3], bool with_rms, orr_ionex *out,
                           orr_diag *diag);
// Writes version 1.0 with out->exponent, values rounded to its unit, NAN as 9999; a value of more than 5
// columns is refused (ORR_E_RANGE names the exponent that would do). Grids must be regular. "-" is stdout.
// Atomic.
orr_status orr_ionex_write(const orr_ionex *x, const char *path, orr_diag *diag);

#endif
