// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/track.h"

#include <stdlib.h>
#include <string.h>

#define STOP_S 900.0 // between instants without nodes, at most
#define WIDE_GAP_S 10800.0
#define OPEN_END 100.0
#define OPEN_END_OF_REFERENCE 100.0 // three hours of 2010-182 are 3.6 sigma off without, 0.9 with it
#define SAME_INSTANT_S 1e-6         // SP3 writes epochs to 1e-8 s; filter steps are a hundred seconds

void orr_track_free(orr_track *t)
{
    free(t->at);
    free(t->grid);
    *t = (orr_track){0};
}

// Samples per segment: six where the count allows, else the nearest number that divides it.
static size_t choose_segment(size_t intervals)
{
    static const size_t liked[] = {ORR_SAMPLES_PER_SEGMENT, 5, 4, 8, 7, 3, 2};
    for (size_t i = 0; i < sizeof liked / sizeof liked[0]; i++)
        if (intervals % liked[i] == 0) return liked[i];
    return 0;
}

// Number of sample intervals over a span: the step divides node_step_s when the span is a multiple of it, so
// that nodes fall on samples; else the least number whose step is a whole number of nanoseconds, as the
// product wants it. A span of whole milliseconds has one at most a quarter above the least (2^a 5^b, a and b
// up to 6).
static size_t choose_intervals(int64_t span_ns, double node_step_s, double grid_s, size_t *per_segment)
{
    const double span_s = (double)span_ns * 1e-9;
    double steps = node_step_s > 0 ? span_s / node_step_s : 0;
    if (steps >= 1 && fabs(steps - round(steps)) * node_step_s < SAME_INSTANT_S) {
        size_t n = (size_t)round(steps) * (size_t)ceil(node_step_s / grid_s - 1e-9);
        *per_segment = choose_segment(n);
        if (*per_segment > 0 && span_ns % (int64_t)n == 0) return n;
    }
    size_t least = (size_t)fmax(ceil(span_s / grid_s - 1e-9), 2);
    for (size_t n = least; n <= 4 * least; n++) {
        *per_segment = choose_segment(n);
        if (*per_segment > 0 && span_ns % (int64_t)n == 0) return n;
    }
    *per_segment = ORR_SAMPLES_PER_SEGMENT;
    double segments = ceil(span_s / (grid_s * ORR_SAMPLES_PER_SEGMENT) - 1e-9);
    return (size_t)(segments > 1 ? segments : 1) * ORR_SAMPLES_PER_SEGMENT;
}

// Without Earth-orientation data the secular pole is off by 0.1-0.2": positions seem to swing by metres once
// a day, an acceleration of 1e-7 m/s^2 that f0 follows from node to node but that nothing tells inside a gap.
// Measured on 2024-035 with gaps of 1 to 8 h, errors grow faster than the random walk by the square of the
// gap's length beyond three hours; with the true pole they do not. Beyond the last node nothing holds the
// orbit on the far side: there errors are five to fifteen times the random walk's from the first half hour on
// (2009-091, 2010-182; with an ERP file, on 2008-279, they are not).
static void widen_gaps(const orr_track_context *c, const orr_node *list, orr_track *t)
{
    size_t from = 0;
    for (size_t k = 0; k < t->n; k++) t->at[k].noise = 1;
    for (size_t k = 1; k < t->n; k++) {
        bool precise = false;
        for (size_t i = t->at[k].first; i < t->at[k].first + t->at[k].n; i++)
            precise = precise || (!list[i].bridge && !list[i].superseded);
        if (!precise && k + 1 < t->n) continue;
        if (c->eop_known) { // beyond the last node the reference is what errs: pressure that is not ECOM's
            for (size_t j = from; j < k && !precise && c->noise.nx == ORR_NX; j++)
                t->at[j].noise = OPEN_END_OF_REFERENCE;
            from = k;
            continue;
        }
        const double times = (t->at[k].t_s - t->at[from].t_s) / WIDE_GAP_S;
        const double noise = fmax(times * times * times * times, precise ? 1 : OPEN_END);
        for (size_t j = from; j < k; j++) t->at[j].noise = noise;
        from = k;
    }
}

// Instants without nodes, as far apart as STOP_S at most, in the step from grid point g0 to g1.
static void fill(orr_track *t, size_t g0, size_t g1)
{
    const double span = t->grid[g1].t_s - t->grid[g0].t_s;
    const size_t parts = (size_t)fmax(ceil(span / STOP_S - 1e-6), 1);
    size_t last = g0;
    for (size_t k = 1; k < parts; k++) {
        const double want = t->grid[g0].t_s + span * (double)k / (double)parts;
        size_t g = last + 1;
        while (g + 1 < g1 && fabs(t->grid[g + 1].t_s - want) < fabs(t->grid[g].t_s - want)) g++;
        if (g >= g1) break;
        t->at[t->n++] = (orr_instant){.t_s = t->grid[g].t_s, .grid = g};
        last = g;
    }
}

