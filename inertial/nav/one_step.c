// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/nav/one_step.h"

#include <math.h>
#include <string.h>

// C2(g) = E + (1-cos|g|)/|g|^2 hat(g) + (|g|-sin|g|)/|g|^3 hat(g)^2 (Bogdanov 2015, eq. (14)).
static orr_mat3 c2_of(orr_vec3 g)
{
    double q = orr_vec3_dot(g, g), b, c;
    if (q < 1e-3) { // the first omitted terms are below 1e-14 of the leading ones
        b = 0.5 - q / 24.0 * (1.0 - q / 30.0 * (1.0 - q / 56.0));
        c = 1.0 / 6.0 - q / 120.0 * (1.0 - q / 42.0 * (1.0 - q / 72.0));
    } else {
        double n = sqrt(q), h = sin(0.5 * n);
        b = 2.0 * h * h / q;
        c = (n - sin(n)) / (q * n);
    }
    orr_mat3 H = orr_mat3_hat(g), H2 = orr_mat3_mul(&H, &H), E = orr_mat3_identity();
    H = orr_mat3_scale(b, &H);
    H2 = orr_mat3_scale(c, &H2);
    E = orr_mat3_add(&E, &H);
    return orr_mat3_add(&E, &H2);
}

static orr_vec3 gravitation_inertial(const orr_gravity *g, orr_vec3 r_m, double t_s)
{
    orr_mat3 R = orr_inertial_from_ecef(t_s);
    return orr_mat3_apply(&R, orr_gravity_gravitation(g, orr_mat3_apply_t(&R, r_m)));
}

static orr_mat3 turned(orr_vec3 g, const orr_mat3 *A)
{
    orr_mat3 C = orr_mat3_from_rotvec(g);
    return orr_mat3_mul(&C, A);
}

// Latitude and (inertial) longitude of a geographic frame are those of its third axis.
static double frame_lat(const orr_mat3 *A) { return atan2(A->m[2][2], hypot(A->m[2][0], A->m[2][1])); }
static double frame_lon(const orr_mat3 *A) { return atan2(A->m[2][1], A->m[2][0]); }
static orr_vec3 frame_position(const orr_mat3 *A, double height_m)
{
    return orr_earth_to_ecef((orr_geodetic){frame_lat(A), frame_lon(A), height_m});
}

static void add_compensated(orr_one_step *s, orr_vec3 d)
{
    orr_vec3 y = orr_vec3_sub(d, s->r_low_m), t = orr_vec3_add(s->r_m, y);
    s->r_low_m = orr_vec3_sub(orr_vec3_sub(t, s->r_m), y);
    s->r_m = t;
}

void orr_one_step_start(orr_one_step *s, orr_nav_frame frame, bool project_mid, double dt_s,
                        const orr_gravity *gravity, double t_s, orr_vec3 r_m, orr_vec3 v_mps, orr_quat q_bi)
{
    memset(s, 0, sizeof *s);
    s->frame = frame;
    s->project_mid = project_mid;
    s->dt_s = dt_s;
    s->gravity = gravity;
    s->t_s = t_s;
    s->r_m = r_m;
    s->A_zi = orr_mat3_from_quat(q_bi);
    if (frame == ORR_FRAME_GEOGRAPHIC) {
        orr_geodetic at =
            orr_earth_from_ecef(r_m); // the ellipsoid is round: inertial longitude serves as well
        s->A_xi = orr_earth_enu_from_ecef(at.lat_rad, at.lon_rad);
        s->height_m = at.height_m;
        s->v_mps = orr_mat3_apply(&s->A_xi, v_mps);
    } else {
        s->v_mps = frame == ORR_FRAME_BODY ? orr_mat3_apply(&s->A_zi, v_mps) : v_mps;
    }
}

orr_vec3 orr_one_step_velocity(const orr_one_step *s)
{
    if (s->frame == ORR_FRAME_INERTIAL) return s->v_mps;
    return orr_mat3_apply_t(s->frame == ORR_FRAME_BODY ? &s->A_zi : &s->A_xi, s->v_mps);
}

