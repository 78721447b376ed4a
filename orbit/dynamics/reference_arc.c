// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/dynamics/reference_arc.h"

#include <stdlib.h>
#include <string.h>

#include "core/linalg.h"
#include "core/robust.h"
#include "orbit/dynamics/variational.h"

#define STEP_S 900.0 // at the radius of GNSS orbits; shorter the lower the orbit
// Days that are to be carried on: passages of the shadow that are cut wrongly by centimetres become metres.
#define FORECAST_STEP_S 450.0
#define STEP_RADIUS_M 2.5e7
#define SHOOT_S 3600.0 // between the two nodes of a first state, at least
#define SHOOT_ROUNDS 15
#define SHOOT_MAX_MPS 300.0 // change of velocity in one round
#define START_TRIES 4
#define START_NEAR_M                                                                                         \
    2e4 // from the nodes that follow: pole, pressure and bad velocities are hundreds of metres
// Nodes by their distance from the orbit through all others, in units of the median: looked at, wrong.
#define SUSPICIOUS 4.0
#define REJECT 8.0
#define NOISY_M 0.20     // residuals of this size all over are looked at
#define MOST_WRONG 3     // one node in so many
#define LEAST_SHARE 1e-3 // of a node's variance that is left where the node alone tells its orbit
#define REJECT_FLOOR_M 0.05
// Among few nodes two or three neighbours that are off alike hold one another: they are set aside together where that leaves
// so little of the sum of squares that setting aside the worst ones leaves.
#define FEW 60
#define BLOCK 0.1
#define PRIOR_POLE_MAS 300.0 // while an arc is judged by itself
#define PRIOR_UT1_MS 2.0

orr_status orr_arc_room_init(const orr_sky *sky, const orr_rotation_knots *knots,
                             const orr_gravity_field *earth, size_t most_nodes, orr_arc_room *room,
                             orr_diag *diag)
{
    *room = (orr_arc_room){.force = {.earth = *earth, .sun_moon = true, .precise = true},
                           .sky = sky,
                           .knots = knots,
                           .most_nodes = most_nodes};
    room->row = malloc((most_nodes + 1) * sizeof *room->row);
    room->length = malloc((most_nodes + 1) * 4 * sizeof *room->length);
    if (room->row == NULL || room->length == NULL) {
        orr_arc_room_free(room);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory for an orbit of %zu positions", most_nodes);
    }
    room->weight = room->length + most_nodes + 1;
    room->sort = room->weight + most_nodes + 1;
    room->square = room->sort + most_nodes + 1;
    const orr_status s = orr_integrator_init(&room->force, sky, &room->integrator, diag);
    if (s != ORR_OK) orr_arc_room_free(room);
    return s;
}

void orr_arc_room_free(orr_arc_room *room)
{
    orr_integrator_free(room->integrator);
    free(room->row);
    free(room->length);
    *room = (orr_arc_room){0};
}

static orr_vec3 inertial(const orr_arc_room *room, const orr_reference_node *node)
{
    orr_sky_point p;
    orr_sky_force_point(room->sky, node->t_s, &p);
    return orr_mat3_apply_t(&p.R, node->ecef_m);
}

// The lower the orbit the faster it turns, and the more of the field's details it feels.
static double step_for(const orr_arc_room *room, orr_vec3 r)
{
    return (room->forget_s > 0 ? FORECAST_STEP_S : STEP_S) *
           fmin(1, orr_vec3_dot(r, r) / (STEP_RADIUS_M * STEP_RADIUS_M));
}

typedef double transition[6][ORR_ARC_STATE]; // of the state at some instant by first state and ECOM

static void start_transition(transition z)
{
    memset(z, 0, sizeof(transition));
    for (int i = 0; i < 6; i++) z[i][i] = 1;
}

