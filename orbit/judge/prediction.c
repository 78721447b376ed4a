// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/judge/prediction.h"

#include <math.h>
#include <stdlib.h>

#include "core/array.h"
#include "core/robust.h"

#define ORBIT_HALF_H 0.5
#define CLOCK_HALF_H 0.76
#define MOVED_M 20.0

const double orr_prediction_age_h[ORR_PREDICTION_AGES] = {1, 3, 6, 12, 24, 48, 72, 120};

// One predicted position or clock.
typedef struct sample {
    size_t sat; // slot
    orr_time t;
    double age_h, error_m, sigma_m, clock_s, clock_sigma_s;
} sample;

typedef struct satellite {
    orr_sat sat;
    bool eclipses, moved;
} satellite;

typedef struct work {
    const orr_ephemeris *e;
    size_t n, n_sats;
    sample *list;
    satellite *sat;
    double *room, *sigma;
    orr_prediction_judgement *out;
} work;

static orr_time last_node(const orr_ephemeris *e, orr_sat sat)
{
    const orr_orbit_node *node;
    for (size_t n = orr_ephemeris_nodes(e, sat, &node); n > 0; n--)
        if (node[n - 1].used) return node[n - 1].t;
    return ORR_TIME_NONE;
}

static size_t slot_of(const work *w, orr_sat sat)
{
    size_t i = 0;
    while (i < w->n_sats && w->sat[i].sat != sat) i++;
    return i;
}

static orr_status take(work *w, const orr_sp3 *truth, size_t k)
{
    const size_t slot = slot_of(w, truth->sat[k]);
    if (slot == w->n_sats) return ORR_OK;
    const orr_time last = last_node(w->e, truth->sat[k]);
    for (size_t i = 0; i < truth->n_epochs && last != ORR_TIME_NONE; i++) {
        const orr_sp3_record *r = &truth->record[i * truth->n_sats + k];
        const orr_time t = truth->epoch[i];
        orr_sat_state s;
        if (t <= last || !isfinite(r->pos_m[0]) || orr_ephemeris_eval(w->e, truth->sat[k], t, &s) != ORR_OK ||
            (s.flags & ORR_EPH_PREDICTED) == 0)
            continue;
        if ((r->flags & ORR_SP3_ORBIT_PREDICTED) != 0) {
            w->out->predicted++;
            continue;
        }
        if (!ORR_ARRAY_GROW(w->list, w->n)) return ORR_E_MEMORY;
        const orr_vec3 d = orr_vec3_sub(s.pos_m, (orr_vec3){r->pos_m[0], r->pos_m[1], r->pos_m[2]});
        const bool clock = (r->flags & ORR_SP3_CLOCK_PREDICTED) == 0 && isfinite(s.clock_s);
        sample *x = &w->list[w->n++];
        *x = (sample){.sat = slot,
                      .t = t,
                      .age_h = orr_time_diff_s(t, last) / 3600,
                      .error_m = orr_vec3_norm(d),
                      .sigma_m = (double)s.sigma_m,
                      .clock_s = clock ? s.clock_s - r->clock_s : (double)NAN,
                      .clock_sigma_s = (double)s.clock_sigma_s};
        satellite *sat = &w->sat[slot];
        sat->eclipses = sat->eclipses || (s.flags & ORR_EPH_ECLIPSE) != 0;
        sat->moved = sat->moved || (r->flags & ORR_SP3_MANOEUVRE) != 0 || x->error_m > MOVED_M;
    }
    return ORR_OK;
}

static int by_epoch(const void *a, const void *b)
{
    const sample *x = a, *y = b;
    if (x->t != y->t) return x->t < y->t ? -1 : 1;
    return (x->sat > y->sat) - (x->sat < y->sat);
}

// The median of a system at every epoch is taken off its clocks.
static void take_common_away(work *w)
{
    for (size_t i = 0, j; i < w->n; i = j) {
        for (j = i; j < w->n && w->list[j].t == w->list[i].t;) j++;
        for (const char *system = ORR_SYSTEMS; *system != '\0'; system++) {
            size_t n = 0;
            for (size_t k = i; k < j; k++)
                if (orr_sat_system(w->sat[w->list[k].sat].sat) == *system && isfinite(w->list[k].clock_s))
                    w->room[n++] = w->list[k].clock_s;
            const double common = n > 0 ? orr_median(w->room, n) : 0;
            for (size_t k = i; k < j; k++)
                if (orr_sat_system(w->sat[w->list[k].sat].sat) == *system) w->list[k].clock_s -= common;
        }
    }
}

