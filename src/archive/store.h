// SPDX-License-Identifier: GPL-3.0-or-later
// The archive as a folder. A day stands in ARCHIVE/yyyy/ddd (year and day of the year, GPS time): its products and day.json,
// which says what they are and what they were made from. A day is done or absent: it is made in a folder beside, its files
// are written to disk, and the folder gets its name in one step. Nothing else is truth; what is derived from it (the
// catalogue) can be thrown away.
#ifndef ORR_ARCHIVE_STORE_H
#define ORR_ARCHIVE_STORE_H

#include <stdio.h>

#include "core/status.h"
#include "core/time.h"

#define ORR_ARCHIVE_PATH 1024
#define ORR_ARCHIVE_DAY_TEXT 16

// A day is the modified Julian day of its midnight in GPS time.
static inline orr_time orr_archive_day_begin(int32_t mjd)
{
    return orr_time_from_mjd(mjd, 0, ORR_SCALE_GPS, NULL);
}
// The day that an instant lies in.
int32_t orr_archive_day_of(orr_time t);
// "2024-035"; returns buf.
char *orr_archive_day_text(int32_t mjd, char buf[ORR_ARCHIVE_DAY_TEXT]);

// The path of a day's folder, or of a file in it; returns buf.
//   Given:    archive     the archive's folder
//             mjd         the day
//             file        name within the day's folder; NULL: the folder itself
//   Returned: buf         the path, cut where it is longer than the buffer
char *orr_archive_path(const char *archive, int32_t mjd, const char *file, char buf[ORR_ARCHIVE_PATH]);

// Makes the archive's folder if there is none, and looks whether it can be written to. ORR_E_IO.
orr_status orr_archive_open(const char *archive, orr_diag *diag);

// One batch at a time on a machine. *lock is a file descriptor that holds it, to be closed to give it up.
// ORR_E_LIMIT where another process has it, with its number.
orr_status orr_archive_lock(const char *archive, int *lock, orr_diag *diag);

// A folder to make a day in, beside its place; its name tells the machine and the process. An old one of that name is removed.
//   Given:    archive     the archive's folder
//             mjd         the day
//   Returned: staging     the folder's path
//             diag        ORR_E_IO
orr_status orr_archive_stage(const char *archive, int32_t mjd, char staging[ORR_ARCHIVE_PATH],
                             orr_diag *diag);
// Gives a finished folder its name: files and folders are on disk before, and a day that was there is replaced in one step.
//   Given:    archive     the archive's folder
//             mjd         the day
//             staging     the folder that orr_archive_stage made
//   Returned: diag        ORR_E_IO
//   Notes:    on failure the old day stands, and the staging folder too.
orr_status orr_archive_commit(const char *archive, int32_t mjd, const char *staging, orr_diag *diag);
// Removes a folder with all files in it (no folder below it).
void orr_archive_remove(const char *folder);

// What is in an archive's folder but no day of it: called with the path and whether a process that no longer lives left it.
typedef void orr_archive_stray(void *user, const char *path, bool leftover);
// Removes the folders that ended processes of this machine have left; tells every leftover, and everything unknown.
//   Given:    archive     the archive's folder
//             sweep       whether leftovers are removed
//             tell, user  called for each; may be NULL
//   Returned: diag        ORR_E_IO
orr_status orr_archive_strays(const char *archive, bool sweep, orr_archive_stray *tell, void *user,
                              orr_diag *diag);

// The days that an archive has, ascending.
//   Given:    archive     the archive's folder
//   Returned: day         [n] modified Julian days; free with free()
//             n           how many
//             diag        ORR_E_IO, ORR_E_MEMORY
orr_status orr_archive_days(const char *archive, int32_t **day, size_t *n, orr_diag *diag);

#endif
