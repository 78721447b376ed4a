// SPDX-License-Identifier: GPL-3.0-or-later
// The arithmetic of an evaluation, in pieces that are inlined where satellites come one by one (ephemeris_eval.c) and side by
// side (ephemeris_slice.c), so that all give the same bits.
#ifndef ORR_ORBIT_EPHEMERIS_EPHEMERIS_AT_H
#define ORR_ORBIT_EPHEMERIS_EPHEMERIS_AT_H

#include <math.h>
#include <string.h>

#include "orbit/ephemeris/ephemeris_private.h"

// Rows of coefficients as the vector unit has them. Lanes are independent and nothing is contracted, so that
// the bits do not depend on how wide the machine is.
typedef double lanes __attribute__((vector_size(EPH_LANES * sizeof(double)), may_alias));
typedef float positions __attribute__((vector_size((EPH_SIGMAS - 1) * sizeof(float)))); // sigmas of positions
#define INLINE static inline __attribute__((always_inline))

// T_j and its first two derivatives at one x.
typedef struct basis {
    double x;
    int degree;
    double t[EPH_MAX_DEGREE + 2], d[EPH_MAX_DEGREE + 2], dd[EPH_MAX_DEGREE + 2];
} basis;

// By steps of two, T_j+2 = (4 x^2 - 2) T_j - T_j-2 and its derivatives: two short chains instead of one long.
INLINE void basis_at(basis *b, int degree, double x)
{
    double x8 = 8.0 * x, x16 = 16.0 * x, xx = x * x, c = 4.0 * xx - 2.0;
    b->x = x;
    b->degree = degree;
    b->t[0] = 1.0, b->d[0] = 0.0, b->dd[0] = 0.0;
    b->t[1] = x, b->d[1] = 1.0, b->dd[1] = 0.0;
    b->t[2] = 2.0 * xx - 1.0, b->d[2] = 4.0 * x, b->dd[2] = 4.0;
    b->t[3] = (c - 1.0) * x, b->d[3] = 12.0 * xx - 3.0, b->dd[3] = 24.0 * x;
    for (int j = 4; j <= degree; j++) {
        double t = b->t[j - 2], d = b->d[j - 2];
        b->t[j] = c * t - b->t[j - 4];
        b->d[j] = c * d + (x8 * t - b->d[j - 4]);
        b->dd[j] = c * b->dd[j - 2] + ((x16 * d + 8.0 * t) - b->dd[j - 4]);
    }
}

// Sums over the rows of one segment. The two largest terms come last, so that the small ones are not rounded
// to them, and the sum can begin before the basis is complete.
INLINE void sum_rows(const double *coef, const basis *b, int degree, double dx, orr_sat_state *out)
{
    const lanes *c = (const lanes *)(const void *)coef;
    lanes p = b->t[2] * c[2], v = b->d[2] * c[2], a = b->dd[2] * c[2];
    for (int j = 3; j <= degree; j++) {
        p += b->t[j] * c[j];
        v += b->d[j] * c[j];
        a += b->dd[j] * c[j];
    }
    p += b->t[1] * c[1];
    v += c[1];
    p += c[0];
    v *= dx;
    a *= dx * dx;
    out->pos_m = (orr_vec3){p[0], p[1], p[2]};
    out->vel_mps = (orr_vec3){v[0], v[1], v[2]};
    out->acc_mps2 = (orr_vec3){a[0], a[1], a[2]};
}

// Where t lies in an arc.
typedef struct place {
    size_t segment, sample; // the sample is counted in the segment
    int64_t rest_ns;        // since the segment's begin
    double x;               // in the segment, [-1, 1]
    float part;             // way from the sample to the next, [0, 1]
} place;

// Without a division.
INLINE void place_at(const eph_arc *a, orr_time t, place *p)
{
    int64_t dt = t - a->t0;
    int64_t i = (int64_t)((double)dt * a->per_segment_ns), last = (int64_t)a->n_segments - 1;
    if (i > last) i = last; // the arc's end belongs to its last segment
    int64_t rest = dt - i * a->segment_ns;
    if (rest < 0) { // the product was rounded up to the next whole number
        i--;
        rest += a->segment_ns;
    } else if (rest >= a->segment_ns && i < last) {
        i++;
        rest -= a->segment_ns;
    }
    p->segment = (size_t)i;
    p->rest_ns = rest;
    p->x = (double)(2 * rest - a->segment_ns) * a->per_segment_ns;
    double u = 0.5 * (p->x + 1.0) * (double)(int64_t)a->samples_per_segment;
    int64_t k = (int64_t)u, last_sample = (int64_t)a->samples_per_segment - 1;
    k = k < last_sample ? k : last_sample;
    p->sample = (size_t)k;
    p->part = (float)(u - (double)k);
}

