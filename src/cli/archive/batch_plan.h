// SPDX-License-Identifier: GPL-3.0-or-later
// A batch divided into chunks of consecutive days: a text file with a line "FIRST LAST" a chunk, behind two lines of '#'.
#ifndef ORR_CLI_ARCHIVE_BATCH_PLAN_H
#define ORR_CLI_ARCHIVE_BATCH_PLAN_H

#include "src/cli/frame/cli.h"

// Writes the plan that --plan names.
//   Given:    c           the call
//             first, last days
//             chunks      how many at most
//   Returned: (value)     an exit status, with its sentence
int batch_plan_write(const orr_cli *c, int32_t first, int32_t last, size_t chunks);
// Reads one chunk.
//   Given:    c           the call
//             which       "FILE:N"
//   Returned: first, last days of the chunk
//             (value)     an exit status, with its sentence
int batch_plan_read(const orr_cli *c, const char *which, int32_t *first, int32_t *last);

#endif
