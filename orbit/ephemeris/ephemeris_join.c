// SPDX-License-Identifier: GPL-3.0-or-later
// Two products of different satellites as one.
#include <math.h>
#include <string.h>

#include "orbit/ephemeris/ephemeris_private.h"

void eph_append(const orr_ephemeris *from, orr_ephemeris *to, size_t i)
{
    const eph_sat *s = &from->sat[i];
    eph_sat *d = &to->sat[to->n_sats];
    *d = *s;
    to->sat_id[to->n_sats++] = from->sat_id[i];
    d->arc = &to->arc[to->n_arcs];
    d->clock = &to->clock[to->n_clocks];
    d->node = &to->node[to->n_nodes];
    d->event = &to->event[to->n_events];
    d->span = NULL;
    d->rate = NULL; // eph_finish makes both
    if (s->n_clocks > 0) memcpy(d->clock, s->clock, s->n_clocks * sizeof *s->clock);
    if (s->n_nodes > 0) memcpy(d->node, s->node, s->n_nodes * sizeof *s->node);
    if (s->n_events > 0) memcpy(d->event, s->event, s->n_events * sizeof *s->event);
    to->n_clocks += s->n_clocks;
    to->n_nodes += s->n_nodes;
    to->n_events += s->n_events;
    for (size_t k = 0; k < s->n_arcs; k++) {
        const eph_arc *a = &s->arc[k];
        eph_arc *b = &to->arc[to->n_arcs++];
        const size_t coefs = a->n_segments * eph_block(a->degree),
                     samples = a->n_segments * a->samples_per_segment + 1;
        *b = *a;
        b->first_segment = to->n_segments;
        b->first_sample = to->n_samples;
        b->first_coef = to->n_coefs;
        memcpy(&to->coef[to->n_coefs], &from->coef[a->first_coef], coefs * sizeof *from->coef);
        memcpy(to->sigma[to->n_samples], from->sigma[a->first_sample], samples * sizeof *from->sigma);
        memcpy(&to->sample_flags[to->n_samples], &from->sample_flags[a->first_sample],
               samples * sizeof *from->sample_flags);
        to->n_segments += a->n_segments;
        to->n_samples += samples;
        to->n_coefs += coefs;
    }
}

orr_status orr_ephemeris_join(const orr_ephemeris *a, const orr_ephemeris *b, orr_ephemeris **out,
                              orr_diag *diag)
{
    *out = NULL;
    const orr_ephemeris counts = {.n_sats = a->n_sats + b->n_sats,
                                  .n_arcs = a->n_arcs + b->n_arcs,
                                  .n_segments = a->n_segments + b->n_segments,
                                  .n_samples = a->n_samples + b->n_samples,
                                  .n_coefs = a->n_coefs + b->n_coefs,
                                  .n_clocks = a->n_clocks + b->n_clocks,
                                  .n_nodes = a->n_nodes + b->n_nodes,
                                  .n_events = a->n_events + b->n_events,
                                  .n_sources = a->n_sources + b->n_sources};
    if (counts.n_sats > EPH_MAX_SATS)
        return orr_diag_set(diag, ORR_E_LIMIT, "%zu satellites are more than a product's %d", counts.n_sats,
                            EPH_MAX_SATS);
    orr_ephemeris *e;
    orr_status s = eph_alloc(&counts, &e, diag);
    if (s != ORR_OK) return s;
    e->n_sats = e->n_arcs = e->n_segments = e->n_samples = e->n_coefs = 0;
    e->n_clocks = e->n_nodes = e->n_events = 0;
    for (size_t i = 0, j = 0; i < a->n_sats || j < b->n_sats;)
        if (j == b->n_sats || (i < a->n_sats && a->sat_id[i] < b->sat_id[j]))
            eph_append(a, e, i++);
        else
            eph_append(b, e, j++);
    if (a->n_sources > 0) memcpy(e->source, a->source, a->n_sources * sizeof *a->source);
    if (b->n_sources > 0) memcpy(e->source + a->n_sources, b->source, b->n_sources * sizeof *b->source);
    e->node_step_s = a->node_step_s;
    e->clock_max_gap_s = fmax(a->clock_max_gap_s, b->clock_max_gap_s);
    e->n_shortened = a->n_shortened + b->n_shortened;
    e->max_pos_error_m = fmax(a->max_pos_error_m, b->max_pos_error_m);
    e->max_vel_error_mps = fmax(a->max_vel_error_mps, b->max_vel_error_mps);
    memcpy(e->options, a->options, sizeof e->options);
    memcpy(e->frame, a->frame, sizeof e->frame);
    e->rotation = a->rotation;
    s = orr_eop_series_copy(&a->rotation.series, &e->rotation.series);
    if (s == ORR_OK) s = eph_copy_clock_events(&a->clock_events, &e->clock_events);
    if (s != ORR_OK)
        orr_diag_set(diag, s, "no memory for two products in one");
    else
        s = eph_finish(e, diag); // refuses a satellite that both have
    if (s != ORR_OK) {
        orr_ephemeris_free(e);
        return s;
    }
    *out = e;
    return ORR_OK;
}
