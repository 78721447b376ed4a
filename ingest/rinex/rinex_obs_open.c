// SPDX-License-Identifier: GPL-3.0-or-later
// Opening observation files: the header, and what lies around it.
#include <stdlib.h>

#include "ingest/rinex/rinex_obs_private.h"

orr_rinex_obs_limits orr_rinex_obs_default_limits(void)
{
    return (orr_rinex_obs_limits){UINT64_C(64) << 30, 100000000, 100000, 999, NULL};
}

static orr_status read_header(orr_rinex_obs *r, orr_diag *diag)
{
    orr_view line;
    const char *name = orr_input_name(r->in);
    orr_status s = ORR_OK;
    if (!orr_input_line(r->in, &line)) {
        s = orr_input_status(r->in, diag);
        return s != ORR_OK ? s : orr_diag_at(diag, ORR_E_KIND, name, 1, 0, "the file is empty");
    }
    if (orr_crinex_is_first_line(line, &r->h.crinex_version)) {
        r->h.hatanaka = true;
        if (!orr_input_line(r->in, &line) ||
            !orr_input_line(r->in, &line)) { // CRINEX PROG / DATE lies between
            s = orr_input_status(r->in, diag);
            return s != ORR_OK
                       ? s
                       : orr_diag_at(diag, ORR_E_FORMAT, name, 0, 0, "the file ends within its header");
        }
    }
    orr_rinex_first first;
    s = orr_rinex_first_line(name, line, &first, diag);
    obs_context c = orr_obs_context(r, diag);
    if (s == ORR_OK) s = orr_obs_header_first(&r->h, &first, &c);
    if (s == ORR_OK && r->h.hatanaka && (r->h.crinex_version >= 3) != (r->h.version >= 3))
        orr_obs_warn(r, 1, "the Compact RINEX version does not belong to this RINEX version");
    for (size_t i = 0; s == ORR_OK && !r->state.ended; i++) {
        if (i > r->limits.max_header_lines)
            return orr_diag_at(diag, ORR_E_LIMIT, name, 0, 0, "a header of more than %zu lines",
                               r->limits.max_header_lines);
        if (!orr_input_line(r->in, &line)) {
            s = orr_input_status(r->in, diag);
            return s != ORR_OK
                       ? s
                       : orr_diag_at(diag, ORR_E_FORMAT, name, 0, 0, "the header has no END OF HEADER");
        }
        if (!r->h.hatanaka && r->h.version >= 3 && line.n > 1 && line.p[0] == '>' && line.p[1] == ' ')
            return orr_diag_at(diag, ORR_E_FORMAT, name, orr_input_line_number(r->in), 1,
                               "epochs begin before END OF HEADER");
        c = orr_obs_context(r, diag);
        s = orr_obs_header_line(&r->h, &r->state, line, &c);
        if (s == ORR_OK && !orr_crinex_note_types(&r->counts, line))
            s = orr_diag_at(diag, ORR_E_FORMAT, name, c.line, 1,
                            "the number of observation types is not usable");
    }
    if (s != ORR_OK) return s;
    c = orr_obs_context(r, diag);
    s = orr_obs_header_check(&r->h, &r->state, &c);
    if (s != ORR_OK) return s;
    if (!(r->state.seen & OBS_SEEN_FIRST))
        orr_obs_warn(r, 0, "the header has no TIME OF FIRST OBS: the system's own time is taken");
    if (!(r->state.seen & OBS_SEEN_MARKER)) orr_obs_warn(r, 0, "the header has no MARKER NAME");
    if (r->h.scale == ORR_SCALE_GLO || r->h.scale == ORR_SCALE_UTC)
        orr_leap_warn(r->h.last != ORR_TIME_NONE ? r->h.last : r->h.first, r->limits.leap,
                      orr_input_name(r->in), r->warnings);
    if (r->h.hatanaka)
        s = orr_crinex_open(r->in, r->h.crinex_version, &r->counts, r->warnings, &r->crinex, diag);
    return s;
}

static orr_status open_input(orr_input *in, const orr_rinex_obs_limits *limits, orr_warnings *warnings,
                             orr_rinex_obs **out, orr_diag *diag)
{
    orr_rinex_obs *r = calloc(1, sizeof *r);
    if (r == NULL) {
        orr_input_close(in);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    r->in = in;
    r->limits = limits != NULL ? *limits : orr_rinex_obs_default_limits();
    r->h.leap = r->limits.leap;
    r->warnings = warnings;
    r->state.open_system = -1;
    r->last = ORR_TIME_NONE;
    orr_rinex_obs_header_init(&r->h);
    orr_status s = read_header(r, diag);
    if (s != ORR_OK) {
        orr_rinex_obs_close(r);
        r = NULL;
    }
    *out = r;
    return s;
}

static orr_input_limits input_limits(const orr_rinex_obs_limits *limits)
{
    orr_input_limits l = orr_input_default_limits();
    uint64_t max = limits != NULL ? limits->max_bytes : orr_rinex_obs_default_limits().max_bytes;
    l.max_bytes = max > SIZE_MAX ? SIZE_MAX : (size_t)max;
    return l;
}

orr_status orr_rinex_obs_open(const char *path, const orr_rinex_obs_limits *limits, orr_warnings *warnings,
                              orr_rinex_obs **out, orr_diag *diag)
{
    *out = NULL;
    orr_input_limits l = input_limits(limits);
    orr_input *in = NULL;
    orr_status s = orr_input_open(path, &l, &in, diag);
    return s != ORR_OK ? s : open_input(in, limits, warnings, out, diag);
}

orr_status orr_rinex_obs_open_memory(const char *name, const char *text, size_t n,
                                     const orr_rinex_obs_limits *limits, orr_warnings *warnings,
                                     orr_rinex_obs **out, orr_diag *diag)
{
    *out = NULL;
    orr_input_limits l = input_limits(limits);
    orr_input *in = NULL;
    orr_status s = orr_input_open_bytes(name, text, n, &l, &in, diag);
    return s != ORR_OK ? s : open_input(in, limits, warnings, out, diag);
}

void orr_rinex_obs_close(orr_rinex_obs *r)
{
    if (r == NULL) return;
    orr_obs_drop_event_lines(r);
    free(r->event_line);
    free(r->value);
    free(r->lli);
    free(r->ssi);
    orr_crinex_close(r->crinex);
    orr_rinex_obs_header_free(&r->h);
    orr_input_close(r->in);
    free(r);
}
