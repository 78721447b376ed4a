// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/study/auxiliary.h"

#include <math.h>
#include <string.h>

#include "core/nan.h"
#include "core/rng.h"
#include "inertial/study/auxiliary_private.h"

// Streams of draws: three an output.
enum { BARO, MAG_X, MAG_Y, MAG_Z, SPEED, HEADING, OUTPUTS, STREAM = 7000, STREAM_BASELINE = 7100 };

// One output's error as it goes from sample to sample.
typedef struct wander {
    const orr_aux_error *e;
    uint64_t seed, stream;
    double constant, walking, keep;
} wander;

static wander wander_of(const orr_aux_error *e, uint64_t seed, int output, double dt_s)
{
    wander w = {.e = e, .seed = seed, .stream = (uint64_t)(STREAM + 3 * output)};
    w.constant = e->bias + e->bias_sigma * orr_rng_normal(seed, w.stream, 0);
    w.walking = e->walking * orr_rng_normal(seed, w.stream, 1);
    w.keep = e->walking > 0.0 ? exp(-dt_s / e->correlation_s) : 0.0;
    return w;
}

static double error_at(wander *w, uint64_t k)
{
    if (k > 0)
        w->walking = w->keep * w->walking + w->e->walking * sqrt(1.0 - w->keep * w->keep) *
                                                orr_rng_normal(w->seed, w->stream + 1, k);
    return w->constant + w->walking + w->e->white * orr_rng_normal(w->seed, w->stream + 2, k);
}

#define SEA_HPA 1013.25
#define LAPSE 2.25577e-5 // 0.0065 K/m of 288.15 K
#define POWER 5.25588    // g M / (R 0.0065 K/m)

#define EARTH_M 6356766.0 // the atmosphere's own, for geopotential heights

double orr_aux_pressure_hpa(double height_m)
{
    return SEA_HPA * pow(1.0 - LAPSE * EARTH_M * height_m / (EARTH_M + height_m), POWER);
}

typedef struct work {
    const orr_aux_plan *plan;
    wander w[OUTPUTS];
    double dt_s, lagged_m, pulses_m, travelled_m, last_speed_mps;
    orr_aux_receiver_state receiver;
} work;

static void measure_height(work *w, const orr_geodetic *at, uint64_t k, orr_aux_sample *out)
{
    const orr_aux_barometer *b = w->plan->barometer;
    const double keep = b->lag_s > 0.0 ? exp(-w->dt_s / b->lag_s) : 0.0;
    w->lagged_m = k == 0 ? at->height_m : keep * w->lagged_m + (1.0 - keep) * at->height_m;
    out->true_height_m = at->height_m;
    out->height_m = w->lagged_m * (1.0 + b->scale) + error_at(&w->w[BARO], k);
    out->pressure_hpa = orr_aux_pressure_hpa(out->height_m);
}

// Year with its fraction, to the day that models of the field ask for.
static double year_of(orr_time t)
{
    return 1980.0 + (double)t * 1e-9 / (365.25 * 86400.0) + 5.0 / 365.25; // GPS time begins on January 6th
}

static void measure_field(work *w, const orr_motion *m, const orr_geodetic *at, uint64_t k,
                          orr_aux_sample *out)
{
    const orr_aux_magnetometer *g = w->plan->magnetometer;
    const double year = year_of(orr_time_add_s(w->plan->tr->t0, out->t_s));
    const orr_mat3 enu = orr_earth_enu_from_ecef(at->lat_rad, at->lon_rad), B = orr_mat3_from_quat(m->q_be);
    out->true_field_nt =
        orr_mat3_apply(&B, orr_mat3_apply_t(&enu, orr_magnetic_field_nt(g->model, year, *at)));
    const orr_vec3 noise =
        orr_vec3_make(error_at(&w->w[MAG_X], k), error_at(&w->w[MAG_Y], k), error_at(&w->w[MAG_Z], k));
    out->field_nt =
        orr_vec3_add(orr_vec3_add(out->true_field_nt, orr_mat3_apply(&g->soft, out->true_field_nt)),
                     orr_vec3_add(g->hard_nt, noise));
}

static void measure_speed(work *w, const orr_motion *m, uint64_t k, orr_aux_sample *out)
{
    const orr_aux_odometer *o = w->plan->odometer;
    const orr_mat3 B = orr_mat3_from_quat(m->q_be);
    out->true_speed_mps = orr_mat3_apply(&B, m->v_mps).y + orr_vec3_cross(m->w_radps, o->arm_m).y;
    out->speed_mps = out->true_speed_mps * (1.0 + o->scale) + error_at(&w->w[SPEED], k);
    if (k > 0) w->travelled_m += 0.5 * w->dt_s * (w->last_speed_mps + out->speed_mps);
    w->last_speed_mps = out->speed_mps;
    w->pulses_m =
        o->quantum_m > 0.0 ? o->quantum_m * floor(w->travelled_m / o->quantum_m + 0.5) : w->travelled_m;
    out->distance_m = w->pulses_m;
}

static double heading_of(orr_vec3 enu)
{
    const double a = atan2(enu.x, enu.y);
    return a < 0.0 ? a + 2.0 * ORR_PI : a;
}

