// SPDX-License-Identifier: GPL-3.0-or-later
// States, clocks and attitude in the forms that other programs read. Dates of headers are those of the data, so that the same
// products make the same bytes.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "core/ncfile.h"
#include "core/outfile.h"
#include "core/path.h"
#include "ingest/rinex/clk.h"
#include "orbit/spacecraft/spacecraft.h"
#include "src/cli/orbit/states_write.h"

static size_t epochs_of(const states_request *q) { return (size_t)((q->to - q->from) / q->step_ns) + 1; }

static bool wanted(const states_request *q, orr_sat sat)
{
    return q->sats == NULL || orr_sat_set_has(q->sats, sat);
}

static size_t count_wanted(const orr_products *p, const states_request *q)
{
    size_t n = 0;
    for (size_t i = 0; i < p->n_sats; i++) n += wanted(q, p->sat[i]);
    return n;
}

static orr_status out_of_memory(orr_diag *diag) { return orr_diag_set(diag, ORR_E_MEMORY, "out of memory"); }

static orr_civil civil_of(orr_time t)
{
    orr_civil c;
    orr_time_to_civil(t, ORR_SCALE_GPS, NULL, &c);
    return c;
}

// --- RINEX CLK ---

static void clk_free(orr_clk *x)
{
    for (size_t k = 0; k < x->n_sats; k++) free(x->sat[k].record);
    free(x->sat);
    free(x->epoch);
}

static orr_status clk_alloc(const orr_products *p, const states_request *q, orr_clk *x, orr_diag *diag)
{
    x->n_epochs = epochs_of(q);
    x->n_sats = 0;
    x->sat = calloc(count_wanted(p, q) + 1, sizeof *x->sat);
    x->epoch = calloc(x->n_epochs, sizeof *x->epoch);
    if (x->sat == NULL || x->epoch == NULL) return out_of_memory(diag);
    for (size_t i = 0; i < p->n_sats; i++) {
        if (!wanted(q, p->sat[i])) continue;
        orr_clk_series *c = &x->sat[x->n_sats++];
        c->sat = p->sat[i];
        orr_sat_text(c->sat, c->name);
        c->record = calloc(x->n_epochs, sizeof *c->record);
        if (c->record == NULL) return out_of_memory(diag);
    }
    return ORR_OK;
}

static void clk_fill(const orr_products *p, const states_request *q, orr_sat_state *state, orr_clk *x,
                     states_count *count)
{
    for (size_t i = 0; i < x->n_epochs; i++) {
        const orr_time t = x->epoch[i] = q->from + (int64_t)i * q->step_ns;
        const size_t n = states_at(p, q, t, state, count);
        for (size_t j = 0, k = 0; j < n; j++) {
            while (x->sat[k].sat != state[j].sat) k++; // both ascend
            if ((state[j].flags & ORR_EPH_CLOCK_VALID) == 0) continue;
            x->sat[k].record[x->sat[k].n++] = (orr_clk_record){.t = t,
                                                               .bias_s = state[j].clock_s,
                                                               .bias_sdev_s = (double)state[j].clock_sigma_s,
                                                               .rate_sps = ORR_NAN,
                                                               .rate_sdev_sps = ORR_NAN};
        }
    }
}

orr_status states_write_clk(const orr_products *p, const states_request *q, states_count *count,
                            orr_diag *diag)
{
    orr_clk x = {
        .version = 3.0, .system = 'M', .scale = ORR_SCALE_GPS, .agency = "Orrery", .leap_seconds = -1};
    const orr_civil c = civil_of(q->from);
    snprintf(x.program, sizeof x.program, "orrery %s", ORR_VERSION);
    snprintf(x.date, sizeof x.date, "%04d%02d%02d %02d%02d%02d GPS", c.year, c.month, c.day, c.hour, c.minute,
             c.second);
    orr_sat_state *state = calloc(p->n_sats, sizeof *state);
    orr_status s = state != NULL ? clk_alloc(p, q, &x, diag) : out_of_memory(diag);
    if (s == ORR_OK) {
        clk_fill(p, q, state, &x, count);
        s = orr_clk_write(&x, q->path, diag);
    }
    clk_free(&x);
    free(state);
    return s;
}

