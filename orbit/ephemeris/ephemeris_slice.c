// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/ephemeris/ephemeris_slice.h"

#include <stdlib.h>

#include "orbit/ephemeris/ephemeris_at.h"

enum { ALIGNED = 64 };
typedef float floats __attribute__((vector_size(EPH_LANES * sizeof(float))));

// Satellites side by side: their polynomials have one degree.
typedef struct block {
    lanes *coef; // [degree + 1][x, y, z]
    int degree;
    int n;
    uint16_t slot[EPH_LANES];
    uint32_t flags[EPH_LANES]; // of the segment
    // Of the sample, and of the way to the next
    floats sigma[EPH_SIGMAS], step[EPH_SIGMAS];
    // Of the clocks between a node and the next
    const eph_clock *clock[EPH_LANES]; // NULL: looked for at every instant
    orr_clock_intervals way;
    orr_clock_noises noise;
    orr_clock_lanes given_s2, more_s2; // variance of predicted nodes: here, and what the next one has beyond
} block;

struct orr_ephemeris_slice {
    const orr_ephemeris *e;
    const eph_arc *shape; // of the arcs that lie side by side
    size_t segment;
    orr_time from, until;    // of theirs, the one that was asked for last: [from, until)
    bool laid, side_by_side; // it has been laid out, and is worth it
    int degree;              // the highest of the blocks
    size_t sample;           // whose sigmas the blocks hold
    orr_time since, up_to;   // [since, up_to): their clocks are those that the blocks hold
    size_t n_blocks, n_alone;
    block *block;
    lanes *coef;
    uint16_t *alone; // satellites of another shape, or with flags that change within the segment
    bool *has;       // each satellite, an arc at the instant asked for
    basis b;
};

