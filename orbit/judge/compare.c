// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/judge/compare.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/astro.h"
#include "core/constants.h"
#include "core/robust.h"
#include "orbit/dynamics/epoch_time.h"
#include "orbit/judge/velocity_filter.h"

#define ROUNDING_M (1e-3 / sqrt(12)) // of a coordinate in SP3

static const int64_t INNER_NS = 7200 * ORR_NS_PER_S, EDGE_NS = 2700 * ORR_NS_PER_S;

typedef struct differences {
    size_t n;
    orr_compare_difference *list;
} differences;

static orr_status add(differences *d, const orr_compare_difference *x, orr_diag *diag)
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

// gain: what an error of the truth's positions is multiplied by; 0 of its own velocities.
static bool truth_velocity(const grid *g, const orr_sp3_record *r, orr_time t, bool derive, orr_vec3 *v,
                           double *gain, bool *derived)
{
    *gain = 0;
    if (!derive && !isnan(r->vel_mps[0]) && !isnan(r->vel_mps[1]) && !isnan(r->vel_mps[2])) {
        *v = (orr_vec3){r->vel_mps[0], r->vel_mps[1], r->vel_mps[2]};
        return true;
    }
    if (g->step_ns == 0 || (t - g->t0) % g->step_ns != 0) return false;
    if (!orr_velocity_filter_at(&g->filter, g->pos, g->n, (size_t)((t - g->t0) / g->step_ns), v, gain))
        return false;
    *derived = true;
    return true;
}

// What is judged: a product, or precise orbits.
typedef struct subject {
    const orr_ephemeris *e;
    const orr_sp3 *sp3;
    size_t n_sp3;
    int64_t usual_ns;     // from node to node
    orr_orbit_node *node; // of precise orbits: positions of one satellite
} subject;

static int node_order(const void *a, const void *b)
{
    const orr_time x = ((const orr_orbit_node *)a)->t, y = ((const orr_orbit_node *)b)->t;
    return (x > y) - (x < y);
}

static const orr_sp3_record *record_of(const orr_sp3 *f, orr_sat sat, size_t epoch)
{
    for (size_t k = 0; k < f->n_sats; k++)
        if (f->sat[k] == sat) return &f->record[epoch * f->n_sats + k];
    return NULL;
}

static bool has_position(const orr_sp3_record *r)
{
    return r != NULL && !isnan(r->pos_m[0]) && !isnan(r->pos_m[1]) && !isnan(r->pos_m[2]);
}

// The nodes of one satellite, ascending; how many.
static size_t nodes_of(subject *u, orr_sat sat, const orr_orbit_node **list)
{
    if (u->e != NULL) return orr_ephemeris_nodes(u->e, sat, list);
    size_t n = 0;
    for (size_t i = 0; i < u->n_sp3; i++)
        for (size_t k = 0; k < u->sp3[i].n_epochs; k++)
            if (has_position(record_of(&u->sp3[i], sat, k)))
                u->node[n++] = (orr_orbit_node){.t = u->sp3[i].epoch[k], .used = true};
    qsort(u->node, n, sizeof *u->node, node_order);
    *list = u->node;
    return n;
}

static bool state_of(const subject *u, orr_sat sat, orr_time t, orr_sat_state *out)
{
    if (u->e != NULL) return orr_ephemeris_eval(u->e, sat, t, out) == ORR_OK;
    for (size_t i = 0; i < u->n_sp3; i++) {
        const orr_sp3 *f = &u->sp3[i];
        const orr_time *at =
            f->n_epochs > 0 ? bsearch(&t, f->epoch, f->n_epochs, sizeof t, orr_time_order) : NULL;
        const orr_sp3_record *r = at != NULL ? record_of(f, sat, (size_t)(at - f->epoch)) : NULL;
        if (!has_position(r)) continue;
        *out = (orr_sat_state){.sat = sat,
                               .pos_m = {r->pos_m[0], r->pos_m[1], r->pos_m[2]},
                               .vel_mps = {r->vel_mps[0], r->vel_mps[1], r->vel_mps[2]},
                               .sigma_m = NAN,
                               .sigma_mps = NAN};
        return true;
    }
    return false;
}

