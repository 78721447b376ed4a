// SPDX-License-Identifier: GPL-3.0-or-later
// A session as one NetCDF-4 file: arcs, samples, the correction, and the field itself.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/ncfile.h"
#include "iono/field/tec_field_nc.h"
#include "iono/fusion/session.h"

#define TITLE "Fused ionospheric delays of a station"
#define TIME_UNITS "nanoseconds since 1980-01-06 00:00:00"
#define MAX_ARCS 100000
#define MAX_SAMPLES 50000000
#define MAX_KNOTS 20000

// One column of samples or arcs as a variable.
typedef struct column {
    const char *name, *units, *words;
} column;
enum { STEC, MODEL, RESIDUAL, MAPPING, X, Y, Z, AZ, EL, SAMPLE_COLUMNS };
static const column SAMPLE[SAMPLE_COLUMNS] = {
    {"stec_tecu", ORR_NC_TECU, "slant TEC: carrier phases less the bias of their arc"},
    {"model_stec_tecu", ORR_NC_TECU, "slant TEC of the field alone"},
    {"residual_vtec_tecu", ORR_NC_TECU, "vertical TEC less field and correction"},
    {"mapping", "1", "slant over vertical"},
    {"pierce_x", "1", "pierce point, geocentric unit vector, ecef"},
    {"pierce_y", "1", NULL},
    {"pierce_z", "1", NULL},
    {"azimuth_rad", "rad", "clockwise from North"},
    {"elevation_rad", "rad", NULL}};

static double *field_of(orr_session_sample *s, int c)
{
    switch (c) {
    case STEC:
        return &s->stec_tecu;
    case MODEL:
        return &s->model_stec_tecu;
    case RESIDUAL:
        return &s->residual_tecu;
    case MAPPING:
        return &s->mapping;
    case X:
        return &s->pierce.x;
    case Y:
        return &s->pierce.y;
    case Z:
        return &s->pierce.z;
    case AZ:
        return &s->az_rad;
    default:
        return &s->el_rad;
    }
}

static void put_samples(orr_nc_writer *w, const orr_session *s, double *buf, int64_t *time, orr_diag *diag)
{
    const char *dim[] = {"sample"};
    orr_nc_put_dim(w, "sample", s->n_samples, diag);
    for (size_t i = 0; i < s->n_samples; i++) time[i] = s->sample[i].t;
    orr_nc_put_var(w, "t", ORR_NC_INT64, 1, dim, time, TIME_UNITS, "epoch", diag);
    for (int c = 0; c < SAMPLE_COLUMNS; c++) {
        for (size_t i = 0; i < s->n_samples; i++) buf[i] = *field_of(&s->sample[i], c);
        orr_nc_put_var(w, SAMPLE[c].name, ORR_NC_DOUBLE, 1, dim, buf, SAMPLE[c].units, SAMPLE[c].words, diag);
    }
    for (size_t i = 0; i < s->n_samples; i++) buf[i] = s->sample[i].stec_tecu / s->sample[i].mapping;
    orr_nc_put_var(w, "vtec_tecu", ORR_NC_DOUBLE, 1, dim, buf, ORR_NC_TECU,
                   "vertical TEC at the pierce point: stec / mapping", diag);
    // For readers of the file alone; not read back.
    for (size_t a = 0; a < s->n_arcs; a++)
        for (size_t i = s->arc[a].first; i < s->arc[a].first + s->arc[a].n; i++)
            buf[i] = s->sample[i].stec_tecu + s->arc[a].bias_tecu;
    orr_nc_put_var(
        w, "phase_tecu", ORR_NC_DOUBLE, 1, dim, buf, ORR_NC_TECU,
        "the phases' curve as measured (wind-up and repaired slips taken out): stec + bias of the arc", diag);
    for (size_t a = 0; a < s->n_arcs; a++)
        for (size_t i = s->arc[a].first; i < s->arc[a].first + s->arc[a].n; i++)
            buf[i] = orr_iono_delay_m(s->sample[i].stec_tecu, s->arc[a].freq1_hz, ORR_MEASURES_CODE);
    orr_nc_put_var(w, "delay_m", ORR_NC_DOUBLE, 1, dim, buf, "m",
                   "delay of a code on the arc's first carrier; a phase is early by it", diag);
    for (size_t a = 0; a < s->n_arcs; a++)
        for (size_t i = s->arc[a].first; i < s->arc[a].first + s->arc[a].n; i++)
            buf[i] = s->arc[a].sigma_tecu;
    orr_nc_put_var(w, "sigma_tecu", ORR_NC_DOUBLE, 1, dim, buf, ORR_NC_TECU,
                   "1-sigma of stec: that of the arc's bias", diag);
}

