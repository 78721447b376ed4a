// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/troposphere/vmf3.h"

#include <math.h>
#include <stdlib.h>

#include "core/array.h"
#include "core/nan.h"
#include "ingest/input/text_records.h"

enum { VALUES = 4, GRADIENTS = 4, WEATHER = 3, MOST = VALUES + WEATHER + GRADIENTS };

// Numbers of a line, MOST at most; columns tells how many there are.
static orr_status read_numbers(orr_cursor *c, orr_view line, double *v, int most, int *columns,
                               orr_diag *diag)
{
    orr_view word;
    *columns = 0;
    while (*columns < most && orr_view_word(&line, &word)) {
        if (orr_view_real(word, &v[*columns]) != ORR_FIELD_OK)
            return orr_cursor_error(c, diag, ORR_E_FORMAT, 0, "'%.*s' is no number",
                                    (int)(word.n < 20 ? word.n : 20), word.p);
        ++*columns;
    }
    return ORR_OK;
}

// The values of v[4], and of gradient[4], in mm, where they are told.
static orr_status keep(orr_cursor *c, const double *v, const double *gradient_mm, orr_vmf3_values *out,
                       orr_diag *diag)
{
    if (!(v[0] >= 5e-4 && v[0] <= 2e-3 && fabs(v[1]) <= 2e-3)) // a_w is below zero in dry polar air
        return orr_cursor_error(c, diag, ORR_E_FORMAT, 0, "coefficients a of %g and %g cannot be", v[0],
                                v[1]);
    if (!(v[2] >= 0.5 && v[2] <= 3 && v[3] >= -0.1 && v[3] <= 1))
        return orr_cursor_error(c, diag, ORR_E_FORMAT, 0, "zenith delays of %g and %g m cannot be", v[2],
                                v[3]);
    double g[GRADIENTS] = {ORR_NAN, ORR_NAN, ORR_NAN, ORR_NAN};
    for (int k = 0; gradient_mm != NULL && k < GRADIENTS; k++) {
        g[k] = 1e-3 * gradient_mm[k];
        if (!(fabs(gradient_mm[k]) <= 50))
            return orr_cursor_error(c, diag, ORR_E_FORMAT, 0, "a gradient of %g mm cannot be",
                                    gradient_mm[k]);
    }
    *out = (orr_vmf3_values){v[0], v[1], v[2], v[3], g[0], g[1], g[2], g[3]};
    return ORR_OK;
}

// The rest of a header line behind a word, if it begins with that.
static bool header_of(orr_view line, const char *word, orr_view *rest)
{
    line = orr_view_trim((orr_view){line.p + 1, line.n - 1});
    const orr_view w = orr_view_of(word);
    if (!orr_view_starts(line, word)) return false;
    *rest = orr_view_trim((orr_view){line.p + w.n, line.n - w.n});
    return true;
}

typedef struct grid_reader {
    orr_cursor c;
    orr_lattice_point *place;
    size_t n, limit;
    double scale;
    const orr_leap_table *leap;
    orr_vmf3_grid *out;
    orr_diag *diag;
} grid_reader;

static orr_status read_header(grid_reader *r, orr_view line)
{
    orr_view rest;
    if (header_of(line, "Epoch:", &rest) && !orr_records_civil(rest, ORR_SCALE_UTC, r->leap, &r->out->t))
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0, "this epoch is no date");
    if (header_of(line, "Scale_factor:", &rest) &&
        (orr_view_real(rest, &r->scale) != ORR_FIELD_OK || r->scale != 1))
        return orr_cursor_error(&r->c, r->diag, ORR_E_UNSUPPORTED, 0, "a scale factor other than 1");
    return ORR_OK;
}

static orr_status read_point(grid_reader *r, orr_view line)
{
    double v[2 + VALUES + GRADIENTS];
    int columns;
    orr_status s = read_numbers(&r->c, line, v, 2 + VALUES + GRADIENTS, &columns, r->diag);
    if (s != ORR_OK) return s;
    const bool gradients = columns == 2 + VALUES + GRADIENTS;
    if (!gradients && columns != 2 + VALUES)
        return orr_cursor_error(
            &r->c, r->diag, ORR_E_FORMAT, 0,
            "a point has 6 numbers (latitude, longitude, a_h, a_w, both delays), or 10 with "
            "gradients; this one has %d",
            columns);
    if (r->n > 0 && gradients != r->out->gradients)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0,
                                "some points have gradients, some have none");
    r->out->gradients = gradients;
    s = orr_records_grow(&r->out->point, r->n, sizeof *r->out->point, r->limit, "points", &r->c, r->diag);
    if (s == ORR_OK)
        s = orr_records_grow(&r->place, r->n, sizeof *r->place, r->limit, "points", &r->c, r->diag);
    if (s == ORR_OK) s = keep(&r->c, v + 2, gradients ? v + 2 + VALUES : NULL, &r->out->point[r->n], r->diag);
    if (s != ORR_OK) return s;
    r->place[r->n++] = (orr_lattice_point){v[0], v[1]};
    return ORR_OK;
}

