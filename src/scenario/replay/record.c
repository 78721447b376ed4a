// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/replay/record.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/nan.h"
#include "core/robust.h"
#include "ingest/rinex/rinex_obs.h"
#include "iono/phase/signals.h"

// Attributes under which files have a signal, besides its own.
static const char *attributes_of(const orr_signal *s)
{
    const char band = s->observation[0], own = s->observation[1];
    if (own == 'W') return "WPYMND"; // of P(Y): how it was tracked
    if (s->system == 'R') return own == 'C' ? "CP" : "XQI";
    if (s->system == 'I') return "ABCX";
    if (s->system == 'E' && (band == '1' || band == '6')) return "XCBAZ";
    if (s->system == 'C' && band == '7') return "DPZ"; // I, Q and X are B2I's
    if (s->system == 'C' && own == 'X') return "XPD";
    if (own == 'I') return "IQX";
    if (own != 'X') return s->observation + 1;
    return band == '5' || s->system == 'E' ? "XQI" : "XLS";
}

int orr_record_signal(char system, const char *code, double version)
{
    size_t n;
    const orr_signal *all = orr_signals(&n);
    char band = code[0];
    const char attribute = band != '\0' ? code[1] : '\0';
    if (attribute == '\0') return -1;
    if (system == 'C' && band == '1' &&
        (attribute == 'I' || attribute == 'Q' || (attribute == 'X' && version < 3.025)))
        band = '2';
    for (size_t k = 0; k < n; k++)
        if (all[k].system == system && all[k].observation[0] == band &&
            strchr(attributes_of(&all[k]), attribute) != NULL)
            return (int)k;
    return -1;
}

typedef struct reading {
    const char *path;
    const orr_source_orbit *orbits;
    orr_span span;
    uint64_t wanted;
    const orr_leap_table *leap;
    orr_replay *r;
    uint32_t seen[ORR_N_SYSTEMS][10][26]; // codes and carriers by band and attribute
    int32_t sat[ORR_SAT_SLOTS];           // of a satellite; -1: none yet
    int32_t (*track)[ORR_MAX_SIGNALS];    // [n_sats]
    bool lost[ORR_SAT_SLOTS];             // a slip was told beside the observations
    bool unknown[ORR_SAT_SLOTS];          // the orbits lack the satellite
    size_t n_unknown;
    size_t outside;
    orr_time first, last; // epochs of the file, whatever the span
} reading;

static uint32_t *counter(reading *w, char system, const char *code)
{
    const char *at = strchr(ORR_SYSTEMS, system);
    if (at == NULL || code[0] < '0' || code[0] > '9' || code[1] < 'A' || code[1] > 'Z') return NULL;
    return &w->seen[at - ORR_SYSTEMS][code[0] - '0'][code[1] - 'A'];
}

static bool observes(int flag) { return flag == ORR_OBS_OK || flag == ORR_OBS_POWER_FAILURE; }

// Whether the orbits have a satellite; those that they lack are counted.
static bool has_orbit(reading *w, orr_sat sat)
{
    bool *unknown = &w->unknown[orr_sat_slot(sat)];
    if (orr_source_orbit_has(w->orbits, sat)) return true;
    w->n_unknown += !*unknown;
    *unknown = true;
    return false;
}

static void count_epoch(reading *w, const orr_rinex_obs_header *h, const orr_rinex_obs_epoch *e)
{
    if (!observes(e->flag)) return;
    if (w->first == ORR_TIME_NONE) w->first = e->t;
    w->last = e->t;
    for (size_t i = 0; i < e->n_sats; i++) {
        if (!has_orbit(w, e->sat[i])) continue;
        const orr_obs_codes *codes = &h->codes[orr_sat_system_index(e->sat[i])];
        for (size_t j = 0; j < codes->n; j++) {
            if (codes->code[j][0] != 'C' && codes->code[j][0] != 'L') continue;
            uint32_t *c = counter(w, orr_sat_system(e->sat[i]), codes->code[j] + 1);
            if (c != NULL && !isnan(e->value[i * e->stride + j])) ++*c;
        }
    }
}

