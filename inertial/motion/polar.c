// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/motion/polar.h"

#include <math.h>

// East, north and up of a sphere; at a pole, longitude 0 serves.
static orr_mat3 sphere_axes(orr_vec3 r_m)
{
    double level = hypot(r_m.x, r_m.y), lon = level > 0.0 ? atan2(r_m.y, r_m.x) : 0.0;
    return orr_earth_enu_from_ecef(atan2(r_m.z, level), lon);
}

orr_mat3 orr_polar_rotation(orr_vec3 from_m, orr_vec3 to_m, double azimuth_rad)
{
    orr_mat3 from = sphere_axes(from_m), to = sphere_axes(to_m), turn = orr_mat3_rot3(-azimuth_rad);
    // What lay along axis k of `from` lies along axis k of the turned `to`: C^T = to^T from.
    to = orr_mat3_mul(&turn, &to);
    orr_mat3 from_t = orr_mat3_transpose(&from);
    return orr_mat3_mul(&from_t, &to);
}

orr_vec3 orr_trajectory_middle(const orr_trajectory *tr)
{
    double span = tr->end_s - tr->begin_s;
    size_t n = (size_t)(span < 1e6 ? span : 1e6) + 2;
    orr_vec3 sum = {0, 0, 0};
    for (size_t k = 0; k < n; k++) {
        orr_motion m;
        tr->evaluate(tr->self, tr->begin_s + span * (double)k / (double)(n - 1), &m);
        sum = orr_vec3_add(sum, orr_vec3_unit(m.r_m));
    }
    return orr_vec3_scale(ORR_EARTH_MEAN_RADIUS_M, orr_vec3_unit(sum));
}

orr_vec3 orr_polar_place(const orr_mat3 *C, orr_vec3 r_m)
{
    orr_geodetic at = orr_earth_from_ecef(orr_mat3_apply_t(C, r_m));
    at.height_m = orr_earth_from_ecef(r_m).height_m;
    return orr_earth_to_ecef(at);
}

orr_vec3 orr_polar_home(const orr_mat3 *C, orr_vec3 r_m)
{
    // The place before its height was put right lies on the same vertical, where turning back gives the height. The
    // verticals differ by at most 0.0067 rad: each round leaves some 1e-5 of the error.
    orr_geodetic at = orr_earth_from_ecef(r_m);
    const double height_m = at.height_m;
    orr_vec3 home = r_m;
    for (int k = 0; k < 4; k++) {
        home = orr_mat3_apply(C, orr_earth_to_ecef(at));
        at.height_m += height_m - orr_earth_from_ecef(home).height_m;
    }
    return home;
}

typedef struct carried {
    orr_mat3 C;
    orr_polar_attitude attitude;
} carried;

static void transfer(void *user, double t_s, orr_motion *m)
{
    const carried *c = user;
    (void)t_s;
    orr_mat3 B = orr_mat3_from_quat(m->q_be), BC = orr_mat3_mul(&B, &c->C);
    orr_vec3 up = orr_mat3_apply_t(&c->C, orr_earth_up(m->r_m));
    m->r_m = orr_polar_place(&c->C, m->r_m);
    if (c->attitude == ORR_POLAR_LEVEL) {
        // As a passive turn of the axes that takes the components along `up` to those along the new vertical.
        orr_vec3 axis = orr_vec3_cross(up, orr_earth_up(m->r_m));
        double sine = orr_vec3_norm(axis);
        if (sine > 0.0) {
            orr_mat3 turn = orr_mat3_from_rotvec(orr_vec3_scale(asin(fmin(sine, 1.0)) / sine, axis));
            BC = orr_mat3_mul(&BC, &turn);
        }
    }
    m->q_be = orr_quat_from_mat3(&BC);
}

orr_status orr_polar_transfer(const orr_trajectory *in, const orr_mat3 *C, orr_polar_attitude attitude,
                              double step_s, orr_trajectory *out, orr_diag *diag)
{
    carried c = {*C, attitude};
    double step = step_s > 0.0 ? step_s : in->knot_step_s > 0.0 ? in->knot_step_s : 0.2;
    return orr_trajectory_resample(in, step, transfer, &c, out, diag);
}
