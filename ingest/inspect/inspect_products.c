// SPDX-License-Identifier: GPL-3.0-or-later
// What files of analysis centres other than orbits are told of: maps, coefficients, Earth rotation, clocks,
// antennas, biases, station coordinates.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/vec.h"
#include "ingest/inspect/inspect.h"
#include "ingest/maps/ion.h"
#include "ingest/maps/ionex.h"
#include "ingest/rinex/clk.h"
#include "ingest/tables/antex.h"
#include "ingest/tables/bias.h"
#include "ingest/tables/erp.h"
#include "ingest/tables/sinex.h"

static void widen(orr_inspection *r, orr_time from, orr_time to)
{
    if (from != ORR_TIME_NONE && (r->from == ORR_TIME_NONE || from < r->from)) r->from = from;
    if (to != ORR_TIME_NONE && (r->to == ORR_TIME_NONE || to > r->to)) r->to = to;
}

static void made_by(orr_inspection *r, const char *program, const char *run_by, const char *date)
{
    if (program[0] != '\0') orr_inspect_fact_add(r, "made by", "%s  %s  %s", program, run_by, date);
}

// ---- maps ----

static void value_range(orr_inspection *r, const char *label, const double *v, size_t n, double factor,
                        const char *unit)
{
    double lo = HUGE_VAL, hi = -HUGE_VAL;
    size_t missing = 0;
    for (size_t i = 0; v != NULL && i < n; i++) {
        missing += isnan(v[i]) ? 1 : 0;
        if (v[i] < lo) lo = v[i];
        if (v[i] > hi) hi = v[i];
    }
    if (v == NULL) return;
    if (lo > hi)
        orr_inspect_fact_add(r, label, "no value at all");
    else if (missing > 0)
        orr_inspect_fact_add(r, label, "%.1f to %.1f %s, %.1f %% of the values missing", lo * factor,
                             hi * factor, unit, 100.0 * (double)missing / (double)n);
    else
        orr_inspect_fact_add(r, label, "%.1f to %.1f %s", lo * factor, hi * factor, unit);
}

static orr_read_limits limits_of(const orr_inspection *r)
{
    orr_read_limits limits = orr_read_default_limits();
    limits.leap = r->leap;
    return limits;
}

orr_status orr_inspect_ionex(const char *path, orr_inspection *r, orr_diag *diag)
{
    orr_ionex x;
    const orr_read_limits limits = limits_of(r);
    orr_bytes text;
    orr_status s = orr_inspect_text(r, path, &text, diag);
    if (s != ORR_OK) return s;
    s = orr_ionex_parse(path, text.text, text.n, &limits, &x, &r->warnings, diag);
    orr_bytes_free(&text);
    if (s != ORR_OK) return s;
    orr_inspect_epochs(r, x.epoch, x.n_epochs);
    size_t cells = x.n_heights * x.n_lats * x.n_lons, n = x.n_epochs * cells;
    r->records = 0; // maps of every kind that hold a value
    const double *kind[3] = {x.tec_tecu, x.rms_tecu, x.hgt_m};
    for (int k = 0; k < 3; k++) {
        for (size_t e = 0; kind[k] != NULL && e < x.n_epochs; e++) {
            bool any = false;
            for (size_t i = 0; i < cells && !any; i++) any = !isnan(kind[k][e * cells + i]);
            r->records += any;
        }
    }
    for (size_t i = 0; i < x.n_dcbs; i++) {
        orr_inspect_sat_add(r, x.dcb[i].sat);
        orr_inspect_system_add(r, x.dcb[i].system);
    }
    made_by(r, x.program, x.run_by, x.date);
    orr_inspect_fact_add(r, "technique", "%s", x.technique);
    orr_inspect_fact_add(r, "grid", "%zu latitudes %.1f to %.1f, %zu longitudes %.1f to %.1f", x.n_lats,
                         x.lat_deg[0], x.lat_deg[x.n_lats - 1], x.n_lons, x.lon_deg[0],
                         x.lon_deg[x.n_lons - 1]);
    orr_inspect_fact_add(r, "layer", "%zu height%s from %.1f km above %.1f km", x.n_heights,
                         x.n_heights > 1 ? "s" : "", x.height_m[0] * 1e-3, x.base_radius_m * 1e-3);
    if (x.mapping_text[0] != '\0') orr_inspect_fact_add(r, "mapping", "%s", x.mapping_text);
    value_range(r, "electron content", x.tec_tecu, n, 1, "TECU");
    value_range(r, "its RMS", x.rms_tecu, n, 1, "TECU");
    value_range(r, "height maps", x.hgt_m, n, 1e-3, "km");
    if (x.n_dcbs > 0) orr_inspect_fact_add(r, "code biases", "%zu", x.n_dcbs);
    orr_inspect_fact_add(r, "time labels", "universal time");
    orr_ionex_free(&x);
    return ORR_OK;
}

