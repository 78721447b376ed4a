// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/tables/satellite_metadata.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/cursor.h"
#include "ingest/input/sniff.h"
#include "ingest/input/text_records.h"

enum { MAX_LINES = 1000000, WORDS = 5 };

static const struct {
    const char *name;
    size_t words; // at least
} blocks[] = {[ORR_METADATA_IDENTIFIER] = {"SATELLITE/IDENTIFIER", 4},
              [ORR_METADATA_PRN] = {"SATELLITE/PRN", 4},
              [ORR_METADATA_POWER] = {"SATELLITE/TX_POWER", 4},
              [ORR_METADATA_CHANNEL] = {"SATELLITE/FREQUENCY_CHANNEL", 4}};
enum { N_BLOCKS = sizeof blocks / sizeof *blocks, NO_BLOCK = -1 };

// The first words of a line; how many there are, up to WORDS.
static size_t split(orr_view line, orr_view word[WORDS])
{
    size_t n = 0, i = 0;
    while (i < line.n && n < WORDS) {
        while (i < line.n && line.p[i] == ' ') i++;
        const size_t from = i;
        while (i < line.n && line.p[i] != ' ') i++;
        if (i > from) word[n++] = (orr_view){line.p + from, i - from};
    }
    return n;
}

static bool is_svn(orr_view v)
{
    return v.n == 4 && strchr(ORR_SYSTEMS, v.p[0]) != NULL && v.p[1] >= '0' && v.p[1] <= '9' &&
           v.p[2] >= '0' && v.p[2] <= '9' && v.p[3] >= '0' && v.p[3] <= '9';
}

// "0000:000:00000" is a time that nothing bounds.
static bool bound(orr_view v, orr_time open, orr_time *out)
{
    if (v.n == 14 && memcmp(v.p, "0000:000:00000", 14) == 0) {
        *out = open;
        return true;
    }
    return orr_records_sinex_time(v, ORR_SCALE_GPS, NULL, out);
}

// One line into *out; NULL, or why it is none.
static const char *take(orr_metadata_kind kind, orr_view line, orr_metadata_line *out)
{
    orr_view w[WORDS];
    if (split(line, w) < blocks[kind].words) return "too few words";
    if (!is_svn(w[0])) return "no space vehicle, as G063 would be";
    *out =
        (orr_metadata_line){.kind = kind, .from = -ORR_TIME_FAR, .until = ORR_TIME_FAR, .sat = ORR_SAT_NONE};
    orr_view_copy(w[0], out->svn, sizeof out->svn);
    if (kind == ORR_METADATA_IDENTIFIER) { // SVN, COSPAR, catalogue number, block
        orr_view_copy(w[3], out->block, sizeof out->block);
        return NULL;
    }
    if (!bound(w[1], -ORR_TIME_FAR, &out->from) || !bound(w[2], ORR_TIME_FAR, &out->until))
        return "its times are none (YYYY:DDD:SSSSS)";
    if (kind == ORR_METADATA_PRN) {
        char name[8];
        orr_view_copy(w[3], name, sizeof name);
        out->sat = orr_sat_parse(name);
        return out->sat != ORR_SAT_NONE ? NULL : "no satellite, as G05 would be";
    }
    if (orr_view_real(w[3], &out->value) != ORR_FIELD_OK || !isfinite(out->value)) return "no number";
    if (kind == ORR_METADATA_POWER && !(out->value > 0 && out->value < 1e6))
        return "no power of a satellite, W";
    return NULL;
}

static int block_of(orr_view line)
{
    const orr_view name = orr_view_trim((orr_view){line.p + 1, line.n - 1});
    for (int k = 0; k < N_BLOCKS; k++)
        if (name.n == strlen(blocks[k].name) && memcmp(name.p, blocks[k].name, name.n) == 0) return k;
    return NO_BLOCK;
}

orr_status orr_satellite_metadata_parse(const char *name, const char *text, size_t n,
                                        const orr_read_limits *limits, orr_satellite_metadata *out,
                                        orr_warnings *warnings, orr_diag *diag)
{
    const orr_read_limits l = limits != NULL ? *limits : orr_read_default_limits();
    *out = (orr_satellite_metadata){.n = 0};
    if (n > l.max_bytes)
        return orr_diag_at(diag, ORR_E_LIMIT, name, 0, 0, "more than %zu bytes of text", l.max_bytes);
    orr_cursor c;
    orr_view line;
    orr_records_tally tally = {.good = 0};
    orr_status s = ORR_OK;
    int block = NO_BLOCK;
    bool any = false;
    orr_cursor_init(&c, name, text, n);
    while (s == ORR_OK && orr_cursor_next(&c, &line)) {
        if (line.n == 0 || line.p[0] == '*') continue;
        if (line.p[0] == '+' || line.p[0] == '-') {
            block = line.p[0] == '+' ? block_of(line) : NO_BLOCK;
            any = any || block != NO_BLOCK;
            continue;
        }
        if (block == NO_BLOCK || orr_view_is_blank(line)) continue;
        orr_metadata_line x;
        const char *why = take((orr_metadata_kind)block, line, &x);
        if (why != NULL) {
            orr_records_leave_out(&tally, &c, 0, why, warnings);
        } else if (out->n == MAX_LINES || !ORR_ARRAY_GROW(out->line, out->n)) {
            s = orr_cursor_error(&c, diag, out->n == MAX_LINES ? ORR_E_LIMIT : ORR_E_MEMORY, 0,
                                 "no room for more than %zu lines", out->n);
        } else {
            out->line[out->n++] = x;
            tally.good++;
        }
    }
    if (s == ORR_OK) s = orr_cursor_status(&c, diag);
    if (s == ORR_OK && !any)
        s = orr_diag_at(
            diag, ORR_E_KIND, name, 0, 0,
            "no satellite metadata: none of the blocks SATELLITE/IDENTIFIER, PRN, TX_POWER is in it");
    if (s == ORR_OK) s = orr_records_verdict(&tally, diag);
    if (s != ORR_OK) orr_satellite_metadata_free(out);
    return s;
}

orr_status orr_satellite_metadata_read(const char *path, const orr_read_limits *limits,
                                       orr_satellite_metadata *out, orr_warnings *warnings, orr_diag *diag)
{
    orr_bytes b;
    *out = (orr_satellite_metadata){.n = 0};
    orr_status s = orr_records_load(path, limits, ORR_KIND_BIT(ORR_KIND_SINEX), &b, diag);
    if (s != ORR_OK) return s;
    s = orr_satellite_metadata_parse(path, b.text, b.n, limits, out, warnings, diag);
    orr_bytes_free(&b);
    return s;
}

void orr_satellite_metadata_free(orr_satellite_metadata *m)
{
    free(m->line);
    *m = (orr_satellite_metadata){.n = 0};
}

const orr_metadata_line *orr_satellite_metadata_at(const orr_satellite_metadata *m, orr_metadata_kind kind,
                                                   const char *svn, orr_time t)
{
    for (size_t i = 0; i < m->n; i++) {
        const orr_metadata_line *x = &m->line[i];
        if (x->kind == kind && x->from <= t && t < x->until && strcmp(x->svn, svn) == 0) return x;
    }
    return NULL;
}

const char *orr_satellite_metadata_svn(const orr_satellite_metadata *m, orr_sat sat, orr_time t)
{
    for (size_t i = 0; i < m->n; i++) {
        const orr_metadata_line *x = &m->line[i];
        if (x->kind == ORR_METADATA_PRN && x->sat == sat && x->from <= t && t < x->until) return x->svn;
    }
    return NULL;
}
