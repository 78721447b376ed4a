// SPDX-License-Identifier: GPL-3.0-or-later
// Compact RINEX back to plain text, for users and for programs that do not read it.
#include <stdlib.h>
#include <string.h>

#include "ingest/rinex/crinex.h"
#include "ingest/rinex/rinex_labels.h"

typedef struct writer {
    orr_crinex_sink write;
    void *user;
    char line[4096]; // 3 + 16 * ORR_CRINEX_MAX_CODES is the longest
    bool failed;
} writer;

static void put_line(writer *w, const char *text, size_t n)
{
    while (n > 0 && text[n - 1] == ' ') n--;
    if (!w->failed && !w->write(w->user, text, n)) w->failed = true;
}

// A fixed-point number, right-aligned in `width` characters with `decimals` of them after the point; false if
// it does not fit.
static bool put_fixed(char *out, int width, int decimals, int64_t value)
{
    uint64_t u = value < 0 ? (uint64_t)-value : (uint64_t)value;
    int i = width, written = 0;
    memset(out, ' ', (size_t)width);
    while (i > 0 && (u > 0 || written <= decimals + 1)) {
        if (written == decimals) {
            out[--i] = '.';
        } else {
            out[--i] = (char)('0' + u % 10);
            u /= 10;
        }
        written++;
    }
    if (u > 0 || written <= decimals + 1) return false;
    if (value < 0) {
        if (i == 0) return false;
        out[--i] = '-';
    }
    return true;
}

static void put_epoch_line(writer *w, const orr_crinex_epoch *e, bool v3)
{
    char *line = w->line;
    size_t n = e->text.n;
    memset(line, ' ', 80);
    if (v3) {
        memcpy(line, e->text.p, n < 41 ? n : 41);
        if (e->has_clock) put_fixed(line + 41, 15, 12, e->clock);
        put_line(w, line, 56);
        return;
    }
    memcpy(line, e->text.p, n < 32 ? n : 32);
    for (size_t first = 0; first == 0 || first < e->n_sats; first += 12) {
        if (first > 0) memset(line, ' ', 80);
        for (size_t i = first; i < e->n_sats && i < first + 12; i++)
            memcpy(line + 32 + 3 * (i - first), e->sat[i], 3);
        if (first == 0 && e->has_clock) put_fixed(line + 68, 12, 9, e->clock);
        put_line(w, line, 80);
    }
}

static bool put_satellite(writer *w, const orr_crinex_epoch *e, size_t i, bool v3)
{
    char *line = w->line;
    size_t at = 0;
    if (v3) {
        memcpy(line, e->sat[i], 3);
        at = 3;
    }
    for (size_t j = 0; j < e->n_codes[i]; j++) {
        const char *flags = e->flags + 2 * (i * e->stride + j);
        int64_t v = e->value[i * e->stride + j];
        if (v == ORR_CRINEX_MISSING)
            memset(line + at, ' ', 14);
        else if (!put_fixed(line + at, 14, 3, v))
            return false;
        line[at + 14] = flags[0];
        line[at + 15] = flags[1];
        at += 16;
        if (!v3 && (j % 5 == 4 || j + 1 == e->n_codes[i])) {
            put_line(w, line, at);
            at = 0;
        }
    }
    if (v3) put_line(w, line, at);
    return true;
}

static orr_status copy_header(orr_input *in, writer *w, orr_crinex_counts *counts, double *version,
                              orr_diag *diag)
{
    orr_view line;
    const char *name = orr_input_name(in);
    if (!orr_input_line(in, &line) || !orr_crinex_is_first_line(line, version)) {
        orr_status s = orr_input_status(in, diag);
        if (s != ORR_OK) return s;
        return orr_diag_at(diag, ORR_E_KIND, name, 1, 61, "not a Compact RINEX (Hatanaka) file");
    }
    if (!orr_input_line(in, &line)) // CRINEX PROG / DATE
        return orr_diag_at(diag, ORR_E_FORMAT, name, 2, 0, "the file ends within its header");
    while (orr_input_line(in, &line)) {
        if (!orr_crinex_note_types(counts, line))
            return orr_diag_at(diag, ORR_E_FORMAT, name, orr_input_line_number(in), 1,
                               "the number of observation types is not usable");
        put_line(w, line.p, line.n);
        if (orr_view_equals(orr_rinex_label(line), "END OF HEADER")) return ORR_OK;
        if (orr_input_line_number(in) > 100000)
            return orr_diag_at(diag, ORR_E_LIMIT, name, 0, 0, "a header of more than 100000 lines");
    }
    orr_status s = orr_input_status(in, diag);
    return s != ORR_OK ? s : orr_diag_at(diag, ORR_E_FORMAT, name, 0, 0, "the header has no END OF HEADER");
}

static orr_status expand(orr_input *in, orr_crinex_counts *counts, writer *w, orr_warnings *warnings,
                         orr_diag *diag)
{
    double version = 0;
    orr_crinex *c = NULL;
    uint64_t n_epochs = 0;
    orr_status s = copy_header(in, w, counts, &version, diag);
    if (s == ORR_OK) s = orr_crinex_open(in, version, counts, warnings, &c, diag);
    while (s == ORR_OK && !w->failed) {
        const orr_crinex_epoch *e = NULL;
        s = orr_crinex_next(c, &e, diag);
        if (s != ORR_OK || e == NULL) break;
        n_epochs++;
        if (e->is_event) {
            put_line(w, e->text.p, e->text.n);
            for (size_t i = 0; i < e->n_event_lines && s == ORR_OK; i++) {
                put_line(w, e->event_line[i].p, e->event_line[i].n);
                if (!orr_crinex_note_types(counts, e->event_line[i]))
                    s = orr_diag_at(
                        diag, ORR_E_FORMAT, orr_input_name(in), e->line, 0,
                        "an event changes the number of observation types to one that is not usable");
            }
            continue;
        }
        put_epoch_line(w, e, version >= 3);
        for (size_t i = 0; i < e->n_sats && s == ORR_OK; i++)
            if (!put_satellite(w, e, i, version >= 3))
                s = orr_diag_at(diag, ORR_E_FORMAT, orr_input_name(in), e->line, 0,
                                "a value of satellite %s does not fit into RINEX's F14.3", e->sat[i]);
    }
    if (s == ORR_OK && n_epochs == 0 && c != NULL && orr_crinex_skipped(c) > 0)
        s = orr_diag_at(diag, ORR_E_FORMAT, orr_input_name(in), orr_input_line_number(in), 0,
                        "no epoch of the file can be decoded");
    orr_crinex_close(c);
    if (s == ORR_OK && w->failed) s = orr_diag_set(diag, ORR_E_IO, "the output could not be written");
    return s;
}

orr_status orr_crinex_expand(orr_input *in, orr_crinex_sink write, void *user, orr_warnings *warnings,
                             orr_diag *diag)
{
    orr_crinex_counts *counts = calloc(1, sizeof *counts);
    writer *w = calloc(1, sizeof *w);
    orr_status s = ORR_E_MEMORY;
    if (counts == NULL || w == NULL) {
        orr_diag_set(diag, s, "out of memory");
    } else {
        w->write = write;
        w->user = user;
        s = expand(in, counts, w, warnings, diag);
    }
    free(counts);
    free(w);
    return s;
}