// Of each signal the code that was recorded most often; a better-liked one may have a tenth less.
static void choose_codes(reading *w, orr_warnings *warnings)
{
    size_t n;
    const orr_signal *all = orr_signals(&n);
    char left[400] = "";
    for (size_t k = 0; k < n; k++) {
        const char *list = attributes_of(&all[k]);
        uint32_t most = 0;
        for (int round = 0; round < 2; round++)
            for (const char *a = list; *a != '\0'; a++) {
                char code[3] = {all[k].observation[0], *a, '\0'};
                const uint32_t *c = counter(w, all[k].system, code);
                if (round == 0 && *c > most) most = *c;
                if (round == 1 && *c > 0 && *c >= 0.9 * most && w->r->code[k][0] == '\0')
                    memcpy(w->r->code[k], code, sizeof code);
            }
        if (all[k].system == 'C' && all[k].observation[0] == '2' && most == 0)
            for (const char *a = "IQX"; *a != '\0'; a++) { // 3.02
                char code[3] = {'1', *a, '\0'};
                if (*counter(w, 'C', code) > 0 && orr_record_signal('C', code, w->r->version) == (int)k &&
                    w->r->code[k][0] == '\0')
                    memcpy(w->r->code[k], code, sizeof code);
            }
        if ((w->wanted >> k & 1) == 0) w->r->code[k][0] = '\0';
    }
    for (size_t s = 0; s < ORR_N_SYSTEMS; s++)
        for (int b = 0; b < 10; b++)
            for (int a = 0; a < 26; a++) {
                const char code[3] = {(char)('0' + b), (char)('A' + a), '\0'};
                if (w->seen[s][b][a] == 0) continue;
                const int k = orr_record_signal(ORR_SYSTEMS[s], code, w->r->version);
                if (k >= 0 && strcmp(w->r->code[k], code) == 0) continue;
                const size_t used = strlen(left);
                snprintf(left + used, sizeof left - used, "%s%c%s", used > 0 ? ", " : "", ORR_SYSTEMS[s],
                         code);
            }
    if (left[0] != '\0')
        orr_warnings_add(warnings, w->path, 0, 0,
                         "these observations are not replayed, as another of the same signal is or no signal "
                         "of a scenario is theirs: %s",
                         left);
}

static void keep_header(reading *w, const orr_rinex_obs_header *h)
{
    orr_replay *r = w->r;
    snprintf(r->marker, sizeof r->marker, "%s", h->marker_name);
    snprintf(r->receiver_type, sizeof r->receiver_type, "%s", h->receiver_type);
    snprintf(r->antenna_type, sizeof r->antenna_type, "%s", h->antenna_type);
    r->antenna_h_m = isnan(h->antenna_h_m) ? 0 : h->antenna_h_m;
    r->antenna_e_m = isnan(h->antenna_e_m) ? 0 : h->antenna_e_m;
    r->antenna_n_m = isnan(h->antenna_n_m) ? 0 : h->antenna_n_m;
    r->version = h->version;
    memcpy(r->glonass_channel, h->glonass_channel, sizeof r->glonass_channel);
}

// Columns of a signal in the header in force; -1: none.
typedef struct columns {
    int at[4]; // code, carrier, Doppler, C/N0
} columns;

static void find_columns(const reading *w, const orr_rinex_obs_header *h, columns *out)
{
    size_t n;
    const orr_signal *all = orr_signals(&n);
    for (size_t k = 0; k < n; k++)
        for (int kind = 0; kind < 4; kind++) {
            const char code[4] = {"CLDS"[kind], w -> r -> code[k][0], w -> r -> code[k][1], '\0'};
            out[k].at[kind] = code[1] != '\0' ? orr_obs_code_index(h, all[k].system, code) : -1;
        }
}

