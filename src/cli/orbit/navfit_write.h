// SPDX-License-Identifier: GPL-3.0-or-later
// What `orrery navfit` writes and says.
#ifndef ORR_CLI_ORBIT_NAVFIT_WRITE_H
#define ORR_CLI_ORBIT_NAVFIT_WRITE_H

#include "orbit/navdata/navset.h"
#include "src/cli/frame/cli.h"

// RINEX NAV 3.05.
orr_status navfit_write_rinex(const orr_navset *set, const char *path, orr_diag *diag);
// The bit streams of [from, to) as CSV; *n_pieces is how many subframes and strings were written. Without one
// there is no file: ORR_E_NODATA.
orr_status navfit_write_bits(const orr_navset *set, orr_time from, orr_time to, const char *path,
                             size_t *n_pieces, orr_diag *diag);

// The report: a table on stderr, or JSON on stdout (with every set).
void navfit_say(const orr_cli *c, const orr_navset *set);
int navfit_print_json(const orr_cli *c, const orr_navset *set);

#endif
