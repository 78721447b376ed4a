// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/study/error_equations.h"

#include <math.h>

#include "inertial/readings/imu.h"

static orr_vec3 add(orr_vec3 a, orr_vec3 b) { return orr_vec3_add(a, b); }
static orr_vec3 sub(orr_vec3 a, orr_vec3 b) { return orr_vec3_sub(a, b); }
static orr_vec3 cross(orr_vec3 a, orr_vec3 b) { return orr_vec3_cross(a, b); }

static orr_mat3 round_gradient(const orr_error_point *p)
{
    const double over_r = orr_vec3_norm(p->gravity) / (sqrt(p->meridian_m * p->normal_m) + p->height_m);
    return (orr_mat3){{{-over_r, 0, 0}, {0, -over_r, 0}, {0, 0, 2.0 * over_r}}};
}

// Central differences over 20 m: the third derivative leaves 1e-11 of it, rounding 1e-10.
static orr_mat3 field_gradient(const orr_gravity *g, orr_vec3 r, const orr_mat3 *D)
{
    enum { AXES = 3 };
    const double step = 10.0;
    orr_mat3 out;
    for (int k = 0; k < AXES; k++) {
        const orr_vec3 axis = orr_vec3_make(D->m[k][0], D->m[k][1], D->m[k][2]);
        const orr_vec3 ahead = orr_gravity_gravitation(g, orr_vec3_axpy(step, axis, r)),
                       behind = orr_gravity_gravitation(g, orr_vec3_axpy(-step, axis, r));
        const orr_vec3 d = orr_mat3_apply(D, orr_vec3_scale(0.5 / step, sub(ahead, behind)));
        out.m[0][k] = d.x;
        out.m[1][k] = d.y;
        out.m[2][k] = d.z;
    }
    return out;
}

void orr_error_point_at(const orr_trajectory *tr, const orr_gravity *g, double t_s, bool round,
                        orr_error_point *out)
{
    orr_motion m;
    tr->evaluate(tr->self, t_s, &m);
    const orr_geodetic at = orr_earth_from_ecef(m.r_m);
    const double s = sin(at.lat_rad), c = cos(at.lat_rad), u = ORR_EARTH_RATE_RADPS;
    orr_error_point p = {.t_s = t_s, .lat_rad = at.lat_rad, .height_m = at.height_m};
    orr_earth_radii(at.lat_rad, &p.meridian_m, &p.normal_m);
    p.D = orr_earth_enu_from_ecef(at.lat_rad, at.lon_rad);
    const orr_mat3 B = orr_mat3_from_quat(m.q_be), Bt = orr_mat3_transpose(&B);
    p.C = orr_mat3_mul(&p.D, &Bt);
    const orr_vec3 attraction = orr_gravity_gravitation(g, m.r_m);
    p.r = orr_mat3_apply(&p.D, m.r_m);
    p.v = orr_mat3_apply(&p.D, m.v_mps);
    p.f = orr_mat3_apply(&p.D, sub(orr_motion_absolute_acceleration(&m), attraction));
    p.earth = orr_vec3_make(0.0, u * c, u * s);
    p.w = add(p.v, cross(p.earth, p.r));
    const double north = p.v.y / (p.meridian_m + at.height_m), east = p.v.x / (p.normal_m + at.height_m);
    p.transport = orr_vec3_make(-north, east, east * s / c);
    p.gravity = sub(orr_mat3_apply(&p.D, attraction), cross(p.earth, cross(p.earth, p.r)));
    p.gradient = round ? round_gradient(&p) : field_gradient(g, m.r_m, &p.D);
    *out = p;
}

// The gradient of plumb gravity: gravitation's and that of -earth x (earth x r).
static orr_vec3 gravity_change(const orr_error_point *p, orr_vec3 dr)
{
    return sub(orr_mat3_apply(&p->gradient, dr), cross(p->earth, cross(p->earth, dr)));
}

orr_vec3 orr_error_turn_of_axes(const orr_error_point *p, orr_vec3 q)
{
    return orr_vec3_make(-q.y, cos(p->lat_rad) * q.x, sin(p->lat_rad) * q.x);
}

static orr_vec3 metres_of_phi(const orr_error_point *p, orr_vec3 q)
{
    return orr_vec3_make((p->normal_m + p->height_m) * cos(p->lat_rad) * q.x,
                         (p->meridian_m + p->height_m) * q.y, q.z);
}
static orr_vec3 phi_of_metres(const orr_error_point *p, orr_vec3 d)
{
    return orr_vec3_make(d.x / ((p->normal_m + p->height_m) * cos(p->lat_rad)),
                         d.y / (p->meridian_m + p->height_m), d.z);
}

