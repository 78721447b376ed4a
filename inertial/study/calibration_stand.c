// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/study/calibration_stand.h"

#include <math.h>
#include <string.h>

#include "core/astro.h"

// [v x]
static orr_mat3 cross_matrix(orr_vec3 v)
{
    const orr_mat3 hat = orr_mat3_hat(v);
    return orr_mat3_scale(-1.0, &hat);
}

// --- The stand ---

// Axis 2 where it points; axis 1 horizontal, to the right of it (East where it is vertical).
static orr_mat3 stand_axes(double azimuth, double elevation)
{
    const orr_vec3 two = {cos(elevation) * sin(azimuth), cos(elevation) * cos(azimuth), sin(elevation)};
    const orr_vec3 one =
        cos(elevation) > 1e-9 ? (orr_vec3){cos(azimuth), -sin(azimuth), 0.0} : (orr_vec3){1, 0, 0};
    const orr_vec3 first = orr_vec3_unit(orr_vec3_axpy(-orr_vec3_dot(one, two), two, one));
    const orr_vec3 three = orr_vec3_cross(first, two);
    return (orr_mat3){{{first.x, first.y, first.z}, {two.x, two.y, two.z}, {three.x, three.y, three.z}}};
}

orr_status orr_stand_prepare(const orr_stand_setup *setup, orr_stand *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    if (!(fabs(setup->elevation_rad) <= ORR_PI / 2 * (1 + 1e-12)) || !isfinite(setup->azimuth_rad))
        return orr_diag_set(diag, ORR_E_ARG,
                            "the stand's axis is %g deg above the horizon; it is within -90 and 90",
                            setup->elevation_rad * ORR_DEG_PER_RAD);
    if (!(fabs(setup->place.height_m) < 1e5) || !(fabs(setup->place.lat_rad) <= ORR_PI / 2 * (1 + 1e-12)))
        return orr_diag_set(diag, ORR_E_ARG, "the stand is not on the Earth");
    out->setup = *setup;
    out->place_m = orr_earth_to_ecef(setup->place);
    out->A_xe = orr_earth_enu_from_ecef(setup->place.lat_rad, setup->place.lon_rad);
    out->C_tx = stand_axes(setup->azimuth_rad, setup->elevation_rad);
    const orr_vec3 u = {0.0, 0.0, ORR_EARTH_RATE_RADPS};
    out->u_radps = orr_mat3_apply(&out->A_xe, u);
    const orr_vec3 turned = orr_vec3_cross(u, orr_vec3_cross(u, out->place_m));
    const orr_vec3 here = orr_gravity_gravitation(setup->gravity, out->place_m);
    out->rest_mps2 = orr_mat3_apply(&out->A_xe, orr_vec3_sub(turned, here));
    // Over 10 m gravitation is linear to 1e-11 of its change.
    const double step = 10.0;
    for (int k = 0; k < 3; k++) {
        orr_vec3 dx = {k == 0 ? step : 0.0, k == 1 ? step : 0.0, k == 2 ? step : 0.0};
        dx = orr_mat3_apply_t(&out->A_xe, dx);
        const orr_vec3 change = orr_mat3_apply(
            &out->A_xe,
            orr_vec3_sub(orr_gravity_gravitation(setup->gravity, orr_vec3_add(out->place_m, dx)),
                         orr_gravity_gravitation(setup->gravity, orr_vec3_sub(out->place_m, dx))));
        out->gradient_ps2.m[0][k] = change.x / (2 * step);
        out->gradient_ps2.m[1][k] = change.y / (2 * step);
        out->gradient_ps2.m[2][k] = change.z / (2 * step);
    }
    return ORR_OK;
}

// --- Profiles ---

double orr_stand_duration(const orr_stand_profile *p)
{
    double sum = 0;
    for (size_t k = 0; k < p->n; k++) sum += p->segment[k].duration_s;
    return sum;
}

// Begin of the segment that t_s is in (its end belongs to it where `late`), and angle and rate there.
static size_t segment_at(const orr_stand_profile *p, double t_s, double *begin_s, double *angle, double *rate)
{
    size_t k = 0;
    *begin_s = *angle = *rate = 0;
    for (; k + 1 < p->n; k++) {
        const double length = p->segment[k].duration_s;
        if (t_s < *begin_s + length) break;
        *begin_s += length;
        *angle += 0.5 * (*rate + p->segment[k].rate_radps) * length;
        *rate = p->segment[k].rate_radps;
    }
    return k;
}