static orr_status read_grid(grid_reader *r)
{
    orr_view line;
    size_t bad;
    orr_status s = ORR_OK;
    while (s == ORR_OK && orr_cursor_next(&r->c, &line)) {
        const orr_view inside = orr_view_trim(line);
        if (inside.n == 0) continue;
        s = inside.p[0] == '!' ? read_header(r, inside) : read_point(r, inside);
    }
    if (s == ORR_OK) s = orr_cursor_status(&r->c, r->diag);
    if (s != ORR_OK) return s;
    if (r->out->t == ORR_TIME_NONE)
        return orr_diag_at(r->diag, ORR_E_FORMAT, r->c.name, 0, 0, "no line '! Epoch:' tells its instant");
    if (!orr_lattice_learn(r->place, r->n, &r->out->lattice, &bad))
        return orr_diag_at(r->diag, ORR_E_FORMAT, r->c.name, 0, 0,
                           "point %zu of %zu is not where a grid of equal steps has it", bad + 1, r->n);
    return ORR_OK;
}

orr_status orr_vmf3_grid_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                               orr_vmf3_grid *out, orr_diag *diag)
{
    const orr_read_limits l = limits != NULL ? *limits : orr_read_default_limits();
    grid_reader r = {.scale = 1, .leap = l.leap, .out = out, .limit = l.max_records, .diag = diag};
    *out = (orr_vmf3_grid){.t = ORR_TIME_NONE};
    orr_cursor_init(&r.c, name, text, n);
    const orr_status s = read_grid(&r);
    free(r.place);
    if (s != ORR_OK) orr_vmf3_grid_free(out);
    return s;
}

void orr_vmf3_grid_free(orr_vmf3_grid *x)
{
    free(x->point);
    *x = (orr_vmf3_grid){.t = ORR_TIME_NONE};
}

orr_status orr_vmf3_heights_parse(const char *name, const char *text, size_t n, size_t points, double *out,
                                  orr_diag *diag)
{
    orr_cursor c;
    orr_view line, word;
    size_t count = 0;
    orr_cursor_init(&c, name, text, n);
    while (orr_cursor_next(&c, &line))
        while (orr_view_word(&line, &word)) {
            double h;
            if (orr_view_real(word, &h) != ORR_FIELD_OK || !(h >= -1000 && h <= 9000))
                return orr_cursor_error(&c, diag, ORR_E_FORMAT, 0, "'%.*s' is no height of ground",
                                        (int)(word.n < 20 ? word.n : 20), word.p);
            if (count < points) out[count] = h;
            count++;
        }
    const orr_status s = orr_cursor_status(&c, diag);
    if (s != ORR_OK || count == points) return s;
    return orr_diag_at(diag, ORR_E_FORMAT, name, 0, 0,
                       "%zu heights, where the grid has %zu points: it takes the file of its own resolution",
                       count, points);
}

static orr_status read_record(orr_cursor *c, orr_view line, const orr_leap_table *leap, orr_vmf3_record *out,
                              orr_diag *diag)
{
    orr_view station, word;
    double mjd, v[MOST];
    int columns;
    if (!orr_view_word(&line, &station) || !orr_view_word(&line, &word) ||
        orr_view_real(word, &mjd) != ORR_FIELD_OK || !(mjd >= 40000 && mjd <= 90000))
        return orr_cursor_error(c, diag, ORR_E_FORMAT, 0, "no station and modified Julian date");
    const orr_status s = read_numbers(c, line, v, MOST, &columns, diag);
    if (s != ORR_OK) return s;
    if (columns < VALUES)
        return orr_cursor_error(
            c, diag, ORR_E_FORMAT, 0,
            "a station has a_h, a_w, and both zenith delays behind its date; this one has %d "
            "numbers",
            columns);
    orr_view_copy(station, out->station, sizeof out->station);
    out->t = orr_time_from_mjd((int32_t)floor(mjd), mjd - floor(mjd), ORR_SCALE_UTC, leap);
    return keep(c, v, columns == MOST ? v + VALUES + WEATHER : NULL, &out->v, diag);
}

orr_status orr_vmf3_sites_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                                orr_vmf3_sites *out, orr_diag *diag)
{
    const orr_read_limits l = limits != NULL ? *limits : orr_read_default_limits();
    const size_t before = out->n;
    orr_cursor c;
    orr_view line;
    orr_cursor_init(&c, name, text, n);
    while (orr_cursor_next(&c, &line)) {
        const orr_view inside = orr_view_trim(line);
        if (inside.n == 0 || inside.p[0] == '!' || inside.p[0] == '#' || inside.p[0] == '%') continue;
        orr_status s =
            orr_records_grow(&out->record, out->n, sizeof *out->record, l.max_records, "records", &c, diag);
        if (s == ORR_OK) s = read_record(&c, inside, l.leap, &out->record[out->n], diag);
        if (s != ORR_OK) return s;
        out->n++;
    }
    const orr_status s = orr_cursor_status(&c, diag);
    if (s != ORR_OK || out->n > before) return s;
    return orr_diag_at(diag, ORR_E_FORMAT, name, 0, 0, "no station of VMF3 is in it");
}

void orr_vmf3_sites_free(orr_vmf3_sites *x)
{
    free(x->record);
    *x = (orr_vmf3_sites){.n = 0};
}