size_t orr_track_window(const orr_track_context *c, double t_s)
{
    size_t w = 0;
    if (c->reference != NULL)
        while (w + 1 < c->reference->n_windows && t_s >= c->reference->border_s[w + 1] - SAME_INSTANT_S) w++;
    return w;
}

static bool usable(const orr_node *n) { return !n->superseded && !n->bridge; }

// Whether from node i on the file is another than that of the node before, at the same instant or a later
// one.
static bool other_file(const orr_node *list, size_t i)
{
    size_t k = i;
    if (!usable(&list[i])) return false;
    while (k > 0 && !usable(&list[k - 1])) k--;
    return k > 0 && list[k - 1].source != list[i].source && list[i].rank > list[k - 1].rank;
}

// The instants of one point of the grid: one, or two where a file ends and the next one begins.
static void stop(const orr_track_context *c, const orr_node *list, size_t first, size_t n, size_t g,
                 orr_track *t)
{
    const double t_s = t->grid[g].t_s;
    size_t split = first;
    while (split < first + n && !other_file(list, split)) split++;
    const bool step = c->noise.nx == ORR_NX && split < first + n;
    if (step && split > first) {
        t->at[t->n++] = (orr_instant){.t_s = t_s, .grid = g, .first = first, .n = split - first};
        n -= split - first;
        first = split;
    }
    t->at[t->n++] = (orr_instant){.t_s = t_s, .grid = g, .first = first, .n = n, .step = step};
}

orr_status orr_track_init(const orr_track_context *c, double from_s, double to_s, double node_step_s,
                          const orr_node *list, size_t n, orr_track *out)
{
    *out = (orr_track){0};
    const int64_t span_ns = orr_track_ns(to_s) - orr_track_ns(from_s);
    size_t intervals = choose_intervals(span_ns, node_step_s, c->options->grid_s, &out->samples_per_segment);
    out->n_samples = intervals + 1;
    out->step_s = (double)span_ns / (double)intervals * 1e-9;
    size_t i = 0, k = 0, inside = 0;
    while (i < n && list[i].t_s < from_s - SAME_INSTANT_S) i++;
    for (size_t j = i; j < n && list[j].t_s <= to_s + SAME_INSTANT_S; j++) inside++;
    out->grid = malloc((out->n_samples + inside) * sizeof *out->grid);
    const size_t stops = 2 * inside + 4 + (size_t)((to_s - from_s) / (STOP_S / 2));
    out->at = malloc(stops * sizeof *out->at);
    if (out->at == NULL || out->grid == NULL) {
        orr_track_free(out);
        return ORR_E_MEMORY;
    }
    size_t last_stop = 0;
    while (k < out->n_samples || (i < n && list[i].t_s <= to_s + SAME_INSTANT_S)) {
        double sample_s = k < out->n_samples ? from_s + out->step_s * (double)k : HUGE_VAL;
        double node_s = i < n && list[i].t_s <= to_s + SAME_INSTANT_S ? list[i].t_s : HUGE_VAL;
        const size_t g = out->n_grid++;
        orr_grid_point *at = &out->grid[g];
        *at = (orr_grid_point){.t_s = sample_s < node_s ? sample_s : node_s};
        if (fabs(sample_s - node_s) < SAME_INSTANT_S) at->t_s = node_s;
        if (sample_s <= at->t_s + SAME_INSTANT_S) {
            at->sample = true;
            k++;
        }
        const size_t first = i;
        while (i < n && list[i].t_s <= at->t_s + SAME_INSTANT_S) i++;
        const bool end = k == out->n_samples && !(i < n && list[i].t_s <= to_s + SAME_INSTANT_S);
        if (i == first && g > 0 && !end) continue;
        if (g > 0) fill(out, last_stop, g);
        stop(c, list, first, i - first, g, out);
        last_stop = g;
    }
    for (size_t j = 0; j < out->n; j++) {
        out->at[j].window = orr_track_window(c, out->at[j].t_s);
        out->at[j].renew = j > 0 && out->at[j].window != out->at[j - 1].window;
    }
    widen_gaps(c, list, out);
    return ORR_OK;
}

orr_mat3 orr_track_axes(const orr_track_context *c, double t_s, orr_vec3 r, orr_vec3 v)
{
    switch (c->options->f0_axes) {
    case ORR_F0_INERTIAL:
        return orr_mat3_identity();
    case ORR_F0_ECEF: {
        orr_sky_point p;
        orr_sky_force_point(c->sky, t_s, &p);
        return orr_mat3_transpose(&p.R);
    }
    case ORR_F0_RTN:
        break;
    }
    return orr_orbit_axes(r, v);
}

void orr_track_use_window(const orr_track_context *c, size_t window, const double *change)
{
    for (int i = 0; i < ORR_ECOM_TERMS && c->reference != NULL; i++)
        c->force->ecom_nmps2[i] = c->reference->ecom_nmps2[window][i] + (change != NULL ? change[i] : 0);
}

