// SPDX-License-Identifier: GPL-3.0-or-later
// Motion of a receiver in space: a satellite of an orbit product, or elements that are carried on by gravitation (EGM96 to degree
// 21, Sun, Moon; no air, no sunlight). The body looks at the Earth: up is away from its centre, forward where it flies.
#include <math.h>
#include <stdlib.h>

#include "core/astro.h"
#include "orbit/ephemeris/ephemeris.h"
#include "orbit/force/integrate.h"
#include "orbit/force/kepler.h"
#include "src/make/moving_private.h"

// A quintic spline with such knots, through places half as far apart, is 1e-8 m off the lowest orbits.
static const double KNOT_S = 10, STEP_S = 5;
// Places beyond the ends, with which a spline is as good there as in the middle.
enum { BEYOND = 12 };
static const double LONGEST_S = 31 * 86400.0;

// Places on the way, STEP_S apart.
typedef struct way {
    size_t n;
    double *t_s;
    orr_vec3 *r_m;
    orr_quat *q_be;
} way;

static void way_free(way *w)
{
    free(w->t_s);
    free(w->r_m);
    free(w->q_be);
}

static orr_status way_for(double duration_s, way *w, orr_diag *diag)
{
    const size_t most = (size_t)ceil(duration_s / STEP_S) + 1 + 2 * BEYOND;
    *w = (way){.t_s = calloc(most, sizeof *w->t_s),
               .r_m = calloc(most, sizeof *w->r_m),
               .q_be = calloc(most, sizeof *w->q_be)};
    if (w->t_s != NULL && w->r_m != NULL && w->q_be != NULL) return ORR_OK;
    way_free(w);
    return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
}

static void way_add(way *w, double t_s, orr_vec3 r_m, orr_vec3 v_mps)
{
    const orr_vec3 up = orr_vec3_unit(r_m), v = orr_velocity_inertial(r_m, v_mps),
                   right = orr_vec3_unit(orr_vec3_cross(v, up)), forward = orr_vec3_cross(up, right);
    const orr_mat3 body = {
        {{right.x, right.y, right.z}, {forward.x, forward.y, forward.z}, {up.x, up.y, up.z}}};
    w->t_s[w->n] = t_s;
    w->r_m[w->n] = r_m;
    w->q_be[w->n++] = orr_quat_from_mat3(&body);
}

static orr_status through(const way *w, orr_time start, double duration_s, orr_trajectory *out,
                          orr_diag *diag)
{
    const orr_spline_samples samples = {w->n, w->t_s, w->r_m, w->n, w->t_s, w->q_be};
    const orr_spline_plan plan = {.degree = 5, .knot_step_s = KNOT_S};
    return orr_trajectory_from_samples(start, 0, duration_s, &samples, plan, plan, out, NULL, diag);
}

// The arc of a product that holds t, or the first one.
static bool arc_about(const orr_ephemeris *e, orr_sat sat, const orr_time *t, orr_time *from, orr_time *to)
{
    for (size_t k = 0; orr_ephemeris_arc(e, sat, k, from, to); k++)
        if (t == NULL || (*t >= *from && *t <= *to)) return true;
    return false;
}

static orr_status of_product(const orr_scenario_trajectory *m, const orr_ephemeris *e, orr_trajectory *out,
                             orr_diag *diag)
{
    char name[ORR_TIME_TEXT];
    orr_time from, to;
    const orr_sat sat = orr_sat_parse(m->sat);
    if (sat == ORR_SAT_NONE)
        return orr_diag_set(diag, ORR_E_ARG, "trajectory.sat: '%s' is no satellite, as L05 is", m->sat);
    if (!arc_about(e, sat, m->has_start ? &m->start : NULL, &from, &to)) {
        if (!m->has_start)
            return orr_diag_set(diag, ORR_E_NODATA, "%s has no orbit of %s", m->product, m->sat);
        return orr_diag_set(diag, ORR_E_NODATA, "%s has no orbit of %s at %s, where the trajectory begins",
                            m->product, m->sat, orr_time_text(m->start, name));
    }
    const orr_time start = m->has_start ? m->start : from;
    const double there_s = orr_time_diff_s(to, start), wish_s = (double)m->duration_ns * 1e-9,
                 duration_s = wish_s > 0 ? wish_s : there_s;
    if (duration_s > there_s)
        return orr_diag_set(diag, ORR_E_NODATA,
                            "%s has an unbroken orbit of %s until %s, %.0f s after the trajectory's begin, "
                            "and %.0f s are asked for",
                            m->product, m->sat, orr_time_text(to, name), there_s, duration_s);
    if (duration_s > LONGEST_S || duration_s < STEP_S)
        return orr_diag_set(diag, ORR_E_ARG,
                            "trajectory: %.0f s of an orbit; from %.0f s to 31 days are possible", duration_s,
                            STEP_S);
    way w;
    orr_status s = way_for(duration_s, &w, diag);
    if (s != ORR_OK) return s;
    for (long k = -BEYOND; (double)k * STEP_S < duration_s + BEYOND * STEP_S; k++) {
        orr_sat_state state;
        const orr_time t = orr_time_add_s(start, (double)k * STEP_S);
        if (t >= from && t <= to && orr_ephemeris_eval(e, sat, t, &state) == ORR_OK)
            way_add(&w, (double)k * STEP_S, state.pos_m, state.vel_mps);
    }
    s = through(&w, start, duration_s, out, diag);
    way_free(&w);
    return s;
}

