// SPDX-License-Identifier: GPL-3.0-or-later
// Makers of TEC fields and what they say of themselves; the evaluation is in tec_eval.c.
#include "iono/field/tec_field.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "iono/field/tec_field_private.h"

#define MAX_EPOCHS 100000
#define MAX_CELLS 20000000 // of all maps together
// Maps and snapshots of coefficients are labelled in UT while some centres mean GPS time: the first and last one are held
// for so long.
#define EDGE_HOLD_NS (60 * ORR_NS_PER_S)
#define NOISE_TECU 2.0 // how far below zero a cell of a map still means none

orr_tec_options orr_tec_default_options(void)
{
    return (orr_tec_options){.spatial = ORR_TEC_SPATIAL_DEFAULT,
                             .temporal = ORR_TEC_TEMPORAL_DEFAULT,
                             .rotation = 1,
                             .degree = 15,
                             .pole_lat_deg = ORR_GEOMAGNETIC_POLE_LAT_DEG,
                             .pole_lon_deg = ORR_GEOMAGNETIC_POLE_LON_DEG,
                             .mapping = ORR_MAPPING_MSLM};
}

static orr_status refuse_options(const orr_tec_options *o, orr_diag *diag)
{
    if (!(o->rotation >= 0 && o->rotation <= 1))
        return orr_diag_set(diag, ORR_E_ARG, "a rotation fraction of %g; it lies between 0 and 1",
                            o->rotation);
    if (!(fabs(o->pole_lat_deg) <= 90) || !(fabs(o->pole_lon_deg) <= 360))
        return orr_diag_set(diag, ORR_E_ARG, "a geomagnetic pole at latitude %g, longitude %g",
                            o->pole_lat_deg, o->pole_lon_deg);
    return ORR_OK;
}

