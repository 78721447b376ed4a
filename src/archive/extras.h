// SPDX-License-Identifier: GPL-3.0-or-later
// What a day of the archive can have beside its orbit: broadcast data fitted to it, the TEC field of the day's maps, and sessions of
// stations. One that cannot be made is noted, and spoils nothing.
#ifndef ORR_ARCHIVE_EXTRAS_H
#define ORR_ARCHIVE_EXTRAS_H

#include "src/archive/inputs_index.h"
#include "src/archive/record.h"

typedef struct orr_archive_extras {
    bool navdata;            // broadcast.rnx
    orr_archive_wants wants; // field.ION; session-NAME.nc of each station
} orr_archive_extras;

// Adds to a planned day's inputs and options what the extras are made from; a map or a station that is missing is noted.
//   Given:    x           what is wanted
//             index       input files, hashed
//             r           the record, planned but for its key
//   Returned: r           with further inputs, words and notes
void orr_archive_extras_plan(const orr_archive_extras *x, const orr_archive_index *index,
                             orr_archive_record *r);

// Makes the extras of a day beside its orbit product.
// Given:
//   x        what is wanted
//   index    input files
//   leap     leap seconds; NULL: built-in
//   folder   the day's, with orbit.nc in it
//   r        the record
// Returned:
//   r        with products, stations and notes
// Errors: ORR_E_IO where a file that was made cannot be read back; failures of extras are notes.
orr_status orr_archive_extras_make(const orr_archive_extras *x, const orr_archive_index *index,
                                   const orr_leap_table *leap, const char *folder, orr_archive_record *r,
                                   orr_diag *diag);

#endif