// Elements at the start, in the true equator and equinox of date, as a state in the axes of integration.
static void begin_state(const orr_scenario_elements *el, orr_time start, orr_vec3 *r, orr_vec3 *v)
{
    const double deg = ORR_RAD_PER_DEG;
    const orr_kepler k = {.a_m = el->semimajor_axis_m,
                          .e = el->eccentricity,
                          .i_rad = el->inclination_deg * deg,
                          .raan_rad = el->node_deg * deg,
                          .argp_rad = el->perigee_deg * deg,
                          .m_rad = el->mean_anomaly_deg * deg};
    orr_mat3 date;
    orr_astro_gcrs_to_tod(start, &date);
    orr_kepler_to_state(&k, ORR_EGM96_GM, r, v);
    *r = orr_mat3_apply_t(&date, *r);
    *v = orr_mat3_apply_t(&date, *v);
}

// Follows the orbit from BEYOND steps before its begin, where the sky's time begins, to `steps` behind it.
static orr_status follow(orr_integrator *it, const orr_sky *sky, orr_vec3 r, orr_vec3 v, long steps, way *w,
                         orr_diag *diag)
{
    const double begin_s = BEYOND * STEP_S;
    orr_status s = orr_integrate(it, begin_s, -begin_s, &r, &v);
    for (long k = 0; k <= BEYOND + steps && s == ORR_OK; k++) {
        const double at_s = (double)k * STEP_S;
        orr_sky_point p;
        orr_vec3 r_ecef, v_ecef;
        if (k > 0) s = orr_integrate(it, at_s - STEP_S, STEP_S, &r, &v);
        orr_sky_at(sky, at_s, &p);
        orr_sky_to_ecef(&p, r, v, &r_ecef, &v_ecef);
        way_add(w, at_s - begin_s, r_ecef, v_ecef);
    }
    if (s == ORR_OK) return s;
    const double reached_s = w->n > 0 ? w->t_s[w->n - 1] : -begin_s;
    return orr_diag_set(diag, s, "trajectory.elements: %.0f s after its begin the orbit is none any more",
                        reached_s);
}

static orr_status of_elements(const orr_scenario_trajectory *m, orr_time start, const orr_leap_table *leap,
                              orr_trajectory *out, orr_diag *diag)
{
    const double duration_s = (double)m->duration_ns * 1e-9;
    if (!(duration_s >= STEP_S && duration_s <= LONGEST_S))
        return orr_diag_set(diag, ORR_E_ARG,
                            "trajectory.duration: %g s of elements; from %.0f s to 31 days are possible",
                            duration_s, STEP_S);
    const long steps = (long)ceil(duration_s / STEP_S) + BEYOND;
    orr_force force = {.sun_moon = true};
    orr_sky *sky = NULL;
    orr_integrator *it = NULL;
    way w = {0};
    orr_vec3 r, v;
    begin_state(&m->elements, start, &r, &v);
    orr_status s = orr_gravity_field_init(&force.earth, ORR_GRAVITY_MAX_DEGREE, false, diag);
    if (s == ORR_OK)
        s = orr_sky_init(orr_time_add_s(start, -BEYOND * STEP_S),
                         orr_time_add_s(start, (double)steps * STEP_S), ORR_SKY_GCRS, NULL, leap, &sky, NULL,
                         diag);
    if (s == ORR_OK) s = orr_integrator_init(&force, sky, &it, diag);
    if (s == ORR_OK) s = way_for(duration_s, &w, diag);
    if (s == ORR_OK) s = follow(it, sky, r, v, steps, &w, diag);
    if (s == ORR_OK) s = through(&w, start, duration_s, out, diag);
    way_free(&w);
    orr_integrator_free(it);
    orr_sky_free(sky);
    return s;
}

orr_status moving_make_orbit(const orr_scenario_trajectory *m, orr_time start, orr_moving *out,
                             orr_diag *diag)
{
    if (m->product == NULL) return of_elements(m, start, out->inputs.leap, &out->trajectory, diag);
    orr_ephemeris *e = NULL;
    orr_status s = orr_ephemeris_load(m->product, &e, diag);
    if (s == ORR_OK) s = orr_inputs_note(&out->inputs, m->product, diag);
    if (s == ORR_OK) s = of_product(m, e, &out->trajectory, diag);
    orr_ephemeris_free(e);
    return s;
}
