// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/samples.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "orbit/smooth/between.h"
#include "orbit/smooth/join.h"
#include "orbit/smooth/noise_choice.h"
#include "orbit/smooth/solution.h"

uint32_t orr_samples_flags(const orr_track_context *c, double node_step_s, const orr_node *a,
                           const orr_node *b)
{
    uint32_t flags = 0;
    if (a->predicted || b->predicted) flags |= ORR_EPH_PREDICTED;
    if (b->t_s - a->t_s > 2.0 * node_step_s + 1e-3) {
        flags |= ORR_EPH_GAP;
        if (c->options->bridge) flags |= ORR_EPH_PREDICTED;
    }
    return flags;
}

// Flags of samples between neighbouring nodes, as the samples go by.
typedef struct between_nodes {
    const orr_node *left, *right;
    size_t next;   // instant at which right is, or the track's end
    double step_s; // usual distance of nodes
} between_nodes;

static const orr_node *last_used(const orr_node *list, const orr_instant *at, const orr_verdict *verdict)
{
    const orr_node *found = NULL;
    for (size_t i = at->first; i < at->first + at->n; i++)
        if (orr_node_counts(&list[i]) && !verdict[i].rejected) found = &list[i];
    return found;
}

// In a gap whose orbits before and after do not agree, sigma is as much larger as they disagree.
static double strain_between(const orr_track *t, const between_nodes *b)
{
    return b->right != NULL && b->next < t->n ? fmax(1, t->at[b->next].strain) : 1;
}

static void pass_instant(const orr_node *list, const orr_track *t, const orr_verdict *verdict, size_t k,
                         between_nodes *b)
{
    const orr_node *node = last_used(list, &t->at[k], verdict);
    if (node != NULL) b->left = node;
    if (k < b->next) return;
    b->right = NULL;
    for (b->next = k + 1; b->next < t->n && b->right == NULL; b->next++)
        b->right = last_used(list, &t->at[b->next], verdict);
    if (b->right != NULL) b->next--;
}

// Variances at an instant: of position along radial, along-track and cross-track axes, of velocity in space.
typedef struct variances {
    double rtn[3], velocity;
} variances;

static variances variances_at(const orr_instant *at, double scale)
{
    const orr_mat3 axes = orr_orbit_axes(at->r_m, at->v_mps);
    variances v = {{0}, 0};
    for (int a = 0; a < 3; a++) {
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                v.rtn[a] += axes.m[i][a] * orr_gauss_kept_P(&at->state, i, j) * axes.m[j][a];
        v.rtn[a] = fmax(v.rtn[a], 0) * scale * scale;
        v.velocity += fmax(orr_gauss_kept_P(&at->state, 3 + a, 3 + a), 0) * scale * scale;
    }
    return v;
}

// What the curve may be off beside what the smoother says: along three axes, and in velocity.
typedef struct excess {
    double rtn2_m2[3], v2_m2ps2;
} excess;

// Where files join, how far the curve is moved off the file's own orbit.
static excess excess_of_join(const orr_grid_point *g, const orr_join *join)
{
    if (join == NULL) return (excess){{0}, 0};
    const orr_mat3 axes = orr_orbit_axes(g->r_m, g->v_mps);
    const orr_vec3 off = orr_mat3_apply_t(&axes, join->r_m);
    return (excess){{off.x * off.x, off.y * off.y, off.z * off.z}, orr_vec3_dot(join->v_mps, join->v_mps)};
}

// Beside an end node that may be wrong: all of its distance from the orbit through the others there, nothing at the next
// node. What it would be is a parabola at first; the line is above it.
static void add_doubt(const between_nodes *b, const orr_node *list, const orr_verdict *verdict, double t_s,
                      excess *e)
{
    const orr_node *left = b->left != NULL ? b->left : b->right, *right = b->right != NULL ? b->right : left;
    if (left == NULL || (verdict[left - list].doubt_m == 0 && verdict[right - list].doubt_m == 0)) return;
    const double step_s = right->t_s - left->t_s, u = step_s > 0 ? (t_s - left->t_s) / step_s : 0;
    const double off_m = fmax((1 - u) * verdict[left - list].doubt_m, u * verdict[right - list].doubt_m);
    const double off_mps = 2 * off_m / b->step_s;
    for (int i = 0; i < 3; i++) e->rtn2_m2[i] += off_m * off_m / 3;
    e->v2_m2ps2 += off_mps * off_mps;
}

// At point g, at part u of the way between two instants.
static void set_sigma(const orr_grid_point *g, const variances *a, const variances *b, double u,
                      double strain, const excess *more, double floor_m, orr_orbit_sample *s)
{
    const double strain2 = strain * strain;
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        const double variance =
            fmax(strain2 * ((1 - u) * a->rtn[i] + u * b->rtn[i]) + more->rtn2_m2[i], floor_m * floor_m / 3);
        s->sigma_rtn_m[i] = (float)sqrt(variance);
        sum += variance;
    }
    s->sigma_m = (float)sqrt(sum);
    const double rate = orr_vec3_norm(g->v_mps) / orr_vec3_norm(g->r_m); // errors of the orbit turn with it
    s->sigma_mps = (float)fmax(sqrt(strain2 * ((1 - u) * a->velocity + u * b->velocity) + more->v2_m2ps2),
                               floor_m * rate);
}

