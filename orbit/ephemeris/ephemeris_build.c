// SPDX-License-Identifier: GPL-3.0-or-later
// From the smoother's samples to the product: segments are fitted, checked against every sample, and the rest
// is copied beside them.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "orbit/ephemeris/ephemeris_private.h"

// Where a degree does so well at the samples, the next one is not tried: between samples it can be a few
// times worse.
#define GOOD_ENOUGH (1.0 / 5)

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
    if (a->t0 < -EPH_TIME_LIMIT || a->t0 > EPH_TIME_LIMIT ||
        (double)a->n * ns > (double)EPH_TIME_LIMIT - (double)a->t0)
        return arc_error(sat, a, "a product's times are of the years 1834 to 2126", diag);
    if (a->samples_per_segment < 1 || a->samples_per_segment > EPH_MAX_SAMPLES_PER_SEGMENT || a->n < 2 ||
        (a->n - 1) % a->samples_per_segment != 0)
        return arc_error(sat, a, "samples do not fill whole segments", diag);
    if (before != NULL &&
        a->t0 < before->t0 + (int64_t)(before->n - 1) * (int64_t)nearbyint(before->step_s * 1e9))
        return arc_error(sat, a, "it begins before the one before it ends", diag);
    for (size_t i = 0; i < a->n; i++) {
        const orr_orbit_sample *p = &a->sample[i];
        double sum = p->pos_m.x + p->pos_m.y + p->pos_m.z + p->vel_mps.x + p->vel_mps.y + p->vel_mps.z +
                     p->acc_mps2.x + p->acc_mps2.y + p->acc_mps2.z;
        const float most = fmaxf(fmaxf(p->sigma_m, p->sigma_mps),
                                 fmaxf(fmaxf(p->sigma_rtn_m[0], p->sigma_rtn_m[1]), p->sigma_rtn_m[2]));
        if (isfinite(sum) && p->sigma_m >= 0 && !isinf(most)) continue;
        char name[ORR_SAT_TEXT], when[ORR_TIME_TEXT];
        return orr_diag_set(diag, ORR_E_NUMERIC, "the smoothed orbit of %s at %s is no number",
                            orr_sat_text(sat, name),
                            orr_time_text(orr_time_add_s(a->t0, (double)i * a->step_s), when));
    }
    return ORR_OK;
}

// An arc's segments as fitted, before there is a product to put them in.
typedef struct fitted {
    int degree;
    size_t samples_per_segment; // the arc's, or fewer
    double *coef;               // n_segments blocks
    double pos_m, vel_mps;      // largest misfit, and where
    orr_time worst;
} fitted;

// Counts what the product will hold.
static orr_status count(const orr_orbit_solution *s, orr_ephemeris *c, orr_diag *diag)
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
            c->n_samples += sat->arc[k].n;
        }
        for (size_t k = 0; k < sat->n_clocks; k++) {
            char name[ORR_SAT_TEXT], when[ORR_TIME_TEXT];
            if (fabs(sat->clock[k].clock_s) < EPH_MAX_CLOCK_S) continue;
            return orr_diag_set(diag, ORR_E_NUMERIC, "the clock of %s at %s is no clock's",
                                orr_sat_text(sat->sat, name), orr_time_text(sat->clock[k].t, when));
        }
    }
    return ORR_OK;
}

// A sigma to 12 significant bits, a part in 4000: the rest is noise of estimates, which a file would keep at seven bits in eight of
// its size.
static float to_sigma_bits(float sigma)
{
    enum { DROPPED = 12 }; // of the 23 that a float has behind its leading one
    uint32_t bits;
    if (!isfinite(sigma)) return sigma;
    memcpy(&bits, &sigma, sizeof bits);
    bits = (bits + (1u << (DROPPED - 1))) &
           ~((1u << DROPPED) - 1); // a carry goes into the exponent, as it should
    memcpy(&sigma, &bits, sizeof bits);
    return sigma;
}

