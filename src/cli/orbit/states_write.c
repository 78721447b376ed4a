// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/orbit/states_write.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/astro.h"
#include "core/fixed.h"
#include "core/outfile.h"
#include "core/path.h"
#include "ingest/sp3/sp3.h"

enum { POS_DECIMALS = 6, VEL_DECIMALS = 9, CLOCK_DECIMALS = 15, ROW = 1024 };

// The rotation to the axes of the GCRS, by the Earth rotation that a product holds.
static void to_inertial(const orr_ephemeris *e, orr_time t, orr_sat_state *state, size_t n)
{
    orr_mat3 R, dR;
    const orr_eop eop = orr_eop_at(orr_ephemeris_eop(e), t, NULL, NULL);
    orr_astro_gcrs_to_itrs(t, &eop, NULL, &R, &dR);
    for (size_t i = 0; i < n; i++) {
        const orr_vec3 r = orr_mat3_apply_t(&R, state[i].pos_m);
        state[i].vel_mps = orr_mat3_apply_t(&R, orr_vec3_sub(state[i].vel_mps, orr_mat3_apply(&dR, r)));
        state[i].pos_m = r;
    }
}

size_t states_at(const orr_products *p, const states_request *q, orr_time t, orr_sat_state *out,
                 states_count *count)
{
    const orr_ephemeris *e = orr_products_at(p, t);
    size_t n = 0, asked = 0;
    for (size_t i = 0; i < p->n_sats; i++) {
        if (q->sats != NULL && !orr_sat_set_has(q->sats, p->sat[i])) continue;
        asked++;
        if (e != NULL && orr_ephemeris_eval(e, p->sat[i], t, &out[n]) == ORR_OK) n++;
    }
    count->written += n;
    count->missing += asked - n;
    if (q->inertial && n > 0) to_inertial(e, t, out, n);
    return n;
}

static char *put_text(char *p, const char *text)
{
    size_t n = strlen(text);
    memcpy(p, text, n);
    return p + n;
}

static char *put_vector(char *p, orr_vec3 v, int decimals, const char *const key[3])
{
    const double x[3] = {v.x, v.y, v.z};
    for (int i = 0; i < 3; i++) {
        p = put_text(p, key[i]);
        p += orr_fixed(x[i], decimals, p);
    }
    return p;
}

// A standard deviation that is not known is an empty column.
static char *put_sigma(char *p, const char *key, float sigma, int decimals, bool json)
{
    p = put_text(p, key);
    return isfinite(sigma) ? p + orr_fixed((double)sigma, decimals, p) : put_text(p, json ? "null" : "");
}

// One row, ending with a newline in CSV and without one in JSON.
static size_t make_row(const orr_sat_state *s, const char *t_gps, bool json, char row[ROW])
{
    static const char *const comma[3] = {",", ",", ","};
    static const char *const pos_key[3] = {",\"x_m\":", ",\"y_m\":", ",\"z_m\":"};
    static const char *const vel_key[3] = {",\"vx_mps\":", ",\"vy_mps\":", ",\"vz_mps\":"};
    static const char *const axis_key[3] = {
        ",\"sigma_radial_m\":", ",\"sigma_along_m\":", ",\"sigma_cross_m\":"};
    char name[ORR_SAT_TEXT], *p = row;
    orr_sat_text(s->sat, name);
    p = put_text(p, json ? "{\"t_gps\":\"" : "");
    p = put_text(p, t_gps);
    p = put_text(p, json ? "\",\"sat\":\"" : ",");
    p = put_text(p, name);
    p = put_text(p, json ? "\"" : "");
    p = put_vector(p, s->pos_m, POS_DECIMALS, json ? pos_key : comma);
    p = put_vector(p, s->vel_mps, VEL_DECIMALS, json ? vel_key : comma);
    p = put_text(p, json ? ",\"clock_s\":" : ",");
    if ((s->flags & ORR_EPH_CLOCK_VALID) != 0)
        p += orr_fixed(s->clock_s, CLOCK_DECIMALS, p);
    else
        p = put_text(p, json ? "null" : "");
    p = put_text(p, json ? ",\"flags\":" : ",");
    p += orr_fixed((double)s->flags, 0, p);
    p = put_sigma(p, json ? ",\"sigma_m\":" : ",", s->sigma_m, POS_DECIMALS, json);
    p = put_sigma(p, json ? ",\"clock_sigma_s\":" : ",", s->clock_sigma_s, CLOCK_DECIMALS, json);
    for (int i = 0; i < 3; i++)
        p = put_sigma(p, json ? axis_key[i] : ",", s->sigma_rtn_m[i], POS_DECIMALS, json);
    p = put_sigma(p, json ? ",\"sigma_mps\":" : ",", s->sigma_mps, VEL_DECIMALS, json);
    p = put_text(p, json ? "}" : "\n");
    return (size_t)(p - row);
}

