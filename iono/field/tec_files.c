// SPDX-License-Identifier: GPL-3.0-or-later
#include "iono/field/tec_files.h"
#include "core/nan.h"
#include "core/path.h"
#include "ingest/input/input.h"
#include "ingest/input/sniff.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Step of n equally spaced values; NAN when they are not.
static double regular_step(const double *v, size_t n)
{
    if (n < 2) return ORR_NAN;
    double step = (v[n - 1] - v[0]) / (double)(n - 1);
    for (size_t i = 1; i < n; i++)
        if (!(fabs(v[i] - v[i - 1] - step) < 1e-6)) return ORR_NAN;
    return step;
}

orr_status orr_tec_field_from_ionex(const orr_ionex *x, const char *name, const orr_tec_options *options,
                                    orr_tec_field **out, orr_diag *diag)
{
    *out = NULL;
    if (x->tec_tecu == NULL) return orr_diag_set(diag, ORR_E_NODATA, "%s: no TEC map in it", name);
    if (x->n_heights != 1)
        return orr_diag_set(diag, ORR_E_UNSUPPORTED,
                            "%s: maps at %zu heights; only those of one shell can be used", name,
                            x->n_heights);
    double dlat = regular_step(x->lat_deg, x->n_lats), dlon = regular_step(x->lon_deg, x->n_lons);
    if (isnan(dlat) || isnan(dlon) || dlon <= 0)
        return orr_diag_set(
            diag, ORR_E_UNSUPPORTED,
            "%s: a grid whose latitudes or longitudes are not in equal steps (longitudes eastward)", name);
    orr_tec_maps m = {.n_maps = x->n_epochs,
                      .n_lat = x->n_lats,
                      .n_lon = x->n_lons,
                      .lat0_deg = x->lat_deg[0],
                      .dlat_deg = dlat,
                      .lon0_deg = x->lon_deg[0],
                      .dlon_deg = dlon,
                      .shell_radius_m = x->base_radius_m + x->height_m[0],
                      .unit_tecu = pow(10, x->exponent),
                      .t = x->epoch,
                      .tec = x->tec_tecu,
                      .rms = x->rms_tecu,
                      .source = name};
    return orr_tec_field_from_maps(&m, options, out, diag);
}

static orr_status check_model(const orr_ion_model *m, const orr_ion_model *first, const char *name,
                              orr_diag *diag)
{
    if (m->type != ORR_ION_GLOBAL)
        return orr_diag_set(diag, ORR_E_UNSUPPORTED,
                            "%s: model \"%s\" is not a global one (spherical harmonics)", name, m->number);
    if (m->frame != ORR_ION_GEOMAGNETIC || m->sun != ORR_ION_SUN_MEAN)
        return orr_diag_set(diag, ORR_E_UNSUPPORTED,
                            "%s: model \"%s\" is not in the geomagnetic frame of the mean Sun", name,
                            m->number);
    if (isnan(m->pole_lat_deg) || isnan(m->pole_lon_deg) || isnan(m->layer_height_m))
        return orr_diag_set(diag, ORR_E_FORMAT,
                            "%s: model \"%s\" does not tell the geomagnetic pole or the height of its layer",
                            name, m->number);
    if (m->pole_lat_deg != first->pole_lat_deg || m->pole_lon_deg != first->pole_lon_deg ||
        m->layer_height_m != first->layer_height_m)
        return orr_diag_set(diag, ORR_E_UNSUPPORTED,
                            "%s: model \"%s\" changes the pole or the height of the layer", name, m->number);
    if (m->max_degree < 0 || m->max_degree > ORR_HARM_MAX_DEGREE)
        return orr_diag_set(diag, ORR_E_LIMIT, "%s: model \"%s\" is of degree %d; %d is the limit", name,
                            m->number, m->max_degree, ORR_HARM_MAX_DEGREE);
    if (m->from == ORR_TIME_NONE)
        return orr_diag_set(diag, ORR_E_FORMAT, "%s: model \"%s\" does not tell its epoch", name, m->number);
    return ORR_OK;
}

