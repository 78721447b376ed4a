// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/motion/drape.h"

#include <math.h>

#include "inertial/motion/local_map.h"

typedef struct terrain {
    orr_local_map map;
    const orr_drape_wave *wave;
    size_t n;
} terrain;

// Height over a place of the map, and its slope towards East and North.
static double height_at(const terrain *t, orr_vec3 at, double *east, double *north)
{
    double sum = 0;
    *east = *north = 0;
    for (size_t k = 0; k < t->n; k++) {
        const orr_drape_wave *w = &t->wave[k];
        const double s = sin(w->azimuth_rad), c = cos(w->azimuth_rad), rate = 2 * ORR_PI / w->wavelength_m;
        const double a = rate * (s * at.x + c * at.y) + w->phase_rad;
        sum += w->amplitude_m * sin(a);
        *east += w->amplitude_m * rate * s * cos(a);
        *north += w->amplitude_m * rate * c * cos(a);
    }
    return sum;
}

static void raise(void *user, double t_s, orr_motion *m)
{
    const terrain *t = user;
    double east, north;
    (void)t_s;
    const orr_vec3 v = orr_motion_velocity_enu(m), at = orr_local_map_from_ecef(&t->map, m->r_m);
    const double height = height_at(t, at, &east, &north);
    const double climb = atan2(east * v.x + north * v.y, hypot(v.x, v.y));
    m->r_m = orr_vec3_axpy(height, orr_earth_up(m->r_m), m->r_m);
    m->q_be = orr_quat_mul(m->q_be, orr_quat_from_rotvec((orr_vec3){climb, 0, 0}));
}

orr_status orr_trajectory_drape(const orr_trajectory *in, orr_geodetic origin, const orr_drape_wave *wave,
                                size_t n, double step_s, orr_trajectory *out, double *vertical_mps2,
                                orr_diag *diag)
{
    if (n == 0 || n > ORR_DRAPE_MAX_WAVES)
        return orr_diag_set(diag, ORR_E_ARG, "%zu waves of a drape; 1 to %d can be", n, ORR_DRAPE_MAX_WAVES);
    for (size_t k = 0; k < n; k++)
        if (!(wave[k].wavelength_m > 0))
            return orr_diag_set(diag, ORR_E_ARG, "wave %zu of a drape is %g m long; it is more than 0", k + 1,
                                wave[k].wavelength_m);
    terrain t = {orr_local_map_make(origin), wave, n};
    const orr_status s = orr_trajectory_resample(in, step_s, raise, &t, out, diag);
    if (s != ORR_OK || vertical_mps2 == NULL) return s;
    vertical_mps2[0] = vertical_mps2[1] = 0;
    for (double at = out->begin_s; at < out->end_s; at += step_s) {
        orr_motion m;
        out->evaluate(out->self, at, &m);
        const double up = orr_vec3_dot(m.a_mps2, orr_earth_up(m.r_m));
        vertical_mps2[0] = fmin(vertical_mps2[0], up);
        vertical_mps2[1] = fmax(vertical_mps2[1], up);
    }
    return ORR_OK;
}
