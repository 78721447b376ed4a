// SPDX-License-Identifier: GPL-3.0-or-later
// What `orrery navfit` writes and says.
#ifndef ORR_CLI_ORBIT_NAVFIT_WRITE_H
#define ORR_CLI_ORBIT_NAVFIT_WRITE_H

#include "orbit/navdata/navset.h"
#include "src/cli/frame/cli.h"
#include "src/make/inputs.h"

// RINEX NAV 3.05; comments of the header name the inputs and their SHA-256.
orr_status navfit_write_rinex(const orr_navset *set, const orr_inputs *inputs, const char *path,
                              orr_diag *diag);
// Writes the bit streams as CSV.
// Given:
//   set       the broadcast data
//   coded     symbols, not bits
//   from, to  the span, [from, to)
//   path      where to; without a piece there is no file
// Returned:
//   n_pieces  how many subframes, strings and pages were written
//   diag      why it failed; may be NULL
// Errors: ORR_E_NODATA (nothing is sent then), ORR_E_IO, ORR_E_MEMORY.
orr_status navfit_write_bits(const orr_navset *set, bool coded, orr_time from, orr_time to, const char *path,
                             size_t *n_pieces, orr_diag *diag);

// The report as a table on stderr.
void navfit_say(const orr_cli *c, const orr_navset *set);
// The report with every set as JSON on stdout; an exit status.
int navfit_print_json(const orr_cli *c, const orr_navset *set, const orr_inputs *inputs);

#endif
