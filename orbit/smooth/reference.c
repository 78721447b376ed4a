// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/reference.h"

#include <stdlib.h>
#include <string.h>

#define DAY_NS (ORR_S_PER_DAY * ORR_NS_PER_S)
#define SHORT_S 43200.0  // a midnight this near to the span's begin or end is no border
#define ENOUGH_NODES 150 // of a window; of more every second, third .. is fitted
#define WANTED_NODES 96
#define SAME_S 1e-6

static bool usable(const orr_node *n) { return !n->superseded && !n->bridge; }

// Midnights of GPS time, save near the ends.
static orr_status make_windows(const orr_node_table *table, orr_run_reference *r)
{
    const double span_s = fmax(orr_time_diff_s(table->to, table->from), 1);
    r->border_s = malloc(((size_t)(span_s / ORR_S_PER_DAY) + 3) * sizeof *r->border_s);
    if (r->border_s == NULL) return ORR_E_MEMORY;
    r->border_s[0] = 0;
    r->n_windows = 1;
    for (orr_time t = (orr_floor_div(table->from, DAY_NS) + 1) * DAY_NS; t < table->to; t += DAY_NS) {
        const double t_s = orr_time_diff_s(t, table->from);
        if (t_s <= SHORT_S || span_s - t_s <= SHORT_S) continue;
        r->border_s[r->n_windows++] = t_s;
    }
    r->border_s[r->n_windows] = span_s;
    return ORR_OK;
}

static size_t window_at(const orr_run_reference *r, double t_s)
{
    size_t w = 0;
    while (w + 1 < r->n_windows && t_s >= r->border_s[w + 1] - SAME_S) w++;
    return w;
}

// The window of node i: a day's 24:00 is its own where the next file has its 00:00.
static size_t window_of(const orr_run_reference *r, const orr_node_list *l, size_t i)
{
    const size_t w = window_at(r, l->node[i].t_s);
    if (w == 0 || l->node[i].t_s > r->border_s[w] + SAME_S) return w;
    for (size_t k = i + 1; k < l->n_nodes && l->node[k].t == l->node[i].t; k++)
        if (usable(&l->node[k]) && l->node[k].source != l->node[i].source) return w - 1;
    return w;
}

static size_t count_in(const orr_run_reference *r, const orr_node_list *l, size_t window)
{
    size_t n = 0;
    for (size_t i = 0; i < l->n_nodes; i++) n += usable(&l->node[i]) && window_of(r, l, i) == window;
    return n;
}

static void fill_arc(const orr_run_reference *r, const orr_node_list *l, size_t count, orr_reference_arc *arc,
                     orr_reference_node *room)
{
    const size_t stride = count > ENOUGH_NODES ? (count + WANTED_NODES / 2) / WANTED_NODES : 1;
    size_t seen = 0;
    arc->node = room;
    arc->n = 0;
    for (size_t i = 0; i < l->n_nodes; i++) {
        if (!usable(&l->node[i]) || window_of(r, l, i) != arc->window) continue;
        if (seen++ % stride != 0 && seen != count) continue;
        if (arc->n > 0 && l->node[i].t_s - room[arc->n - 1].t_s < SAME_S) continue; // files that overlap
        room[arc->n++] = (orr_reference_node){l->node[i].t_s, l->node[i].ecef_m};
    }
}

static orr_status allocate(const orr_node_table *table, orr_run_reference *r)
{
    const size_t n = table->n_sats * r->n_windows + 1;
    r->sat = calloc(table->n_sats + 1, sizeof *r->sat);
    r->fitted = calloc(n, sizeof *r->fitted);
    r->ecom_nmps2 = calloc(n, sizeof *r->ecom_nmps2);
    r->state = calloc(2 * n, sizeof *r->state);
    r->t_s = calloc(n, sizeof *r->t_s);
    if (r->sat == NULL || r->fitted == NULL || r->ecom_nmps2 == NULL || r->state == NULL || r->t_s == NULL)
        return ORR_E_MEMORY;
    for (size_t i = 0; i < table->n_sats; i++) {
        const size_t k = i * r->n_windows;
        r->sat[i] = (orr_satellite_reference){r->n_windows,      r->border_s,      &r->fitted[k],
                                              &r->ecom_nmps2[k], &r->state[2 * k], &r->t_s[k]};
        for (size_t w = 0; w < r->n_windows; w++) r->ecom_nmps2[k + w][0] = ORR_ECOM_D0_NMPS2;
    }
    return ORR_OK;
}

