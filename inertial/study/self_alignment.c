// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/study/self_alignment.h"

#include <math.h>

// Rows: the axes of the triad that two vectors span, the first along `a`. Zero rows where they are parallel.
static orr_mat3 triad(orr_vec3 a, orr_vec3 b)
{
    const orr_vec3 x = orr_vec3_unit(a), y = orr_vec3_unit(orr_vec3_cross(a, b)), z = orr_vec3_cross(x, y);
    return (orr_mat3){{{x.x, x.y, x.z}, {y.x, y.y, y.z}, {z.x, z.y, z.z}}};
}

// The rotation that takes a pair of vectors in one frame into the same pair in another: exact for the first of them.
static orr_status match(orr_vec3 a, orr_vec3 b, orr_vec3 a_seen, orr_vec3 b_seen, orr_mat3 *seen_from,
                        orr_diag *diag)
{
    const double span = orr_vec3_norm(orr_vec3_cross(a, b)) / (orr_vec3_norm(a) * orr_vec3_norm(b));
    if (!(span > 1e-9))
        return orr_diag_set(
            diag, ORR_E_NUMERIC,
            "gravity and the Earth's rotation tell no heading here: the window is too short, or the "
            "place is a pole");
    const orr_mat3 t = triad(a, b), s = triad(a_seen, b_seen), st = orr_mat3_transpose(&s);
    *seen_from = orr_mat3_mul(&st, &t);
    return ORR_OK;
}

// What a run has read: the measured increments, else the ideal ones.
static orr_vec3 turned(const orr_imu *m, size_t j)
{
    return (m->measured_dtheta_rad != NULL ? m->measured_dtheta_rad : m->dtheta_rad)[j];
}
static orr_vec3 pushed(const orr_imu *m, size_t j)
{
    return (m->measured_dv_mps != NULL ? m->measured_dv_mps : m->dv_mps)[j];
}

static orr_geodetic place_of(const orr_imu *m, size_t j) { return orr_earth_from_ecef(m->r_m[j]); }

static orr_mat3 true_body_from_enu(const orr_imu *m, size_t j)
{
    const orr_geodetic g = place_of(m, j);
    const orr_mat3 enu = orr_earth_enu_from_ecef(g.lat_rad, g.lon_rad), t = orr_mat3_transpose(&enu);
    const orr_mat3 body = orr_mat3_from_quat(m->q_be[j]);
    return orr_mat3_mul(&body, &t);
}

// Plumb gravity that a body at rest feels, reversed: the specific force of rest, ecef axes.
static orr_vec3 rest_force(const orr_gravity *g, orr_vec3 r)
{
    const double u2 = ORR_EARTH_RATE_RADPS * ORR_EARTH_RATE_RADPS;
    const orr_vec3 a = orr_gravity_gravitation(g, r);
    return orr_vec3_make(-a.x - u2 * r.x, -a.y - u2 * r.y, -a.z);
}

static orr_status by_average(const orr_imu *m, size_t from, size_t to, orr_vec3 force_enu, orr_vec3 rate_enu,
                             orr_mat3 *body_from_enu, orr_diag *diag)
{
    orr_vec3 th = {0, 0, 0}, dv = {0, 0, 0};
    for (size_t j = from; j < to; j++) {
        th = orr_vec3_add(th, turned(m, j));
        dv = orr_vec3_add(dv, pushed(m, j));
    }
    return match(force_enu, rate_enu, dv, th, body_from_enu, diag);
}

// Gravity's integrals over the first half and over the second, in the axes of the window's begin: as the gyros carry
// them, and as the Earth turns.
static orr_status by_gravity(const orr_imu *m, size_t from, size_t to, orr_vec3 force_ecef,
                             const orr_mat3 *enu_from_ecef, orr_mat3 *body_from_enu, orr_diag *diag)
{
    orr_mat3 body_from_begin = orr_mat3_identity();
    orr_vec3 seen[2] = {{0, 0, 0}, {0, 0, 0}}, last_th = {0, 0, 0}, last_dv = {0, 0, 0}, known[2];
    const size_t half = (from + to) / 2;
    for (size_t j = from; j < to; j++) {
        const orr_vec3 th = turned(m, j), dv = pushed(m, j);
        // Coning and sculling with the increment before (Savage 1998, eq. (26), (36)).
        const orr_vec3 phi = orr_vec3_axpy(1.0 / 12.0, orr_vec3_cross(last_th, th), th);
        orr_vec3 push = orr_vec3_axpy(0.5, orr_vec3_cross(th, dv), dv);
        push = orr_vec3_axpy(1.0 / 12.0,
                             orr_vec3_add(orr_vec3_cross(last_th, dv), orr_vec3_cross(last_dv, th)), push);
        seen[j >= half] = orr_vec3_add(seen[j >= half], orr_mat3_apply_t(&body_from_begin, push));
        const orr_mat3 step = orr_mat3_from_rotvec(phi);
        body_from_begin = orr_mat3_mul(&step, &body_from_begin);
        last_th = th;
        last_dv = dv;
    }
    const double u = ORR_EARTH_RATE_RADPS, dt = 1.0 / m->rate_hz;
    const double edge[3] = {0.0, (double)(half - from) * dt, (double)(to - from) * dt};
    for (int k = 0; k < 2; k++) { // of R3(-u t) f, t from the window's begin
        const double c = (sin(u * edge[k + 1]) - sin(u * edge[k])) / u,
                     s = -(cos(u * edge[k + 1]) - cos(u * edge[k])) / u;
        known[k] = orr_vec3_make(c * force_ecef.x - s * force_ecef.y, s * force_ecef.x + c * force_ecef.y,
                                 (edge[k + 1] - edge[k]) * force_ecef.z);
    }
    // The sum is the best known vertical, the difference shows where it goes.
    orr_mat3 begin_from_ecef;
    orr_status s =
        match(orr_vec3_add(known[0], known[1]), orr_vec3_sub(known[1], known[0]),
              orr_vec3_add(seen[0], seen[1]), orr_vec3_sub(seen[1], seen[0]), &begin_from_ecef, diag);
    if (s != ORR_OK) return s;
    const orr_mat3 turn = orr_inertial_from_ecef(edge[2]), ecef_from_enu = orr_mat3_transpose(enu_from_ecef);
    orr_mat3 a = orr_mat3_mul(&turn, &ecef_from_enu);
    a = orr_mat3_mul(&begin_from_ecef, &a);
    *body_from_enu = orr_mat3_mul(&body_from_begin, &a);
    return ORR_OK;
}

