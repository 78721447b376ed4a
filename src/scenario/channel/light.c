// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/channel/light.h"

#include <math.h>

#include "core/constants.h"

static const double EARTH_RADPS = ORR_EARTH_RATE_RADPS;

// R3 of an angle of 1e-5: its sine and cosine by two terms, exact to rounding.
typedef struct turn {
    double c, s;
} turn;

static turn turn_of(double angle)
{
    const double square = angle * angle;
    return (turn){1 - square / 2, angle * (1 - square / 6)};
}

static orr_vec3 turned(turn r, orr_vec3 v)
{
    return (orr_vec3){r.c * v.x + r.s * v.y, r.c * v.y - r.s * v.x, v.z};
}

void orr_light_close(double tau_s, orr_vec3 sat_m, orr_vec3 vel_mps, orr_vec3 r_m, orr_vec3 v_mps,
                     orr_light *out)
{
    const double c = ORR_LIGHT_MPS;
    const turn R = turn_of(EARTH_RADPS * tau_s);
    const orr_vec3 near = turned(R, sat_m), v = turned(R, vel_mps);
    const orr_vec3 inertial = {v.x - EARTH_RADPS * near.y, v.y + EARTH_RADPS * near.x, v.z};
    const orr_vec3 first = orr_vec3_sub(near, r_m);
    const double range = orr_vec3_norm(first);
    const double more_s = (range / c - tau_s) / (1 + orr_vec3_dot(first, inertial) / (range * c));
    // Seen from the antenna's axes, the satellite of a little earlier lies back along its inertial way.
    out->tau_s = tau_s + more_s;
    out->sat_m = orr_vec3_axpy(-more_s, inertial, near);
    const orr_vec3 d = orr_vec3_sub(out->sat_m, r_m);
    out->range_m = orr_vec3_norm(d);
    out->u = orr_vec3_scale(1 / out->range_m, d);
    out->sat_v_mps = inertial;
    out->range_rate_mps =
        orr_vec3_dot(out->u, orr_vec3_sub(v, v_mps)) / (1 + orr_vec3_dot(out->u, inertial) / c);
    const double tau_rate = out->range_rate_mps / c;
    const orr_vec3 d_rate = orr_vec3_axpy(-tau_rate, inertial, orr_vec3_sub(v, v_mps));
    out->u_rate_ps = orr_vec3_scale(1 / out->range_m, orr_vec3_axpy(-out->range_rate_mps, out->u, d_rate));
    // Without the rotation: the same two points in the axes of emission and of reception.
    const orr_vec3 straight = orr_vec3_sub(orr_vec3_axpy(-more_s, vel_mps, sat_m), r_m);
    out->distance_m = orr_vec3_norm(straight);
    out->distance_rate_mps =
        orr_vec3_dot(straight, orr_vec3_sub(orr_vec3_scale(1 - tau_rate, vel_mps), v_mps)) / out->distance_m;
}

double orr_light_shapiro_m(orr_vec3 antenna_m, orr_vec3 sat_m, double range_m)
{
    const double sum = orr_vec3_norm(antenna_m) + orr_vec3_norm(sat_m);
    return 2 * ORR_WGS84_GM / (ORR_LIGHT_MPS * ORR_LIGHT_MPS) * log((sum + range_m) / (sum - range_m));
}
