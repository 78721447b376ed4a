// SPDX-License-Identifier: GPL-3.0-or-later
// From the smoother's samples to the product: segments are fitted, checked against every sample, and the rest
// is copied beside them.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "orbit/ephemeris_impl.h"

// Where a degree is good enough, the next one is not tried: a tenth of what is allowed.
#define TARGET (1.0 / 10)

static orr_status arc_error(orr_sat sat, const orr_orbit_arc *a, const char *what, orr_diag *diag)
{
    char name[ORR_SAT_TEXT], when[ORR_TIME_TEXT];
    return orr_diag_set(diag, ORR_E_ARG, "%s, arc from %s: %s", orr_sat_text(sat, name),
                        orr_time_text(a->t0, when), what);
}

static orr_status check_arc(orr_sat sat, const orr_orbit_arc *a, const orr_orbit_arc *before, orr_diag *diag)
{
    double ns = a->step_s * 1e9;
    if (!(a->step_s > 0) || a->step_s > ORR_S_PER_DAY || fabs(ns - nearbyint(ns)) > 1e-3)
        return arc_error(sat, a, "the step of samples is no whole number of nanoseconds up to a day", diag);
    if (a->samples_per_segment < 1 || a->samples_per_segment > EPH_MAX_SAMPLES_PER_SEGMENT || a->n < 2 ||
        (a->n - 1) % a->samples_per_segment != 0)
        return arc_error(sat, a, "samples do not fill whole segments", diag);
    if (before != NULL &&
        a->t0 < before->t0 + (int64_t)(before->n - 1) * (int64_t)nearbyint(before->step_s * 1e9))
        return arc_error(sat, a, "it begins before the one before it ends", diag);
    return ORR_OK;
}

// Counts what the product will hold, for degree `degree` throughout.
static orr_status count(const orr_orbit_solution *s, int degree, orr_ephemeris *c, orr_diag *diag)
{
    *c = (orr_ephemeris){.n_sats = s->n_sats, .n_sources = s->n_sources};
    if (s->n_sats > EPH_MAX_SATS)
        return orr_diag_set(diag, ORR_E_LIMIT, "%zu satellites are more than a product's %d", s->n_sats,
                            EPH_MAX_SATS);
    for (size_t i = 0; i < s->n_sats; i++) {
        const orr_orbit_sat *sat = &s->sat[i];
        if (i > 0 && sat->sat <= s->sat[i - 1].sat)
            return orr_diag_set(diag, ORR_E_ARG, "satellites of a solution must ascend");
        c->n_arcs += sat->n_arcs;
        c->n_clocks += sat->n_clocks;
        c->n_nodes += sat->n_nodes;
        c->n_events += sat->n_events;
        for (size_t k = 0; k < sat->n_arcs; k++) {
            orr_status st = check_arc(sat->sat, &sat->arc[k], k > 0 ? &sat->arc[k - 1] : NULL, diag);
            if (st != ORR_OK) return st;
            c->n_segments += (sat->arc[k].n - 1) / sat->arc[k].samples_per_segment;
            c->n_samples += sat->arc[k].n;
        }
    }
    c->n_coefs = c->n_segments * eph_block(degree);
    return ORR_OK;
}

