// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/tables/blq.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "core/cursor.h"
#include "ingest/input/input.h"

enum { ROWS = 6, LINE = 256, LISTED = 160 };

// The next line that is no comment; false at the end.
static bool next_line(orr_cursor *c, orr_view *line)
{
    while (orr_cursor_next(c, line)) {
        const orr_view inside = orr_view_trim(*line);
        if (inside.n > 0 && !(inside.n >= 2 && inside.p[0] == '$' && inside.p[1] == '$')) {
            *line = inside;
            return true;
        }
    }
    return false;
}

static bool read_row(orr_view line, double out[ORR_BLQ_TIDES])
{
    char text[LINE], *at = text;
    snprintf(text, sizeof text, "%.*s", (int)(line.n < LINE ? line.n : LINE - 1), line.p);
    for (int k = 0; k < ORR_BLQ_TIDES; k++) {
        char *end;
        out[k] = strtod(at, &end);
        if (end == at || !isfinite(out[k])) return false;
        at = end;
    }
    return true;
}

static orr_status read_rows(orr_cursor *c, const char *station, orr_blq *out, orr_diag *diag)
{
    orr_view line;
    for (int k = 0; k < ROWS; k++) {
        const bool there = next_line(c, &line);
        if (!there || !read_row(line, k < 3 ? out->amplitude_m[k] : out->lag_deg[k - 3]))
            return orr_cursor_error(
                c, diag, ORR_E_FORMAT, 0,
                "station %.40s: %s of its six lines (three of amplitudes, three of phases) has not eleven "
                "numbers",
                station,
                k == 0          ? "the first"
                : k == ROWS - 1 ? "the last"
                                : "one");
    }
    return ORR_OK;
}

static orr_status find(const char *path, const orr_bytes *b, const char *station, orr_blq *out,
                       orr_diag *diag)
{
    char listed[LISTED] = "";
    orr_cursor c;
    orr_view line;
    orr_cursor_init(&c, path, b->text, b->n);
    while (next_line(&c, &line)) {
        char name[LINE];
        snprintf(name, sizeof name, "%.*s", (int)(line.n < LINE ? line.n : LINE - 1), line.p);
        const orr_status s = read_rows(&c, name, out, diag);
        if (s != ORR_OK || strcasecmp(name, station) == 0) return s;
        const size_t used = strlen(listed);
        snprintf(listed + used, sizeof listed - used, "%s%.20s", used > 0 ? ", " : "", name);
    }
    const orr_status s = orr_cursor_status(&c, diag);
    if (s != ORR_OK) return s;
    return orr_diag_at(diag, ORR_E_NODATA, path, 0, 0, "no ocean loading of '%.40s': the file has %s",
                       station, listed[0] != '\0' ? listed : "no station");
}

orr_status orr_blq_read(const char *path, const char *station, orr_blq *out, orr_diag *diag)
{
    orr_bytes b;
    *out = (orr_blq){.lag_deg = {{0}}};
    orr_status s = orr_input_read_all(path, NULL, &b, diag);
    if (s != ORR_OK) return s;
    s = find(path, &b, station, out, diag);
    orr_bytes_free(&b);
    return s;
}
