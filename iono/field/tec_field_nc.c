// SPDX-License-Identifier: GPL-3.0-or-later
// A TEC field inside a product: variables and attributes whose names begin with "field_".
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/ncfile.h"
#include "iono/field/tec_field_nc.h"
#include "iono/field/tec_field_private.h"

#define MAX_SETS 100000

static void put_double(orr_nc_writer *w, const char *name, double v, orr_diag *diag)
{
    orr_nc_put_att_double(w, NULL, name, &v, 1, diag);
}

static void put_int(orr_nc_writer *w, const char *name, int64_t v, orr_diag *diag)
{
    orr_nc_put_att_int64(w, NULL, name, &v, 1, diag);
}

static void put_grid(orr_nc_writer *w, const tec_grid *g, const char *name, const char *words, orr_diag *diag)
{
    char lat[32], lon[32], grid[40];
    snprintf(grid, sizeof grid, "%s_grid", name);
    snprintf(lat, sizeof lat, "%s_lat", name);
    snprintf(lon, sizeof lon, "%s_lon", name);
    orr_nc_put_dim(w, lat, g->n_lat, diag);
    orr_nc_put_dim(w, lon, g->n_lon, diag);
    const char *dims[] = {"field_epoch", lat, lon};
    orr_nc_put_var(w, name, ORR_NC_FLOAT, 3, dims, g->value, ORR_NC_TECU, words, diag);
    double corner[6] = {g->lat0, g->dlat, g->lon0, g->dlon, g->sun_fixed, g->round};
    const char *six[] = {"field_grid_parameter"};
    orr_nc_put_var(w, grid, ORR_NC_DOUBLE, 1, six, corner, NULL,
                   "first latitude, step, first longitude, step (rad); sun-fixed axes; all round", diag);
}

static orr_status put_broadcast(orr_nc_writer *w, const orr_tec_field *f, orr_diag *diag)
{
    orr_time *t = malloc(f->n * sizeof *t);
    double *value = malloc(f->n * sizeof f->set->value);
    orr_status s = ORR_OK;
    if (t == NULL || value == NULL)
        s = orr_diag_set(diag, ORR_E_MEMORY, "no memory to write a field");
    else {
        for (size_t k = 0; k < f->n; k++) {
            t[k] = f->set[k].t;
            memcpy(value + 9 * k, f->set[k].value, sizeof f->set->value);
        }
        put_int(w, "field_algorithm", (int64_t)f->algorithm, diag);
        orr_nc_put_dim(w, "field_broadcast_set", f->n, diag);
        orr_nc_put_dim(w, "field_broadcast_parameter", 9, diag);
        const char *dims[] = {"field_broadcast_set", "field_broadcast_parameter"};
        orr_nc_put_var(w, "field_broadcast_t", ORR_NC_INT64, 1, dims, t, "ns since 1980-01-06T00:00:00 GPS",
                       "from when a set holds; the lowest number: from ever", diag);
        s = orr_nc_put_var(
            w, "field_broadcast", ORR_NC_DOUBLE, 2, dims, value, NULL,
            "the coefficients as broadcast: alpha 0-3, beta 0-3; BDGIM's nine; NeQuick-G's three", diag);
        if (f->algorithm == ORR_TEC_NEQUICK) {
            const char *tables[] = {"field_nequick_number"};
            orr_nc_put_dim(w, tables[0], ORR_NEQUICK_NUMBERS, diag);
            s = orr_nc_put_var(
                w, "field_nequick", ORR_NC_DOUBLE, 1, tables, orr_nequick_numbers(f->nequick), NULL,
                "NeQuick-G's tables: a month foF2 [2][76][13] and M3000 [2][49][9], then modip", diag);
        }
    }
    free(t);
    free(value);
    return s;
}

