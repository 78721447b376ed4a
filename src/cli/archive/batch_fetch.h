// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs of a batch from the mirrors of the IGS, by way of the cache of `orrery fetch`.
#ifndef ORR_CLI_ARCHIVE_BATCH_FETCH_H
#define ORR_CLI_ARCHIVE_BATCH_FETCH_H

#include "src/archive/inputs_index.h"
#include "src/cli/frame/cli.h"

// Fetches what days first - 1 to last + 1 are made from and makes an index of it. A file that is nowhere to be had is told, and its day
// fails or goes without.
//   Given:    c           the command, with --centre and --offline
//             wants       TEC fields and stations
//             first, last modified Julian days
//   Returned: x           the files; free with orr_archive_index_free whatever this returned
//   Returns an exit status.
int batch_fetch(orr_cli *c, const orr_archive_wants *wants, int32_t first, int32_t last,
                orr_archive_index *x);

// Fetches into the cache the newest ultra-rapid orbits of a day and of the day before it. What could not be fetched is told, and no
// failure: the cache may have what it takes.
//   Given:    mjd     the day
//   Returned: the exit code
int batch_fetch_ultra(orr_cli *c, int32_t mjd);

#endif