static orr_status write_rows(const orr_products *p, const states_request *q, bool json, FILE *f,
                             states_count *count, orr_diag *diag)
{
    size_t rows = 0;
    orr_sat_state *state = calloc(p->n_sats, sizeof *state);
    if (state == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the states of %zu satellites", p->n_sats);
    fputs(json ? "["
               : "t_gps,sat,x_m,y_m,z_m,vx_mps,vy_mps,vz_mps,clock_s,flags,sigma_m,clock_sigma_s,"
                 "sigma_radial_m,sigma_along_m,sigma_cross_m,sigma_mps\n",
          f);
    orr_status s = ORR_OK;
    for (orr_time t = q->from; s == ORR_OK; t += q->step_ns) {
        char t_gps[ORR_TIME_TEXT], row[ROW];
        orr_time_text(t, t_gps);
        size_t n = states_at(p, q, t, state, count);
        for (size_t i = 0; i < n; i++) {
            if (json) fputs(rows++ > 0 ? ",\n" : "\n", f);
            fwrite(row, 1, make_row(&state[i], t_gps, json, row), f);
        }
        if (ferror(f)) s = orr_diag_set(diag, ORR_E_IO, "could not write: %s", strerror(errno));
        if (q->to - t < q->step_ns) break;
    }
    fputs(json ? "\n]\n" : "", f);
    free(state);
    return s;
}

orr_status states_write_table(const orr_products *p, const states_request *q, bool json, states_count *count,
                              orr_diag *diag)
{
    orr_outfile out;
    orr_status s = orr_outfile_open(q->path, &out, diag);
    if (s != ORR_OK) return s;
    s = write_rows(p, q, json, out.stream, count, diag);
    return orr_outfile_end(&out, s, diag);
}

static uint8_t sp3_flags(uint32_t f)
{
    return (uint8_t)(((f & ORR_EPH_CLOCK_EVENT) != 0 ? ORR_SP3_CLOCK_EVENT : 0) |
                     ((f & ORR_EPH_MANOEUVRE) != 0 ? ORR_SP3_MANOEUVRE : 0) |
                     ((f & ORR_EPH_PREDICTED) != 0 ? ORR_SP3_ORBIT_PREDICTED | ORR_SP3_CLOCK_PREDICTED : 0));
}

static void put_record(const orr_sat_state *s, orr_sp3_record *r)
{
    r->pos_m[0] = s->pos_m.x, r->pos_m[1] = s->pos_m.y, r->pos_m[2] = s->pos_m.z;
    r->vel_mps[0] = s->vel_mps.x, r->vel_mps[1] = s->vel_mps.y, r->vel_mps[2] = s->vel_mps.z;
    for (int k = 0; k < 3; k++) r->pos_sdev_m[k] = s->sigma_m / sqrtf(3.0f);
    if ((s->flags & ORR_EPH_CLOCK_VALID) != 0) {
        r->clock_s = s->clock_s;
        r->clock_rate_sps = s->clock_rate_sps;
        if (isfinite(s->clock_sigma_s)) r->clock_sdev_s = fmaxf(s->clock_sigma_s, 1e-12f); // SP3's least
    }
    r->flags = sp3_flags(s->flags);
}

static orr_status sp3_header(const orr_products *p, const states_request *q, orr_sp3 *sp3, orr_diag *diag)
{
    char text[3][81];
    sp3->version = 'd';
    sp3->has_velocity = true;
    strcpy(sp3->data_used, "ORBIT");
    snprintf(sp3->coordinates, sizeof sp3->coordinates, "%.5s", orr_ephemeris_frame(p->item[0]));
    strcpy(sp3->orbit_type, "FIT");
    strcpy(sp3->agency, "ORRY");
    strcpy(sp3->file_type, "M");
    sp3->scale = ORR_SCALE_GPS;
    sp3->interval_s = (double)q->step_ns * 1e-9;
    sp3->pos_vel_base = 1.25;
    sp3->clock_base = 1.025;
    snprintf(text[0], sizeof text[0], "STATES OF AN ORBIT PRODUCT, NOT AN ANALYSIS CENTRE'S ORBIT");
    snprintf(text[1], sizeof text[1], "MADE BY ORRERY %s FROM %.40s", ORR_VERSION, orr_base_name(q->product));
    snprintf(text[2], sizeof text[2], "CLOCKS WITHOUT PERIODIC RELATIVITY");
    sp3->comment = calloc(3, sizeof *sp3->comment);
    for (size_t i = 0; i < 3 && sp3->comment != NULL; i++) {
        sp3->comment[i] = strdup(text[i]);
        if (sp3->comment[i] == NULL) break;
        sp3->n_comments++;
    }
    return sp3->n_comments == 3
               ? ORR_OK
               : orr_diag_set(diag, ORR_E_MEMORY, "no memory for the comments of an SP3 file");
}

orr_status states_write_sp3(const orr_products *p, const states_request *q, states_count *count,
                            orr_diag *diag)
{
    const orr_sat *list = p->sat;
    const size_t n_all = p->n_sats;
    size_t n_sats = 0;
    int64_t n_epochs = (q->to - q->from) / q->step_ns + 1;
    for (size_t i = 0; i < n_all; i++) n_sats += q->sats == NULL || orr_sat_set_has(q->sats, list[i]);
    if (n_epochs > (int64_t)orr_sp3_default_limits().max_epochs)
        return orr_diag_set(diag, ORR_E_LIMIT, "%lld epochs are too many for an SP3 file",
                            (long long)n_epochs);
    orr_sp3 sp3 = {0};
    orr_status s = orr_sp3_alloc(n_sats, (size_t)n_epochs, &sp3, diag);
    orr_sat_state *state = calloc(n_all, sizeof *state);
    if (s == ORR_OK && state == NULL)
        s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for the states of %zu satellites", n_all);
    if (s == ORR_OK) s = sp3_header(p, q, &sp3, diag);
    for (size_t i = 0, k = 0; i < n_all && s == ORR_OK; i++)
        if (q->sats == NULL || orr_sat_set_has(q->sats, list[i])) sp3.sat[k++] = list[i];
    for (size_t i = 0; i < (size_t)n_epochs && s == ORR_OK; i++) {
        orr_time t = q->from + (int64_t)i * q->step_ns;
        size_t n = states_at(p, q, t, state, count), k = 0;
        sp3.epoch[i] = t;
        for (size_t j = 0; j < n; j++) {
            while (sp3.sat[k] != state[j].sat) k++; // both ascend
            put_record(&state[j], &sp3.record[i * n_sats + k]);
        }
    }
    if (s == ORR_OK) s = orr_sp3_write(&sp3, q->path, diag);
    free(state);
    orr_sp3_free(&sp3);
    return s;
}
