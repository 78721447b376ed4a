// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/judge/compare_clocks.h"

#include <math.h>
#include <stdlib.h>

#include "core/array.h"
#include "core/robust.h"

enum { LEAST_SATELLITES = 4 };

typedef struct sample {
    orr_sat sat;
    orr_time t;
    double off_s, sigma_s;
} sample;

typedef struct samples {
    size_t n;
    sample *list;
} samples;

static bool is_node(const orr_clock_node *node, size_t n, orr_time t)
{
    size_t low = 0, high = n;
    while (low < high) {
        const size_t mid = low + (high - low) / 2;
        if (node[mid].t < t)
            low = mid + 1;
        else
            high = mid;
    }
    return low < n && node[low].t == t;
}

static orr_status collect(const orr_ephemeris *e, const orr_sp3 *sp3, const orr_sat_set *sats,
                          bool with_inputs, samples *d, orr_clock_comparison *out)
{
    for (size_t k = 0; k < sp3->n_sats; k++) {
        if (sats != NULL && !orr_sat_set_has(sats, sp3->sat[k])) continue;
        const orr_clock_node *node;
        const size_t n = orr_ephemeris_clocks(e, sp3->sat[k], &node);
        for (size_t i = 0; i < sp3->n_epochs && n > 0; i++) {
            const orr_sp3_record *r = &sp3->record[i * sp3->n_sats + k];
            const orr_time t = sp3->epoch[i];
            orr_sat_state s;
            if (!isfinite(r->clock_s)) continue;
            if (is_node(node, n, t)) {
                out->inputs++;
                if (!with_inputs) continue;
            }
            if (orr_ephemeris_eval(e, sp3->sat[k], t, &s) != ORR_OK || (s.flags & ORR_EPH_CLOCK_VALID) == 0) {
                out->no_clock++;
                continue;
            }
            if (!ORR_ARRAY_GROW(d->list, d->n)) return ORR_E_MEMORY;
            d->list[d->n++] = (sample){sp3->sat[k], t, s.clock_s - r->clock_s, (double)s.clock_sigma_s};
        }
    }
    return ORR_OK;
}

static int by_system_then_time(const void *a, const void *b)
{
    const sample *x = a, *y = b;
    const int p = (int)orr_sat_system(x->sat) - (int)orr_sat_system(y->sat);
    if (p != 0) return p;
    return (x->t > y->t) - (x->t < y->t);
}

// Each epoch's median goes; epochs of few satellites go altogether. room: d->n doubles.
static void take_medians(samples *d, double *room, orr_clock_comparison *out)
{
    size_t kept = 0;
    for (size_t i = 0; i < d->n;) {
        size_t j = i;
        while (j < d->n && by_system_then_time(&d->list[i], &d->list[j]) == 0) {
            room[j - i] = d->list[j].off_s;
            j++;
        }
        if (j - i < LEAST_SATELLITES)
            out->few += j - i;
        else {
            const double median = orr_median(room, j - i);
            for (size_t k = i; k < j; k++) {
                d->list[kept] = d->list[k];
                d->list[kept++].off_s -= median;
            }
        }
        i = j;
    }
    d->n = kept;
}

// Of one system (sat ORR_SAT_NONE) or satellite.
static orr_clock_stats summarise(const samples *d, char system, orr_sat sat, double *room)
{
    orr_clock_stats s = {.system = system,
                         .sat = sat,
                         .rms_s = (double)NAN,
                         .p95_s = (double)NAN,
                         .max_s = (double)NAN,
                         .sigma_rms_s = (double)NAN,
                         .ratio = (double)NAN};
    double sum2 = 0, sigma2 = 0, ratio2 = 0;
    size_t with_sigma = 0;
    orr_sat_set seen = {0};
    for (size_t i = 0; i < d->n; i++) {
        const sample *x = &d->list[i];
        if (sat != ORR_SAT_NONE ? x->sat != sat : orr_sat_system(x->sat) != system) continue;
        if (!orr_sat_set_has(&seen, x->sat)) s.satellites++;
        orr_sat_set_add(&seen, x->sat);
        room[s.n++] = fabs(x->off_s);
        sum2 += x->off_s * x->off_s;
        if (!(x->sigma_s > 0)) continue;
        with_sigma++;
        sigma2 += x->sigma_s * x->sigma_s;
        ratio2 += x->off_s * x->off_s / (x->sigma_s * x->sigma_s);
    }
    if (s.n == 0) return s;
    s.rms_s = sqrt(sum2 / (double)s.n);
    s.max_s = orr_order_statistic(room, s.n, s.n - 1);
    s.p95_s = orr_order_statistic(room, s.n, (s.n * 95 + 99) / 100 - 1); // nearest rank
    if (with_sigma == 0) return s;
    s.sigma_rms_s = sqrt(sigma2 / (double)with_sigma);
    s.ratio = sqrt(ratio2 / (double)with_sigma);
    return s;
}

static int worst_first(const void *a, const void *b)
{
    const double x = ((const orr_clock_stats *)a)->rms_s, y = ((const orr_clock_stats *)b)->rms_s;
    return (x < y) - (x > y);
}

static orr_status by_satellite(const orr_ephemeris *e, const samples *d, double *room,
                               orr_clock_comparison *out)
{
    const orr_sat *list;
    const size_t n = orr_ephemeris_satellites(e, &list);
    out->sat = calloc(n + 1, sizeof *out->sat);
    if (out->sat == NULL) return ORR_E_MEMORY;
    for (size_t i = 0; i < n; i++) {
        const orr_clock_stats s = summarise(d, orr_sat_system(list[i]), list[i], room);
        if (s.n > 0) out->sat[out->n_sats++] = s;
    }
    qsort(out->sat, out->n_sats, sizeof *out->sat, worst_first);
    return ORR_OK;
}

orr_status orr_compare_clocks(const orr_ephemeris *e, const orr_sp3 *truth, size_t n_truths,
                              const orr_sat_set *sats, bool with_inputs, orr_clock_comparison *out,
                              orr_diag *diag)
{
    *out = (orr_clock_comparison){0};
    samples d = {0};
    orr_status s = ORR_OK;
    for (size_t i = 0; i < n_truths && s == ORR_OK; i++)
        s = collect(e, &truth[i], sats, with_inputs, &d, out);
    double *room = calloc(d.n + 1, sizeof *room);
    if (room == NULL) s = ORR_E_MEMORY;
    if (s == ORR_OK) {
        if (d.n > 1) qsort(d.list, d.n, sizeof *d.list, by_system_then_time);
        take_medians(&d, room, out);
        for (const char *system = ORR_SYSTEMS; *system != '\0'; system++) {
            out->system[out->n_systems] = summarise(&d, *system, ORR_SAT_NONE, room);
            out->n_systems += out->system[out->n_systems].n > 0;
        }
        s = by_satellite(e, &d, room, out);
    }
    free(room);
    free(d.list);
    if (s == ORR_OK) return s;
    orr_clock_comparison_free(out);
    return orr_diag_set(diag, s, "no memory to compare clocks");
}

void orr_clock_comparison_free(orr_clock_comparison *c)
{
    free(c->sat);
    *c = (orr_clock_comparison){0};
}
