// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/troposphere/vmf3_series.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <strings.h>

#include "core/array.h"
#include "ingest/input/text_records.h"

// The records of one station, by ascending time.
typedef struct station_records {
    size_t first, n;
} station_records;

struct orr_vmf3_series {
    size_t n_grids;
    orr_vmf3_grid *grid;  // by ascending time
    double *height_m;     // of the grid's points
    orr_vmf3_sites sites; // by station, and by ascending time
    size_t n_stations;
    station_records *station;
    bool gradients;
    orr_span span;
};

static orr_status add_file(orr_vmf3_series *v, const char *path, const orr_read_limits *limits,
                           orr_diag *diag)
{
    orr_bytes b;
    orr_status s = orr_records_load(
        path, limits, ORR_KIND_BIT(ORR_KIND_VMF3_GRID) | ORR_KIND_BIT(ORR_KIND_VMF3_SITE), &b, diag);
    if (s != ORR_OK) return s;
    const orr_kind kind = orr_sniff((orr_view){b.text, b.n}).kind;
    if (kind == ORR_KIND_VMF3_SITE && v->n_grids == 0) {
        s = orr_vmf3_sites_parse(path, b.text, b.n, limits, &v->sites, diag);
    } else if (kind == ORR_KIND_VMF3_GRID && v->sites.n == 0) {
        s = ORR_ARRAY_GROW(v->grid, v->n_grids) ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        if (s == ORR_OK) s = orr_vmf3_grid_parse(path, b.text, b.n, limits, &v->grid[v->n_grids], diag);
        v->n_grids += s == ORR_OK ? 1 : 0;
    } else if (kind == ORR_KIND_VMF3_SITE || kind == ORR_KIND_VMF3_GRID) {
        s = orr_diag_at(diag, ORR_E_KIND, path, 0, 0,
                        "troposphere.files are all grids or all of stations: this is %s",
                        orr_kind_name(kind));
    } else {
        s = orr_diag_at(diag, ORR_E_KIND, path, 0, 0, "this is %s, not VMF3 on a grid or of stations",
                        orr_kind_name(kind));
    }
    orr_bytes_free(&b);
    return s;
}

static int by_time(const void *a, const void *b)
{
    const orr_vmf3_grid *x = a, *y = b;
    return (x->t > y->t) - (x->t < y->t);
}

static int by_station_and_time(const void *a, const void *b)
{
    const orr_vmf3_record *x = a, *y = b;
    const int names = strcasecmp(x->station, y->station);
    return names != 0 ? names : (x->t > y->t) - (x->t < y->t);
}

static bool same_lattice(const orr_lattice *a, const orr_lattice *b)
{
    return a->n_lat == b->n_lat && a->n_lon == b->n_lon && a->lat_deg == b->lat_deg &&
           a->lon_deg == b->lon_deg && a->lat_step_deg == b->lat_step_deg &&
           a->lon_step_deg == b->lon_step_deg;
}

static orr_status settle_grids(orr_vmf3_series *v, orr_diag *diag)
{
    char text[ORR_TIME_TEXT];
    qsort(v->grid, v->n_grids, sizeof *v->grid, by_time);
    v->gradients = true;
    for (size_t k = 0; k < v->n_grids; k++) {
        v->gradients = v->gradients && v->grid[k].gradients;
        if (k == 0) continue;
        if (v->grid[k].t == v->grid[k - 1].t)
            return orr_diag_set(diag, ORR_E_FORMAT, "troposphere.files: two grids of %s",
                                orr_time_text(v->grid[k].t, text));
        if (!same_lattice(&v->grid[k].lattice, &v->grid[0].lattice))
            return orr_diag_set(diag, ORR_E_FORMAT,
                                "troposphere.files: the grid of %s has other points than the first",
                                orr_time_text(v->grid[k].t, text));
    }
    v->span = (orr_span){v->grid[0].t, v->grid[v->n_grids - 1].t};
    return ORR_OK;
}