// The arc that holds t, the later one where two meet; NULL in a gap.
INLINE const eph_arc *arc_at(const eph_sat *s, orr_time t)
{
    for (size_t k = s->n_arcs; k-- > 0;) {
        const eph_arc *a = &s->arc[k];
        if (t >= a->t0) return t <= a->t1 ? a : NULL;
    }
    return NULL;
}

INLINE uint32_t mixed_flags(const orr_ephemeris *e, const eph_sat *s, const eph_arc *a, size_t segment,
                            int64_t rest_ns, orr_time t)
{
    int64_t sample_ns = a->segment_ns / (int64_t)a->samples_per_segment;
    size_t k = (size_t)(rest_ns / sample_ns);
    uint32_t flags = e->sample_flags[a->first_sample + segment * a->samples_per_segment + k];
    size_t low = 0, high = s->n_spans; // spans before `low` have begun, those from `high` on have not
    while (low < high) {
        size_t mid = low + (high - low) / 2;
        if (s->span[mid].t0 <= t)
            low = mid + 1;
        else
            high = mid;
    }
    while (low-- > 0 && s->span[low].reach >= t)
        if (s->span[low].t1 >= t) flags |= s->span[low].flag;
    return flags;
}

// Index of the last clock node not after t; t is not before the first. `hint` is where another satellite's was.
INLINE size_t clock_before(const eph_sat *s, orr_time t, size_t hint)
{
    enum { WALK = 4 }; // a few nodes more or less than even spacing has: days' joints
    size_t last = s->n_clocks - 1;
    if (hint < last && s->rate[hint].t <= t && t < s->rate[hint + 1].t) return hint;
    double guess = (double)(t - s->rate[0].t) * s->clock_per_ns;
    size_t i = guess < (double)last ? (size_t)guess : last;
    for (int k = 0; k < WALK && i > 0 && s->rate[i].t > t; k++) i--;
    for (int k = 0; k < WALK && i < last && s->rate[i + 1].t <= t; k++) i++;
    if (s->rate[i].t <= t && (i == last || t < s->rate[i + 1].t)) return i;
    size_t low = 0, high = s->n_clocks; // clock[low].t <= t < clock[high].t
    while (high - low > 1) {
        size_t mid = low + (high - low) / 2;
        if (s->rate[mid].t <= t)
            low = mid;
        else
            high = mid;
    }
    return low;
}

// The end of a stretch still has a clock: its last node, with the rate that leads there.
INLINE const eph_clock *stretch_end(const eph_sat *s, size_t i, orr_time t)
{
    if (s->rate[i].t != t) return NULL;
    while (i > 0 && s->rate[i - 1].t == t) i--;
    return i > 0 && s->rate[i - 1].flags != 0 ? &s->rate[i - 1] : NULL;
}

// The clock within the interval that begins with node c.
INLINE void clock_in(const eph_sat *s, const eph_clock *c, orr_time t, orr_sat_state *out)
{
    const double part = (double)(t - c->t) * c->per_ns;
    const double given_s2 = (double)c->sigma2_s2 + part * (double)(c->next_s2 - c->sigma2_s2);
    double between_s2;
    orr_clock_interval_at(&c->way, &part, &out->clock_s, &out->clock_rate_sps);
    orr_clock_between_s2(&s->clock_noise, &c->way.length_s, &part, &between_s2);
    out->clock_sigma_s = (float)sqrt(EPH_CLOCK_ROUNDING_S2 + given_s2 + between_s2);
    out->flags |= c->flags;
}

