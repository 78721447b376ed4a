// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/study/vibration_motion.h"

#include <stdlib.h>
#include <string.h>

double orr_vibration_drift(const orr_vibration *v)
{
    const double s = sin(0.5 * v->amplitude_rad);
    return -4.0 * ORR_PI * v->frequency_hz * s * s;
}

// R3(-a) R1(beta) R3(a) turns by beta about the axis (cos a, sin a, 0).
orr_quat orr_vibration_attitude(const orr_vibration *v, double t_s)
{
    const double a = 2.0 * ORR_PI * v->frequency_hz * (t_s - v->start_s);
    return orr_quat_from_rotvec((orr_vec3){v->amplitude_rad * cos(a), v->amplitude_rad * sin(a), 0.0});
}

void orr_vibration_rate(const orr_vibration *v, double t_s, orr_vec3 *rate_radps, orr_vec3 *change_radps2)
{
    const double w = 2.0 * ORR_PI * v->frequency_hz, a = w * (t_s - v->start_s), b = sin(v->amplitude_rad);
    *rate_radps = (orr_vec3){-w * b * sin(a), w * b * cos(a), orr_vibration_drift(v)};
    *change_radps2 = (orr_vec3){-w * w * b * cos(a), -w * w * b * sin(a), 0.0};
}

typedef struct standing {
    orr_vibration vibration;
    orr_vec3 r_m;
    orr_quat q_xe; // axes at rest from ecef
} standing;

static void evaluate(const void *self, double t_s, orr_motion *out)
{
    const standing *s = self;
    *out = (orr_motion){.r_m = s->r_m,
                        .q_be = orr_quat_mul(s->q_xe, orr_vibration_attitude(&s->vibration, t_s))};
    orr_vibration_rate(&s->vibration, t_s, &out->w_radps, &out->wdot_radps2);
}

orr_status orr_trajectory_vibrating(orr_time t0, double begin_s, double end_s, orr_geodetic place,
                                    orr_angles attitude, const orr_vibration *v, orr_trajectory *out,
                                    orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    if (!(v->frequency_hz >= 0) || !(fabs(v->amplitude_rad) < ORR_PI))
        return orr_diag_set(
            diag, ORR_E_ARG,
            "a vibration of %g Hz and %g rad: the frequency is not negative and the amplitude "
            "less than half a turn",
            v->frequency_hz, v->amplitude_rad);
    standing *s = malloc(sizeof *s);
    if (s == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a vibrating body");
    const orr_mat3 E = orr_earth_enu_from_ecef(place.lat_rad, place.lon_rad), L = orr_body_from_enu(attitude);
    const orr_mat3 A = orr_mat3_mul(&L, &E);
    *s = (standing){*v, orr_earth_to_ecef(place), orr_quat_from_mat3(&A)};
    *out = (orr_trajectory){
        .t0 = t0, .begin_s = begin_s, .end_s = end_s, .evaluate = evaluate, .destroy = free, .self = s};
    return ORR_OK;
}
