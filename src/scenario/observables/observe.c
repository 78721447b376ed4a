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

// What a recorded station's header has of itself.
static void describe_station(const orr_replay *r, orr_rinex_obs_header *h)
{
    snprintf(h->marker_name, sizeof h->marker_name, "%s", r->marker);
    snprintf(h->receiver_type, sizeof h->receiver_type, "%s", r->receiver_type);
    snprintf(h->antenna_type, sizeof h->antenna_type, "%s", r->antenna_type);
    h->antenna_h_m = r->antenna_h_m;
    h->antenna_e_m = r->antenna_e_m;
    h->antenna_n_m = r->antenna_n_m;
}

// RINEX band and attribute of a signal: as it was recorded, or with all its components.
static const char *name_of(const writer *w, size_t signal)
{
    const orr_replay *r = w->plan->replay;
    if (r == NULL || r->code[signal][0] == '\0') return w->signal[signal].observation;
    const bool old = w->signal[signal].system == 'C' && r->code[signal][0] == '1' &&
                     w->signal[signal].observation[0] == '2'; // B1I by its name of 3.02
    return old ? w->signal[signal].observation : r->code[signal];
}

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
    h->antenna_h_m = h->antenna_e_m = h->antenna_n_m = 0;
    if (w->plan->replay != NULL) describe_station(w->plan->replay, h);
    if (a->motion == NULL && orr_antenna_at(a, w->plan->from, &at) == ORR_ANSWER_OK) {
        h->has_position = true;
        // Of the marker where antenna heights are told, else of the reference point.
        h->position_m = orr_vec3_sub(
            at.r_m, orr_mat3_apply_t(&at.enu, (orr_vec3){h->antenna_e_m, h->antenna_n_m, h->antenna_h_m}));
    }
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
            const char *own = name_of(w, j), code[4] = {*kind, own[0], own[1], '\0'};
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

// Leaves of an observation what was recorded at an epoch, with the record's own indicators.
static void keep_recorded(const writer *w, size_t epoch, const orr_observation *y, size_t at)
{
    const orr_replay_track *x = orr_replay_track_of(w->plan->replay, y->sat, y->signal);
    const orr_replay_node *n = x != NULL ? orr_replay_node_of(x, epoch) : NULL;
    const bool has[4] = {n != NULL && !isnan(n->code), n != NULL && !isnan(n->carrier),
                         n != NULL && !isnan(n->doppler_hz), n != NULL && !isnan(n->cn0_dbhz)};
    for (size_t k = 0; k < 4; k++)
        if (!has[k]) w->value[at + k] = (double)NAN;
    for (size_t k = 0; k < 2; k++) {
        w->lli[at + k] = has[k] ? n->lli[k] : 0;
        w->ssi[at + k] = has[k] ? n->ssi[k] : 0;
    }
}

static orr_status write_epoch(writer *w, orr_time t, size_t epoch, orr_rinex_obs_writer *out,
                              orr_observe_count *count, orr_diag *diag)
{
    orr_observed o;
    const orr_status s = orr_observer_at(w->observer, t, &o, diag);
    if (s != ORR_OK) return s;
    const orr_replay *recorded = w->plan->recorded ? w->plan->replay : NULL;
    orr_rinex_obs_epoch e = {.t = t,
                             .flag = recorded != NULL ? recorded->flag[epoch] : ORR_OBS_OK,
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
        if (recorded != NULL) keep_recorded(w, epoch, y, at);
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
    const orr_replay *recorded = p->recorded ? p->replay : NULL;
    const size_t total = recorded != NULL ? recorded->n_epochs : (size_t)((p->to - p->from) / p->step_ns) + 1;
    for (size_t k = 0; s == ORR_OK && k < total; k++) {
        const orr_time t =
            recorded != NULL ? recorded->tag[k] : orr_time_add(p->from, (int64_t)k * p->step_ns);
        if (p->cancel != NULL && *p->cancel) s = orr_diag_set(diag, ORR_E_INTERRUPTED, "interrupted");
        if (t < p->from || t > p->to) continue;
        if (s == ORR_OK) s = write_epoch(w, t, k, out, count, diag);
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
