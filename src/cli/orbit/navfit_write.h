// SPDX-License-Identifier: GPL-3.0-or-later
// What `orrery navfit` writes and says.
#ifndef ORR_CLI_ORBIT_NAVFIT_WRITE_H
#define ORR_CLI_ORBIT_NAVFIT_WRITE_H

#include "orbit/navdata/navset.h"
#include "src/cli/frame/cli.h"
#include "src/make/inputs.h"

// Writes the sets as a navigation file; comments of the header name the inputs and their SHA-256.
// Given:
//   set       the broadcast data
//   inputs    what they were made from
//   version   of RINEX: 3.05 or 4.02
//   path      where to
// Returned:
//   n_left    sets whose messages that version has no records of
//   diag      why it failed; may be NULL
orr_status navfit_write_rinex(const orr_navset *set, const orr_inputs *inputs, double version,
                              const char *path, size_t *n_left, orr_diag *diag);
// Writes the sets that RTCM 3 has messages for as its frames, in the order of their transmission.
// Given:
//   set       the broadcast data
//   leap      table of leap seconds
//   path      where to
// Returned:
//   n         frames
//   diag      why it failed; may be NULL
// Errors: ORR_E_NODATA where there is none, ORR_E_RANGE, ORR_E_IO, ORR_E_MEMORY.
orr_status navfit_write_rtcm(const orr_navset *set, const orr_leap_table *leap, const char *path, size_t *n,
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