static void turn_in(const orr_stand_profile *p, size_t k, double since_s, double angle, double rate,
                    double out[3])
{
    const orr_stand_segment *s = &p->segment[k];
    double change = (s->rate_radps - rate) / s->duration_s;
    if (since_s > s->duration_s) { // beyond the end
        angle += 0.5 * (rate + s->rate_radps) * s->duration_s;
        since_s -= s->duration_s;
        rate = s->rate_radps;
        change = 0;
    }
    const double theta = angle + (rate + 0.5 * change * since_s) * since_s, w = rate + change * since_s;
    const double a = p->ripple, n = p->ripple_per_turn;
    out[0] = theta;
    out[1] = w;
    out[2] = change;
    if (!(fabs(a) > 0) || !(n > 0)) return;
    const double half = sin(0.5 * n * theta);
    out[0] += a / n * 2 * half * half; // (1 - cos) / n
    out[1] *= 1 + a * sin(n * theta);
    out[2] = change * (1 + a * sin(n * theta)) + a * n * w * w * cos(n * theta);
}

void orr_stand_turn(const orr_stand_profile *p, double t_s, double *angle_rad, double *rate_radps,
                    double *acceleration_radps2)
{
    double begin, angle, rate, out[3];
    const size_t k = segment_at(p, t_s, &begin, &angle, &rate);
    turn_in(p, k, t_s - begin, angle, rate, out);
    *angle_rad = out[0];
    *rate_radps = out[1];
    *acceleration_radps2 = out[2];
}

orr_status orr_stand_cycle_check(const orr_stand_cycle *c, orr_diag *diag)
{
    const orr_mat3 T = orr_mat3_transpose(&c->order), P = orr_mat3_mul(&c->order, &T);
    const orr_vec3 x = {c->order.m[0][0], c->order.m[0][1], c->order.m[0][2]},
                   y = {c->order.m[1][0], c->order.m[1][1], c->order.m[1][2]},
                   z = {c->order.m[2][0], c->order.m[2][1], c->order.m[2][2]};
    double off = fabs(orr_vec3_dot(orr_vec3_cross(x, y), z) - 1.0);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) off = fmax(off, fabs(P.m[i][j] - (i == j ? 1.0 : 0.0)));
    if (!(off < 1e-9)) return orr_diag_set(diag, ORR_E_ARG, "the order of a cycle's axes is no rotation");
    if (!(orr_vec3_norm(c->mounting_rad) < ORR_PI / 4))
        return orr_diag_set(diag, ORR_E_ARG, "a mounting error of %g deg; less than 45 is meant by it",
                            orr_vec3_norm(c->mounting_rad) * ORR_DEG_PER_RAD);
    if (c->profile.n == 0) return orr_diag_set(diag, ORR_E_ARG, "a cycle has no segments");
    if (!(fabs(c->profile.ripple) < 1) || !(c->profile.ripple_per_turn >= 0))
        return orr_diag_set(diag, ORR_E_ARG,
                            "a ripple of %g of the rate, %g times a turn: the first is less than 1, the "
                            "second not negative",
                            c->profile.ripple, c->profile.ripple_per_turn);
    for (size_t k = 0; k < c->profile.n; k++)
        if (!(c->profile.segment[k].duration_s > 0) || !isfinite(c->profile.segment[k].rate_radps))
            return orr_diag_set(diag, ORR_E_ARG, "segment %zu of a cycle lasts %g s; each is longer than 0",
                                k + 1, c->profile.segment[k].duration_s);
    return ORR_OK;
}

// --- Readings ---

// C_zt = I_alpha I I_chi (25), with the exact rotation for the mounting error or the literal first order (22).
static orr_mat3 attitude(const orr_stand *s, const orr_stand_cycle *c, double angle)
{
    const orr_mat3 chi = orr_mat3_rot2(c->start_rad + angle), nominal = orr_mat3_mul(&c->order, &chi);
    orr_mat3 alpha = orr_mat3_from_rotvec(c->mounting_rad);
    if (s->setup.literal_mounting) {
        const orr_mat3 unit = orr_mat3_identity(), hat = orr_mat3_hat(c->mounting_rad);
        alpha = orr_mat3_add(&unit, &hat);
    }
    return orr_mat3_mul(&alpha, &nominal);
}

