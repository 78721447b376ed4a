// SPDX-License-Identifier: GPL-3.0-or-later
// Station coordinates from SINEX files (IERS SINEX 2.02): SITE/ID, SITE/ECCENTRICITY and SOLUTION/ESTIMATE
// blocks; the rest (matrices, normal equations) is passed over.
#ifndef ORR_INGEST_TABLES_SINEX_H
#define ORR_INGEST_TABLES_SINEX_H

#include "core/status.h"
#include "core/time.h"
#include "ingest/input/limits.h"

typedef struct orr_sinex_site {
    char code[10]; // "BOR1" or nine characters
    char point[3]; // "A"
    char domes[10];
    char description[23];
    double lon_deg, lat_deg, height_m; // approximate
} orr_sinex_site;

// Antenna reference point minus marker. Of two systems one is given (UNE or XYZ).
typedef struct orr_sinex_eccentricity {
    char code[10], point[3];
    orr_time from, until; // ORR_TIME_NONE: open
    bool local;           // true: Up, North, East; false: X, Y, Z
    double offset_m[3];
} orr_sinex_eccentricity;

typedef struct orr_sinex_estimate {
    char code[10], point[3], solution[5];
    orr_time epoch;                     // reference epoch
    double pos_m[3], pos_sdev_m[3];     // marker, ecef
    double vel_mps[3], vel_sdev_mps[3]; // m/s (files say m/year); NAN where not estimated
} orr_sinex_estimate;

typedef struct orr_sinex {
    double version;
    char agency[4];
    orr_time from, until; // of the data
    size_t n_sites, n_eccentricities, n_estimates;
    orr_sinex_site *site;
    orr_sinex_eccentricity *eccentricity;
    orr_sinex_estimate *estimate;
} orr_sinex;

// Reads a whole file in memory.
//   Given:    name        of the file, for messages
//             text, n     its n bytes, decompressed
//             limits      what is refused; NULL: the defaults
//   Returned: out         the coordinates, to be freed with orr_sinex_free; empty on failure
//             warnings    complaints that did not stop the reading; may be NULL
//             diag        ORR_E_KIND, ORR_E_FORMAT, ORR_E_LIMIT, ORR_E_MEMORY
orr_status orr_sinex_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                           orr_sinex *out, orr_warnings *warnings, orr_diag *diag);
// Frees all and leaves *x empty.
void orr_sinex_free(orr_sinex *x);

// Marker position at t (velocity applied where estimated) of a station ("BOR1", any case; the first four
// characters of a nine-character name count), from the estimate whose epoch is nearest. ORR_E_NODATA.
orr_status orr_sinex_position(const orr_sinex *x, const char *code, orr_time t, double pos_m[3]);
// The eccentricity valid at t; NULL if there is none.
const orr_sinex_eccentricity *orr_sinex_find_eccentricity(const orr_sinex *x, const char *code, orr_time t);

#endif
