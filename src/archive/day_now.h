// SPDX-License-Identifier: GPL-3.0-or-later
// The day of the present: observed as far as the newest ultra-rapid orbits are, predicted from there to its end. It is made anew when
// newer ones have come, and gives way to the day that precise orbits make.
#ifndef ORR_ARCHIVE_DAY_NOW_H
#define ORR_ARCHIVE_DAY_NOW_H

#include "src/archive/day.h"
#include "src/make/newest.h"

// What the day is to be made from.
//   Given:    newest      the files to go on from
//             mjd         the day
//   Returned: r           inputs, options and key; marked as predicted
//             diag        ORR_E_IO
orr_status orr_archive_now_plan(const orr_newest *newest, int32_t mjd, orr_archive_record *r, orr_diag *diag);
// Makes it and puts it in its place.
// Given:
//   settings  of the batch, without extras of other inputs than its orbit
//   newest    the files
//   jobs      threads of the smoother
//   r         what orr_archive_now_plan returned
// Returned:
//   r         with products, quality, notes, and until when it was observed
//   diag      why it failed: nothing of it is left in the archive then
// Errors: those of orr_orbit_solve and of orr_archive_day_put; ORR_E_NODATA (nothing reaches into the day).
orr_status orr_archive_now_make(const orr_archive_settings *settings, const orr_newest *newest, int jobs,
                                orr_archive_record *r, orr_diag *diag);

#endif
