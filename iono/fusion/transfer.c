// SPDX-License-Identifier: GPL-3.0-or-later
// Delays for a receiver that need not be the station. What field and correction leave of the station's curves has two
// parts: a random field on the shell with a known covariance, and an offset of each satellite (its arc's bias is not
// exact), which goes along to every receiver. At the new rays both are predicted from all the station's rays at once
// (least-squares collocation). What the prediction does not know is made by conditional simulation: a seeded random
// field is drawn everywhere, and the collocation is of the differences from it. So there is one realisation for the
// station and its neighbours: at the station's own rays it is the station's curve, two satellites that nobody saw are
// alike where they stand in one direction, and everything moves continuously.
//
// Nothing jumps, nor does its rate: between samples the station's curve is a monotone cubic; beyond an arc's end its last residual is held while its weight falls; arcs of one satellite that follow
// each other are joined by a ramp; beyond the session's ends all of it tapers off.
#include <math.h>

#include "core/limb.h"
#include "core/linalg.h"
#include "core/rng.h"
#include "iono/fusion/session.h"

#define FADE_S 900.0    // beyond an arc's end
#define REST_S 60.0     // and so the pierce point comes to rest there
#define JOIN_S 1800.0   // arcs closer than this are joined
#define RAMP_S 450.0    // at most so much of either arc is bent towards the other
#define TAPER_S 1800.0  // beyond the session's ends
#define SAME_SITE_M 1.0 // closer to the station than this it is the station
#define LEAST_FADE 1e-3 // weight of an observation that is as good as none
enum { MOST = 96 };     // rays of a station; more tell nothing new

// 1 to 0 as x goes from 0 to 1, smooth at both ends.
static double falling(double x)
{
    if (!(x > 0)) return 1;
    return x < 1 ? 1 - x * x * (3 - 2 * x) : 0;
}

// Weights of a cubic B-spline at u in [0, 1) of an interval of its lattice, divided by their own length, so that the
// sum with independent unit normals has variance 1 everywhere.
static void spline_weights(double u, double w[4])
{
    double v = 1 - u, square = 0;
    w[0] = v * v * v / 6;
    w[1] = (3 * u * u * u - 6 * u * u + 4) / 6;
    w[2] = (3 * v * v * v - 6 * v * v + 4) / 6;
    w[3] = u * u * u / 6;
    for (int i = 0; i < 4; i++) square += w[i] * w[i];
    for (int i = 0; i < 4; i++) w[i] /= sqrt(square);
}

// The lattice's step for a correlation of 1/e at `scale`: a cubic B-spline of white numbers h apart has it at a lag of
// about 1.18 h.
#define LATTICE(scale) ((scale) / 1.18)

static int64_t time_cell(orr_time t, double time_s, double *u)
{
    double h_ns = fmin(fmax(LATTICE(time_s) * 1e9, 1e6), 1e18);
    int64_t step = (int64_t)h_ns, k = t / step;
    if (t % step < 0) k--;
    *u = (double)(t - k * step) / (double)step;
    return k;
}

double orr_coloured_noise(uint64_t seed, orr_sat sat, orr_time t, double time_s)
{
    double u, w[4], sum = 0;
    int64_t k = time_cell(t, time_s, &u);
    spline_weights(u, w);
    for (int i = 0; i < 4; i++) sum += w[i] * orr_rng_normal(seed, sat, (uint64_t)(k + i));
    return sum;
}

double orr_shell_noise(uint64_t seed, double east, double north, orr_time t, double time_s)
{
    double x = east / LATTICE(1), y = north / LATTICE(1), x0 = floor(x), y0 = floor(y), wx[4], wy[4], wt[4],
           u, sum = 0;
    int64_t k = time_cell(t, time_s, &u);
    spline_weights(x - x0, wx);
    spline_weights(y - y0, wy);
    spline_weights(u, wt);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            uint64_t column = ((uint64_t)(uint32_t)((int64_t)x0 + i) << 32) | (uint32_t)((int64_t)y0 + j);
            double in_time = 0;
            for (int l = 0; l < 4; l++)
                in_time += wt[l] * orr_rng_normal(seed ^ UINT64_C(0x73686c6c), column, (uint64_t)(k + l));
            sum += wx[i] * wy[j] * in_time;
        }
    return sum;
}

