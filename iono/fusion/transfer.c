// SPDX-License-Identifier: GPL-3.0-or-later
// Delays for a receiver that need not be the station. What field and correction leave of the station's curves
// is a random field with a known covariance; at the new rays it is predicted from all the station's rays at
// once (least-squares collocation), and what the prediction does not know is filled with seeded noise of just
// that variance. So the total variance is the station's everywhere, and at the station's own rays the curve
// is the station's.
#include <math.h>

#include "core/linalg.h"
#include "core/rng.h"
#include "iono/fusion/session.h"

// An arc's weight is tapered near its ends, so that nothing jumps when it comes or goes.
#define FADE_S 300.0
#define SAME_SITE_M 1.0 // closer to the station than this it is the station

double orr_coloured_noise(uint64_t seed, orr_sat sat, orr_time t, double time_s)
{
    // A cubic B-spline of white numbers h apart has correlation 1/e at a lag of about 1.65 h (its own
    // autocorrelation).
    double h_ns = fmin(fmax(time_s / 1.18 * 1e9, 1e6), 1e18);
    int64_t step = (int64_t)h_ns, k = t / step;
    if (t % step < 0) k--;
    double u = (double)(t - k * step) / (double)step, v = 1 - u;
    double w[4] = {v * v * v / 6, (3 * u * u * u - 6 * u * u + 4) / 6, (3 * v * v * v - 6 * v * v + 4) / 6,
                   u * u * u / 6};
    double sum = 0, square = 0;
    for (int i = 0; i < 4; i++) {
        sum += w[i] * orr_rng_normal(seed, sat, (uint64_t)(k + i));
        square += w[i] * w[i];
    }
    return sum / sqrt(square);
}

// What the station says at t, ray by ray.
typedef struct seen {
    orr_sat sat;
    double residual, fade, sigma; // vertical; 0..1; of the arc's bias, slant
    orr_vec3 unit;
} seen;

static size_t see(const orr_session *s, orr_time t, seen *out)
{
    size_t n = 0;
    double gap = fmax(s->max_gap_s, 1.5 * s->interval_s);
    for (size_t a = 0; a < s->n_arcs && n < ORR_SESSION_MAX_SATS; a++) {
        const orr_session_arc *arc = &s->arc[a];
        const orr_session_sample *x = s->sample + arc->first;
        if (arc->n < 2 || t < x[0].t || t > x[arc->n - 1].t) continue;
        size_t lo = 0, hi = arc->n - 1;
        while (hi - lo > 1) {
            size_t mid = lo + (hi - lo) / 2;
            if (x[mid].t <= t)
                lo = mid;
            else
                hi = mid;
        }
        if (x[hi].t == t) lo = hi; // the last sample itself
        double span = orr_time_diff_s(x[hi].t, x[lo].t);
        if (span > gap) continue;
        double w = span > 0 ? orr_time_diff_s(t, x[lo].t) / span : 0;
        double age = fmin(orr_time_diff_s(t, x[0].t), orr_time_diff_s(x[arc->n - 1].t, t)) / FADE_S;
        out[n++] =
            (seen){arc->sat, (1 - w) * x[lo].residual_tecu + w * x[hi].residual_tecu,
                   age < 1 ? age * age * (3 - 2 * age) : 1, arc->sigma_tecu,
                   orr_vec3_unit(orr_vec3_axpy(w, orr_vec3_sub(x[hi].pierce, x[lo].pierce), x[lo].pierce))};
    }
    return n;
}

static orr_status rays(const orr_tec_instant *at, const orr_correction *correction, orr_vec3 site_m,
                       const orr_sat *sat, const orr_vec3 *sat_m, size_t n, orr_realisation *out,
                       size_t *n_out, orr_diag *diag)
{
    orr_iono_site site;
    orr_status s = orr_iono_site_at(site_m, &site, diag);
    if (s != ORR_OK) return s;
    *n_out = 0;
    for (size_t i = 0; i < n; i++) {
        orr_tec_ray r;
        if (orr_tec_look(at, &site, sat_m[i], &r, NULL) != ORR_OK) continue;
        double v =
            r.vtec_tecu + (correction != NULL ? orr_correction_at(correction, at->t, r.pierce.unit) : 0);
        out[(*n_out)++] = (orr_realisation){.sat = sat[i],
                                            .pierce = r.pierce,
                                            .mapping = r.mapping,
                                            .vtec_tecu = v,
                                            .stec_tecu = correction != NULL ? r.mapping * v : r.stec_tecu,
                                            .model_stec_tecu = r.stec_tecu,
                                            .sigma_tecu = r.sigma_tecu,
                                            .origin = ORR_ORIGIN_FIELD,
                                            .flags = r.flags};
    }
    return ORR_OK;
}