// Copies satellites, fitted arcs, samples' flags and sigmas, clocks, nodes, events.
static void copy(const orr_orbit_solution *s, const fitted *fit, orr_ephemeris *e)
{
    size_t arc = 0, clock = 0, node = 0, event = 0, segment = 0, sample = 0, coef = 0;
    for (size_t i = 0; i < s->n_sats; i++) {
        const orr_orbit_sat *from = &s->sat[i];
        e->sat_id[i] = from->sat;
        e->sat[i] = (eph_sat){.node_noise_m = from->node_noise_m,
                              .n_arcs = from->n_arcs,
                              .n_clocks = from->n_clocks,
                              .n_nodes = from->n_nodes,
                              .n_events = from->n_events,
                              .clock_noise = from->clock_noise,
                              .arc = &e->arc[arc],
                              .clock = &e->clock[clock],
                              .node = &e->node[node],
                              .event = &e->event[event]};
        for (size_t k = 0; k < from->n_clocks; k++) {
            e->clock[clock + k] = from->clock[k];
            e->clock[clock + k].flags &= EPH_CLOCK_FLAGS;
        }
        if (from->n_nodes > 0) memcpy(&e->node[node], from->node, from->n_nodes * sizeof *from->node);
        if (from->n_events > 0) memcpy(&e->event[event], from->event, from->n_events * sizeof *from->event);
        clock += from->n_clocks;
        node += from->n_nodes;
        event += from->n_events;
        for (size_t k = 0; k < from->n_arcs; k++) {
            const orr_orbit_arc *a = &from->arc[k];
            const fitted *f = &fit[arc];
            eph_arc *b = &e->arc[arc++];
            *b =
                (eph_arc){.t0 = a->t0,
                          .segment_ns = (int64_t)nearbyint(a->step_s * 1e9) * (int64_t)f->samples_per_segment,
                          .n_segments = (a->n - 1) / f->samples_per_segment,
                          .samples_per_segment = f->samples_per_segment,
                          .degree = f->degree,
                          .first_segment = segment,
                          .first_sample = sample,
                          .first_coef = coef};
            e->n_shortened += f->samples_per_segment < a->samples_per_segment;
            memcpy(&e->coef[coef], f->coef, b->n_segments * eph_block(f->degree) * sizeof *e->coef);
            coef += b->n_segments * eph_block(f->degree);
            segment += b->n_segments;
            e->max_pos_error_m = fmax(e->max_pos_error_m, f->pos_m);
            e->max_vel_error_mps = fmax(e->max_vel_error_mps, f->vel_mps);
            for (size_t j = 0; j < a->n; j++) {
                const orr_orbit_sample *p = &a->sample[j];
                const float sigma[EPH_SIGMAS] = {to_sigma_bits(p->sigma_m), to_sigma_bits(p->sigma_rtn_m[0]),
                                                 to_sigma_bits(p->sigma_rtn_m[1]),
                                                 to_sigma_bits(p->sigma_rtn_m[2]),
                                                 to_sigma_bits(p->sigma_mps)};
                memcpy(e->sigma[sample + j], sigma, sizeof sigma);
                e->sample_flags[sample + j] = a->sample[j + 1 < a->n ? j : j - 1].flags & EPH_STATE_FLAGS;
            }
            sample += a->n;
        }
    }
}

orr_status eph_copy_clock_events(const orr_clock_events *from, orr_clock_events *to)
{
    if (from->n == 0) return ORR_OK;
    to->item = malloc(from->n * sizeof *to->item);
    if (to->item == NULL) return ORR_E_MEMORY;
    memcpy(to->item, from->item, from->n * sizeof *to->item);
    to->n = from->n;
    return ORR_OK;
}

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
        if (pos > worst[0]) worst[0] = pos, *worst_at = i;
        if (vel > worst[1]) worst[1] = vel, *worst_at = i;
    }
}

// Fit operators of one number of samples a segment, made when first asked for.
typedef struct operators {
    size_t samples_per_segment;
    eph_fit of[EPH_MAX_DEGREE + 1];
} operators;

static void operators_free(operators *o)
{
    for (int d = 0; d <= EPH_MAX_DEGREE; d++) eph_fit_free(&o->of[d]);
    *o = (operators){0};
}

static orr_status operator_of(operators *o, int degree, size_t samples_per_segment, const eph_fit **f,
                              orr_diag *diag)
{
    if (o->samples_per_segment != samples_per_segment) operators_free(o);
    o->samples_per_segment = samples_per_segment;
    *f = &o->of[degree];
    return o->of[degree].matrix != NULL ? ORR_OK
                                        : eph_fit_init(degree, samples_per_segment, &o->of[degree], diag);
}

// Fits all segments of an arc, as long as the operator says; gives up at the first that misses by more than
// limit (pos_m, vel_mps; NULL: never).
static bool fit_segments(const eph_fit *f, const orr_orbit_arc *a, const double limit[2], fitted *out)
{
    size_t per_segment = f->samples - 1;
    double worst[2] = {0}, h = 0.5 * a->step_s * (double)per_segment;
    for (size_t g = 0; g * per_segment + 1 < a->n; g++) {
        size_t at = SIZE_MAX, first = g * per_segment;
        fit_segment(f, &a->sample[first], h, &out->coef[g * eph_block(f->degree)], worst, &at);
        if (at != SIZE_MAX) out->worst = a->t0 + (int64_t)(first + at) * (int64_t)nearbyint(a->step_s * 1e9);
        if (limit != NULL && (worst[0] > limit[0] || worst[1] > limit[1])) return false;
    }
    out->degree = f->degree;
    out->samples_per_segment = per_segment;
    out->pos_m = worst[0];
    out->vel_mps = worst[1];
    return true;
}

