// SPDX-License-Identifier: GPL-3.0-or-later
// Rays through a TEC field: harmonics beside bilinear maps, one ray with everything that depends on time made
// anew, and all satellites of an epoch.
#include <math.h>
#include <stdlib.h>

#include "bench/bench.h"
#include "core/rng.h"
#include "iono/field/tec_field.h"

enum { MAPS = 25, ROWS = 71, COLS = 73, SATS = 32, TIMES = 64 };

typedef struct job {
    orr_tec_field *field;
    orr_iono_site site;
    orr_vec3 sat[SATS];
    orr_time t[TIMES];
    size_t next;
} job;

static void one_ray(void *arg)
{
    job *j = arg;
    orr_tec_instant at;
    orr_tec_ray r;
    size_t k = j->next++;
    if (orr_tec_field_at(j->field, j->t[k % TIMES], &at, NULL) != ORR_OK ||
        orr_tec_look(&at, &j->site, j->sat[k % SATS], &r, NULL) != ORR_OK)
        abort();
    bench_use(r.stec_tecu);
}

static void one_epoch(void *arg)
{
    job *j = arg;
    orr_tec_instant at;
    if (orr_tec_field_at(j->field, j->t[j->next++ % TIMES], &at, NULL) != ORR_OK) abort();
    for (size_t i = 0; i < SATS; i++) {
        orr_tec_ray r;
        if (orr_tec_look(&at, &j->site, j->sat[i], &r, NULL) != ORR_OK) abort();
        bench_use(r.stec_tecu);
    }
}

static void pierce(void *arg)
{
    job *j = arg;
    orr_pierce p;
    if (orr_pierce_ray(&j->site, j->sat[j->next++ % SATS], ORR_SHELL_RADIUS_M, &p, NULL) != ORR_OK) abort();
    bench_use(p.lat_rad);
}

typedef struct load {
    orr_tec_maps maps;
    orr_tec_options options;
} load;

static void refit(void *arg)
{
    const load *l = arg;
    orr_tec_field *f;
    if (orr_tec_field_from_maps(&l->maps, &l->options, &f, NULL) != ORR_OK) abort();
    bench_use(orr_tec_field_shell_radius_m(f));
    orr_tec_field_free(f);
}

void bench_tec(bench *b)
{
    bench_group(b, "TEC field, degree 15, 25 hourly maps with RMS maps");
    double *tec = malloc(2 * MAPS * ROWS * COLS * sizeof *tec);
    if (tec == NULL) abort();
    load l = {.options = orr_tec_default_options()};
    static orr_time epoch[MAPS];
    for (size_t k = 0; k < MAPS; k++) {
        epoch[k] = (INT64_C(1391040000) + 3600 * (int64_t)k) * ORR_NS_PER_S;
        for (size_t i = 0; i < ROWS * COLS; i++) {
            double lat = (87.5 - 2.5 * (double)(i / COLS)) * ORR_RAD_PER_DEG,
                   lon = (-180 + 5 * (double)(i % COLS)) * ORR_RAD_PER_DEG;
            tec[k * ROWS * COLS + i] =
                30 + 20 * cos(lat) * cos(lon + 0.26 * (double)k) + 5 * sin(3 * lon) * cos(lat) * cos(lat);
            tec[(MAPS + k) * ROWS * COLS + i] = 1;
        }
    }
    l.maps = (orr_tec_maps){
        MAPS,  ROWS, COLS, 87.5, -2.5, -180, 5, ORR_SHELL_RADIUS_M, 0.1, epoch, tec, tec + MAPS * ROWS * COLS,
        "made"};
    job j = {0}, grid = {0};
    if (orr_iono_site_at(orr_earth_to_ecef((orr_geodetic){0.91, 0.3, 100}), &j.site, NULL) != ORR_OK) abort();
    for (size_t i = 0; i < SATS; i++) {
        double az = 6.28 * orr_rng_uniform(1, 0, i), el = 0.1 + 1.4 * orr_rng_uniform(1, 1, i);
        orr_vec3 d =
            orr_vec3_axpy(cos(el) * sin(az), j.site.east, orr_vec3_scale(cos(el) * cos(az), j.site.north));
        j.sat[i] = orr_vec3_axpy(22e6, orr_vec3_axpy(sin(el), j.site.up, d), j.site.pos_m);
    }
    for (size_t i = 0; i < TIMES; i++) j.t[i] = epoch[0] + (int64_t)(86000e9 * orr_rng_uniform(1, 2, i));
    grid = j;
    load bilinear = l;
    bilinear.options.spatial = ORR_TEC_BILINEAR;
    if (orr_tec_field_from_maps(&l.maps, &l.options, &j.field, NULL) != ORR_OK ||
        orr_tec_field_from_maps(&bilinear.maps, &bilinear.options, &grid.field, NULL) != ORR_OK)
        abort();
    double bare = bench_seconds(b, pierce, &j) * 1e9;
    bench_row(b, "one ray, time anew, harmonics", bench_seconds(b, one_ray, &j) * 1e9,
              bench_seconds(b, one_ray, &grid) * 1e9, "ns", "bilinear");
    bench_row(b, "a satellite of an epoch of 32, harmonics", bench_seconds(b, one_epoch, &j) * 1e9 / SATS,
              bench_seconds(b, one_epoch, &grid) * 1e9 / SATS, "ns", "bilinear");
    bench_row(b, "its pierce point alone", bare, 0, "ns", "");
    bench_row(b, "refit of a day's maps at load", bench_seconds(b, refit, &l) * 1e3, 0, "ms", "");
    orr_tec_field_free(j.field);
    orr_tec_field_free(grid.field);
    free(tec);
}
