// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/satellite_arcs.h"

#include <stdlib.h>

#include "core/array.h"
#include "orbit/smooth/join.h"
#include "orbit/smooth/noise_choice.h"
#include "orbit/smooth/samples.h"

#define TELLING_NODES 4 // three are met whatever they are: position, velocity and f0
// Files that differ by metres differ by less; station keeping takes ten times as much.
#define LEAST_PUSH_MPS 0.01
#define MAX_APART_M 1.0 // arcs that come nearer than this share an instant; else the manoeuvre leaves a hole

// Ratio of real to formal sigma: residuals of the used nodes against their formal covariance sigma^2 E - P.
// Only the ratio qf / sigma^2 shapes the orbit, so their common scale is free and has to come from the data.
// Two or three nodes, which an orbit meets whatever they are, tell nothing: then it stays as it was.
static double real_over_formal(const orr_satellite_work *w, const orr_track *t, const orr_verdict *verdict)
{
    double chi2 = 0, formal2 = 0;
    size_t instants = 0;
    for (size_t k = 0; k < t->n; k++) {
        const orr_instant *at = &t->at[k];
        bool any = false;
        for (size_t i = at->first; i < at->first + at->n; i++) {
            const orr_node *node = &w->node[i];
            if (!orr_node_counts(node) || verdict[i].rejected) continue;
            orr_vec3 x = orr_vec3_make(at->state.x[0], at->state.x[1], at->state.x[2]);
            orr_vec3 e = orr_vec3_sub(orr_track_measured(w->c, at, node), x);
            double weight = 1.0 / (node->sigma_m * node->sigma_m);
            chi2 += weight * orr_vec3_dot(e, e);
            for (int j = 0; j < 3; j++) formal2 += 1.0 - weight * orr_gauss_kept_P(&at->state, j, j);
            any = true;
        }
        instants += any;
    }
    return instants >= TELLING_NODES && formal2 > 0 ? sqrt(chi2 / formal2) : w->scale;
}

// Steps of velocity at noon, and stretches in which the orbit is noisier near the Earth's shadow.
static orr_status tell_file_noise(orr_satellite_work *w, const orr_track *t)
{
    orr_status s = ORR_OK;
    size_t since = t->n;
    bool shadow = false;
    for (size_t k = 0; k < t->n; k++) shadow = shadow || t->at[k].next.near_shadow;
    for (size_t k = 0; k < t->n && s == ORR_OK; k++) {
        const orr_instant *at = &t->at[k];
        if (at->pulse) {
            double step[6];
            orr_join_step(at, step);
            s = orr_event_add(&w->events, ORR_EVENT_NOON_STEP, orr_satellite_time(w, at->t_s),
                              orr_satellite_time(w, at->t_s),
                              orr_vec3_norm((orr_vec3){step[3], step[4], step[5]}));
        }
        const double before = since < t->n ? t->at[since].shadow : 0, now = k + 1 < t->n ? at->shadow : 0;
        if (s != ORR_OK || !shadow || fabs(now - before) <= 0) continue;
        if (before > 0)
            s = orr_event_add(&w->events, ORR_EVENT_SHADOW_NOISE, orr_satellite_time(w, t->at[since].t_s),
                              orr_satellite_time(w, at->t_s), before + 1);
        since = now > 0 ? k : t->n;
    }
    return s;
}

