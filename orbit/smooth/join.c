// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/join.h"

#include <stdlib.h>
#include <string.h>

// From half an hour to three before the joint, and as long after it, so that the velocity is never further from either
// orbit's than this.
#define SHORTEST_S 1800.0
#define LONGEST_S 10800.0
#define LIMIT_MPS 1.6e-5
#define NOON_S 300.0          // a step of velocity alone moves the curve by a tenth of a millimetre
#define STEEPEST (2.1875 / 2) // of the weight, over the half length

// The difference of the two orbits one step on, or (F is symplectic) one step back.
static void carry(const orr_grid_step *g, bool back, double d[6])
{
    double next[6];
    for (int i = 0; i < 6; i++) {
        next[i] = 0;
        for (int k = 0; k < 6; k++) {
            // F = (A B; C D), F^-1 = (D' -B'; -C' A')
            const double f = !back                ? g->F[i][k]
                             : (i < 3) == (k < 3) ? g->F[(k + 3) % 6][(i + 3) % 6]
                                                  : -g->F[(k + 3) % 6][(i + 3) % 6];
            next[i] += f * d[k];
        }
    }
    memcpy(d, next, sizeof next);
}

// Adds `times` the difference d, and what the change of the weight (per s, per s^2) brings.
static void add(const double d[6], double weight, double rate, double bend, orr_join *j)
{
    const orr_vec3 r = {d[0], d[1], d[2]}, v = {d[3], d[4], d[5]};
    j->r_m = orr_vec3_axpy(weight, r, j->r_m);
    j->v_mps = orr_vec3_axpy(rate, r, orr_vec3_axpy(weight, v, j->v_mps));
    j->a_mps2 = orr_vec3_axpy(bend, r, orr_vec3_axpy(2 * rate, v, j->a_mps2));
}

// Weight of the later orbit, x from -1 to 1 about the joint: 35 s^4 - 84 s^5 + 70 s^6 - 20 s^7.
static double weigh(double x, double half_s, double *rate, double *bend)
{
    const double s = fmin(fmax(0.5 * (x + 1), 0), 1), r = 1 - s;
    *rate = 140 * s * s * s * r * r * r / (2 * half_s);
    *bend = 420 * s * s * r * r * (1 - 2 * s) / (4 * half_s * half_s);
    return s * s * s * s * (35 + s * (-84 + s * (70 - 20 * s)));
}

void orr_join_step(const orr_instant *at, double step[6])
{
    for (int i = 0; i < 6; i++) {
        double variance = 0;
        if (at->step)
            variance +=
                i < 3 ? ORR_FILE_STEP_R_M * ORR_FILE_STEP_R_M : ORR_FILE_STEP_V_MPS * ORR_FILE_STEP_V_MPS;
        if (at->pulse && i >= 3) variance += ORR_NOON_STEP_MPS * ORR_NOON_STEP_MPS;
        step[i] = at->u[i] * variance;
    }
}

static orr_status join_at(const orr_track_context *c, orr_track *t, const orr_instant *at, orr_join *out)
{
    const orr_grid_step *on;
    orr_status s = ORR_OK;
    double step[6], d[6], rate, bend;
    orr_join_step(at, step);
    const double jump_m = orr_vec3_norm((orr_vec3){step[0], step[1], step[2]});
    const double half_s =
        at->step ? fmin(fmax(jump_m * STEEPEST / LIMIT_MPS, SHORTEST_S), LONGEST_S) : NOON_S;
    memcpy(d, step, sizeof d);
    for (size_t g = at->grid; g < t->n_grid && s == ORR_OK; g++) { // what is too much of the later orbit
        const double x = (t->grid[g].t_s - at->t_s) / half_s;
        if (x >= 1) break;
        const double w = weigh(x, half_s, &rate, &bend);
        add(d, w - 1, rate, bend, &out[g]);
        out[g].between_files = out[g].between_files || at->step;
        if (g + 1 == t->n_grid) break;
        s = orr_track_step(c, t, g, &on);
        if (s == ORR_OK) carry(on, false, d);
    }
    memcpy(d, step, sizeof d);
    for (size_t g = at->grid; s == ORR_OK && g-- > 0;) { // what is wanting of it before
        s = orr_track_step(c, t, g, &on);
        if (s != ORR_OK) break;
        carry(on, true, d);
        const double x = (t->grid[g].t_s - at->t_s) / half_s;
        if (x <= -1) break;
        const double w = weigh(x, half_s, &rate, &bend);
        add(d, w, rate, bend, &out[g]);
        out[g].between_files = out[g].between_files || at->step;
    }
    return s;
}

orr_status orr_join_files(const orr_track_context *c, orr_track *t, orr_join **out)
{
    *out = NULL;
    for (size_t k = 1; k < t->n; k++) {
        if (!t->at[k].step && !t->at[k].pulse) continue;
        if (*out == NULL) *out = calloc(t->n_grid, sizeof **out);
        if (*out == NULL) return ORR_E_MEMORY;
        const orr_status s = join_at(c, t, &t->at[k], *out);
        if (s != ORR_OK) {
            free(*out);
            *out = NULL;
            return s;
        }
    }
    return ORR_OK;
}
