// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of a day in the archive: its products, what they were made from, and how good they are. It stands in the
// day's folder as day.json, made of the same values in the same order whatever machine wrote it.
#ifndef ORR_ARCHIVE_RECORD_H
#define ORR_ARCHIVE_RECORD_H

#include "core/sat.h"
#include "core/sha256.h"
#include "core/status.h"
#include "core/time.h"
#include "orbit/smooth/solution.h"
#include "src/archive/inputs_index.h"

#define ORR_ARCHIVE_RECORD "day.json"
#define ORR_ARCHIVE_SCHEMA 1
#define ORR_ARCHIVE_MAX_STATIONS 16
#define ORR_ARCHIVE_MAX_INPUTS (4 + ORR_ARCHIVE_MAX_ERP + ORR_ARCHIVE_MAX_STATIONS)
#define ORR_ARCHIVE_MAX_PRODUCTS (3 + ORR_ARCHIVE_MAX_STATIONS)
#define ORR_ARCHIVE_MAX_NOTES 32

typedef struct orr_archive_file {
    char name[256]; // base name
    char sha256[ORR_SHA256_HEX];
    int64_t bytes; // of products; -1: not told
} orr_archive_file;

// Of all satellites of one system over the day, or of all.
typedef struct orr_archive_quality {
    char system; // letter; '*' for all
    size_t satellites, nodes, left_out, manoeuvres, gaps;
    double residual_mm; // RMS of used nodes, 3-D
    double sigma_mm;    // median of the product's 3-D sigma
} orr_archive_quality;

// Of the session of one station.
typedef struct orr_archive_station {
    char name[8];
    size_t arcs, samples;
    double
        dstec_tecu; // RMS of the field's slant TEC within arcs, against their phases, with the session's correction; NAN without
} orr_archive_station;

typedef struct orr_archive_record {
    int32_t mjd;
    char program[64];         // the maker and its version, "orrery 1.2.3"
    char key[ORR_SHA256_HEX]; // of program, options and inputs: a day with another key is stale
    char options[1024];       // of the batch, in words
    bool before, after;       // whether the day before and the day after were there
    orr_time
        observed_until; // of a day with predictions, which begin there; ORR_TIME_NONE: observed all through
    size_t n_inputs, n_products, n_quality, n_notes;
    orr_archive_file input[ORR_ARCHIVE_MAX_INPUTS], product[ORR_ARCHIVE_MAX_PRODUCTS];
    orr_archive_quality quality[ORR_N_SYSTEMS + 1]; // all first, then systems in the order of satellites
    size_t n_stations;
    orr_archive_station station[ORR_ARCHIVE_MAX_STATIONS];
    char note[ORR_ARCHIVE_MAX_NOTES][256]; // warnings of the making
} orr_archive_record;

// The key of a day.
// Given:
//   program   name and release of the program
//   options   of the batch, in words
//   input     [n] files that the day is made from
//   n         how many
// Returned:
//   key       SHA-256 of all of these
void orr_archive_key(const char *program, const char *options, const orr_archive_file *input, size_t n,
                     char key[ORR_SHA256_HEX]);

// A file that a day is made from, by its base name.
//   Given:    path, sha256     of the file
//   Returned: f                as the record has it
void orr_archive_take_file(orr_archive_file *f, const char *path, const char *sha256);
// A product that stands in the day's folder, with its size and hash.
//   Given:    folder      the day's
//             name        of the file in it
//   Returned: r           with it
//             diag        ORR_E_IO
orr_status orr_archive_note_product(orr_archive_record *r, const char *folder, const char *name,
                                    orr_diag *diag);

// How good a day is, from its solution, into r->quality.
void orr_archive_judge(const orr_orbit_solution *s, orr_archive_record *r);

// Writes day.json into a folder. ORR_E_IO, ORR_E_MEMORY.
orr_status orr_archive_record_write(const orr_archive_record *r, const char *folder, orr_diag *diag);
// Whether a part of the day was predicted.
static inline bool orr_archive_is_predicted(const orr_archive_record *r)
{
    return r->observed_until != ORR_TIME_NONE;
}
// Reads it. ORR_E_NODATA where there is none, ORR_E_UNSUPPORTED (of a later schema), ORR_E_FORMAT.
orr_status orr_archive_record_read(const char *folder, orr_archive_record *r, orr_diag *diag);

#endif