static orr_status settle_stations(orr_vmf3_series *v, orr_diag *diag)
{
    orr_vmf3_record *r = v->sites.record;
    size_t kept = 0;
    qsort(r, v->sites.n, sizeof *r, by_station_and_time);
    v->gradients = true;
    v->span = (orr_span){r[0].t, r[0].t};
    for (size_t k = 0; k < v->sites.n; k++) {
        // Files of days that follow each other both have the midnight between them.
        if (kept > 0 && by_station_and_time(&r[kept - 1], &r[k]) == 0) continue;
        const bool new_one = kept == 0 || strcasecmp(r[kept - 1].station, r[k].station) != 0;
        if (new_one) {
            if (!ORR_ARRAY_GROW(v->station, v->n_stations))
                return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
            v->station[v->n_stations++] = (station_records){kept, 0};
        }
        v->station[v->n_stations - 1].n++;
        r[kept++] = r[k];
        v->gradients = v->gradients && !isnan(r[k].v.north_wet_m);
        if (r[k].t < v->span.from) v->span.from = r[k].t;
        if (r[k].t > v->span.to) v->span.to = r[k].t;
    }
    v->sites.n = kept;
    return ORR_OK;
}

static orr_status read_heights(orr_vmf3_series *v, const char *path, const orr_read_limits *limits,
                               orr_diag *diag)
{
    orr_bytes b;
    const size_t points = v->grid[0].lattice.n_lat * v->grid[0].lattice.n_lon;
    v->height_m = calloc(points, sizeof *v->height_m);
    if (v->height_m == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    orr_status s = orr_records_load(path, limits, 0, &b, diag);
    if (s != ORR_OK) return s;
    s = orr_vmf3_heights_parse(path, b.text, b.n, points, v->height_m, diag);
    orr_bytes_free(&b);
    return s;
}

static orr_status settle(orr_vmf3_series *v, const char *heights, const orr_read_limits *limits,
                         orr_diag *diag)
{
    char text[ORR_TIME_TEXT];
    if ((v->n_grids > 0) != (heights != NULL))
        return orr_diag_set(diag, ORR_E_ARG, "%s",
                            v->n_grids > 0 ? "troposphere.files: grids of VMF3 need the heights of their "
                                             "points (troposphere.orography)"
                                           : "troposphere.orography: has no effect with files of stations");
    orr_status s = v->n_grids > 0 ? settle_grids(v, diag) : settle_stations(v, diag);
    if (s == ORR_OK && heights != NULL) s = read_heights(v, heights, limits, diag);
    if (s == ORR_OK && v->span.from == v->span.to)
        s = orr_diag_set(
            diag, ORR_E_NODATA,
            "troposphere.files: they have %s alone: two instants at least, around the scenario's time",
            orr_time_text(v->span.from, text));
    return s;
}

orr_status orr_vmf3_series_open(const char *const *file, size_t n, const char *heights,
                                const orr_leap_table *leap, orr_vmf3_series **out, orr_diag *diag)
{
    orr_read_limits limits = orr_read_default_limits();
    limits.leap = leap;
    *out = NULL;
    orr_vmf3_series *v = calloc(1, sizeof *v);
    if (v == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    orr_status s = ORR_OK;
    for (size_t k = 0; s == ORR_OK && k < n; k++) s = add_file(v, file[k], &limits, diag);
    if (s == ORR_OK) s = settle(v, heights, &limits, diag);
    if (s == ORR_OK)
        *out = v;
    else
        orr_vmf3_series_close(v);
    return s;
}

void orr_vmf3_series_close(orr_vmf3_series *v)
{
    if (v == NULL) return;
    for (size_t k = 0; k < v->n_grids; k++) orr_vmf3_grid_free(&v->grid[k]);
    free(v->grid);
    free(v->height_m);
    free(v->station);
    orr_vmf3_sites_free(&v->sites);
    free(v);
}

bool orr_vmf3_series_of_stations(const orr_vmf3_series *v) { return v->n_grids == 0; }
bool orr_vmf3_series_has_gradients(const orr_vmf3_series *v) { return v->gradients; }
orr_span orr_vmf3_series_span(const orr_vmf3_series *v) { return v->span; }

bool orr_vmf3_series_find(const orr_vmf3_series *v, const char *name, size_t *station, char *listed, size_t n)
{
    size_t used = 0;
    listed[0] = '\0';
    for (size_t k = 0; k < v->n_stations; k++) {
        const char *have = v->sites.record[v->station[k].first].station;
        if (strcasecmp(have, name) == 0) {
            *station = k;
            return true;
        }
        if (used < n) used += (size_t)snprintf(listed + used, n - used, "%s%s", k > 0 ? ", " : "", have);
    }
    return false;
}

static orr_vmf3_values blend(const orr_vmf3_values *a, double wa, const orr_vmf3_values *b, double wb)
{
    return (orr_vmf3_values){wa * a->a_hydrostatic + wb * b->a_hydrostatic,
                             wa * a->a_wet + wb * b->a_wet,
                             wa * a->hydrostatic_m + wb * b->hydrostatic_m,
                             wa * a->wet_m + wb * b->wet_m,
                             wa * a->north_hydrostatic_m + wb * b->north_hydrostatic_m,
                             wa * a->east_hydrostatic_m + wb * b->east_hydrostatic_m,
                             wa * a->north_wet_m + wb * b->north_wet_m,
                             wa * a->east_wet_m + wb * b->east_wet_m};
}

// Delays of a point brought from its height to another: Kouba 2008, eqs. (3) to (5). Above 44 km no pressure is left.
static void lift(orr_vmf3_values *x, double lat_rad, double from_m, double to_m)
{
    const double flat = 1 - 0.00266 * cos(2 * lat_rad);
    const double pressure = x->hydrostatic_m / 0.0022768 * (flat - 0.28e-6 * from_m);
    const double left = fmax(1 - 0.0000226 * (to_m - from_m), 0);
    x->hydrostatic_m = 0.0022768 * pressure * pow(left, 5.225) / (flat - 0.28e-6 * to_m);
    x->wet_m *= exp(-(to_m - from_m) / 2000);
}

// Share of the later of two instants.
static double later(orr_time from, orr_time to, orr_time t)
{
    return orr_time_diff_s(t, from) / orr_time_diff_s(to, from);
}

static bool grids_at(const orr_vmf3_series *v, orr_geodetic place, orr_time t, orr_vmf3_values *out)
{
    orr_lattice_cell cell;
    size_t k = 0;
    if (!orr_lattice_find(&v->grid[0].lattice, place.lat_rad * ORR_DEG_PER_RAD,
                          place.lon_rad * ORR_DEG_PER_RAD, &cell))
        return false;
    while (k + 2 < v->n_grids && t >= v->grid[k + 1].t) k++;
    const double w = later(v->grid[k].t, v->grid[k + 1].t, t);
    *out = (orr_vmf3_values){.wet_m = 0};
    for (int j = 0; j < 4; j++) {
        const size_t p = cell.at[j];
        orr_vmf3_values x = blend(&v->grid[k].point[p], 1 - w, &v->grid[k + 1].point[p], w);
        lift(&x, place.lat_rad, v->height_m[p], place.height_m);
        *out = blend(out, 1, &x, cell.weight[j]);
    }
    return true;
}

bool orr_vmf3_series_at(const orr_vmf3_series *v, size_t station, orr_geodetic place, orr_time t,
                        orr_vmf3_values *out)
{
    if (!orr_span_holds(v->span, t)) return false;
    if (v->n_grids > 0) return grids_at(v, place, t, out);
    const station_records *of = &v->station[station];
    const orr_vmf3_record *r = v->sites.record + of->first;
    if (of->n < 2 || t < r[0].t || t > r[of->n - 1].t) return false;
    size_t low = 0, high = of->n - 1;
    while (high - low > 1) {
        const size_t middle = (low + high) / 2;
        *(t >= r[middle].t ? &low : &high) = middle;
    }
    const double w = later(r[low].t, r[high].t, t);
    *out = blend(&r[low].v, 1 - w, &r[high].v, w);
    return true;
}