orr_status orr_tec_field_from_ion(const orr_ion *x, const char *name, const orr_tec_options *options,
                                  orr_tec_field **out, orr_diag *diag)
{
    *out = NULL;
    if (x->n_models == 0) return orr_diag_set(diag, ORR_E_NODATA, "%s: no model in it", name);
    for (size_t k = 0; k < x->n_models; k++) {
        orr_status s = check_model(&x->model[k], &x->model[0], name, diag);
        if (s != ORR_OK) return s;
    }
    size_t per = (ORR_HARM_MAX_DEGREE + 1) * (ORR_HARM_MAX_DEGREE + 1);
    orr_tec_coefficients *set = calloc(x->n_models, sizeof *set);
    double *value = calloc(2 * per * x->n_models, sizeof *value);
    if (set == NULL || value == NULL) {
        free(set);
        free(value);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for coefficients");
    }
    orr_status s = ORR_OK;
    for (size_t k = 0; s == ORR_OK && k < x->n_models; k++) {
        const orr_ion_model *m = &x->model[k];
        double *v = value + 2 * per * k, *rms = v + per;
        bool some = false;
        for (size_t i = 0; i < m->n_coefficients; i++) {
            const orr_ion_coefficient *c = &m->coefficient[i];
            if (c->degree < 0 || c->degree > m->max_degree || abs(c->order) > c->degree) {
                s = orr_diag_set(diag, ORR_E_FORMAT,
                                 "%s: model \"%s\" is of degree %d and has a coefficient (%d, %d)", name,
                                 m->number, m->max_degree, c->degree, c->order);
                break;
            }
            size_t at = orr_ion_index(c->degree, c->order);
            v[at] = c->tecu;
            if (c->rms_tecu > 0) {
                rms[at] = c->rms_tecu;
                some = true;
            }
        }
        set[k] = (orr_tec_coefficients){m->from, m->to, m->max_degree, m->max_degree, v, some ? rms : NULL};
    }
    if (s == ORR_OK) {
        const orr_ion_model *m = &x->model[0];
        orr_tec_model model = {
            x->n_models, set, m->pole_lat_deg, m->pole_lon_deg, ORR_EARTH_MEAN_RADIUS_M + m->layer_height_m,
            name};
        s = orr_tec_field_from_model(&model, options, out, diag);
    }
    free(set);
    free(value);
    return s;
}

static const struct {
    char system;
    uint8_t kind;
} source_of[] = {[ORR_TEC_GPS] = {'G', ORR_NAV_KLOBUCHAR},   [ORR_TEC_QZSS] = {'J', ORR_NAV_KLOBUCHAR},
                 [ORR_TEC_NAVIC] = {'I', ORR_NAV_KLOBUCHAR}, [ORR_TEC_BEIDOU] = {'C', ORR_NAV_KLOBUCHAR},
                 [ORR_TEC_BDGIM] = {'C', ORR_NAV_BDGIM},     [ORR_TEC_NEQUICK] = {'E', ORR_NAV_NEQUICK_G}};

// QZSS sends a set for the wide area and one for Japan: that of the wide area.
static bool is_of(const orr_nav_iono *c, orr_tec_algorithm a)
{
    return c->system == source_of[a].system && c->kind == source_of[a].kind &&
           !(a == ORR_TEC_QZSS && c->flags == 1);
}

typedef struct timed_set {
    orr_tec_broadcast set;
    size_t row; // in the file
} timed_set;

static int by_time_and_row(const void *a, const void *b)
{
    const timed_set *x = a, *y = b;
    if (x->set.t != y->set.t) return x->set.t < y->set.t ? -1 : 1;
    return (x->row > y->row) - (x->row < y->row);
}

// A file's sets of a model in the order of time, one for each: a mark of a header is an hour of `day`. Of two for one
// time the one further down stands. Both arrays have room for all of nav->iono.
static size_t sets_of(const orr_nav *nav, orr_tec_algorithm a, orr_time day, timed_set *all,
                      orr_tec_broadcast *out)
{
    size_t n = 0, n_all = 0;
    for (size_t i = 0; i < nav->n_iono; i++) {
        const orr_nav_iono *c = &nav->iono[i];
        if (!is_of(c, a) || (c->t != ORR_TIME_NONE && !orr_time_is_near(c->t))) continue;
        timed_set *one = &all[n_all++];
        *one = (timed_set){.set.t = c->t, .row = i};
        if (c->t == ORR_TIME_NONE && c->time_mark >= 'A' && c->time_mark <= 'X')
            one->set.t = orr_time_add(day, (int64_t)(c->time_mark - 'A') * 3600 * ORR_NS_PER_S);
        const size_t count = c->kind == ORR_NAV_BDGIM ? 9 : c->kind == ORR_NAV_NEQUICK_G ? 3 : 8;
        memcpy(one->set.value, c->coefficient, count * sizeof(double));
        for (size_t k = 0; k < count; k++)
            if (!isfinite(c->coefficient[k])) {
                n_all--; // a set that lacks a number is none
                break;
            }
    }
    qsort(all, n_all, sizeof *all, by_time_and_row);
    for (size_t i = 0; i < n_all; i++) {
        if (n > 0 && out[n - 1].t == all[i].set.t) n--;
        out[n++] = all[i].set;
    }
    return n;
}

