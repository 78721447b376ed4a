// SPDX-License-Identifier: GPL-3.0-or-later
// Two passes over the file: which signals each satellite has, then those of the chosen pair. So memory
// follows what is used, whatever a receiver writes.
#include "iono/phase/phase_tec.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/astro.h"
#include "core/nan.h"
#include "ingest/rinex/rinex_obs.h"
#include "iono/phase/clock_steps.h"
#include "iono/phase/signals.h"
#include "iono/phase/windup.h"

#define SAT_SLOTS (ORR_N_SYSTEMS * 100)
#define ENOUGH 0.9 // a better-liked signal may have so much fewer epochs than the fullest one

orr_phase_options orr_phase_default_options(void)
{
    return (orr_phase_options){.from = ORR_TIME_NONE,
                               .to = ORR_TIME_NONE,
                               .mask_rad = 10 * ORR_RAD_PER_DEG,
                               .shell_radius_m = ORR_SHELL_RADIUS_M,
                               .windup = true,
                               .arcs = orr_arc_default_options(),
                               .max_samples = 50000000};
}

// How often each code of a satellite was seen, by kind (C, L), band and attribute.
typedef struct tally {
    uint32_t seen[2][10][26];
} tally;

typedef struct choice {
    char phase[2][4], range[2][4];
    double freq_hz[2];
    int at[4]; // columns of phase 1, 2, range 1, 2 in the header in force; -1: not there
} choice;

// Samples of one satellite as they are read.
typedef struct raw {
    size_t n;
    orr_time *t;
    double (*value)[4]; // phases in cycles, ranges in metres
    uint8_t *lost;
    bool lost_next;
} raw;

typedef struct reading {
    const char *data; // the file's bytes
    size_t n_data;
    const orr_phase_options *o;
    tally *tally[SAT_SLOTS];
    choice *choice[SAT_SLOTS];
    raw raw[SAT_SLOTS];
    int8_t channel[100];
    double version;
    uint64_t n_samples;
    size_t n_epochs;
    orr_time *epoch;
} reading;

static size_t slot_of(orr_sat s)
{
    return (size_t)orr_sat_system_index(s) * 100 + (size_t)orr_sat_number(s) % 100;
}