// A field with its epochs, frame and mapping; nothing of its values yet.
static orr_status begin(tec_kind kind, size_t n, double shell_radius_m, const char *source,
                        const orr_tec_options *options, orr_tec_field **out, orr_diag *diag)
{
    *out = NULL;
    orr_tec_options o = options != NULL ? *options : orr_tec_default_options();
    if (o.temporal == ORR_TEC_TEMPORAL_DEFAULT) o.temporal = ORR_TEC_ROTATED;
    if (o.spatial == ORR_TEC_SPATIAL_DEFAULT) o.spatial = ORR_TEC_HARMONIC;
    orr_status s = refuse_options(&o, diag);
    if (s != ORR_OK) return s;
    if (source == NULL) source = "field";
    if (n > MAX_EPOCHS)
        return orr_diag_set(diag, ORR_E_LIMIT, "%s: %zu epochs; %d are the limit", source, n, MAX_EPOCHS);
    if (!(shell_radius_m > 6.4e6 && shell_radius_m < 1e7))
        return orr_diag_set(diag, ORR_E_FORMAT, "%s: an ionospheric shell of radius %g km", source,
                            shell_radius_m / 1e3);
    orr_tec_field *f = calloc(1, sizeof *f);
    if (f == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a TEC field");
    f->kind = kind;
    f->options = o;
    f->shell_radius_m = shell_radius_m;
    f->mapping = orr_mapping_published(o.mapping);
    f->n = n;
    snprintf(f->source, sizeof f->source, "%s", source);
    f->geomagnetic = orr_geomagnetic_axes(o.pole_lat_deg * ORR_RAD_PER_DEG, o.pole_lon_deg * ORR_RAD_PER_DEG);
    if (n > 0) {
        f->t = malloc(n * sizeof *f->t);
        f->t1 = malloc(n * sizeof *f->t1);
        f->sun = malloc(n * sizeof *f->sun);
        f->sun_east = malloc(n * sizeof *f->sun_east);
        if (!f->t || !f->t1 || !f->sun || !f->sun_east) {
            orr_tec_field_free(f);
            return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a TEC field");
        }
    }
    *out = f;
    return ORR_OK;
}

static orr_status set_epoch(orr_tec_field *f, size_t k, orr_time t, orr_time t1, orr_diag *diag)
{
    char a[ORR_TIME_TEXT], b[ORR_TIME_TEXT];
    if (k > 0 && t <= f->t[k - 1])
        return orr_diag_set(diag, ORR_E_FORMAT, "%s: the epoch %s does not follow %s", f->source,
                            orr_time_text(t, a), orr_time_text(f->t[k - 1], b));
    f->t[k] = t;
    f->t1[k] = t1;
    f->sun_east[k] = orr_mean_sun_lon(t, f->options.leap);
    f->sun[k] = orr_geomagnetic_lon_of_equator(&f->geomagnetic, f->sun_east[k]);
    orr_time end = t1 == ORR_TIME_NONE ? t : t1;
    if (k == 0 || end > f->to) f->to = end;
    if (k == 0) f->from = t;
    return ORR_OK;
}

static orr_status check_maps(const orr_tec_maps *m, orr_diag *diag)
{
    const char *name = m->source != NULL ? m->source : "maps";
    if (m->n_maps == 0) return orr_diag_set(diag, ORR_E_NODATA, "%s: no TEC map in it", name);
    if (m->n_lat < 2 || m->n_lon < 2 || m->n_lat > MAX_CELLS || m->n_lon > MAX_CELLS ||
        m->n_lat * m->n_lon > MAX_CELLS / m->n_maps)
        return orr_diag_set(diag, ORR_E_LIMIT, "%s: %zu maps of %zu x %zu cells", name, m->n_maps, m->n_lat,
                            m->n_lon);
    double lat1 = m->lat0_deg + m->dlat_deg * (double)(m->n_lat - 1),
           width = m->dlon_deg * (double)(m->n_lon - 1);
    if (!(m->dlat_deg != 0) || !(m->dlon_deg > 0) || !(fabs(m->lat0_deg) <= 90.001) ||
        !(fabs(lat1) <= 90.001) || !(fabs(m->lon0_deg) <= 360) || !(width <= 360.001))
        return orr_diag_set(
            diag, ORR_E_FORMAT,
            "%s: a grid from latitude %g by %g (%zu rows), from longitude %g by %g (%zu columns)", name,
            m->lat0_deg, m->dlat_deg, m->n_lat, m->lon0_deg, m->dlon_deg, m->n_lon);
    for (size_t k = 0; k < m->n_maps; k++)
        for (size_t i = 0; i < m->n_lat * m->n_lon; i++) {
            double v = m->tec[k * m->n_lat * m->n_lon + i];
            if (isinf(v)) {
                char when[ORR_TIME_TEXT];
                return orr_diag_set(
                    diag, ORR_E_FORMAT, "%s: the map of %s says %.4g TECU at latitude %g, longitude %g", name,
                    orr_time_text(m->t[k], when), v, m->lat0_deg + m->dlat_deg * (double)(i / m->n_lon),
                    m->lon0_deg + m->dlon_deg * (double)(i % m->n_lon));
            }
        }
    return ORR_OK;
}

void tec_grid_finish(tec_grid *g)
{
    double last = g->lat0 + g->dlat * (double)(g->n_lat - 1), near = 80 * ORR_RAD_PER_DEG;
    g->per_lat = 1 / g->dlat;
    g->per_lon = 1 / g->dlon;
    g->turn = 2 * ORR_PI / g->dlon;
    g->per_turn = 1 / g->turn;
    g->north_cap = fabs(g->lat0) >= near; // "north" is the first row, whichever pole it is at
    g->south_cap = fabs(last) >= near;
}

static orr_status keep_grid(const orr_tec_maps *m, const double *value, tec_grid *g, orr_diag *diag)
{
    size_t n = m->n_maps * m->n_lat * m->n_lon;
    *g = (tec_grid){.n_lat = m->n_lat,
                    .n_lon = m->n_lon,
                    .lat0 = m->lat0_deg * ORR_RAD_PER_DEG,
                    .dlat = m->dlat_deg * ORR_RAD_PER_DEG,
                    .lon0 = m->lon0_deg * ORR_RAD_PER_DEG,
                    .dlon = m->dlon_deg * ORR_RAD_PER_DEG};
    g->round = m->dlon_deg * (double)m->n_lon > 360 - 1e-6;
    tec_grid_finish(g);
    g->value = malloc(n * sizeof *g->value);
    if (g->value == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for maps");
    for (size_t i = 0; i < n; i++) {
        // A value a little below zero is the noise of the maps' making and means none; far below it is no value.
        double v = value[i] >= 0 ? value[i] : value[i] >= -NOISE_TECU ? 0 : ORR_NAN;
        g->value[i] = (float)v;
        if (isnan(v)) g->holes = true;
    }
    return ORR_OK;
}

// Not all round, or not up to the poles.
static bool of_a_region(const orr_tec_maps *m)
{
    double last = m->lat0_deg + m->dlat_deg * (double)(m->n_lat - 1);
    return m->dlon_deg * (double)m->n_lon <= 360 - 1e-6 || fmax(m->lat0_deg, last) < 80 ||
           fmin(m->lat0_deg, last) > -80;
}

orr_status orr_tec_field_from_maps(const orr_tec_maps *maps, const orr_tec_options *options,
                                   orr_tec_field **out, orr_diag *diag)
{
    *out = NULL;
    orr_status s = check_maps(maps, diag);
    if (s != ORR_OK) return s;
    orr_tec_field *f;
    orr_tec_options o = options != NULL ? *options : orr_tec_default_options();
    const bool region = of_a_region(maps);
    if (o.spatial == ORR_TEC_SPATIAL_DEFAULT) o.spatial = region ? ORR_TEC_BILINEAR : ORR_TEC_HARMONIC;
    if (o.temporal == ORR_TEC_TEMPORAL_DEFAULT) o.temporal = region ? ORR_TEC_LINEAR : ORR_TEC_ROTATED;
    const bool harmonic = o.spatial == ORR_TEC_HARMONIC;
    s = begin(harmonic ? TEC_HARMONICS : TEC_GRID, maps->n_maps, maps->shell_radius_m, maps->source, &o, &f,
              diag);
    if (s != ORR_OK) return s;
    for (size_t k = 0; s == ORR_OK && k < maps->n_maps; k++)
        s = set_epoch(f, k, maps->t[k], ORR_TIME_NONE, diag);
    f->from -= EDGE_HOLD_NS;
    f->to += EDGE_HOLD_NS;
    if (s == ORR_OK) s = keep_grid(maps, maps->tec, &f->tec, diag); // harmonics need it where there are holes
    if (s == ORR_OK && maps->rms != NULL) s = keep_grid(maps, maps->rms, &f->rms, diag);
    if (s == ORR_OK && harmonic) {
        if (region)
            s = orr_diag_set(
                diag, ORR_E_UNSUPPORTED,
                "%s: maps of a region cannot be refitted to spherical harmonics; use the bilinear mode",
                f->source);
        if (s == ORR_OK) s = orr_harm_basis_init(f->options.degree, &f->basis, diag);
        if (s == ORR_OK) {
            f->coef = calloc(f->n * f->basis.size, sizeof *f->coef);
            s = f->coef != NULL ? tec_fit_maps(maps, f, diag)
                                : orr_diag_set(diag, ORR_E_MEMORY, "no memory for coefficients");
        }
    }
    if (s != ORR_OK) {
        orr_tec_field_free(f);
        return s;
    }
    *out = f;
    return ORR_OK;
}

// The coefficients' RMS as an RMS grid of the sun-fixed frame, terms taken as independent: files give no
// correlations.
static orr_status grid_of_rms(orr_tec_field *f, orr_diag *diag)
{
    enum { ROWS = 37, COLS = 72 };
    tec_grid *g = &f->rms;
    *g = (tec_grid){.n_lat = ROWS,
                    .n_lon = COLS,
                    .lat0 = ORR_PI / 2,
                    .dlat = -ORR_PI / (ROWS - 1),
                    .lon0 = -ORR_PI,
                    .dlon = 2 * ORR_PI / COLS,
                    .round = true,
                    .sun_fixed = true};
    tec_grid_finish(g);
    g->value = malloc(f->n * ROWS * COLS * sizeof *g->value);
    double *row = malloc(f->basis.n_coef * sizeof *row), *rms = malloc(f->basis.n_coef * sizeof *rms);
    if (g->value == NULL || row == NULL || rms == NULL) {
        free(row);
        free(rms);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the RMS of coefficients");
    }
    for (size_t k = 0; k < f->n; k++) {
        orr_harm_pack(&f->basis, f->coef_rms + k * f->basis.size, rms);
        for (size_t r = 0; r < ROWS; r++)
            for (size_t c = 0; c < COLS; c++) {
                double lat = g->lat0 + (double)r * g->dlat, lon = g->lon0 + (double)c * g->dlon, sum = 0;
                orr_harm_row(&f->basis, sin(lat), cos(lat), sin(lon), cos(lon), row);
                for (size_t i = 0; i < f->basis.n_coef; i++) sum += row[i] * row[i] * rms[i] * rms[i];
                g->value[(k * ROWS + r) * COLS + c] = (float)sqrt(sum);
            }
    }
    free(row);
    free(rms);
    return ORR_OK;
}

orr_status orr_tec_field_from_model(const orr_tec_model *model, const orr_tec_options *options,
                                    orr_tec_field **out, orr_diag *diag)
{
    *out = NULL;
    const char *name = model->source != NULL ? model->source : "coefficients";
    if (model->n == 0) return orr_diag_set(diag, ORR_E_NODATA, "%s: no set of coefficients in it", name);
    orr_tec_options o = options != NULL ? *options : orr_tec_default_options();
    o.spatial = ORR_TEC_HARMONIC;
    if (o.temporal == ORR_TEC_TEMPORAL_DEFAULT) o.temporal = ORR_TEC_ROTATED;
    o.pole_lat_deg = model->pole_lat_deg;
    o.pole_lon_deg = model->pole_lon_deg;
    o.degree = 0;
    bool with_rms = false;
    for (size_t k = 0; k < model->n; k++) {
        if (model->set[k].degree > o.degree) o.degree = model->set[k].degree;
        if (model->set[k].rms != NULL) with_rms = true;
    }
    orr_tec_field *f;
    orr_status s = begin(TEC_HARMONICS, model->n, model->shell_radius_m, model->source, &o, &f, diag);
    if (s == ORR_OK) s = orr_harm_basis_init(o.degree, &f->basis, diag);
    if (s != ORR_OK) {
        orr_tec_field_free(f);
        return s;
    }
    f->coef = calloc(f->n * f->basis.size, sizeof *f->coef);
    if (with_rms) f->coef_rms = calloc(f->n * f->basis.size, sizeof *f->coef_rms);
    if (f->coef == NULL || (with_rms && f->coef_rms == NULL)) {
        orr_tec_field_free(f);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for coefficients");
    }
    for (size_t k = 0; s == ORR_OK && k < f->n; k++) {
        const orr_tec_coefficients *set = &model->set[k];
        s = set_epoch(f, k, set->t, set->t1, diag);
        for (int n = 0; n <= set->degree; n++)
            for (int m = -n; m <= n; m++) {
                if (abs(m) > set->order) continue;
                size_t from = (size_t)(n * n) + (size_t)(m == 0 ? 0 : m > 0 ? 2 * m - 1 : -2 * m);
                size_t to = k * f->basis.size + orr_harm_slot(&f->basis, n, m);
                f->coef[to] = set->value[from];
                if (set->rms != NULL) f->coef_rms[to] = set->rms[from];
                if (!isfinite(set->value[from]) && s == ORR_OK)
                    s = orr_diag_set(diag, ORR_E_FORMAT, "%s: the coefficient (%d, %d) is no number",
                                     f->source, n, m);
            }
    }
    if (s == ORR_OK && model->set[0].t1 == ORR_TIME_NONE) f->from -= EDGE_HOLD_NS;
    if (s == ORR_OK && model->set[f->n - 1].t1 == ORR_TIME_NONE) f->to += EDGE_HOLD_NS;
    if (s == ORR_OK && with_rms) s = grid_of_rms(f, diag);
    if (s != ORR_OK) {
        orr_tec_field_free(f);
        return s;
    }
    *out = f;
    return ORR_OK;
}

orr_status orr_tec_field_from_broadcast(orr_tec_algorithm algorithm, const orr_tec_broadcast *set, size_t n,
                                        orr_time from, orr_time to, const char *source,
                                        const orr_tec_options *options, orr_tec_field **out, orr_diag *diag)
{
    *out = NULL;
    if (algorithm <= ORR_TEC_AUTO || algorithm > ORR_TEC_NEQUICK)
        return orr_diag_set(diag, ORR_E_ARG, "%s: no such model of the ionosphere", source);
    if (n == 0) return orr_diag_set(diag, ORR_E_NODATA, "%s: no coefficients of the ionosphere", source);
    for (size_t k = 0; k < n; k++) {
        for (int i = 0; i < 9; i++)
            if (!isfinite(set[k].value[i]))
                return orr_diag_set(diag, ORR_E_FORMAT, "%s: a coefficient of the ionosphere is missing",
                                    source);
        if (k > 0 && set[k].t <= set[k - 1].t)
            return orr_diag_set(diag, ORR_E_FORMAT, "%s: coefficients of the ionosphere out of order",
                                source);
    }
    orr_tec_field *f;
    orr_status s = begin(TEC_BROADCAST, 0, ORR_SHELL_RADIUS_M, source, options, &f, diag);
    if (s != ORR_OK) return s;
    const char *const folder = f->options.nequick;
    f->options.nequick = NULL;
    f->algorithm = f->options.algorithm = algorithm;
    f->from = from;
    f->to = to;
    f->n = n;
    f->set = malloc(n * sizeof *f->set);
    if (f->set == NULL)
        s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for coefficients");
    else
        memcpy(f->set, set, n * sizeof *f->set);
    if (s == ORR_OK && algorithm == ORR_TEC_NEQUICK)
        s = folder != NULL
                ? orr_nequick_load(folder, &f->nequick, diag)
                : orr_diag_set(
                      diag, ORR_E_NODATA,
                      "%s: Galileo's coefficients are those of NeQuick-G, whose tables (ccir11.asc to "
                      "ccir22.asc, modip.asc) are read from a folder: none was given",
                      source);
    if (s != ORR_OK) {
        orr_tec_field_free(f);
        return s;
    }
    *out = f;
    return ORR_OK;
}

orr_tec_field *orr_tec_field_share(orr_tec_field *f)
{
    if (f != NULL) atomic_fetch_add(&f->others, 1);
    return f;
}

void orr_tec_field_free(orr_tec_field *f)
{
    if (f == NULL || atomic_fetch_sub(&f->others, 1) > 0) return;
    free(f->t);
    free(f->t1);
    free(f->sun);
    free(f->sun_east);
    free(f->coef);
    free(f->coef_rms);
    free(f->set);
    orr_nequick_free(f->nequick);
    free(f->tec.value);
    free(f->rms.value);
    orr_harm_basis_free(&f->basis);
    free(f);
}

void orr_tec_field_span(const orr_tec_field *f, orr_time *from, orr_time *to)
{
    *from = f->from;
    *to = f->to;
}

const char *orr_tec_field_source(const orr_tec_field *f) { return f->source; }

const char *orr_tec_field_kind(const orr_tec_field *f)
{
    static const char *const names[] = {"harmonics", "maps", "klobuchar"};
    if (f->kind == TEC_BROADCAST && f->algorithm == ORR_TEC_BDGIM) return "bdgim";
    if (f->kind == TEC_BROADCAST && f->algorithm == ORR_TEC_NEQUICK) return "nequick";
    return names[f->kind];
}

const orr_tec_options *orr_tec_field_options(const orr_tec_field *f) { return &f->options; }
const orr_tec_fit *orr_tec_field_fit(const orr_tec_field *f) { return f->fitted ? &f->fit : NULL; }
double orr_tec_field_shell_radius_m(const orr_tec_field *f) { return f->shell_radius_m; }

size_t orr_tec_field_sets(const orr_tec_field *f, int *degree)
{
    if (f->kind != TEC_HARMONICS) return 0;
    *degree = f->basis.degree;
    return f->n;
}

void orr_tec_field_set(const orr_tec_field *f, size_t k, orr_time *t, orr_time *t1, double *value,
                       double *rms)
{
    *t = f->t[k];
    *t1 = f->t1[k];
    orr_harm_pack(&f->basis, f->coef + k * f->basis.size, value);
    if (rms == NULL) return;
    if (f->coef_rms != NULL)
        orr_harm_pack(&f->basis, f->coef_rms + k * f->basis.size, rms);
    else
        memset(rms, 0, f->basis.n_coef * sizeof *rms);
}

size_t orr_tec_field_epochs(const orr_tec_field *f, const orr_time **t)
{
    *t = f->t;
    return f->t != NULL ? f->n : 0;
}
