// SPDX-License-Identifier: GPL-3.0-or-later
// One day of the archive made. About every midnight the orbits of some hours to either side are smoothed together; a day
// goes over from the solution about its begin to that about its end in the hours around noon. Both days at a midnight take
// it from the same solution, made of the same files: they join to the bit, although each is made on its own.
#ifndef ORR_ARCHIVE_DAY_H
#define ORR_ARCHIVE_DAY_H

#include "src/archive/extras.h"
#include "src/archive/record.h"

typedef struct orr_archive_settings {
    const char *archive; // the folder
    const orr_leap_table *leap;
    orr_archive_extras extras; // beside the orbit
} orr_archive_settings;

// The solution about the midnight that ended the day made last, for the next one. Zero at first.
typedef struct orr_archive_midnight {
    bool there;
    int32_t mjd; // the day that begins with it
    orr_orbit_solution solution;
    orr_warnings warnings; // of its making: both days note them
} orr_archive_midnight;
// Frees it; it is empty then.
void orr_archive_midnight_free(orr_archive_midnight *m);

// What a day is to be made from: everything of the record but its products, quality and notes.
//   Given:    settings    of the batch
//             index       input files, hashed for the day and its neighbours
//             mjd         the day
//   Returned: r           inputs, options and key
//             diag        errors of orr_archive_index_find
orr_status orr_archive_day_plan(const orr_archive_settings *settings, const orr_archive_index *index,
                                int32_t mjd, orr_archive_record *r, orr_diag *diag);
// Whether the archive has the day, made from the same by the same, with products of the size that they were made in; or made of
// observed orbits where predictions are planned.
bool orr_archive_day_is_fresh(const orr_archive_settings *settings, const orr_archive_record *planned);

// Makes a planned day and puts it in its place.
// Given:
//   settings  of the batch
//   index     input files
//   last      what the day before has left; it only saves time
//   r         what orr_archive_day_plan returned
// Returned:
//   last      for the day after
//   r         with products, quality and notes
//   diag      why it failed: nothing of it is left in the archive then
// Errors: those of orr_orbit_solve, orr_ephemeris_build and orr_ephemeris_save, ORR_E_IO.
// Notes: where a neighbour's file cannot be used, the day is made without it, and says so.
orr_status orr_archive_day_make(const orr_archive_settings *settings, const orr_archive_index *index,
                                orr_archive_midnight *last, orr_archive_record *r, orr_diag *diag);

// Puts a day that has been solved in its place: the orbit product, what is wanted beside it, and the record.
// Given:
//   settings  of the batch
//   index     input files, for what is wanted beside the orbit
//   solution  of the day
//   r         what was planned
// Returned:
//   r         with products, quality and notes
//   diag      why it failed: nothing of it is left in the archive then
// Errors: those of orr_ephemeris_build and orr_ephemeris_save, ORR_E_IO.
orr_status orr_archive_day_put(const orr_archive_settings *settings, const orr_archive_index *index,
                               const orr_orbit_solution *solution, orr_archive_record *r, orr_diag *diag);
// Warnings of the making as notes of the record, as many as it has room for.
void orr_archive_note_warnings(orr_archive_record *r, const orr_warnings *w);

#endif
