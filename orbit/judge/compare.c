// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/judge/compare.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/robust.h"
#include "orbit/judge/velocity_filter.h"

static const int64_t INNER_NS = 7200 * ORR_NS_PER_S, EDGE_NS = 2700 * ORR_NS_PER_S;

// One epoch of one satellite.
typedef struct difference {
    orr_sat sat;
    int place; // ORR_COMPARE_PLACES: in none
    orr_time t;
    orr_vec3 pos_m, vel_mps; // vel_mps.x NAN where the truth has no velocity
} difference;

typedef struct differences {
    size_t n;
    difference *list;
} differences;

static orr_status add(differences *d, const difference *x, orr_diag *diag)
{
    if (!ORR_ARRAY_GROW(d->list, d->n))
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for more than %zu differences", d->n);
    d->list[d->n++] = *x;
    return ORR_OK;
}

// The truth's positions of one satellite on an even grid, for the velocity filter.
typedef struct grid {
    orr_time t0;
    int64_t step_ns; // 0: the epochs make no grid, no velocities are derived
    size_t n;
    orr_vec3 *pos;
    orr_velocity_filter filter;
} grid;

static orr_status grid_init(const orr_sp3 *sp3, grid *g, orr_diag *diag)
{
    *g = (grid){0};
    int64_t step = 0;
    for (size_t i = 1; i < sp3->n_epochs; i++) {
        int64_t d = sp3->epoch[i] - sp3->epoch[i - 1];
        if (step == 0 || d < step) step = d;
    }
    if (step < ORR_NS_PER_S || step > 900 * ORR_NS_PER_S) return ORR_OK;
    int64_t n = (sp3->epoch[sp3->n_epochs - 1] - sp3->epoch[0]) / step + 1;
    if (n > 100 * (int64_t)sp3->n_epochs) return ORR_OK; // a few epochs strewn over years
    g->pos = calloc((size_t)n, sizeof *g->pos);
    if (g->pos == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %lld positions", (long long)n);
    g->t0 = sp3->epoch[0];
    g->n = (size_t)n;
    g->step_ns = step;
    return orr_velocity_filter_init((double)step * 1e-9, &g->filter, diag);
}

static void grid_free(grid *g)
{
    free(g->pos);
    orr_velocity_filter_free(&g->filter);
    *g = (grid){0};
}

static void grid_fill(grid *g, const orr_sp3 *sp3, size_t sat)
{
    for (size_t i = 0; i < g->n; i++) g->pos[i] = (orr_vec3){(double)NAN, (double)NAN, (double)NAN};
    for (size_t i = 0; i < sp3->n_epochs && g->step_ns > 0; i++) {
        int64_t d = sp3->epoch[i] - g->t0;
        const double *p = sp3->record[i * sp3->n_sats + sat].pos_m;
        if (d % g->step_ns == 0) g->pos[d / g->step_ns] = (orr_vec3){p[0], p[1], p[2]};
    }
}

static bool truth_velocity(const grid *g, const orr_sp3_record *r, orr_time t, bool derive, orr_vec3 *v,
                           bool *derived)
{
    if (!derive && !isnan(r->vel_mps[0]) && !isnan(r->vel_mps[1]) && !isnan(r->vel_mps[2])) {
        *v = (orr_vec3){r->vel_mps[0], r->vel_mps[1], r->vel_mps[2]};
        return true;
    }
    if (g->step_ns == 0 || (t - g->t0) % g->step_ns != 0) return false;
    if (!orr_velocity_filter_at(&g->filter, g->pos, g->n, (size_t)((t - g->t0) / g->step_ns), v))
        return false;
    *derived = true;
    return true;
}

// Index of the first node not before t.
static size_t node_from(const orr_orbit_node *node, size_t n, orr_time t)
{
    size_t low = 0, high = n;
    while (low < high) {
        size_t mid = low + (high - low) / 2;
        if (node[mid].t < t)
            low = mid + 1;
        else
            high = mid;
    }
    return low;
}

static bool is_input(const orr_orbit_node *node, size_t n, orr_time t)
{
    size_t i = node_from(node, n, t);
    return i < n && node[i].t == t;
}

static int place_of(const orr_orbit_node *node, size_t n, orr_time t, int64_t usual_ns)
{
    size_t after = node_from(node, n, t), before = after, first = 0, last = n;
    while (after < n && !node[after].used) after++;
    while (before > 0 && !node[before - 1].used) before--;
    while (first < n && !node[first].used) first++;
    while (last > 0 && !node[last - 1].used) last--;
    if (last == 0) return ORR_COMPARE_PLACES;
    if (before > 0 && after < n && node[after].t - node[before - 1].t > 2 * usual_ns) return ORR_COMPARE_GAP;
    int64_t from_first = t - node[first].t, to_last = node[last - 1].t - t;
    if (llabs(from_first) <= EDGE_NS || llabs(to_last) <= EDGE_NS) return ORR_COMPARE_EDGE;
    return from_first >= INNER_NS && to_last >= INNER_NS ? ORR_COMPARE_INNER : ORR_COMPARE_PLACES;
}

static orr_status collect(const orr_ephemeris *e, const orr_sp3 *sp3, const orr_compare_options *o,
                          differences *d, orr_comparison *out, orr_diag *diag)
{
    grid g;
    orr_status s = sp3->n_epochs > 0 ? grid_init(sp3, &g, diag) : ORR_OK;
    if (sp3->n_epochs == 0) return s;
    int64_t usual_ns = (int64_t)(orr_ephemeris_node_step_s(e) * 1e9);
    for (size_t k = 0; k < sp3->n_sats && s == ORR_OK; k++) {
        const orr_orbit_node *node;
        size_t n_nodes = orr_ephemeris_nodes(e, sp3->sat[k], &node);
        grid_fill(&g, sp3, k);
        for (size_t i = 0; i < sp3->n_epochs && s == ORR_OK; i++) {
            const orr_sp3_record *r = &sp3->record[i * sp3->n_sats + k];
            orr_time t = sp3->epoch[i];
            orr_sat_state state;
            if (isnan(r->pos_m[0]) || isnan(r->pos_m[1]) || isnan(r->pos_m[2])) continue;
            if (is_input(node, n_nodes, t)) {
                out->inputs++;
                if (!o->with_inputs) continue;
            }
            if (orr_ephemeris_eval(e, sp3->sat[k], t, &state) != ORR_OK) {
                out->no_orbit++;
                continue;
            }
            orr_vec3 v = {(double)NAN, (double)NAN, (double)NAN};
            difference x = {
                .sat = sp3->sat[k], .place = place_of(node, n_nodes, t, usual_ns), .t = t, .vel_mps = v};
            x.pos_m = orr_vec3_sub(state.pos_m, (orr_vec3){r->pos_m[0], r->pos_m[1], r->pos_m[2]});
            if (truth_velocity(&g, r, t, o->derive_velocity, &v, &out->vel_derived))
                x.vel_mps = orr_vec3_sub(state.vel_mps, v);
            if (x.place == ORR_COMPARE_PLACES) out->between++;
            s = add(d, &x, diag);
        }
    }
    grid_free(&g);
    return s;
}

// Statistics of one system in one place. size: scratch of d->n doubles.
static void summarise(const differences *d, char system, int place, double *size, orr_compare_stats *out)
{
    double sum2 = 0, vel2 = 0;
    orr_sat_set seen = {0};
    *out = (orr_compare_stats){
        .rms_m = (double)NAN, .p95_m = (double)NAN, .max_m = (double)NAN, .vel_rms_mps = (double)NAN};
    for (size_t i = 0; i < d->n; i++) {
        const difference *x = &d->list[i];
        if (x->place != place || orr_sat_system(x->sat) != system) continue;
        double r2 = orr_vec3_dot(x->pos_m, x->pos_m);
        size[out->n++] = sqrt(r2);
        sum2 += r2;
        out->mean_m = orr_vec3_add(out->mean_m, x->pos_m);
        if (!orr_sat_set_has(&seen, x->sat)) {
            orr_sat_set_add(&seen, x->sat);
            out->satellites++;
        }
        if (isnan(x->vel_mps.x)) continue;
        vel2 += orr_vec3_dot(x->vel_mps, x->vel_mps);
        out->n_vel++;
    }
    if (out->n_vel > 0) out->vel_rms_mps = sqrt(vel2 / (double)out->n_vel);
    if (out->n == 0) return;
    out->rms_m = sqrt(sum2 / (double)out->n);
    out->max_m = orr_order_statistic(size, out->n, out->n - 1);
    out->p95_m = orr_order_statistic(size, out->n, (out->n * 95 + 99) / 100 - 1); // nearest rank
    out->mean_m = orr_vec3_scale(1.0 / (double)out->n, out->mean_m);
}

static int worst_first(const void *a, const void *b)
{
    double x = ((const orr_compare_satellite *)a)->rms_m, y = ((const orr_compare_satellite *)b)->rms_m;
    return (x < y) - (x > y);
}

// d's satellites may come in several runs (one a file): slots are found by identity.
static orr_status by_satellite(const differences *d, orr_comparison *out, orr_diag *diag)
{
    enum { SLOTS = (ORR_N_SYSTEMS + 1) * 256 };
    orr_compare_satellite *all = calloc(SLOTS, sizeof *all);
    if (all == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a table of satellites");
    for (size_t i = 0; i < d->n; i++) {
        const difference *x = &d->list[i];
        orr_compare_satellite *s = &all[x->sat % SLOTS];
        double r = orr_vec3_norm(x->pos_m);
        s->sat = x->sat;
        s->rms_m += r * r; // the sum until all are in
        if (s->n++ == 0 || r > s->max_m) {
            s->max_m = r;
            s->worst = x->t;
        }
    }
    size_t n = 0;
    for (size_t i = 0; i < SLOTS; i++) {
        if (all[i].n == 0) continue;
        all[n] = all[i];
        all[n].rms_m = sqrt(all[n].rms_m / (double)all[n].n);
        n++;
    }
    qsort(all, n, sizeof *all, worst_first);
    out->sat = all;
    out->n_sats = n;
    return ORR_OK;
}

orr_status orr_compare(const orr_ephemeris *e, const orr_sp3 *truth, size_t n_truths,
                       const orr_compare_options *options, orr_comparison *out, orr_diag *diag)
{
    differences d = {0};
    double *size = NULL;
    *out = (orr_comparison){0};
    orr_status s = ORR_OK;
    for (size_t i = 0; i < n_truths && s == ORR_OK; i++) s = collect(e, &truth[i], options, &d, out, diag);
    if (s == ORR_OK && d.n == 0)
        s = orr_diag_set(diag, ORR_E_NODATA,
                         "nothing to compare: of the truth's positions %zu are at epochs that the product "
                         "was made from and "
                         "%zu where it has no orbit",
                         out->inputs, out->no_orbit);
    if (s == ORR_OK) s = by_satellite(&d, out, diag);
    if (s == ORR_OK && (size = calloc(d.n, sizeof *size)) == NULL)
        s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu differences", d.n);
    for (const char *system = ORR_SYSTEMS; *system != '\0' && s == ORR_OK; system++) {
        orr_compare_system *row = &out->system[out->n_systems];
        size_t n = 0;
        row->system = *system;
        for (int p = 0; p < ORR_COMPARE_PLACES; p++) {
            summarise(&d, *system, p, size, &row->place[p]);
            n += row->place[p].n;
        }
        if (n > 0) out->n_systems++;
    }
    free(size);
    free(d.list);
    if (s != ORR_OK) orr_comparison_free(out);
    return s;
}

void orr_comparison_free(orr_comparison *c)
{
    free(c->sat);
    *c = (orr_comparison){0};
}