// --- ORBEX ---

static void orbex_time(FILE *f, const char *label, orr_time t)
{
    const orr_civil c = civil_of(t);
    fprintf(f, "%s%04d %02d %02d %02d %02d %15.12f", label, c.year, c.month, c.day, c.hour, c.minute,
            c.second + c.ns * 1e-9);
}

static void orbex_head(FILE *f, const orr_products *p, const states_request *q)
{
    char sat[ORR_SAT_TEXT];
    fputs("%=ORBEX  0.09\n%%\n+FILE/DESCRIPTION\n", f);
    fprintf(f, " DESCRIPTION         Attitude of the satellites of an orbit product\n");
    fprintf(f, " CREATED_BY          orrery %s\n", ORR_VERSION);
    const orr_civil c = civil_of(q->from);
    fprintf(f, " CREATION_DATE       %04d %02d %02d %02d %02d %02d\n", c.year, c.month, c.day, c.hour,
            c.minute, c.second);
    fprintf(f, " INPUT_DATA          %.60s\n", orr_base_name(q->product));
    fputs(" TIME_SYSTEM         GPS\n", f);
    orbex_time(f, " START_TIME          ", q->from);
    orbex_time(f, "\n END_TIME            ", q->from + (int64_t)(epochs_of(q) - 1) * q->step_ns);
    fprintf(f, "\n EPOCH_INTERVAL      %9.3f\n", (double)q->step_ns * 1e-9);
    fprintf(f, " COORD_SYSTEM        %.5s\n FRAME_TYPE          ECEF\n LIST_OF_REC_TYPES   ATT\n",
            orr_ephemeris_frame(p->item[0]));
    fputs("-FILE/DESCRIPTION\n+SATELLITE/ID_AND_DESCRIPTION\n", f);
    for (size_t i = 0; i < p->n_sats; i++)
        if (wanted(q, p->sat[i])) fprintf(f, " %s\n", orr_sat_text(p->sat[i], sat));
    fputs("-SATELLITE/ID_AND_DESCRIPTION\n+EPHEMERIS/DATA\n"
          "*ATT RECORDS: TRANSFORMATION FROM TERRESTRIAL FRAME COORDINATES (T) TO SAT. BODY FRAME ONES (B) "
          "SUCH "
          "AS\n"
          "*                                 (0,B) = q.(0,T).trans(q)\n"
          "*REC ID_              N ___q0_(scalar)_____ ____q1__x__________ ____q2__y__________ "
          "____q3__z__________\n",
          f);
}

orr_status states_write_orbex(const orr_products *p, const states_request *q, states_count *count,
                              orr_diag *diag)
{
    orr_outfile out;
    orr_status s = orr_outfile_open(q->path, &out, diag);
    if (s != ORR_OK) return s;
    orr_spacecraft *x = calloc(p->n_sats, sizeof *x);
    if (x == NULL) return orr_outfile_end(&out, out_of_memory(diag), diag);
    orbex_head(out.stream, p, q);
    for (size_t i = 0; i < epochs_of(q); i++) {
        const orr_time t = q->from + (int64_t)i * q->step_ns;
        orr_spacecraft_sources src = {.orbit = orr_products_at(p, t)};
        const orr_vec3 sun = orr_attitude_sun(t, src.orbit != NULL ? orr_ephemeris_eop(src.orbit) : NULL);
        size_t n = 0, asked = 0;
        for (size_t k = 0; k < p->n_sats; k++) {
            if (!wanted(q, p->sat[k])) continue;
            asked++;
            if (src.orbit != NULL && orr_spacecraft_at(&src, p->sat[k], t, sun, &x[n]) == ORR_OK)
                n += x[n].has_attitude;
        }
        count->written += n;
        count->missing += asked - n;
        orbex_time(out.stream, "## ", t);
        fprintf(out.stream, " %3zu\n", n);
        for (size_t k = 0; k < n; k++) {
            char sat[ORR_SAT_TEXT];
            // Ours turns as conj(q) v q; ORBEX as q v conj(q).
            const orr_quat a = orr_quat_from_mat3(&x[k].attitude.body);
            fprintf(out.stream, " ATT %-17s4 %19.16f %19.16f %19.16f %19.16f\n",
                    orr_sat_text(x[k].state.sat, sat), a.w, -a.x, -a.y, -a.z);
        }
    }
    fputs("-EPHEMERIS/DATA\n%END_ORBEX\n", out.stream);
    free(x);
    return orr_outfile_end(&out, ORR_OK, diag);
}