// Smoothed state x about point g as a sample.
static void set_state(const orr_track_context *c, const orr_grid_point *g, const double x[ORR_NX],
                      const orr_join *join, orr_orbit_sample *s)
{
    orr_sky_point p;
    orr_sky_at(c->sky, g->t_s, &p);
    orr_vec3 r = orr_vec3_add(g->r_m, orr_vec3_make(x[0], x[1], x[2]));
    orr_vec3 v = orr_vec3_add(g->v_mps, orr_vec3_make(x[3], x[4], x[5]));
    if (join != NULL) {
        r = orr_vec3_add(r, join->r_m);
        v = orr_vec3_add(v, join->v_mps);
    }
    const orr_mat3 axes = orr_track_axes(c, g->t_s, g->r_m, g->v_mps);
    orr_vec3 a = orr_force_of_state(c->force, &p, r, v);
    a = orr_vec3_add(a, orr_mat3_apply(&axes, orr_vec3_make(x[6], x[7], x[8])));
    if (join != NULL) a = orr_vec3_add(a, join->a_mps2);
    orr_sky_to_ecef(&p, r, v, &s->pos_m, &s->vel_mps);
    s->acc_mps2 = orr_vec3_add(orr_mat3_apply(&p.R, a), orr_mat3_apply(&p.ddR, r));
    s->acc_mps2 = orr_vec3_axpy(2.0, orr_mat3_apply(&p.dR, v), s->acc_mps2);
    if (orr_force_sunlight_fast(r, p.sun_m) < 1) s->flags |= ORR_EPH_ECLIPSE;
}

orr_status orr_samples_make(orr_track_context *c, const orr_node *list, double node_step_s, orr_track *t,
                            const orr_verdict *verdict, double scale, orr_orbit_arc *arc)
{
    const size_t longest = orr_track_longest(t, 0, t->n - 1);
    double(*x)[ORR_NX] = malloc((longest + 1) * sizeof *x), (*b)[ORR_NW] = malloc(longest * sizeof *b);
    orr_join *join = NULL;
    orr_status status = x != NULL && b != NULL ? ORR_OK : ORR_E_MEMORY;
    if (status == ORR_OK && c->noise.nx == ORR_NX) status = orr_join_files(c, t, &join);
    between_nodes nodes = {.step_s = node_step_s};
    bool eclipsing = false;
    for (size_t k = 0; k < t->n; k++) eclipsing = eclipsing || t->at[k].next.near_shadow;
    const orr_claim claim = orr_noise_claim(c, node_step_s, eclipsing);
    scale *= claim.times;
    variances after = variances_at(&t->at[0], scale);
    for (size_t k = 0; k < t->n && status == ORR_OK; k++) {
        const orr_instant *at = &t->at[k], *next = k + 1 < t->n ? at + 1 : at;
        const variances before = after;
        after = variances_at(next, scale);
        pass_instant(list, t, verdict, k, &nodes);
        size_t n = next->grid - at->grid;
        if (n == 0 && next != at) continue; // a file ends and the next one begins
        if (n > 0)
            status = orr_track_between(c, t, k, x, b);
        else
            memcpy(x[n++], at->state.x, sizeof x[0]);
        orr_track_use_window(c, at->window, &at->state.x[ORR_PARTIAL_ECOM]);
        for (size_t j = 0; j < n && status == ORR_OK; j++) {
            const orr_grid_point *g = &t->grid[at->grid + j];
            if (!g->sample) continue;
            orr_orbit_sample *s = &arc->sample[arc->n++];
            s->flags = nodes.left != NULL && nodes.right != NULL
                           ? orr_samples_flags(c, node_step_s, nodes.left, nodes.right)
                           : ORR_EPH_PREDICTED; // beyond the last node
            const orr_join *joined = join != NULL ? &join[at->grid + j] : NULL;
            set_state(c, g, x[j], joined, s);
            excess more = excess_of_join(g, joined);
            add_doubt(&nodes, list, verdict, g->t_s, &more);
            set_sigma(g, &before, &after, next == at ? 0 : (g->t_s - at->t_s) / (next->t_s - at->t_s),
                      strain_between(t, &nodes), &more, claim.least_m, s);
            if (joined != NULL && joined->between_files) s->flags |= ORR_EPH_JOINT;
            if (eclipsing && at->shadow > 0) s->flags |= ORR_EPH_SHADOW_NOISE;
        }
    }
    free(x);
    free(b);
    free(join);
    return status;
}
