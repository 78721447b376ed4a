// SPDX-License-Identifier: GPL-3.0-or-later
// The clocks of a product's file.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "orbit/ephemeris/ephemeris_load_private.h"

static orr_status read_clocks(const eph_file *f, orr_ephemeris *e)
{
    int64_t *t = NULL;
    double *bias = NULL;
    uint16_t *flags = NULL;
    size_t n = e->n_clocks;
    if (n == 0) return ORR_OK;
    orr_status s = eph_read_column(f, "clock_time", ORR_NC_INT64, n, (void **)&t);
    if (s == ORR_OK) s = eph_read_column(f, "clock_bias", ORR_NC_DOUBLE, n, (void **)&bias);
    if (s == ORR_OK) s = eph_read_column(f, "clock_flags", ORR_NC_UINT16, n, (void **)&flags);
    for (size_t i = 0; i < n && s == ORR_OK; i++) {
        e->clock[i] = (orr_clock_node){.t = t[i], .clock_s = bias[i], .flags = flags[i] & EPH_CLOCK_FLAGS};
        if (t[i] < -EPH_TIME_LIMIT || t[i] > EPH_TIME_LIMIT || !(fabs(bias[i]) < EPH_MAX_CLOCK_S))
            s = eph_wrong(f, "a clock node is impossible");
    }
    // Where two files meet, both have a clock for the instant: left and right of a jump.
    for (size_t i = 0; i < e->n_sats && s == ORR_OK; i++)
        for (size_t k = 1; k < e->sat[i].n_clocks && s == ORR_OK; k++)
            if (e->sat[i].clock[k].t < e->sat[i].clock[k - 1].t)
                s = eph_wrong(f, "clock nodes do not ascend in time");
    free(t);
    free(bias);
    free(flags);
    return s;
}

// What a product of an earlier program does not have: of its clocks no sigma is known.
static orr_status read_clock_noise(const eph_file *f, orr_ephemeris *e)
{
    for (size_t i = 0; i < e->n_sats; i++)
        e->sat[i].clock_noise = (orr_clock_noise){(double)NAN, (double)NAN, (double)NAN};
    if (e->n_clocks == 0 || !orr_nc_has_var(&f->r, "clock_white_noise")) return ORR_OK;
    double *white = NULL, *walk = NULL, *frequency = NULL;
    float *sigma = NULL;
    orr_status s = eph_read_column(f, "clock_white_noise", ORR_NC_DOUBLE, e->n_sats, (void **)&white);
    if (s == ORR_OK) s = eph_read_column(f, "clock_walk_noise", ORR_NC_DOUBLE, e->n_sats, (void **)&walk);
    if (s == ORR_OK)
        s = eph_read_column(f, "clock_frequency_noise", ORR_NC_DOUBLE, e->n_sats, (void **)&frequency);
    if (s == ORR_OK) s = eph_read_column(f, "clock_sigma", ORR_NC_FLOAT, e->n_clocks, (void **)&sigma);
    for (size_t i = 0; i < e->n_sats && s == ORR_OK; i++) {
        e->sat[i].clock_noise = (orr_clock_noise){white[i], walk[i], frequency[i]};
        const double *const of[3] = {&white[i], &walk[i], &frequency[i]};
        for (int k = 0; k < 3; k++)
            if (*of[k] < 0 || *of[k] > EPH_MAX_CLOCK_S * EPH_MAX_CLOCK_S)
                s = eph_wrong(f, "the noise of a clock is none");
    }
    for (size_t i = 0; i < e->n_clocks && s == ORR_OK; i++) {
        e->clock[i].sigma_s = sigma[i];
        if (!(sigma[i] >= 0 && sigma[i] <= (float)EPH_MAX_CLOCK_S))
            s = eph_wrong(f, "the sigma of a clock is none");
    }
    free(white);
    free(walk);
    free(frequency);
    free(sigma);
    return s;
}

// "G05", or letters of systems.
static bool read_event_of(const char *name, orr_clock_event *v)
{
    char who[ORR_N_SYSTEMS + 2] = "";
    memcpy(who, name, ORR_N_SYSTEMS + 1);
    v->sat = v->kind != ORR_CLOCK_EVENT_REFERENCE ? orr_sat_parse3(who, 0) : ORR_SAT_NONE;
    if (v->kind != ORR_CLOCK_EVENT_REFERENCE) return v->sat != ORR_SAT_NONE;
    const size_t n = strlen(who);
    memcpy(v->systems, who, n <= ORR_N_SYSTEMS ? n : 0);
    return n > 0 && n <= ORR_N_SYSTEMS && strspn(who, ORR_SYSTEMS) == n;
}

static orr_status read_clock_events(const eph_file *f, orr_clock_events *events)
{
    size_t n = 0, shape[2] = {0, ORR_N_SYSTEMS + 1};
    if (!orr_nc_has_var(&f->r, "clock_event_kind")) return ORR_OK;
    uint8_t *kind = NULL;
    int64_t *t0 = NULL, *t1 = NULL;
    double *value = NULL;
    char *names = NULL;
    orr_status s = orr_nc_get_dim(&f->r, "clock_event", f->max_bytes / 8, &n, f->diag);
    shape[0] = n;
    if (s == ORR_OK) s = eph_read_column(f, "clock_event_kind", ORR_NC_UINT8, n, (void **)&kind);
    if (s == ORR_OK) s = eph_read_column(f, "clock_event_start", ORR_NC_INT64, n, (void **)&t0);
    if (s == ORR_OK) s = eph_read_column(f, "clock_event_end", ORR_NC_INT64, n, (void **)&t1);
    if (s == ORR_OK) s = eph_read_column(f, "clock_event_value", ORR_NC_DOUBLE, n, (void **)&value);
    if (s == ORR_OK)
        s = orr_nc_alloc_var(&f->r, "clock_event_of", ORR_NC_CHAR, 2, shape, (void **)&names, f->diag);
    if (s == ORR_OK && (events->item = calloc(n + 1, sizeof *events->item)) == NULL)
        s = orr_diag_set(f->diag, ORR_E_MEMORY, "no memory for the events of clocks");
    for (size_t i = 0; i < n && s == ORR_OK; i++) {
        orr_clock_event *v = &events->item[i];
        *v = (orr_clock_event){
            .kind = (orr_clock_event_kind)kind[i], .t0 = t0[i], .t1 = t1[i], .value_s = value[i]};
        if (kind[i] < ORR_CLOCK_EVENT_WRONG || kind[i] > ORR_CLOCK_EVENT_REFERENCE ||
            t0[i] < -EPH_TIME_LIMIT || t1[i] > EPH_TIME_LIMIT || t1[i] < t0[i] ||
            !(fabs(value[i]) < EPH_MAX_CLOCK_S) || !read_event_of(&names[i * (ORR_N_SYSTEMS + 1)], v))
            s = eph_wrong(f, "an event of a clock is impossible");
    }
    if (s == ORR_OK) events->n = n;
    free(kind);
    free(t0);
    free(t1);
    free(value);
    free(names);
    return s;
}

orr_status eph_load_clocks(const eph_file *f, orr_ephemeris *e)
{
    orr_status s = read_clocks(f, e);
    if (s == ORR_OK) s = read_clock_noise(f, e);
    return s == ORR_OK ? read_clock_events(f, &e->clock_events) : s;
}