// What the station says of a satellite at t.
typedef struct seen {
    orr_sat sat;
    bool inside;                  // of an arc; else it is carried on from its end, or across a gap
    double residual, fade, sigma; // vertical; 0..1; of the arc's bias, slant
    orr_vec3 unit;
} seen;

// By the second, at a sample.
typedef struct curve_slopes {
    double residual;
    orr_vec3 pierce;
} curve_slopes;

static const orr_session_sample *first_of(const orr_session *s, const orr_session_arc *a)
{
    return &s->sample[a->first];
}
static const orr_session_sample *last_of(const orr_session *s, const orr_session_arc *a)
{
    return &s->sample[a->first + a->n - 1];
}

// How far a ramp from arc a to arc b has come at t, and the step it bridges. False where they are not joined.
static bool ramp(const orr_session *s, const orr_session_arc *a, const orr_session_arc *b, orr_time t,
                 double *step, double *part)
{
    const orr_session_sample *end = last_of(s, a), *start = first_of(s, b);
    double gap = orr_time_diff_s(start->t, end->t);
    if (gap > JOIN_S) return false;
    double before = fmin(RAMP_S, orr_time_diff_s(end->t, first_of(s, a)->t) / 2),
           after = fmin(RAMP_S, orr_time_diff_s(last_of(s, b)->t, start->t) / 2);
    *step = start->residual_tecu - end->residual_tecu;
    *part = 1 - falling((orr_time_diff_s(t, end->t) + before) / (before + gap + after));
    return true;
}

// Between x and y at t, on curves of residual and pierce point that go through them with these changes per second.
static seen between(const orr_session_arc *arc, const orr_session_sample *x, const orr_session_sample *y,
                    const curve_slopes slope[2], orr_time t)
{
    const double T = orr_time_diff_s(y->t, x->t), u = T > 0 ? orr_time_diff_s(t, x->t) / T : 0;
    const double w = u * u * (3 - 2 * u), a = T * u * (1 - u) * (1 - u), b = -T * u * u * (1 - u);
    const orr_vec3 along = orr_vec3_axpy(w, orr_vec3_sub(y->pierce, x->pierce), x->pierce);
    return (seen){arc->sat,
                  true,
                  x->residual_tecu + w * (y->residual_tecu - x->residual_tecu) + a * slope[0].residual +
                      b * slope[1].residual,
                  1,
                  arc->sigma_tecu,
                  orr_vec3_unit(orr_vec3_axpy(a, slope[0].pierce, orr_vec3_axpy(b, slope[1].pierce, along)))};
}

// Change of a residual at the middle one of three samples, from the slopes before and after it over h and k seconds: that of the
// parabola through them, held back so that nothing rises above the samples or falls below them (Steffen 1990).
static double monotone_slope(double before, double h, double after, double k)
{
    if (!(before * after > 0)) return 0;
    const double parabola = (before * k + after * h) / (h + k);
    return copysign(fmin(fabs(parabola), 2 * fmin(fabs(before), fabs(after))), before);
}