orr_status orr_field_realise(const orr_tec_field *f, orr_time t, orr_vec3 site_m, const orr_sat *sat,
                             const orr_vec3 *sat_m, size_t n, orr_realisation *out, size_t *n_out,
                             orr_diag *diag)
{
    orr_tec_instant at;
    *n_out = 0;
    orr_status s = orr_tec_field_at(f, t, &at, diag);
    return s == ORR_OK ? rays(&at, NULL, site_m, sat, sat_m, n, out, n_out, diag) : s;
}

orr_status orr_session_realise(const orr_session *s, orr_time t, orr_vec3 site_m, const orr_sat *sat,
                               const orr_vec3 *sat_m, size_t n, const orr_transfer_options *options,
                               orr_realisation *out, size_t *n_out, orr_diag *diag)
{
    *n_out = 0;
    if (n > ORR_SESSION_MAX_SATS)
        return orr_diag_set(diag, ORR_E_LIMIT, "%zu satellites in one question; %d are the limit", n,
                            ORR_SESSION_MAX_SATS);
    orr_transfer_options o = options != NULL ? *options : (orr_transfer_options){.seed = 1, .noise = true};
    bool inside = t >= s->from && t <= s->to;
    orr_tec_instant at;
    orr_status status = orr_tec_field_at(s->field, t, &at, diag);
    if (status == ORR_OK)
        status = rays(&at, inside ? &s->correction : NULL, site_m, sat, sat_m, n, out, n_out, diag);
    if (status != ORR_OK || !inside) return status;

    enum { MOST = 96 }; // rays of a station; more tell nothing new
    seen ray[ORR_SESSION_MAX_SATS];
    double k[MOST * MOST], y[MOST], c[MOST];
    size_t m = see(s, t, ray);
    if (m > MOST) m = MOST;
    double variance = s->small.sigma_tecu * s->small.sigma_tecu;
    double radius = orr_tec_field_shell_radius_m(s->field), per_unit = radius / s->small.length_m;
    for (size_t i = 0; i < m; i++) {
        for (size_t j = 0; j < i; j++)
            k[i * m + j] = variance * exp(-per_unit * orr_vec3_norm(orr_vec3_sub(ray[i].unit, ray[j].unit)));
        double f = fmax(ray[i].fade, 1e-3);
        k[i * m + i] = variance / (f * f) + 1e-9;
        y[i] = ray[i].residual;
    }
    // A ray without an arc of its own has the typical uncertainty of the arcs.
    double typical = 0, arcs = 0;
    for (size_t i = 0; i < m; i++)
        if (!isnan(ray[i].sigma)) {
            typical += ray[i].sigma * ray[i].sigma;
            arcs++;
        }
    typical = arcs > 0 ? sqrt(typical / arcs) : 0;
    // y := L^-1 y, c := L^-1 c: predictions and their variances are products of the two.
    status = orr_cholesky_factor(k, m, 0);
    if (status == ORR_OK) status = orr_cholesky_solve_lower(k, m, y);
    if (status != ORR_OK)
        return orr_diag_set(diag, status, "the covariance of the session's %zu rays is singular", m);
    bool home = orr_vec3_norm(orr_vec3_sub(site_m, s->site.pos_m)) < SAME_SITE_M;
    for (size_t i = 0; i < *n_out; i++) {
        orr_realisation *r = &out[i];
        const seen *own = NULL;
        for (size_t j = 0; j < m; j++) {
            if (ray[j].sat == r->sat) own = &ray[j];
            c[j] = variance * exp(-per_unit * orr_vec3_norm(orr_vec3_sub(r->pierce.unit, ray[j].unit)));
        }
        double residual = 0, left = variance;
        if (home && own != NULL) { // the station's own curve, whatever the covariance says
            residual = own->residual;
            left = 0;
            r->origin = ORR_ORIGIN_FUSED;
        } else {
            if (orr_cholesky_solve_lower(k, m, c) != ORR_OK) return ORR_E_NUMERIC;
            for (size_t j = 0; j < m; j++) {
                residual += c[j] * y[j];
                left -= c[j] * c[j];
            }
            if (left < 0) left = 0;
            if (o.noise) residual += sqrt(left) * orr_coloured_noise(o.seed, r->sat, t, s->small.time_s);
            r->origin = own != NULL ? ORR_ORIGIN_TRANSFERRED : ORR_ORIGIN_NOISE;
        }
        r->vtec_tecu += residual;
        if (r->vtec_tecu < 0 && r->origin != ORR_ORIGIN_FUSED) {
            r->vtec_tecu = 0;
            r->flags |= ORR_TEC_CLIPPED;
        }
        r->stec_tecu = r->mapping * r->vtec_tecu;
        double bias = own != NULL && !isnan(own->sigma) ? own->sigma : typical;
        r->sigma_tecu = sqrt(bias * bias + r->mapping * r->mapping * left);
    }
    return ORR_OK;
}