// With segments of so many samples: the lowest degree that is good enough, else the highest.
static orr_status fit_with(operators *o, const orr_orbit_arc *a, size_t per_segment, fitted *out,
                           orr_diag *diag)
{
    static const double good[2] = {GOOD_ENOUGH * EPH_MAX_POS_ERROR_M, GOOD_ENOUGH * EPH_MAX_VEL_ERROR_MPS};
    int highest = eph_fit_max_degree(per_segment);
    free(out->coef);
    out->coef = calloc((a->n - 1) / per_segment * eph_block(highest), sizeof *out->coef);
    if (out->coef == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the segments of an arc");
    for (int degree = EPH_MIN_DEGREE;; degree++) {
        const eph_fit *f;
        orr_status st = operator_of(o, degree, per_segment, &f, diag);
        if (st != ORR_OK) return st;
        if (fit_segments(f, a, degree < highest ? good : NULL, out)) return ORR_OK;
    }
}

// Smooth motion of a GNSS satellite needs degree 8 on 15 min and 11 on an hour; an edge of shadow needs all
// that the samples carry. So the degree is each arc's own. An orbit that is rougher than that (noise in the
// place of forces) is met at its samples by segments of few of them, at last by quintics from one sample to
// the next.
static orr_status fit_arc(operators *o, orr_sat sat, const orr_orbit_arc *a, fitted *out, orr_diag *diag)
{
    for (size_t per_segment = a->samples_per_segment; per_segment >= 1; per_segment--) {
        if (a->samples_per_segment % per_segment != 0) continue;
        orr_status st = fit_with(o, a, per_segment, out, diag);
        if (st != ORR_OK) return st;
        if (out->pos_m <= EPH_MAX_POS_ERROR_M && out->vel_mps <= EPH_MAX_VEL_ERROR_MPS) return ORR_OK;
    }
    char name[ORR_SAT_TEXT], when[ORR_TIME_TEXT]; // only rounding is left: numbers of no orbit
    return orr_diag_set(diag, ORR_E_NUMERIC, "no segment meets the smoothed orbit of %s near %s",
                        orr_sat_text(sat, name), orr_time_text(out->worst, when));
}

static orr_status fit_all(const orr_orbit_solution *s, fitted *fit, orr_ephemeris *counts, orr_diag *diag)
{
    operators o = {0};
    orr_status st = ORR_OK;
    size_t arc = 0;
    for (size_t i = 0; i < s->n_sats && st == ORR_OK; i++) {
        for (size_t k = 0; k < s->sat[i].n_arcs && st == ORR_OK; k++, arc++) {
            const orr_orbit_arc *a = &s->sat[i].arc[k];
            st = fit_arc(&o, s->sat[i].sat, a, &fit[arc], diag);
            if (st != ORR_OK) break;
            counts->n_segments += (a->n - 1) / fit[arc].samples_per_segment;
            counts->n_coefs += (a->n - 1) / fit[arc].samples_per_segment * eph_block(fit[arc].degree);
        }
    }
    operators_free(&o);
    return st;
}

orr_status eph_fit_satellites(const orr_orbit_solution *s, orr_backing *backing, orr_ephemeris **out,
                              orr_diag *diag)
{
    orr_ephemeris counts;
    *out = NULL;
    orr_status st = count(s, &counts, diag);
    if (st != ORR_OK) return st;
    counts.backing = backing;
    fitted *fit = calloc(counts.n_arcs + 1, sizeof *fit);
    if (fit == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu arcs", counts.n_arcs);
    st = fit_all(s, fit, &counts, diag);
    if (st == ORR_OK) st = eph_alloc(&counts, out, diag);
    if (st == ORR_OK) copy(s, fit, *out);
    for (size_t i = 0; i < counts.n_arcs; i++) free(fit[i].coef);
    free(fit);
    return st;
}

orr_status eph_describe(const orr_orbit_solution *s, orr_ephemeris *e, orr_diag *diag)
{
    if (s->n_sources > 0) memcpy(e->source, s->source, s->n_sources * sizeof *s->source);
    e->node_step_s = s->node_step_s;
    e->clock_max_gap_s = s->clock_max_gap_s;
    memcpy(e->options, s->options, sizeof e->options);
    memcpy(e->frame, s->frame, sizeof e->frame);
    e->options[sizeof e->options - 1] = e->frame[sizeof e->frame - 1] = '\0';
    orr_status st = eph_copy_clock_events(&s->clock_events, &e->clock_events);
    e->rotation = s->rotation;
    const orr_status copied = orr_eop_series_copy(&s->rotation.series, &e->rotation.series);
    if (st == ORR_OK) st = copied;
    return st == ORR_OK
               ? ORR_OK
               : orr_diag_set(diag, st, "no memory for the Earth's rotation and the events of clocks");
}

orr_status orr_ephemeris_build(const orr_orbit_solution *s, orr_ephemeris **out, orr_diag *diag)
{
    orr_status st = eph_fit_satellites(s, NULL, out, diag);
    if (st == ORR_OK) st = eph_describe(s, *out, diag);
    if (st == ORR_OK) st = eph_finish(*out, diag);
    if (st != ORR_OK) {
        orr_ephemeris_free(*out);
        *out = NULL;
    }
    return st;
}