// Copies satellites, arcs, samples' flags and sigmas, clocks, nodes, events; everything but the coefficients.
static void copy(const orr_orbit_solution *s, int degree, orr_ephemeris *e)
{
    size_t arc = 0, clock = 0, node = 0, event = 0, segment = 0, sample = 0;
    for (size_t i = 0; i < s->n_sats; i++) {
        const orr_orbit_sat *from = &s->sat[i];
        e->sat_id[i] = from->sat;
        e->sat[i] = (eph_sat){.n_arcs = from->n_arcs,
                              .n_clocks = from->n_clocks,
                              .n_nodes = from->n_nodes,
                              .n_events = from->n_events,
                              .arc = &e->arc[arc],
                              .clock = &e->clock[clock],
                              .node = &e->node[node],
                              .event = &e->event[event]};
        if (from->n_clocks > 0) memcpy(&e->clock[clock], from->clock, from->n_clocks * sizeof *from->clock);
        if (from->n_nodes > 0) memcpy(&e->node[node], from->node, from->n_nodes * sizeof *from->node);
        if (from->n_events > 0) memcpy(&e->event[event], from->event, from->n_events * sizeof *from->event);
        clock += from->n_clocks;
        node += from->n_nodes;
        event += from->n_events;
        for (size_t k = 0; k < from->n_arcs; k++) {
            const orr_orbit_arc *a = &from->arc[k];
            eph_arc *b = &e->arc[arc++];
            *b =
                (eph_arc){.t0 = a->t0,
                          .segment_ns = (int64_t)nearbyint(a->step_s * 1e9) * (int64_t)a->samples_per_segment,
                          .n_segments = (a->n - 1) / a->samples_per_segment,
                          .samples_per_segment = a->samples_per_segment,
                          .degree = degree,
                          .first_segment = segment,
                          .first_sample = sample,
                          .first_coef = segment * eph_block(degree)};
            segment += b->n_segments;
            for (size_t j = 0; j < a->n; j++) {
                e->sigma[sample + j] = a->sample[j].sigma_m;
                e->sample_flags[sample + j] = a->sample[j + 1 < a->n ? j : j - 1].flags;
            }
            sample += a->n;
        }
    }
    if (s->n_sources > 0) memcpy(e->source, s->source, s->n_sources * sizeof *s->source);
    e->node_step_s = s->node_step_s;
    e->clock_max_gap_s = s->clock_max_gap_s;
    memcpy(e->options, s->options, sizeof e->options);
    memcpy(e->frame, s->frame, sizeof e->frame);
    e->options[sizeof e->options - 1] = e->frame[sizeof e->frame - 1] = '\0';
}

// Misfit of a build and where it was worst.
typedef struct misfit {
    double pos_m, vel_mps;
    orr_sat sat;
    orr_time t;
} misfit;

// Fits the segment that starts at sample[0] into rows of coef; worsens *m by its misfit.
static void fit_segment(const eph_fit *f, const orr_orbit_sample *sample, double h, double *coef,
                        double worst[2], size_t *worst_at)
{
    size_t n = f->samples;
    double data[3 * (EPH_MAX_SAMPLES_PER_SEGMENT + 1)], c[EPH_MAX_DEGREE + 1];
    double err[2][EPH_MAX_SAMPLES_PER_SEGMENT + 1] = {{0}};
    for (size_t axis = 0; axis < 3; axis++) {
        for (size_t i = 0; i < n; i++) {
            const orr_orbit_sample *p = &sample[i];
            const double *r = &p->pos_m.x, *v = &p->vel_mps.x, *a = &p->acc_mps2.x;
            data[i] = r[axis];
            data[n + i] = v[axis] * h;
            data[2 * n + i] = a[axis] * h * h;
        }
        eph_fit_apply(f, data, c);
        for (int j = 0; j <= f->degree; j++) coef[j * EPH_LANES + (int)axis] = c[j];
        for (size_t i = 0; i < 2 * n; i++) {
            double s = -data[i];
            for (int j = 0; j <= f->degree; j++)
                s += f->basis[i * (size_t)(f->degree + 1) + (size_t)j] * c[j];
            err[i / n][i % n] += s * s;
        }
    }
    for (size_t i = 0; i < n; i++) {
        double pos = sqrt(err[0][i]), vel = sqrt(err[1][i]) / h;
        // Written so that NAN counts as worst of all.
        if (!(pos <= worst[0])) worst[0] = pos, *worst_at = i;
        if (!(vel <= worst[1])) worst[1] = vel, *worst_at = i;
    }
}

