// SPDX-License-Identifier: GPL-3.0-or-later
#include <math.h>
#include <string.h>

#include "core/linalg.h"
#include "core/nan.h"
#include "core/rng.h"
#include "inertial/study/auxiliary_private.h"

enum { UNKNOWNS = 4, STREAM_RANGE = 7200, STREAM_RATE, STREAM_WALK };

size_t orr_aux_nominal_sky(void *user, orr_time t, orr_vec3 *r_m, int *number)
{
    enum { PLANES = 3, SLOTS = 8 };
    (void)user;
    const double a = 29600.318e3, incl = 56.0 * ORR_RAD_PER_DEG, rate = sqrt(3.986004418e14 / (a * a * a));
    const double s =
        (double)(t % INT64_C(86164000000000)) * 1e-9; // of a sidereal day, which is two revolutions
    for (int plane = 0; plane < PLANES; plane++)
        for (int slot = 0; slot < SLOTS; slot++) {
            const double u =
                rate * s + 2.0 * ORR_PI * ((double)slot / SLOTS + (double)plane / (PLANES * SLOTS));
            const double node = 2.0 * ORR_PI * (double)plane / PLANES - ORR_EARTH_RATE_RADPS * s;
            const int k = plane * SLOTS + slot;
            r_m[k] = orr_vec3_make(a * (cos(u) * cos(node) - sin(u) * cos(incl) * sin(node)),
                                   a * (cos(u) * sin(node) + sin(u) * cos(incl) * cos(node)),
                                   a * sin(u) * sin(incl));
            number[k] = k;
        }
    return PLANES * SLOTS;
}

// The sight of one satellite.
typedef struct sight {
    double h[UNKNOWNS]; // minus the direction East, North, Up; 1 for the clock
    double over_sine;   // standard deviation over that in the zenith
    int number;
} sight;

static size_t look(const orr_aux_plan *plan, orr_time t, orr_vec3 at, const orr_mat3 *enu,
                   sight out[ORR_AUX_SATELLITES])
{
    orr_vec3 r[ORR_AUX_SATELLITES];
    int number[ORR_AUX_SATELLITES];
    const size_t n = plan->sky(plan->sky_user, t, r, number);
    size_t seen = 0;
    for (size_t k = 0; k < n && k < ORR_AUX_SATELLITES; k++) {
        const orr_vec3 e = orr_mat3_apply(enu, orr_vec3_unit(orr_vec3_sub(r[k], at)));
        if (!(e.z > sin(plan->receiver->mask_rad)) || number[k] < 0 || number[k] >= ORR_AUX_SATELLITES)
            continue;
        out[seen++] = (sight){{-e.x, -e.y, -e.z, 1.0}, 1.0 / fmax(e.z, 0.05), number[k]};
    }
    return seen;
}

// Weighted least squares of the errors in z, all satellites with variances in their ratio: what comes out, and its covariance.
static bool solve(const sight *s, size_t n, double sigma, const double *z, orr_vec3 *error,
                  orr_mat3 *covariance)
{
    double a[UNKNOWNS * UNKNOWNS] = {0}, b[UNKNOWNS] = {0};
    for (size_t k = 0; k < n; k++) {
        const double w = 1.0 / (s[k].over_sine * s[k].over_sine);
        for (int i = 0; i < UNKNOWNS; i++) {
            b[i] += w * s[k].h[i] * z[k];
            for (int j = 0; j < UNKNOWNS; j++) a[UNKNOWNS * i + j] += w * s[k].h[i] * s[k].h[j];
        }
    }
    if (n < UNKNOWNS || orr_cholesky_factor(a, UNKNOWNS, 1e-9) != ORR_OK ||
        orr_cholesky_solve(a, UNKNOWNS, b) != ORR_OK || orr_cholesky_invert(a, UNKNOWNS) != ORR_OK)
        return false;
    *error = orr_vec3_make(b[0], b[1], b[2]);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) covariance->m[i][j] = sigma * sigma * a[UNKNOWNS * i + j];
    return true;
}

// The process of a satellite's range, exact over any time since it was last seen.
static double walked(const orr_aux_plan *plan, orr_aux_receiver_state *state, int number, double t_s,
                     uint64_t k)
{
    const orr_aux_receiver *r = plan->receiver;
    if (!(r->range_walking_m > 0.0)) return 0.0;
    const double draw = orr_rng_normal(plan->seed, STREAM_WALK, k * ORR_AUX_SATELLITES + (uint64_t)number);
    const double keep =
        state->known[number] ? exp(-(t_s - state->at_s[number]) / r->range_correlation_s) : 0.0;
    state->walking[number] =
        keep * state->walking[number] + r->range_walking_m * sqrt(1.0 - keep * keep) * draw;
    state->known[number] = true;
    state->at_s[number] = t_s;
    return state->walking[number];
}

void orr_aux_receive(const orr_aux_plan *plan, const orr_motion *m, uint64_t k, orr_aux_receiver_state *state,
                     orr_aux_sample *out)
{
    const orr_aux_receiver *r = plan->receiver;
    const orr_mat3 B = orr_mat3_from_quat(m->q_be);
    const orr_vec3 at = orr_vec3_add(m->r_m, orr_mat3_apply_t(&B, r->arm_m));
    const orr_vec3 speed = orr_vec3_add(m->v_mps, orr_mat3_apply_t(&B, orr_vec3_cross(m->w_radps, r->arm_m)));
    const orr_geodetic place = orr_earth_from_ecef(at);
    const orr_mat3 enu = orr_earth_enu_from_ecef(place.lat_rad, place.lon_rad);
    sight s[ORR_AUX_SATELLITES];
    double range[ORR_AUX_SATELLITES], rate[ORR_AUX_SATELLITES];
    out->satellites = look(plan, orr_time_add_s(plan->tr->t0, out->t_s), at, &enu, s);
    for (size_t i = 0; i < out->satellites; i++) {
        const uint64_t draw = k * ORR_AUX_SATELLITES + (uint64_t)s[i].number;
        range[i] = s[i].over_sine * (r->range_m * orr_rng_normal(plan->seed, STREAM_RANGE, draw) +
                                     walked(plan, state, s[i].number, out->t_s, k));
        rate[i] = s[i].over_sine * r->rate_mps * orr_rng_normal(plan->seed, STREAM_RATE, draw);
    }
    if (!solve(s, out->satellites, hypot(r->range_m, r->range_walking_m), range, &out->position_error_m,
               &out->position_covariance) ||
        !solve(s, out->satellites, r->rate_mps, rate, &out->velocity_error_mps, &out->velocity_covariance))
        return;
    out->position_m = orr_vec3_add(at, orr_mat3_apply_t(&enu, out->position_error_m));
    out->velocity_mps = orr_vec3_add(speed, orr_mat3_apply_t(&enu, out->velocity_error_mps));
}