// Samples of the smoothed track as an arc of the solution.
static orr_status emit_arc(orr_satellite_work *w, orr_track *t, const orr_verdict *verdict)
{
    const size_t first = 0, last = t->n - 1;
    const double scale = w->c->noise.nx == ORR_NX ? w->scale : real_over_formal(w, t, verdict);
    w->scale = scale;
    const double noise_m =
        scale * (w->c->noise.nx == ORR_NX ? w->c->options->sigma_m : w->c->options->plain.sigma_m);
    w->out->node_noise_m = fmax(w->out->node_noise_m, noise_m);
    if (!ORR_ARRAY_GROW(w->out->arc, w->out->n_arcs)) return ORR_E_MEMORY;
    orr_orbit_arc arc = {.t0 = orr_satellite_time(w, t->at[first].t_s),
                         .step_s = t->step_s,
                         .samples_per_segment = t->samples_per_segment};
    arc.sample = calloc(t->n_samples, sizeof *arc.sample);
    if (arc.sample == NULL) return ORR_E_MEMORY;
    orr_status s = orr_samples_make(w->c, w->node, w->table->step_s, t, verdict, scale, &arc);
    w->out->arc[w->out->n_arcs++] = arc;
    if (s == ORR_OK) s = tell_file_noise(w, t);
    if (s == ORR_OK) s = orr_events_eclipses(w->c->sky, &arc, &w->events);

    // Nodes: residuals, gaps, joints of files.
    const orr_node *used = NULL;
    for (size_t k = first; k <= last && s == ORR_OK; k++) {
        const orr_instant *at = &t->at[k];
        orr_sky_point p;
        if (at->n > 0) orr_sky_at(w->c->sky, at->t_s, &p);
        for (size_t i = at->first; i < at->first + at->n && s == ORR_OK; i++) {
            const orr_node *node = &w->node[i];
            orr_orbit_node *o = &w->out->node[i];
            o->residual_m = orr_vec3_sub(orr_mat3_apply(&p.R, orr_smoothed_r(at)), node->ecef_m);
            if (i > 0 && w->node[i - 1].t == node->t && node->source != w->node[i - 1].source) {
                double jump = orr_vec3_norm(orr_vec3_sub(node->ecef_m, w->node[i - 1].ecef_m));
                s = orr_event_add(&w->events, ORR_EVENT_DAY_JUMP, node->t, node->t, jump);
            } else if (verdict[i].jump_m > 0) {
                s = orr_event_add(&w->events, ORR_EVENT_DAY_JUMP, node->t, node->t, verdict[i].jump_m);
            }
            if (!orr_node_counts(node) || s != ORR_OK) continue;
            if (verdict[i].rejected) {
                w->report->nodes_rejected++;
                s = orr_event_add(&w->events, ORR_EVENT_OUTLIER, node->t, node->t,
                                  orr_vec3_norm(o->residual_m));
                continue;
            }
            o->used = 1;
            w->report->nodes_used++;
            w->report->residual_m2 += orr_vec3_dot(o->residual_m, o->residual_m);
            if (used != NULL && (orr_samples_flags(w->c, w->table->step_s, used, node) & ORR_EPH_GAP))
                s = orr_event_add(&w->events, ORR_EVENT_GAP, used->t, node->t, 0);
            used = node;
        }
    }
    return s;
}

// Where a gap ends the orbit may begin anew, for once: what that would gain is the square of how ill the orbits before and after it
// agree, over the six unknowns that would be free.
static orr_status strain_gaps(orr_satellite_work *w, orr_track *t, const orr_verdict *verdict)
{
    const orr_node *before = NULL;
    orr_fresh_start *fresh = NULL;
    orr_status s = ORR_OK;
    for (size_t k = 0; k < t->n && s == ORR_OK; k++) {
        t->at[k].strain = 0;
        for (size_t i = t->at[k].first; i < t->at[k].first + t->at[k].n && s == ORR_OK; i++) {
            const orr_node *node = &w->node[i];
            if (!orr_node_counts(node) || verdict[i].rejected) continue;
            const bool gap = before != NULL &&
                             (orr_samples_flags(w->c, w->table->step_s, before, node) & ORR_EPH_GAP) != 0;
            before = node;
            if (!gap) continue;
            if (fresh == NULL) {
                fresh = calloc(t->n, sizeof *fresh);
                if (fresh == NULL) return ORR_E_MEMORY;
                orr_filter_range(w->c, w->node, verdict, t, 0, t->n - 1);
                s = orr_smooth_range(w->c, verdict, t, 0, t->n - 1, fresh);
            }
            if (fresh[k].told) t->at[k].strain = sqrt(fmax(fresh[k].gain, 0) / 6) / w->scale;
        }
    }
    free(fresh);
    return s;
}

