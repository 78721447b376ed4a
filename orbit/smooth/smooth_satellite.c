// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/smooth_satellite.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "orbit/smooth/events.h"
#include "orbit/smooth/join.h"
#include "orbit/smooth/noise_choice.h"
#include "orbit/smooth/prior.h"
#include "orbit/smooth/reference.h"
#include "orbit/smooth/samples.h"
#include "orbit/smooth/segmentation.h"
#include "orbit/smooth/solution.h"

#define MAX_PASSES 8
#define LINEAR_M 30.0   // deviation (of velocity: times the node step) below which (33) is linear to 0.1 mm
#define TELLING_NODES 4 // three are met whatever they are: position, velocity and f0
// Files that differ by metres differ by less; station keeping takes ten times as much.
#define LEAST_PUSH_MPS 0.01
#define MAX_APART_M 1.0 // arcs that come nearer than this share an instant; else the manoeuvre leaves a hole

typedef struct work {
    orr_track_context *c;
    const orr_node_table *table;
    orr_node *node; // of the satellite
    size_t n;
    orr_reference *ref; // per node
    orr_orbit_sat *out;
    orr_event_list events;
    orr_satellite_report *report;
    double scale;            // real to formal sigma of the last arc that told; 1 before
    orr_noise_factor factor; // before an arc's own is chosen
    bool failed;             // a stretch could not be smoothed
    size_t n_files;
    orr_file_evidence *evidence; // NULL: not asked for
} work;

void orr_satellite_free(orr_orbit_sat *s)
{
    for (size_t i = 0; i < s->n_arcs; i++) free(s->arc[i].sample);
    free(s->arc);
    free(s->clock);
    free(s->node);
    free(s->event);
    *s = (orr_orbit_sat){0};
}

static orr_time absolute(const work *w, double t_s) { return orr_sky_origin(w->c->sky) + orr_track_ns(t_s); }

static void note(work *w, const char *text, double from_s)
{
    char when[ORR_TIME_TEXT];
    if (w->report->note[0] == '\0')
        snprintf(w->report->note, sizeof w->report->note, "%s (near %s)", text,
                 orr_time_format(absolute(w, from_s), ORR_SCALE_GPS, 0, NULL, when));
}

static orr_vec3 smoothed_r(const orr_instant *at)
{
    return orr_vec3_add(at->r_m, orr_vec3_make(at->smoothed.x[0], at->smoothed.x[1], at->smoothed.x[2]));
}
static orr_vec3 smoothed_v(const orr_instant *at)
{
    return orr_vec3_add(at->v_mps, orr_vec3_make(at->smoothed.x[3], at->smoothed.x[4], at->smoothed.x[5]));
}

// The next pass starts from the smoothed states; rejected nodes no longer restart the a-priori. Returns the
// largest deviation met, metres: of position, or of velocity times the node step.
static double take_references(const work *w, const orr_track *t, const orr_arc_range *arc)
{
    double largest = 0;
    for (size_t k = arc->first; k <= arc->last; k++) {
        const orr_instant *at = &t->at[k];
        for (size_t i = at->first; i < at->first + at->n; i++) {
            orr_reference *ref = &w->ref[i];
            orr_vec3 dr = orr_vec3_sub(smoothed_r(at), ref->valid ? ref->r_m : at->r_m);
            orr_vec3 dv = orr_vec3_sub(smoothed_v(at), ref->valid ? ref->v_mps : at->v_mps);
            largest = fmax(largest, fmax(orr_vec3_norm(dr), orr_vec3_norm(dv) * w->table->step_s));
            *ref = (orr_reference){.valid = true, .r_m = smoothed_r(at), .v_mps = smoothed_v(at)};
        }
    }
    return largest;
}