static void put_arcs(orr_nc_writer *w, const orr_session *s, double *buf, int64_t *whole, uint16_t *sat,
                     char (*name)[4], orr_diag *diag)
{
    const char *dim[] = {"arc"}, *text[] = {"arc", "sat_name"};
    size_t n = s->n_arcs;
    orr_nc_put_dim(w, "arc", n, diag);
    orr_nc_put_dim(w, "sat_name", 4, diag);
    for (size_t a = 0; a < n; a++) {
        char id[ORR_SAT_TEXT];
        sat[a] = s->arc[a].sat;
        memset(name[a], 0, 4);
        memcpy(name[a], orr_sat_text(s->arc[a].sat, id), 3);
        whole[a] = (int64_t)s->arc[a].n;
    }
    orr_nc_put_var(w, "arc_satellite", ORR_NC_CHAR, 2, text, name, NULL, "satellite", diag);
    orr_nc_put_var(w, "arc_sat", ORR_NC_UINT16, 1, dim, sat, NULL, "satellite as a number", diag);
    orr_nc_put_var(w, "arc_samples", ORR_NC_INT64, 1, dim, whole, "1",
                   "samples of the arc; they follow each other", diag);
    for (size_t a = 0; a < n; a++) buf[a] = s->arc[a].bias_tecu;
    orr_nc_put_var(w, "arc_bias_tecu", ORR_NC_DOUBLE, 1, dim, buf, ORR_NC_TECU, "phase curve minus slant TEC",
                   diag);
    for (size_t a = 0; a < n; a++) buf[a] = s->arc[a].sigma_tecu;
    orr_nc_put_var(w, "arc_sigma_tecu", ORR_NC_DOUBLE, 1, dim, buf, ORR_NC_TECU, "1-sigma of the bias", diag);
    for (size_t a = 0; a < n; a++) buf[a] = s->arc[a].freq1_hz;
    orr_nc_put_var(w, "arc_freq1_hz", ORR_NC_DOUBLE, 1, dim, buf, "Hz", "first carrier", diag);
}

static void put_number(orr_nc_writer *w, const char *name, double v, orr_diag *diag)
{
    orr_nc_put_att_double(w, NULL, name, &v, 1, diag);
}

orr_status orr_session_save(const orr_session *s, const char *path, const char *history,
                            const orr_nc_input *input, size_t n_inputs, orr_diag *diag)
{
    size_t most = s->n_samples > s->n_arcs ? s->n_samples : s->n_arcs;
    double *buf = malloc((most + 1) * sizeof *buf);
    int64_t *whole = malloc((most + 1) * sizeof *whole);
    uint16_t *sat = malloc((s->n_arcs + 1) * sizeof *sat);
    char(*name)[4] = malloc((s->n_arcs + 1) * sizeof *name);
    orr_nc_writer w;
    orr_status status = ORR_OK;
    if (buf == NULL || whole == NULL || sat == NULL || name == NULL)
        status = orr_diag_set(diag, ORR_E_MEMORY, "no memory to write a session");
    if (status == ORR_OK) status = orr_nc_create(path, &w, diag);
    if (status == ORR_OK) {
        orr_nc_put_provenance(&w, TITLE, history, input, n_inputs, diag);
        orr_nc_put_att_text(&w, NULL, "product", "iono-session", diag);
        orr_nc_put_att_text(&w, NULL, "station", s->station, diag);
        orr_nc_put_att_text(&w, NULL, "method", s->method, diag);
        put_number(&w, "station_x_m", s->site.pos_m.x, diag);
        put_number(&w, "station_y_m", s->site.pos_m.y, diag);
        put_number(&w, "station_z_m", s->site.pos_m.z, diag);
        put_number(&w, "interval_s", s->interval_s, diag);
        put_number(&w, "max_gap_s", s->max_gap_s, diag);
        put_number(&w, "small_scale_sigma_tecu", s->small.sigma_tecu, diag);
        put_number(&w, "small_scale_length_m", s->small.length_m, diag);
        put_number(&w, "small_scale_time_s", s->small.time_s, diag);
        put_number(&w, "small_scale_own_tecu", s->small.own_tecu, diag);
        orr_nc_put_att_int64(&w, NULL, "from_ns", &s->from, 1, diag);
        orr_nc_put_att_int64(&w, NULL, "to_ns", &s->to, 1, diag);
        put_samples(&w, s, buf, whole, diag);
        put_arcs(&w, s, buf, whole, sat, name, diag);
        if (s->correction.n > 0) {
            const char *dims[] = {"knot", "correction_term"};
            orr_nc_put_dim(&w, "knot", s->correction.n, diag);
            orr_nc_put_dim(&w, "correction_term", ORR_CORRECTION_TERMS, diag);
            orr_nc_put_var(&w, "correction", ORR_NC_DOUBLE, 2, dims, s->correction.term, ORR_NC_TECU,
                           "correction of vertical TEC: 1, x, y, x^2, x y, y^2, x^3, x^2 y, x y^2, y^3 (x "
                           "East, y North in 1000 km on the "
                           "shell), effective height in 100 km, content of the plasmasphere",
                           diag);
            orr_nc_put_att_int64(&w, NULL, "correction_t0_ns", &s->correction.t0, 1, diag);
            put_number(&w, "correction_knot_s", s->correction.knot_s, diag);
            put_number(&w, "correction_reach", s->correction.reach, diag);
        }
        status = orr_tec_field_put(&w, s->field, diag);
        if (status == ORR_OK)
            status = orr_nc_commit(&w, diag);
        else
            orr_nc_abort(&w);
    }
    free(buf);
    free(whole);
    free(sat);
    free(name);
    return status;
}