// Turn of the geographic frame over one step that ends with absolute velocity v: E and N from the radii of
// curvature, U so that its first axis stays in the plane of latitude.
static orr_vec3 frame_turn(const orr_one_step *s, double lat_rad, double M, double N, orr_vec3 v)
{
    double g1 = -v.y * s->dt_s / (M + s->height_m), g2 = v.x * s->dt_s / (N + s->height_m);
    return orr_vec3_make(g1, g2, g2 * tan(lat_rad - 0.5 * g1));
}

static void advance_geographic(orr_one_step *s, const orr_mat3 *A_zp, orr_vec3 f)
{
    double M, N, lat = frame_lat(&s->A_xi);
    orr_earth_radii(lat, &M, &N);
    orr_vec3 f_i = orr_mat3_apply_t(A_zp, f);
    orr_vec3 F_i = orr_vec3_add(f_i, gravitation_inertial(s->gravity, s->r_m, s->t_s));
    // The frame turns with the velocity at the step's end, which depends on the turn: a fixed point whose
    // error shrinks some 1e6-fold a round.
    orr_vec3 v = s->v_mps, g = {0, 0, 0};
    for (int k = 0; k < 4; k++) {
        g = frame_turn(s, lat, M, N, v);
        orr_mat3 C1 = orr_mat3_from_rotvec(g), C2 = c2_of(g);
        orr_mat3 A_xp = s->project_mid ? turned(orr_vec3_scale(0.5, g), &s->A_xi) : s->A_xi;
        orr_vec3 F = orr_mat3_apply(&A_xp, F_i);
        v = orr_vec3_axpy(s->dt_s, orr_mat3_apply(&C2, F), orr_mat3_apply(&C1, s->v_mps));
    }
    s->v_mps = v;
    orr_mat3 A = turned(g, &s->A_xi);
    s->A_xi = orr_earth_enu_from_ecef(frame_lat(&A), frame_lon(&A));
    s->height_m += v.z * s->dt_s;
    s->r_m = frame_position(&s->A_xi, s->height_m);
}

void orr_one_step_advance(orr_one_step *s, orr_vec3 dtheta_rad, orr_vec3 dv_mps)
{
    orr_vec3 f = orr_vec3_scale(1.0 / s->dt_s, dv_mps);
    orr_mat3 A_zp = s->project_mid ? turned(orr_vec3_scale(0.5, dtheta_rad), &s->A_zi) : s->A_zi;
    if (s->frame == ORR_FRAME_GEOGRAPHIC) {
        advance_geographic(s, &A_zp, f);
        s->A_zi = turned(dtheta_rad, &s->A_zi);
    } else {
        orr_vec3 G = gravitation_inertial(s->gravity, s->r_m, s->t_s);
        if (s->frame == ORR_FRAME_INERTIAL) {
            s->v_mps = orr_vec3_axpy(s->dt_s, orr_vec3_add(orr_mat3_apply_t(&A_zp, f), G), s->v_mps);
            s->A_zi = turned(dtheta_rad, &s->A_zi);
            add_compensated(s, orr_vec3_scale(s->dt_s, s->v_mps));
        } else {
            orr_mat3 C1 = orr_mat3_from_rotvec(dtheta_rad), C2 = c2_of(dtheta_rad);
            orr_vec3 F = orr_vec3_add(f, orr_mat3_apply(&A_zp, G));
            s->v_mps = orr_vec3_axpy(s->dt_s, orr_mat3_apply(&C2, F), orr_mat3_apply(&C1, s->v_mps));
            s->A_zi = orr_mat3_mul(&C1, &s->A_zi);
            add_compensated(s, orr_vec3_scale(s->dt_s, orr_mat3_apply_t(&s->A_zi, s->v_mps)));
        }
    }
    s->t_s += s->dt_s;
}