// Ratio of real to formal sigma: residuals of the used nodes against their formal covariance sigma^2 E - P.
// Only the ratio qf / sigma^2 shapes the orbit, so their common scale is free and has to come from the data.
// Two or three nodes, which an orbit meets whatever they are, tell nothing: then it stays as it was.
static double real_over_formal(const work *w, const orr_track *t, const orr_verdict *verdict)
{
    double chi2 = 0, formal2 = 0;
    size_t instants = 0;
    for (size_t k = 0; k < t->n; k++) {
        const orr_instant *at = &t->at[k];
        bool any = false;
        for (size_t i = at->first; i < at->first + at->n; i++) {
            const orr_node *node = &w->node[i];
            if (!orr_node_counts(node) || verdict[i].rejected) continue;
            orr_vec3 x = orr_vec3_make(at->smoothed.x[0], at->smoothed.x[1], at->smoothed.x[2]);
            orr_vec3 e = orr_vec3_sub(orr_track_measured(w->c, at, node), x);
            double weight = 1.0 / (node->sigma_m * node->sigma_m);
            chi2 += weight * orr_vec3_dot(e, e);
            for (int j = 0; j < 3; j++) formal2 += 1.0 - weight * at->smoothed.P[j][j];
            any = true;
        }
        instants += any;
    }
    return instants >= TELLING_NODES && formal2 > 0 ? sqrt(chi2 / formal2) : w->scale;
}

// Steps of velocity at noon, and stretches in which the orbit is noisier near the Earth's shadow.
static orr_status tell_file_noise(work *w, const orr_track *t)
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
            s = orr_event_add(&w->events, ORR_EVENT_NOON_STEP, absolute(w, at->t_s), absolute(w, at->t_s),
                              orr_vec3_norm((orr_vec3){step[3], step[4], step[5]}));
        }
        const double before = since < t->n ? t->at[since].shadow : 0, now = k + 1 < t->n ? at->shadow : 0;
        if (s != ORR_OK || !shadow || fabs(now - before) <= 0) continue;
        if (before > 0)
            s = orr_event_add(&w->events, ORR_EVENT_SHADOW_NOISE, absolute(w, t->at[since].t_s),
                              absolute(w, at->t_s), before + 1);
        since = now > 0 ? k : t->n;
    }
    return s;
}

// Samples of the smoothed track as an arc of the solution.
static orr_status emit_arc(work *w, const orr_track *t, const orr_verdict *verdict)
{
    const size_t first = 0, last = t->n - 1;
    const double scale = w->c->noise.nx == ORR_NX ? w->scale : real_over_formal(w, t, verdict);
    w->scale = scale;
    const double noise_m =
        scale * (w->c->noise.nx == ORR_NX ? w->c->options->sigma_m : w->c->options->plain.sigma_m);
    w->out->node_noise_m = fmax(w->out->node_noise_m, noise_m);
    if (!ORR_ARRAY_GROW(w->out->arc, w->out->n_arcs)) return ORR_E_MEMORY;
    orr_orbit_arc arc = {.t0 = absolute(w, t->at[first].t_s),
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
            o->residual_m = orr_vec3_sub(orr_mat3_apply(&p.R, smoothed_r(at)), node->ecef_m);
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

// Filter and smoother over the whole track, with noise as large as it is. smoothed: it is already, with the noise as it was
// before.
static orr_status settle(work *w, orr_track *t, const orr_verdict *verdict, bool smoothed)
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
    } else if (!smoothed) {
        orr_filter_range(w->c, w->node, verdict, t, 0, t->n - 1);
    }
    return smoothed ? ORR_OK : orr_smooth_range(w->c, t, 0, t->n - 1);
}