INLINE void clock_at(const eph_sat *s, orr_time t, size_t *hint, orr_sat_state *out)
{
    out->clock_s = out->clock_rate_sps = (double)NAN;
    out->clock_sigma_s = (float)NAN;
    if (s->n_clocks == 0 || t < s->rate[0].t) return;
    size_t i = *hint = clock_before(s, t, *hint);
    const eph_clock *c = &s->rate[i];
    if (c->flags == 0 && (c = stretch_end(s, i, t)) == NULL) return;
    clock_in(s, c, t, out);
}

// Between two samples, a straight line: the positions' as one vector, then the velocity's.
INLINE void sigma_at(float (*sample)[EPH_SIGMAS], float part, orr_sat_state *out)
{
    positions first, next;
    memcpy(&first, sample[0], sizeof first);
    memcpy(&next, sample[1], sizeof next);
    const positions now = first + part * (next - first);
    out->sigma_m = now[0];
    for (int k = 0; k < 3; k++) out->sigma_rtn_m[k] = now[1 + k];
    out->sigma_mps = sample[0][4] + part * (sample[1][4] - sample[0][4]);
}

// All of a state but what the rows tell.
INLINE void rest_at(const orr_ephemeris *e, size_t slot, const eph_arc *a, orr_time t, const place *at,
                    size_t *hint, orr_sat_state *out)
{
    const eph_sat *s = &e->sat[slot];
    out->sat = e->sat_id[slot];
    out->valid_from = a->t0;
    out->valid_to = a->t1;
    sigma_at(&e->sigma[a->first_sample + at->segment * a->samples_per_segment + at->sample], at->part, out);
    const eph_meta *m = &e->meta[a->first_segment + at->segment];
    out->flags = m->mixed ? mixed_flags(e, s, a, at->segment, at->rest_ns, t) : m->flags;
    clock_at(s, t, hint, out);
}

INLINE const double *rows_of(const orr_ephemeris *e, const eph_arc *a, size_t segment)
{
    return &e->coef[a->first_coef + segment * eph_block(a->degree)];
}

INLINE orr_status eval(const orr_ephemeris *e, orr_sat sat, orr_time t, orr_sat_state *out)
{
    if (t < e->from || t > e->to) return ORR_E_RANGE;
    if (sat >= sizeof e->slot / sizeof e->slot[0] || e->slot[sat] < 0) return ORR_E_NODATA;
    size_t slot = (size_t)e->slot[sat];
    const eph_arc *a = arc_at(&e->sat[slot], t);
    if (a == NULL) return ORR_E_NODATA;
    basis b;
    place at;
    place_at(a, t, &at);
    basis_at(&b, a->degree, at.x);
    sum_rows(rows_of(e, a, at.segment), &b, a->degree, a->dx_dt, out);
    size_t hint = SIZE_MAX;
    rest_at(e, slot, a, t, &at, &hint, out);
    return ORR_OK;
}

INLINE bool same_shape(const eph_arc *a, const eph_arc *b)
{
    return a->t0 == b->t0 && a->segment_ns == b->segment_ns && a->n_segments == b->n_segments &&
           a->samples_per_segment == b->samples_per_segment;
}

// All satellites that have an arc at t; how many.
// Given:
//   e    the product
//   t    the instant
//   max  room
// Returned:
//   out  states: one behind the other, or with `has` each at its satellite's index
//   has  [n_sats] whether it has an arc; may be NULL
INLINE size_t eval_all(const orr_ephemeris *e, orr_time t, orr_sat_state *out, size_t max, bool *has)
{
    size_t n = 0, hint = SIZE_MAX;
    basis b;
    b.degree = -1;
    b.x = 0;
    place at = {0};
    const eph_arc *before = NULL; // arcs of the same shape share the place and the basis
    for (size_t i = 0; i < e->n_sats && n < max; i++) {
        const eph_arc *a = arc_at(&e->sat[i], t);
        if (has != NULL) has[i] = a != NULL;
        if (a == NULL) continue;
        if (before == NULL || !same_shape(a, before)) place_at(a, t, &at);
        before = a;
        if (b.degree < a->degree || b.x != at.x) basis_at(&b, a->degree, at.x);
        orr_sat_state *s = &out[has != NULL ? i : n];
        sum_rows(rows_of(e, a, at.segment), &b, a->degree, a->dx_dt, s);
        rest_at(e, i, a, t, &at, &hint, s);
        n++;
    }
    return n;
}

#endif
