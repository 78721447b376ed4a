// SPDX-License-Identifier: GPL-3.0-or-later
// The IGS satellite metadata file (igs_satellite_metadata.snx, SINEX 2.02 "Extension for satellite metadata"): which space
// vehicle sends under which PRN and when, its block, what it transmits in all, its GLONASS channel.
#ifndef ORR_INGEST_TABLES_SATELLITE_METADATA_H
#define ORR_INGEST_TABLES_SATELLITE_METADATA_H

#include "core/sat.h"
#include "core/time.h"
#include "ingest/input/limits.h"

// Blocks that are kept.
typedef enum orr_metadata_kind {
    ORR_METADATA_IDENTIFIER, // block
    ORR_METADATA_PRN,        // sat
    ORR_METADATA_POWER,      // value, W
    ORR_METADATA_CHANNEL,    // value
} orr_metadata_kind;

// One line of a block; it holds for from <= t < until.
typedef struct orr_metadata_line {
    orr_metadata_kind kind;
    char svn[5]; // "G063"
    orr_time from, until;
    orr_sat sat;
    double value;
    char block[16]; // "GPS-IIF"
} orr_metadata_line;

typedef struct orr_satellite_metadata {
    size_t n;
    orr_metadata_line *line; // in the file's order
} orr_satellite_metadata;

// Reads such a file. Lines that cannot be read are told and left out.
//   Given:    path          of the file
//             limits        NULL: the defaults
//   Returned: out           the lines; free with orr_satellite_metadata_free
//             warnings      may be NULL
//             diag          ORR_E_KIND (none of these blocks), those of orr_records_load and orr_records_verdict, ORR_E_LIMIT
orr_status orr_satellite_metadata_read(const char *path, const orr_read_limits *limits,
                                       orr_satellite_metadata *out, orr_warnings *warnings, orr_diag *diag);
// The same from bytes in memory.
//   Given:    name          of the file, for sentences
//             text, n       its bytes
//             limits        NULL: the defaults
//   Returned: out           the lines; free with orr_satellite_metadata_free
//             warnings      may be NULL
//             diag          as above
orr_status orr_satellite_metadata_parse(const char *name, const char *text, size_t n,
                                        const orr_read_limits *limits, orr_satellite_metadata *out,
                                        orr_warnings *warnings, orr_diag *diag);
// Frees the lines; zeroed ones may be freed.
void orr_satellite_metadata_free(orr_satellite_metadata *m);

// The line of a kind that holds at t for a vehicle (svn: "G063"); NULL where there is none.
const orr_metadata_line *orr_satellite_metadata_at(const orr_satellite_metadata *m, orr_metadata_kind kind,
                                                   const char *svn, orr_time t);
// The vehicle that sends as a satellite at t: "G063", borrowed; NULL where the file does not tell.
const char *orr_satellite_metadata_svn(const orr_satellite_metadata *m, orr_sat sat, orr_time t);

#endif