static orr_status get_scalars(const orr_nc_reader *r, orr_session *s, orr_diag *diag)
{
    orr_vec3 pos;
    const struct {
        const char *name;
        double *v;
    } real[] = {{"station_x_m", &pos.x},
                {"station_y_m", &pos.y},
                {"station_z_m", &pos.z},
                {"interval_s", &s->interval_s},
                {"max_gap_s", &s->max_gap_s},
                {"small_scale_sigma_tecu", &s->small.sigma_tecu},
                {"small_scale_length_m", &s->small.length_m},
                {"small_scale_time_s", &s->small.time_s},
                {"small_scale_own_tecu", &s->small.own_tecu}};
    for (size_t i = 0; i < sizeof real / sizeof *real; i++)
        if (orr_nc_get_att_double(r, NULL, real[i].name, real[i].v, NULL) != ORR_OK || !isfinite(*real[i].v))
            return orr_diag_set(diag, ORR_E_FORMAT, "%s: no usable attribute %s", r->path, real[i].name);
    if (orr_nc_get_att_int64(r, NULL, "from_ns", &s->from, NULL) != ORR_OK ||
        orr_nc_get_att_int64(r, NULL, "to_ns", &s->to, NULL) != ORR_OK || s->from > s->to ||
        !orr_time_is_near(s->from) || !orr_time_is_near(s->to))
        return orr_diag_set(diag, ORR_E_FORMAT, "%s: no usable span (from_ns, to_ns)", r->path);
    if (!(s->small.length_m > 1 && s->small.length_m < 1e9) ||
        !(s->small.time_s > 0 && s->small.time_s < 1e8) ||
        !(s->small.sigma_tecu >= 0 && s->small.sigma_tecu < 1e5) ||
        !(s->small.own_tecu >= 0 && s->small.own_tecu < fmax(s->small.sigma_tecu, 1e-12)) ||
        !(s->interval_s >= 0))
        return orr_diag_set(diag, ORR_E_FORMAT, "%s: its small-scale structure makes no sense", r->path);
    orr_nc_get_att_text(r, NULL, "station", s->station, sizeof s->station, NULL); // a name may be missing
    orr_nc_get_att_text(r, NULL, "method", s->method, sizeof s->method, NULL);
    return orr_iono_site_at(pos, &s->site, diag);
}

