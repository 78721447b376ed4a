// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/tables/gravity_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/ncfile.h"
#include "core/vec.h"
#include "ingest/input/input.h"

#define MAX_POINTS ((size_t)20000000)

void orr_gravity_file_free(orr_gravity_file *f)
{
    free(f->distance_m);
    free(f->lat_rad);
    free(f->lon_rad);
    free(f->mgal);
    memset(f, 0, sizeof *f);
}

typedef struct point {
    double lat, lon, mgal; // or distance, 0, mgal
} point;

static int by_place(const void *a, const void *b)
{
    const point *p = a, *q = b;
    if (p->lat != q->lat) return p->lat < q->lat ? -1 : 1;
    return (p->lon > q->lon) - (p->lon < q->lon);
}

// Fields of a row (at most 4 are counted) and how many of them are numbers. An empty field is one, so that a
// row with a hole does not pass for a shorter one.
typedef struct row {
    int fields, numbers;
    double v[4];
} row;

static row read_row(orr_view line)
{
    char separator = memchr(line.p, ',', line.n) != NULL   ? ','
                     : memchr(line.p, ';', line.n) != NULL ? ';'
                                                           : ' ';
    row r = {0};
    orr_view field;
    while (r.fields < 4 &&
           (separator == ' ' ? orr_view_word(&line, &field) : orr_view_split(&line, separator, &field))) {
        r.numbers += orr_view_real(field, &r.v[r.fields]) == ORR_FIELD_OK;
        r.fields++;
    }
    return r;
}

static orr_status read_points(orr_input *in, point **out, size_t *n, int *per_row, orr_diag *diag)
{
    orr_view line;
    bool first = true;
    while (orr_input_line(in, &line)) {
        orr_view v = orr_view_trim(line);
        if (v.n == 0 || v.p[0] == '#') continue;
        row r = read_row(v);
        bool header = first && r.numbers == 0;
        first = false;
        if (header) continue;
        int k = r.numbers;
        if (*per_row == 0) *per_row = k;
        if ((k != 2 && k != 3) || k != *per_row || k != r.fields)
            return orr_diag_at(diag, ORR_E_FORMAT, orr_input_name(in), orr_input_line_number(in), 0,
                               "a row of gravity has two numbers (distance in m, mGal) or three (latitude, "
                               "longitude, mGal), the "
                               "same in all rows");
        if (*n == MAX_POINTS)
            return orr_diag_at(diag, ORR_E_LIMIT, orr_input_name(in), orr_input_line_number(in), 0,
                               "more than %zu points", MAX_POINTS);
        if (!orr_array_grow(out, *n, sizeof **out))
            return orr_diag_set(diag, ORR_E_MEMORY, "no memory for more than %zu points of gravity", *n);
        (*out)[(*n)++] = k == 2 ? (point){r.v[0], 0.0, r.v[1]} : (point){r.v[0], r.v[1], r.v[2]};
    }
    orr_status s = orr_input_status(in, diag);
    if (s == ORR_OK && *n == 0)
        s = orr_diag_at(diag, ORR_E_FORMAT, orr_input_name(in), 0, 0, "it has no row of gravity");
    return s;
}

