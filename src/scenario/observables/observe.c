// SPDX-License-Identifier: GPL-3.0-or-later
// Observations as RINEX.
#include "src/scenario/observables/observe.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ingest/rinex/rinex_obs.h"

static const char KINDS[] = "CLDS"; // code, phase, Doppler, C/N0 of each signal

// What is kept while a file is written.
typedef struct writer {
    const orr_channels *c;
    const orr_observe_plan *plan;
    size_t antenna, n_signals, stride;
    const orr_signal *signal;
    orr_observer *observer;
    orr_rinex_obs_header header;
    size_t column[64]; // of a signal's code observation among those of its system
    orr_sat *sat;
    double *value;
    uint8_t *lli, *ssi;
} writer;

static orr_status describe(writer *w, orr_diag *diag)
{
    orr_rinex_obs_header *h = &w->header;
    const orr_antenna *a = orr_channels_antenna(w->c, w->antenna);
    orr_antenna_state at;
    snprintf(h->program, sizeof h->program, "orrery " ORR_VERSION);
    snprintf(h->marker_name, sizeof h->marker_name, "%.60s", a->name);
    snprintf(h->marker_type, sizeof h->marker_type, "%s", a->motion != NULL ? "NON_GEODETIC" : "GEODETIC");
    snprintf(h->receiver_type, sizeof h->receiver_type, "ORRERY SIMULATED");
    snprintf(h->antenna_type, sizeof h->antenna_type, "%s", a->type[0] != '\0' ? a->type : "NONE");
    snprintf(h->signal_unit, sizeof h->signal_unit, "DBHZ");
    if (a->motion == NULL && orr_antenna_at(a, w->plan->from, &at) == ORR_ANSWER_OK) {
        h->has_position = true;
        h->position_m = at.r_m;
    }
    h->antenna_h_m = h->antenna_e_m = h->antenna_n_m = 0; // the position is that of the reference point
    h->system = 'M';
    h->scale = ORR_SCALE_GPS;
    h->first = w->plan->from;
    h->last = w->plan->to;
    h->interval_s = (double)w->plan->step_ns / 1e9;
    orr_status s = ORR_OK;
    for (size_t j = 0; s == ORR_OK && j < w->n_signals; j++) {
        if ((orr_channels_signals(w->c) >> j & 1) == 0) continue;
        w->column[j] = h->codes[strchr(ORR_SYSTEMS, w->signal[j].system) - ORR_SYSTEMS].n;
        for (const char *kind = KINDS; s == ORR_OK && *kind != '\0'; kind++) {
            const char code[4] = {*kind, w->signal[j].observation[0], w->signal[j].observation[1], '\0'};
            s = orr_rinex_obs_header_add_code(h, w->signal[j].system, code, diag);
        }
        if (w->column[j] + strlen(KINDS) > w->stride) w->stride = w->column[j] + strlen(KINDS);
    }
    if ((orr_channels_signals(w->c) & orr_signals_of('R')) != 0) {
        h->has_glonass_bias = true;
        static const char *const codes[4] = {"C1C", "C1P", "C2C", "C2P"};
        for (int k = 0; k < 4; k++) {
            snprintf(h->glonass_bias[k].code, sizeof h->glonass_bias[k].code, "%s", codes[k]);
            h->glonass_bias[k].bias_m = 0;
        }
        for (int slot = 1; slot <= 27; slot++) {
            int channel;
            if (orr_channels_frequency_channel(w->c, orr_sat_make('R', slot), &channel))
                h->glonass_channel[slot] = (int8_t)channel;
        }
    }
    return s;
}

static uint8_t strength(double cn0_dbhz) // RINEX 3.05, table 7
{
    return (uint8_t)fmin(fmax(floor(cn0_dbhz / 6), 1), 9);
}

static orr_status write_epoch(writer *w, orr_time t, orr_rinex_obs_writer *out, orr_observe_count *count,
                              orr_diag *diag)
{
    orr_observed o;
    const orr_status s = orr_observer_at(w->observer, t, &o, diag);
    if (s != ORR_OK) return s;
    orr_rinex_obs_epoch e = {.t = t,
                             .clock_offset_s = (double)NAN,
                             .stride = w->stride,
                             .sat = w->sat,
                             .value = w->value,
                             .lli = w->lli,
                             .ssi = w->ssi};
    for (size_t k = 0; k < o.n; k++) {
        const orr_observation *y = &o.item[k];
        if (e.n_sats == 0 || w->sat[e.n_sats - 1] != y->sat) {
            for (size_t j = 0; j < w->stride; j++) {
                w->value[e.n_sats * w->stride + j] = (double)NAN;
                w->lli[e.n_sats * w->stride + j] = w->ssi[e.n_sats * w->stride + j] = 0;
            }
            w->sat[e.n_sats++] = y->sat;
        }
        const size_t at = (e.n_sats - 1) * w->stride + w->column[y->signal];
        const double value[4] = {y->code_m, y->phase_cycles, y->doppler_hz, y->cn0_dbhz};
        memcpy(&w->value[at], value, sizeof value);
        w->ssi[at] = w->ssi[at + 1] = strength(y->cn0_dbhz);
        if (y->begins) w->lli[at + 1] = ORR_OBS_LLI_SLIP;
    }
    count->epochs++;
    count->observations += o.n;
    return orr_rinex_obs_write(out, &e, diag);
}

static orr_status write_all(writer *w, const char *path, orr_observe_count *count, orr_diag *diag)
{
    const orr_observe_plan *p = w->plan;
    orr_rinex_obs_writer *out;
    orr_status s = orr_rinex_obs_create(path, p->rinex, &w->header, &out, diag);
    if (s != ORR_OK) return s;
    const size_t total = (size_t)((p->to - p->from) / p->step_ns) + 1;
    for (size_t k = 0; s == ORR_OK && k < total; k++) {
        if (p->cancel != NULL && *p->cancel) s = orr_diag_set(diag, ORR_E_INTERRUPTED, "interrupted");
        if (s == ORR_OK) s = write_epoch(w, orr_time_add(p->from, (int64_t)k * p->step_ns), out, count, diag);
        if (p->progress != NULL) p->progress(p->user, k + 1, total);
    }
    if (s == ORR_OK) return orr_rinex_obs_commit(out, diag);
    orr_rinex_obs_abort(out);
    return s;
}

orr_status orr_observe_rinex(const orr_channels *c, size_t antenna, const orr_observe_plan *plan,
                             const char *path, orr_observe_count *count, orr_diag *diag)
{
    writer w = {.c = c, .plan = plan, .antenna = antenna};
    const size_t max = orr_channels_max(c);
    *count = (orr_observe_count){0};
    w.signal = orr_signals(&w.n_signals);
    orr_rinex_obs_header_init(&w.header);
    orr_status s = describe(&w, diag);
    if (s == ORR_OK) s = orr_observer_open(c, antenna, plan->noise, plan->seed, &w.observer, diag);
    if (s == ORR_OK) {
        w.sat = calloc(max, sizeof *w.sat);
        w.value = calloc(max * w.stride, sizeof *w.value);
        w.lli = calloc(max * w.stride, 1);
        w.ssi = calloc(max * w.stride, 1);
        if (w.sat == NULL || w.value == NULL || w.lli == NULL || w.ssi == NULL)
            s = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    if (s == ORR_OK) s = write_all(&w, path, count, diag);
    orr_observer_close(w.observer);
    free(w.sat);
    free(w.value);
    free(w.lli);
    free(w.ssi);
    orr_rinex_obs_header_free(&w.header);
    return s;
}
