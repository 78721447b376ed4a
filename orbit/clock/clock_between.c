// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/clock/clock_between.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/robust.h"
#include "orbit/clock/clock_common.h"

enum { N_LAGS = 2, LEAST_DIFFERENCES = 5, LEAST_SHARING = 5 };
static const size_t lag[N_LAGS] = {1, 2};

typedef struct sums {
    double sum2[N_LAGS];
    size_t n[N_LAGS];
} sums;

// Second differences within a run of nodes that are one step apart each.
static void add_run(const orr_clock_node *c, size_t n, sums *to)
{
    for (int k = 0; k < N_LAGS; k++)
        for (size_t i = 0; i + 2 * lag[k] < n; i++) {
            const double d = c[i + 2 * lag[k]].clock_s - 2 * c[i + lag[k]].clock_s + c[i].clock_s;
            to->sum2[k] += d * d;
            to->n[k]++;
        }
}

static sums second_differences(const orr_clock_list *l, double step_s, double max_gap_s)
{
    sums s = {0};
    for (size_t first = 0; first < l->n;) {
        size_t next = first + 1;
        for (; next < l->n; next++) {
            const double dt = orr_time_diff_s(l->node[next].t, l->node[next - 1].t);
            if (fabs(dt - step_s) > 1e-3 || dt > max_gap_s ||
                (l->node[next].flags & ORR_EPH_CLOCK_EVENT) != 0 ||
                (l->node[next].flags & ORR_EPH_PREDICTED) != 0)
                break;
        }
        add_run(&l->node[first], next - first, &s);
        first = next;
    }
    return s;
}

// Variance of second differences, a lag apart, of white noise of variance 1.
static double white_difference(double tau_s)
{
    return 6 - 8 * orr_clock_white_correlation(tau_s) + 2 * orr_clock_white_correlation(2 * tau_s);
}

// White noise, a random walk and one of frequency have second differences of variance f(tau) w, 2 q tau and 2/3 r tau^3.
// Of each two neighbouring kinds the first two lags tell how much: a ratio of 2 is a walk, of 8 one of frequency.
static orr_clock_noise noise_of(const sums *s, double step_s)
{
    const double v1 = s->sum2[0] / (double)s->n[0], f1 = white_difference(step_s),
                 f2 = white_difference(2 * step_s);
    const double v2 = s->n[1] >= LEAST_DIFFERENCES ? s->sum2[1] / (double)s->n[1] : 2 * v1;
    orr_clock_noise n = {0};
    if (v2 <= 2 * v1 && f2 < 2 * f1) { // f1 w + 2 q tau, f2 w + 4 q tau
        n.white_s2 = fmin((2 * v1 - v2) / (2 * f1 - f2), v1 / f1);
        n.wfm_s2ps = fmax(v1 - f1 * n.white_s2, 0) / (2 * step_s);
    } else { // 2 q tau + 2/3 r tau^3, 4 q tau + 16/3 r tau^3
        const double r = fmin(fmax(v2 - 2 * v1, 0) / 6, v1);
        n.rwfm_s2ps3 = 1.5 * r / (step_s * step_s * step_s);
        n.wfm_s2ps = (v1 - r) / (2 * step_s);
    }
    return n;
}

static double median_of(double *x, size_t n) { return n > 0 ? orr_upper_median(x, n) : (double)NAN; }

// A satellite that tells too little has what is usual in its system.
static orr_status fill_from_system(const orr_clock_table *clocks, const bool *told, orr_clock_noise *noise)
{
    double *room = malloc((3 * clocks->n + 1) * sizeof *room);
    if (room == NULL) return ORR_E_MEMORY;
    for (const char *system = ORR_SYSTEMS; *system != '\0'; system++) {
        double *white = room, *walk = room + clocks->n, *frequency = room + 2 * clocks->n;
        size_t n = 0;
        for (size_t i = 0; i < clocks->n; i++) {
            if (orr_sat_system(clocks->list[i].sat) != *system || !told[i]) continue;
            white[n] = noise[i].white_s2;
            walk[n] = noise[i].wfm_s2ps;
            frequency[n++] = noise[i].rwfm_s2ps3;
        }
        const orr_clock_noise usual = {median_of(white, n), median_of(walk, n), median_of(frequency, n)};
        for (size_t i = 0; i < clocks->n; i++)
            if (orr_sat_system(clocks->list[i].sat) == *system && !told[i]) noise[i] = usual;
    }
    free(room);
    return ORR_OK;
}

// The usual distance of a satellite's nodes; 0 where there are no two.
static double usual_step(const orr_clock_list *l, double *room)
{
    size_t n = 0;
    for (size_t i = 1; i < l->n; i++) {
        const double dt = orr_time_diff_s(l->node[i].t, l->node[i - 1].t);
        if (dt > 0) room[n++] = dt;
    }
    return n > 0 ? orr_upper_median(room, n) : 0;
}

// Whether at most epochs so many satellites tell what is shared that a single one's noise is not taken for it.
static bool is_told_by_many(const orr_clock_common *c)
{
    size_t many = 0;
    for (size_t e = 0; e < c->n; e++) many += c->epoch[e].n >= LEAST_SHARING;
    return 2 * many > c->n;
}

// Of one system, after what all share is taken from a copy of each clock; of few satellites the reference's steps alone.
static orr_status measure_system(const orr_clock_table *clocks, char system, double max_gap_s, bool *told,
                                 orr_clock_noise *noise)
{
    orr_clock_common shared;
    orr_status s = orr_clock_common_find(clocks->list, clocks->n, system, &shared);
    if (s == ORR_OK && !is_told_by_many(&shared)) s = orr_clock_common_keep_steps(&shared);
    for (size_t i = 0; i < clocks->n && s == ORR_OK; i++) {
        const orr_clock_list *l = &clocks->list[i];
        if (orr_sat_system(l->sat) != system || l->n == 0) continue;
        orr_clock_list copy = {.sat = l->sat, .n = l->n, .node = malloc(l->n * sizeof *copy.node)};
        double *room = malloc(l->n * sizeof *room);
        if (copy.node != NULL && room != NULL) {
            memcpy(copy.node, l->node, l->n * sizeof *copy.node);
            orr_clock_common_apply(&shared, -1, &copy);
            const double step_s = usual_step(l, room);
            const sums d = second_differences(&copy, step_s, max_gap_s);
            told[i] = d.n[0] >= LEAST_DIFFERENCES;
            if (told[i]) noise[i] = noise_of(&d, step_s);
        } else
            s = ORR_E_MEMORY;
        free(copy.node);
        free(room);
    }
    orr_clock_common_free(&shared);
    return s;
}

orr_status orr_clock_between_noise(const orr_clock_table *clocks, double max_gap_s, orr_clock_noise *noise)
{
    bool *told = calloc(clocks->n + 1, sizeof *told);
    orr_status s = told != NULL ? ORR_OK : ORR_E_MEMORY;
    for (const char *system = ORR_SYSTEMS; *system != '\0' && s == ORR_OK; system++)
        s = measure_system(clocks, *system, max_gap_s, told, noise);
    if (s == ORR_OK) s = fill_from_system(clocks, told, noise);
    free(told);
    return s;
}
