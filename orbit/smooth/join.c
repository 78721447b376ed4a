// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/join.h"

#include <stdlib.h>
#include <string.h>

// From half an hour to three before the joint, and as long after it, so that the velocity is never further from either
// orbit's than this.
#define SHORTEST_S 1800.0
#define LONGEST_S 10800.0
#define LIMIT_MPS 1.6e-5
#define MOST_MPS 1.9e-5 // with what the velocities differ by
#define LONGER 1.1
enum { TRIES = 20 };
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

typedef struct joint {
    const orr_instant *at;
    double step[6], half_s;
    double most_mps; // that the curve's velocity is off the file's own
} joint;

// What is added at point g of the grid, where the two orbits differ by d; false beyond the joint's reach. out: NULL to look only.
static bool bend(const orr_track *t, size_t g, const double d[6], bool later, joint *j, orr_join *out)
{
    double rate, bend;
    const double x = (t->grid[g].t_s - j->at->t_s) / j->half_s;
    if (fabs(x) >= 1) return false;
    const double w = weigh(x, j->half_s, &rate, &bend) - (later ? 1 : 0);
    orr_join now = {0};
    add(d, w, rate, bend, &now);
    j->most_mps = fmax(j->most_mps, orr_vec3_norm(now.v_mps));
    if (out == NULL) return true;
    add(d, w, rate, bend, &out[g]);
    out[g].between_files = out[g].between_files || j->at->step;
    return true;
}

static orr_status go_over(const orr_track_context *c, orr_track *t, joint *j, orr_join *out)
{
    const orr_grid_step *on;
    orr_status s = ORR_OK;
    double d[6];
    j->most_mps = 0;
    memcpy(d, j->step, sizeof d);
    for (size_t g = j->at->grid; s == ORR_OK && bend(t, g, d, true, j, out);
         g++) { // too much of the later orbit
        if (g + 1 == t->n_grid) break;
        s = orr_track_step(c, t, g, &on);
        if (s == ORR_OK) carry(on, false, d);
    }
    memcpy(d, j->step, sizeof d);
    for (size_t g = j->at->grid; s == ORR_OK && g-- > 0;) { // what is wanting of it before
        s = orr_track_step(c, t, g, &on);
        if (s != ORR_OK) break;
        carry(on, true, d);
        if (!bend(t, g, d, false, j, out)) break;
    }
    return s;
}

// The length follows from the jump at the joint. Where the velocities differ too, the orbits are further apart beside it, and
// more is needed.
static orr_status join_at(const orr_track_context *c, orr_track *t, const orr_instant *at, orr_join *out)
{
    joint j = {.at = at, .half_s = NOON_S};
    orr_join_step(at, j.step);
    if (at->step) {
        const double jump_m = orr_vec3_norm((orr_vec3){j.step[0], j.step[1], j.step[2]});
        j.half_s = fmin(fmax(jump_m * STEEPEST / LIMIT_MPS, SHORTEST_S), LONGEST_S);
        for (int i = 0; i < TRIES; i++) {
            const orr_status s = go_over(c, t, &j, NULL);
            if (s != ORR_OK) return s;
            if (j.most_mps <= MOST_MPS || j.half_s >= LONGEST_S) break;
            j.half_s = fmin(LONGER * j.half_s, LONGEST_S);
        }
    }
    return go_over(c, t, &j, out);
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
