// SPDX-License-Identifier: GPL-3.0-or-later
// The inside of the observation reader: its state, header lines, the mapping of RINEX 2 types.
#ifndef ORR_INGEST_RINEX_RINEX_OBS_PRIVATE_H
#define ORR_INGEST_RINEX_RINEX_OBS_PRIVATE_H

#include "ingest/rinex/crinex.h"
#include "ingest/rinex/rinex_labels.h"
#include "ingest/rinex/rinex_obs.h"

// Where header lines report to.
typedef struct obs_context {
    const char *name;
    int64_t line;
    orr_warnings *warnings;
    orr_diag *diag;
    const orr_leap_table *leap;
} obs_context;

// What must be remembered between header lines.
typedef struct obs_header_state {
    int open_system;  // continuation of SYS / # / OBS TYPES: its index, -1 none
    size_t open_want; // types still to come
    size_t v2_want, v2_n;
    char v2_type[ORR_OBS_MAX_CODES][4];
    // OBS SCALE FACTOR of 2.20: the factor of all types (0: not told), and of some by name; those still to come
    int v2_scale_all, v2_scale_now;
    size_t v2_scale_want, v2_n_scaled;
    struct {
        char type[4];
        int factor, column;
        int64_t line;
    } v2_scale[ORR_OBS_MAX_CODES];
    bool ended, wide; // wide: text behind column 80 has been told
    uint32_t seen;    // OBS_SEEN_*
} obs_header_state;
enum { OBS_SEEN_MARKER = 1, OBS_SEEN_TYPES = 2, OBS_SEEN_FIRST = 4 };

struct orr_rinex_obs {
    orr_input *in;
    orr_rinex_obs_limits limits;
    orr_warnings *warnings;
    orr_rinex_obs_header h;
    obs_header_state state;
    orr_crinex *crinex; // NULL for plain files
    orr_crinex_counts counts;
    orr_rinex_obs_epoch e;
    orr_sat sat[ORR_OBS_MAX_SATS];
    double *value;
    uint8_t *lli, *ssi;
    size_t cells;
    char **event_line; // as handed out
    size_t n_event_lines;
    uint64_t n_epochs, skipped;
    orr_time last;
    uint32_t warned; // WARNED_* and one bit a system
};
enum { WARNED_SYSTEM = 1u << 16, WARNED_EXTRA = 1u << 17, WARNED_ORDER = 1u << 18, WARNED_EMPTY = 1u << 19 };

// A complaint about the line read last.
static inline void orr_obs_warn(orr_rinex_obs *r, int column, const char *what)
{
    orr_warnings_add(r->warnings, orr_input_name(r->in), orr_input_line_number(r->in), column, "%s", what);
}

// Where the line read last reports to.
static inline obs_context orr_obs_context(orr_rinex_obs *r, orr_diag *diag)
{
    return (obs_context){orr_input_name(r->in), orr_input_line_number(r->in), r->warnings, diag,
                         r->limits.leap};
}

// Frees the lines of the last event.
void orr_obs_drop_event_lines(orr_rinex_obs *r);

// Takes one header line. ORR_OK also where it only warned; an error refuses the file.
orr_status orr_obs_header_line(orr_rinex_obs_header *h, obs_header_state *st, orr_view line,
                               const obs_context *c);
// After END OF HEADER (or an event): the lists must be complete; fills in the codes of RINEX 2.
orr_status orr_obs_header_check(orr_rinex_obs_header *h, obs_header_state *st, const obs_context *c);
// First line of the file (already parsed) into h.
orr_status orr_obs_header_first(orr_rinex_obs_header *h, const orr_rinex_first *first, const obs_context *c);

// What several header lines share: a complaint, a refusal, the place of a system's letter among ORR_SYSTEMS (-1: none), an
// observation code within columns (false where it is none).
void orr_obs_header_warn(const obs_context *c, int column, const char *what);
// A refusal of the header at a column of the line: ORR_E_FORMAT.
orr_status orr_obs_header_refuse(const obs_context *c, int column, const char *what);
// -1 for letters that are no system.
int orr_obs_system_index(char c);
// Two or three characters, without blanks.
bool orr_obs_code_text(orr_view line, int col, int width, char out[4]);
// Lists of types (SYS / # / OBS TYPES; # / TYPES OF OBSERV) and scale factors (SYS / SCALE FACTOR; OBS SCALE FACTOR of 2.20).
orr_status orr_obs_types_v3(orr_rinex_obs_header *h, obs_header_state *st, orr_view line,
                            const obs_context *c);
// Of RINEX 2, for all systems.
orr_status orr_obs_types_v2(obs_header_state *st, orr_view line, const obs_context *c);
// Of 2.20.
orr_status orr_obs_scale_factor_v2(obs_header_state *st, orr_view line, const obs_context *c);
// The factors of all types of 2.20, after the header.
orr_status orr_obs_scales_of_v2(const obs_header_state *st, double scale[ORR_OBS_MAX_CODES],
                                const obs_context *c);
// Of 3 and later.
orr_status orr_obs_scale_factor(orr_rinex_obs_header *h, orr_view line, const obs_context *c);

// Appends a code; ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_obs_codes_add(orr_obs_codes *codes, const char *code, const char *original, orr_diag *diag);
// Frees a list of codes and leaves it empty.
void orr_obs_codes_clear(orr_obs_codes *codes);
// The RINEX 3 code that a RINEX 2 type of a system is taken for.
//   Given:    system      its letter
//             type        as the file has it, e.g. "P2"
//             set, n      all types of the file: what L2 is taken for depends on them
//   Returned: out         the code, "" if there is none
void orr_obs_code_of_v2(char system, const char *type, const char (*set)[4], size_t n, char out[4]);

#endif