orr_status orr_inspect_ion(const char *path, orr_inspection *r, orr_diag *diag)
{
    orr_ion x;
    const orr_read_limits limits = limits_of(r);
    orr_bytes text;
    orr_status s = orr_inspect_text(r, path, &text, diag);
    if (s != ORR_OK) return s;
    s = orr_ion_parse(path, text.text, text.n, &limits, &x, &r->warnings, diag);
    orr_bytes_free(&text);
    if (s != ORR_OK) return s;
    orr_time *t = malloc(x.n_models * sizeof *t);
    size_t n = 0, coefficients = 0;
    for (size_t i = 0; i < x.n_models; i++) {
        const orr_ion_model *m = &x.model[i];
        widen(r, m->from, m->to != ORR_TIME_NONE ? m->to : m->from);
        coefficients += m->n_coefficients;
        if (t != NULL && (n == 0 || m->from > t[n - 1])) t[n++] = m->from;
    }
    if (t != NULL) {
        orr_time to = r->to;
        orr_inspect_epochs(r, t, n);
        widen(r, ORR_TIME_NONE, to);
    }
    free(t);
    r->records = (int64_t)x.n_models;
    const orr_ion_model *m = &x.model[0];
    static const char *const mapping[] = {"none", "1/cos z", "modified single layer", "extended slab"};
    orr_inspect_fact_add(r, "title", "%s", m->title);
    orr_inspect_fact_add(r, "expansion", "degree %d, order %d, %zu coefficients in all", m->max_degree,
                         m->max_order, coefficients);
    orr_inspect_fact_add(r, "frame", "%s, %s Sun",
                         m->frame == ORR_ION_GEOMAGNETIC ? "geomagnetic" : "geographic",
                         m->sun == ORR_ION_SUN_MEAN ? "mean" : "true");
    orr_inspect_fact_add(r, "mapping", "%s", mapping[m->mapping]);
    if (!isnan(m->layer_height_m)) orr_inspect_fact_add(r, "layer", "%.1f km", m->layer_height_m * 1e-3);
    if (m->to == ORR_TIME_NONE) orr_inspect_fact_add(r, "validity", "snapshots, linear in time between them");
    orr_ion_free(&x);
    return ORR_OK;
}

// ---- Earth rotation and clocks ----

orr_status orr_inspect_erp(const char *path, orr_inspection *r, orr_diag *diag)
{
    orr_erp x;
    orr_bytes text;
    orr_status s = orr_inspect_text(r, path, &text, diag);
    if (s != ORR_OK) return s;
    s = orr_erp_parse(path, text.text, text.n, r->leap, NULL, &x, &r->warnings, diag);
    orr_bytes_free(&text);
    if (s != ORR_OK) return s;
    orr_time *t = malloc(x.series.n * sizeof *t);
    if (t == NULL) {
        orr_erp_free(&x);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu instants", x.series.n);
    }
    for (size_t i = 0; i < x.series.n; i++) {
        double day = floor(x.series.mjd_utc[i]);
        t[i] = orr_time_from_mjd((int32_t)day, x.series.mjd_utc[i] - day, ORR_SCALE_UTC, NULL);
    }
    orr_leap_warn(t[x.series.n - 1], r->leap, path, &r->warnings);
    orr_inspect_epochs(r, t, x.series.n);
    free(t);
    if (x.version > 0) snprintf(r->version, sizeof r->version, "%d", x.version % 100);
    r->records = (int64_t)x.series.n;
    const orr_eop *e = &x.series.value[0];
    const double mas = ORR_DEG_PER_RAD * 3600e3;
    if (x.title[0] != '\0') orr_inspect_fact_add(r, "title", "%s", x.title);
    orr_inspect_fact_add(r, "first values", "pole %.3f %.3f mas, UT1-UTC %.4f ms, LOD %.4f ms",
                         e->xp_rad * mas, e->yp_rad * mas, e->ut1_utc_s * 1e3, e->lod_s * 1e3);
    orr_erp_free(&x);
    return ORR_OK;
}

orr_status orr_inspect_clk(const char *path, orr_inspection *r, orr_diag *diag)
{
    orr_clk x;
    const orr_read_limits limits = limits_of(r);
    orr_bytes text;
    orr_status s = orr_inspect_text(r, path, &text, diag);
    if (s != ORR_OK) return s;
    s = orr_clk_parse(path, text.text, text.n, &limits, &x, &r->warnings, diag);
    orr_bytes_free(&text);
    if (s != ORR_OK) return s;
    size_t records = 0;
    orr_inspect_epochs(r, x.epoch, x.n_epochs);
    snprintf(r->version, sizeof r->version, "%.2f", x.version);
    r->satellites = 0;
    for (size_t i = 0; i < x.n_sats; i++) {
        orr_inspect_sat_add(r, x.sat[i].sat);
        records += x.sat[i].n;
    }
    size_t receiver_records = 0;
    for (size_t i = 0; i < x.n_receivers; i++) receiver_records += x.receiver[i].n;
    r->records = (int64_t)(records + receiver_records);
    made_by(r, x.program, x.run_by, x.date);
    if (x.agency[0] != '\0') orr_inspect_fact_add(r, "agency", "%s", x.agency);
    if (x.reference[0] != '\0') orr_inspect_fact_add(r, "reference clock", "%s", x.reference);
    orr_inspect_fact_add(r, "satellite clocks", "%zu records", records);
    if (x.n_receivers > 0)
        orr_inspect_fact_add(r, "receiver clocks", "%zu records of %zu receivers", receiver_records,
                             x.n_receivers);
    orr_inspect_fact_add(r, "time labels", "%s", orr_scale_name(x.scale));
    orr_clk_free(&x);
    return ORR_OK;
}

