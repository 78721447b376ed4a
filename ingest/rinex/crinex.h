// SPDX-License-Identifier: GPL-3.0-or-later
// Compact RINEX (Hatanaka compression), versions 1.0 and 3.0, decoded epoch by epoch: the epoch line and the
// flags are character differences to the epoch before, the observations numerical differences of a given
// order (Hatanaka 2008, "A Compression Format and Tools for GNSS Observation Data", Bulletin of GSI 55).
// Header lines are not compressed.
#ifndef ORR_INGEST_RINEX_CRINEX_H
#define ORR_INGEST_RINEX_CRINEX_H

#include "ingest/input/input.h"

#define ORR_CRINEX_MISSING INT64_MIN
#define ORR_CRINEX_MAX_SATS 512
#define ORR_CRINEX_MAX_CODES 128

// How many observation types a satellite of a system has; by system letter, [' '] holds RINEX 2's one list.
typedef struct orr_crinex_counts {
    size_t n[128];
} orr_crinex_counts;
// Takes note of "# / TYPES OF OBSERV" and "SYS / # / OBS TYPES" lines, of headers and of events. False if
// such a line has no usable number.
bool orr_crinex_note_types(orr_crinex_counts *counts, orr_view header_line);

// One epoch or event, valid until the next call.
typedef struct orr_crinex_epoch {
    orr_view text; // the epoch line, uncompressed; in version 1.0 with all satellites in it, in 3.0 they
                   // follow column 41
    int flag;      // 0-6
    bool is_event; // flag 2-6: event lines, no satellites
    size_t n_sats, stride;
    char (*sat)[4];       // "G05"; RINEX 2's blank letter is kept
    size_t *n_codes;      // of each satellite
    const int64_t *value; // [sat * stride + code], 1/1000 of the unit; ORR_CRINEX_MISSING
    const char *flags;    // [(sat * stride + code) * 2]: LLI, signal strength; blank where missing
    bool has_clock;
    int64_t clock; // 1e-9 s in version 1.0, 1e-12 s in 3.0
    size_t n_event_lines;
    orr_view *event_line;
    int64_t line; // of the compressed file
} orr_crinex_epoch;

typedef struct orr_crinex orr_crinex;
// Begins to decode.
//   Given:    in          the file, read up to END OF HEADER
//             version     1.0 or 3.0
//             counts      observation types of each system; looked at before each epoch, so that the caller may
//                         let an event change it
//   Returned: warnings    of damage, now and while decoding; may be NULL
//             out         the decoder, to be closed with orr_crinex_close
//             diag        ORR_E_UNSUPPORTED (another version), ORR_E_MEMORY
//   Notes:    in, counts and warnings must outlive the decoder.
orr_status orr_crinex_open(orr_input *in, double version, const orr_crinex_counts *counts,
                           orr_warnings *warnings, orr_crinex **out, orr_diag *diag);
// *epoch is NULL at the end. Damage is reported to the warnings; decoding goes on at the next initialised
// epoch.
orr_status orr_crinex_next(orr_crinex *c, const orr_crinex_epoch **epoch, orr_diag *diag);
uint64_t orr_crinex_skipped(const orr_crinex *c); // stretches of damage
void orr_crinex_close(orr_crinex *c);             // not the input

typedef bool (*orr_crinex_sink)(void *user, const char *line, size_t n); // false stops with ORR_E_IO
// Expands a whole file to plain RINEX text.
//   Given:    in          the file, at its begin
//             write       gets line by line, without line ends
//             user        handed to it
//   Returned: warnings    of damage; may be NULL
//             diag        as of orr_rinex_obs_open; ORR_E_KIND if the input is not Hatanaka-compressed; ORR_E_IO
//                         where `write` stopped it
orr_status orr_crinex_expand(orr_input *in, orr_crinex_sink write, void *user, orr_warnings *warnings,
                             orr_diag *diag);
// Recognises the first line of a compressed file; *version may be NULL.
bool orr_crinex_is_first_line(orr_view line, double *version);

#endif
