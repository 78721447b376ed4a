// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/smooth_satellite.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "orbit/smooth/noise_choice.h"
#include "orbit/smooth/prior.h"
#include "orbit/smooth/reference.h"
#include "orbit/smooth/satellite_arcs.h"

#define MAX_PASSES 8
#define LINEAR_M 30.0 // deviation (of velocity: times the node step) below which (33) is linear to 0.1 mm

void orr_satellite_free(orr_orbit_sat *s)
{
    for (size_t i = 0; i < s->n_arcs; i++) free(s->arc[i].sample);
    free(s->arc);
    free(s->clock);
    free(s->node);
    free(s->event);
    *s = (orr_orbit_sat){0};
}

static void note(orr_satellite_work *w, const char *text, double from_s)
{
    char when[ORR_TIME_TEXT];
    if (w->report->note[0] == '\0')
        snprintf(w->report->note, sizeof w->report->note, "%s (near %s)", text,
                 orr_time_format(orr_satellite_time(w, from_s), ORR_SCALE_GPS, 0, NULL, when));
}

// The next pass starts from the smoothed states; rejected nodes no longer restart the a-priori. Returns the
// largest deviation met, metres: of position, or of velocity times the node step.
static double take_references(const orr_satellite_work *w, const orr_track *t, const orr_arc_range *arc)
{
    double largest = 0;
    for (size_t k = arc->first; k <= arc->last; k++) {
        const orr_instant *at = &t->at[k];
        for (size_t i = at->first; i < at->first + at->n; i++) {
            orr_reference *ref = &w->ref[i];
            orr_vec3 dr = orr_vec3_sub(orr_smoothed_r(at), ref->valid ? ref->r_m : at->r_m);
            orr_vec3 dv = orr_vec3_sub(orr_smoothed_v(at), ref->valid ? ref->v_mps : at->v_mps);
            largest = fmax(largest, fmax(orr_vec3_norm(dr), orr_vec3_norm(dv) * w->table->step_s));
            *ref = (orr_reference){.valid = true, .r_m = orr_smoothed_r(at), .v_mps = orr_smoothed_v(at)};
        }
    }
    return largest;
}

// The next pass is not linearised about nodes that were rejected or that no arc holds. Returns how many these
// are.
static size_t invalidate_left_out(orr_satellite_work *w, const orr_track *t, const orr_segmentation *seg,
                                  size_t i0, size_t i1)
{
    size_t n = 0, i = i0;
    for (size_t a = 0; a <= seg->n_arcs; a++) {
        size_t begin = i1, end = i1;
        if (a < seg->n_arcs) orr_nodes_of_arc(t, &seg->arc[a], &begin, &end);
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
static orr_status choose_noise_of_low_orbit(orr_satellite_work *w, orr_track *t, size_t i0)
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

// What a track about the reference tells of the times of its nodes: their distance along the orbit over the speed.
static void read_times(orr_satellite_work *w, const orr_track *t)
{
    for (size_t k = 0; k < t->n; k++)
        for (size_t i = t->at[k].first; i < t->at[k].first + t->at[k].n; i++) {
            const orr_vec3 off = orr_track_measured(w->c, &t->at[k], &w->node[i]), v = t->at[k].v_mps;
            if (orr_node_counts(&w->node[i]) && !w->node[i].predicted)
                w->node[i].told_s = orr_vec3_dot(off, v) / orr_vec3_dot(v, v);
        }
}

// Nodes list[i0..i1), no two of them further apart than the longest bridged gap.
static orr_status smooth_stretch(orr_satellite_work *w, size_t i0, size_t i1)
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
        if (s == ORR_OK && pass == 1 && w->c->noise.nx == ORR_NX && w->evidence != NULL) read_times(w, &t);
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
    if (s == ORR_OK) s = orr_satellite_arcs(w, &t, &seg);
    orr_segmentation_free(&seg);
    orr_track_free(&t);
    if (s == ORR_E_NUMERIC || s == ORR_E_NODATA) {
        w->failed = true;
        note(w, "these positions are no orbit that can be integrated", from_s);
        return ORR_OK;
    }
    return s;
}

static orr_status smooth_all(orr_satellite_work *w)
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

static void discard_arcs(orr_satellite_work *w)
{
    for (size_t i = 0; i < w->out->n_arcs; i++) free(w->out->arc[i].sample);
    for (size_t i = 0; i < w->n; i++) w->out->node[i].used = 0;
    w->out->n_arcs = 0;
    w->events.n = 0;
    *w->report = (orr_satellite_report){0};
}

// Nodes of the bridge are no input: they leave the list that the product keeps.
static void drop_bridge(orr_satellite_work *w)
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
    orr_satellite_work w = {.c = c,
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
        w.node[i].told_s = (double)NAN;
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
    for (size_t i = 0; i < list->n_nodes && evidence != NULL; i++) list->node[i].told_s = w.node[i].told_s;
    orr_events_sort(&w.events);
    out->event = w.events.item;
    out->n_events = w.events.n;
done:
    free(w.ref);
    free(w.node);
    if (s != ORR_OK) orr_satellite_free(out);
    return s;
}