// What the arcs found; a window without an orbit of its own has the coefficients of the nearest that has.
static void keep(orr_run_reference *r, const orr_reference_arc *arc, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const orr_satellite_reference *s = &r->sat[arc[i].sat];
        const size_t w = arc[i].window;
        s->fitted[w] = arc[i].fitted;
        if (!arc[i].fitted) continue;
        memcpy(s->ecom_nmps2[w], arc[i].ecom_nmps2, sizeof s->ecom_nmps2[w]);
        s->state[2 * w] = arc[i].r_m;
        s->state[2 * w + 1] = arc[i].v_mps;
        s->t_s[w] = arc[i].t_s;
        for (size_t k = 0; k < s->n_windows; k++) { // arcs of a satellite come in order
            const bool later = k > w && !s->fitted[k], first = k < w && !s->fitted[k];
            bool any_before = false;
            for (size_t j = 0; j < w; j++) any_before = any_before || s->fitted[j];
            if (later || (first && !any_before))
                memcpy(s->ecom_nmps2[k], arc[i].ecom_nmps2, sizeof s->ecom_nmps2[k]);
        }
    }
}

orr_status orr_run_reference_make(const orr_smoother_options *o, const orr_node_table *table, bool hold,
                                  const volatile int *cancel, orr_run_reference *out, orr_diag *diag)
{
    *out = (orr_run_reference){0};
    size_t n_arcs = 0, n_nodes = 0;
    orr_reference_arc *arc = NULL;
    orr_reference_node *node = NULL;
    orr_status s = make_windows(table, out);
    for (size_t i = 0; i < table->n_sats; i++) n_nodes += table->list[i].n_nodes;
    if (s == ORR_OK) s = allocate(table, out);
    if (s == ORR_OK) {
        arc = calloc(table->n_sats * out->n_windows + 1, sizeof *arc);
        node = malloc((n_nodes + 1) * sizeof *node);
        if (arc == NULL || node == NULL) s = ORR_E_MEMORY;
    }
    orr_reference_node *next = node;
    for (size_t i = 0; i < table->n_sats && s == ORR_OK; i++)
        for (size_t w = 0; w < out->n_windows; w++) {
            const size_t count = count_in(out, &table->list[i], w);
            if (count == 0) continue;
            arc[n_arcs] = (orr_reference_arc){.sat = i, .window = w};
            fill_arc(out, &table->list[i], count, &arc[n_arcs], next);
            next += arc[n_arcs++].n;
        }
    if (s != ORR_OK) orr_diag_set(diag, s, "out of memory for %zu satellites", table->n_sats);
    if (s == ORR_OK) {
        const orr_reference_problem p = {.from = table->from,
                                         .to = table->to,
                                         .n_windows = out->n_windows,
                                         .border_s = out->border_s,
                                         .n_arcs = n_arcs,
                                         .arc = arc,
                                         .eop = o->eop,
                                         .leap = o->leap,
                                         .hold = hold,
                                         .gravity_degree = o->gravity_degree,
                                         .jobs = o->jobs,
                                         .cancel = cancel};
        s = orr_reference_fit_run(&p, &out->fit, diag);
    }
    if (s == ORR_OK) keep(out, arc, n_arcs);
    free(arc);
    free(node);
    if (s != ORR_OK) orr_run_reference_free(out);
    return s;
}

void orr_run_reference_free(orr_run_reference *r)
{
    orr_reference_fit_free(&r->fit);
    free(r->border_s);
    free(r->sat);
    free(r->fitted);
    free(r->ecom_nmps2);
    free(r->state);
    free(r->t_s);
    *r = (orr_run_reference){0};
}

void orr_reference_use(const orr_track_context *c, const orr_node *list, size_t n, orr_reference *reference)
{
    const orr_satellite_reference *s = c->reference;
    for (size_t i = 0; i < n; i++)
        if (s->fitted[orr_track_window(c, list[i].t_s)]) reference[i].valid = false;
    for (size_t w = 0; w < s->n_windows; w++) {
        size_t first = n;
        for (size_t i = 0; i < n && s->fitted[w]; i++)
            if (fabs(list[i].t_s - s->t_s[w]) < SAME_S) first = i; // the last of an instant: the new file's
        if (first < n)
            reference[first] = (orr_reference){.valid = true,
                                               .gross = reference[first].gross,
                                               .r_m = s->state[2 * w],
                                               .v_mps = s->state[2 * w + 1]};
    }
}

orr_status orr_reference_start_at(const orr_track_context *c, const orr_node *node, orr_reference *reference)
{
    const orr_satellite_reference *s = c->reference;
    const size_t w = orr_track_window(c, node->t_s);
    if (!s->fitted[w]) return ORR_OK;
    orr_vec3 r = s->state[2 * w], v = s->state[2 * w + 1];
    orr_track_use_window(c, w, NULL);
    const orr_status status = orr_integrate(c->integrator, s->t_s[w], node->t_s - s->t_s[w], &r, &v);
    if (status == ORR_OK)
        *reference = (orr_reference){.valid = true, .gross = reference->gross, .r_m = r, .v_mps = v};
    return status;
}
