// SPDX-License-Identifier: GPL-3.0-or-later
// Yaw, pitch and roll with their derivatives as attitude and body rates.
#include <math.h>
#include <string.h>

#include "core/earth.h"
#include "src/service/dialect/dialect.h"

// Body rates at s seconds: those of yaw, pitch and roll, in axes right, forward, up.
static orr_vec3 rate_at(double angle[4][3], double s)
{
    double a[3], r[3];
    for (int k = 0; k < 3; k++) {
        a[k] = angle[0][k] + s * (angle[1][k] + s / 2 * (angle[2][k] + s / 3 * angle[3][k]));
        r[k] = angle[1][k] + s * (angle[2][k] + s / 2 * angle[3][k]);
    }
    const double p = r[2] - r[0] * sin(a[1]), q = r[1] * cos(a[2]) + r[0] * sin(a[2]) * cos(a[1]),
                 down = -r[1] * sin(a[2]) + r[0] * cos(a[2]) * cos(a[1]);
    return (orr_vec3){q, p, -down};
}

static void put(double to[3], orr_vec3 v)
{
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
}

void orr_dialect_turn(double angle[4][3], int order, orr_msg_motion *m)
{
    const double h = 1e-3;
    const orr_geodetic place = orr_earth_from_ecef((orr_vec3){m->pos_m[0], m->pos_m[1], m->pos_m[2]});
    const orr_mat3 enu = orr_earth_enu_from_ecef(place.lat_rad, place.lon_rad),
                   own = orr_body_from_enu((orr_angles){angle[0][0], angle[0][1], angle[0][2]}),
                   body = orr_mat3_mul(&own, &enu);
    const orr_quat q = orr_quat_from_mat3(&body);
    const orr_vec3 w = rate_at(angle, 0), before = rate_at(angle, -h), after = rate_at(angle, h);
    const double attitude[4] = {q.w, q.x, q.y, q.z};
    memcpy(m->attitude, attitude, sizeof attitude);
    put(m->rate_radps, w);
    put(m->rate2_radps2, orr_vec3_scale(0.5 / h, orr_vec3_sub(after, before)));
    put(m->rate3_radps3,
        orr_vec3_scale(1 / h / h, orr_vec3_sub(orr_vec3_add(after, before), orr_vec3_scale(2, w))));
    m->angular_order = (uint8_t)(1 + order);
}