// Filter and smoother over the whole track, with noise as large as it is. smoothed: it is already, with the noise as it was
// before.
static orr_status settle(orr_satellite_work *w, orr_track *t, const orr_verdict *verdict, bool smoothed)
{
    const double step_s = w->table->step_s;
    if (w->c->noise.nx == ORR_NX) {
        w->c->noise.factor = w->factor;
        const orr_noise_choice choice = orr_noise_choose(w->c, w->node, verdict, t, smoothed, step_s);
        w->scale = choice.scale;
        w->c->noise.factor = choice.factor;
        if (w->evidence != NULL)
            orr_file_evidence_add(w->c, w->node, verdict, t, step_s, w->n_files, w->evidence);
        smoothed = smoothed && !orr_noise_ratio_is_sought(step_s);
    }
    orr_status s = ORR_OK;
    if (!smoothed) {
        orr_filter_range(w->c, w->node, verdict, t, 0, t->n - 1);
        s = orr_smooth_range(w->c, verdict, t, 0, t->n - 1, NULL);
    }
    if (s == ORR_OK && w->c->noise.nx == ORR_NX) s = strain_gaps(w, t, verdict);
    if (s == ORR_OK && w->evidence != NULL)
        orr_file_ends_add(w->c, w->node, w->n, verdict, t, w->scale, w->n_files, w->evidence);
    return s;
}

// One arc again on a grid of its own, from from_s to to_s, which may reach beyond its nodes list[i0..i1).
static orr_status smooth_alone(orr_satellite_work *w, double from_s, double to_s, size_t i0, size_t i1,
                               const orr_verdict *verdict)
{
    orr_track t;
    orr_status s = orr_track_init(w->c, from_s, to_s, w->table->step_s, w->node, i1, &t);
    if (s != ORR_OK) return s;
    for (size_t k = 0; k < t.n; k++) // nodes before the arc belong to another
        if (t.at[k].first < i0) {
            size_t skip = i0 - t.at[k].first;
            t.at[k].n = t.at[k].n > skip ? t.at[k].n - skip : 0;
            t.at[k].first = i0;
        }
    s = orr_track_linearise(w->c, w->ref, &t);
    if (s == ORR_OK) s = settle(w, &t, verdict, false);
    if (s == ORR_OK) s = emit_arc(w, &t, verdict);
    orr_track_free(&t);
    return s;
}

// How far a node is from the orbit of the nearest arc, carried on to its instant; 0 where there is none near
// enough to tell.
static double distance_from_orbit(const orr_satellite_work *w, const orr_track *t,
                                  const orr_segmentation *seg, size_t k, const orr_node *node)
{
    const orr_instant *end = NULL;
    for (size_t a = 0; a < seg->n_arcs; a++) {
        const orr_instant *x = &t->at[seg->arc[a].last < k ? seg->arc[a].last : seg->arc[a].first];
        if (end == NULL || fabs(x->t_s - node->t_s) < fabs(end->t_s - node->t_s)) end = x;
    }
    if (end == NULL || fabs(end->t_s - node->t_s) > w->c->options->max_gap_s) return 0;
    orr_instant there = {.r_m = orr_smoothed_r(end), .v_mps = orr_smoothed_v(end)};
    if (orr_integrate(w->c->integrator, end->t_s, node->t_s - end->t_s, &there.r_m, &there.v_mps) != ORR_OK)
        return 0;
    // The empirical acceleration as it is at the end: 1e-7 m/s^2 are 4 cm in a quarter of an hour.
    const double dt = node->t_s - end->t_s;
    const orr_vec3 f0 = orr_vec3_make(end->state.x[6], end->state.x[7], end->state.x[8]);
    const orr_mat3 axes = orr_track_axes(w->c, end->t_s, end->r_m, end->v_mps);
    there.r_m = orr_vec3_axpy(0.5 * dt * dt, orr_mat3_apply(&axes, f0), there.r_m);
    return orr_vec3_norm(orr_track_measured(w->c, &there, node));
}