// The step that departs from grid point g and arrives at (r1, v1).
static void linear_step(const orr_track_context *c, orr_grid_point *a, double h, orr_vec3 r1, orr_vec3 v1)
{
    const orr_orbit_step s = {a->t_s, h, a->r_m, a->v_mps, r1, v1};
    orr_vec3 rm, vm;
    orr_orbit_step_middle(&s, &rm, &vm);
    const orr_mat3 B[3] = {orr_track_axes(c, a->t_s, a->r_m, a->v_mps),
                           orr_track_axes(c, a->t_s + h / 2, rm, vm), orr_track_axes(c, a->t_s + h, r1, v1)};
    orr_variational_step(c->force, c->sky, &s, B, a->F);
    a->axes = B[1];
}

static const orr_reference *reference_at(const orr_instant *at, const orr_reference *reference)
{
    for (size_t i = at->first; i < at->first + at->n; i++)
        if (reference[i].valid) return &reference[i];
    return NULL;
}

#define SHADOW_MARGIN_S 900.0 // after a satellite leaves the shadow, and before

// Whether the satellite is near the Earth's shadow on the step from g on, by a circle through where it is.
static bool near_shadow(const orr_track_context *c, const orr_grid_point *g)
{
    orr_sky_point p;
    orr_sky_force_point(c->sky, g->t_s, &p);
    const double rate = orr_vec3_norm(g->v_mps) / orr_vec3_norm(g->r_m);
    for (int k = -1; k <= 1; k++) {
        const double turn = k * SHADOW_MARGIN_S * rate;
        const orr_vec3 r = orr_vec3_axpy(sin(turn) / rate, g->v_mps, orr_vec3_scale(cos(turn), g->r_m));
        if (orr_force_sunlight_fast(r, p.sun_m) < 0.5) return true;
    }
    return false;
}

// From instant k to the next one: the grid's states and the transition.
static orr_status go_on(const orr_track_context *c, orr_track *t, size_t k, orr_vec3 *r, orr_vec3 *v)
{
    orr_instant *at = &t->at[k];
    orr_transition_start(&at->next);
    for (size_t g = at->grid; g < t->at[k + 1].grid; g++) {
        orr_grid_point *a = &t->grid[g];
        const double h = t->grid[g + 1].t_s - a->t_s;
        a->r_m = *r, a->v_mps = *v;
        orr_status s = orr_integrate(c->integrator, a->t_s, h, r, v);
        if (s != ORR_OK) return s;
        linear_step(c, a, h, *r, *v);
        a->near_shadow = c->noise.nx == ORR_NX && near_shadow(c, a);
        orr_transition_append(&at->next, a->F, &a->axes, h, at->noise * c->noise.qf_m2ps5, c->noise.qv_m2ps3,
                              a->near_shadow);
    }
    return ORR_OK;
}

orr_status orr_track_linearise(const orr_track_context *c, const orr_reference *reference, orr_track *t)
{
    size_t k0 = 0;
    while (k0 < t->n && reference_at(&t->at[k0], reference) == NULL) k0++;
    if (k0 == t->n) return ORR_E_NODATA;
    const orr_reference *start = reference_at(&t->at[k0], reference);
    orr_vec3 r = start->r_m, v = start->v_mps;
    orr_track_use_window(c, t->at[k0].window, NULL);
    orr_status s = orr_integrate(c->integrator, t->at[k0].t_s, t->at[0].t_s - t->at[k0].t_s, &r, &v);
    if (s != ORR_OK) return s;
    for (size_t k = 0; k < t->n; k++) {
        orr_instant *at = &t->at[k];
        const orr_reference *restart = reference_at(at, reference);
        memset(at->shift, 0, sizeof at->shift);
        if (restart != NULL && k > 0) {
            orr_vec3 dr = orr_vec3_sub(r, restart->r_m), dv = orr_vec3_sub(v, restart->v_mps);
            memcpy(at->shift, (double[6]){dr.x, dr.y, dr.z, dv.x, dv.y, dv.z}, 6 * sizeof at->shift[0]);
            r = restart->r_m, v = restart->v_mps;
        }
        if (at->renew)
            for (int i = 0; i < ORR_ECOM_TERMS; i++)
                at->shift[ORR_PARTIAL_ECOM + i] = c->reference->ecom_nmps2[t->at[k - 1].window][i] -
                                                  c->reference->ecom_nmps2[at->window][i];
        at->r_m = r, at->v_mps = v;
        t->grid[at->grid].r_m = r, t->grid[at->grid].v_mps = v;
        if (k + 1 == t->n) break;
        orr_track_use_window(c, at->window, NULL);
        s = go_on(c, t, k, &r, &v);
        if (s != ORR_OK) return s;
    }
    return ORR_OK;
}

orr_vec3 orr_track_measured(const orr_track_context *c, const orr_instant *at, const orr_node *n)
{
    orr_sky_point p;
    orr_sky_force_point(c->sky, n->t_s, &p);
    return orr_vec3_sub(orr_mat3_apply_t(&p.R, n->ecef_m), at->r_m);
}
