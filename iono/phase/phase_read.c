// SPDX-License-Identifier: GPL-3.0-or-later
#include "iono/phase/phase_read.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/nan.h"
#include "ingest/rinex/rinex_obs.h"
#include "iono/phase/signals.h"

#define ENOUGH 0.9 // a better-liked signal may have so much fewer epochs than the fullest one

// How often each code of a satellite was seen, by kind (C, L), band and attribute.
typedef struct phase_tally {
    uint32_t seen[2][10][26];
} tally;

void phase_reading_free(phase_reading *r)
{
    if (r == NULL) return;
    for (size_t i = 0; i < ORR_SAT_SLOTS; i++) {
        free(r->tally[i]);
        free(r->choice[i]);
        free(r->raw[i].t);
        free(r->raw[i].value);
        free(r->raw[i].lost);
    }
    free(r->epoch);
    free(r);
}

static bool wanted(const orr_phase_options *o, orr_sat s)
{
    return orr_sat_system_index(s) >= 0 && (o->sats == NULL || orr_sat_set_has(o->sats, s));
}

static uint32_t *counter(tally *t, const char *code)
{
    if ((code[0] != 'C' && code[0] != 'L') || code[1] < '0' || code[1] > '9' || code[2] < 'A' ||
        code[2] > 'Z')
        return NULL;
    return &t->seen[code[0] == 'L'][code[1] - '0'][code[2] - 'A'];
}

// --- First pass ---

static orr_status count_epoch(phase_reading *r, const orr_rinex_obs_header *h, const orr_rinex_obs_epoch *e,
                              orr_diag *diag)
{
    for (size_t i = 0; i < e->n_sats; i++) {
        if (!wanted(r->o, e->sat[i])) continue;
        size_t slot = orr_sat_slot(e->sat[i]);
        if (r->tally[slot] == NULL && (r->tally[slot] = calloc(1, sizeof(tally))) == NULL)
            return orr_diag_set(diag, ORR_E_MEMORY, "no memory for observations");
        const orr_obs_codes *codes = &h->codes[orr_sat_system_index(e->sat[i])];
        for (size_t j = 0; j < codes->n; j++) {
            uint32_t *c = counter(r->tally[slot], codes->code[j]);
            if (c != NULL && !isnan(e->value[i * e->stride + j])) ++*c;
        }
    }
    return ORR_OK;
}

// The best-liked code of a band among those seen nearly as often as the fullest.
static uint32_t best_of(const tally *t, char system, char kind, char band, char like, char code[4])
{
    uint32_t most = 0, found = 0;
    int best = 1000;
    for (int a = 0; a < 26; a++) {
        uint32_t n = t->seen[kind == 'L'][band - '0'][a];
        if (orr_signal_rank(system, band, (char)('A' + a)) >= 0 && n > most) most = n;
    }
    for (int a = 0; a < 26; a++) {
        uint32_t n = t->seen[kind == 'L'][band - '0'][a];
        int rank = orr_signal_rank(system, band, (char)('A' + a));
        if (n == 0 || rank < 0 || n < ENOUGH * most) continue;
        if ('A' + a == like) rank = -1; // the code that belongs to the phase
        if (rank >= best) continue;
        best = rank;
        found = n;
        code[0] = kind;
        code[1] = band;
        code[2] = (char)('A' + a);
        code[3] = '\0';
    }
    return found;
}