// --- phi: the differential of the equations that a navigator in geographic axes solves ---

static orr_error_state rate_phi(const orr_error_point *p, const orr_error_state *x, orr_vec3 gyro,
                                orr_vec3 accel)
{
    const double s = sin(p->lat_rad), c = cos(p->lat_rad), t = s / c, u = ORR_EARTH_RATE_RADPS;
    const double q = 1.0 - ORR_WGS84_E2 * s * s;
    const double dN = p->normal_m * ORR_WGS84_E2 * s * c / q,
                 dM = 3.0 * p->meridian_m * ORR_WGS84_E2 * s * c / q;
    const double N = p->normal_m + p->height_m, M = p->meridian_m + p->height_m;
    const double lat = x->position.y, high = x->position.z;
    // Of the rates v_N / M and v_E / N.
    const double north = x->velocity.y / M - p->v.y * (dM * lat + high) / (M * M);
    const double east = x->velocity.x / N - p->v.x * (dN * lat + high) / (N * N);
    const orr_vec3 transport = orr_vec3_make(-north, east, t * east + p->v.x / N * lat / (c * c));
    const orr_vec3 earth = orr_vec3_make(0.0, -u * s * lat, u * c * lat);
    const orr_vec3 turn = orr_error_turn_of_axes(p, x->position), dr = metres_of_phi(p, x->position);
    const orr_vec3 both = add(p->earth, p->transport), coriolis = add(p->earth, both);
    const orr_vec3 d_coriolis = add(transport, orr_vec3_scale(2.0, earth));
    // Gravity there, seen in the axes there.
    const orr_vec3 d_gravity = sub(gravity_change(p, dr), cross(turn, p->gravity));
    orr_error_state out;
    out.position = orr_vec3_make(east / c + p->v.x / N * s / (c * c) * lat, north, x->velocity.z);
    out.velocity = add(cross(x->attitude, p->f), add(accel, d_gravity));
    out.velocity = sub(out.velocity, add(cross(coriolis, x->velocity), cross(d_coriolis, p->v)));
    out.attitude = sub(sub(gyro, add(earth, transport)), cross(both, x->attitude));
    return out;
}

// --- psi: vectors, seen from the geographic axes ---

static orr_error_state rate_psi(const orr_error_point *p, const orr_error_state *x, orr_vec3 gyro,
                                orr_vec3 accel)
{
    const orr_vec3 both = add(p->earth, p->transport), coriolis = add(p->earth, both);
    orr_error_state out;
    out.position = sub(x->velocity, cross(p->transport, x->position));
    out.velocity = add(cross(x->attitude, p->f), add(accel, gravity_change(p, x->position)));
    out.velocity = sub(out.velocity, cross(coriolis, x->velocity));
    out.attitude = sub(gyro, cross(both, x->attitude));
    return out;
}

// --- dynamic: components in the instruments' axes. Their errors turn what is integrated, not what gravity does to it ---

static orr_error_state rate_dynamic(const orr_error_point *p, const orr_error_state *x, orr_vec3 gyro,
                                    orr_vec3 accel)
{
    const orr_vec3 both = add(p->earth, p->transport);
    const orr_vec3 attraction = add(p->gravity, cross(p->earth, cross(p->earth, p->r)));
    const orr_vec3 full = add(x->position, cross(x->attitude, p->r));
    const orr_vec3 d_attraction = sub(orr_mat3_apply(&p->gradient, full), cross(x->attitude, attraction));
    orr_error_state out;
    out.position = add(sub(x->velocity, cross(both, x->position)), cross(p->r, gyro));
    out.velocity = add(sub(add(accel, d_attraction), cross(both, x->velocity)), cross(p->w, gyro));
    out.attitude = sub(gyro, cross(both, x->attitude));
    return out;
}

orr_error_state orr_error_rate(orr_error_model m, const orr_error_point *p, const orr_error_state *x,
                               orr_vec3 gyro_radps, orr_vec3 accel_mps2)
{
    const orr_vec3 gyro = orr_mat3_apply(&p->C, gyro_radps), accel = orr_mat3_apply(&p->C, accel_mps2);
    return m == ORR_ERROR_PHI   ? rate_phi(p, x, gyro, accel)
           : m == ORR_ERROR_PSI ? rate_psi(p, x, gyro, accel)
                                : rate_dynamic(p, x, gyro, accel);
}

// --- From one to another, by way of psi's vectors ---

