// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/troposphere/gpt3.h"

#include <math.h>
#include <stdlib.h>

#include "core/array.h"
#include "ingest/input/sniff.h"
#include "ingest/input/text_records.h"

enum { COLUMNS = 64, ALONE = 22 }; // columns of a line; of undulation and height, which have no season

// What a season's numbers are multiplied by, and between which its mean may be, in the file's unit.
static const struct {
    const char *name;
    double factor, least, most;
} quantity[ORR_GPT3_SEASONS] = {
    [ORR_GPT3_PRESSURE] = {"pressure", 1, 30000, 115000},
    [ORR_GPT3_TEMPERATURE] = {"temperature", 1, 180, 340},
    [ORR_GPT3_HUMIDITY] = {"humidity", 1e-3, 0, 50},
    [ORR_GPT3_LAPSE] = {"lapse rate", 1e-3, -50, 50},
    [ORR_GPT3_A_HYDROSTATIC] = {"a_h", 1e-3, 0.5, 2},
    [ORR_GPT3_A_WET] = {"a_w", 1e-3, 0.1, 2},
    [ORR_GPT3_DECREASE] = {"lambda", 1, -5, 20},
    [ORR_GPT3_MEAN] = {"mean temperature", 1, 180, 340},
    [ORR_GPT3_NORTH_HYDROSTATIC] = {"Gn_h", 1e-5, -1000, 1000},
    [ORR_GPT3_EAST_HYDROSTATIC] = {"Ge_h", 1e-5, -1000, 1000},
    [ORR_GPT3_NORTH_WET] = {"Gn_w", 1e-5, -1000, 1000},
    [ORR_GPT3_EAST_WET] = {"Ge_w", 1e-5, -1000, 1000},
};

static orr_status read_numbers(orr_cursor *c, orr_view line, double v[COLUMNS], orr_diag *diag)
{
    orr_view word;
    int n = 0;
    while (n < COLUMNS && orr_view_word(&line, &word)) {
        if (orr_view_real(word, &v[n]) != ORR_FIELD_OK)
            return orr_cursor_error(c, diag, ORR_E_FORMAT, 0, "'%.*s' in column %d is no number",
                                    (int)(word.n < 20 ? word.n : 20), word.p, n + 1);
        n++;
    }
    if (n == COLUMNS && !orr_view_word(&line, &word)) return ORR_OK;
    if (n == 44 || n == 39)
        return orr_cursor_error(c, diag, ORR_E_KIND, 0,
                                "%d numbers are GPT2's; GPT3 has 64: give gpt3_5.grd or gpt3_1.grd", n);
    return orr_cursor_error(c, diag, ORR_E_FORMAT, 0, "%s 64 numbers in the line of a point",
                            n < COLUMNS ? "less than" : "more than");
}

static orr_status keep(orr_cursor *c, const double v[COLUMNS], orr_gpt3_point *out, orr_diag *diag)
{
    for (int k = 0; k < ORR_GPT3_SEASONS; k++) {
        const double *of = v + 2 + 5 * k + (2 + 5 * k >= ALONE ? 2 : 0);
        if (!(of[0] >= quantity[k].least && of[0] <= quantity[k].most))
            return orr_cursor_error(c, diag, ORR_E_FORMAT, 0, "a mean %s of %g cannot be", quantity[k].name,
                                    of[0]);
        for (int j = 0; j < 5; j++) out->season[k][j] = (float)(of[j] * quantity[k].factor);
    }
    if (!(fabs(v[ALONE]) <= 200 && v[ALONE + 1] >= -1000 && v[ALONE + 1] <= 9000))
        return orr_cursor_error(c, diag, ORR_E_FORMAT, 0, "undulation %g m and height %g m cannot be",
                                v[ALONE], v[ALONE + 1]);
    out->undulation_m = (float)v[ALONE];
    out->height_m = (float)v[ALONE + 1];
    return ORR_OK;
}

// Lines into points and their places, whose arrays grow.
static orr_status read_lines(orr_cursor *c, size_t limit, orr_gpt3_point **point, orr_lattice_point **place,
                             size_t *n, orr_diag *diag)
{
    orr_view line;
    double v[COLUMNS];
    while (orr_cursor_next(c, &line)) {
        const orr_view inside = orr_view_trim(line);
        if (inside.n == 0 || inside.p[0] == '%') continue;
        orr_status s = read_numbers(c, inside, v, diag);
        if (s == ORR_OK) s = orr_records_grow(point, *n, sizeof **point, limit, "points", c, diag);
        if (s == ORR_OK) s = orr_records_grow(place, *n, sizeof **place, limit, "points", c, diag);
        if (s == ORR_OK) s = keep(c, v, &(*point)[*n], diag);
        if (s != ORR_OK) return s;
        (*place)[*n] = (orr_lattice_point){v[0], v[1]};
        ++*n;
    }
    return orr_cursor_status(c, diag);
}

orr_status orr_gpt3_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                          orr_gpt3 *out, orr_diag *diag)
{
    const orr_read_limits l = limits != NULL ? *limits : orr_read_default_limits();
    orr_cursor c;
    orr_lattice_point *place = NULL;
    size_t points = 0, bad;
    *out = (orr_gpt3){.point = NULL};
    orr_cursor_init(&c, name, text, n);
    orr_status s = read_lines(&c, l.max_values / COLUMNS, &out->point, &place, &points, diag);
    if (s == ORR_OK && points == 0)
        s = orr_diag_at(diag, ORR_E_KIND, name, 0, 0, "no grid of GPT3: no line with a point's numbers");
    else if (s == ORR_OK && !orr_lattice_learn(place, points, &out->lattice, &bad))
        s = orr_diag_at(diag, ORR_E_FORMAT, name, 0, 0,
                        "point %zu of %zu is not where a grid of equal steps has it", bad + 1, points);
    free(place);
    if (s != ORR_OK) orr_gpt3_free(out);
    return s;
}

orr_status orr_gpt3_read(const char *path, const orr_read_limits *limits, orr_gpt3 *out, orr_diag *diag)
{
    orr_bytes b;
    *out = (orr_gpt3){.point = NULL};
    orr_status s = orr_records_load(path, limits, ORR_KIND_BIT(ORR_KIND_GPT3), &b, diag);
    if (s != ORR_OK) return s;
    s = orr_gpt3_parse(path, b.text, b.n, limits, out, diag);
    orr_bytes_free(&b);
    return s;
}

void orr_gpt3_free(orr_gpt3 *x)
{
    free(x->point);
    *x = (orr_gpt3){.point = NULL};
}