// Rate, force of rest and the matrix of arms at an instant.
static void feel(const orr_stand *s, const orr_stand_cycle *c, const double turn[3], orr_stand_increment *out)
{
    const orr_mat3 C = attitude(s, c, turn[0]), Cx = orr_mat3_mul(&C, &s->C_tx);
    const orr_vec3 wt = orr_mat3_apply(&C, (orr_vec3){0, turn[1], 0}); // (24)
    const orr_vec3 dwt = orr_mat3_apply(&C, (orr_vec3){0, turn[2], 0});
    const orr_vec3 u = orr_mat3_apply(&Cx, s->u_radps); // (26)
    out->dtheta_rad = orr_vec3_add(wt, u);              // (23)
    out->rest_mps = orr_mat3_apply(&Cx, s->rest_mps2);
    const bool literal = s->setup.literal_forces;
    // In body axes the Earth's rate turns backwards with the stand: u' = -w_t x u.
    const orr_vec3 w = literal ? wt : out->dtheta_rad,
                   dw = literal ? dwt : orr_vec3_sub(dwt, orr_vec3_cross(wt, u));
    const orr_mat3 W = cross_matrix(w), WW = orr_mat3_mul(&W, &W), D = cross_matrix(dw);
    out->arm_ps = orr_mat3_add(&WW, &D);
    if (literal) return;
    const orr_mat3 Ct = orr_mat3_transpose(&Cx), GC = orr_mat3_mul(&s->gradient_ps2, &Ct),
                   G = orr_mat3_mul(&Cx, &GC), less = orr_mat3_scale(-1.0, &G);
    out->arm_ps = orr_mat3_add(&out->arm_ps, &less);
}

// Gauss-Legendre, 5 nodes on (0, 1).
static const double node[5] = {0.04691007703066800, 0.23076534494715845, 0.5, 0.76923465505284155,
                               0.95308992296933200};
static const double weight[5] = {0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                 0.23931433524968324, 0.11846344252809454};

orr_stand_increment orr_stand_integrate(const orr_stand *stand, const orr_stand_cycle *cycle, double from_s,
                                        double to_s)
{
    const orr_stand_profile *p = &cycle->profile;
    orr_stand_increment sum;
    memset(&sum, 0, sizeof sum);
    double begin, angle, rate, at = from_s;
    size_t k = segment_at(p, from_s + 1e-9 * (to_s - from_s), &begin, &angle, &rate);
    while (at < to_s) {
        const orr_stand_segment *g = &p->segment[k];
        const double end = begin + g->duration_s, to = k + 1 < p->n && end < to_s ? end : to_s;
        const double fastest = fmax(fabs(rate), fabs(g->rate_radps)) * (1 + fabs(p->ripple));
        const double bend = fastest * (to - at) * (1 + (fabs(p->ripple) > 0 ? p->ripple_per_turn : 0));
        const size_t pieces = 1 + (size_t)(bend / 0.2);
        const double h = (to - at) / (double)pieces;
        for (size_t i = 0; i < pieces; i++)
            for (int j = 0; j < 5; j++) {
                double turn[3];
                orr_stand_increment now;
                turn_in(p, k, at - begin + ((double)i + node[j]) * h, angle, rate, turn);
                feel(stand, cycle, turn, &now);
                sum.dtheta_rad = orr_vec3_axpy(weight[j] * h, now.dtheta_rad, sum.dtheta_rad);
                sum.rest_mps = orr_vec3_axpy(weight[j] * h, now.rest_mps, sum.rest_mps);
                const orr_mat3 part = orr_mat3_scale(weight[j] * h, &now.arm_ps);
                sum.arm_ps = orr_mat3_add(&sum.arm_ps, &part);
            }
        at = to;
        if (at < to_s) {
            angle += 0.5 * (rate + g->rate_radps) * g->duration_s;
            rate = g->rate_radps;
            begin = end;
            k++;
        }
    }
    return sum;
}

double orr_stand_force(const orr_stand_increment *a, int axis, orr_vec3 arm_m)
{
    const double rest = axis == 0 ? a->rest_mps.x : axis == 1 ? a->rest_mps.y : a->rest_mps.z;
    const double *row = a->arm_ps.m[axis];
    return rest + row[0] * arm_m.x + row[1] * arm_m.y + row[2] * arm_m.z;
}