static orr_status sat_of(reading *w, orr_sat sat, int32_t *out, orr_diag *diag)
{
    orr_replay *r = w->r;
    int32_t *k = &w->sat[orr_sat_slot(sat)];
    if (*k < 0) {
        if (!ORR_ARRAY_GROW(r->sat, r->n_sats) || !ORR_ARRAY_GROW(w->track, r->n_sats))
            return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        *k = (int32_t)r->n_sats++;
        r->sat[*k] = (orr_replay_sat){.sat = sat, .pair = {-1, -1}};
        for (size_t j = 0; j < ORR_MAX_SIGNALS; j++) w->track[*k][j] = -1;
    }
    *out = *k;
    return ORR_OK;
}

static orr_status take_signal(reading *w, int32_t sat, size_t signal, const columns *c,
                              const orr_rinex_obs_epoch *e, size_t i, orr_diag *diag)
{
    orr_replay *r = w->r;
    const double *value = e->value + i * e->stride;
    double v[4];
    for (int k = 0; k < 4; k++) v[k] = c->at[k] >= 0 ? value[c->at[k]] : ORR_NAN;
    if (isnan(v[0]) && isnan(v[1])) return ORR_OK;
    int32_t *t = &w->track[sat][signal];
    if (*t < 0) {
        if (!ORR_ARRAY_GROW(r->track, r->n_tracks)) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        *t = (int32_t)r->n_tracks++;
        r->track[*t] = (orr_replay_track){.sat = (size_t)sat, .signal = (uint16_t)signal};
    }
    orr_replay_track *x = &r->track[*t];
    if (!ORR_ARRAY_GROW(x->node, x->n)) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    orr_replay_node *n = &x->node[x->n++];
    *n = (orr_replay_node){.epoch = (uint32_t)(r->n_epochs - 1),
                           .sight = (uint32_t)(r->sat[sat].n - 1),
                           .code = v[0],
                           .carrier = v[1],
                           .doppler_hz = (float)v[2],
                           .cn0_dbhz = (float)v[3]};
    for (int k = 0; k < 2; k++)
        if (c->at[k] >= 0) {
            n->lli[k] = e->lli[i * e->stride + (size_t)c->at[k]];
            n->ssi[k] = e->ssi[i * e->stride + (size_t)c->at[k]];
        }
    if (w->lost[orr_sat_slot(r->sat[sat].sat)]) n->lli[1] |= ORR_OBS_LLI_SLIP;
    r->has_doppler = r->has_doppler || !isnan(v[2]);
    r->has_cn0 = r->has_cn0 || !isnan(v[3]);
    return ORR_OK;
}

static orr_status take_epoch(reading *w, const columns *c, const orr_rinex_obs_epoch *e, orr_diag *diag)
{
    orr_replay *r = w->r;
    if (e->flag == ORR_OBS_CYCLE_SLIP)
        for (size_t i = 0; i < e->n_sats; i++) w->lost[orr_sat_slot(e->sat[i])] = true;
    if (!observes(e->flag)) return ORR_OK;
    if (!orr_span_holds(w->span, e->t)) {
        w->outside++;
        return ORR_OK;
    }
    if (r->n_epochs > 0 && e->t <= r->tag[r->n_epochs - 1]) return ORR_OK; // a second record of an epoch
    if (!ORR_ARRAY_GROW(r->tag, r->n_epochs) || !ORR_ARRAY_GROW(r->flag, r->n_epochs))
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    r->tag[r->n_epochs] = e->t;
    r->flag[r->n_epochs++] = (uint8_t)e->flag;
    orr_status s = ORR_OK;
    for (size_t i = 0; s == ORR_OK && i < e->n_sats; i++) {
        int32_t sat = -1;
        size_t n;
        const orr_signal *all = orr_signals(&n);
        if (w->unknown[orr_sat_slot(e->sat[i])]) continue;
        s = sat_of(w, e->sat[i], &sat, diag);
        if (s != ORR_OK) return s;
        orr_replay_sat *x = &r->sat[sat];
        if (!ORR_ARRAY_GROW(x->sight, x->n)) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        x->sight[x->n++] = (orr_replay_sight){.epoch = (uint32_t)(r->n_epochs - 1), .at = {-1, -1}};
        for (size_t k = 0; s == ORR_OK && k < n; k++)
            if (all[k].system == orr_sat_system(e->sat[i])) s = take_signal(w, sat, k, &c[k], e, i, diag);
        w->lost[orr_sat_slot(e->sat[i])] = false;
    }
    return s;
}