// One step in which the sunlight has no kink.
static orr_status step_on(const orr_arc_room *room, double t_s, double h_s, orr_vec3 *r, orr_vec3 *v,
                          transition z)
{
    orr_orbit_step step = {.t_s = t_s, .h_s = h_s, .r0_m = *r, .v0_mps = *v};
    const orr_status s = orr_integrate(room->integrator, t_s, h_s, r, v);
    if (s != ORR_OK || z == NULL) return s;
    step.r1_m = *r;
    step.v1_mps = *v;
    double f[6][ORR_PARTIALS];
    transition before;
    orr_variational_step(&room->force, room->sky, &step, NULL, f);
    memcpy(before, z, sizeof before);
    for (int k = 0; k < 6; k++) {
        for (int c = 0; c < ORR_ARC_STATE; c++) z[k][c] = c < 6 ? 0 : f[k][ORR_PARTIAL_ECOM + c - 6];
        for (int j = 0; j < 6; j++)
            for (int c = 0; c < ORR_ARC_STATE; c++) z[k][c] += f[k][j] * before[j][c];
    }
    return ORR_OK;
}

// From the state at t_s to t_s + span_s, in steps; z (may be NULL) is carried along.
static orr_status advance(const orr_arc_room *room, double t_s, double span_s, orr_vec3 *r, orr_vec3 *v,
                          transition z)
{
    const double longest = step_for(room, *r);
    int steps = (int)ceil(fabs(span_s) / longest - 1e-9);
    if (steps < 1) steps = 1;
    orr_integrator_set(room->integrator, &room->force, longest * (1 + 1e-9));
    for (int i = 0; i < steps; i++) {
        const double begin_s = t_s + span_s * i / steps, h_s = span_s / steps;
        double border[ORR_INTEGRATE_BORDERS + 1], from = 0;
        size_t n = z != NULL ? orr_integrate_borders(room->integrator, begin_s, h_s, *r, *v, border) : 0;
        border[n++] = h_s;
        for (size_t k = 0; k < n; from = border[k++]) {
            const orr_status s = step_on(room, begin_s + from, border[k] - from, r, v, z);
            if (s != ORR_OK) return s;
        }
    }
    return ORR_OK;
}

// Velocity at node i with which the orbit passes through node j, by Newton's method.
static bool shoot(const orr_arc_room *room, const orr_reference_arc *arc, size_t i, size_t j, orr_vec3 *r0,
                  orr_vec3 *v0)
{
    const orr_vec3 a = inertial(room, &arc->node[i]), b = inertial(room, &arc->node[j]);
    const double dt = arc->node[j].t_s - arc->node[i].t_s, ra = orr_vec3_norm(a), rb = orr_vec3_norm(b);
    const orr_vec3 radial = orr_vec3_unit(a), normal = orr_vec3_unit(orr_vec3_cross(a, b));
    if (!(dt > 0) || !(ra > 6e6) || !(rb > 6e6)) return false;
    orr_vec3 v = orr_vec3_scale(sqrt(ORR_EGM96_GM / ra), orr_vec3_cross(normal, radial));
    v = orr_vec3_axpy((rb - ra) / dt, radial, v);
    for (int round = 0; round < SHOOT_ROUNDS; round++) {
        orr_vec3 r1 = a, v1 = v;
        transition z;
        start_transition(z);
        if (advance(room, arc->node[i].t_s, dt, &r1, &v1, z) != ORR_OK) return false;
        const orr_vec3 miss = orr_vec3_sub(b, r1);
        const double m[3] = {miss.x, miss.y, miss.z};
        double A[9], x[3] = {0}; // normal equations of a regular 3x3 system
        for (int p = 0; p < 3; p++) {
            for (int q = 0; q < 3; q++) {
                A[3 * p + q] = 0;
                for (int k = 0; k < 3; k++) A[3 * p + q] += z[k][3 + p] * z[k][3 + q];
            }
            for (int k = 0; k < 3; k++) x[p] += z[k][3 + p] * m[k];
        }
        if (orr_symmetric_solve(A, 3, 3, x, 1) != ORR_OK) return false;
        orr_vec3 dv = {x[0], x[1], x[2]};
        const double size = orr_vec3_norm(dv);
        if (size > SHOOT_MAX_MPS) dv = orr_vec3_scale(SHOOT_MAX_MPS / size, dv);
        v = orr_vec3_add(v, dv);
        if (size < 1e-6) {
            *r0 = a;
            *v0 = v;
            return true;
        }
    }
    return false;
}

