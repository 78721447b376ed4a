// SPDX-License-Identifier: GPL-3.0-or-later
// What a file is and what is in it, told the same way for every kind: the report behind `orrery inspect`.
// A format adds its kind by one function `orr_inspect_<name>` in a file of its own and one line in
// inspect.def.
#ifndef ORR_INGEST_INSPECT_INSPECT_H
#define ORR_INGEST_INSPECT_INSPECT_H

#include "core/sat.h"
#include "core/time.h"
#include "ingest/input/input.h"
#include "ingest/input/sniff.h"

#define ORR_INSPECT_NONE ((int64_t)-1) // a count that makes no sense for this kind

// One line for people: "agency", "AIUB".
typedef struct orr_inspect_fact {
    char label[24];
    char text[512];
} orr_inspect_fact;

typedef struct orr_inspection {
    orr_kind kind;
    char version[8];                 // as the format writes it, may be empty
    orr_time from, to;               // first and last instant the data cover, ORR_TIME_NONE if unknown
    double interval_s;               // usual step between epochs, NAN if unknown or not even
    char systems[ORR_N_SYSTEMS + 1]; // letters in the order of ORR_SYSTEMS; use orr_inspect_sat
    int64_t satellites;              // how many different ones
    int64_t epochs;                  // how many instants
    int64_t records; // what there is where epochs make no sense: ephemerides, maps, biases, antennas
    int64_t gaps;    // places where the epochs are further apart than interval_s
    size_t n_facts;
    orr_inspect_fact *fact;
    bool incomplete; // there was no memory for all of them
    orr_warnings warnings;
    orr_sat_set seen; // behind `systems` and `satellites`
    // For the kinds' functions.
    const orr_leap_table *leap;
    const orr_bytes *raw; // of what can be read but once (a pipe); NULL: the functions read the file
} orr_inspection;

// Opens ("-" is standard input; a pipe is read once, into memory), sniffs, reads by the kind's own reader. ORR_OK with warnings inside, or the reader's refusal; *out
// is to be freed in both cases (kind and version are filled in as far as they are known). Errors: as the
// readers', and ORR_E_UNSUPPORTED for kinds that are recognised and not read here.
// leap converts UTC labels (NULL: built-in) and must outlive *out.
orr_status orr_inspect(const char *path, const orr_leap_table *leap, orr_inspection *out, orr_diag *diag);
// Empties a report: nothing is known.
void orr_inspection_init(orr_inspection *r);
// Frees what a report holds and empties it.
void orr_inspection_free(orr_inspection *r);

// Archives are looked at before anything is opened: they are no text, whatever is in them.
bool orr_inspect_is_zip(const char *path);
// The report of a zip archive: how many files its directory names. ORR_E_IO, ORR_E_FORMAT where it has no
// directory.
orr_status orr_inspect_zip(const char *path, orr_inspection *r, orr_diag *diag);

// For the kinds' functions, orr_status orr_inspect_<name>(const char *path, orr_inspection *r, orr_diag
// *diag): kind and version are set already (a function may refine the version), the rest is as
// orr_inspection_init left it.

// The whole text of the file, decompressed, to be freed with orr_bytes_free. Errors of orr_input_read_all.
orr_status orr_inspect_text(const orr_inspection *r, const char *path, orr_bytes *text, orr_diag *diag);

// Adds a line for people; without memory the report goes on without it.
//   Given:    label       the line's name, cut at 23 bytes
//             fmt, ...    its text, as of printf, cut at 511 bytes
//   Returned: r           with the line
void orr_inspect_fact_add(orr_inspection *r, const char *label, const char *fmt, ...) ORR_PRINTF(3, 4);
// Counts a satellite (once) and its system; `satellites` starts to count with the first.
void orr_inspect_sat_add(orr_inspection *r, orr_sat sat);
// A system without satellites of its own (a bias of a whole system, an observation type's list).
void orr_inspect_system_add(orr_inspection *r, char system);
// Fills from, to, epochs, and where they are not told also interval_s (the most frequent step) and gaps
// (steps over 1.5 intervals) from ascending instants.
void orr_inspect_epochs(orr_inspection *r, const orr_time *t, size_t n);

#define ORR_INSPECT(kind, name)                                                                              \
    orr_status orr_inspect_##name(const char *path, orr_inspection *r, orr_diag *diag);
#include "ingest/inspect/inspect.def"
#undef ORR_INSPECT

#endif