// RMS error and sigma of one satellite about an age; NAN where there is nothing.
static double about(const work *w, size_t slot, double age_h, bool clock, double *sigma)
{
    double sum = 0, sigma2 = 0;
    size_t n = 0;
    for (size_t i = 0; i < w->n; i++) {
        const sample *x = &w->list[i];
        const double value = clock ? x->clock_s : x->error_m;
        if (x->sat != slot || !isfinite(value) ||
            fabs(x->age_h - age_h) > (clock ? CLOCK_HALF_H : ORBIT_HALF_H))
            continue;
        sum += value * value;
        sigma2 += clock ? x->clock_sigma_s * x->clock_sigma_s : x->sigma_m * x->sigma_m;
        n++;
    }
    *sigma = n > 0 ? sqrt(sigma2 / (double)n) : (double)NAN;
    return n > 0 ? sqrt(sum / (double)n) : (double)NAN;
}

static orr_prediction_stats over_satellites(const work *w, char system, bool eclipses, double age_h,
                                            bool clock)
{
    orr_prediction_stats s = {.median = (double)NAN, .p95 = (double)NAN, .ratio = (double)NAN};
    size_t n = 0, n_ratio = 0;
    for (size_t i = 0; i < w->n_sats; i++) {
        const satellite *x = &w->sat[i];
        double sigma;
        if (orr_sat_system(x->sat) != system || x->moved || (!clock && x->eclipses != eclipses)) continue;
        const double error = about(w, i, age_h, clock, &sigma);
        if (isnan(error)) continue;
        w->room[n++] = error;
        if (sigma > 0) w->sigma[n_ratio++] = error / sigma;
    }
    s.satellites = n;
    if (n == 0) return s;
    s.median = orr_median(w->room, n);
    s.p95 = orr_order_statistic(w->room, n, (n * 95 + 99) / 100 - 1);
    if (n_ratio > 0) s.ratio = orr_median(w->sigma, n_ratio);
    return s;
}

static orr_status make_rows(work *w)
{
    for (const char *system = ORR_SYSTEMS; *system != '\0'; system++)
        for (int eclipses = 0; eclipses < 2; eclipses++)
            for (int k = 0; k < ORR_PREDICTION_AGES; k++) {
                orr_prediction_row row = {
                    .system = *system, .eclipses = eclipses != 0, .age_h = orr_prediction_age_h[k]};
                row.orbit = over_satellites(w, *system, row.eclipses, row.age_h, false);
                row.clock = over_satellites(w, *system, false, row.age_h, true);
                if (row.orbit.satellites == 0) continue;
                if (!ORR_ARRAY_GROW(w->out->row, w->out->n)) return ORR_E_MEMORY;
                w->out->row[w->out->n++] = row;
            }
    for (size_t i = 0; i < w->n_sats; i++) {
        if (!w->sat[i].moved) continue;
        if (!ORR_ARRAY_GROW(w->out->moved, w->out->n_moved)) return ORR_E_MEMORY;
        w->out->moved[w->out->n_moved++] = w->sat[i].sat;
    }
    return ORR_OK;
}

orr_status orr_prediction_judge(const orr_ephemeris *e, const orr_sp3 *truth, size_t n_truths,
                                orr_prediction_judgement *out, orr_diag *diag)
{
    const orr_sat *sat;
    work w = {.e = e, .out = out, .n_sats = orr_ephemeris_satellites(e, &sat)};
    *out = (orr_prediction_judgement){0};
    w.sat = calloc(w.n_sats + 1, sizeof *w.sat);
    orr_status s = w.sat != NULL ? ORR_OK : ORR_E_MEMORY;
    for (size_t i = 0; i < w.n_sats && s == ORR_OK; i++) w.sat[i].sat = sat[i];
    for (size_t i = 0; i < n_truths && s == ORR_OK; i++)
        for (size_t k = 0; k < truth[i].n_sats && s == ORR_OK; k++) s = take(&w, &truth[i], k);
    const size_t room = (w.n > w.n_sats ? w.n : w.n_sats) + 1;
    w.room = malloc(room * sizeof *w.room);
    w.sigma = malloc(room * sizeof *w.sigma);
    if (w.room == NULL || w.sigma == NULL) s = ORR_E_MEMORY;
    if (s == ORR_OK && w.n > 0) {
        qsort(w.list, w.n, sizeof *w.list, by_epoch);
        take_common_away(&w);
        s = make_rows(&w);
    }
    free(w.list);
    free(w.sat);
    free(w.room);
    free(w.sigma);
    if (s == ORR_OK) return ORR_OK;
    orr_prediction_judgement_free(out);
    return orr_diag_set(diag, s, "out of memory for the judgement of a prediction");
}

void orr_prediction_judgement_free(orr_prediction_judgement *j)
{
    free(j->row);
    free(j->moved);
    *j = (orr_prediction_judgement){0};
}