bool orr_arc_start(orr_arc_room *room, orr_reference_arc *arc)
{
    memset(arc->ecom_nmps2, 0, sizeof arc->ecom_nmps2);
    arc->ecom_nmps2[0] = ORR_ECOM_D0_NMPS2;
    memcpy(room->force.ecom_nmps2, arc->ecom_nmps2, sizeof arc->ecom_nmps2);
    for (size_t i = 0; i < START_TRIES && i + 2 < arc->n; i++) {
        size_t j = i + 1;
        while (j + 1 < arc->n && arc->node[j].t_s - arc->node[i].t_s < SHOOT_S - 1) j++;
        orr_vec3 r, v;
        if (!shoot(room, arc, i, j, &r, &v)) continue;
        orr_vec3 r0 = r, v0 = v;
        if (i > 0 &&
            advance(room, arc->node[i].t_s, arc->node[0].t_s - arc->node[i].t_s, &r0, &v0, NULL) != ORR_OK)
            continue;
        // Most of the nodes after it have to be near.
        size_t near = 0, seen = 0;
        double t = arc->node[i].t_s;
        for (size_t k = j; k < arc->n && seen < 6; k += (arc->n - j) / 6 + 1, seen++) {
            if (advance(room, t, arc->node[k].t_s - t, &r, &v, NULL) != ORR_OK) break;
            t = arc->node[k].t_s;
            near += orr_vec3_norm(orr_vec3_sub(inertial(room, &arc->node[k]), r)) < START_NEAR_M;
        }
        if (2 * near < seen) continue;
        arc->t_s = arc->node[0].t_s;
        arc->r_m = r0;
        arc->v_mps = v0;
        return true;
    }
    return false;
}

// Rows of one node: coordinates by state, ECOM and knots; what was measured less what was computed.
static void make_row(const orr_arc_room *room, const orr_reference_arc *arc, const orr_reference_node *node,
                     orr_vec3 r, transition z, double row[3][ORR_ARC_UNKNOWNS + 1])
{
    orr_sky_point p;
    orr_vec3 by[ORR_KNOT_VALUES];
    double weight[ORR_KNOT_REACH];
    orr_sky_force_point(room->sky, node->t_s, &p);
    orr_knot_partials(node->ecef_m, by);
    orr_knot_weights(room->knots, arc->window, node->t_s, weight);
    for (int i = 0; i < 3; i++) memcpy(row[i], z[i], sizeof z[i]);
    for (int j = 0; j < ORR_KNOT_VALUES; j++) {
        const orr_vec3 d = orr_mat3_apply_t(&p.R, by[j]);
        for (int k = 0; k < ORR_KNOT_REACH; k++) {
            const int c = ORR_ARC_STATE + ORR_KNOT_VALUES * k + j;
            row[0][c] = -weight[k] * d.x, row[1][c] = -weight[k] * d.y, row[2][c] = -weight[k] * d.z;
        }
    }
    const orr_vec3 l = orr_vec3_sub(orr_mat3_apply_t(&p.R, node->ecef_m), r);
    row[0][ORR_ARC_UNKNOWNS] = l.x, row[1][ORR_ARC_UNKNOWNS] = l.y, row[2][ORR_ARC_UNKNOWNS] = l.z;
}

// Weight of a node by its age.
static double remembered(const orr_arc_room *room, const orr_reference_node *node)
{
    return room->forget_s > 0 ? exp((node->t_s - room->now_s) / room->forget_s) : 1;
}