static orr_error_state to_psi(orr_error_model m, const orr_error_point *p, const orr_error_state *x)
{
    orr_error_state out = *x;
    if (m == ORR_ERROR_PHI) {
        const orr_vec3 turn = orr_error_turn_of_axes(p, x->position);
        out.position = metres_of_phi(p, x->position);
        out.velocity = add(x->velocity, cross(turn, p->v));
        out.attitude = add(x->attitude, turn);
    } else if (m == ORR_ERROR_DYNAMIC) {
        out.position = add(x->position, cross(x->attitude, p->r));
        out.velocity = add(x->velocity, cross(x->attitude, p->w));
        out.velocity = sub(out.velocity, cross(p->earth, out.position));
    }
    return out;
}

static orr_error_state from_psi(orr_error_model m, const orr_error_point *p, const orr_error_state *x)
{
    orr_error_state out = *x;
    if (m == ORR_ERROR_PHI) {
        out.position = phi_of_metres(p, x->position);
        const orr_vec3 turn = orr_error_turn_of_axes(p, out.position);
        out.velocity = sub(x->velocity, cross(turn, p->v));
        out.attitude = sub(x->attitude, turn);
    } else if (m == ORR_ERROR_DYNAMIC) {
        out.position = sub(x->position, cross(x->attitude, p->r));
        out.velocity = sub(add(x->velocity, cross(p->earth, x->position)), cross(x->attitude, p->w));
    }
    return out;
}

orr_error_state orr_error_convert(orr_error_model from, orr_error_model to, const orr_error_point *p,
                                  const orr_error_state *x)
{
    const orr_error_state psi = to_psi(from, p, x);
    return from_psi(to, p, &psi);
}

orr_error_state orr_error_hold_vertical(orr_error_model m, const orr_error_point *p, const orr_error_state *x)
{
    orr_error_state phi = orr_error_convert(m, ORR_ERROR_PHI, p, x);
    phi.position.z = phi.velocity.z = 0.0;
    return orr_error_convert(ORR_ERROR_PHI, m, p, &phi);
}

orr_vec3 orr_error_metres(orr_error_model m, const orr_error_point *p, const orr_error_state *x)
{
    return m == ORR_ERROR_PHI ? metres_of_phi(p, x->position) : x->position;
}

// The turn a of C'C^T = 1 + [a x] + ...
static orr_vec3 turn_between(const orr_mat3 *now, const orr_mat3 *truth)
{
    const orr_mat3 t = orr_mat3_transpose(truth), d = orr_mat3_mul(now, &t);
    return orr_vec3_scale(-1.0, orr_rotvec_from_mat3(&d));
}

orr_error_state orr_error_direct(orr_error_model m, const orr_error_point *p, orr_vec3 r_m, orr_vec3 w_mps,
                                 const orr_mat3 *A_bi)
{
    const orr_mat3 R = orr_inertial_from_ecef(p->t_s), Rt = orr_mat3_transpose(&R);
    const orr_mat3 B = orr_mat3_mul(A_bi, &R), Bt = orr_mat3_transpose(&B); // navigated body from ecef
    const orr_vec3 r = orr_mat3_apply(&Rt, r_m), w = orr_mat3_apply(&Rt, w_mps);
    const orr_vec3 u = orr_vec3_make(0.0, 0.0, ORR_EARTH_RATE_RADPS), v = sub(w, cross(u, r));
    orr_error_state out;
    if (m == ORR_ERROR_PHI) {
        const orr_geodetic at = orr_earth_from_ecef(r),
                           truth = orr_earth_from_ecef(orr_mat3_apply_t(&p->D, p->r));
        const orr_mat3 D = orr_earth_enu_from_ecef(at.lat_rad, at.lon_rad), C = orr_mat3_mul(&D, &Bt);
        out.position = orr_vec3_make(remainder(at.lon_rad - truth.lon_rad, 2.0 * ORR_PI),
                                     at.lat_rad - p->lat_rad, at.height_m - p->height_m);
        out.velocity = sub(orr_mat3_apply(&D, v), p->v);
        out.attitude = turn_between(&C, &p->C);
        return out;
    }
    const orr_mat3 C = orr_mat3_mul(&p->D, &Bt); // navigated, in the true geographic axes
    out.attitude = turn_between(&C, &p->C);
    if (m == ORR_ERROR_PSI) {
        out.position = sub(orr_mat3_apply(&p->D, r), p->r);
        out.velocity = sub(orr_mat3_apply(&p->D, v), p->v);
        return out;
    }
    out.position = sub(orr_mat3_apply(&p->C, orr_mat3_apply(&B, r)), p->r);
    out.velocity = sub(orr_mat3_apply(&p->C, orr_mat3_apply(&B, w)), p->w);
    return out;
}