static orr_status pass(reading *w, bool counting, orr_warnings *warnings, orr_diag *diag)
{
    orr_rinex_obs *file;
    columns column[ORR_MAX_SIGNALS];
    orr_rinex_obs_limits limits = orr_rinex_obs_default_limits();
    limits.leap = w->leap;
    orr_status s = orr_rinex_obs_open(w->path, &limits, counting ? NULL : warnings, &file, diag);
    if (s != ORR_OK) return s;
    const orr_rinex_obs_header *h = orr_rinex_obs_header_of(file);
    if (counting)
        keep_header(w, h);
    else
        find_columns(w, h, column);
    for (;;) {
        const orr_rinex_obs_epoch *e;
        s = orr_rinex_obs_next(file, &e, diag);
        if (s != ORR_OK || e == NULL) break;
        if (e->header_changed && !counting) find_columns(w, h, column);
        if (e->flag == ORR_OBS_START_MOVING)
            s = orr_diag_at(diag, ORR_E_UNSUPPORTED, w->path, e->line, 0,
                            "the antenna begins to move; a replay is of a station that stands");
        else if (counting)
            count_epoch(w, h, e);
        else
            s = take_epoch(w, column, e, diag);
        if (s != ORR_OK) break;
    }
    orr_rinex_obs_close(file);
    return s;
}

static int by_sat(const void *a, const void *b)
{
    const orr_sat x = ((const orr_replay_sat *)a)->sat, y = ((const orr_replay_sat *)b)->sat;
    return (x > y) - (x < y);
}

