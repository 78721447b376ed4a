// SPDX-License-Identifier: GPL-3.0-or-later
// What an archive holds, how its days join, and which of them look suspicious. Read from the days themselves each time;
// ARCHIVE/catalogue.sqlite keeps it for others' queries and saves what takes time (joints), and can be deleted whenever.
#ifndef ORR_ARCHIVE_CATALOGUE_H
#define ORR_ARCHIVE_CATALOGUE_H

#include "src/archive/record.h"

// How a day's orbits meet those of the day before at midnight.
typedef struct orr_catalogue_joint {
    size_t satellites; // in both; 0: the day before is not there
    double median_mm, max_mm, max_mps;
    orr_sat max_sat;
} orr_catalogue_joint;

typedef struct orr_catalogue_day {
    int32_t mjd;
    orr_status state; // ORR_OK, or why its record cannot be read
    char program[64], key[ORR_SHA256_HEX], sha256[ORR_SHA256_HEX];
    int64_t bytes;
    bool before, after;
    bool predicted; // a part of it: its sigma is not to be compared with others'
    size_t n_notes;
    orr_archive_quality all;
    orr_catalogue_joint joint;
    char suspicion[160]; // why the day looks unusual beside the others; empty where it does not
} orr_catalogue_day;

typedef struct orr_catalogue {
    size_t n;
    orr_catalogue_day *day; // ascending
} orr_catalogue;

// "ok", "predicted", or why its record cannot be read.
const char *orr_catalogue_state(const orr_catalogue_day *d);

// Reads all days and judges them.
// Given:
//   archive   the archive's folder
//   joints    whether the joints are wanted: those that the catalogue does not know are measured
// Returned:
//   out       the days; free with orr_catalogue_free whatever this returned
//   warnings  what is wrong with the catalogue's file, which is made anew then; may be NULL
//   diag      why it failed; may be NULL
// Errors: ORR_E_IO, ORR_E_MEMORY.
orr_status orr_catalogue_make(const char *archive, bool joints, orr_catalogue *out, orr_warnings *warnings,
                              orr_diag *diag);
// Frees it; it is empty then.
void orr_catalogue_free(orr_catalogue *c);

// Joint of two products at an instant that both have.
//   Given:    a, b        paths of the products
//             t           the instant
//   Returned: out         how they meet
//             diag        errors of orr_ephemeris_load
orr_status orr_catalogue_join(const char *a, const char *b, orr_time t, orr_catalogue_joint *out,
                              orr_diag *diag);

// Looks through a day's products: every byte is read.
//   Given:    archive     the archive's folder
//             mjd         the day
//   Returned: diag        ORR_E_NODATA, ORR_E_FORMAT with the file's name (lost, cut or changed)
orr_status orr_catalogue_verify(const char *archive, int32_t mjd, orr_diag *diag);

#endif
