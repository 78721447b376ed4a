// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/events.h"

#include <stdlib.h>

#include "core/array.h"

#define BOUNDARY_S 0.05
#define SEARCH_S 30.0

orr_status orr_event_add(orr_event_list *l, orr_event_kind kind, orr_time t0, orr_time t1, double value)
{
    if (!ORR_ARRAY_GROW(l->item, l->n)) return ORR_E_MEMORY;
    l->item[l->n++] = (orr_orbit_event){kind, t0, t1, value};
    return ORR_OK;
}

static int by_begin(const void *a, const void *b)
{
    const orr_orbit_event *x = a, *y = b;
    if (x->t0 != y->t0) return x->t0 < y->t0 ? -1 : 1;
    return (int)x->kind - (int)y->kind;
}

void orr_events_sort(orr_event_list *l)
{
    if (l->n > 1) qsort(l->item, l->n, sizeof *l->item, by_begin);
}

static double limb_at(const orr_sky *sky, double t_s, orr_vec3 ecef)
{
    orr_sky_point p;
    orr_sky_force_point(sky, t_s, &p);
    return orr_force_limb_distance(orr_mat3_apply_t(&p.R, ecef), p.sun_m);
}

// Limb distance between samples, the position by the cubic through both ends' states: metres off over 150 s.
static double limb_between(const orr_sky *sky, const orr_orbit_arc *arc, double arc_s, double x_s)
{
    double k = floor(x_s / arc->step_s);
    if (k > (double)(arc->n - 2)) k = (double)(arc->n - 2);
    const orr_orbit_sample *a = &arc->sample[(size_t)k], *b = a + 1;
    double h = arc->step_s, u = x_s / h - k, u2 = u * u, u3 = u2 * u;
    orr_vec3 r = orr_vec3_scale(2 * u3 - 3 * u2 + 1, a->pos_m);
    r = orr_vec3_axpy(h * (u3 - 2 * u2 + u), a->vel_mps, r);
    r = orr_vec3_axpy(-2 * u3 + 3 * u2, b->pos_m, r);
    r = orr_vec3_axpy(h * (u3 - u2), b->vel_mps, r);
    return limb_at(sky, arc_s + x_s, r);
}

typedef enum light { SUN, PARTIAL, DARK } light;
static light light_of(double limb) { return limb >= 1 ? SUN : limb > -1 ? PARTIAL : DARK; }

orr_status orr_events_eclipses(const orr_sky *sky, const orr_orbit_arc *arc, orr_event_list *l)
{
    const double arc_s = orr_time_diff_s(arc->t0, orr_sky_origin(sky));
    const double length = arc->step_s * (double)(arc->n - 1);
    double begin = 0, x0 = 0;
    light now = light_of(limb_between(sky, arc, arc_s, 0));
    orr_status s = ORR_OK;
    while (x0 < length && s == ORR_OK) {
        double x1 = x0 + SEARCH_S < length ? x0 + SEARCH_S : length;
        light then = light_of(limb_between(sky, arc, arc_s, x1));
        if (then == now) {
            x0 = x1;
            continue;
        }
        double lo = x0, hi = x1; // the first change after x0
        while (hi - lo > BOUNDARY_S) {
            double mid = 0.5 * (lo + hi);
            if (light_of(limb_between(sky, arc, arc_s, mid)) == now)
                lo = mid;
            else
                hi = mid;
        }
        if (now != SUN)
            s = orr_event_add(l, now == DARK ? ORR_EVENT_UMBRA : ORR_EVENT_PENUMBRA,
                              orr_time_add_s(arc->t0, begin), orr_time_add_s(arc->t0, hi), 0);
        now = light_of(limb_between(sky, arc, arc_s, hi));
        begin = x0 = hi;
    }
    if (now != SUN && s == ORR_OK)
        s = orr_event_add(l, now == DARK ? ORR_EVENT_UMBRA : ORR_EVENT_PENUMBRA,
                          orr_time_add_s(arc->t0, begin), orr_time_add_s(arc->t0, length), 0);
    return s;
}

static orr_status separation(const orr_track_context *c, double a_s, orr_reference before, double b_s,
                             orr_reference after, double t_s, orr_vec3 *dr, orr_vec3 *dv)
{
    orr_status s = orr_integrate(c->integrator, a_s, t_s - a_s, &before.r_m, &before.v_mps);
    if (s == ORR_OK) s = orr_integrate(c->integrator, b_s, t_s - b_s, &after.r_m, &after.v_mps);
    *dr = orr_vec3_sub(after.r_m, before.r_m);
    *dv = orr_vec3_sub(after.v_mps, before.v_mps);
    return s;
}

orr_status orr_events_manoeuvre(const orr_track_context *c, double a_s, orr_reference before, double b_s,
                                orr_reference after, double *when_s, double *apart_m, double *dv_mps)
{
    // dr grows almost linearly from the instant of the push: Newton's step on |dr|^2, held inside the
    // interval.
    double t = 0.5 * (a_s + b_s);
    orr_vec3 dr, dv;
    for (int i = 0; i < 20; i++) {
        orr_status s = separation(c, a_s, before, b_s, after, t, &dr, &dv);
        if (s != ORR_OK) return s;
        double v2 = orr_vec3_dot(dv, dv), step = v2 > 0 ? -orr_vec3_dot(dr, dv) / v2 : 0, old = t;
        t += step;
        if (t < a_s) t = a_s;
        if (t > b_s) t = b_s;
        if (fabs(t - old) < 1e-3) break;
    }
    orr_status s = separation(c, a_s, before, b_s, after, t, &dr, &dv);
    *when_s = t;
    *apart_m = orr_vec3_norm(dr);
    *dv_mps = orr_vec3_norm(dv);
    return s;
}