static orr_status fit_all(const orr_orbit_solution *s, int degree, orr_ephemeris *e, misfit *m,
                          orr_diag *diag)
{
    eph_fit f = {0};
    *m = (misfit){0};
    orr_status st = ORR_OK;
    size_t arc = 0;
    for (size_t i = 0; i < s->n_sats && st == ORR_OK; i++) {
        for (size_t k = 0; k < s->sat[i].n_arcs && st == ORR_OK; k++, arc++) {
            const orr_orbit_arc *a = &s->sat[i].arc[k];
            int can = eph_fit_max_degree(a->samples_per_segment);
            int d = degree < can ? degree : can; // coefficients above stay zero
            if (f.degree != d || f.samples != a->samples_per_segment + 1) {
                eph_fit_free(&f);
                st = eph_fit_init(d, a->samples_per_segment, &f, diag);
                if (st != ORR_OK) break;
            }
            double h = 0.5 * a->step_s * (double)a->samples_per_segment;
            for (size_t g = 0; g < e->arc[arc].n_segments; g++) {
                double worst[2] = {m->pos_m, m->vel_mps};
                size_t at = SIZE_MAX, first = g * a->samples_per_segment;
                fit_segment(&f, &a->sample[first], h,
                            &e->coef[e->arc[arc].first_coef + g * eph_block(degree)], worst, &at);
                if (at == SIZE_MAX) continue;
                *m = (misfit){worst[0], worst[1], s->sat[i].sat,
                              orr_time_add_s(a->t0, (double)(first + at) * a->step_s)};
                if (isnan(worst[0]) || isnan(worst[1])) break;
            }
        }
    }
    eph_fit_free(&f);
    return st;
}

// The longest segment of the solution, in seconds, and the highest degree that its samples carry.
static void shape(const orr_orbit_solution *s, double *longest_s, int *can)
{
    *longest_s = 0;
    *can = EPH_MIN_DEGREE;
    for (size_t i = 0; i < s->n_sats; i++) {
        for (size_t k = 0; k < s->sat[i].n_arcs; k++) {
            const orr_orbit_arc *a = &s->sat[i].arc[k];
            double length = a->step_s * (double)a->samples_per_segment;
            if (length > *longest_s) *longest_s = length;
            int d = eph_fit_max_degree(a->samples_per_segment);
            if (d > *can) *can = d;
        }
    }
}

orr_status orr_ephemeris_build(const orr_orbit_solution *s, orr_ephemeris **out, orr_diag *diag)
{
    orr_ephemeris counts, *e = NULL;
    misfit m = {0};
    *out = NULL;
    double longest_s;
    int can;
    shape(s, &longest_s, &can);
    // Smooth motion of a GNSS satellite needs degree 6 on 15 min and 8 on an hour (measured); the ends of
    // shadow need more. Start there and go up until it is good enough.
    int degree = longest_s <= 1000 ? 8 : longest_s <= 2000 ? 9 : longest_s <= 4000 ? 10 : 12;
    if (degree > can) degree = can;
    for (;; degree++) {
        orr_status st = count(s, degree, &counts, diag);
        if (st == ORR_OK) st = eph_alloc(&counts, &e, diag);
        if (st != ORR_OK) return st;
        copy(s, degree, e);
        st = fit_all(s, degree, e, &m, diag);
        if (st != ORR_OK) {
            orr_ephemeris_free(e);
            return st;
        }
        bool good = m.pos_m <= TARGET * EPH_MAX_POS_ERROR_M && m.vel_mps <= TARGET * EPH_MAX_VEL_ERROR_MPS;
        if (good || degree >= can) break;
        orr_ephemeris_free(e);
    }
    e->max_pos_error_m = m.pos_m;
    e->max_vel_error_mps = m.vel_mps;
    orr_status st = ORR_OK;
    if (!(m.pos_m <= EPH_MAX_POS_ERROR_M) || !(m.vel_mps <= EPH_MAX_VEL_ERROR_MPS)) {
        char name[ORR_SAT_TEXT], when[ORR_TIME_TEXT];
        st = orr_diag_set(
            diag, ORR_E_NUMERIC,
            "the segments miss the smoothed orbit by up to %.3g m and %.3g m/s (allowed: %.1g and %.1g), "
            "worst at %s of %s",
            m.pos_m, m.vel_mps, EPH_MAX_POS_ERROR_M, EPH_MAX_VEL_ERROR_MPS, orr_time_text(m.t, when),
            orr_sat_text(m.sat, name));
    }
    if (st == ORR_OK) st = eph_finish(e, diag);
    if (st != ORR_OK) {
        orr_ephemeris_free(e);
        return st;
    }
    *out = e;
    return ORR_OK;
}