orr_status orr_ephemeris_slice_open(const orr_ephemeris *e, orr_ephemeris_slice **out, orr_diag *diag)
{
    const size_t most =
        e->n_sats / EPH_LANES + EPH_MAX_DEGREE + 1; // blocks: of each degree one may not be full
    orr_ephemeris_slice *s = calloc(1, sizeof *s);
    if (s != NULL) {
        s->e = e;
        s->from = s->until = ORR_TIME_NONE;
        s->block = aligned_alloc(ALIGNED, (most * sizeof(block) + ALIGNED - 1) / ALIGNED * ALIGNED);
        s->coef = aligned_alloc(ALIGNED, most * (EPH_MAX_DEGREE + 1) * 4 * sizeof(lanes)); // three are used
        s->alone = malloc((e->n_sats + 1) * sizeof *s->alone);
        s->has = malloc((e->n_sats + 1) * sizeof *s->has);
    }
    if (s == NULL || s->block == NULL || s->coef == NULL || s->alone == NULL || s->has == NULL) {
        orr_ephemeris_slice_close(s);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    *out = s;
    return ORR_OK;
}

void orr_ephemeris_slice_close(orr_ephemeris_slice *s)
{
    if (s == NULL) return;
    free(s->block);
    free(s->coef);
    free(s->alone);
    free(s->has);
    free(s);
}

// The first arc at t: its shape is the one that counts. NULL: no satellite has one.
static const eph_arc *any_arc(const orr_ephemeris *e, orr_time t)
{
    const eph_arc *a = NULL;
    for (size_t i = 0; i < e->n_sats && a == NULL; i++) a = arc_at(&e->sat[i], t);
    return a;
}

// Whether a satellite's arc at t fits beside others of that shape throughout the segment.
static const eph_arc *fitting(const orr_ephemeris_slice *s, const eph_sat *sat, orr_time t)
{
    const eph_arc *a = arc_at(sat, t);
    if (a == NULL || !same_shape(a, s->shape)) return NULL;
    for (const eph_arc *next = a + 1; next < sat->arc + sat->n_arcs; next++)
        if (next->t0 < s->until) return NULL;
    return s->e->meta[a->first_segment + s->segment].mixed == 0 ? a : NULL;
}

static void put_beside(orr_ephemeris_slice *s, block *b, size_t slot, const eph_arc *a)
{
    const double *c = rows_of(s->e, a, s->segment);
    const int k = b->n++;
    b->slot[k] = (uint16_t)slot;
    b->flags[k] = s->e->meta[a->first_segment + s->segment].flags;
    for (int j = 0; j <= b->degree; j++)
        for (int q = 0; q < 3; q++) b->coef[3 * j + q][k] = c[j * EPH_LANES + q];
}

static block *new_block(orr_ephemeris_slice *s, int degree, lanes **room)
{
    block *b = &s->block[s->n_blocks++];
    memset(b, 0, sizeof *b);
    b->degree = degree;
    if (degree > s->degree) s->degree = degree;
    b->coef = *room;
    *room += 3 * (degree + 1);
    memset(b->coef, 0, 3 * (size_t)(degree + 1) * sizeof *b->coef);
    return b;
}

// Lays the satellites of the segment that holds t side by side, as far as most of them fit.
static void lay_out(orr_ephemeris_slice *s, orr_time t)
{
    const orr_ephemeris *e = s->e;
    block *open[EPH_MAX_DEGREE + 1] = {NULL};
    lanes *room = s->coef;
    size_t beside = 0;
    s->n_blocks = s->n_alone = 0;
    s->degree = EPH_MIN_DEGREE;
    for (size_t i = 0; i < e->n_sats; i++) {
        const eph_arc *a = fitting(s, &e->sat[i], t);
        if (a == NULL) {
            s->alone[s->n_alone++] = (uint16_t)i;
            continue;
        }
        block **b = &open[a->degree];
        if (*b == NULL || (*b)->n == EPH_LANES) *b = new_block(s, a->degree, &room);
        put_beside(s, *b, i, a);
        s->has[i] = true;
        beside++;
    }
    s->laid = true;
    s->side_by_side = beside > s->n_alone;
    s->since = s->up_to = ORR_TIME_NONE;
}

static bool holds(orr_time from, orr_time until, orr_time t)
{
    return from != ORR_TIME_NONE && t >= from && t < until;
}

// The segment that holds t becomes the slice's; it is laid out when it is asked for again.
static void turn_to(orr_ephemeris_slice *s, orr_time t)
{
    place at;
    s->laid = false;
    s->from = s->until = ORR_TIME_NONE;
    s->shape = any_arc(s->e, t);
    if (s->shape == NULL) return;
    place_at(s->shape, t, &at);
    s->segment = at.segment;
    s->from = s->shape->t0 + (int64_t)at.segment * s->shape->segment_ns;
    s->until = s->from + s->shape->segment_ns;
}

// The clock's interval at t where it is an ordinary one, within two nodes; narrows the time in which all of them are.
static const eph_clock *ordinary_clock(orr_ephemeris_slice *s, const eph_sat *sat, orr_time t, size_t *hint)
{
    if (sat->n_clocks == 0 || t < sat->rate[0].t) return NULL;
    const size_t i = *hint = clock_before(sat, t, *hint);
    if (sat->rate[i].flags == 0 || i + 1 == sat->n_clocks) return NULL;
    if (sat->rate[i].t > s->since) s->since = sat->rate[i].t;
    if (sat->rate[i + 1].t < s->up_to) s->up_to = sat->rate[i + 1].t;
    return &sat->rate[i];
}

static void take_sigmas(const orr_ephemeris_slice *s, block *b, int k)
{
    const eph_arc *a = arc_at(&s->e->sat[b->slot[k]], s->from);
    float(*sample)[EPH_SIGMAS] =
        &s->e->sigma[a->first_sample + s->segment * a->samples_per_segment + s->sample];
    for (int j = 0; j < EPH_SIGMAS; j++) {
        b->sigma[j][k] = sample[0][j];
        b->step[j][k] = sample[1][j] - sample[0][j];
    }
}

static void take_clock(block *b, int k, const eph_sat *sat, const eph_clock *c)
{
    static const eph_clock none;
    b->clock[k] = c;
    if (c == NULL) c = &none;
    b->way.length_s[k] = c->way.length_s;
    b->way.clock_s[k] = c->way.clock_s;
    b->way.rate_sps[k] = c->way.rate_sps;
    b->way.bend_first_sps[k] = c->way.bend_first_sps;
    b->way.bend_last_sps[k] = c->way.bend_last_sps;
    b->noise.white_s2[k] = sat->clock_noise.white_s2;
    b->noise.wfm_s2ps[k] = sat->clock_noise.wfm_s2ps;
    b->noise.rwfm_s2ps3[k] = sat->clock_noise.rwfm_s2ps3;
    b->given_s2[k] = (double)c->sigma2_s2;
    b->more_s2[k] = (double)(c->next_s2 - c->sigma2_s2);
}

// Sigmas of the sample and the clocks' intervals at t.
static void take_rest(orr_ephemeris_slice *s, orr_time t, size_t sample)
{
    size_t hint = SIZE_MAX;
    s->sample = sample;
    s->since = s->from;
    s->up_to = s->until;
    for (size_t i = 0; i < s->n_blocks; i++) {
        block *b = &s->block[i];
        for (int k = 0; k < b->n; k++) {
            take_sigmas(s, b, k);
            const eph_sat *sat = &s->e->sat[b->slot[k]];
            take_clock(b, k, sat, ordinary_clock(s, sat, t, &hint));
        }
    }
}

// Position, velocity and acceleration of a block, as sum_rows has them.
INLINE void sum_block(const block *b, const basis *f, double dx, lanes p[3], lanes v[3], lanes a[3])
{
    const lanes *c = b->coef;
    for (int q = 0; q < 3; q++) {
        p[q] = f->t[2] * c[6 + q];
        v[q] = f->d[2] * c[6 + q];
        a[q] = f->dd[2] * c[6 + q];
    }
    for (int j = 3; j <= b->degree; j++)
        for (int q = 0; q < 3; q++) {
            p[q] += f->t[j] * c[3 * j + q];
            v[q] += f->d[j] * c[3 * j + q];
            a[q] += f->dd[j] * c[3 * j + q];
        }
    for (int q = 0; q < 3; q++) {
        p[q] += f->t[1] * c[3 + q];
        v[q] += c[3 + q];
        p[q] += c[q];
        v[q] *= dx;
        a[q] *= dx * dx;
    }
}

// Clocks, rates and sigmas of a block, as clock_in has them.
INLINE void clocks_of(const block *b, orr_time t, lanes *clock, lanes *rate, lanes *sigma)
{
    lanes part = {0}, between;
    for (int k = 0; k < b->n; k++)
        if (b->clock[k] != NULL) part[k] = (double)(t - b->clock[k]->t) * b->clock[k]->per_ns;
    orr_clock_intervals_at(&b->way, &part, clock, rate);
    orr_clock_betweens_s2(&b->noise, &b->way.length_s, &part, &between);
    const lanes variance = EPH_CLOCK_ROUNDING_S2 + (b->given_s2 + part * b->more_s2) + between;
    for (int k = 0; k < EPH_LANES; k++) (*sigma)[k] = sqrt(variance[k]);
}

INLINE void block_at(const orr_ephemeris_slice *s, const block *b, orr_time t, float part, orr_sat_state *out)
{
    lanes p[3], v[3], a[3], clock, rate, clock_sigma;
    floats sigma[EPH_SIGMAS];
    sum_block(b, &s->b, s->shape->dx_dt, p, v, a);
    for (int j = 0; j < EPH_SIGMAS; j++) sigma[j] = b->sigma[j] + part * b->step[j];
    clocks_of(b, t, &clock, &rate, &clock_sigma);
    for (int k = 0; k < b->n; k++) {
        const size_t slot = b->slot[k];
        orr_sat_state *o = &out[slot];
        o->sat = s->e->sat_id[slot];
        o->pos_m = (orr_vec3){p[0][k], p[1][k], p[2][k]};
        o->vel_mps = (orr_vec3){v[0][k], v[1][k], v[2][k]};
        o->acc_mps2 = (orr_vec3){a[0][k], a[1][k], a[2][k]};
        o->sigma_m = sigma[0][k];
        for (int j = 0; j < 3; j++) o->sigma_rtn_m[j] = sigma[1 + j][k];
        o->sigma_mps = sigma[4][k];
        o->valid_from = s->shape->t0;
        o->valid_to = s->shape->t1;
        o->flags = b->flags[k];
        size_t hint = SIZE_MAX;
        if (b->clock[k] == NULL) {
            clock_at(&s->e->sat[slot], t, &hint, o);
            continue;
        }
        o->flags |= b->clock[k]->flags;
        o->clock_s = clock[k];
        o->clock_rate_sps = rate[k];
        o->clock_sigma_s = (float)clock_sigma[k];
    }
}

INLINE void slice_eval(orr_ephemeris_slice *s, orr_time t, orr_sat_state *out)
{
    place at;
    const bool again = holds(s->from, s->until, t);
    if (!again) turn_to(s, t);
    if (again && !s->laid) lay_out(s, t);
    if (!again || !s->side_by_side) {
        eval_all(s->e, t, out, s->e->n_sats, s->has);
        return;
    }
    place_at(s->shape, t, &at);
    if (!holds(s->since, s->up_to, t) || at.sample != s->sample) take_rest(s, t, at.sample);
    basis_at(&s->b, s->degree, at.x);
    for (size_t i = 0; i < s->n_blocks; i++) block_at(s, &s->block[i], t, at.part, out);
    for (size_t i = 0; i < s->n_alone; i++) {
        const size_t slot = s->alone[i];
        s->has[slot] = eval(s->e, s->e->sat_id[slot], t, &out[slot]) == ORR_OK;
    }
}

static void eval_plain(orr_ephemeris_slice *s, orr_time t, orr_sat_state *out) { slice_eval(s, t, out); }

#if defined(__x86_64__)
// For machines whose vectors hold four doubles, as in ephemeris_eval.c.
__attribute__((target("avx2"))) static void eval_wide(orr_ephemeris_slice *s, orr_time t, orr_sat_state *out)
{
    slice_eval(s, t, out);
    __builtin_ia32_vzeroupper();
}
#else
#define eval_wide eval_plain
#endif

const bool *orr_ephemeris_slice_eval(orr_ephemeris_slice *s, orr_time t, orr_sat_state *out)
{
    if (s->e->wide)
        eval_wide(s, t, out);
    else
        eval_plain(s, t, out);
    return s->has;
}
