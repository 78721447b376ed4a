// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/force/integrate.h"

#include <stdlib.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "orbit/force/shadow.h"

#define LOOKS 4     // places along a step at which the shadow may be near
#define LOOK_S 60.0 // and then the distance between places; a passage shorter than it is not seen
#define SAME_S 0.5  // a border so near to an end of the step is that end
#define LONGEST_PENUMBRA_S 1200.0 // of a grazing passage

struct orr_integrator {
    const orr_force *force;
    const orr_sky *sky;
    gsl_odeiv2_step *step;
    double max_step_s;
};

orr_status orr_integrator_init(const orr_force *force, const orr_sky *sky, orr_integrator **out,
                               orr_diag *diag)
{
    *out = NULL;
    orr_integrator *it = calloc(1, sizeof *it);
    if (it == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    it->force = force;
    it->sky = sky;
    it->max_step_s = ORR_INTEGRATE_MAX_STEP_S;
    it->step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 6);
    if (it->step == NULL) {
        free(it);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    *out = it;
    return ORR_OK;
}

void orr_integrator_free(orr_integrator *it)
{
    if (it == NULL) return;
    gsl_odeiv2_step_free(it->step);
    free(it);
}

void orr_integrator_set(orr_integrator *it, const orr_force *force, double max_step_s)
{
    it->force = force;
    it->max_step_s = max_step_s;
}

static int motion(double t, const double y[], double dydt[], void *params)
{
    const orr_integrator *it = params;
    orr_sky_point p;
    orr_sky_force_point(it->sky, t, &p);
    const orr_vec3 a =
        orr_force_of_state(it->force, &p, orr_vec3_make(y[0], y[1], y[2]), orr_vec3_make(y[3], y[4], y[5]));
    dydt[0] = y[3], dydt[1] = y[4], dydt[2] = y[5];
    dydt[3] = a.x, dydt[4] = a.y, dydt[5] = a.z;
    return GSL_SUCCESS;
}

// Position dt after (r, v) by the series of two-body motion: 20 m off over 900 s of a GNSS satellite, 5 ms of its way.
static orr_vec3 near_position(orr_vec3 r, orr_vec3 v, double dt)
{
    const double r2 = orr_vec3_dot(r, r), u = ORR_EGM96_GM / (r2 * sqrt(r2)), p = orr_vec3_dot(r, v) / r2,
                 w = orr_vec3_dot(v, v) / r2 - u, t2 = dt * dt, t3 = t2 * dt, t4 = t2 * t2;
    const double f = 1 - u * t2 / 2 + u * p * t3 / 2 + u * t4 / 24 * (3 * w - 15 * p * p + u);
    return orr_vec3_axpy(dt - u * t3 / 6 + u * p * t4 / 4, v, orr_vec3_scale(f, r));
}

typedef struct passage { // an orbit before the Sun, for a step
    orr_vec3 r, v, sun;
} passage;

// Distance from the shadow's edge in half widths of the penumbra: 1 at its outer border, -1 at the inner one.
static double limb_after(const passage *p, double dt)
{
    return fmin(orr_force_limb_distance(near_position(p->r, p->v, dt), p->sun), 9);
}

static bool may_meet_shadow(const passage *p, double h_s)
{
    const double s2 = orr_vec3_dot(p->sun, p->sun);
    const double edge =
        1.01 * ORR_SHADOW_RADIUS_M + 0.01 * orr_vec3_norm(p->r) + fabs(h_s) / LOOKS * orr_vec3_norm(p->v);
    for (int k = 0; k <= LOOKS; k++) {
        const orr_vec3 q = near_position(p->r, p->v, h_s * k / LOOKS);
        const double along = orr_vec3_dot(q, p->sun);
        if (along < 0 && orr_vec3_dot(q, q) - along * along / s2 < edge * edge) return true;
    }
    return false;
}

// Where the limb distance is `level` between dt a and b, at which it lies on different sides.
static double crossing(const passage *p, double a, double b, double level)
{
    const bool above = limb_after(p, a) > level;
    for (int i = 0; i < 40 && fabs(b - a) > 1e-3; i++) {
        const double m = 0.5 * (a + b);
        if ((limb_after(p, m) > level) == above)
            a = m;
        else
            b = m;
    }
    return 0.5 * (a + b);
}

size_t orr_integrate_borders(const orr_integrator *it, double t_s, double h_s, orr_vec3 r, orr_vec3 v,
                             double dt_s[ORR_INTEGRATE_BORDERS])
{
    if (!it->force->precise && !(it->force->srp_mps2 > 0 || it->force->srp_mps2 < 0)) return 0;
    orr_sky_point sky;
    orr_sky_force_point(it->sky, t_s + 0.5 * h_s, &sky);
    const passage p = {r, v, sky.sun_m};
    if (!may_meet_shadow(&p, h_s)) return 0;
    size_t n = 0;
    const int looks = (int)ceil(fabs(h_s) / LOOK_S);
    double before = limb_after(&p, 0);
    for (int k = 1; k <= looks; k++) {
        const double a = h_s * (k - 1) / looks, b = h_s * k / looks, now = limb_after(&p, b);
        // inwards the outer border comes first, outwards the inner one
        const double level[2] = {now < before ? 1 : -1, now < before ? -1 : 1};
        for (int i = 0; i < 2; i++) {
            if ((before > level[i]) == (now > level[i]) || n == ORR_INTEGRATE_BORDERS) continue;
            const double when = crossing(&p, a, b, level[i]);
            if (fabs(when) > SAME_S && fabs(h_s - when) > SAME_S) dt_s[n++] = when;
        }
        before = now;
    }
    return n;
}

// One stretch in which the sunlight has no kink; within the penumbra in short steps.
static orr_status go(orr_integrator *it, double t_s, double h_s, double y[6])
{
    gsl_odeiv2_system system = {motion, NULL, 6, it};
    double error[6];
    int parts = 1;
    if (fabs(h_s) > ORR_INTEGRATE_PENUMBRA_STEP_S && fabs(h_s) < LONGEST_PENUMBRA_S) {
        orr_sky_point sky;
        orr_sky_force_point(it->sky, t_s + 0.5 * h_s, &sky);
        const passage p = {{y[0], y[1], y[2]}, {y[3], y[4], y[5]}, sky.sun_m};
        if (fabs(limb_after(&p, 0.5 * h_s)) < 1)
            parts = (int)ceil(fabs(h_s) / ORR_INTEGRATE_PENUMBRA_STEP_S - 1e-9);
    }
    for (int k = 0; k < parts; k++)
        if (gsl_odeiv2_step_apply(it->step, t_s + h_s * k / parts, h_s / parts, y, error, NULL, NULL,
                                  &system) != GSL_SUCCESS)
            return ORR_E_NUMERIC;
    return ORR_OK;
}

#define WAVE_ANGLE 2.0 // of the highest harmonic that a step may pass over

// The finer the field and the lower the orbit, the shorter the waves that it passes over.
static double longest_step(const orr_integrator *it, orr_vec3 r, orr_vec3 v)
{
    const double waves = orr_gravity_field_degree(&it->force->earth) * orr_vec3_norm(v) / orr_vec3_norm(r);
    return waves > 0 ? fmin(it->max_step_s, WAVE_ANGLE / waves) : it->max_step_s;
}

orr_status orr_integrate(orr_integrator *it, double t_s, double h_s, orr_vec3 *r, orr_vec3 *v)
{
    int coarse = (int)ceil(fabs(h_s) / longest_step(it, *r, *v) - 1e-9);
    if (coarse < 1) coarse = 1;
    double y[6] = {r->x, r->y, r->z, v->x, v->y, v->z};
    for (int i = 0; i < coarse; i++) {
        const double big = h_s / coarse, start = t_s + big * i;
        const orr_vec3 q = orr_vec3_make(y[0], y[1], y[2]), w = orr_vec3_make(y[3], y[4], y[5]);
        if (!(orr_vec3_dot(q, q) > 1e12)) return ORR_E_NUMERIC;
        double border[ORR_INTEGRATE_BORDERS + 1], from = 0;
        size_t n = orr_integrate_borders(it, start, big, q, w, border);
        border[n++] = big;
        for (size_t k = 0; k < n; from = border[k++]) {
            const orr_status s = go(it, start + from, border[k] - from, y);
            if (s != ORR_OK) return s;
        }
    }
    for (int k = 0; k < 6; k++)
        if (!isfinite(y[k])) return ORR_E_NUMERIC;
    *r = orr_vec3_make(y[0], y[1], y[2]);
    *v = orr_vec3_make(y[3], y[4], y[5]);
    return ORR_OK;
}
