// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/force/integrate.h"

#include <stdlib.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

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

static double sunlight_at(const orr_integrator *it, double t_s, orr_vec3 r)
{
    orr_sky_point p;
    orr_sky_force_point(it->sky, t_s, &p);
    return orr_force_sunlight_fast(r, p.sun_m);
}

// Whether the sunlight changes within the step: then the force has near-kinks that a long step would smear.
static bool crosses_penumbra(const orr_integrator *it, double t_s, double h_s, orr_vec3 r, orr_vec3 v)
{
    if (!it->force->precise && !(it->force->srp_mps2 > 0 || it->force->srp_mps2 < 0)) return false;
    double first = sunlight_at(it, t_s, r);
    for (int k = 1; k <= 4;
         k++) { // a parabola follows the orbit to some km over a step, a hundredth of the shadow
        double dt = h_s * k / 4;
        orr_vec3 g = orr_vec3_scale(-ORR_EGM96_GM / pow(orr_vec3_norm(r), 3), r);
        orr_vec3 q = orr_vec3_axpy(dt, v, orr_vec3_axpy(0.5 * dt * dt, g, r));
        double light = sunlight_at(it, t_s + dt, q);
        if (fabs(light - first) > 0 || (light > 0 && light < 1)) return true;
    }
    return false;
}

orr_status orr_integrate(orr_integrator *it, double t_s, double h_s, orr_vec3 *r, orr_vec3 *v)
{
    gsl_odeiv2_system system = {motion, NULL, 6, it};
    int coarse = (int)ceil(fabs(h_s) / it->max_step_s - 1e-9);
    if (coarse < 1) coarse = 1;
    double y[6] = {r->x, r->y, r->z, v->x, v->y, v->z}, error[6];
    for (int i = 0; i < coarse; i++) {
        double big = h_s / coarse, start = t_s + big * i;
        orr_vec3 q = orr_vec3_make(y[0], y[1], y[2]), w = orr_vec3_make(y[3], y[4], y[5]);
        if (!(orr_vec3_dot(q, q) > 1e12)) return ORR_E_NUMERIC;
        int fine = 1;
        if (crosses_penumbra(it, start, big, q, w))
            fine = (int)ceil(fabs(big) / ORR_INTEGRATE_PENUMBRA_STEP_S - 1e-9);
        if (fine < 1) fine = 1;
        for (int k = 0; k < fine; k++) {
            double h = big / fine;
            if (gsl_odeiv2_step_apply(it->step, start + h * k, h, y, error, NULL, NULL, &system) !=
                GSL_SUCCESS)
                return ORR_E_NUMERIC;
        }
    }
    for (int k = 0; k < 6; k++)
        if (!isfinite(y[k])) return ORR_E_NUMERIC;
    *r = orr_vec3_make(y[0], y[1], y[2]);
    *v = orr_vec3_make(y[3], y[4], y[5]);
    return ORR_OK;
}
