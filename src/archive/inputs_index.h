// SPDX-License-Identifier: GPL-3.0-or-later
// A folder of input files, looked through once: which precise orbits are there of which day. Files are told by their first
// lines, whatever their names.
#ifndef ORR_ARCHIVE_INPUTS_INDEX_H
#define ORR_ARCHIVE_INPUTS_INDEX_H

#include "core/sha256.h"
#include "core/status.h"
#include "core/time.h"

#define ORR_ARCHIVE_MAX_ERP 13 // beside the files of a day and its neighbours

typedef struct orr_archive_input {
    int32_t mjd; // the day that it begins in
    char *path;
    char sha256[ORR_SHA256_HEX]; // empty until orr_archive_index_hash
    size_t station;              // of observations: which of the wanted stations
} orr_archive_input;

// What else days are made from, if it is wanted.
typedef struct orr_archive_wants {
    const char *maps; // pattern of the names of TEC fields (IONEX, .ION); NULL: none are wanted
    const char *const
        *station; // [n_stations] first letters of the markers of observations that are wanted, upper case
    size_t n_stations;
} orr_archive_wants;

typedef struct orr_archive_index {
    orr_archive_input *item; // ascending in day, then in path
    size_t n;
    orr_archive_input *map, *obs; // likewise TEC fields, and observations of the wanted stations
    size_t n_maps, n_obs;
    orr_archive_input *erp; // [n_erp] Earth rotation parameters for all days, hashed; their mjd means nothing
    size_t n_erp;
    size_t n_other; // files of other kinds, or with days of prediction in them
} orr_archive_index;

// Looks through a folder and all below it for SP3 files of one day (up to 30 h: some have both midnights).
// Given:
//   folder    where
//   name      shell pattern that base names of SP3 files have to match; NULL: all
//   wants     what else is looked for; NULL: nothing
//   leap      for files dated in UTC; NULL: built-in
// Returned:
//   out       the files; free with orr_archive_index_free whatever this returned
//   warnings  files that cannot be read
//   diag      why it failed; may be NULL
// Errors: ORR_E_IO (the folder cannot be read), ORR_E_MEMORY.
orr_status orr_archive_index_make(const char *folder, const char *name, const orr_archive_wants *wants,
                                  const orr_leap_table *leap, orr_archive_index *out, orr_warnings *warnings,
                                  orr_diag *diag);
// The same of files that are named.
// Given:
//   path      [n] files
//   n         how many
//   wants     what else is taken; NULL: nothing
//   leap      as above
// Returned:
//   out       the files; free with orr_archive_index_free whatever this returned
//   warnings  files that cannot be read
//   diag      why it failed; may be NULL
// Errors: ORR_E_MEMORY.
orr_status orr_archive_index_of(const char *const *path, size_t n, const orr_archive_wants *wants,
                                const orr_leap_table *leap, orr_archive_index *out, orr_warnings *warnings,
                                orr_diag *diag);
// Adds a file of Earth rotation parameters. ORR_E_LIMIT (more than ORR_ARCHIVE_MAX_ERP), ORR_E_IO, ORR_E_MEMORY.
orr_status orr_archive_index_add_erp(orr_archive_index *x, const char *path, orr_diag *diag);
// Frees all; it is empty then.
void orr_archive_index_free(orr_archive_index *x);

// The day's file. ORR_E_NODATA where there is none; ORR_E_ARG where there are several, which are named.
//   Given:    x           the index
//             mjd         the day
//   Returned: input       the file, borrowed from x; NULL on failure
//             diag        the sentence
orr_status orr_archive_index_find(const orr_archive_index *x, int32_t mjd, const orr_archive_input **input,
                                  orr_diag *diag);
// The day's TEC field; errors as above.
//   Given:    x           the index
//             mjd         the day
//   Returned: map         the file, borrowed from x; NULL on failure
//             diag        the sentence
orr_status orr_archive_index_find_map(const orr_archive_index *x, int32_t mjd, const orr_archive_input **map,
                                      orr_diag *diag);
// The day's observations of a station; NULL where there are none. Of several files the first by name is taken.
const orr_archive_input *orr_archive_index_find_obs(const orr_archive_index *x, int32_t mjd, size_t station);
// Hashes the files of days first to last.
//   Given:    x           the index
//             first, last modified Julian days
//   Returned: x           with sha256 filled
//             diag        ORR_E_IO
orr_status orr_archive_index_hash(orr_archive_index *x, int32_t first, int32_t last, orr_diag *diag);

#endif
