// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/archive/catalogue.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "core/robust.h"
#include "orbit/ephemeris/ephemeris.h"
#include "src/archive/catalogue_cache.h"
#include "src/archive/store.h"

#define UNUSUAL 6.0 // robust standard deviations from the median of all days

orr_status orr_catalogue_join(const char *a, const char *b, orr_time t, orr_catalogue_joint *out,
                              orr_diag *diag)
{
    orr_ephemeris *e[2] = {NULL, NULL};
    *out = (orr_catalogue_joint){.median_mm = ORR_NAN, .max_mm = ORR_NAN, .max_mps = ORR_NAN};
    orr_status s = orr_ephemeris_load(a, &e[0], diag);
    if (s == ORR_OK) s = orr_ephemeris_load(b, &e[1], diag);
    const orr_sat *sat = NULL;
    const size_t n = s == ORR_OK ? orr_ephemeris_satellites(e[0], &sat) : 0;
    double *apart = calloc(n + 1, sizeof *apart);
    if (s == ORR_OK && apart == NULL) s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu satellites", n);
    for (size_t i = 0; s == ORR_OK && i < n; i++) {
        orr_sat_state x, y;
        if (orr_ephemeris_eval(e[0], sat[i], t, &x) != ORR_OK ||
            orr_ephemeris_eval(e[1], sat[i], t, &y) != ORR_OK)
            continue;
        const double mm = 1e3 * orr_vec3_norm(orr_vec3_sub(x.pos_m, y.pos_m));
        const double mps = orr_vec3_norm(orr_vec3_sub(x.vel_mps, y.vel_mps));
        if (!(mm <= out->max_mm)) out->max_mm = mm, out->max_sat = sat[i];
        if (!(mps <= out->max_mps)) out->max_mps = mps;
        apart[out->satellites++] = mm;
    }
    if (out->satellites > 0) out->median_mm = orr_median(apart, out->satellites);
    free(apart);
    orr_ephemeris_free(e[0]);
    orr_ephemeris_free(e[1]);
    return s;
}

static void take_record(const char *archive, orr_catalogue_day *d)
{
    char folder[ORR_ARCHIVE_PATH];
    orr_archive_record *r = malloc(sizeof *r);
    d->joint = (orr_catalogue_joint){.median_mm = ORR_NAN, .max_mm = ORR_NAN, .max_mps = ORR_NAN};
    d->state = r == NULL ? ORR_E_MEMORY
                         : orr_archive_record_read(orr_archive_path(archive, d->mjd, NULL, folder), r, NULL);
    if (d->state == ORR_OK && r->mjd != d->mjd) d->state = ORR_E_FORMAT; // a folder that somebody moved
    if (d->state == ORR_OK) {
        snprintf(d->program, sizeof d->program, "%s", r->program);
        snprintf(d->key, sizeof d->key, "%s", r->key);
        d->before = r->before;
        d->predicted = orr_archive_is_predicted(r);
        d->after = r->after;
        d->n_notes = r->n_notes;
        for (size_t i = 0; i < r->n_products; i++)
            d->bytes += r->product[i].bytes > 0 ? r->product[i].bytes : 0;
        if (r->n_products > 0) snprintf(d->sha256, sizeof d->sha256, "%s", r->product[0].sha256);
        if (r->n_quality > 0) d->all = r->quality[0];
    }
    free(r);
}

// A day that is observed and whole. What is predicted neither joins nor compares.
static bool judged(const orr_catalogue_day *d) { return d->state == ORR_OK && !d->predicted; }

static orr_status measure_joints(const char *archive, orr_catalogue *c, orr_catalogue_cache *cache,
                                 orr_warnings *warnings)
{
    for (size_t i = 1; i < c->n; i++) {
        orr_catalogue_day *a = &c->day[i - 1], *b = &c->day[i];
        char path[2][ORR_ARCHIVE_PATH];
        orr_diag why = {0};
        if (!judged(a) || !judged(b) || b->mjd != a->mjd + 1) continue;
        if (orr_catalogue_cache_joint(cache, a->sha256, b->sha256, &b->joint)) continue;
        orr_archive_path(archive, a->mjd, "orbit.nc", path[0]);
        orr_archive_path(archive, b->mjd, "orbit.nc", path[1]);
        const orr_status s =
            orr_catalogue_join(path[0], path[1], orr_archive_day_begin(b->mjd), &b->joint, &why);
        if (s == ORR_E_MEMORY) return s;
        if (s == ORR_OK)
            orr_catalogue_cache_keep(cache, a->sha256, b->sha256, &b->joint);
        else
            orr_warnings_add(warnings, why.file, 0, 0, "%s", why.text);
    }
    return ORR_OK;
}

// --- Suspicion ---

