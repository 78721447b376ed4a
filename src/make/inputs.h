// SPDX-License-Identifier: GPL-3.0-or-later
// Input files of a product: each is read once, and the bytes that were read are hashed, so that provenance is true of a
// pipe, and of a file that somebody replaces meanwhile.
#ifndef ORR_MAKE_INPUTS_H
#define ORR_MAKE_INPUTS_H

#include "core/ncfile.h"
#include "ingest/input/input.h"
#include "ingest/input/sniff.h"
#include "ingest/rinex/rinex_nav.h"
#include "orbit/smooth/solution.h"

// Base names and SHA-256 of what was read, in the order of reading. Zero is an empty list; free with orr_inputs_free.
typedef struct orr_inputs {
    orr_orbit_source *item;
    size_t n;
    const orr_leap_table *leap; // by which files that are read into the list are dated; NULL: built-in
} orr_inputs;
// Frees the list; it is empty then.
void orr_inputs_free(orr_inputs *list);
// The list as a NetCDF product's provenance wants it: an array of list->n borrowed names and hashes, to be freed with
// free(); NULL without memory.
orr_nc_input *orr_inputs_provenance(const orr_inputs *list);
// Appends what another list has. ORR_E_MEMORY.
orr_status orr_inputs_join(orr_inputs *list, const orr_inputs *more, orr_diag *diag);

// Reads a file as it is expected.
// Given:
//   list   what has been read so far; NULL: provenance is not wanted
//   path   the file
//   kinds  what it may be (orr_input_limits): another file is refused by its first lines
// Returned:
//   list   the file appended
//   text   its text, decompressed; free with orr_bytes_free
//   diag   why it failed; may be NULL
// Errors: those of orr_input_read_all.
orr_status orr_inputs_read(orr_inputs *list, const char *path, uint64_t kinds, orr_bytes *text,
                           orr_diag *diag);
// The same with the bytes as they are, compressed or not.
// Given:
//   list   what has been read so far; NULL: provenance is not wanted
//   path   the file
//   kinds  what it may be; 0: whatever it is
// Returned:
//   list   the file appended
//   bytes  its bytes; free with orr_bytes_free
//   diag   why it failed; may be NULL
// Errors: those of orr_input_read_raw.
orr_status orr_inputs_read_raw(orr_inputs *list, const char *path, uint64_t kinds, orr_bytes *bytes,
                               orr_diag *diag);
// Appends a file that a library opened by itself (NetCDF): its bytes are read again to be hashed.
orr_status orr_inputs_note(orr_inputs *list, const char *path, orr_diag *diag);

// Reads navigation files as one (orr_nav_merge).
// Given:
//   list      what has been read so far; NULL: provenance is not wanted
//   path      [n] the files
//   n         how many; 0 gives an empty result
// Returned:
//   list      the files appended
//   out       their records; free with orr_nav_free
//   warnings  of the reader; may be NULL
//   diag      why it failed; may be NULL
// Errors: those of orr_input_read_all, orr_nav_parse and orr_nav_merge; ORR_E_MEMORY.
orr_status orr_inputs_read_navs(orr_inputs *list, const char *const *path, size_t n, orr_nav *out,
                                orr_warnings *warnings, orr_diag *diag);

#endif