// The ellipsoid is round: inertial longitudes serve as well.
void orr_hold_vertical(orr_vec3 reference_r_m, orr_vec3 reference_v_mps, orr_vec3 *r_m, orr_vec3 *v_mps)
{
    orr_geodetic ref = orr_earth_from_ecef(reference_r_m), at = orr_earth_from_ecef(*r_m);
    orr_mat3 A_ref = orr_earth_enu_from_ecef(ref.lat_rad, ref.lon_rad),
             A = orr_earth_enu_from_ecef(at.lat_rad, at.lon_rad);
    orr_vec3 up = {A.m[2][0], A.m[2][1], A.m[2][2]};
    double up_mps = orr_mat3_apply(&A_ref, reference_v_mps).z;
    *r_m = orr_vec3_axpy(ref.height_m - at.height_m, up, *r_m);
    *v_mps = orr_vec3_axpy(up_mps - orr_vec3_dot(*v_mps, up), up, *v_mps);
}

void orr_one_step_hold_vertical(orr_one_step *s, orr_vec3 reference_r_m, orr_vec3 reference_v_mps)
{
    if (s->frame == ORR_FRAME_GEOGRAPHIC) {
        orr_geodetic ref = orr_earth_from_ecef(reference_r_m);
        orr_mat3 A_ref = orr_earth_enu_from_ecef(ref.lat_rad, ref.lon_rad);
        s->height_m = ref.height_m;
        s->v_mps.z = orr_mat3_apply(&A_ref, reference_v_mps).z;
        s->r_m = frame_position(&s->A_xi, s->height_m);
    } else {
        orr_vec3 v = orr_one_step_velocity(s);
        orr_hold_vertical(reference_r_m, reference_v_mps, &s->r_m, &v);
        s->v_mps = s->frame == ORR_FRAME_BODY ? orr_mat3_apply(&s->A_zi, v) : v;
    }
}

// --- Approach 1: the same step solved for the reading ---

// True inertial position and attitude at edge j, and the geographic frame there.
typedef struct edge {
    orr_vec3 r_m;
    orr_mat3 A_zi, A_xi;
    double height_m;
} edge;

static edge edge_at(const orr_imu *imu, size_t j, bool geographic)
{
    edge e;
    orr_vec3 v;
    memset(&e, 0, sizeof e);
    orr_imu_true_state(imu, j, &e.r_m, &v, &e.A_zi);
    if (geographic) {
        orr_geodetic at = orr_earth_from_ecef(e.r_m);
        e.A_xi = orr_earth_enu_from_ecef(at.lat_rad, at.lon_rad);
        e.height_m = at.height_m;
    }
    return e;
}

// Turn of the frame from A0 to A1.
static orr_vec3 turn_between(const orr_mat3 *A0, const orr_mat3 *A1)
{
    orr_mat3 T = orr_mat3_transpose(A0), D = orr_mat3_mul(A1, &T);
    return orr_rotvec_from_mat3(&D);
}

// Velocity that belongs to the end of the step from s to `next`, in axes of the frame; *turn is the
// geographic frame's.
static orr_vec3 step_velocity(const orr_one_step *s, const edge *next, orr_vec3 *turn)
{
    if (s->frame == ORR_FRAME_GEOGRAPHIC) {
        double M, N;
        orr_earth_radii(frame_lat(&s->A_xi), &M, &N);
        *turn = turn_between(&s->A_xi, &next->A_xi);
        return orr_vec3_make((N + s->height_m) * turn->y / s->dt_s, -(M + s->height_m) * turn->x / s->dt_s,
                             (next->height_m - s->height_m) / s->dt_s);
    }
    orr_vec3 d = orr_vec3_add(orr_vec3_sub(next->r_m, s->r_m), s->r_low_m);
    orr_vec3 v = orr_vec3_scale(1.0 / s->dt_s, d);
    return s->frame == ORR_FRAME_BODY ? orr_mat3_apply(&next->A_zi, v) : v;
}