void orr_stand_motion(const orr_stand *stand, const orr_stand_cycle *cycle, double t_s, orr_motion *out)
{
    double angle, rate, change;
    orr_stand_turn(&cycle->profile, t_s, &angle, &rate, &change);
    orr_stand exact = *stand;
    exact.setup.literal_mounting = false;
    const orr_mat3 C = attitude(&exact, cycle, angle), Cx = orr_mat3_mul(&C, &stand->C_tx),
                   A = orr_mat3_mul(&Cx, &stand->A_xe);
    const orr_vec3 w = orr_mat3_apply(&C, (orr_vec3){0, rate, 0}),
                   dw = orr_mat3_apply(&C, (orr_vec3){0, change, 0});
    const orr_vec3 r = cycle->outer_m, v = orr_vec3_cross(w, r),
                   a = orr_vec3_add(orr_vec3_cross(w, v), orr_vec3_cross(dw, r));
    *out = (orr_motion){.r_m = orr_vec3_add(stand->place_m, orr_mat3_apply_t(&A, r)),
                        .v_mps = orr_mat3_apply_t(&A, v),
                        .a_mps2 = orr_mat3_apply_t(&A, a),
                        .q_be = orr_quat_from_mat3(&A),
                        .w_radps = w,
                        .wdot_radps2 = dw};
}

// Bends of the profile at edges of the readings; the largest number of samples that divides all of them, for navigators.
static orr_status edges(const orr_stand_profile *p, double rate_hz, size_t *n, size_t *common, orr_diag *diag)
{
    double sum = 0;
    size_t before = 0;
    *common = 0;
    for (size_t k = 0; k < p->n; k++) {
        sum += p->segment[k].duration_s * rate_hz;
        const double whole = nearbyint(sum);
        if (!(fabs(sum - whole) < 1e-6) || !(whole < 5e7))
            return orr_diag_set(
                diag, ORR_E_ARG,
                "segment %zu of a cycle ends after %.9g samples of %g Hz; whole numbers are wanted, 50 "
                "million at most",
                k + 1, sum, rate_hz);
        size_t a = *common, b = (size_t)whole - before;
        while (b > 0) {
            const size_t rest = a % b;
            a = b;
            b = rest;
        }
        *common = a;
        before = (size_t)whole;
    }
    *n = before;
    return ORR_OK;
}

orr_status orr_stand_readings(const orr_stand *stand, const orr_stand_cycle *cycle, const orr_vec3 *inner_m,
                              orr_time t0, double rate_hz, orr_imu *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    size_t n = 0, common = 0;
    orr_status s = orr_stand_cycle_check(cycle, diag);
    if (s == ORR_OK && !(rate_hz > 0)) s = orr_diag_set(diag, ORR_E_ARG, "readings at %g Hz", rate_hz);
    if (s == ORR_OK) s = edges(&cycle->profile, rate_hz, &n, &common, diag);
    if (s == ORR_OK) s = orr_imu_allocate(out, n, 1, false, false, diag);
    if (s != ORR_OK) return s;
    out->t0 = t0;
    out->rate_hz = rate_hz;
    out->mode = (orr_imu_mode){.approach = 2, .quadrature = ORR_QUADRATURE_GAUSS, .order = 5};
    out->knot_step_s = (double)common / rate_hz;
    out->knot_degree = 3;
    for (size_t j = 0; j <= n; j++) {
        orr_motion m;
        orr_stand_motion(stand, cycle, (double)j / rate_hz, &m);
        out->r_m[j] = m.r_m;
        out->v_mps[j] = m.v_mps;
        out->q_be[j] = m.q_be;
        if (j == n) break;
        const orr_stand_increment a =
            orr_stand_integrate(stand, cycle, (double)j / rate_hz, (double)(j + 1) / rate_hz);
        double dv[3];
        for (int i = 0; i < 3; i++)
            dv[i] = orr_stand_force(
                &a, i, inner_m != NULL ? orr_vec3_add(cycle->outer_m, inner_m[i]) : cycle->outer_m);
        out->dtheta_rad[j] = a.dtheta_rad;
        out->dv_mps[j] = (orr_vec3){dv[0], dv[1], dv[2]};
    }
    orr_mat3 A;
    orr_imu_true_state(out, 0, &out->start_r_m, &out->start_v_mps, &A);
    out->start_q_bi = orr_quat_from_mat3(&A);
    return ORR_OK;
}
