// SPDX-License-Identifier: GPL-3.0-or-later
// `orrery batch --now`: the day of the present.
#ifndef ORR_CLI_ARCHIVE_BATCH_NOW_H
#define ORR_CLI_ARCHIVE_BATCH_NOW_H

#include "src/cli/frame/cli.h"

// Looks for newer ultra-rapid orbits where --fetch is given, and makes the day of the present, and the next where it begins soon.
// Returns the exit code.
int batch_now(orr_cli *c);

#endif
