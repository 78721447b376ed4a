// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/echo.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/angle.h"
#include "core/constants.h"
#include "core/interval.h"
#include "src/scenario/effect/mover.h"
#include "src/scenario/effect/reflection.h"

typedef struct reflector {
    bool has_sats;
    orr_sat_set sats;
    orr_interval there;
    double phase_cycles, power_db;
    bool in_space;
    double delay_m, delay_mps; // at its begin, of others
    orr_mover place;           // of one in space
} reflector;

struct orr_echoes {
    bool has_ground;
    orr_scenario_ground ground;
    size_t n_pattern;
    orr_scenario_gain *pattern;
    size_t n;
    reflector item[ORR_MAX_ECHOES];
};

static orr_status refuse(const orr_scenario *s, size_t k, const char *key, const char *why, orr_diag *diag)
{
    char path[60];
    snprintf(path, sizeof path, "multipath.reflectors[%zu].%s", k, key);
    return orr_marks_blame(&s->marks, ORR_E_FORMAT, path, why, diag);
}

static orr_status prepare(const orr_scenario *s, size_t k, orr_span span, reflector *out, orr_diag *diag)
{
    const orr_scenario_reflector *x = &s->multipath.reflectors.item[k];
    *out = (reflector){.has_sats = x->has_sats,
                       .sats = x->sats,
                       .there = {x->has_from ? x->from : span.from, x->has_to ? x->to : span.to + 1},
                       .phase_cycles = x->phase_deg / 360,
                       .power_db = x->power_db,
                       .delay_m = x->delay_m,
                       .delay_mps = -x->doppler_hz * ORR_LIGHT_MPS / ORR_L1_HZ,
                       .in_space = x->position.n > 0};
    if (out->there.from > span.to || out->there.to <= span.from)
        return refuse(s, k, x->has_to && out->there.to <= span.from ? "to" : "from",
                      "it is not there in the time of the channels", diag);
    if (!out->in_space) {
        const orr_time end = out->there.to < span.to ? out->there.to : span.to;
        if (out->delay_m + out->delay_mps * orr_time_diff_s(end, out->there.from) < 0)
            return refuse(s, k, "doppler",
                          "the echo would overtake its signal: end it (to) before its delay is 0", diag);
        return ORR_OK;
    }
    out->place = orr_mover_of(&x->position, &x->velocity_mps, out->there.from);
    return ORR_OK;
}