static void measure_heading(work *w, const orr_motion *m, const orr_geodetic *at, uint64_t k,
                            orr_aux_sample *out)
{
    const orr_aux_antennas *a = w->plan->antennas;
    const orr_mat3 enu = orr_earth_enu_from_ecef(at->lat_rad, at->lon_rad), B = orr_mat3_from_quat(m->q_be);
    const orr_vec3 b = orr_mat3_apply(&enu, orr_mat3_apply_t(&B, a->baseline_m));
    const uint64_t seed = w->plan->seed;
    const orr_vec3 seen = orr_vec3_make(b.x + a->across_m * orr_rng_normal(seed, STREAM_BASELINE, k),
                                        b.y + a->across_m * orr_rng_normal(seed, STREAM_BASELINE + 1, k),
                                        b.z + a->up_m * orr_rng_normal(seed, STREAM_BASELINE + 2, k));
    out->true_heading_rad = heading_of(b);
    out->true_pitch_rad = atan2(b.z, hypot(b.x, b.y));
    out->heading_rad = remainder(heading_of(seen) + error_at(&w->w[HEADING], k), 2.0 * ORR_PI);
    if (out->heading_rad < 0.0) out->heading_rad += 2.0 * ORR_PI;
    out->pitch_rad = atan2(seen.z, hypot(seen.x, seen.y));
    out->heading_sigma_rad =
        hypot(a->across_m / hypot(b.x, b.y), hypot(a->heading_rad.white, a->heading_rad.walking));
}

static orr_aux_sample nothing(double t_s)
{
    const double n = ORR_NAN;
    const orr_vec3 none = {n, n, n};
    const orr_mat3 unknown = {{{n, n, n}, {n, n, n}, {n, n, n}}};
    return (orr_aux_sample){t_s, n, n, n, none, none, n,    n,    n,       n,      n,
                            n,   n, n, 0, none, none, none, none, unknown, unknown};
}

static bool positive(const orr_aux_error *e)
{
    return e->bias_sigma >= 0.0 && e->walking >= 0.0 && e->white >= 0.0 &&
           (e->walking == 0.0 || e->correlation_s > 0.0);
}

static orr_status check(const orr_aux_plan *p, orr_diag *diag)
{
    static const char *const what[] = {"barometer", "magnetometer", "odometer", "two-antenna heading"};
    const orr_aux_error *const e[] = {p->barometer != NULL ? &p->barometer->height_m : NULL,
                                      p->magnetometer != NULL ? &p->magnetometer->axis_nt : NULL,
                                      p->odometer != NULL ? &p->odometer->speed_mps : NULL,
                                      p->antennas != NULL ? &p->antennas->heading_rad : NULL};
    for (size_t k = 0; k < sizeof e / sizeof e[0]; k++)
        if (e[k] != NULL && !positive(e[k]))
            return orr_diag_set(diag, ORR_E_ARG,
                                "the %s has a negative standard deviation, or a process with a correlation "
                                "time that is not above 0",
                                what[k]);
    if (!(p->rate_hz > 0.0 && p->duration_s >= 0.0))
        return orr_diag_set(diag, ORR_E_ARG, "%g samples a second for %g s", p->rate_hz, p->duration_s);
    if (p->antennas != NULL && !(hypot(p->antennas->baseline_m.x, p->antennas->baseline_m.y) > 0.01))
        return orr_diag_set(diag, ORR_E_ARG,
                            "two antennas in one place, or one above the other, tell no heading");
    const orr_aux_receiver *r = p->receiver;
    if (r != NULL && !(r->range_m >= 0.0 && r->rate_mps >= 0.0 && r->range_walking_m >= 0.0 &&
                       (r->range_walking_m == 0.0 || r->range_correlation_s > 0.0) && p->sky != NULL))
        return orr_diag_set(
            diag, ORR_E_ARG,
            "the receiver has a negative standard deviation, a process with a correlation time that is not "
            "above 0, or no sky");
    return ORR_OK;
}

orr_status orr_auxiliary(const orr_aux_plan *p, orr_status (*sample)(void *user, const orr_aux_sample *s),
                         void *user, orr_diag *diag)
{
    static const orr_aux_error none = {0};
    orr_status s = check(p, diag);
    if (s != ORR_OK) return s;
    work w;
    memset(&w, 0, sizeof w);
    w.plan = p;
    w.dt_s = 1.0 / p->rate_hz;
    const orr_aux_error *mag = p->magnetometer != NULL ? &p->magnetometer->axis_nt : &none;
    const orr_aux_error *const of[OUTPUTS] = {p->barometer != NULL ? &p->barometer->height_m : &none,
                                              mag,
                                              mag,
                                              mag,
                                              p->odometer != NULL ? &p->odometer->speed_mps : &none,
                                              p->antennas != NULL ? &p->antennas->heading_rad : &none};
    for (int i = 0; i < OUTPUTS; i++) w.w[i] = wander_of(of[i], p->seed, i, w.dt_s);
    const uint64_t n = (uint64_t)floor(p->duration_s * p->rate_hz + 1e-6);
    for (uint64_t k = 0; k <= n && s == ORR_OK; k++) {
        orr_aux_sample out = nothing(p->begin_s + (double)k * w.dt_s);
        orr_motion m;
        s = orr_trajectory_evaluate(p->tr, out.t_s, &m, diag);
        if (s != ORR_OK) return s;
        const orr_geodetic at = orr_earth_from_ecef(m.r_m);
        if (p->barometer != NULL) measure_height(&w, &at, k, &out);
        if (p->magnetometer != NULL) measure_field(&w, &m, &at, k, &out);
        if (p->odometer != NULL) measure_speed(&w, &m, k, &out);
        if (p->antennas != NULL) measure_heading(&w, &m, &at, k, &out);
        if (p->receiver != NULL) orr_aux_receive(p, &m, k, &w.receiver, &out);
        s = sample(user, &out);
    }
    return s;
}