static void reading_free(reading *r)
{
    for (size_t i = 0; i < SAT_SLOTS; i++) {
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

static orr_status count_epoch(reading *r, const orr_rinex_obs_header *h, const orr_rinex_obs_epoch *e,
                              orr_diag *diag)
{
    for (size_t i = 0; i < e->n_sats; i++) {
        if (!wanted(r->o, e->sat[i])) continue;
        size_t slot = slot_of(e->sat[i]);
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

static orr_status choose(reading *r, size_t slot, char system, int channel, orr_diag *diag)
{
    const tally *t = r->tally[slot];
    choice best = {0};
    uint32_t most = 0;
    const char *pairs = orr_signal_band_pairs(system);
    for (int round = 0; round < 2;
         round++) // how many epochs the fullest pair has; then the first that has nearly as many
        for (size_t p = 0; pairs[p] != '\0'; p += 2) {
            choice c = {0};
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

static void find_columns(reading *r, const orr_rinex_obs_header *h)
{
    for (size_t slot = 0; slot < SAT_SLOTS; slot++) {
        choice *c = r->choice[slot];
        if (c == NULL) continue;
        char system = ORR_SYSTEMS[slot / 100];
        for (int i = 0; i < 2; i++) {
            c->at[i] = orr_obs_code_index(h, system, c->phase[i]);
            c->at[2 + i] = c->range[i][0] != '\0' ? orr_obs_code_index(h, system, c->range[i]) : -1;
        }
    }
}

static bool grow(raw *w)
{
    return ORR_ARRAY_GROW(w->t, w->n) && ORR_ARRAY_GROW(w->value, w->n) && ORR_ARRAY_GROW(w->lost, w->n);
}

static orr_status take_epoch(reading *r, const orr_rinex_obs_epoch *e, bool skip, orr_diag *diag)
{
    if (e->flag == ORR_OBS_POWER_FAILURE)
        for (size_t s = 0; s < SAT_SLOTS; s++) r->raw[s].lost_next = true;
    if (!skip) {
        if (!ORR_ARRAY_GROW(r->epoch, r->n_epochs))
            return orr_diag_set(diag, ORR_E_MEMORY, "no memory for epochs");
        r->epoch[r->n_epochs++] = e->t;
    }
    for (size_t i = 0; i < e->n_sats; i++) {
        if (!wanted(r->o, e->sat[i])) continue;
        size_t slot = slot_of(e->sat[i]);
        const choice *c = r->choice[slot];
        if (c == NULL) continue;
        raw *w = &r->raw[slot];
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
static orr_status open_observations(const reading *r, const char *path, orr_warnings *warnings,
                                    orr_rinex_obs **out, orr_diag *diag)
{
    return orr_rinex_obs_open_memory(path, r->data, r->n_data, NULL, warnings, out, diag);
}

static orr_status pass(reading *r, const char *path, bool counting, orr_phase_tec *out,
                       orr_warnings *warnings, orr_diag *diag)
{
    orr_rinex_obs *file;
    orr_status s = open_observations(r, path, warnings, &file, diag);
    if (s != ORR_OK) return s;
    const orr_rinex_obs_header *h = orr_rinex_obs_header_of(file);
    const orr_phase_options *o = r->o;
    r->version = h->version;
    if (counting) {
        snprintf(out->marker, sizeof out->marker, "%s", h->marker_name);
        memcpy(r->channel, h->glonass_channel, sizeof r->channel);
        if (o->site_m != NULL)
            s = orr_iono_site_at(*o->site_m, &out->site, diag);
        else if (!h->has_position || orr_vec3_norm(h->position_m) < 6.2e6)
            s = orr_diag_at(diag, ORR_E_NODATA, path, 0, 0,
                            "the header has no position of the station (APPROX POSITION XYZ); give one");
        else
            s = orr_iono_site_at(h->position_m, &out->site, diag);
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

// --- From observations to TEC ---

// The Sun's ecef position every ten minutes; straight lines between are good to 0.02 degrees.
typedef struct sun_table {
    orr_time t0;
    size_t n;
    orr_vec3 *at;
} sun_table;
#define SUN_STEP_NS (600 * ORR_NS_PER_S)

static orr_status sun_init(sun_table *s, orr_time from, orr_time to, const orr_leap_table *leap,
                           orr_diag *diag)
{
    s->t0 = from;
    s->n = (size_t)((to - from) / SUN_STEP_NS) + 2;
    s->at = malloc(s->n * sizeof *s->at);
    if (s->at == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the Sun");
    for (size_t i = 0; i < s->n; i++) {
        orr_time t = from + (int64_t)i * SUN_STEP_NS;
        orr_eop eop = orr_eop_at(NULL, t, leap, NULL);
        orr_mat3 rotation;
        orr_astro_gcrs_to_itrs(t, &eop, leap, &rotation, NULL);
        s->at[i] = orr_mat3_apply(&rotation, orr_astro_sun(t));
    }
    return ORR_OK;
}

static orr_vec3 sun_at(const sun_table *s, orr_time t)
{
    size_t i = (size_t)((t - s->t0) / SUN_STEP_NS);
    double w = (double)(t - s->t0 - (int64_t)i * SUN_STEP_NS) / (double)SUN_STEP_NS;
    return orr_vec3_axpy(w, orr_vec3_sub(s->at[i + 1], s->at[i]), s->at[i]);
}

static void phase_sat_free(orr_phase_sat *s)
{
    free(s->t);
    free(s->gf_tecu);
    free(s->code_tecu);
    free(s->windup);
    free(s->pierce);
    orr_arcs_free(&s->arcs);
}

// What the phase centre of each carrier adds to the range from the centre of mass, taken out: metres to add to what was
// measured on carriers 1 and 2. The satellite keeps nominal yaw. False where the file has not both carriers.
static bool antenna_shift(const orr_antex *antex, const choice *c, orr_sat sat, orr_time t, orr_vec3 pos_m,
                          orr_vec3 sun_m, orr_vec3 site_m, double shift_m[2])
{
    const orr_antex_antenna *a = orr_antex_find_sat(antex, sat, t);
    if (a == NULL) return false;
    orr_vec3 z = orr_vec3_scale(-1, orr_vec3_unit(pos_m));
    orr_vec3 y = orr_vec3_unit(orr_vec3_cross(z, orr_vec3_unit(orr_vec3_sub(sun_m, pos_m))));
    orr_vec3 x = orr_vec3_cross(y, z), down = orr_vec3_unit(orr_vec3_sub(site_m, pos_m));
    for (int i = 0; i < 2; i++) {
        const char code[4] = {orr_sat_system(sat), '0', c->phase[i][1], '\0'};
        const orr_antex_frequency *f = orr_antex_find_frequency(a, code);
        if (f == NULL) return false;
        shift_m[i] = f->offset_m[0] * orr_vec3_dot(down, x) + f->offset_m[1] * orr_vec3_dot(down, y) +
                     f->offset_m[2] * orr_vec3_dot(down, z);
    }
    return true;
}

static orr_status make_sat(const reading *r, size_t slot, const sun_table *sun, orr_phase_tec *out,
                           bool *known, orr_diag *diag)
{
    const orr_phase_options *o = r->o;
    const raw *w = &r->raw[slot];
    const choice *c = r->choice[slot];
    orr_phase_sat s = {.sat = orr_sat_make(ORR_SYSTEMS[slot / 100], (int)(slot % 100))};
    memcpy(s.phase, c->phase, sizeof s.phase);
    memcpy(s.range, c->range, sizeof s.range);
    memcpy(s.freq_hz, c->freq_hz, sizeof s.freq_hz);
    s.t = malloc((w->n + 1) * sizeof *s.t);
    s.gf_tecu = malloc((w->n + 1) * sizeof *s.gf_tecu);
    s.code_tecu = malloc((w->n + 1) * sizeof *s.code_tecu);
    s.windup = malloc((w->n + 1) * sizeof *s.windup);
    s.pierce = calloc(w->n + 1, sizeof *s.pierce);
    double *mw = malloc((w->n + 1) * sizeof *mw), *seconds = malloc((w->n + 1) * sizeof *seconds);
    uint8_t *lost = malloc(w->n + 1);
    orr_status status = ORR_OK;
    if (!s.t || !s.gf_tecu || !s.code_tecu || !s.windup || !s.pierce || !mw || !seconds || !lost)
        status = orr_diag_set(diag, ORR_E_MEMORY, "no memory for the phases of a satellite");
    double f1 = s.freq_hz[0], f2 = s.freq_hz[1], l1 = ORR_LIGHT_MPS / f1, l2 = ORR_LIGHT_MPS / f2;
    double k = orr_tecu_per_metre(f1, f2), turns = 0;
    bool pending = false, antenna = o->antex == NULL;
    *known = o->position == NULL;
    for (size_t i = 0; status == ORR_OK && i < w->n; i++) {
        pending |= w->lost[i];
        double wind = 0, shift[2] = {0};
        if (o->position != NULL) {
            orr_vec3 pos;
            if (!o->position(o->user, s.sat, w->t[i], &pos)) continue;
            *known = true;
            if (orr_pierce_ray(&out->site, pos, o->shell_radius_m, &s.pierce[s.n], NULL) != ORR_OK ||
                s.pierce[s.n].el_rad < o->mask_rad)
                continue;
            if (o->windup) wind = turns = orr_windup_turns(&out->site, pos, sun_at(sun, w->t[i]), turns);
            if (o->antex != NULL &&
                antenna_shift(o->antex, c, s.sat, w->t[i], pos, sun_at(sun, w->t[i]), out->site.pos_m, shift))
                antenna = true;
            else
                shift[0] = shift[1] = 0;
        }
        const double *v = w->value[i];
        double z1 = v[0] - wind, z2 = v[1] - wind;
        s.t[s.n] = w->t[i];
        seconds[s.n] = orr_time_diff_s(w->t[i], w->t[0]);
        s.windup[s.n] = wind;
        s.gf_tecu[s.n] = k * (l1 * z1 + shift[0] - l2 * z2 - shift[1]);
        s.code_tecu[s.n] = k * (v[3] + shift[1] - v[2] - shift[0]);
        mw[s.n] = z1 - z2 - (f1 * v[2] + f2 * v[3]) * (f1 - f2) / ((f1 + f2) * ORR_LIGHT_MPS);
        lost[s.n] = pending;
        pending = false;
        s.n++;
    }
    if (status == ORR_OK && s.n > 0) {
        orr_arc_series series = {s.n, seconds, s.gf_tecu, mw, lost, k * l1, k * l2};
        status = orr_arcs_find(&series, &o->arcs, &s.arcs, diag);
    }
    if (!antenna) out->n_without_antenna++;
    free(mw);
    free(seconds);
    free(lost);
    if (status != ORR_OK || s.n == 0) {
        phase_sat_free(&s);
        return status;
    }
    for (size_t i = 0; i < s.n; i++) s.gf_tecu[i] -= s.arcs.fix_tecu[i];
    out->sat[out->n_sats++] = s;
    return ORR_OK;
}

static orr_status undo_clock_steps(reading *r, orr_phase_tec *out, orr_diag *diag)
{
    orr_clock_series *series = calloc(SAT_SLOTS, sizeof *series);
    if (series == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for observations");
    size_t n = 0;
    for (size_t slot = 0; slot < SAT_SLOTS; slot++)
        if (r->choice[slot] != NULL && r->raw[slot].n > 0)
            series[n++] = (orr_clock_series){r->raw[slot].n, r->raw[slot].t, r->raw[slot].value,
                                             ORR_LIGHT_MPS / r->choice[slot]->freq_hz[0]};
    orr_status s = orr_clock_steps_undo(series, n, r->epoch, r->n_epochs, &out->n_clock_steps, diag);
    free(series);
    return s;
}

static int by_time(const void *a, const void *b)
{
    orr_time x = *(const orr_time *)a, y = *(const orr_time *)b;
    return x < y ? -1 : x > y;
}

static orr_status finish(reading *r, const char *path, orr_phase_tec *out, orr_diag *diag)
{
    if (r->n_epochs == 0)
        return orr_diag_at(diag, ORR_E_NODATA, path, 0, 0, "no epoch of observations in the time asked for");
    out->n_epochs = r->n_epochs;
    out->from = r->epoch[0];
    out->to = r->epoch[r->n_epochs - 1];
    if (out->to < out->from) return orr_diag_at(diag, ORR_E_FORMAT, path, 0, 0, "epochs go backward in time");
    orr_status s = undo_clock_steps(r, out, diag);
    if (s != ORR_OK) return s;
    for (size_t i = 0; i + 1 < r->n_epochs; i++) r->epoch[i] = r->epoch[i + 1] - r->epoch[i];
    if (r->n_epochs > 1) {
        qsort(r->epoch, r->n_epochs - 1, sizeof *r->epoch, by_time);
        out->interval_s = (double)r->epoch[(r->n_epochs - 1) / 2] * 1e-9;
    }
    out->has_geometry = r->o->position != NULL;
    out->sat = calloc(SAT_SLOTS, sizeof *out->sat);
    if (out->sat == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for satellites");
    sun_table sun = {0};
    if (r->o->position != NULL && (r->o->windup || r->o->antex != NULL))
        s = sun_init(&sun, out->from, out->to, r->o->leap, diag);
    size_t dual = 0;
    for (size_t slot = 0; s == ORR_OK && slot < SAT_SLOTS; slot++) {
        if (r->tally[slot] == NULL) continue;
        if (r->choice[slot] == NULL || r->raw[slot].n == 0) {
            out->n_single++;
            continue;
        }
        bool known;
        dual++;
        s = make_sat(r, slot, &sun, out, &known, diag);
        if (!known) out->n_unknown++;
    }
    free(sun.at);
    if (s != ORR_OK) return s;
    if (dual == 0)
        return orr_diag_at(diag, ORR_E_NODATA, path, 0, 0,
                           "no satellite has carrier phases on two frequencies (%zu have one or none)",
                           out->n_single);
    if (out->n_sats == 0)
        return orr_diag_at(
            diag, ORR_E_NODATA, path, 0, 0,
            "none of its %zu satellites is above the mask with a known position (%zu are not in the orbit)",
            dual, out->n_unknown);
    return ORR_OK;
}

orr_status orr_phase_tec_make(const char *name, const void *data, size_t n, const orr_phase_options *options,
                              orr_phase_tec *out, orr_warnings *warnings, orr_diag *diag)
{
    *out = (orr_phase_tec){0};
    orr_phase_options o = options != NULL ? *options : orr_phase_default_options();
    reading *r = calloc(1, sizeof *r);
    if (r == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory to read observations");
    r->o = &o;
    r->data = data;
    r->n_data = n;
    orr_status s = pass(r, name, true, out, warnings, diag);
    for (size_t slot = 0; s == ORR_OK && slot < SAT_SLOTS; slot++) {
        if (r->tally[slot] == NULL) continue;
        char system = ORR_SYSTEMS[slot / 100];
        int channel = 0;
        if (system == 'R') {
            channel = r->channel[slot % 100];
            if (channel == ORR_OBS_NO_CHANNEL && o.glonass_channel != NULL)
                channel = o.glonass_channel[slot % 100];
            if (channel == ORR_OBS_NO_CHANNEL) {
                orr_warnings_add(warnings, name, 0, 0,
                                 "R%02zu is left out: neither the header nor a navigation file tells its "
                                 "frequency channel",
                                 slot % 100);
                continue;
            }
        }
        s = choose(r, slot, system, channel, diag);
    }
    if (s == ORR_OK) s = pass(r, name, false, out, NULL, diag); // warned of once
    if (s == ORR_OK) s = finish(r, name, out, diag);
    reading_free(r);
    if (s != ORR_OK) orr_phase_tec_free(out);
    return s;
}

void orr_phase_tec_free(orr_phase_tec *p)
{
    for (size_t i = 0; i < p->n_sats; i++) phase_sat_free(&p->sat[i]);
    free(p->sat);
    *p = (orr_phase_tec){0};
}