// Satellites ascending; tracks that point at them follow.
static orr_status order(reading *w, orr_diag *diag)
{
    orr_replay *r = w->r;
    orr_sat *was = calloc(r->n_sats + 1, sizeof *was);
    if (was == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (size_t k = 0; k < r->n_sats; k++) was[k] = r->sat[k].sat;
    qsort(r->sat, r->n_sats, sizeof *r->sat, by_sat);
    for (size_t k = 0; k < r->n_tracks; k++)
        r->track[k].sat = (size_t)(orr_replay_sat_of(r, was[r->track[k].sat]) - r->sat);
    free(was);
    return ORR_OK;
}

// The usual step between epochs, and where a track's nodes do not follow each other.
static orr_status find_gaps(orr_replay *r, orr_diag *diag)
{
    double *step = calloc(r->n_epochs, sizeof *step);
    if (step == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (size_t k = 1; k < r->n_epochs; k++) step[k - 1] = orr_time_diff_s(r->tag[k], r->tag[k - 1]);
    r->interval_s = r->n_epochs > 1 ? orr_median(step, r->n_epochs - 1) : 30;
    free(step);
    const double most_s = 1.5 * r->interval_s;
    for (size_t k = 0; k < r->n_tracks; k++) {
        orr_replay_track *x = &r->track[k];
        for (size_t j = 0; j < x->n; j++)
            x->node[j].begins =
                j == 0 || orr_time_diff_s(r->tag[x->node[j].epoch], r->tag[x->node[j - 1].epoch]) > most_s;
    }
    for (size_t k = 0; k < r->n_sats; k++) {
        orr_replay_sat *x = &r->sat[k];
        for (size_t j = 0; j < x->n; j++)
            x->sight[j].begins =
                j == 0 || orr_time_diff_s(r->tag[x->sight[j].epoch], r->tag[x->sight[j - 1].epoch]) > most_s;
    }
    return ORR_OK;
}

static void warn_of_unknown(const reading *w, orr_warnings *warnings)
{
    char list[600] = "", sat[ORR_SAT_TEXT];
    for (size_t k = 0; k < ORR_SAT_SLOTS; k++) {
        const size_t used = strlen(list);
        if (w->unknown[k])
            snprintf(list + used, sizeof list - used, " %s",
                     orr_sat_text(orr_sat_make(ORR_SYSTEMS[k / 100], (int)(k % 100)), sat));
    }
    if (w->n_unknown > 0)
        orr_warnings_add(warnings, w->path, 0, 0,
                         "the orbits lack these satellites, which are not replayed:%s", list);
}

static orr_status nothing(const reading *w, orr_diag *diag)
{
    char text[4][ORR_TIME_TEXT];
    if (w->first == ORR_TIME_NONE)
        return orr_diag_at(diag, ORR_E_NODATA, w->path, 0, 0, "the file has no observations");
    if (w->r->n_epochs > 0)
        return orr_diag_at(diag, ORR_E_NODATA, w->path, 0, 0,
                           "the scenario's orbits have none of the %zu satellites that were observed",
                           w->n_unknown);
    return orr_diag_at(
        diag, ORR_E_NODATA, w->path, 0, 0,
        "observations from %s to %s, but the scenario's orbits and ionosphere reach from %s to %s: "
        "name those of the recorded day",
        orr_time_text(w->first, text[0]), orr_time_text(w->last, text[1]),
        orr_time_text(w->span.from, text[2]), orr_time_text(w->span.to, text[3]));
}

static orr_status finish(reading *w, orr_warnings *warnings, orr_diag *diag)
{
    orr_replay *r = w->r;
    if (r->n_epochs == 0 || r->n_tracks == 0) return nothing(w, diag);
    warn_of_unknown(w, warnings);
    if (w->outside > 0)
        orr_warnings_add(warnings, w->path, 0, 0,
                         "%zu epochs are left out: outside of replay.from and replay.to, or where the "
                         "scenario's orbits or ionosphere "
                         "do not reach",
                         w->outside);
    r->t = calloc(r->n_epochs, sizeof *r->t);
    r->clock_s = calloc(r->n_epochs, sizeof *r->clock_s);
    r->held_s = calloc(r->n_epochs, sizeof *r->held_s);
    r->steps = calloc(r->n_epochs, sizeof *r->steps);
    if (r->t == NULL || r->clock_s == NULL || r->held_s == NULL || r->steps == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    memcpy(r->t, r->tag, r->n_epochs * sizeof *r->t);
    const orr_status s = order(w, diag);
    return s == ORR_OK ? find_gaps(r, diag) : s;
}

orr_status orr_record_read(const char *path, const orr_source_orbit *orbits, orr_span span, uint64_t wanted,
                           const orr_leap_table *leap, orr_warnings *warnings, orr_replay **out,
                           orr_diag *diag)
{
    *out = NULL;
    reading *w = calloc(1, sizeof *w);
    orr_replay *r = calloc(1, sizeof *r);
    if (w == NULL || r == NULL) {
        free(w);
        free(r);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    *w = (reading){.path = path,
                   .orbits = orbits,
                   .span = span,
                   .wanted = wanted,
                   .leap = leap,
                   .r = r,
                   .first = ORR_TIME_NONE};
    for (size_t k = 0; k < ORR_SAT_SLOTS; k++) w->sat[k] = -1;
    orr_status s = pass(w, true, warnings, diag);
    if (s == ORR_OK) choose_codes(w, warnings);
    if (s == ORR_OK) s = pass(w, false, warnings, diag);
    if (s == ORR_OK) s = finish(w, warnings, diag);
    free(w->track);
    free(w);
    if (s != ORR_OK)
        orr_replay_free(r);
    else
        *out = r;
    return s;
}
