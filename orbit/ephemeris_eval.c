// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluation: the product and a time in, states out. One routine does the arithmetic whoever asks, so that
// one satellite and the whole constellation give the same bits.
#include <math.h>
#include <string.h>

#include "orbit/ephemeris_impl.h"

// T_j and its first two derivatives at one x.
typedef struct basis {
    double x;
    int degree; // -1: nothing yet
    double t[EPH_MAX_DEGREE + 1], d[EPH_MAX_DEGREE + 1], dd[EPH_MAX_DEGREE + 1];
} basis;

static void basis_at(basis *b, int degree, double x)
{
    if (b->degree >= degree && b->x == x) return;
    double x2 = 2.0 * x;
    b->x = x;
    b->degree = degree;
    b->t[0] = 1.0, b->d[0] = 0.0, b->dd[0] = 0.0;
    b->t[1] = x, b->d[1] = 1.0, b->dd[1] = 0.0;
    for (int j = 1; j < degree; j++) {
        b->t[j + 1] = x2 * b->t[j] - b->t[j - 1];
        b->d[j + 1] = (x2 * b->d[j] + 2.0 * b->t[j]) - b->d[j - 1];
        b->dd[j + 1] = (x2 * b->dd[j] + 4.0 * b->d[j]) - b->dd[j - 1];
    }
}

// Sums over the rows of one segment; the four lanes are independent, which the compiler turns into vectors.
static void sum_rows(const double *restrict c, const basis *restrict b, int degree,
                     double p[restrict EPH_LANES], double v[restrict EPH_LANES], double a[restrict EPH_LANES])
{
    for (int k = 0; k < EPH_LANES; k++) p[k] = v[k] = a[k] = 0.0;
    for (int j = degree; j >= 0; j--) {
        double t = b->t[j], d = b->d[j], dd = b->dd[j];
        for (int k = 0; k < EPH_LANES; k++) {
            double cj = c[j * EPH_LANES + k];
            p[k] += t * cj;
            v[k] += d * cj;
            a[k] += dd * cj;
        }
    }
}

// Index of the segment at t and the rest within it, without a division.
static size_t segment_at(const eph_arc *a, orr_time t, int64_t *rest_ns)
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
    *rest_ns = rest;
    return (size_t)i;
}

// The arc that holds t, the later one where two meet; NULL in a gap.
static const eph_arc *arc_at(const eph_sat *s, orr_time t)
{
    for (size_t k = s->n_arcs; k-- > 0;) {
        const eph_arc *a = &s->arc[k];
        if (t >= a->t0) return t <= a->t1 ? a : NULL;
    }
    return NULL;
}