// The changes at sample i of an arc's n: of the parabola through it and its neighbours. At an arc's end the residual rests, because
// it is held beyond; the pierce point moves on.
static curve_slopes slopes_at(const orr_session_sample *x, size_t i, size_t n)
{
    const orr_session_sample *p = &x[i > 0 ? i - 1 : 0], *q = &x[i], *r = &x[i + 1 < n ? i + 1 : i];
    const double h = orr_time_diff_s(q->t, p->t), k = orr_time_diff_s(r->t, q->t);
    curve_slopes before = {0}, after = {0};
    if (h > 0) {
        before.residual = (q->residual_tecu - p->residual_tecu) / h;
        before.pierce = orr_vec3_scale(1 / h, orr_vec3_sub(q->pierce, p->pierce));
    }
    if (k > 0) {
        after.residual = (r->residual_tecu - q->residual_tecu) / k;
        after.pierce = orr_vec3_scale(1 / k, orr_vec3_sub(r->pierce, q->pierce));
    }
    if (!(h > 0 && k > 0)) return (curve_slopes){0, h > 0 ? before.pierce : after.pierce};
    return (curve_slopes){
        monotone_slope(before.residual, h, after.residual, k),
        orr_vec3_axpy(k / (h + k), before.pierce, orr_vec3_scale(h / (h + k), after.pierce))};
}

// What an arc's sample i, its first or last, says `beyond_s` seconds outside of the arc (negative: before it): its residual, where its
// pierce point comes to rest.
static seen held(const orr_session_arc *arc, const orr_session_sample *first, size_t i, double beyond_s)
{
    const orr_session_sample *x = &first[i];
    const double moved_s = copysign(REST_S * -expm1(-fabs(beyond_s) / REST_S), beyond_s);
    return (seen){arc->sat,
                  false,
                  x->residual_tecu,
                  falling(fabs(beyond_s) / FADE_S),
                  arc->sigma_tecu,
                  orr_vec3_unit(orr_vec3_axpy(moved_s, slopes_at(first, i, arc->n).pierce, x->pierce))};
}

static seen inside(const orr_session *s, const orr_session_arc *arc, orr_time t)
{
    const orr_session_sample *x = first_of(s, arc);
    size_t lo = 0, hi = arc->n - 1;
    while (hi - lo > 1) {
        size_t mid = lo + (hi - lo) / 2;
        if (x[mid].t <= t)
            lo = mid;
        else
            hi = mid;
    }
    const curve_slopes slope[2] = {slopes_at(x, lo, arc->n), slopes_at(x, hi, arc->n)};
    return between(arc, &x[lo], &x[hi], slope, t);
}

// One satellite's arcs [from, to), in time order. False where it says nothing at t.
static bool see_satellite(const orr_session *s, size_t from, size_t to, orr_time t, seen *out)
{
    const orr_session_arc *before = NULL, *in = NULL, *after = NULL;
    for (size_t a = from; a < to; a++) {
        const orr_session_arc *arc = &s->arc[a];
        if (arc->n < 2) continue;
        if (last_of(s, arc)->t < t)
            before = arc;
        else if (first_of(s, arc)->t <= t && in == NULL)
            in = arc;
        else if (after == NULL)
            after = arc;
    }
    double step, part;
    if (in != NULL) {
        *out = inside(s, in, t);
        if (before != NULL && ramp(s, before, in, t, &step, &part)) out->residual -= (1 - part) * step;
        if (after != NULL && ramp(s, in, after, t, &step, &part)) out->residual += part * step;
        return true;
    }
    if (before != NULL && after != NULL && ramp(s, before, after, t, &step, &part)) {
        const curve_slopes ends[2] = {slopes_at(first_of(s, before), before->n - 1, before->n),
                                      slopes_at(first_of(s, after), 0, after->n)};
        *out = between(before, last_of(s, before), first_of(s, after), ends, t);
        out->residual = last_of(s, before)->residual_tecu + part * step;
        out->inside = false;
        return true;
    }
    double since = before != NULL ? orr_time_diff_s(t, last_of(s, before)->t) : FADE_S,
           until = after != NULL ? orr_time_diff_s(first_of(s, after)->t, t) : FADE_S;
    if (since < FADE_S)
        *out = held(before, first_of(s, before), before->n - 1, since);
    else if (until < FADE_S)
        *out = held(after, first_of(s, after), 0, -until);
    else
        return false;
    return out->fade > LEAST_FADE;
}

