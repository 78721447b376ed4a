// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/maps/esri_grid.h"

#include <math.h>
#include <stdlib.h>
#include <strings.h>

#include "ingest/input/sniff.h"
#include "ingest/input/text_records.h"

enum { NCOLS, NROWS, XCORNER, XCENTER, YCORNER, YCENTER, CELLSIZE, DX, DY, NODATA, KEYS };
static const char *const key[KEYS] = {"ncols",     "nrows",    "xllcorner", "xllcenter", "yllcorner",
                                      "yllcenter", "cellsize", "dx",        "dy",        "nodata_value"};

typedef struct header {
    double value[KEYS];
    bool has[KEYS];
} header;

static int key_of(orr_view word)
{
    char name[16];
    orr_view_copy(word, name, sizeof name);
    for (int k = 0; k < KEYS; k++)
        if (strcasecmp(name, key[k]) == 0) return k;
    return -1;
}

// Lines of a key and a number; *line is the first that is none.
static orr_status read_header(orr_cursor *c, header *h, orr_view *line, orr_diag *diag)
{
    double number;
    while (orr_cursor_next(c, line)) {
        orr_view rest = *line, word;
        if (!orr_view_word(&rest, &word)) continue;
        if (orr_view_real(word, &number) == ORR_FIELD_OK) return ORR_OK;
        const int k = key_of(word);
        if (k < 0)
            return orr_cursor_error(c, diag, ORR_E_FORMAT, 0, "'%.*s' is no key of such a grid's header",
                                    (int)(word.n < 20 ? word.n : 20), word.p);
        if (!orr_view_word(&rest, &word) || orr_view_real(word, &h->value[k]) != ORR_FIELD_OK)
            return orr_cursor_error(c, diag, ORR_E_FORMAT, 0, "%s has no number", key[k]);
        h->has[k] = true;
    }
    const orr_status s = orr_cursor_status(c, diag);
    return s != ORR_OK ? s : orr_cursor_error(c, diag, ORR_E_FORMAT, 0, "no heights follow the header");
}

static bool is_count(double x) { return x >= 2 && x <= 1e6 && x == floor(x); }

// The grid that a header tells of, without its heights.
static orr_status lay_out(const orr_cursor *c, const header *h, const orr_read_limits *limits,
                          orr_esri_grid *out, orr_diag *diag)
{
    const bool x = h->has[XCORNER] || h->has[XCENTER], y = h->has[YCORNER] || h->has[YCENTER],
               step = h->has[CELLSIZE] || (h->has[DX] && h->has[DY]);
    if (!h->has[NCOLS] || !h->has[NROWS] || !x || !y || !step)
        return orr_cursor_error(c, diag, ORR_E_FORMAT, 0, "the header has no %s",
                                !h->has[NCOLS]   ? "ncols"
                                : !h->has[NROWS] ? "nrows"
                                : !x             ? "xllcorner or xllcenter"
                                : !y             ? "yllcorner or yllcenter"
                                                 : "cellsize");
    if (!is_count(h->value[NCOLS]) || !is_count(h->value[NROWS]))
        return orr_cursor_error(c, diag, ORR_E_FORMAT, 0, "%g columns and %g rows are no grid",
                                h->value[NCOLS], h->value[NROWS]);
    const double dx = h->has[CELLSIZE] ? h->value[CELLSIZE] : h->value[DX],
                 dy = h->has[CELLSIZE] ? h->value[CELLSIZE] : h->value[DY];
    if (!(dx > 0 && dy > 0)) return orr_cursor_error(c, diag, ORR_E_FORMAT, 0, "cells of no size");
    const double west = h->has[XCENTER] ? h->value[XCENTER] : h->value[XCORNER] + dx / 2,
                 south = h->has[YCENTER] ? h->value[YCENTER] : h->value[YCORNER] + dy / 2,
                 north = south + (h->value[NROWS] - 1) * dy, width = h->value[NCOLS] * dx;
    if (!(south >= -90 && north <= 90 && west >= -360 && west <= 360 && width <= 360 + dx))
        return orr_cursor_error(
            c, diag, ORR_E_UNSUPPORTED, 0,
            "coordinates from %g %g on are no degrees of longitude and latitude: bring the grid from "
            "its projection to geographic coordinates first",
            west, south);
    if (h->value[NCOLS] * h->value[NROWS] > (double)limits->max_values)
        return orr_cursor_error(c, diag, ORR_E_LIMIT, 0, "%.0f heights: more than %zu",
                                h->value[NCOLS] * h->value[NROWS], limits->max_values);
    *out = (orr_esri_grid){.columns = (size_t)h->value[NCOLS],
                           .rows = (size_t)h->value[NROWS],
                           .west_deg = west,
                           .north_deg = north,
                           .lon_step_deg = dx,
                           .lat_step_deg = dy};
    return ORR_OK;
}

