// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/track.h"

#include <stdlib.h>
#include <string.h>

#define WIDE_GAP_S 10800.0
#define OPEN_END 100.0
#define SAME_INSTANT_S 1e-6 // SP3 writes epochs to 1e-8 s; filter steps are a hundred seconds

void orr_track_free(orr_track *t)
{
    free(t->at);
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
    for (size_t k = 1; k < t->n && !c->eop_known; k++) {
        bool precise = false;
        for (size_t i = t->at[k].first; i < t->at[k].first + t->at[k].n; i++)
            precise = precise || (!list[i].bridge && !list[i].superseded);
        if (!precise && k + 1 < t->n) continue;
        const double times = (t->at[k].t_s - t->at[from].t_s) / WIDE_GAP_S;
        const double noise = fmax(times * times * times * times, precise ? 1 : OPEN_END);
        for (size_t j = from; j < k; j++) t->at[j].noise = noise;
        from = k;
    }
}

orr_status orr_track_init(const orr_track_context *c, double from_s, double to_s, double node_step_s,
                          const orr_node *list, size_t n, orr_track *out)
{
    *out = (orr_track){0};
    const int64_t span_ns = orr_track_ns(to_s) - orr_track_ns(from_s);
    size_t intervals = choose_intervals(span_ns, node_step_s, c->options->grid_s, &out->samples_per_segment);
    out->n_samples = intervals + 1;
    out->step_s = (double)span_ns / (double)intervals * 1e-9;
    out->at = calloc(out->n_samples + n, sizeof *out->at);
    if (out->at == NULL) return ORR_E_MEMORY;
    size_t i = 0, k = 0;
    while (i < n && list[i].t_s < from_s - SAME_INSTANT_S) i++;
    while (k < out->n_samples || (i < n && list[i].t_s <= to_s + SAME_INSTANT_S)) {
        double sample_s = k < out->n_samples ? from_s + out->step_s * (double)k : HUGE_VAL;
        double node_s = i < n && list[i].t_s <= to_s + SAME_INSTANT_S ? list[i].t_s : HUGE_VAL;
        orr_instant *at = &out->at[out->n++];
        at->t_s = sample_s < node_s ? sample_s : node_s;
        if (fabs(sample_s - node_s) < SAME_INSTANT_S) at->t_s = node_s;
        if (sample_s <= at->t_s + SAME_INSTANT_S) {
            at->sample = true;
            k++;
        }
        at->first = i;
        while (i < n && list[i].t_s <= at->t_s + SAME_INSTANT_S) {
            at->n++;
            i++;
        }
    }
    widen_gaps(c, list, out);
    return ORR_OK;
}

// Axes of f0 at an instant, as a matrix to integration axes.
static orr_mat3 f0_axes(const orr_track_context *c, double t_s, orr_vec3 r, orr_vec3 v)
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
    orr_vec3 radial = orr_vec3_unit(r), cross = orr_vec3_unit(orr_vec3_cross(r, v)),
             along = orr_vec3_cross(cross, radial);
    return (orr_mat3){
        {{radial.x, along.x, cross.x}, {radial.y, along.y, cross.y}, {radial.z, along.z, cross.z}}};
}