static size_t see(const orr_session *s, orr_time t, seen out[MOST])
{
    size_t n = 0;
    for (size_t a = 0, end; a < s->n_arcs && n < MOST; a = end) {
        for (end = a + 1; end < s->n_arcs && s->arc[end].sat == s->arc[a].sat;) end++;
        if (see_satellite(s, a, end, t, &out[n])) n++;
    }
    return n;
}

// Field and `part` of the correction along the rays; correction NULL: the field's own slant.
static orr_status rays(const orr_tec_instant *at, const orr_correction *correction, double part,
                       orr_vec3 site_m, const orr_sat *sat, const orr_vec3 *sat_m, size_t n,
                       orr_realisation *out, size_t *n_out, orr_diag *diag)
{
    orr_iono_site site;
    orr_status s = orr_iono_site_at(site_m, &site, diag);
    if (s != ORR_OK) return s;
    *n_out = 0;
    for (size_t i = 0; i < n; i++) {
        orr_tec_ray r;
        if (orr_tec_look(at, &site, sat_m[i], &r, NULL) != ORR_OK) continue;
        double v = r.vtec_tecu;
        if (correction != NULL)
            v += part * orr_correction_at(correction, at->t, r.pierce.unit, r.vtec_tecu, r.mapping);
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
    return s == ORR_OK ? rays(&at, NULL, 0, site_m, sat, sat_m, n, out, n_out, diag) : s;
}

// What is left of the station's curves at one instant.
typedef struct structure {
    const orr_session *s;
    orr_transfer_options o;
    orr_time t;
    double variance, own; // of the residuals; the part of it that belongs to satellites and not to places
    double per_unit;      // shell radius over correlation length
    double typical;       // sigma of an arc's bias, slant, where a satellite has no arc
    size_t m;
    seen ray[MOST];
    double k[MOST * MOST],
        y[MOST]; // Cholesky factor of the rays' covariance; L^-1 (residuals - what was drawn)
} structure;

static double covariance(const structure *x, orr_vec3 a, orr_vec3 b)
{
    return (x->variance - x->own) * exp(-x->per_unit * orr_vec3_norm(orr_vec3_sub(a, b)));
}

// The seeded random field and offset at a ray; 0 where the expectation is asked for.
static double drawn(const structure *x, orr_sat sat, orr_vec3 unit)
{
    if (!x->o.noise) return 0;
    const orr_correction *c = &x->s->correction;
    double east = x->per_unit * orr_vec3_dot(unit, c->east),
           north = x->per_unit * orr_vec3_dot(unit, c->north);
    return sqrt(x->variance - x->own) * orr_shell_noise(x->o.seed, east, north, x->t, x->s->small.time_s) +
           sqrt(x->own) * orr_coloured_noise(x->o.seed, sat, x->t, x->s->small.time_s);
}

static orr_status prepare(structure *x, orr_diag *diag)
{
    double arcs = 0, square = 0;
    for (size_t i = 0; i < x->s->n_arcs; i++)
        if (!isnan(x->s->arc[i].sigma_tecu)) {
            square += x->s->arc[i].sigma_tecu * x->s->arc[i].sigma_tecu;
            arcs++;
        }
    x->typical = arcs > 0 ? sqrt(square / arcs) : 0;
    x->variance = x->s->small.sigma_tecu * x->s->small.sigma_tecu;
    x->own = x->s->small.own_tecu * x->s->small.own_tecu;
    x->per_unit = orr_tec_field_shell_radius_m(x->s->field) / x->s->small.length_m;
    x->m = see(x->s, x->t, x->ray);
    for (size_t i = 0; i < x->m; i++) {
        const seen *r = &x->ray[i];
        for (size_t j = 0; j < i; j++) x->k[i * x->m + j] = covariance(x, r->unit, x->ray[j].unit);
        x->k[i * x->m + i] = x->variance / (r->fade * r->fade) + 1e-9;
        x->y[i] = r->residual - drawn(x, r->sat, r->unit);
    }
    orr_status s = orr_cholesky_factor(x->k, x->m, 0);
    if (s == ORR_OK) s = orr_cholesky_solve_lower(x->k, x->m, x->y);
    return s == ORR_OK ? ORR_OK
                       : orr_diag_set(diag, s, "the covariance of the session's %zu rays is singular", x->m);
}

// The residual at a ray, the variance that is left in it, and the station's own ray to the same satellite or NULL.
static orr_status predict(const structure *x, orr_sat sat, orr_vec3 unit, double *residual, double *left,
                          const seen **own)
{
    double c[MOST];
    *own = NULL;
    for (size_t j = 0; j < x->m; j++) {
        c[j] = covariance(x, unit, x->ray[j].unit);
        if (x->ray[j].sat != sat) continue;
        *own = &x->ray[j];
        c[j] += x->own;
    }
    if (orr_cholesky_solve_lower(x->k, x->m, c) != ORR_OK) return ORR_E_NUMERIC;
    *residual = drawn(x, sat, unit);
    *left = x->variance;
    for (size_t j = 0; j < x->m; j++) {
        *residual += c[j] * x->y[j];
        *left -= c[j] * c[j];
    }
    *left = fmax(*left, 0);
    return ORR_OK;
}

// How much of the session is in force: 1 within it, falling to 0 beyond its ends.
static double in_force(const orr_session *s, orr_time t)
{
    double beyond = fmax(orr_time_diff_s(s->from, t), orr_time_diff_s(t, s->to));
    return falling(beyond / TAPER_S);
}

orr_status orr_session_realise(const orr_session *s, orr_time t, orr_vec3 site_m, const orr_sat *sat,
                               const orr_vec3 *sat_m, size_t n, const orr_transfer_options *options,
                               orr_realisation *out, size_t *n_out, orr_diag *diag)
{
    *n_out = 0;
    if (n > ORR_SESSION_MAX_SATS)
        return orr_diag_set(diag, ORR_E_LIMIT, "%zu satellites in one question; %d are the limit", n,
                            ORR_SESSION_MAX_SATS);
    const double part = orr_limb_in_space(site_m) ? 0 : in_force(s, t); // what the station saw lies below
    orr_tec_instant at;
    orr_status status = orr_tec_field_at(s->field, t, &at, diag);
    if (status == ORR_OK)
        status = rays(&at, part > 0 ? &s->correction : NULL, part, site_m, sat, sat_m, n, out, n_out, diag);
    if (status != ORR_OK || !(part > 0)) return status;

    structure x = {
        .s = s, .o = options != NULL ? *options : (orr_transfer_options){.seed = 1, .noise = true}, .t = t};
    status = prepare(&x, diag);
    if (status != ORR_OK) return status;
    const bool home = orr_vec3_norm(orr_vec3_sub(site_m, s->site.pos_m)) < SAME_SITE_M;
    for (size_t i = 0; i < *n_out; i++) {
        orr_realisation *r = &out[i];
        const seen *own;
        double residual, left;
        if (predict(&x, r->sat, r->pierce.unit, &residual, &left, &own) != ORR_OK) return ORR_E_NUMERIC;
        r->origin = own == NULL || !own->inside ? ORR_ORIGIN_NOISE
                    : home                      ? ORR_ORIGIN_FUSED
                                                : ORR_ORIGIN_TRANSFERRED;
        r->vtec_tecu += part * residual;
        if (r->vtec_tecu < 0) {
            r->vtec_tecu = 0;
            r->flags |= ORR_TEC_CLIPPED;
        }
        r->stec_tecu = r->mapping * r->vtec_tecu;
        double bias = own != NULL && !isnan(own->sigma) ? own->sigma : x.typical;
        r->sigma_tecu = sqrt(bias * bias + r->mapping * r->mapping * left);
    }
    return ORR_OK;
}
