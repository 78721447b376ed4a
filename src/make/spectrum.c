// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/spectrum.h"

#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/cursor.h"

enum { MOST = 10000 };

// The next number of a row; BLANK at its end.
static orr_field next_number(orr_view *rest, double *out)
{
    while (rest->n > 0 && strchr(" \t,;", rest->p[0]) != NULL) rest->p++, rest->n--;
    size_t n = 0;
    while (n < rest->n && strchr(" \t,;", rest->p[n]) == NULL) n++;
    const orr_view word = {rest->p, n};
    rest->p += n;
    rest->n -= n;
    return n == 0 ? ORR_FIELD_BLANK : orr_view_real(word, out);
}

static orr_status read_rows(const char *path, const orr_bytes *raw, orr_spectrum_table *out, orr_diag *diag)
{
    orr_cursor c;
    orr_view line;
    bool first = true;
    orr_cursor_init(&c, path, raw->text, raw->n);
    while (orr_cursor_next(&c, &line)) {
        orr_view rest = orr_view_trim(line);
        if (rest.n == 0 || rest.p[0] == '#') continue;
        double v[3];
        const orr_field f = next_number(&rest, &v[0]), d = next_number(&rest, &v[1]);
        const bool heading = first && f == ORR_FIELD_BAD && d != ORR_FIELD_OK;
        first = false;
        if (heading) continue;
        if (f != ORR_FIELD_OK || d != ORR_FIELD_OK || next_number(&rest, &v[2]) != ORR_FIELD_BLANK)
            return orr_cursor_error(&c, diag, ORR_E_FORMAT, 0,
                                    "two numbers a row are wanted: frequency in Hz, density");
        if (out->n == MOST) return orr_cursor_error(&c, diag, ORR_E_LIMIT, 0, "more than %d rows", (int)MOST);
        if (!ORR_ARRAY_GROW(out->frequency_hz, out->n) || !ORR_ARRAY_GROW(out->density, out->n))
            return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a spectrum");
        out->frequency_hz[out->n] = v[0];
        out->density[out->n++] = v[1];
    }
    const orr_status s = orr_cursor_status(&c, diag);
    if (s == ORR_OK && out->n == 0)
        return orr_diag_at(diag, ORR_E_NODATA, path, 0, 0, "has no rows of numbers");
    return s;
}

orr_status orr_spectrum_read(orr_inputs *inputs, const char *path, orr_spectrum_table *out, orr_diag *diag)
{
    orr_bytes raw;
    *out = (orr_spectrum_table){0};
    const orr_status s = orr_inputs_read_raw(inputs, path, 0, &raw, diag);
    if (s != ORR_OK) return s;
    const orr_status rows = read_rows(path, &raw, out, diag);
    orr_bytes_free(&raw);
    return rows;
}

void orr_spectrum_free(orr_spectrum_table *t)
{
    free(t->frequency_hz);
    free(t->density);
    *t = (orr_spectrum_table){0};
}