static void accumulate(const orr_arc_room *room, const orr_reference_arc *arc, orr_arc_equations *e)
{
    const double unit = 1 / (ORR_ARC_SIGMA_M * ORR_ARC_SIGMA_M);
    memset(e, 0, sizeof *e);
    for (size_t i = 0; i < arc->n; i++) {
        const double w = unit * room->weight[i] * remembered(room, &arc->node[i]);
        if (!(w > 0)) continue;
        e->n++;
        for (int k = 0; k < 3; k++) {
            const double *row = room->row[i][k];
            for (int a = 0; a < ORR_ARC_UNKNOWNS; a++) {
                const double x = w * row[a];
                for (int b = 0; b <= a; b++) e->N[a][b] += x * row[b];
                e->r[a] += x * row[ORR_ARC_UNKNOWNS];
            }
            e->ll += w * row[ORR_ARC_UNKNOWNS] * row[ORR_ARC_UNKNOWNS];
        }
    }
    const double *sigma = orr_ecom_sigma_nmps2(arc->r_m, arc->v_mps);
    for (int j = 0; j < ORR_ECOM_TERMS; j++) {
        const double s = sigma[j], p = 1 / (s * s),
                     off = arc->ecom_nmps2[j] - (j == 0 ? ORR_ECOM_D0_NMPS2 : 0);
        e->N[6 + j][6 + j] += p;
        e->r[6 + j] -= p * off;
        e->ll += p * off * off;
    }
    for (int a = 0; a < ORR_ARC_UNKNOWNS; a++)
        for (int b = 0; b < a; b++) e->N[b][a] = e->N[a][b];
}

// The arc's own solution, its share of the rotation free within what is usual, and each node against the orbit through
// all others: room->length, and room->square, the normalised square of that. left: the sum of squares that is left.
static bool leave_out(const orr_arc_room *room, const orr_reference_arc *arc, const orr_arc_equations *e,
                      double *left)
{
    enum { N = ORR_ARC_UNKNOWNS };
    const double unit = 1 / (ORR_ARC_SIGMA_M * ORR_ARC_SIGMA_M);
    double A[N][N], b[N][N + 1]; // N^-1, and N^-1 r in the last column
    memcpy(A, e->N, sizeof A);
    memset(b, 0, sizeof b);
    for (int c = 0; c < ORR_KNOT_LOCAL; c++) {
        const double s = c % ORR_KNOT_VALUES == 2 ? PRIOR_UT1_MS : PRIOR_POLE_MAS;
        A[ORR_ARC_STATE + c][ORR_ARC_STATE + c] += 1 / (s * s);
    }
    for (int i = 0; i < N; i++) b[i][i] = 1, b[i][N] = e->r[i];
    if (orr_symmetric_solve(&A[0][0], N, N, &b[0][0], N + 1) != ORR_OK) return false;
    *left = e->ll;
    for (int i = 0; i < N; i++) *left -= e->r[i] * b[i][N];
    for (size_t i = 0; i < arc->n; i++) {
        double by[3][N], v[3];
        orr_mat3 s;
        for (int k = 0; k < 3; k++) {
            const double *row = room->row[i][k];
            v[k] = row[N];
            for (int c = 0; c < N; c++) v[k] -= row[c] * b[c][N];
            for (int c = 0; c < N; c++) by[k][c] = 0;
            for (int a = 0; a < N; a++)
                for (int c = 0; c < N; c++) by[k][c] += row[a] * b[a][c];
        }
        // Of a node that is used, residuals are too small by what it draws the orbit to itself.
        const bool used = room->weight[i] > 0;
        for (int k = 0; k < 3; k++)
            for (int j = 0; j < 3; j++) {
                double sum = 0;
                for (int c = 0; c < N; c++) sum += by[k][c] * room->row[i][j][c];
                s.m[k][j] = (k == j) + (used ? -unit : unit) * sum;
            }
        for (int k = 0; k < 3; k++) s.m[k][k] = fmax(s.m[k][k], LEAST_SHARE);
        const orr_mat3 weight = orr_mat3_inverse(&s);
        const orr_vec3 r = {v[0], v[1], v[2]}, u = orr_mat3_apply(&weight, r);
        room->length[i] = orr_vec3_norm(used ? u : r);
        room->square[i] = fmax(orr_vec3_dot(r, u), 0);
    }
    return true;
}

// Median of the used nodes' squares, and which of them is furthest off.
static double usual(const orr_arc_room *room, size_t n, size_t *worst)
{
    size_t used = 0;
    *worst = 0;
    for (size_t i = 0; i < n; i++) {
        if (!(room->weight[i] > 0)) continue;
        if (used == 0 || room->square[i] > room->square[*worst]) *worst = i;
        room->sort[used++] = room->square[i];
    }
    return used > 0 ? orr_upper_median(room->sort, used) : 0;
}