// Radial, along-track and cross-track parts of a difference, by position and velocity in space (ecef's axes).
static orr_vec3 along_the_orbit(orr_vec3 d, orr_vec3 pos_m, orr_vec3 v)
{
    if (isnan(v.x)) return (orr_vec3){(double)NAN, (double)NAN, (double)NAN};
    const orr_vec3 radial = orr_vec3_unit(pos_m), cross = orr_vec3_unit(orr_vec3_cross(pos_m, v)),
                   along = orr_vec3_cross(cross, radial);
    return (orr_vec3){orr_vec3_dot(d, radial), orr_vec3_dot(d, along), orr_vec3_dot(d, cross)};
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
    if (t > node[last - 1].t) return ORR_COMPARE_PLACES; // beyond the last is judged by its age
    int64_t from_first = t - node[first].t, to_last = node[last - 1].t - t;
    if (llabs(from_first) <= EDGE_NS || llabs(to_last) <= EDGE_NS) return ORR_COMPARE_EDGE;
    return from_first >= INNER_NS && to_last >= INNER_NS ? ORR_COMPARE_INNER : ORR_COMPARE_PLACES;
}

static bool passes_shadow(const subject *u, orr_sat sat)
{
    const orr_orbit_event *event;
    const size_t n = u->e != NULL ? orr_ephemeris_events(u->e, sat, &event) : 0;
    for (size_t i = 0; i < n; i++)
        if (event[i].kind == ORR_EVENT_UMBRA || event[i].kind == ORR_EVENT_PENUMBRA) return true;
    return false;
}

// Of a coordinate of the truth.
static double truth_noise_m(const subject *u, orr_sat sat)
{
    return fmax(ROUNDING_M, u->e != NULL ? orr_ephemeris_node_noise_m(u->e, sat) : 0); // NAN is no larger
}

// What a position of the truth tells of its epoch's time; epochs of the input tell as well.
static size_t read_time(const orr_sat_state *state, orr_vec3 truth, orr_time t, orr_time_reading *out)
{
    const orr_vec3 v = orr_velocity_inertial(state->pos_m, state->vel_mps);
    const double late_s = orr_vec3_dot(orr_vec3_sub(truth, state->pos_m), v) / orr_vec3_dot(v, v);
    *out = (orr_time_reading){.t = t, .sat = state->sat, .late_s = late_s};
    return isfinite(late_s) ? 1 : 0;
}

// What the epochs of one of the truth's files are off, x[0..n) its differences: moved away, or the truth's noise.
static orr_status judge_times(orr_time_reading *reading, size_t n_readings, orr_compare_difference *x,
                              size_t n, bool remove, orr_comparison *out, orr_diag *diag)
{
    orr_epoch_times times;
    const orr_status s = orr_epoch_times_find(reading, n_readings, &times);
    if (s != ORR_OK) return orr_diag_set(diag, s, "no memory for the times of %zu positions", n_readings);
    const orr_epoch_spread spread = orr_epoch_times_spread(&times, 0);
    out->late_most_s = fmax(out->late_most_s, spread.most_s);
    for (size_t i = 0; i < n && spread.epochs > 0; i++) {
        const double late_s = orr_epoch_late_s(&times, 0, x[i].t),
                     off_m = spread.rms_s * orr_vec3_norm(x[i].motion_mps);
        if (isnan(off_m)) continue;
        x[i].truth_mps = hypot(x[i].truth_mps, x[i].truth_gain * off_m);
        if (!remove) {
            x[i].truth_m = hypot(x[i].truth_m, off_m);
            continue;
        }
        x[i].pos_m = orr_vec3_axpy(late_s, x[i].motion_mps, x[i].pos_m);
        x[i].rac_m = orr_vec3_axpy(late_s, x[i].motion_rac_mps, x[i].rac_m);
    }
    const double before = (double)out->late_epochs, more = (double)spread.epochs;
    if (more > 0)
        out->late_rms_s =
            sqrt((before * out->late_rms_s * out->late_rms_s + more * spread.rms_s * spread.rms_s) /
                 (before + more));
    out->late_epochs += spread.epochs;
    orr_epoch_times_free(&times);
    return ORR_OK;
}