// --- CCSDS OEM ---

// IGS' frames are realisations of the ITRF whose name their number leads to (IGSMAIL 7399, 8238 and earlier).
static const char *oem_frame(const orr_products *p, const states_request *q)
{
    static const char *const names[][2] = {{"20", "ITRF2020"}, {"14", "ITRF2014"}, {"08", "ITRF2008"},
                                           {"05", "ITRF2005"}, {"00", "ITRF2000"}, {"97", "ITRF-97"}};
    const char *frame = orr_ephemeris_frame(p->item[0]);
    if (q->inertial) return "GCRF";
    for (size_t k = 0; k < sizeof names / sizeof names[0]; k++)
        if (strncmp(frame, "IG", 2) == 0 && strlen(frame) >= 5 && strncmp(frame + 3, names[k][0], 2) == 0)
            return names[k][1];
    return strncmp(frame, "ITR", 3) == 0 ? "ITRF" : frame;
}

static void oem_segment(FILE *f, const char *sat, const char *frame, orr_time from, orr_time to, size_t n)
{
    char a[ORR_TIME_TEXT], b[ORR_TIME_TEXT];
    fprintf(f,
            "\nMETA_START\nOBJECT_NAME = %s\nOBJECT_ID = %s\nCENTER_NAME = EARTH\nREF_FRAME = %s\n"
            "TIME_SYSTEM = GPS\nSTART_TIME = %s\nSTOP_TIME = %s\n",
            sat, sat, frame, orr_time_text(from, a), orr_time_text(to, b));
    if (n > 1) // Hermite through n points is of degree 2 n - 1
        fprintf(f, "INTERPOLATION = HERMITE\nINTERPOLATION_DEGREE = %zu\n", n < 4 ? 2 * n - 1 : (size_t)7);
    fputs("META_STOP\n", f);
}

// One satellite: a stretch without holes is a segment.
static void oem_satellite(const orr_products *p, const states_request *q, size_t sat, orr_sat_state *row,
                          FILE *f, states_count *count)
{
    char name[ORR_SAT_TEXT], text[ORR_TIME_TEXT];
    orr_sat_set one = {0};
    const size_t n = epochs_of(q);
    states_request mine = *q;
    orr_sat_set_add(&one, p->sat[sat]);
    mine.sats = &one;
    orr_sat_text(p->sat[sat], name);
    for (size_t i = 0, end = 0; i < n; i = end + 1) {
        for (end = i; end < n; end++)
            if (states_at(p, &mine, q->from + (int64_t)end * q->step_ns, &row[end], count) == 0) break;
        if (end == i) continue;
        const orr_time from = q->from + (int64_t)i * q->step_ns,
                       to = q->from + (int64_t)(end - 1) * q->step_ns;
        oem_segment(f, name, oem_frame(p, q), from, to, end - i);
        for (size_t k = i; k < end; k++) {
            const orr_vec3 r = row[k].pos_m, v = row[k].vel_mps;
            fprintf(f, "%s %.9f %.9f %.9f %.12f %.12f %.12f\n",
                    orr_time_text(q->from + (int64_t)k * q->step_ns, text), r.x * 1e-3, r.y * 1e-3,
                    r.z * 1e-3, v.x * 1e-3, v.y * 1e-3, v.z * 1e-3);
        }
    }
}

orr_status states_write_oem(const orr_products *p, const states_request *q, states_count *count,
                            orr_diag *diag)
{
    char text[ORR_TIME_TEXT];
    orr_outfile out;
    orr_status s = orr_outfile_open(q->path, &out, diag);
    if (s != ORR_OK) return s;
    orr_sat_state *row = calloc(epochs_of(q), sizeof *row);
    if (row == NULL) return orr_outfile_end(&out, out_of_memory(diag), diag);
    fprintf(out.stream,
            "CCSDS_OEM_VERS = 2.0\nCOMMENT Made by Orrery %s from %.60s; the date is that of the data\n"
            "CREATION_DATE = %s\nORIGINATOR = ORRERY\n",
            ORR_VERSION, orr_base_name(q->product), orr_time_text(q->from, text));
    for (size_t i = 0; i < p->n_sats; i++)
        if (wanted(q, p->sat[i])) oem_satellite(p, q, i, row, out.stream, count);
    free(row);
    return orr_outfile_end(&out, ORR_OK, diag);
}