// One arc again on a grid of its own, from from_s to to_s, which may reach beyond its nodes list[i0..i1).
static orr_status smooth_alone(work *w, double from_s, double to_s, size_t i0, size_t i1,
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

// First and last node (half open) of an arc of the track.
static void nodes_of(const orr_track *t, const orr_arc_range *arc, size_t *i0, size_t *i1)
{
    *i0 = t->at[arc->first].first;
    *i1 = t->at[arc->last].first + t->at[arc->last].n;
}

// How far a node is from the orbit of the nearest arc, carried on to its instant; 0 where there is none near
// enough to tell.
static double distance_from_orbit(const work *w, const orr_track *t, const orr_segmentation *seg, size_t k,
                                  const orr_node *node)
{
    const orr_instant *end = NULL;
    for (size_t a = 0; a < seg->n_arcs; a++) {
        const orr_instant *x = &t->at[seg->arc[a].last < k ? seg->arc[a].last : seg->arc[a].first];
        if (end == NULL || fabs(x->t_s - node->t_s) < fabs(end->t_s - node->t_s)) end = x;
    }
    if (end == NULL || fabs(end->t_s - node->t_s) > w->c->options->max_gap_s) return 0;
    orr_instant there = {.r_m = smoothed_r(end), .v_mps = smoothed_v(end)};
    if (orr_integrate(w->c->integrator, end->t_s, node->t_s - end->t_s, &there.r_m, &there.v_mps) != ORR_OK)
        return 0;
    // The empirical acceleration as it is at the end: 1e-7 m/s^2 are 4 cm in a quarter of an hour.
    const double dt = node->t_s - end->t_s;
    const orr_vec3 f0 = orr_vec3_make(end->smoothed.x[6], end->smoothed.x[7], end->smoothed.x[8]);
    const orr_mat3 axes = orr_track_axes(w->c, end->t_s, end->r_m, end->v_mps);
    there.r_m = orr_vec3_axpy(0.5 * dt * dt, orr_mat3_apply(&axes, f0), there.r_m);
    return orr_vec3_norm(orr_track_measured(w->c, &there, node));
}

// Nodes that were rejected or that no arc holds: told as outliers, so that nothing is dropped in silence.
static orr_status tell_left_out(work *w, const orr_track *t, const orr_segmentation *seg)
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
static bool only_files_part(const work *w, const orr_instant *x, const orr_instant *y, double dv_mps)
{
    const orr_node *left = &w->node[x->first + x->n - 1], *right = &w->node[y->first];
    return left->source != right->source && !right->manoeuvre && dv_mps < LEAST_PUSH_MPS;
}

// Where the arc that ends at x and the one that begins at y part. At a manoeuvre both reach to where they
// meet, if they do; else there is nothing between them. Where files part them, the earlier one holds up to
// the later one's begin.
static orr_status part_arcs(work *w, const orr_instant *x, const orr_instant *y, double *to_s,
                            double *begin_s)
{
    orr_reference before = {.valid = true, .r_m = smoothed_r(x), .v_mps = smoothed_v(x)},
                  after = {.valid = true, .r_m = smoothed_r(y), .v_mps = smoothed_v(y)};
    double when = 0, apart = HUGE_VAL, dv = 0;
    orr_status s = orr_events_manoeuvre(w->c, x->t_s, before, y->t_s, after, &when, &apart, &dv);
    if (s != ORR_OK) return s;
    const bool near = y->t_s - x->t_s < 2.0 * w->table->step_s;
    if (near && only_files_part(w, x, y, dv)) {
        s = orr_integrate(w->c->integrator, x->t_s, y->t_s - x->t_s, &before.r_m, &before.v_mps);
        *to_s = *begin_s = y->t_s;
        if (s != ORR_OK) return s;
        return orr_event_add(&w->events, ORR_EVENT_DAY_JUMP, absolute(w, y->t_s), absolute(w, y->t_s),
                             orr_vec3_norm(orr_vec3_sub(after.r_m, before.r_m)));
    }
    w->report->manoeuvres++;
    const bool meet = near && apart <= MAX_APART_M;
    *begin_s = y->t_s;
    if (meet)
        *to_s = *begin_s = round(when * 1e3) * 1e-3; // whole milliseconds have steps of whole nanoseconds
    return orr_event_add(&w->events, ORR_EVENT_MANOEUVRE, absolute(w, x->t_s), absolute(w, y->t_s), dv);
}

static orr_status emit_all(work *w, orr_track *t, const orr_segmentation *seg)
{
    double begin_s = 0;
    orr_status s = tell_left_out(w, t, seg);
    for (size_t a = 0; a < seg->n_arcs && s == ORR_OK; a++) {
        const orr_arc_range *arc = &seg->arc[a];
        size_t i0, i1;
        nodes_of(t, arc, &i0, &i1);
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

// The next pass is not linearised about nodes that were rejected or that no arc holds. Returns how many these
// are.
static size_t invalidate_left_out(work *w, const orr_track *t, const orr_segmentation *seg, size_t i0,
                                  size_t i1)
{
    size_t n = 0, i = i0;
    for (size_t a = 0; a <= seg->n_arcs; a++) {
        size_t begin = i1, end = i1;
        if (a < seg->n_arcs) nodes_of(t, &seg->arc[a], &begin, &end);
        for (; i < begin && seg->n_arcs > 0; i++, n++) w->ref[i].valid = false;
        for (; i < end; i++) {
            if (!seg->verdict[i].rejected) continue;
            w->ref[i].valid = false;
            n++;
        }
    }
    return n;
}

#define LOW_ORBIT_M 1.5e7 // below it drag and the field's details are no matter of ECOM

// How large the random walk of a low orbit is depends on its height and the Sun: the nodes tell.
static orr_status choose_noise_of_low_orbit(work *w, orr_track *t, size_t i0)
{
    const bool low = orr_vec3_norm(w->node[i0].ecef_m) < LOW_ORBIT_M;
    if (!low || w->c->noise.nx == ORR_NX || !w->c->options->plain.choose_qf) return ORR_OK;
    orr_verdict *none = calloc(w->n + 1, sizeof *none);
    if (none == NULL) return ORR_E_MEMORY;
    w->c->noise.factor = w->factor;
    orr_noise_choose_freely(w->c, w->node, none, t);
    free(none);
    return ORR_OK;
}

// Nodes list[i0..i1), no two of them further apart than the longest bridged gap.
static orr_status smooth_stretch(work *w, size_t i0, size_t i1)
{
    const orr_smoother_options *o = w->c->options;
    double from_s = w->node[i0].t_s, to_s = w->node[i1 - 1].t_s;
    if (!(to_s > from_s)) {
        note(w, "a node alone is no orbit", from_s);
        return ORR_OK;
    }
    orr_track t;
    orr_segmentation seg = {0};
    orr_status s = ORR_OK;
    if (w->c->noise.nx == ORR_NX && i0 > 0) s = orr_reference_start_at(w->c, &w->node[i0], &w->ref[i0]);
    if (s != ORR_OK) return s;
    w->c->noise.factor = w->factor;
    int most = o->passes > 0 ? o->passes : MAX_PASSES;
    size_t left_out_before = 0, arcs_before = 1;
    for (int pass = 1;; pass++) {
        s = orr_track_init(w->c, from_s, to_s, w->table->step_s, w->node, i1, &t);
        if (s != ORR_OK) return s;
        s = orr_track_linearise(w->c, w->ref, &t);
        if (s == ORR_OK) s = choose_noise_of_low_orbit(w, &t, i0);
        if (s == ORR_OK) s = orr_segment_track(w->c, w->node, i1, w->table->step_s, &t, &seg);
        double largest = 0;
        if (s != ORR_OK) break;
        size_t left_out = invalidate_left_out(w, &t, &seg, i0, i1);
        // A poor linearisation about sparse first nodes can make good nodes look bad: the verdict has to
        // stand.
        bool stands = left_out == left_out_before && seg.n_arcs == arcs_before;
        left_out_before = left_out;
        arcs_before = seg.n_arcs;
        bool done = pass >= most;
        if (!done || seg.n_arcs > 1) {
            for (size_t a = 0; a < seg.n_arcs; a++)
                largest = fmax(largest, take_references(w, &t, &seg.arc[a]));
            if (o->passes == 0 && largest < LINEAR_M && stands) done = true;
        }
        if (pass > w->report->passes) w->report->passes = pass;
        if (done) break;
        orr_segmentation_free(&seg);
        orr_track_free(&t);
    }
    if (s == ORR_OK) s = emit_all(w, &t, &seg);
    orr_segmentation_free(&seg);
    orr_track_free(&t);
    if (s == ORR_E_NUMERIC || s == ORR_E_NODATA) {
        w->failed = true;
        note(w, "these positions are no orbit that can be integrated", from_s);
        return ORR_OK;
    }
    return s;
}

static orr_status smooth_all(work *w)
{
    const orr_track_context *c = w->c;
    if (c->options->nav != NULL)
        w->report->from_broadcast =
            orr_prior_broadcast(c, w->out->sat, w->node, w->n, w->table->step_s, w->ref);
    else
        orr_prior_sparse(c, w->node, w->n, w->table->step_s, w->ref);
    if (c->noise.nx == ORR_NX) orr_reference_use(c, w->node, w->n, w->ref);
    orr_status s = ORR_OK;
    for (size_t i = 0; i < w->n && s == ORR_OK;) {
        size_t j = i + 1;
        while (j < w->n && w->node[j].t_s - w->node[j - 1].t_s <= c->options->max_gap_s + 1e-3) j++;
        s = smooth_stretch(w, i, j);
        if (j < w->n && s == ORR_OK)
            s = orr_event_add(&w->events, ORR_EVENT_GAP, w->node[j - 1].t, w->node[j].t, 0);
        i = j;
    }
    return s;
}

static void discard_arcs(work *w)
{
    for (size_t i = 0; i < w->out->n_arcs; i++) free(w->out->arc[i].sample);
    for (size_t i = 0; i < w->n; i++) w->out->node[i].used = 0;
    w->out->n_arcs = 0;
    w->events.n = 0;
    *w->report = (orr_satellite_report){0};
}

// Nodes of the bridge are no input: they leave the list that the product keeps.
static void drop_bridge(work *w)
{
    size_t n = 0;
    for (size_t i = 0; i < w->n; i++)
        if (!w->node[i].bridge) w->out->node[n++] = w->out->node[i];
    w->out->n_nodes = n;
}

#define PLAIN_START_R_M 1e3
#define PLAIN_START_V_MPS 1e2
#define START_R_M 10.0 // the reference is within centimetres
#define START_V_MPS 1e-2
// Where it is not, the passes come there; more than so much is beyond what eighteen unknowns can carry in double
// precision beside nodes of a millimetre.
#define ROUGH_START_R_M 100.0
#define ROUGH_START_V_MPS 1.0

static bool all_fitted(const orr_satellite_reference *r)
{
    for (size_t w = 0; w < r->n_windows; w++)
        if (!r->fitted[w]) return false;
    return true;
}

static bool any_fitted(const orr_satellite_reference *r)
{
    for (size_t w = 0; w < r->n_windows; w++)
        if (r->fitted[w]) return true;
    return false;
}

// About the reference with ECOM in the state where there is one; else, and for low orbits, about the nodes
// alone.
static void choose_method(orr_track_context *c, orr_node_list *list, bool may_be_rich)
{
    const orr_smoother_options *o = c->options;
    const bool low = list->n_nodes > 0 && orr_vec3_norm(list->node[0].ecef_m) < LOW_ORBIT_M;
    const bool rich = may_be_rich && c->reference != NULL && any_fitted(c->reference) && !low;
    c->noise = (orr_filter_noise){.nx = rich ? ORR_NX : ORR_NX_PLAIN,
                                  .qf_m2ps5 = rich ? o->qf_m2ps5 : o->plain.qf_m2ps5,
                                  .qv_m2ps3 = rich ? 0 : o->plain.qv_m2ps3,
                                  .start_r_m = rich ? ROUGH_START_R_M : PLAIN_START_R_M,
                                  .start_v_mps = rich ? ROUGH_START_V_MPS : PLAIN_START_V_MPS,
                                  .f0_sigma_mps2 = rich ? o->f0_sigma_mps2 : o->plain.f0_sigma_mps2,
                                  .factor = {.q = 1}};
    if (rich && all_fitted(c->reference)) {
        c->noise.start_r_m = START_R_M;
        c->noise.start_v_mps = START_V_MPS;
    }
    c->force->precise = rich;
    const int degree = low ? o->low_gravity_degree : o->gravity_degree;
    if (c->force->earth.degree != degree) // both were tried before
        orr_gravity_field_init(&c->force->earth, degree, o->zonal_only, NULL);
    c->force->earth.model = low ? o->low_gravity : NULL;
    if (rich) return;
    c->reference = NULL;
    for (size_t i = 0; i < list->n_nodes; i++)
        if (!list->node[i].bridge)
            list->node[i].sigma_m = list->node[i].predicted ? o->plain.sigma_predicted_m : o->plain.sigma_m;
}

orr_status orr_satellite_smooth(const orr_track_context *shared, const orr_node_table *table,
                                orr_node_list *list, size_t n_files, orr_file_evidence *evidence,
                                orr_orbit_sat *out, orr_satellite_report *report)
{
    orr_track_context own = *shared, *c = &own;
    choose_method(c, list, true);
    *out = (orr_orbit_sat){.sat = list->sat, .clock_noise = list->clock_noise};
    *report = (orr_satellite_report){0};
    work w = {.c = c,
              .table = table,
              .n = list->n_nodes,
              .out = out,
              .report = report,
              .scale = 1,
              .factor = c->noise.factor,
              .n_files = n_files,
              .evidence = evidence};
    out->node = calloc(list->n_nodes + 1, sizeof *out->node);
    out->clock = malloc((list->n_clocks + 1) * sizeof *out->clock);
    w.ref = calloc(list->n_nodes + 1, sizeof *w.ref);
    w.node = malloc((list->n_nodes + 1) * sizeof *w.node); // their sigmas are changed
    orr_status s = ORR_E_MEMORY;
    if (out->node == NULL || out->clock == NULL || w.ref == NULL || w.node == NULL) goto done;
    memcpy(w.node, list->node, list->n_nodes * sizeof *w.node);
    memcpy(out->clock, list->clock, list->n_clocks * sizeof *out->clock);
    out->n_clocks = list->n_clocks;
    out->n_nodes = list->n_nodes;
    bool bridged = false;
    for (size_t i = 0; i < list->n_nodes; i++) {
        out->node[i] = (orr_orbit_node){.t = list->node[i].t,
                                        .residual_m = {(double)NAN, (double)NAN, (double)NAN},
                                        .source = list->node[i].source};
        bridged = bridged || list->node[i].bridge;
        w.node[i].superseded = w.node[i].superseded || w.node[i].bridge;
    }
    s = smooth_all(&w);
    if (s == ORR_OK && w.failed &&
        c->noise.nx == ORR_NX) { // what is no orbit about the reference may be one by itself
        choose_method(c, list, false);
        for (size_t i = 0; i < w.n; i++) w.node[i].sigma_m = list->node[i].sigma_m;
        discard_arcs(&w);
        w.factor = c->noise.factor;
        w.scale = 1;
        s = smooth_all(&w);
    }
    if (s == ORR_OK && bridged) {
        // The formal sigmas of precise nodes are larger than the truth by 1/scale; those of the bridge, which
        // are true, have to be stretched likewise before the two are weighed against each other.
        double scale = w.scale > 1e-4 ? w.scale : 1e-4;
        for (size_t i = 0; i < w.n; i++)
            if (w.node[i].bridge) {
                w.node[i].superseded = false;
                w.node[i].sigma_m /= scale;
            }
        discard_arcs(&w);
        s = smooth_all(&w);
        drop_bridge(&w);
    }
    orr_events_sort(&w.events);
    out->event = w.events.item;
    out->n_events = w.events.n;
done:
    free(w.ref);
    free(w.node);
    if (s != ORR_OK) orr_satellite_free(out);
    return s;
}