static orr_status choose(phase_reading *r, size_t slot, char system, int channel, orr_diag *diag)
{
    const tally *t = r->tally[slot];
    phase_choice best = {0};
    uint32_t most = 0;
    const char *pairs = orr_signal_band_pairs(system);
    for (int round = 0; round < 2;
         round++) // how many epochs the fullest pair has; then the first that has nearly as many
        for (size_t p = 0; pairs[p] != '\0'; p += 2) {
            phase_choice c = {0};
            uint32_t n1 = best_of(t, system, 'L', pairs[p], 0, c.phase[0]),
                     n2 = best_of(t, system, 'L', pairs[p + 1], 0, c.phase[1]);
            uint32_t n = n1 < n2 ? n1 : n2;
            if (n == 0) continue;
            for (int i = 0; i < 2; i++)
                c.freq_hz[i] = orr_signal_frequency_hz(system, c.phase[i], channel, r->version);
            if (!(c.freq_hz[0] > c.freq_hz[1]) || !(c.freq_hz[1] > 0)) continue;
            if (round == 0) {
                if (n > most) most = n;
            } else if (n >= ENOUGH * most) {
                for (size_t i = 0; i < 2; i++)
                    best_of(t, system, 'C', pairs[p + i], c.phase[i][2], c.range[i]);
                best = c;
                pairs = ""; // found
                break;
            }
        }
    if (most == 0) return ORR_OK;
    r->choice[slot] = malloc(sizeof best);
    if (r->choice[slot] == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for observations");
    *r->choice[slot] = best;
    return ORR_OK;
}

// --- Second pass ---

static void find_columns(phase_reading *r, const orr_rinex_obs_header *h)
{
    for (size_t slot = 0; slot < ORR_SAT_SLOTS; slot++) {
        phase_choice *c = r->choice[slot];
        if (c == NULL) continue;
        char system = ORR_SYSTEMS[slot / 100];
        for (int i = 0; i < 2; i++) {
            c->at[i] = orr_obs_code_index(h, system, c->phase[i]);
            c->at[2 + i] = c->range[i][0] != '\0' ? orr_obs_code_index(h, system, c->range[i]) : -1;
        }
    }
}

static bool grow(phase_raw *w)
{
    return ORR_ARRAY_GROW(w->t, w->n) && ORR_ARRAY_GROW(w->value, w->n) && ORR_ARRAY_GROW(w->lost, w->n);
}

static orr_status take_epoch(phase_reading *r, const orr_rinex_obs_epoch *e, bool skip, orr_diag *diag)
{
    if (e->flag == ORR_OBS_POWER_FAILURE)
        for (size_t s = 0; s < ORR_SAT_SLOTS; s++) r->raw[s].lost_next = true;
    if (!skip) {
        if (!ORR_ARRAY_GROW(r->epoch, r->n_epochs))
            return orr_diag_set(diag, ORR_E_MEMORY, "no memory for epochs");
        r->epoch[r->n_epochs++] = e->t;
    }
    for (size_t i = 0; i < e->n_sats; i++) {
        if (!wanted(r->o, e->sat[i])) continue;
        size_t slot = orr_sat_slot(e->sat[i]);
        const phase_choice *c = r->choice[slot];
        if (c == NULL) continue;
        phase_raw *w = &r->raw[slot];
        const double *v = e->value + i * e->stride;
        if (e->flag == ORR_OBS_CYCLE_SLIP) {
            w->lost_next = true;
            continue;
        }
        for (int k = 0; k < 2; k++)
            if (c->at[k] >= 0 && (e->lli[i * e->stride + (size_t)c->at[k]] & ORR_OBS_LLI_SLIP))
                w->lost_next = true;
        if (skip || c->at[0] < 0 || c->at[1] < 0 || isnan(v[c->at[0]]) || isnan(v[c->at[1]])) continue;
        if (w->n > 0 && e->t <= w->t[w->n - 1]) continue; // a second record of one epoch
        if (r->n_samples++ >= r->o->max_samples)
            return orr_diag_set(diag, ORR_E_LIMIT,
                                "more than %llu samples; take a longer step or fewer satellites",
                                (unsigned long long)r->o->max_samples);
        if (!grow(w)) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for observations");
        w->t[w->n] = e->t;
        for (int k = 0; k < 4; k++) w->value[w->n][k] = c->at[k] >= 0 ? v[c->at[k]] : ORR_NAN;
        w->lost[w->n] = w->lost_next;
        w->lost_next = false;
        w->n++;
    }
    return ORR_OK;
}

// Opens the observations again for each pass.
static orr_status open_observations(const phase_reading *r, const char *path, orr_warnings *warnings,
                                    orr_rinex_obs **out, orr_diag *diag)
{
    return orr_rinex_obs_open_memory(path, r->data, r->n_data, NULL, warnings, out, diag);
}

static orr_status pass(phase_reading *r, const char *path, bool counting, orr_warnings *warnings,
                       orr_diag *diag)
{
    orr_rinex_obs *file;
    orr_status s = open_observations(r, path, warnings, &file, diag);
    if (s != ORR_OK) return s;
    const orr_rinex_obs_header *h = orr_rinex_obs_header_of(file);
    const orr_phase_options *o = r->o;
    r->version = h->version;
    if (counting) {
        snprintf(r->marker, sizeof r->marker, "%s", h->marker_name);
        memcpy(r->channel, h->glonass_channel, sizeof r->channel);
        if (o->site_m != NULL)
            s = orr_iono_site_at(*o->site_m, &r->site, diag);
        else if (!h->has_position || orr_vec3_norm(h->position_m) < 6.2e6)
            s = orr_diag_at(diag, ORR_E_NODATA, path, 0, 0,
                            "the header has no position of the station (APPROX POSITION XYZ); give one");
        else
            s = orr_iono_site_at(h->position_m, &r->site, diag);
    } else
        find_columns(r, h);
    orr_time taken = ORR_TIME_NONE;
    while (s == ORR_OK) {
        const orr_rinex_obs_epoch *e;
        s = orr_rinex_obs_next(file, &e, diag);
        if (s != ORR_OK || e == NULL) break;
        if (e->header_changed && !counting) find_columns(r, h);
        if (e->flag == ORR_OBS_START_MOVING || e->flag == ORR_OBS_NEW_SITE) {
            s = orr_diag_at(diag, ORR_E_UNSUPPORTED, path, e->line, 0,
                            "the antenna moves from here on; arcs need a station that stands still");
            break;
        }
        if (e->flag > ORR_OBS_POWER_FAILURE && e->flag != ORR_OBS_CYCLE_SLIP) continue;
        if (e->t == ORR_TIME_NONE || (o->from != ORR_TIME_NONE && e->t < o->from) ||
            (o->to != ORR_TIME_NONE && e->t > o->to))
            continue;
        if (counting) {
            s = count_epoch(r, h, e, diag);
            continue;
        }
        bool skip = e->flag == ORR_OBS_CYCLE_SLIP || (taken != ORR_TIME_NONE && o->step_s > 0 &&
                                                      orr_time_diff_s(e->t, taken) < o->step_s - 0.01);
        if (!skip) taken = e->t;
        s = take_epoch(r, e, skip, diag);
    }
    if (counting) memcpy(r->channel, h->glonass_channel, sizeof r->channel); // events may have named more
    orr_rinex_obs_close(file);
    return s;
}

// The frequency channel of a GLONASS slot, from the header or else from a navigation file; told where neither has it.
static int channel_of(const phase_reading *r, size_t number, const char *name, orr_warnings *warnings)
{
    int channel = r->channel[number];
    if (channel == ORR_OBS_NO_CHANNEL && r->o->glonass_channel != NULL)
        channel = r->o->glonass_channel[number];
    if (channel == ORR_OBS_NO_CHANNEL)
        orr_warnings_add(
            warnings, name, 0, 0,
            "R%02zu is left out: neither the header nor a navigation file tells its frequency channel",
            number);
    return channel;
}

orr_status phase_read(const char *name, const void *data, size_t n, const orr_phase_options *o,
                      phase_reading **out, orr_warnings *warnings, orr_diag *diag)
{
    phase_reading *r = *out = calloc(1, sizeof *r);
    if (r == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory to read observations");
    r->o = o;
    r->data = data;
    r->n_data = n;
    orr_status s = pass(r, name, true, warnings, diag);
    for (size_t slot = 0; s == ORR_OK && slot < ORR_SAT_SLOTS; slot++) {
        if (r->tally[slot] == NULL) continue;
        const char system = ORR_SYSTEMS[slot / 100];
        const int channel = system == 'R' ? channel_of(r, slot % 100, name, warnings) : 0;
        if (channel != ORR_OBS_NO_CHANNEL) s = choose(r, slot, system, channel, diag);
    }
    if (s == ORR_OK) s = pass(r, name, false, NULL, diag); // warned of once
    if (s == ORR_OK) return ORR_OK;
    phase_reading_free(r);
    *out = NULL;
    return s;
}