orr_status orr_tec_field_put(orr_nc_writer *w, const orr_tec_field *f, orr_diag *diag)
{
    orr_nc_put_att_text(w, NULL, "field_source", f->source, diag);
    put_int(w, "field_kind", (int64_t)f->kind, diag);
    put_int(w, "field_temporal", (int64_t)f->options.temporal, diag);
    put_int(w, "field_mapping", (int64_t)f->options.mapping, diag);
    put_double(w, "field_rotation", f->options.rotation, diag);
    put_double(w, "field_pole_lat_deg", f->options.pole_lat_deg, diag);
    put_double(w, "field_pole_lon_deg", f->options.pole_lon_deg, diag);
    put_double(w, "field_shell_radius_m", f->shell_radius_m, diag);
    put_int(w, "field_from", f->from, diag);
    put_int(w, "field_to", f->to, diag);
    if (f->kind == TEC_BROADCAST) return put_broadcast(w, f, diag);
    orr_nc_put_dim(w, "field_epoch", f->n, diag);
    orr_nc_put_dim(w, "field_grid_parameter", 6, diag);
    const char *epochs[] = {"field_epoch"};
    orr_nc_put_var(w, "field_t", ORR_NC_INT64, 1, epochs, f->t, "nanoseconds since 1980-01-06 00:00:00",
                   "epoch of the field, GPS time", diag);
    orr_nc_put_var(w, "field_t1", ORR_NC_INT64, 1, epochs, f->t1, NULL,
                   "end of a set that holds for an interval, nanoseconds of GPS time since 1980-01-06; the "
                   "lowest number: a snapshot",
                   diag);
    if (f->kind == TEC_HARMONICS) {
        double *all = malloc(f->n * f->basis.n_coef * sizeof *all);
        if (all == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory to write a field");
        for (size_t k = 0; k < f->n; k++)
            orr_harm_pack(&f->basis, f->coef + k * f->basis.size, all + k * f->basis.n_coef);
        orr_nc_put_dim(w, "field_coefficient", f->basis.n_coef, diag);
        const char *dims[] = {"field_epoch", "field_coefficient"};
        orr_nc_put_var(
            w, "field_coefficients", ORR_NC_DOUBLE, 2, dims, all, ORR_NC_TECU,
            "normalised spherical harmonics, sun-fixed geomagnetic axes: n = 0.., m = 0, 1, -1, 2, -2, ..",
            diag);
        free(all);
        put_int(w, "field_degree", f->basis.degree, diag);
    }
    if (f->kind == TEC_GRID || f->tec.holes) put_grid(w, &f->tec, "field_tec", "vertical TEC maps", diag);
    if (f->rms.value != NULL) put_grid(w, &f->rms, "field_rms", "RMS of vertical TEC", diag);
    return w->status;
}

static orr_status get_grid(const orr_nc_reader *r, size_t n, const char *name, tec_grid *g, orr_diag *diag)
{
    char lat[32], lon[32], grid[40];
    double v[6];
    snprintf(lat, sizeof lat, "%s_lat", name);
    snprintf(lon, sizeof lon, "%s_lon", name);
    snprintf(grid, sizeof grid, "%s_grid", name);
    orr_status s = orr_nc_get_dim(r, lat, 10000, &g->n_lat, diag);
    if (s == ORR_OK) s = orr_nc_get_dim(r, lon, 10000, &g->n_lon, diag);
    if (s == ORR_OK) s = orr_nc_get_var(r, grid, ORR_NC_DOUBLE, 1, (size_t[]){6}, v, diag);
    if (s != ORR_OK) return s;
    if (g->n_lat < 2 || g->n_lon < 2 || !(fabs(v[0]) < 7) || !(fabs(v[1]) > 1e-5 && fabs(v[1]) < 7) ||
        !(fabs(v[2]) < 7) || !(v[3] > 1e-5 && v[3] < 7))
        return orr_diag_set(diag, ORR_E_FORMAT, "%s: %s describes no grid", r->path, grid);
    void *value = NULL;
    s = orr_nc_alloc_var(r, name, ORR_NC_FLOAT, 3, (size_t[]){n, g->n_lat, g->n_lon}, &value, diag);
    if (s != ORR_OK) return s;
    g->value = value;
    g->lat0 = v[0];
    g->dlat = v[1];
    g->lon0 = v[2];
    g->dlon = v[3];
    g->sun_fixed = v[4] != 0;
    g->round = v[5] != 0;
    tec_grid_finish(g);
    for (size_t i = 0; i < n * g->n_lat * g->n_lon; i++)
        if (isnan(g->value[i])) g->holes = true;
    return ORR_OK;
}

typedef struct settings {
    char source[256];
    int64_t kind, temporal, mapping, from, to;
    double rotation, pole_lat, pole_lon, radius;
} settings;

static orr_status get_settings(const orr_nc_reader *r, settings *x, orr_diag *diag)
{
    const struct {
        const char *name;
        int64_t *v;
    } whole[] = {{"field_kind", &x->kind},
                 {"field_temporal", &x->temporal},
                 {"field_mapping", &x->mapping},
                 {"field_from", &x->from},
                 {"field_to", &x->to}};
    const struct {
        const char *name;
        double *v;
    } real[] = {{"field_rotation", &x->rotation},
                {"field_pole_lat_deg", &x->pole_lat},
                {"field_pole_lon_deg", &x->pole_lon},
                {"field_shell_radius_m", &x->radius}};
    const char *missing = NULL;
    for (size_t i = 0; i < sizeof whole / sizeof *whole; i++)
        if (orr_nc_get_att_int64(r, NULL, whole[i].name, whole[i].v, NULL) != ORR_OK) missing = whole[i].name;
    for (size_t i = 0; i < sizeof real / sizeof *real; i++)
        if (orr_nc_get_att_double(r, NULL, real[i].name, real[i].v, NULL) != ORR_OK) missing = real[i].name;
    if (orr_nc_get_att_text(r, NULL, "field_source", x->source, sizeof x->source, NULL) != ORR_OK)
        missing = "field_source";
    if (missing != NULL)
        return orr_diag_set(diag, ORR_E_FORMAT, "%s: no attribute %s; the file holds no TEC field", r->path,
                            missing);
    if (x->kind < TEC_HARMONICS || x->kind > TEC_BROADCAST || x->temporal < ORR_TEC_NEAREST ||
        x->temporal > ORR_TEC_ROTATED || x->mapping < ORR_MAPPING_NONE || x->mapping > ORR_MAPPING_MSLM ||
        x->from > x->to || !orr_time_is_near(x->from) || !orr_time_is_near(x->to) || !(x->rotation >= 0) ||
        !(x->rotation <= 1) || !(fabs(x->pole_lat) <= 90) || !(fabs(x->pole_lon) <= 360) ||
        !(x->radius > 6.4e6 && x->radius < 1e7))
        return orr_diag_set(diag, ORR_E_FORMAT, "%s: the settings of its TEC field make no sense", r->path);
    return ORR_OK;
}

static orr_status get_epochs(const orr_nc_reader *r, orr_tec_field *f, orr_diag *diag)
{
    orr_status s = orr_nc_get_dim(r, "field_epoch", MAX_SETS, &f->n, diag);
    if (s == ORR_OK && f->n == 0)
        s = orr_diag_set(diag, ORR_E_FORMAT, "%s: a TEC field without epochs", r->path);
    void *t = NULL, *t1 = NULL;
    if (s == ORR_OK) s = orr_nc_alloc_var(r, "field_t", ORR_NC_INT64, 1, &f->n, &t, diag);
    f->t = t;
    if (s == ORR_OK) s = orr_nc_alloc_var(r, "field_t1", ORR_NC_INT64, 1, &f->n, &t1, diag);
    f->t1 = t1;
    if (s != ORR_OK) return s;
    f->sun = malloc(f->n * sizeof *f->sun);
    f->sun_east = malloc(f->n * sizeof *f->sun_east);
    if (f->sun == NULL || f->sun_east == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a TEC field");
    for (size_t k = 0; k < f->n; k++) {
        if ((k > 0 && f->t[k] <= f->t[k - 1]) || !orr_time_is_near(f->t[k]) ||
            (f->t1[k] != ORR_TIME_NONE && !orr_time_is_near(f->t1[k])))
            return orr_diag_set(diag, ORR_E_FORMAT,
                                "%s: the epochs of its TEC field do not ascend, or are no times", r->path);
        f->sun_east[k] = orr_mean_sun_lon(f->t[k], f->options.leap);
        f->sun[k] = orr_geomagnetic_lon_of_equator(&f->geomagnetic, f->sun_east[k]);
    }
    return ORR_OK;
}

static orr_status get_coefficients(const orr_nc_reader *r, orr_tec_field *f, orr_diag *diag)
{
    int64_t degree = -1;
    if (orr_nc_get_att_int64(r, NULL, "field_degree", &degree, NULL) != ORR_OK || degree < 0 ||
        degree > ORR_HARM_MAX_DEGREE)
        return orr_diag_set(diag, ORR_E_FORMAT, "%s: no usable degree of its TEC field", r->path);
    orr_status s = orr_harm_basis_init((int)degree, &f->basis, diag);
    if (s != ORR_OK) return s;
    void *all = NULL;
    s = orr_nc_alloc_var(r, "field_coefficients", ORR_NC_DOUBLE, 2, (size_t[]){f->n, f->basis.n_coef}, &all,
                         diag);
    if (s != ORR_OK) return s;
    const double *listed = all;
    f->coef = malloc(f->n * f->basis.size * sizeof *f->coef);
    if (f->coef == NULL) s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for coefficients");
    for (size_t i = 0; s == ORR_OK && i < f->n * f->basis.n_coef; i++)
        if (!isfinite(listed[i]))
            s = orr_diag_set(diag, ORR_E_FORMAT, "%s: a coefficient of its TEC field is no number", r->path);
    for (size_t k = 0; s == ORR_OK && k < f->n; k++)
        orr_harm_unpack(&f->basis, listed + k * f->basis.n_coef, f->coef + k * f->basis.size);
    free(all);
    return s;
}

static orr_status get_nequick(const orr_nc_reader *r, orr_tec_field *f, orr_diag *diag)
{
    const size_t n = ORR_NEQUICK_NUMBERS;
    void *number = NULL;
    orr_status s = orr_nc_alloc_var(r, "field_nequick", ORR_NC_DOUBLE, 1, &n, &number, diag);
    if (s != ORR_OK) return s;
    s = orr_nequick_of_numbers(number, &f->nequick, diag);
    free(number);
    return s;
}

static orr_status get_broadcast(const orr_nc_reader *r, orr_tec_field *f, orr_diag *diag)
{
    int64_t algorithm = ORR_TEC_GPS;
    f->n = 1;
    void *t = NULL, *value = NULL;
    orr_status s = ORR_OK;
    size_t per = 9;
    if (orr_nc_has_var(r, "field_klobuchar")) { // of older files: one set of GPS's, for all times
        per = 8;
        s = orr_nc_alloc_var(r, "field_klobuchar", ORR_NC_DOUBLE, 1, &per, &value, diag);
    } else {
        if (orr_nc_get_att_int64(r, NULL, "field_algorithm", &algorithm, NULL) != ORR_OK ||
            algorithm <= ORR_TEC_AUTO || algorithm > ORR_TEC_NEQUICK)
            return orr_diag_set(diag, ORR_E_FORMAT, "%s: no usable model of its TEC field", r->path);
        s = orr_nc_get_dim(r, "field_broadcast_set", MAX_SETS, &f->n, diag);
        if (s == ORR_OK && f->n == 0)
            s = orr_diag_set(diag, ORR_E_FORMAT, "%s: a TEC field without coefficients", r->path);
        if (s == ORR_OK) s = orr_nc_alloc_var(r, "field_broadcast_t", ORR_NC_INT64, 1, &f->n, &t, diag);
        if (s == ORR_OK)
            s = orr_nc_alloc_var(r, "field_broadcast", ORR_NC_DOUBLE, 2, (size_t[]){f->n, per}, &value, diag);
    }
    if (s == ORR_OK && (f->set = calloc(f->n, sizeof *f->set)) == NULL)
        s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for a TEC field");
    f->algorithm = f->options.algorithm = (orr_tec_algorithm)algorithm;
    for (size_t k = 0; s == ORR_OK && k < f->n; k++) {
        orr_tec_broadcast *set = &f->set[k];
        set->t = t != NULL ? ((const orr_time *)t)[k] : ORR_TIME_NONE;
        memcpy(set->value, (const double *)value + per * k, per * sizeof(double));
        bool numbers = true;
        for (size_t i = 0; i < per; i++) numbers = numbers && isfinite(set->value[i]);
        if (!numbers || (k > 0 && set->t <= f->set[k - 1].t))
            s = orr_diag_set(diag, ORR_E_FORMAT, "%s: a set of its TEC field is no number, or out of order",
                             r->path);
    }
    free(t);
    free(value);
    return s == ORR_OK && f->algorithm == ORR_TEC_NEQUICK ? get_nequick(r, f, diag) : s;
}

orr_status orr_tec_field_get(const orr_nc_reader *r, const orr_leap_table *leap, orr_tec_field **out,
                             orr_diag *diag)
{
    *out = NULL;
    settings x = {0};
    orr_status s = get_settings(r, &x, diag);
    if (s != ORR_OK) return s;
    orr_tec_field *f = calloc(1, sizeof *f);
    if (f == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a TEC field");
    f->kind = (tec_kind)x.kind;
    f->options = orr_tec_default_options();
    f->options.spatial = f->kind == TEC_GRID ? ORR_TEC_BILINEAR : ORR_TEC_HARMONIC;
    f->options.temporal = (orr_tec_temporal)x.temporal;
    f->options.mapping = (orr_mapping_kind)x.mapping;
    f->options.rotation = x.rotation;
    f->options.leap = leap;
    f->options.pole_lat_deg = x.pole_lat;
    f->options.pole_lon_deg = x.pole_lon;
    f->mapping = orr_mapping_published(f->options.mapping);
    f->geomagnetic = orr_geomagnetic_axes(x.pole_lat * ORR_RAD_PER_DEG, x.pole_lon * ORR_RAD_PER_DEG);
    f->shell_radius_m = x.radius;
    f->from = x.from;
    f->to = x.to;
    memcpy(f->source, x.source, sizeof f->source);
    if (f->kind == TEC_BROADCAST) {
        s = get_broadcast(r, f, diag);
    } else {
        s = get_epochs(r, f, diag);
        if (s == ORR_OK && f->kind == TEC_HARMONICS) s = get_coefficients(r, f, diag);
        if (s == ORR_OK) f->options.degree = f->basis.degree;
        if (s == ORR_OK && (f->kind == TEC_GRID || orr_nc_has_var(r, "field_tec")))
            s = get_grid(r, f->n, "field_tec", &f->tec, diag);
        if (s == ORR_OK && orr_nc_has_var(r, "field_rms")) s = get_grid(r, f->n, "field_rms", &f->rms, diag);
    }
    if (s != ORR_OK) {
        orr_tec_field_free(f);
        return s;
    }
    *out = f;
    return ORR_OK;
}
