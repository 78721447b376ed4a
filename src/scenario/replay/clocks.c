// SPDX-License-Identifier: GPL-3.0-or-later
// Satellites' clocks between the nodes of the orbits' clocks. A line between nodes five minutes apart misses a rubidium clock by some
// centimetres; at the nodes it is right. What the station's ionosphere-free phases are left with in between is that, and noise:
// a random walk tied to zero at both nodes is separated from it by their variances.
#include <math.h>
#include <stdlib.h>

#include "core/constants.h"
#include "core/linalg.h"
#include "core/robust.h"
#include "src/scenario/replay/replay_private.h"

#define LIKELY_M2PS 1e-6 // variance of a walk before it is estimated: 9 mm in the middle of 5 minutes

orr_status replay_bridges(replay_maker *m, orr_diag *diag)
{
    const orr_ephemeris *e = orr_source_orbit_ephemeris(m->orbits);
    double *step = NULL;
    size_t n_steps = 0;
    for (size_t k = 0; k < m->r->n_sats; k++) {
        const orr_clock_node *node;
        orr_replay_sat *x = &m->r->sat[k];
        const size_t n = orr_ephemeris_clocks(e, x->sat, &node);
        size_t j = 0;
        x->walk_m2ps = LIKELY_M2PS;
        for (size_t i = 0; i < x->n; i++) {
            const orr_time t = m->r->t[x->sight[i].epoch];
            while (j + 1 < n && node[j + 1].t <= t) j++;
            x->sight[i].bridge_s = 0;
            if (j + 1 >= n || t < node[j].t) continue;
            const double before = orr_time_diff_s(t, node[j].t), behind = orr_time_diff_s(node[j + 1].t, t);
            x->sight[i].bridge_s = (float)(before * behind / (before + behind));
        }
        if (n < 2) continue;
        double *grown = realloc(step, (n_steps + 1) * sizeof *step);
        if (grown == NULL) {
            free(step);
            return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        }
        step = grown;
        step[n_steps++] = orr_time_diff_s(node[n / 2].t, node[n / 2 - 1].t);
    }
    m->clock_step_s = n_steps > 0 ? orr_median(step, n_steps) : 0;
    free(step);
    return ORR_OK;
}

// What is left of a satellite's phases, m, its arcs' means off; NAN where it has not both carriers or is an outlier.
static void phases_left(const replay_maker *m, const orr_replay_sat *x, double *left_m)
{
    const orr_replay *r = m->r;
    double a[2];
    replay_free_of_ionosphere(m, x, a);
    for (size_t from = 0, to; from < x->n; from = to) {
        double sum = 0, weight = 0;
        for (to = from; to < x->n && x->sight[to].arc == x->sight[from].arc; to++) {
            const orr_replay_node *n[2];
            const orr_replay_sight *g = &x->sight[to];
            left_m[to] = (double)NAN;
            if ((g->rejected & 1) != 0 || !replay_pair_of(r, x, g, n)) continue;
            left_m[to] = a[0] * n[0]->carrier_m - a[1] * n[1]->carrier_m -
                         ORR_LIGHT_MPS * (r->clock_s[g->epoch] - r->held_s[g->epoch]);
            const double w = 1 / (replay_variance_m2(g) + x->walk_m2ps * (double)g->bridge_s);
            sum += w * left_m[to];
            weight += w;
        }
        for (size_t k = from; k < to; k++) left_m[k] -= sum / weight;
    }
}

// One stretch between two nodes: sights from..to-1 lie strictly between them.
static orr_status smooth(const replay_maker *m, orr_replay_sat *x, size_t from, size_t to, orr_time node,
                         orr_time next, const double *left_m, double *band, double *value)
{
    size_t n = 0;
    orr_time last = node;
    for (size_t k = from; k < to; k++) {
        const orr_replay_sight *g = &x->sight[k];
        if (isnan(left_m[k])) continue;
        const orr_time t = m->r->t[g->epoch];
        const double rise = 1 / (x->walk_m2ps * orr_time_diff_s(t, last)), own = 1 / replay_variance_m2(g);
        band[2 * n] = rise + own;
        band[2 * n + 1] = 0;
        if (n > 0) {
            band[2 * n - 2] += rise;
            band[2 * n - 1] = -rise;
        }
        value[n++] = own * left_m[k];
        last = t;
    }
    if (n == 0) return ORR_OK;
    band[2 * n - 2] += 1 / (x->walk_m2ps * orr_time_diff_s(next, last));
    const orr_status s = orr_band_solve(band, n, n > 1 ? 1 : 0, value, 1);
    if (s != ORR_OK) return s;
    for (size_t k = from, j = 0; k < to; k++)
        if (!isnan(left_m[k])) x->sight[k].clock_m = value[j++];
    return ORR_OK;
}

// Sights without a phase have the clock of the one before, up to the next node.
static void carry(orr_replay_sat *x, const double *left_m)
{
    for (size_t k = 1; k < x->n; k++)
        if (isnan(left_m[k]) && x->sight[k].bridge_s > 0 && !x->sight[k].begins)
            x->sight[k].clock_m = x->sight[k - 1].clock_m;
}

orr_status replay_clocks(replay_maker *m, orr_diag *diag)
{
    const orr_ephemeris *e = orr_source_orbit_ephemeris(m->orbits);
    orr_replay *r = m->r;
    size_t most = 1, n_all = 0;
    double sum = 0;
    for (size_t k = 0; k < r->n_sats; k++) most = r->sat[k].n > most ? r->sat[k].n : most;
    double *left_m = malloc(most * sizeof *left_m), *value = malloc(most * sizeof *value),
           *band = malloc(2 * most * sizeof *band);
    orr_status s = left_m != NULL && value != NULL && band != NULL
                       ? ORR_OK
                       : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (size_t k = 0; s == ORR_OK && k < r->n_sats; k++) {
        const orr_clock_node *node;
        orr_replay_sat *x = &r->sat[k];
        const size_t n = orr_ephemeris_clocks(e, x->sat, &node);
        for (size_t i = 0; i < x->n; i++) x->sight[i].clock_m = 0;
        if (x->pair[0] < 0 || !(x->walk_m2ps > 0)) continue;
        phases_left(m, x, left_m);
        for (size_t j = 0, from = 0; s == ORR_OK && j + 1 < n; j++) {
            while (from < x->n && r->t[x->sight[from].epoch] <= node[j].t) from++;
            size_t to = from;
            while (to < x->n && r->t[x->sight[to].epoch] < node[j + 1].t) to++;
            if (to > from) s = smooth(m, x, from, to, node[j].t, node[j + 1].t, left_m, band, value);
            from = to;
        }
        carry(x, left_m);
        for (size_t i = 0; i < x->n; i++)
            if (x->sight[i].bridge_s > 0 && !isnan(left_m[i])) {
                sum += x->sight[i].clock_m * x->sight[i].clock_m;
                n_all++;
            }
    }
    m->report->clock_step_s = m->clock_step_s;
    m->report->clock_between_m = n_all > 0 ? sqrt(sum / (double)n_all) : 0;
    free(left_m);
    free(value);
    free(band);
    return s;
}
