// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/channel/light.h"

#include <math.h>

#include "core/constants.h"

// State at emission, tau before t. The product is asked once, at the nearest whole nanosecond of the first estimate; from there
// less than a microsecond is left, which two derivatives carry to 1e-18 m.
static void carry(const orr_sat_state *from, double dt_s, orr_sat_state *out)
{
    *out = *from;
    out->pos_m =
        orr_vec3_axpy(dt_s * dt_s / 2, from->acc_mps2, orr_vec3_axpy(dt_s, from->vel_mps, from->pos_m));
    out->vel_mps = orr_vec3_axpy(dt_s, from->acc_mps2, from->vel_mps);
    out->clock_s += dt_s * from->clock_rate_sps;
}

orr_status orr_light_from(const orr_ephemeris *e, orr_time t, const orr_sat_state *reception, orr_vec3 r_m,
                          orr_vec3 v_mps, orr_light *out)
{
    const double w = ORR_EARTH_RATE_RADPS, c = ORR_LIGHT_MPS;
    double tau = orr_vec3_norm(orr_vec3_sub(reception->pos_m, r_m)) / c;
    const int64_t before_ns = llround(tau * 1e9);
    orr_sat_state near;
    const orr_status status = orr_ephemeris_eval(e, reception->sat, orr_time_add(t, -before_ns), &near);
    if (status != ORR_OK) return status;
    orr_vec3 d = {0, 0, 0};
    for (int step = 0; step < 3; step++) {
        carry(&near, (double)before_ns * 1e-9 - tau, &out->emission);
        const orr_mat3 R = orr_mat3_rot3(w * tau);
        out->sat_m = orr_mat3_apply(&R, out->emission.pos_m);
        d = orr_vec3_sub(out->sat_m, r_m);
        out->range_m = orr_vec3_norm(d);
        tau = out->range_m / c;
    }
    out->tau_s = tau;
    out->u = orr_vec3_scale(1 / out->range_m, d);
    const orr_mat3 R = orr_mat3_rot3(w * tau);
    const orr_vec3 earth = {0, 0, w}, v = orr_mat3_apply(&R, out->emission.vel_mps);
    out->sat_v_mps = orr_vec3_add(v, orr_vec3_cross(earth, out->sat_m));
    out->range_rate_mps =
        orr_vec3_dot(out->u, orr_vec3_sub(v, v_mps)) / (1 + orr_vec3_dot(out->u, out->sat_v_mps) / c);
    // Without the rotation: the same two points in the axes of emission and of reception.
    const orr_vec3 straight = orr_vec3_sub(out->emission.pos_m, r_m);
    const double tau_rate = out->range_rate_mps / c;
    out->distance_m = orr_vec3_norm(straight);
    out->distance_rate_mps =
        orr_vec3_dot(straight, orr_vec3_sub(orr_vec3_scale(1 - tau_rate, out->emission.vel_mps), v_mps)) /
        out->distance_m;
    return ORR_OK;
}

double orr_light_shapiro_m(orr_vec3 antenna_m, orr_vec3 sat_m, double range_m)
{
    const double sum = orr_vec3_norm(antenna_m) + orr_vec3_norm(sat_m);
    return 2 * ORR_WGS84_GM / (ORR_LIGHT_MPS * ORR_LIGHT_MPS) * log((sum + range_m) / (sum - range_m));
}