static orr_status collect(subject *u, const orr_sp3 *sp3, const orr_compare_options *o, differences *d,
                          orr_comparison *out, orr_diag *diag)
{
    grid g;
    const size_t first = d->n;
    size_t n_readings = 0;
    if (sp3->n_epochs == 0) return ORR_OK;
    orr_time_reading *reading = malloc(sp3->n_epochs * sp3->n_sats * sizeof *reading);
    orr_status s = reading != NULL
                       ? grid_init(sp3, &g, diag)
                       : orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu epochs", sp3->n_epochs);
    if (s != ORR_OK) {
        free(reading);
        return s;
    }
    for (size_t k = 0; k < sp3->n_sats && s == ORR_OK; k++) {
        const orr_orbit_node *node;
        if (o->sats != NULL && !orr_sat_set_has(o->sats, sp3->sat[k])) continue;
        const size_t n_nodes = nodes_of(u, sp3->sat[k], &node);
        const bool eclipsing = passes_shadow(u, sp3->sat[k]);
        const double truth_m = sqrt(3) * truth_noise_m(u, sp3->sat[k]);
        grid_fill(&g, sp3, k);
        for (size_t i = 0; i < sp3->n_epochs && s == ORR_OK; i++) {
            const orr_sp3_record *r = &sp3->record[i * sp3->n_sats + k];
            orr_time t = sp3->epoch[i];
            orr_sat_state state;
            if (!has_position(r)) continue;
            const orr_vec3 there = {r->pos_m[0], r->pos_m[1], r->pos_m[2]};
            const bool known = state_of(u, sp3->sat[k], t, &state);
            if (known && !(state.flags & ORR_EPH_PREDICTED))
                n_readings += read_time(&state, there, t, &reading[n_readings]);
            if (u->e != NULL && is_input(node, n_nodes, t)) {
                out->inputs++;
                if (!o->with_inputs) continue;
            }
            if (!known) {
                out->no_orbit++;
                continue;
            }
            orr_vec3 v = {(double)NAN, (double)NAN, (double)NAN};
            orr_compare_difference x = {.sat = sp3->sat[k],
                                        .place = place_of(node, n_nodes, t, u->usual_ns),
                                        .t = t,
                                        .pos_m = orr_vec3_sub(state.pos_m, there),
                                        .vel_mps = v};
            double gain;
            if (truth_velocity(&g, r, t, o->derive_velocity, &v, &gain, &out->vel_derived))
                x.vel_mps = orr_vec3_sub(state.vel_mps, v);
            x.eclipsing = eclipsing;
            x.sigma_m = (double)state.sigma_m;
            x.sigma_mps = (double)state.sigma_mps;
            x.truth_m = truth_m;
            x.truth_mps = gain * truth_m;
            x.motion_mps = orr_velocity_inertial(there, isnan(v.x) ? state.vel_mps : v);
            x.motion_rac_mps = along_the_orbit(x.motion_mps, there, x.motion_mps);
            x.rac_m = along_the_orbit(x.pos_m, there, x.motion_mps);
            x.truth_gain = gain;
            if (x.place == ORR_COMPARE_PLACES) out->between++;
            s = add(d, &x, diag);
        }
    }
    grid_free(&g);
    if (s == ORR_OK && d->n > first)
        s = judge_times(reading, n_readings, d->list + first, d->n - first, o->remove_times, out, diag);
    free(reading);
    for (size_t i = first; i < d->n && s == ORR_OK && o->sink != NULL; i++) o->sink(o->user, &d->list[i]);
    return s;
}

static bool counts_in(const orr_compare_difference *x, char system, int place, int light)
{
    return x->place == place && orr_sat_system(x->sat) == system &&
           (light == ORR_COMPARE_LIGHTS || x->eclipsing == (light == ORR_COMPARE_ECLIPSING));
}

// RMS of n values of which the squares add up to sum2.
static double rms(double sum2, size_t n) { return sqrt(sum2 / (double)n); }