// Nodes that were rejected or that no arc holds: told as outliers, so that nothing is dropped in silence.
static orr_status tell_left_out(orr_satellite_work *w, const orr_track *t, const orr_segmentation *seg)
{
    orr_status s = ORR_OK;
    for (size_t k = 0, a = 0; k < t->n; k++) {
        while (a < seg->n_arcs && seg->arc[a].last < k) a++;
        if (a < seg->n_arcs && seg->arc[a].first <= k) continue; // told with its arc
        for (size_t i = t->at[k].first; i < t->at[k].first + t->at[k].n && s == ORR_OK; i++) {
            if (!orr_node_counts(&w->node[i])) continue;
            w->report->nodes_rejected++;
            s = orr_event_add(&w->events, ORR_EVENT_OUTLIER, w->node[i].t, w->node[i].t,
                              distance_from_orbit(w, t, seg, k, &w->node[i]));
        }
    }
    return s;
}

// Whether two files that go on differently part the arcs here, rather than a push: no flag says so, and the
// velocities are as near as those of two solutions for one orbit.
static bool only_files_part(const orr_satellite_work *w, const orr_instant *x, const orr_instant *y,
                            double dv_mps)
{
    const orr_node *left = &w->node[x->first + x->n - 1], *right = &w->node[y->first];
    return left->source != right->source && !right->manoeuvre && dv_mps < LEAST_PUSH_MPS;
}

// Where the arc that ends at x and the one that begins at y part. At a manoeuvre both reach to where they
// meet, if they do; else there is nothing between them. Where files part them, the earlier one holds up to
// the later one's begin.
static orr_status part_arcs(orr_satellite_work *w, const orr_instant *x, const orr_instant *y, double *to_s,
                            double *begin_s)
{
    orr_reference before = {.valid = true, .r_m = orr_smoothed_r(x), .v_mps = orr_smoothed_v(x)},
                  after = {.valid = true, .r_m = orr_smoothed_r(y), .v_mps = orr_smoothed_v(y)};
    double when = 0, apart = HUGE_VAL, dv = 0;
    orr_status s = orr_events_manoeuvre(w->c, x->t_s, before, y->t_s, after, &when, &apart, &dv);
    if (s != ORR_OK) return s;
    const bool near = y->t_s - x->t_s < 2.0 * w->table->step_s;
    if (near && only_files_part(w, x, y, dv)) {
        s = orr_integrate(w->c->integrator, x->t_s, y->t_s - x->t_s, &before.r_m, &before.v_mps);
        *to_s = *begin_s = y->t_s;
        if (s != ORR_OK) return s;
        return orr_event_add(&w->events, ORR_EVENT_DAY_JUMP, orr_satellite_time(w, y->t_s),
                             orr_satellite_time(w, y->t_s),
                             orr_vec3_norm(orr_vec3_sub(after.r_m, before.r_m)));
    }
    w->report->manoeuvres++;
    const bool meet = near && apart <= MAX_APART_M;
    *begin_s = y->t_s;
    if (meet)
        *to_s = *begin_s = round(when * 1e3) * 1e-3; // whole milliseconds have steps of whole nanoseconds
    return orr_event_add(&w->events, ORR_EVENT_MANOEUVRE, orr_satellite_time(w, x->t_s),
                         orr_satellite_time(w, y->t_s), dv);
}

orr_status orr_satellite_arcs(orr_satellite_work *w, orr_track *t, const orr_segmentation *seg)
{
    double begin_s = 0;
    orr_status s = tell_left_out(w, t, seg);
    for (size_t a = 0; a < seg->n_arcs && s == ORR_OK; a++) {
        const orr_arc_range *arc = &seg->arc[a];
        size_t i0, i1;
        orr_nodes_of_arc(t, arc, &i0, &i1);
        double from_s = a == 0 ? t->at[arc->first].t_s : begin_s, to_s = t->at[arc->last].t_s;
        if (a + 1 < seg->n_arcs) {
            s = part_arcs(w, &t->at[arc->last], &t->at[seg->arc[a + 1].first], &to_s, &begin_s);
            if (s != ORR_OK) break;
        }
        if (to_s <= from_s) continue;
        bool whole = arc->first == 0 && arc->last == t->n - 1 && seg->n_arcs == 1;
        if (!whole) {
            s = smooth_alone(w, from_s, to_s, i0, i1, seg->verdict);
            continue;
        }
        s = settle(w, t, seg->verdict, true);
        if (s == ORR_OK) s = emit_arc(w, t, seg->verdict);
    }
    return s;
}