static uint32_t mixed_flags(const orr_ephemeris *e, const eph_sat *s, const eph_arc *a, size_t segment,
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

// True if the clock may be interpolated from node i to the next. SP3's event flag says that the clock jumped
// between the epoch before and the flagged one (SP3-d, column 75). Two nodes at one instant are where files
// join with different clocks: there it jumps.
static bool clock_joined(const orr_ephemeris *e, const eph_sat *s, size_t i)
{
    if (i + 1 >= s->n_clocks) return false;
    const orr_clock_node *c = &s->clock[i];
    int64_t step_ns = c[1].t - c[0].t;
    return step_ns > 0 && step_ns <= e->clock_max_gap_ns && (c[1].flags & ORR_EPH_CLOCK_EVENT) == 0;
}

// Index of the last clock node not after t; t is not before the first.
static size_t clock_before(const eph_sat *s, orr_time t)
{
    enum { WALK = 4 }; // a few nodes more or less than even spacing has: days' joints
    size_t last = s->n_clocks - 1;
    double guess = (double)(t - s->clock[0].t) * s->clock_per_ns;
    size_t i = guess < (double)last ? (size_t)guess : last;
    for (int k = 0; k < WALK && i > 0 && s->clock[i].t > t; k++) i--;
    for (int k = 0; k < WALK && i < last && s->clock[i + 1].t <= t; k++) i++;
    if (s->clock[i].t <= t && (i == last || t < s->clock[i + 1].t)) return i;
    size_t low = 0, high = s->n_clocks; // clock[low].t <= t < clock[high].t
    while (high - low > 1) {
        size_t mid = low + (high - low) / 2;
        if (s->clock[mid].t <= t)
            low = mid;
        else
            high = mid;
    }
    return low;
}

static void clock_at(const orr_ephemeris *e, const eph_sat *s, orr_time t, orr_sat_state *out)
{
    out->clock_s = out->clock_rate_sps = (double)NAN;
    if (s->n_clocks == 0 || t < s->clock[0].t) return;
    size_t i = clock_before(s, t);
    if (!clock_joined(e, s, i)) {
        // The end of a stretch still has a clock: its last node, with the rate that leads there.
        if (s->clock[i].t != t) return;
        while (i > 0 && s->clock[i - 1].t == t) i--;
        if (i == 0 || !clock_joined(e, s, i - 1)) return;
        i--;
    }
    const orr_clock_node *c = &s->clock[i];
    double rate = (c[1].clock_s - c[0].clock_s) / ((double)(c[1].t - c[0].t) * 1e-9);
    out->clock_rate_sps = rate;
    out->clock_s = t == c[1].t ? c[1].clock_s : c[0].clock_s + rate * ((double)(t - c[0].t) * 1e-9);
    out->flags |=
        ORR_EPH_CLOCK_VALID | ((c[0].flags | c[1].flags) & (ORR_EPH_CLOCK_EVENT | ORR_EPH_PREDICTED));
}

static void state_at(const orr_ephemeris *e, size_t slot, const eph_arc *a, orr_time t, basis *b,
                     orr_sat_state *out)
{
    const eph_sat *s = &e->sat[slot];
    int64_t rest_ns;
    size_t segment = segment_at(a, t, &rest_ns);
    double x = (double)(2 * rest_ns - a->segment_ns) * a->per_segment_ns;
    basis_at(b, a->degree, x);
    double p[EPH_LANES], v[EPH_LANES], acc[EPH_LANES];
    sum_rows(&e->coef[a->first_coef + segment * eph_block(a->degree)], b, a->degree, p, v, acc);
    double dx = a->dx_dt, dx2 = dx * dx;
    out->sat = e->sat_id[slot];
    out->pos_m = (orr_vec3){p[0], p[1], p[2]};
    out->vel_mps = (orr_vec3){v[0] * dx, v[1] * dx, v[2] * dx};
    out->acc_mps2 = (orr_vec3){acc[0] * dx2, acc[1] * dx2, acc[2] * dx2};
    out->valid_from = a->t0;
    out->valid_to = a->t1;

    double u = 0.5 * (x + 1.0) * (double)a->samples_per_segment;
    size_t last = a->samples_per_segment - 1, k = u < 0 ? 0 : u < (double)last ? (size_t)u : last;
    const float *sigma = &e->sigma[a->first_sample + segment * a->samples_per_segment + k];
    float part = (float)(u - (double)k);
    out->sigma_m = sigma[0] + part * (sigma[1] - sigma[0]);

    const eph_meta *m = &e->meta[a->first_segment + segment];
    out->flags = m->mixed ? mixed_flags(e, s, a, segment, rest_ns, t) : m->flags;
    clock_at(e, s, t, out);
}

orr_status orr_ephemeris_eval(const orr_ephemeris *e, orr_sat sat, orr_time t, orr_sat_state *out)
{
    if (t < e->from || t > e->to) return ORR_E_RANGE;
    if (sat >= sizeof e->slot / sizeof e->slot[0] || e->slot[sat] < 0) return ORR_E_NODATA;
    size_t slot = (size_t)e->slot[sat];
    const eph_arc *a = arc_at(&e->sat[slot], t);
    if (a == NULL) return ORR_E_NODATA;
    basis b;
    b.degree = -1;
    state_at(e, slot, a, t, &b, out);
    return ORR_OK;
}

size_t orr_ephemeris_eval_all(const orr_ephemeris *e, orr_time t, orr_sat_state *out, size_t max)
{
    size_t n = 0;
    basis b;
    b.degree = -1;
    if (t < e->from || t > e->to) return 0;
    for (size_t i = 0; i < e->n_sats && n < max; i++) {
        const eph_arc *a = arc_at(&e->sat[i], t);
        if (a != NULL) state_at(e, i, a, t, &b, &out[n++]);
    }
    return n;
}
