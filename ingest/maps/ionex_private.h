// SPDX-License-Identifier: GPL-3.0-or-later
// The IONEX reader's parts among themselves: header, maps, assembly. Private to the ingest room.
#ifndef ORR_INGEST_MAPS_IONEX_PRIVATE_H
#define ORR_INGEST_MAPS_IONEX_PRIVATE_H

#include "core/cursor.h"
#include "ingest/maps/ionex.h"

#define IONEX_MISSING 9999
#define IONEX_PER_LINE 16 // values of I5 in a line
#define IONEX_MAX_AXIS 9999

typedef enum ionex_kind { IONEX_TEC, IONEX_RMS, IONEX_HGT, IONEX_KINDS } ionex_kind;
extern const char *const ionex_kind_name[IONEX_KINDS]; // "TEC", "RMS", "HEIGHT"

// Maps of one kind in file order; value holds n x map_size numbers.
typedef struct ionex_maps {
    size_t n, capacity;
    orr_time *epoch;
    int64_t *number; // as START OF .. MAP says; pairs maps that lack an epoch of their own
    double *value;
} ionex_maps;

typedef struct ionex_reader {
    orr_cursor c;
    orr_ionex *out;
    orr_warnings *warnings;
    orr_diag *diag;
    orr_read_limits limits;
    // Header's grid, {first, last, step} in the file's units (degrees, km).
    double axis[3][3];
    bool have_axis[3], have_exponent;
    int64_t n_maps_declared; // -1 if not told
    orr_time first_declared, last_declared;
    size_t map_size;
    ionex_maps maps[IONEX_KINDS];
    bool end_of_file_seen;
    int last_own_exponent_map; // number of maps seen with an exponent of their own
    size_t negatives, stray;   // values below zero; lines that belong to nothing
    int64_t first_negative_line;
} ionex_reader;

enum { IONEX_AXIS_HEIGHT, IONEX_AXIS_LAT, IONEX_AXIS_LON };

orr_status ionex_read_header(ionex_reader *r);
orr_status ionex_read_maps(ionex_reader *r);

#endif