// ---- antennas, biases, coordinates ----

orr_status orr_inspect_antex(const char *path, orr_inspection *r, orr_diag *diag)
{
    orr_antex x;
    const orr_read_limits limits = limits_of(r);
    orr_bytes text;
    orr_status s = orr_inspect_text(r, path, &text, diag);
    if (s != ORR_OK) return s;
    s = orr_antex_parse(path, text.text, text.n, &limits, &x, &r->warnings, diag);
    orr_bytes_free(&text);
    if (s != ORR_OK) return s;
    snprintf(r->version, sizeof r->version, "%.1f", x.version);
    r->records = (int64_t)x.n_antennas;
    r->satellites = 0;
    for (size_t i = 0; i < x.n_antennas; i++) {
        orr_inspect_sat_add(r, x.antenna[i].sat);
        if (x.antenna[i].sat != ORR_SAT_NONE) widen(r, x.antenna[i].valid_from, x.antenna[i].valid_until);
    }
    orr_inspect_fact_add(r, "values", "%s", x.pcv_type == 'A' ? "absolute" : "relative");
    orr_inspect_fact_add(r, "satellite antennas", "%zu", x.n_satellites);
    orr_inspect_fact_add(r, "receiver antennas", "%zu", x.n_antennas - x.n_satellites);
    orr_antex_free(&x);
    return ORR_OK;
}

orr_status orr_inspect_bias(const char *path, orr_inspection *r, orr_diag *diag)
{
    orr_bias_set x;
    const orr_read_limits limits = limits_of(r);
    orr_bytes text;
    orr_status s = orr_inspect_text(r, path, &text, diag);
    if (s != ORR_OK) return s;
    s = orr_bias_parse(path, text.text, text.n, &limits, &x, &r->warnings, diag);
    orr_bytes_free(&text);
    if (s != ORR_OK) return s;
    if (x.version > 0) snprintf(r->version, sizeof r->version, "%.2f", x.version);
    widen(r, x.from, x.until);
    r->records = (int64_t)x.n;
    r->satellites = 0;
    size_t kinds[3] = {0}, phase = 0, stations = 0;
    for (size_t i = 0; i < x.n; i++) {
        const orr_bias *b = &x.bias[i];
        orr_inspect_sat_add(r, b->sat);
        orr_inspect_system_add(r, b->system);
        kinds[b->kind]++;
        phase += b->obs1[0] == 'L';
        stations += b->station[0] != '\0';
    }
    orr_inspect_fact_add(r, "format", "%s, %s", x.format, x.absolute ? "absolute" : "differences");
    if (x.agency[0] != '\0') orr_inspect_fact_add(r, "agency", "%s", x.agency);
    orr_inspect_fact_add(r, "biases", "%zu OSB, %zu DSB, %zu ISB", kinds[ORR_BIAS_OSB], kinds[ORR_BIAS_DSB],
                         kinds[ORR_BIAS_ISB]);
    orr_inspect_fact_add(r, "of them", "%zu of phases, %zu of stations", phase, stations);
    orr_bias_free(&x);
    return ORR_OK;
}

orr_status orr_inspect_sinex(const char *path, orr_inspection *r, orr_diag *diag)
{
    orr_sinex x;
    const orr_read_limits limits = limits_of(r);
    orr_bytes text;
    orr_status s = orr_inspect_text(r, path, &text, diag);
    if (s != ORR_OK) return s;
    s = orr_sinex_parse(path, text.text, text.n, &limits, &x, &r->warnings, diag);
    orr_bytes_free(&text);
    if (s != ORR_OK) return s;
    snprintf(r->version, sizeof r->version, "%.2f", x.version);
    widen(r, x.from, x.until);
    r->records = (int64_t)x.n_estimates;
    orr_inspect_fact_add(r, "agency", "%s", x.agency);
    orr_inspect_fact_add(r, "sites", "%zu", x.n_sites);
    orr_inspect_fact_add(r, "coordinates", "%zu", x.n_estimates);
    orr_inspect_fact_add(r, "eccentricities", "%zu", x.n_eccentricities);
    orr_sinex_free(&x);
    return ORR_OK;
}