// --- NetCDF ---

typedef struct nc_tables {
    size_t n_epochs, n_sats;
    double *time_s, *pos_m, *vel_mps, *clock_s;
    float *sigma_m, *clock_sigma_s;
    int32_t *flags;
    char *name;
} nc_tables;

static void nc_free(nc_tables *x)
{
    void *const all[] = {x->time_s,  x->pos_m,         x->vel_mps, x->clock_s,
                         x->sigma_m, x->clock_sigma_s, x->flags,   x->name};
    for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) free(all[k]);
}

static orr_status nc_alloc(const orr_products *p, const states_request *q, nc_tables *x, orr_diag *diag)
{
    x->n_epochs = epochs_of(q);
    x->n_sats = count_wanted(p, q);
    const size_t n = x->n_epochs * x->n_sats;
    if ((uint64_t)n > ORR_NC_MAX_VALUES / 3)
        return orr_diag_set(diag, ORR_E_LIMIT,
                            "%zu states are too many for one file: ask for less, or --split", n);
    x->time_s = calloc(x->n_epochs, sizeof(double));
    x->pos_m = calloc(3 * n + 1, sizeof(double));
    x->vel_mps = calloc(3 * n + 1, sizeof(double));
    x->clock_s = calloc(n + 1, sizeof(double));
    x->sigma_m = calloc(n + 1, sizeof(float));
    x->clock_sigma_s = calloc(n + 1, sizeof(float));
    x->flags = calloc(n + 1, sizeof(int32_t));
    x->name = calloc(4 * x->n_sats + 4, 1);
    const bool good = x->time_s != NULL && x->pos_m != NULL && x->vel_mps != NULL && x->clock_s != NULL &&
                      x->sigma_m != NULL && x->clock_sigma_s != NULL && x->flags != NULL && x->name != NULL;
    if (!good) return out_of_memory(diag);
    for (size_t k = 0; k < 3 * n; k++) x->pos_m[k] = x->vel_mps[k] = ORR_NAN;
    for (size_t k = 0; k < n; k++) {
        x->clock_s[k] = ORR_NAN;
        x->sigma_m[k] = x->clock_sigma_s[k] = (float)ORR_NAN;
    }
    for (size_t i = 0, k = 0; i < p->n_sats; i++) {
        char text[ORR_SAT_TEXT];
        if (wanted(q, p->sat[i])) memcpy(x->name + 3 * k++, orr_sat_text(p->sat[i], text), 3);
    }
    return ORR_OK;
}

static void nc_fill(const orr_products *p, const states_request *q, orr_sat_state *state, nc_tables *x,
                    states_count *count)
{
    for (size_t i = 0; i < x->n_epochs; i++) {
        const orr_time t = q->from + (int64_t)i * q->step_ns;
        const size_t n = states_at(p, q, t, state, count);
        x->time_s[i] = orr_time_diff_s(t, q->from);
        for (size_t j = 0, k = 0; j < n; j++) {
            char text[ORR_SAT_TEXT];
            orr_sat_text(state[j].sat, text);
            while (memcmp(x->name + 3 * k, text, 3) != 0) k++; // both ascend
            const size_t at = i * x->n_sats + k;
            const orr_vec3 r = state[j].pos_m, v = state[j].vel_mps;
            memcpy(&x->pos_m[3 * at], (double[]){r.x, r.y, r.z}, 3 * sizeof(double));
            memcpy(&x->vel_mps[3 * at], (double[]){v.x, v.y, v.z}, 3 * sizeof(double));
            x->flags[at] = (int32_t)state[j].flags;
            x->sigma_m[at] = state[j].sigma_m;
            if ((state[j].flags & ORR_EPH_CLOCK_VALID) == 0) continue;
            x->clock_s[at] = state[j].clock_s;
            x->clock_sigma_s[at] = state[j].clock_sigma_s;
        }
    }
}