// The worst goes first, as long as one is far from what is usual, or all are (an error among few nodes makes the others
// look as bad). Returns how many went; middle is what is usual then.
static size_t drop_worst(const orr_arc_room *room, const orr_reference_arc *arc, orr_arc_equations *e,
                         double *middle, double *left)
{
    size_t worst, n_wrong = 0;
    for (size_t i = 0; i < arc->n; i++) room->weight[i] = 1;
    accumulate(room, arc, e);
    if (!leave_out(room, arc, e, left)) return 0;
    *middle = usual(room, arc->n, &worst);
    while (n_wrong < arc->n / MOST_WRONG && room->length[worst] > REJECT_FLOOR_M &&
           (room->square[worst] > SUSPICIOUS * SUSPICIOUS * *middle || *middle > NOISY_M * NOISY_M)) {
        room->weight[worst] = 0;
        n_wrong++;
        accumulate(room, arc, e);
        if (!leave_out(room, arc, e, left)) break;
        *middle = usual(room, arc->n, &worst);
    }
    return n_wrong;
}

// Two or three neighbours alone, if they explain far more than what went before.
static void drop_block(const orr_arc_room *room, const orr_reference_arc *arc, orr_arc_equations *e,
                       double *middle, double left)
{
    double least = BLOCK * left;
    size_t from = 0, length = 0, worst;
    double *before = malloc((arc->n + 1) * sizeof *before);
    if (before == NULL) return; // as it was
    memcpy(before, room->weight, arc->n * sizeof *before);
    for (size_t n = 2; n <= 3; n++)
        for (size_t first = 0; first + n <= arc->n; first++) {
            for (size_t i = 0; i < arc->n; i++) room->weight[i] = i < first || i >= first + n ? 1 : 0;
            accumulate(room, arc, e);
            double now;
            if (!leave_out(room, arc, e, &now) || !(now < least)) continue;
            least = BLOCK * now;
            from = first;
            length = n;
        }
    for (size_t i = 0; i < arc->n && length > 0; i++) before[i] = i < from || i >= from + length ? 1 : 0;
    memcpy(room->weight, before, arc->n * sizeof *before);
    free(before);
    accumulate(room, arc, e);
    if (leave_out(room, arc, e, &left)) *middle = usual(room, arc->n, &worst);
}

// Nodes that are wrong have no weight; then those come back that agree with the rest.
static void weigh(const orr_arc_room *room, orr_reference_arc *arc, orr_arc_equations *e)
{
    double middle = 0, left = 0;
    arc->rejected = 0;
    if (drop_worst(room, arc, e, &middle, &left) == 0) return;
    if (arc->n <= FEW) drop_block(room, arc, e, &middle, left);
    bool back = false;
    for (size_t i = 0; i < arc->n; i++) {
        if (room->weight[i] > 0) continue;
        const bool near = room->square[i] < REJECT * REJECT * middle || room->length[i] < REJECT_FLOOR_M;
        if (near) room->weight[i] = 1;
        back = back || near;
        arc->rejected += !near;
    }
    if (back) accumulate(room, arc, e);
}

orr_status orr_arc_equations_make(orr_arc_room *room, orr_reference_arc *arc, orr_arc_equations *out)
{
    orr_vec3 r = arc->r_m, v = arc->v_mps;
    double t = arc->t_s;
    transition z;
    start_transition(z);
    memcpy(room->force.ecom_nmps2, arc->ecom_nmps2, sizeof arc->ecom_nmps2);
    for (size_t i = 0; i < arc->n; i++) {
        const double dt = arc->node[i].t_s - t;
        if (dt > 0) {
            const orr_status s = advance(room, t, dt, &r, &v, z);
            if (s != ORR_OK) return s;
            t = arc->node[i].t_s;
        }
        make_row(room, arc, &arc->node[i], r, z, room->row[i]);
    }
    weigh(room, arc, out);
    return ORR_OK;
}
