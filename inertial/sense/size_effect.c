// SPDX-License-Identifier: GPL-3.0-or-later
// An accelerometer at r from the unit's point feels w' x r + w x (w x r) more. Integrals over a step follow from the increments
// of the gyros: w at edges by the cubic through the sums of four steps, w w' within a step by w linear about its mean.
#include <math.h>

#include "inertial/sense/measured_private.h"

bool orr_size_effect_any(const orr_triad_errors *accel)
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            if (accel->arm_m[i][k] != 0.0) return true;
    return false;
}

// The rate at edge j (0..n). Beyond the run it goes on as in its first or last step.
static orr_vec3 rate_at(const orr_imu *m, size_t j)
{
    const size_t last = m->n - 1;
    const orr_vec3 a = m->dtheta_rad[j >= 2 ? j - 2 : 0], b = m->dtheta_rad[j >= 1 ? j - 1 : 0],
                   c = m->dtheta_rad[j < last ? j : last], d = m->dtheta_rad[j + 1 < last ? j + 1 : last];
    const orr_vec3 near = orr_vec3_add(b, c), far = orr_vec3_add(a, d);
    return orr_vec3_scale(m->rate_hz / 12.0, orr_vec3_sub(orr_vec3_scale(7.0, near), far));
}

void orr_size_effect(const orr_triad_errors *accel, const orr_imu *m, size_t j, double add[3])
{
    const double dt = 1.0 / m->rate_hz;
    const orr_vec3 w = orr_vec3_scale(m->rate_hz, m->dtheta_rad[j]);
    const orr_vec3 turn = orr_vec3_sub(rate_at(m, j + 1), rate_at(m, j));
    for (int i = 0; i < 3; i++) {
        const orr_vec3 r = orr_vec3_make(accel->arm_m[i][0], accel->arm_m[i][1], accel->arm_m[i][2]);
        // Mean of w x (w x r) where w runs from w - turn / 2 to w + turn / 2.
        orr_vec3 inward = orr_vec3_cross(w, orr_vec3_cross(w, r));
        inward = orr_vec3_axpy(1.0 / 12.0, orr_vec3_cross(turn, orr_vec3_cross(turn, r)), inward);
        const orr_vec3 a = orr_vec3_axpy(dt, inward, orr_vec3_cross(turn, r));
        add[i] = i == 0 ? a.x : i == 1 ? a.y : a.z;
    }
}
