// SPDX-License-Identifier: GPL-3.0-or-later
// orrery inspect on files of our own making, which are no affair of the ingest room: orbits, sessions,
// readings.
#ifndef ORR_CLI_FILES_INSPECT_OWN_H
#define ORR_CLI_FILES_INSPECT_OWN_H

#include "ingest/inspect/inspect.h"

// Fills an inspection of a NetCDF file. Errors: those of the three readers; ORR_E_KIND for others' files.
orr_status orr_inspect_own(const char *path, orr_inspection *r, orr_diag *diag);

#endif