// Variational equations d_eta' = d_V, d_V' = G d_eta + B f0 (33)-(34) over one step, all nine columns by one
// classical Runge-Kutta step with the gradient at begin, middle and end. At 150 s it errs by 4e-11 of the
// deviation.
static void variational_step(const orr_mat3 G[3], const orr_mat3 B[3], double h, double F[6][ORR_NX])
{
    static const double along[4] = {0, 0.5, 0.5, 1}, weight[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    static const int where[4] = {0, 1, 1, 2};
    for (int col = 0; col < ORR_NX; col++) {
        double y0[6] = {0}, sum[6] = {0}, k[6] = {0};
        if (col < 6) y0[col] = 1;
        for (int s = 0; s < 4; s++) {
            double y[6];
            for (int i = 0; i < 6; i++) y[i] = y0[i] + along[s] * h * k[i];
            const orr_mat3 *g = &G[where[s]], *b = &B[where[s]];
            for (int i = 0; i < 3; i++) {
                k[i] = y[3 + i];
                k[3 + i] = g->m[i][0] * y[0] + g->m[i][1] * y[1] + g->m[i][2] * y[2];
                if (col >= 6) k[3 + i] += b->m[i][col - 6];
            }
            for (int i = 0; i < 6; i++) sum[i] += weight[s] * k[i];
        }
        for (int i = 0; i < 6; i++) F[i][col] = y0[i] + h * sum[i];
    }
}

static void transition_between(const orr_track_context *c, double t_s, double h, orr_vec3 r0, orr_vec3 v0,
                               orr_vec3 r1, orr_vec3 v1, orr_transition *out)
{
    // Middle of the step by the quintic through both ends' states and accelerations: metres off at most.
    orr_vec3 a0 = orr_integrator_acceleration(c->integrator, t_s, r0);
    orr_vec3 a1 = orr_integrator_acceleration(c->integrator, t_s + h, r1);
    orr_vec3 rm = orr_vec3_scale(0.5, orr_vec3_add(r0, r1));
    rm = orr_vec3_axpy(5.0 / 32 * h, orr_vec3_sub(v0, v1), rm);
    rm = orr_vec3_axpy(h * h / 64, orr_vec3_add(a0, a1), rm);
    orr_vec3 vm = orr_vec3_scale(15.0 / 8 / h, orr_vec3_sub(r1, r0));
    vm = orr_vec3_axpy(-7.0 / 16, orr_vec3_add(v0, v1), vm);
    vm = orr_vec3_axpy(h / 32, orr_vec3_sub(a1, a0), vm);

    orr_mat3 G[3] = {orr_force_central_gradient(r0), orr_force_central_gradient(rm),
                     orr_force_central_gradient(r1)};
    orr_mat3 B[3] = {f0_axes(c, t_s, r0, v0), f0_axes(c, t_s + h / 2, rm, vm), f0_axes(c, t_s + h, r1, v1)};
    variational_step(G, B, h, out->F);
    out->h_s = h;
    out->axes = B[1];
}

static const orr_reference *reference_at(const orr_instant *at, const orr_reference *reference)
{
    for (size_t i = at->first; i < at->first + at->n; i++)
        if (reference[i].valid) return &reference[i];
    return NULL;
}

orr_status orr_track_linearise(const orr_track_context *c, const orr_reference *reference, orr_track *t)
{
    size_t k0 = 0;
    while (k0 < t->n && reference_at(&t->at[k0], reference) == NULL) k0++;
    if (k0 == t->n) return ORR_E_NODATA;
    const orr_reference *start = reference_at(&t->at[k0], reference);
    orr_vec3 r = start->r_m, v = start->v_mps;
    orr_status s = orr_integrate(c->integrator, t->at[k0].t_s, t->at[0].t_s - t->at[k0].t_s, &r, &v);
    if (s != ORR_OK) return s;
    for (size_t k = 0; k < t->n; k++) {
        orr_instant *at = &t->at[k];
        const orr_reference *restart = reference_at(at, reference);
        memset(at->shift, 0, sizeof at->shift);
        if (restart != NULL && k > 0) {
            orr_vec3 dr = orr_vec3_sub(r, restart->r_m), dv = orr_vec3_sub(v, restart->v_mps);
            memcpy(at->shift, (double[6]){dr.x, dr.y, dr.z, dv.x, dv.y, dv.z}, sizeof at->shift);
            r = restart->r_m, v = restart->v_mps;
        }
        at->r_m = r, at->v_mps = v;
        at->axes = f0_axes(c, at->t_s, r, v);
        if (k + 1 == t->n) break;
        double h = t->at[k + 1].t_s - at->t_s;
        s = orr_integrate(c->integrator, at->t_s, h, &r, &v);
        if (s != ORR_OK) return s;
        transition_between(c, at->t_s, h, at->r_m, at->v_mps, r, v, &at->next);
    }
    return ORR_OK;
}

orr_vec3 orr_track_measured(const orr_track_context *c, const orr_instant *at, const orr_node *n)
{
    orr_sky_point p;
    orr_sky_force_point(c->sky, n->t_s, &p);
    return orr_vec3_sub(orr_mat3_apply_t(&p.R, n->ecef_m), at->r_m);
}