orr_status orr_echoes_open(const orr_scenario *s, orr_span span, orr_echoes **out, orr_diag *diag)
{
    const orr_scenario_multipath *m = &s->multipath;
    *out = NULL;
    if (!m->has_ground && m->reflectors.n == 0) return ORR_OK;
    orr_echoes *e = calloc(1, sizeof *e);
    if (e == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    e->has_ground = m->has_ground;
    e->ground = m->ground;
    e->n_pattern = m->pattern.n;
    e->pattern = calloc(m->pattern.n + 1, sizeof *e->pattern);
    orr_status status = e->pattern != NULL ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (status == ORR_OK && m->pattern.n > 0)
        memcpy(e->pattern, m->pattern.item, m->pattern.n * sizeof *e->pattern);
    for (size_t k = 0; status == ORR_OK && k < m->reflectors.n; k++) {
        status = prepare(s, k, span, &e->item[k], diag);
        if (status == ORR_OK) e->n = k + 1;
    }
    if (status == ORR_OK)
        *out = e;
    else
        orr_echoes_close(e);
    return status;
}

void orr_echoes_close(orr_echoes *e)
{
    if (e == NULL) return;
    free(e->pattern);
    free(e);
}

size_t orr_echoes_max(const orr_echoes *e) { return e == NULL ? 0 : e->n + (e->has_ground ? 1 : 0); }

static double elevation_deg(orr_vec3 axis, orr_vec3 u)
{
    return asin(fmin(fmax(orr_vec3_dot(u, axis), -1), 1)) * ORR_DEG_PER_RAD;
}

// The ground's: 2 h sin(elevation) behind the signal.
static bool ground_echo(const orr_echoes *e, const orr_echo_ray *ray, orr_echo *out)
{
    const orr_antenna_state *at = ray->at;
    const orr_vec3 up = {at->enu.m[2][0], at->enu.m[2][1], at->enu.m[2][2]};
    const bool level = e->ground.has_level;
    const double h = level ? orr_earth_from_ecef(at->r_m).height_m - e->ground.level_m : e->ground.height_m;
    const double h_rate = level ? orr_vec3_dot(at->v_mps, up) : 0;
    const double s = orr_vec3_dot(ray->u, up),
                 s_rate = orr_vec3_dot(ray->u_rate_ps, up) +
                          orr_vec3_dot(ray->u, orr_vec3_cross(at->enu_radps, up));
    if (!(s > 0) || !(h > 0)) return false;
    out->number = 1;
    out->delay_m = 2 * h * s;
    out->delay_mps = 2 * (h * s_rate + h_rate * s);
    double direct_deg = 0, reflected_deg = 0;
    if (e->n_pattern > 0) {
        const orr_vec3 down = orr_vec3_axpy(-2 * s, up, ray->u), // the ray's mirror image
            own = {at->axes.m[2][0], at->axes.m[2][1], at->axes.m[2][2]};
        direct_deg = elevation_deg(own, ray->u);
        reflected_deg = elevation_deg(own, down);
    }
    double complex slope;
    const double complex medium =
                             orr_medium(e->ground.permittivity, e->ground.conductivity_spm, ray->carrier_hz),
                         ratio = orr_reflected(medium, s, e->pattern, e->n_pattern, direct_deg, reflected_deg,
                                               &slope);
    const double square = creal(ratio) * creal(ratio) + cimag(ratio) * cimag(ratio);
    // Near -1 at low elevations, and never near 1: half a cycle is taken out before an angle is.
    out->phase_cycles = 0.5 - orr_atan2(-cimag(ratio), -creal(ratio)) / (2 * ORR_PI);
    out->phase_rate_hz = -(creal(ratio) * cimag(slope) - cimag(ratio) * creal(slope)) / fmax(square, 1e-20) *
                         s_rate / (2 * ORR_PI);
    out->power_db = 10 / log(10) * log(fmax(square, 1e-20));
    return true;
}

static void reflector_echo(const reflector *x, const orr_echo_ray *ray, orr_echo *out)
{
    const double since_s = orr_time_diff_s(ray->t, x->there.from);
    out->phase_cycles = x->phase_cycles;
    out->phase_rate_hz = 0;
    out->power_db = x->power_db;
    if (!x->in_space) {
        out->delay_m = x->delay_m + x->delay_mps * since_s;
        out->delay_mps = x->delay_mps;
        return;
    }
    // A plane wave reaches the reflector u.p earlier than the antenna, and goes the distance |p| on.
    const orr_vec3 p = orr_vec3_sub(orr_mover_at(&x->place, ray->t), ray->at->r_m),
                   p_rate = orr_vec3_sub(x->place.v_mps, ray->at->v_mps);
    out->delay_m = orr_vec3_norm(p) - orr_vec3_dot(ray->u, p);
    out->delay_mps = orr_vec3_dot(orr_vec3_unit(p), p_rate) - orr_vec3_dot(ray->u, p_rate) -
                     orr_vec3_dot(ray->u_rate_ps, p);
}

size_t orr_echoes_at(const orr_echoes *e, const orr_echo_ray *ray, orr_echo out[ORR_MAX_ECHOES])
{
    size_t n = 0;
    if (e == NULL) return 0;
    const size_t before = e->has_ground ? 1 : 0;
    if (e->has_ground && ground_echo(e, ray, &out[n])) n++;
    for (size_t k = 0; k < e->n; k++) {
        const reflector *x = &e->item[k];
        if (!orr_interval_holds(x->there, ray->as_of) ||
            (x->has_sats && !orr_sat_set_has(&x->sats, ray->sat)))
            continue;
        out[n].number = (uint16_t)(before + k + 1);
        reflector_echo(x, ray, &out[n++]);
    }
    return n;
}

bool orr_echoes_change(const orr_echoes *e, orr_time after, orr_time until)
{
    for (size_t k = 0; e != NULL && k < e->n; k++)
        if (orr_interval_turns(e->item[k].there, after, until)) return true;
    return false;
}

// Greatest fourth derivative of a way past a point: 9 v^4/d^3.
static double bends(const reflector *x, const orr_antenna *antenna, orr_time from, orr_time to)
{
    double nearest_m = (double)INFINITY, fastest_mps = 0;
    for (int k = 0; k <= 10; k++) {
        orr_antenna_state at;
        const orr_time t = from + (to - from) / 10 * k;
        if (orr_antenna_at(antenna, t, &at) != ORR_ANSWER_OK) continue;
        const orr_vec3 r = orr_mover_at(&x->place, t);
        const double v = orr_vec3_norm(orr_vec3_sub(x->place.v_mps, at.v_mps)),
                     d = orr_vec3_norm(orr_vec3_sub(r, at.r_m));
        // Between two of these instants it may come nearer by half of what it moves meanwhile.
        nearest_m = fmin(nearest_m, d - v * orr_time_diff_s(to, from) / 20);
        fastest_mps = fmax(fastest_mps, v);
    }
    return 9 * pow(fastest_mps, 4) / pow(fmax(nearest_m, 1), 3);
}

bool orr_echoes_allow(const orr_echoes *e, const orr_antenna *antenna, orr_time from, orr_time to,
                      int64_t length_ns, double error_m)
{
    for (size_t k = 0; e != NULL && k < e->n; k++) {
        const reflector *x = &e->item[k];
        if (x->there.to <= from || to <= x->there.from) continue;
        if (!orr_interval_fits(x->there, (orr_interval){from, to}, length_ns)) return false;
        const double T = (double)length_ns / 1e9;
        if (x->in_space && pow(T, 4) / 384 * bends(x, antenna, from, to) > error_m) return false;
    }
    return true;
}