// A broadcast model of a navigation file, for the days that its ephemerides and its sets span and one to either side.
static orr_status from_nav(const orr_nav *nav, const char *name, const orr_tec_options *options,
                           orr_tec_field **out, orr_diag *diag)
{
    *out = NULL;
    orr_tec_algorithm chosen = options != NULL ? options->algorithm : ORR_TEC_AUTO;
    if (chosen < ORR_TEC_AUTO || chosen > ORR_TEC_NEQUICK)
        return orr_diag_set(diag, ORR_E_ARG, "no such model of the ionosphere");
    const orr_tec_algorithm first = chosen != ORR_TEC_AUTO ? chosen : ORR_TEC_GPS,
                            last = chosen != ORR_TEC_AUTO ? chosen : ORR_TEC_NEQUICK;
    chosen = ORR_TEC_AUTO;
    for (orr_tec_algorithm a = first; chosen == ORR_TEC_AUTO && a <= last; a++)
        for (size_t i = 0; i < nav->n_iono; i++)
            if (is_of(&nav->iono[i], a)) chosen = a;
    if (chosen == ORR_TEC_AUTO)
        return orr_diag_set(
            diag, ORR_E_NODATA,
            "%s: no Klobuchar coefficients in it (ION ALPHA, IONOSPHERIC CORR), nor others of the "
            "model asked for",
            name);
    if (nav->n_eph == 0)
        return orr_diag_set(diag, ORR_E_NODATA,
                            "%s: no ephemeris that would tell the day of its Klobuchar coefficients", name);
    orr_time from = nav->eph[0].toe, to = from;
    for (size_t i = 0; i < nav->n_eph; i++) {
        if (nav->eph[i].toe < from) from = nav->eph[i].toe;
        if (nav->eph[i].toe > to) to = nav->eph[i].toe;
    }
    const int64_t day = (int64_t)ORR_S_PER_DAY * ORR_NS_PER_S;
    const orr_time middle = from + (to - from) / 2;
    timed_set *all = malloc(nav->n_iono * sizeof *all);
    orr_tec_broadcast *set = malloc(nav->n_iono * sizeof *set);
    if (all == NULL || set == NULL) {
        free(all);
        free(set);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for coefficients");
    }
    const size_t n = sets_of(nav, chosen, middle - orr_floor_mod(middle, day), all, set);
    free(all);
    for (size_t k = 0; k < n; k++)
        if (set[k].t != ORR_TIME_NONE) {
            if (set[k].t < from) from = set[k].t;
            if (set[k].t > to) to = set[k].t;
        }
    const orr_status s =
        orr_tec_field_from_broadcast(chosen, set, n, from - day, to + day, name, options, out, diag);
    free(set);
    return s;
}

orr_status orr_tec_field_open(const char *path, const orr_tec_options *options, orr_tec_field **out,
                              orr_warnings *warnings, orr_diag *diag)
{
    *out = NULL;
    orr_bytes text;
    orr_input_limits limits = orr_input_default_limits();
    limits.kinds =
        ORR_KIND_BIT(ORR_KIND_IONEX) | ORR_KIND_BIT(ORR_KIND_ION) | ORR_KIND_BIT(ORR_KIND_RINEX_NAV);
    orr_status s = orr_input_read_all(path, &limits, &text, diag);
    if (s != ORR_OK) return s;
    s = orr_tec_field_parse(path, text.text, text.n, options, out, warnings, diag);
    orr_bytes_free(&text);
    return s;
}

orr_status orr_tec_field_parse(const char *path, const char *text, size_t n, const orr_tec_options *options,
                               orr_tec_field **out, orr_warnings *warnings, orr_diag *diag)
{
    *out = NULL;
    const char *name = orr_base_name(path);
    orr_ionex maps;
    orr_read_limits limits = orr_read_default_limits();
    limits.leap = options != NULL ? options->leap : NULL;
    orr_status s = orr_ionex_parse(path, text, n, &limits, &maps, warnings, diag);
    if (s == ORR_OK) {
        s = orr_tec_field_from_ionex(&maps, name, options, out, diag);
        orr_ionex_free(&maps);
        return s;
    }
    if (s != ORR_E_KIND) return s;
    orr_ion models;
    s = orr_ion_parse(path, text, n, NULL, &models, warnings, diag);
    if (s == ORR_OK) {
        s = orr_tec_field_from_ion(&models, name, options, out, diag);
        orr_ion_free(&models);
        return s;
    }
    if (s != ORR_E_KIND) return s;
    orr_nav nav;
    orr_nav_limits nav_limits = orr_nav_default_limits();
    nav_limits.leap = limits.leap;
    s = orr_nav_parse(path, text, n, &nav_limits, &nav, warnings, diag);
    if (s == ORR_OK) {
        s = from_nav(&nav, name, options, out, diag);
        orr_nav_free(&nav);
        return s;
    }
    if (s != ORR_E_KIND) return s;
    return orr_diag_at(
        diag, ORR_E_KIND, path, 0, 0,
        "neither an IONEX file of maps, nor Bernese coefficients (.ION), nor a RINEX navigation file");
}