static orr_status nc_write(const orr_products *p, const states_request *q, const nc_tables *x, orr_diag *diag)
{
    static const char *const time_sat_axis[] = {"time", "satellite", "axis"}, *const sat_name[] = {
                                                                                  "satellite", "name_length"};
    const char *const *time_sat = time_sat_axis;
    orr_nc_writer w;
    char units[80];
    const orr_civil c = civil_of(q->from);
    orr_status s = orr_nc_create(q->path, &w, diag);
    if (s != ORR_OK) return s;
    snprintf(units, sizeof units, "seconds since %04d-%02d-%02d %02d:%02d:%06.3f", c.year, c.month, c.day,
             c.hour, c.minute, c.second + c.ns * 1e-9);
    orr_nc_put_provenance(&w, "Satellite states of an orbit product", NULL, NULL, 0, diag);
    orr_nc_put_att_text(&w, NULL, "reference_frame", q->inertial ? "GCRS" : orr_ephemeris_frame(p->item[0]),
                        diag);
    orr_nc_put_att_text(&w, NULL, "time_system", "GPS", diag);
    orr_nc_put_dim(&w, "time", x->n_epochs, diag);
    orr_nc_put_dim(&w, "satellite", x->n_sats, diag);
    orr_nc_put_dim(&w, "axis", 3, diag);
    orr_nc_put_dim(&w, "name_length", 3, diag);
    orr_nc_put_var(&w, "time", ORR_NC_DOUBLE, 1, time_sat, x->time_s, units,
                   "time, GPS scale without leap seconds", diag);
    orr_nc_put_att_text(&w, "time", "standard_name", "time", diag);
    orr_nc_put_att_text(&w, "time", "calendar", "standard", diag);
    orr_nc_put_att_text(&w, "time", "axis", "T", diag);
    orr_nc_put_var(&w, "satellite_name", ORR_NC_CHAR, 2, sat_name, x->name, NULL,
                   "satellite as IGS files name it", diag);
    orr_nc_put_var(&w, "position", ORR_NC_DOUBLE, 3, time_sat_axis, x->pos_m, "m",
                   "position of the centre of mass: x, y, z", diag);
    orr_nc_put_var(&w, "velocity", ORR_NC_DOUBLE, 3, time_sat_axis, x->vel_mps, "m s-1", "velocity: x, y, z",
                   diag);
    orr_nc_put_var(&w, "clock", ORR_NC_DOUBLE, 2, time_sat, x->clock_s, "s",
                   "clock offset without periodic relativity", diag);
    orr_nc_put_var(&w, "sigma", ORR_NC_FLOAT, 2, time_sat, x->sigma_m, "m",
                   "standard deviation of the position, 3-D", diag);
    orr_nc_put_var(&w, "clock_sigma", ORR_NC_FLOAT, 2, time_sat, x->clock_sigma_s, "s",
                   "standard deviation of the clock offset", diag);
    s = orr_nc_put_var(&w, "flags", ORR_NC_INT32, 2, time_sat, x->flags, NULL, "what holds for a state",
                       diag);
    static const char *const named[] = {"position", "velocity", "clock", "sigma", "clock_sigma", "flags"};
    for (size_t k = 0; k < sizeof named / sizeof named[0]; k++)
        s = orr_nc_put_att_text(&w, named[k], "coordinates", "satellite_name", diag);
    if (s == ORR_OK) return orr_nc_commit(&w, diag);
    orr_nc_abort(&w);
    return s;
}

orr_status states_write_netcdf(const orr_products *p, const states_request *q, states_count *count,
                               orr_diag *diag)
{
    nc_tables x = {0};
    orr_sat_state *state = calloc(p->n_sats, sizeof *state);
    orr_status s = state != NULL ? nc_alloc(p, q, &x, diag) : out_of_memory(diag);
    if (s == ORR_OK) {
        nc_fill(p, q, state, &x, count);
        s = nc_write(p, q, &x, diag);
    }
    nc_free(&x);
    free(state);
    return s;
}