static double within_half_turn(double a) { return remainder(a, 2.0 * acos(-1.0)); }

orr_angles orr_self_alignment_closed_form(orr_vec3 gyro, orr_vec3 accel, double heading_rad, double lat_rad,
                                          double gravity_mps2)
{
    const double c = cos(heading_rad), s = sin(heading_rad);
    const double right = c * accel.x - s * accel.y, forward = s * accel.x + c * accel.y;
    return (orr_angles){.heading_rad = -gyro.x / (ORR_EARTH_RATE_RADPS * cos(lat_rad)) +
                                       tan(lat_rad) * accel.x / gravity_mps2,
                        .pitch_rad = forward / gravity_mps2,
                        .roll_rad = -right / gravity_mps2};
}

// Means of the window: of the errors, East, North, Up, and of the true angles.
static void means(const orr_imu *m, size_t from, size_t to, orr_self_alignment *out)
{
    orr_vec3 gyro = {0, 0, 0}, accel = {0, 0, 0};
    const orr_mat3 first = true_body_from_enu(m, from);
    const orr_angles a0 = orr_angles_from_body_enu(&first);
    orr_angles sum = {0, 0, 0};
    for (size_t j = from; j < to; j++) {
        const orr_mat3 b = true_body_from_enu(m, j);
        const orr_angles a = orr_angles_from_body_enu(&b);
        gyro = orr_vec3_add(gyro, orr_mat3_apply_t(&b, orr_vec3_sub(turned(m, j), m->dtheta_rad[j])));
        accel = orr_vec3_add(accel, orr_mat3_apply_t(&b, orr_vec3_sub(pushed(m, j), m->dv_mps[j])));
        sum.heading_rad += within_half_turn(a.heading_rad - a0.heading_rad);
        sum.pitch_rad += a.pitch_rad;
        sum.roll_rad += a.roll_rad;
    }
    const double n = (double)(to - from);
    out->gyro_error_radps = orr_vec3_scale(m->rate_hz / n, gyro);
    out->accel_error_mps2 = orr_vec3_scale(m->rate_hz / n, accel);
    out->truth = (orr_angles){a0.heading_rad + sum.heading_rad / n, sum.pitch_rad / n, sum.roll_rad / n};
}

orr_status orr_self_align(const orr_imu *imu, orr_self_method method, size_t from, size_t to,
                          const orr_gravity *gravity, orr_self_alignment *out, orr_diag *diag)
{
    if (!(from + 2 <= to && to <= imu->n) || imu->truth_every != 1)
        return orr_diag_set(diag, ORR_E_ARG,
                            "a window of two readings at least is wanted, with truth at every reading");
    const orr_geodetic g = place_of(imu, to);
    const orr_mat3 enu = orr_earth_enu_from_ecef(g.lat_rad, g.lon_rad);
    const orr_vec3 force_ecef = rest_force(gravity, imu->r_m[to]), force = orr_mat3_apply(&enu, force_ecef);
    const orr_vec3 rate = orr_mat3_apply(&enu, orr_vec3_make(0, 0, ORR_EARTH_RATE_RADPS));
    orr_mat3 b;
    const orr_status s = method == ORR_SELF_AVERAGE ? by_average(imu, from, to, force, rate, &b, diag)
                                                    : by_gravity(imu, from, to, force_ecef, &enu, &b, diag);
    if (s != ORR_OK) return s;
    out->found = orr_angles_from_body_enu(&b);
    means(imu, from, to, out);
    if (method == ORR_SELF_INERTIAL) {
        const orr_mat3 last = true_body_from_enu(imu, to);
        out->truth = orr_angles_from_body_enu(&last);
    }
    out->error =
        (orr_angles){within_half_turn(out->found.heading_rad - out->truth.heading_rad),
                     out->found.pitch_rad - out->truth.pitch_rad, out->found.roll_rad - out->truth.roll_rad};
    out->closed_form =
        orr_self_alignment_closed_form(out->gyro_error_radps, out->accel_error_mps2, out->truth.heading_rad,
                                       g.lat_rad, orr_vec3_norm(force));
    return ORR_OK;
}