static orr_status read_heights(orr_cursor *c, const header *h, orr_view line, orr_esri_grid *out,
                               orr_diag *diag)
{
    const size_t n = out->columns * out->rows;
    const double none = h->has[NODATA] ? h->value[NODATA] : -9999;
    size_t k = 0;
    do {
        orr_view word;
        while (orr_view_word(&line, &word)) {
            double v;
            if (orr_view_real(word, &v) != ORR_FIELD_OK || (v != none && !(v >= -12000 && v <= 9000)))
                return orr_cursor_error(c, diag, ORR_E_FORMAT, 0, "'%.*s' is no height in metres",
                                        (int)(word.n < 20 ? word.n : 20), word.p);
            if (k == n)
                return orr_cursor_error(c, diag, ORR_E_FORMAT, 0, "more than %zu x %zu heights", out->columns,
                                        out->rows);
            out->height_m[k++] = v == none ? NAN : (float)v;
        }
    } while (orr_cursor_next(c, &line));
    const orr_status s = orr_cursor_status(c, diag);
    if (s != ORR_OK || k == n) return s;
    return orr_cursor_error(c, diag, ORR_E_FORMAT, 0, "the file ends after %zu of %zu x %zu heights", k,
                            out->columns, out->rows);
}

orr_status orr_esri_grid_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                               orr_esri_grid *out, orr_diag *diag)
{
    const orr_read_limits l = limits != NULL ? *limits : orr_read_default_limits();
    header h = {.has = {false}};
    orr_cursor c;
    orr_view line;
    *out = (orr_esri_grid){.height_m = NULL};
    orr_cursor_init(&c, name, text, n);
    c.max_line = n + 1; // a row is a line, however many columns it has
    orr_status s = read_header(&c, &h, &line, diag);
    if (s == ORR_OK) s = lay_out(&c, &h, &l, out, diag);
    if (s != ORR_OK) return s;
    // Each height takes two bytes: a short file cannot ask for much.
    if (out->columns * out->rows > n / 2 + 1)
        return orr_cursor_error(&c, diag, ORR_E_FORMAT, 0, "the file is too short for %zu x %zu heights",
                                out->columns, out->rows);
    out->height_m = malloc(out->columns * out->rows * sizeof *out->height_m);
    s = out->height_m != NULL ? read_heights(&c, &h, line, out, diag)
                              : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (s != ORR_OK) orr_esri_grid_free(out);
    return s;
}

orr_status orr_esri_grid_read(const char *path, const orr_read_limits *limits, orr_esri_grid *out,
                              orr_diag *diag)
{
    orr_bytes b;
    *out = (orr_esri_grid){.height_m = NULL};
    orr_status s = orr_records_load(path, limits, ORR_KIND_BIT(ORR_KIND_ESRI_GRID), &b, diag);
    if (s != ORR_OK) return s;
    s = orr_esri_grid_parse(path, b.text, b.n, limits, out, diag);
    orr_bytes_free(&b);
    return s;
}

void orr_esri_grid_free(orr_esri_grid *x)
{
    free(x->height_m);
    *x = (orr_esri_grid){.height_m = NULL};
}