typedef double figure(const orr_catalogue_day *d);
static double residual(const orr_catalogue_day *d) { return d->all.residual_mm; }
static double sigma(const orr_catalogue_day *d) { return d->all.sigma_mm; }
static double left_out(const orr_catalogue_day *d) { return (double)d->all.left_out; }
static double joint(const orr_catalogue_day *d) { return d->joint.max_mm; }
static double missing(const orr_catalogue_day *d) { return -(double)d->all.satellites; }

// What is judged: by how much a day has to be above the others, in any case and against their scatter.
static const struct {
    figure *of;
    double least;
    const char *words, *unit;
} FIGURES[] = {
    {residual, 0.2, "residuals", "mm"},     {sigma, 0.2, "sigma", "mm"},
    {left_out, 10, "nodes left out", ""},   {joint, 0.1, "joint", "mm"},
    {missing, 1.5, "satellites fewer", ""},
};

static orr_status suspect(orr_catalogue *c, orr_diag *diag)
{
    double *v = malloc((c->n + 1) * sizeof *v);
    if (v == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu days", c->n);
    for (size_t f = 0; f < sizeof FIGURES / sizeof *FIGURES; f++) {
        size_t n = 0;
        for (size_t i = 0; i < c->n; i++)
            if (judged(&c->day[i]) && isfinite(FIGURES[f].of(&c->day[i]))) v[n++] = FIGURES[f].of(&c->day[i]);
        if (n < 3) continue; // nothing to compare with
        const double median = orr_median(v, n);
        for (size_t i = 0; i < n; i++) v[i] = fabs(v[i] - median);
        const double limit = fmax(UNUSUAL * ORR_SIGMA_PER_MAD * orr_median(v, n), FIGURES[f].least);
        for (size_t i = 0; i < c->n; i++) {
            orr_catalogue_day *d = &c->day[i];
            const double over = judged(d) ? FIGURES[f].of(d) - median : ORR_NAN;
            if (!(over > limit)) continue;
            const size_t at = strlen(d->suspicion);
            const bool fewer = FIGURES[f].of == missing;
            snprintf(d->suspicion + at, sizeof d->suspicion - at, "%s%s %.4g%s%s, usually %.4g",
                     at > 0 ? "; " : "", FIGURES[f].words, fewer ? over : FIGURES[f].of(d),
                     FIGURES[f].unit[0] != '\0' ? " " : "", FIGURES[f].unit, fewer ? 0 : median);
        }
    }
    free(v);
    return ORR_OK;
}

const char *orr_catalogue_state(const orr_catalogue_day *d)
{
    return d->state != ORR_OK ? orr_status_name(d->state) : d->predicted ? "predicted" : "ok";
}

orr_status orr_catalogue_make(const char *archive, bool joints, orr_catalogue *out, orr_warnings *warnings,
                              orr_diag *diag)
{
    *out = (orr_catalogue){0};
    int32_t *day = NULL;
    size_t n = 0;
    orr_status s = orr_archive_days(archive, &day, &n, diag);
    if (s == ORR_OK) out->day = calloc(n + 1, sizeof *out->day);
    if (s == ORR_OK && out->day == NULL) s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu days", n);
    for (size_t i = 0; s == ORR_OK && i < n; i++) {
        out->n = i + 1;
        out->day[i] = (orr_catalogue_day){.mjd = day[i]};
        take_record(archive, &out->day[i]);
    }
    free(day);
    if (s == ORR_OK && joints) {
        orr_catalogue_cache *cache = orr_catalogue_cache_open(archive, warnings);
        s = measure_joints(archive, out, cache, warnings);
        if (s == ORR_OK) s = suspect(out, diag);
        if (s == ORR_OK) orr_catalogue_cache_days(cache, out);
        orr_catalogue_cache_close(cache, warnings);
    }
    return s;
}

void orr_catalogue_free(orr_catalogue *c)
{
    free(c->day);
    *c = (orr_catalogue){0};
}

orr_status orr_catalogue_verify(const char *archive, int32_t mjd, orr_diag *diag)
{
    char folder[ORR_ARCHIVE_PATH], path[ORR_ARCHIVE_PATH], sha256[ORR_SHA256_HEX];
    orr_archive_record *r = malloc(sizeof *r);
    if (r == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a record");
    orr_status s = orr_archive_record_read(orr_archive_path(archive, mjd, NULL, folder), r, diag);
    if (s == ORR_OK && r->mjd != mjd)
        s = orr_diag_at(diag, ORR_E_FORMAT, folder, 0, 0, "holds another day than its name says");
    for (size_t i = 0; s == ORR_OK && i < r->n_products; i++) {
        orr_archive_path(archive, mjd, r->product[i].name, path);
        s = orr_sha256_file(path, sha256, diag);
        if (s == ORR_OK && strcmp(sha256, r->product[i].sha256) != 0)
            s = orr_diag_at(diag, ORR_E_FORMAT, path, 0, 0,
                            "is not as it was made: run 'orrery batch' for its day again");
    }
    free(r);
    return s;
}