// Statistics of one system in one place; light: ORR_COMPARE_LIGHTS for both. size: scratch of d->n doubles.
static void summarise(const differences *d, char system, int place, int light, double *size,
                      orr_compare_stats *out)
{
    double sum2 = 0, vel2 = 0, sigma2 = 0, vel_sigma2 = 0, truth2 = 0, vel_truth2 = 0;
    const double none = (double)NAN;
    orr_vec3 rac2 = {0};
    size_t n_rac = 0;
    orr_sat_set seen = {0};
    *out = (orr_compare_stats){.rms_m = none,
                               .p95_m = none,
                               .max_m = none,
                               .vel_rms_mps = none,
                               .sigma_rms_m = none,
                               .vel_sigma_rms_mps = none,
                               .truth_rms_m = none,
                               .vel_truth_rms_mps = none,
                               .error_over_sigma = none,
                               .vel_error_over_sigma = none};
    for (size_t i = 0; i < d->n; i++) {
        const orr_compare_difference *x = &d->list[i];
        if (!counts_in(x, system, place, light)) continue;
        double r2 = orr_vec3_dot(x->pos_m, x->pos_m);
        size[out->n++] = sqrt(r2);
        sum2 += r2;
        sigma2 += x->sigma_m * x->sigma_m;
        truth2 += x->truth_m * x->truth_m;
        out->mean_m = orr_vec3_add(out->mean_m, x->pos_m);
        if (!isnan(x->rac_m.x)) {
            const orr_vec3 q = x->rac_m;
            out->rac_mean_m = orr_vec3_add(out->rac_mean_m, q);
            rac2 = orr_vec3_add(rac2, (orr_vec3){q.x * q.x, q.y * q.y, q.z * q.z});
            n_rac++;
        }
        if (!orr_sat_set_has(&seen, x->sat)) {
            orr_sat_set_add(&seen, x->sat);
            out->satellites++;
        }
        if (isnan(x->vel_mps.x)) continue;
        vel2 += orr_vec3_dot(x->vel_mps, x->vel_mps);
        vel_sigma2 += x->sigma_mps * x->sigma_mps;
        vel_truth2 += x->truth_mps * x->truth_mps;
        out->n_vel++;
    }
    if (out->n_vel > 0) {
        out->vel_rms_mps = rms(vel2, out->n_vel);
        out->vel_sigma_rms_mps = rms(vel_sigma2, out->n_vel);
        out->vel_truth_rms_mps = rms(vel_truth2, out->n_vel);
        out->vel_error_over_sigma = out->vel_rms_mps / hypot(out->vel_sigma_rms_mps, out->vel_truth_rms_mps);
    }
    if (out->n == 0) return;
    const double per = n_rac > 0 ? 1.0 / (double)n_rac : (double)NAN;
    out->rac_mean_m = orr_vec3_scale(per, out->rac_mean_m);
    out->rac_rms_m = (orr_vec3){sqrt(rac2.x * per), sqrt(rac2.y * per), sqrt(rac2.z * per)};
    out->rms_m = rms(sum2, out->n);
    out->sigma_rms_m = rms(sigma2, out->n);
    out->truth_rms_m = rms(truth2, out->n);
    out->error_over_sigma = out->rms_m / hypot(out->sigma_rms_m, out->truth_rms_m);
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
        const orr_compare_difference *x = &d->list[i];
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

static orr_status compare(subject *u, const orr_sp3 *truth, size_t n_truths,
                          const orr_compare_options *options, orr_comparison *out, orr_diag *diag)
{
    differences d = {0};
    double *size = NULL;
    *out = (orr_comparison){0};
    orr_status s = ORR_OK;
    for (size_t i = 0; i < n_truths && s == ORR_OK; i++) s = collect(u, &truth[i], options, &d, out, diag);
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
            summarise(&d, *system, p, ORR_COMPARE_LIGHTS, size, &row->place[p]);
            for (int light = 0; light < ORR_COMPARE_LIGHTS; light++)
                summarise(&d, *system, p, light, size, &row->light[light][p]);
            n += row->place[p].n;
        }
        if (n > 0) out->n_systems++;
    }
    free(size);
    free(d.list);
    if (s != ORR_OK) orr_comparison_free(out);
    return s;
}

orr_status orr_compare(const orr_ephemeris *e, const orr_sp3 *truth, size_t n_truths,
                       const orr_compare_options *options, orr_comparison *out, orr_diag *diag)
{
    subject u = {.e = e, .usual_ns = (int64_t)(orr_ephemeris_node_step_s(e) * 1e9)};
    return compare(&u, truth, n_truths, options, out, diag);
}

orr_status orr_compare_sp3(const orr_sp3 *list, size_t n, const orr_sp3 *truth, size_t n_truths,
                           const orr_compare_options *options, orr_comparison *out, orr_diag *diag)
{
    subject u = {.sp3 = list, .n_sp3 = n, .usual_ns = INT64_MAX / 4};
    size_t most = 0;
    *out = (orr_comparison){0};
    for (size_t i = 0; i < n; i++) {
        most += list[i].n_epochs;
        for (size_t k = 1; k < list[i].n_epochs; k++) {
            const int64_t step = list[i].epoch[k] - list[i].epoch[k - 1];
            if (step > 0 && step < u.usual_ns) u.usual_ns = step;
        }
    }
    u.node = calloc(most + 1, sizeof *u.node);
    orr_status s = u.node != NULL ? compare(&u, truth, n_truths, options, out, diag)
                                  : orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu epochs", most);
    free(u.node);
    return s;
}

void orr_comparison_free(orr_comparison *c)
{
    free(c->sat);
    *c = (orr_comparison){0};
}
