// SPDX-License-Identifier: GPL-3.0-or-later
// Cells lie on multiples of 10 s, on which clocks have their nodes: between nodes they are cubics, which a cubic through both
// ends repeats. Over 10 s a quintic errs by T^6 / 46080 of 3e-15 m/s^6. What does not fit (an arc's end, a clock's jump, nodes
// that lie closer) is halved, and at the shortest the product itself answers.
#include "src/scenario/channel/satellite_cell.h"

#include <math.h>
#include <string.h>

#include "core/hermite.h"

// The product's own rounding is 4e-9 m.
static const double FIT_M = 2e-8, FIT_MPS = 1e-8;

static const double *coordinates(const orr_vec3 *v) { return &v->x; }

static double clock_m(const orr_sat_state *x)
{
    return (x->flags & ORR_EPH_CLOCK_VALID) != 0 ? ORR_LIGHT_MPS * x->clock_s : 0;
}

static double clock_rate_mps(const orr_sat_state *x)
{
    return (x->flags & ORR_EPH_CLOCK_VALID) != 0 ? ORR_LIGHT_MPS * x->clock_rate_sps : 0;
}

static double relativity_m(const orr_sat_state *x)
{
    return 2 / ORR_LIGHT_MPS * orr_vec3_dot(x->pos_m, x->vel_mps);
}

static double relativity_rate_mps(const orr_sat_state *x)
{
    return 2 / ORR_LIGHT_MPS * (orr_vec3_dot(x->vel_mps, x->vel_mps) + orr_vec3_dot(x->pos_m, x->acc_mps2));
}

typedef double lanes __attribute__((vector_size(4 * sizeof(double)), aligned(sizeof(double)), may_alias));

// Horner's scheme of four polynomials and their derivatives.
static void evaluate(const satellite_cell *cell, double s, satellite_state *out)
{
    const lanes *c = (const lanes *)(const void *)cell->x;
    lanes v = c[5], d = {0, 0, 0, 0};
    for (int j = 4; j >= 0; j--) {
        d = d * s + v;
        v = v * s + c[j];
    }
    out->pos_m = (orr_vec3){v[0], v[1], v[2]};
    out->vel_mps = (orr_vec3){d[0], d[1], d[2]};
    out->clock_m = v[3];
    out->clock_rate_mps = d[3];
    out->relativity_m = orr_cubic_at(cell->relativity, s);
    out->relativity_rate_mps = orr_cubic_rate(cell->relativity, s);
    out->flags = cell->flags;
}

static void fit(const orr_sat_state end[2], double T, satellite_cell *cell)
{
    for (int k = 0; k < 3; k++) {
        double c[6], v[2], r[2], a[2];
        for (int i = 0; i < 2; i++) {
            v[i] = coordinates(&end[i].pos_m)[k];
            r[i] = coordinates(&end[i].vel_mps)[k];
            a[i] = coordinates(&end[i].acc_mps2)[k];
        }
        orr_hermite_quintic(v, r, a, T, c);
        for (int j = 0; j < 6; j++) cell->x[j][k] = c[j];
    }
    double c[4];
    const double m0 = clock_m(&end[0]);
    orr_hermite_cubic(m0, clock_m(&end[1]) - m0, clock_rate_mps(&end[0]), clock_rate_mps(&end[1]), T, c);
    for (int j = 0; j < 6; j++) cell->x[j][3] = j < 4 ? c[j] : 0;
    const double r0 = relativity_m(&end[0]);
    orr_hermite_cubic(r0, relativity_m(&end[1]) - r0, relativity_rate_mps(&end[0]),
                      relativity_rate_mps(&end[1]), T, cell->relativity);
    cell->flags = end[0].flags;
}

static bool fits(const satellite_cell *cell, double s, const orr_sat_state *x)
{
    satellite_state y;
    evaluate(cell, s, &y);
    for (int k = 0; k < 3; k++)
        if (!(fabs(coordinates(&y.pos_m)[k] - coordinates(&x->pos_m)[k]) <= FIT_M) ||
            !(fabs(coordinates(&y.vel_mps)[k] - coordinates(&x->vel_mps)[k]) <= FIT_MPS))
            return false;
    return fabs(y.clock_m - clock_m(x)) <= FIT_M && fabs(y.clock_rate_mps - clock_rate_mps(x)) <= FIT_MPS;
}

// Curves over [from, to] of one arc whose flags do not change; false where there are none.
static bool make(const orr_ephemeris *e, orr_sat sat, orr_time from, orr_time to, satellite_cell *cell)
{
    orr_sat_state x[3]; // ends and middle
    const orr_time at[3] = {from, to, from + (to - from) / 2};
    for (int k = 0; k < 3; k++)
        if (orr_ephemeris_eval(e, sat, at[k], &x[k]) != ORR_OK || x[k].flags != x[0].flags ||
            x[k].valid_from != x[0].valid_from)
            return false;
    const double T = orr_time_diff_s(to, from);
    fit(x, T, cell);
    return fits(cell, T / 2, &x[2]);
}

static void find(const orr_ephemeris *e, orr_sat sat, orr_time t, satellite_cell *cell)
{
    orr_time from = lattice_cell(t), to = from + LATTICE_NS;
    while (!(cell->curves = make(e, sat, from, to, cell)) && to - from > LATTICE_LEAST_NS) {
        const orr_time middle = from + (to - from) / 2;
        if (t < middle)
            to = middle;
        else
            from = middle;
    }
    cell->from = from;
    cell->to = to;
}

// The product's own answer at t, carried back by less than a nanosecond.
static bool ask(const orr_ephemeris *e, orr_sat sat, orr_time t, double before_s, satellite_state *out)
{
    orr_sat_state x;
    if (orr_ephemeris_eval(e, sat, t, &x) != ORR_OK) return false;
    *out = (satellite_state){.pos_m = orr_vec3_axpy(-before_s, x.vel_mps, x.pos_m),
                             .vel_mps = orr_vec3_axpy(-before_s, x.acc_mps2, x.vel_mps),
                             .clock_m = clock_m(&x) - before_s * clock_rate_mps(&x),
                             .clock_rate_mps = clock_rate_mps(&x),
                             .relativity_m = relativity_m(&x) - before_s * relativity_rate_mps(&x),
                             .relativity_rate_mps = relativity_rate_mps(&x),
                             .flags = x.flags};
    return true;
}

bool satellite_at(const orr_ephemeris *e, orr_sat sat, satellite_cell cell[2], orr_time t, double before_s,
                  satellite_state *out)
{
    const int64_t whole_ns = (int64_t)(before_s * 1e9);
    const orr_time at = orr_time_add(t, -whole_ns);
    const double rest_s = before_s - (double)whole_ns * 1e-9;
    // Reception and emission may lie in neighbouring cells: two are kept.
    satellite_cell *here = &cell[(lattice_cell(at) / LATTICE_NS) & 1];
    if (at < here->from || at >= here->to) find(e, sat, at, here);
    if (!here->curves) return ask(e, sat, at, rest_s, out);
    evaluate(here, orr_time_diff_s(at, here->from) - rest_s, out);
    return true;
}