// Increments that take the state s to the edge `next` (Bogdanov 2015, eq. (13)).
static void solve_step(const orr_one_step *s, const edge *next, orr_vec3 *dtheta_rad, orr_vec3 *dv_mps)
{
    orr_vec3 g_z = turn_between(&s->A_zi, &next->A_zi), g_x = {0, 0, 0}, f;
    orr_mat3 A_zp = s->project_mid ? turned(orr_vec3_scale(0.5, g_z), &s->A_zi) : s->A_zi;
    orr_vec3 v1 = step_velocity(s, next, &g_x);
    orr_vec3 G = gravitation_inertial(s->gravity, s->r_m, s->t_s);
    if (s->frame == ORR_FRAME_INERTIAL) {
        f = orr_vec3_sub(orr_vec3_scale(1.0 / s->dt_s, orr_vec3_sub(v1, s->v_mps)), G);
        f = orr_mat3_apply(&A_zp, f);
    } else {
        orr_vec3 g = s->frame == ORR_FRAME_BODY ? g_z : g_x;
        orr_mat3 C1 = orr_mat3_from_rotvec(g), C2 = c2_of(g);
        orr_vec3 F = orr_vec3_scale(1.0 / s->dt_s,
                                    orr_mat3_solve(&C2, orr_vec3_sub(v1, orr_mat3_apply(&C1, s->v_mps))));
        if (s->frame == ORR_FRAME_BODY) {
            f = orr_vec3_sub(F, orr_mat3_apply(&A_zp, G));
        } else {
            orr_mat3 A_xp = s->project_mid ? turned(orr_vec3_scale(0.5, g_x), &s->A_xi) : s->A_xi;
            orr_vec3 f_i = orr_vec3_sub(orr_mat3_apply_t(&A_xp, F), G);
            f = orr_mat3_apply(&A_zp, f_i);
        }
    }
    *dtheta_rad = g_z;
    *dv_mps = orr_vec3_scale(s->dt_s, f);
}

// Puts the state on the truth of an edge, the velocity being that of the step just made (open loop).
static void set_on_edge(orr_one_step *s, const edge *e, orr_vec3 v_mps, double t_s)
{
    s->r_m = e->r_m;
    s->r_low_m = orr_vec3_make(0, 0, 0);
    s->A_zi = e->A_zi;
    s->A_xi = e->A_xi;
    s->height_m = e->height_m;
    s->v_mps = v_mps;
    s->t_s = t_s;
}

orr_status orr_one_step_generate(orr_imu *imu, const orr_gravity *gravity, orr_diag *diag)
{
    orr_nav_frame frame = imu->mode.frame;
    bool geographic = frame == ORR_FRAME_GEOGRAPHIC;
    if (geographic)
        for (size_t j = 0; j <= imu->n; j++)
            if (hypot(imu->r_m[j].x, imu->r_m[j].y) < 1000.0)
                return orr_diag_set(diag, ORR_E_UNSUPPORTED,
                                    "the track comes within 1 km of a pole %.1f s after the start, where the "
                                    "geographic frame "
                                    "has no north; use the inertial or the body frame",
                                    orr_imu_edge_s(imu, j));
    double dt = 1.0 / imu->rate_hz;
    edge e0 = edge_at(imu, 0, geographic), e1 = edge_at(imu, 1, geographic);
    orr_one_step s;
    orr_quat q0 = orr_quat_from_mat3(&e0.A_zi);
    orr_vec3 turn, zero = {0, 0, 0};
    orr_one_step_start(&s, frame, imu->mode.project_mid, dt, gravity, imu->begin_s, e0.r_m, zero, q0);
    orr_vec3 v = step_velocity(&s, &e1, &turn);
    if (frame == ORR_FRAME_BODY) v = orr_mat3_apply_t(&e1.A_zi, v);
    if (geographic) v = orr_mat3_apply_t(&s.A_xi, v);
    imu->start_r_m = e0.r_m;
    imu->start_v_mps = v;
    imu->start_q_bi = q0;
    orr_one_step_start(&s, frame, imu->mode.project_mid, dt, gravity, imu->begin_s, e0.r_m, v, q0);
    if (imu->mode.closed_loop) imu->carried_r_m[0] = s.r_m;
    for (size_t j = 0; j < imu->n; j++) {
        edge next = edge_at(imu, j + 1, geographic);
        solve_step(&s, &next, &imu->dtheta_rad[j], &imu->dv_mps[j]);
        if (imu->mode.closed_loop) {
            orr_one_step_advance(&s, imu->dtheta_rad[j], imu->dv_mps[j]);
            imu->carried_r_m[j + 1] = s.r_m;
        } else {
            orr_vec3 v1 = step_velocity(&s, &next, &turn);
            set_on_edge(&s, &next, v1, orr_imu_edge_s(imu, j + 1));
        }
    }
    return ORR_OK;
}