orr_status orr_tec_field_to_ion(const orr_tec_field *f, orr_ion *out, orr_diag *diag)
{
    *out = (orr_ion){0};
    int degree = 0;
    size_t n = orr_tec_field_sets(f, &degree), per = ((size_t)degree + 1) * ((size_t)degree + 1);
    if (n == 0)
        return orr_diag_set(diag, ORR_E_UNSUPPORTED,
                            "%s is kept as %s, not as harmonics; coefficients cannot be written",
                            orr_tec_field_source(f), orr_tec_field_kind(f));
    double *value = malloc(2 * per * sizeof *value);
    out->model = calloc(n, sizeof *out->model);
    if (value == NULL || out->model == NULL) {
        free(value);
        orr_ion_free(out);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for models");
    }
    const orr_tec_options *o = orr_tec_field_options(f);
    orr_status s = ORR_OK;
    for (size_t k = 0; s == ORR_OK && k < n; k++) {
        orr_ion_model *m = &out->model[k];
        s = orr_ion_model_alloc(degree, degree, m, diag);
        if (s != ORR_OK) break;
        out->n_models = k + 1;
        orr_tec_field_set(f, k, &m->from, &m->to, value, value + per);
        snprintf(m->title, sizeof m->title, "%.40s AS SPHERICAL HARMONICS", orr_tec_field_source(f));
        snprintf(m->number, sizeof m->number, "%04zu-%02d", k + 1, 0);
        m->type = ORR_ION_GLOBAL;
        m->frame = ORR_ION_GEOMAGNETIC;
        m->sun = ORR_ION_SUN_MEAN;
        m->mapping = o->mapping == ORR_MAPPING_MSLM         ? ORR_ION_MAP_MSLM
                     : o->mapping == ORR_MAPPING_THIN_SHELL ? ORR_ION_MAP_COSZ
                                                            : ORR_ION_MAP_NONE;
        m->layer_height_m = orr_tec_field_shell_radius_m(f) - ORR_EARTH_MEAN_RADIUS_M;
        m->pole_lat_deg = o->pole_lat_deg;
        m->pole_lon_deg = o->pole_lon_deg;
        m->lat_south_deg = -90;
        m->lat_north_deg = 90;
        for (size_t i = 0; i < per; i++) {
            m->coefficient[i].tecu = value[i];
            m->coefficient[i].rms_tecu = value[per + i];
        }
    }
    free(value);
    if (s != ORR_OK) orr_ion_free(out);
    return s;
}

orr_status orr_tec_field_to_ionex(const orr_tec_field *f, orr_time t0, double step_s, size_t n,
                                  orr_ionex *out, orr_diag *diag)
{
    const double lat[3] = {87.5, -87.5, -2.5}, lon[3] = {-180, 180, 5};
    double radius = orr_tec_field_shell_radius_m(f),
           height[3] = {radius - ORR_EARTH_MEAN_RADIUS_M, radius - ORR_EARTH_MEAN_RADIUS_M, 0};
    orr_status s = orr_ionex_alloc(n, t0, step_s, lat, lon, height, true, out, diag);
    if (s != ORR_OK) return s;
    out->base_radius_m = ORR_EARTH_MEAN_RADIUS_M;
    orr_tec_instant *at = malloc(sizeof *at);
    if (at == NULL) s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for maps");
    bool with_rms = false;
    for (size_t k = 0; s == ORR_OK && k < n; k++) {
        s = orr_tec_field_at(f, out->epoch[k], at, diag);
        for (size_t i = 0; s == ORR_OK && i < out->n_lats; i++)
            for (size_t j = 0; j < out->n_lons; j++) {
                double b = out->lat_deg[i] * ORR_RAD_PER_DEG, l = out->lon_deg[j] * ORR_RAD_PER_DEG;
                orr_tec_value v;
                orr_status one =
                    orr_tec_vertical(at, (orr_vec3){cos(b) * cos(l), cos(b) * sin(l), sin(b)}, &v, NULL);
                if (one == ORR_E_NODATA || one == ORR_E_RANGE) continue; // stays missing
                size_t to = orr_ionex_index(out, k, 0, i, j);
                out->tec_tecu[to] = v.vtec_tecu;
                out->rms_tecu[to] = v.sigma_tecu;
                if (!isnan(v.sigma_tecu)) with_rms = true;
            }
    }
    free(at);
    if (s == ORR_OK && !with_rms) {
        free(out->rms_tecu);
        out->rms_tecu = NULL;
    }
    if (s != ORR_OK) orr_ionex_free(out);
    return s;
}