static orr_status get_samples(const orr_nc_reader *r, orr_session *s, orr_diag *diag)
{
    orr_status status = orr_nc_get_dim(r, "sample", MAX_SAMPLES, &s->n_samples, diag);
    if (status != ORR_OK) return status;
    void *got = NULL;
    status = orr_nc_alloc_var(r, "t", ORR_NC_INT64, 1, &s->n_samples, &got, diag);
    if (status != ORR_OK) return status;
    s->sample = calloc(s->n_samples + 1, sizeof *s->sample); // as many as there are times
    for (size_t i = 0; s->sample != NULL && i < s->n_samples; i++) s->sample[i].t = ((const int64_t *)got)[i];
    free(got);
    if (s->sample == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a session");
    for (int c = 0; c < SAMPLE_COLUMNS; c++) {
        status = orr_nc_alloc_var(r, SAMPLE[c].name, ORR_NC_DOUBLE, 1, &s->n_samples, &got, diag);
        if (status != ORR_OK) return status;
        bool finite = true;
        for (size_t i = 0; i < s->n_samples; i++) {
            *field_of(&s->sample[i], c) = ((const double *)got)[i];
            finite = finite && isfinite(((const double *)got)[i]);
        }
        free(got);
        if (!finite)
            return orr_diag_set(diag, ORR_E_FORMAT, "%s: %s has values that are no numbers", r->path,
                                SAMPLE[c].name);
    }
    return ORR_OK;
}

static orr_status get_arcs(const orr_nc_reader *r, orr_session *s, orr_diag *diag)
{
    orr_status status = orr_nc_get_dim(r, "arc", MAX_ARCS, &s->n_arcs, diag);
    if (status != ORR_OK) return status;
    size_t n = s->n_arcs, total = 0;
    s->arc = calloc(n + 1, sizeof *s->arc);
    uint16_t *sat = calloc(n + 1, sizeof *sat);
    int64_t *count = calloc(n + 1, sizeof *count);
    double *number = calloc(3 * (n + 1), sizeof *number);
    if (s->arc == NULL || sat == NULL || count == NULL || number == NULL)
        status = orr_diag_set(diag, ORR_E_MEMORY, "no memory for a session");
    if (status == ORR_OK) status = orr_nc_get_var(r, "arc_sat", ORR_NC_UINT16, 1, &n, sat, diag);
    if (status == ORR_OK) status = orr_nc_get_var(r, "arc_samples", ORR_NC_INT64, 1, &n, count, diag);
    if (status == ORR_OK) status = orr_nc_get_var(r, "arc_bias_tecu", ORR_NC_DOUBLE, 1, &n, number, diag);
    if (status == ORR_OK)
        status = orr_nc_get_var(r, "arc_sigma_tecu", ORR_NC_DOUBLE, 1, &n, number + n, diag);
    if (status == ORR_OK)
        status = orr_nc_get_var(r, "arc_freq1_hz", ORR_NC_DOUBLE, 1, &n, number + 2 * n, diag);
    for (size_t a = 0; status == ORR_OK && a < n; a++) {
        bool good = count[a] >= 0 && (size_t)count[a] <= s->n_samples - total;
        for (size_t i = 1; good && i < (size_t)count[a]; i++)
            good = s->sample[total + i].t > s->sample[total + i - 1].t;
        for (size_t i = 0; good && i < (size_t)count[a]; i++) good = orr_time_is_near(s->sample[total + i].t);
        if (!good) {
            status = orr_diag_set(diag, ORR_E_FORMAT, "%s: arc %zu does not fit its samples", r->path, a);
            break;
        }
        s->arc[a] =
            (orr_session_arc){sat[a], total, (size_t)count[a], number[a], number[n + a], number[2 * n + a]};
        total += (size_t)count[a];
    }
    free(sat);
    free(count);
    free(number);
    return status;
}

static orr_status get_correction(const orr_nc_reader *r, orr_session *s, orr_diag *diag)
{
    orr_correction *c = &s->correction;
    c->up = orr_vec3_unit(s->site.pos_m);
    c->east = s->site.east;
    c->north = orr_vec3_cross(c->up, c->east);
    c->scale = orr_tec_field_shell_radius_m(s->field) / 1e6;
    c->knot_s = 3600;
    c->reach = 1.5;
    if (!orr_nc_has_var(r, "correction")) return ORR_OK;
    orr_status status = orr_nc_get_dim(r, "knot", MAX_KNOTS, &c->n, diag);
    if (status != ORR_OK) return status;
    void *term = NULL;
    status = orr_nc_alloc_var(r, "correction", ORR_NC_DOUBLE, 2, (size_t[]){c->n, ORR_CORRECTION_TERMS},
                              &term, diag);
    if (status != ORR_OK) {
        c->n = 0;
        return status;
    }
    c->term = term;
    if (orr_nc_get_att_int64(r, NULL, "correction_t0_ns", &c->t0, NULL) != ORR_OK ||
        orr_nc_get_att_double(r, NULL, "correction_knot_s", &c->knot_s, NULL) != ORR_OK ||
        orr_nc_get_att_double(r, NULL, "correction_reach", &c->reach, NULL) != ORR_OK || !(c->knot_s > 0) ||
        !(c->reach > 0) || !orr_time_is_near(c->t0))
        return orr_diag_set(diag, ORR_E_FORMAT, "%s: its correction has no usable knots", r->path);
    return ORR_OK;
}

orr_status orr_session_load(const char *path, const orr_leap_table *leap, orr_session *out, orr_diag *diag)
{
    *out = (orr_session){0};
    orr_nc_reader r;
    orr_status s = orr_nc_open(path, &r, diag);
    if (s != ORR_OK) return s;
    char product[32] = "";
    if (orr_nc_get_att_text(&r, NULL, "product", product, sizeof product, NULL) != ORR_OK ||
        strcmp(product, "iono-session") != 0)
        s = orr_diag_set(diag, ORR_E_KIND, "%s is no ionospheric session (made by `orrery iono`)", path);
    if (s == ORR_OK) s = get_scalars(&r, out, diag);
    if (s == ORR_OK) s = orr_tec_field_get(&r, leap, &out->field, diag);
    if (s == ORR_OK) s = get_samples(&r, out, diag);
    if (s == ORR_OK) s = get_arcs(&r, out, diag);
    if (s == ORR_OK) s = get_correction(&r, out, diag);
    orr_nc_close(&r);
    if (s != ORR_OK) orr_session_free(out);
    return s;
}