static orr_status to_map(const char *path, point *p, size_t n, orr_gravity_file *f, orr_diag *diag)
{
    qsort(p, n, sizeof *p, by_place);
    size_t n_lon = 1;
    while (n_lon < n && p[n_lon].lat == p[0].lat) n_lon++;
    f->n_lon = n_lon;
    f->n_lat = n / n_lon;
    bool grid = f->n_lat * n_lon == n;
    for (size_t k = 0; k < n && grid; k++)
        grid = p[k].lon == p[k % n_lon].lon && p[k].lat == p[k / n_lon * n_lon].lat &&
               (k % n_lon == 0 || p[k].lon > p[k - 1].lon);
    if (!grid)
        return orr_diag_at(
            diag, ORR_E_FORMAT, path, 0, 0,
            "its %zu points do not fill a grid of latitudes and longitudes (the first row of it has %zu)", n,
            n_lon);
    f->lat_rad = malloc(f->n_lat * sizeof(double));
    f->lon_rad = malloc(n_lon * sizeof(double));
    f->mgal = malloc(n * sizeof(double));
    if (f->lat_rad == NULL || f->lon_rad == NULL || f->mgal == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a map of %zu points", n);
    for (size_t k = 0; k < n; k++) {
        f->lat_rad[k / n_lon] = p[k].lat * ORR_RAD_PER_DEG;
        f->lon_rad[k % n_lon] = p[k].lon * ORR_RAD_PER_DEG;
        f->mgal[k] = p[k].mgal;
    }
    return ORR_OK;
}

static orr_status to_profile(const point *p, size_t n, orr_gravity_file *f, orr_diag *diag)
{
    f->n_profile = n;
    f->distance_m = malloc(n * sizeof(double));
    f->mgal = malloc(n * sizeof(double));
    if (f->distance_m == NULL || f->mgal == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a profile of %zu points", n);
    for (size_t k = 0; k < n; k++) {
        f->distance_m[k] = p[k].lat;
        f->mgal[k] = p[k].mgal;
    }
    return ORR_OK;
}

static const char *first_of(const orr_nc_reader *r, const char *const name[3])
{
    for (int k = 0; k < 3; k++)
        if (orr_nc_has_var(r, name[k])) return name[k];
    return name[0];
}

// From North to South, as many maps lie, to ascending latitudes.
static void turn_over(orr_gravity_file *f)
{
    for (size_t i = 0, k = f->n_lat - 1; i < k; i++, k--) {
        double lat = f->lat_rad[i];
        f->lat_rad[i] = f->lat_rad[k];
        f->lat_rad[k] = lat;
        for (size_t j = 0; j < f->n_lon; j++) {
            double *a = &f->mgal[i * f->n_lon + j], *b = &f->mgal[k * f->n_lon + j], value = *a;
            *a = *b;
            *b = value;
        }
    }
}

static orr_status read_netcdf(const char *name, const void *data, size_t n, orr_gravity_file *f,
                              orr_diag *diag)
{
    static const char *const lats[3] = {"lat", "latitude", "y"}, *const lons[3] = {"lon", "longitude", "x"},
                             *const values[3] = {"disturbance", "gravity_disturbance", "mgal"};
    orr_nc_reader r;
    orr_status s = orr_nc_open_memory(name, data, n, &r, diag);
    if (s != ORR_OK) return s;
    const char *lat = first_of(&r, lats), *lon = first_of(&r, lons);
    void *a = NULL, *b = NULL, *c = NULL;
    s = orr_nc_get_dim(&r, lat, MAX_POINTS, &f->n_lat, diag);
    if (s == ORR_OK) s = orr_nc_get_dim(&r, lon, MAX_POINTS / (f->n_lat > 0 ? f->n_lat : 1), &f->n_lon, diag);
    size_t shape[2] = {f->n_lat, f->n_lon};
    if (s == ORR_OK) s = orr_nc_alloc_var(&r, lat, ORR_NC_DOUBLE, 1, &f->n_lat, &a, diag);
    if (s == ORR_OK) s = orr_nc_alloc_var(&r, lon, ORR_NC_DOUBLE, 1, &f->n_lon, &b, diag);
    if (s == ORR_OK) s = orr_nc_alloc_var(&r, first_of(&r, values), ORR_NC_DOUBLE, 2, shape, &c, diag);
    orr_nc_close(&r);
    f->lat_rad = a;
    f->lon_rad = b;
    f->mgal = c;
    if (s != ORR_OK) return s;
    for (size_t k = 0; k < f->n_lat; k++) f->lat_rad[k] *= ORR_RAD_PER_DEG;
    for (size_t k = 0; k < f->n_lon; k++) f->lon_rad[k] *= ORR_RAD_PER_DEG;
    if (f->n_lat > 1 && f->lat_rad[0] > f->lat_rad[f->n_lat - 1]) turn_over(f);
    return ORR_OK;
}

// Closes `in`.
static orr_status read_text(orr_input *in, orr_gravity_file *out, orr_diag *diag)
{
    point *p = NULL;
    size_t n = 0;
    int per_row = 0;
    orr_status s = read_points(in, &p, &n, &per_row, diag);
    if (s == ORR_OK)
        s = per_row == 3 ? to_map(orr_input_name(in), p, n, out, diag) : to_profile(p, n, out, diag);
    free(p);
    orr_input_close(in);
    return s;
}

orr_status orr_gravity_file_parse(const char *name, const void *data, size_t n, orr_gravity_file *out,
                                  orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_input *in;
    orr_status s;
    if (orr_nc_is_netcdf(data, n))
        s = read_netcdf(name, data, n, out, diag);
    else if ((s = orr_input_open_bytes(name, data, n, NULL, &in, diag)) == ORR_OK)
        s = read_text(in, out, diag);
    if (s != ORR_OK) orr_gravity_file_free(out);
    return s;
}
