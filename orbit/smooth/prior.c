// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/prior.h"

#include "orbit/broadcast/broadcast.h"

#define WINDOW 10
#define WRONG_RECORD_M 1e3
#define SAME_S 1e-6
#define GROSS_M 200.0
#define GROSS_J2 5e-3      // of gravity at the equator: three times what the flattened Earth adds
#define GROSS_ORDERS 2.0   // of the fourth order: 9 e of it is left, for eccentricities to 0.2
#define UNBROKEN_STEPS 2.5 // nodes further apart than so many steps do not share a polynomial

// Derivative at x[at] of the polynomial through (x[i], y[i]), by the barycentric differentiation matrix.
static orr_vec3 polynomial_slope(const double *x, const orr_vec3 *y, size_t n, size_t at)
{
    orr_vec3 slope = {0, 0, 0};
    double own = 0; // rows of the matrix sum to zero
    for (size_t i = 0; i < n; i++) {
        if (i == at) continue;
        double d = 1.0 / (x[i] - x[at]);
        for (size_t k = 0; k < n; k++)
            if (k != i && k != at) d *= (x[at] - x[k]) / (x[i] - x[k]);
        slope = orr_vec3_axpy(d, y[i], slope);
        own -= d;
    }
    return orr_vec3_axpy(own, y[at], slope);
}

// Circular motion at r towards (or from) another place of the same orbit, dt later (or, negative, earlier).
static bool circular_velocity(orr_vec3 r, orr_vec3 other, double dt, orr_vec3 *v)
{
    orr_vec3 normal = orr_vec3_cross(r, other);
    double radius = orr_vec3_norm(r), sine = orr_vec3_norm(normal) / (radius * orr_vec3_norm(other));
    double period = 2 * ORR_PI * sqrt(radius * radius * radius / ORR_EGM96_GM);
    if (fabs(dt) > 0.45 * period || sine < 1e-6) return false;
    orr_vec3 along = orr_vec3_unit(orr_vec3_cross(normal, r));
    *v = orr_vec3_scale((dt > 0 ? 1.0 : -1.0) * sqrt(ORR_EGM96_GM / radius), along);
    return true;
}

// How much the middle one of three evenly spaced nodes bends away from what gravity allows, in units of what
// is suspicious; negative where it cannot be said. In inertial axes r(-h) + r(h) = 2 cos(n h) r, for a circle
// exactly, for an ellipse up to the fourth order of n h.
static double bend(const orr_node *list, const orr_reference *ref, size_t n, size_t i)
{
    if (i == 0 || i + 1 >= n || ref[i - 1].gross || ref[i].gross || ref[i + 1].gross) return -1;
    const double h = list[i].t_s - list[i - 1].t_s, radius = orr_vec3_norm(ref[i].r_m);
    if (!(h > SAME_S) || fabs(list[i + 1].t_s - list[i].t_s - h) > SAME_S) return -1;
    const double nh = h * sqrt(ORR_EGM96_GM / (radius * radius * radius));
    const orr_vec3 both = orr_vec3_add(ref[i - 1].r_m, ref[i + 1].r_m);
    const double off = orr_vec3_norm(orr_vec3_axpy(-2 * cos(nh), ref[i].r_m, both));
    const double flat = GROSS_J2 * nh * nh * ORR_EGM96_RADIUS_M * ORR_EGM96_RADIUS_M / radius;
    return off / (GROSS_M + flat + GROSS_ORDERS / 12 * nh * nh * nh * nh * radius);
}

// A typing error of ten kilometres would spoil the velocities of all nodes that share a polynomial with it,
// and the linearisation about them. A node that is off by s bends by 2 s, its neighbours by s; the first and
// the last one have no bend of their own, only a neighbour that bends without reason.
static void find_gross(const orr_node *list, orr_reference *ref, size_t n)
{
    for (size_t found = 0; found <= n / 4; found++) {
        size_t worst = 0;
        double most = 1;
        for (size_t i = 1; i + 1 < n; i++)
            if (bend(list, ref, n, i) > most) most = bend(list, ref, n, worst = i);
        if (worst == 0) return;
        const double left = bend(list, ref, n, worst - 1), right = bend(list, ref, n, worst + 1);
        size_t culprit = worst;
        if (left < 0 && right >= 0 && right <= 1) culprit = worst - 1;
        if (right < 0 && left >= 0 && left <= 1) culprit = worst + 1;
        ref[culprit].gross = true;
    }
    for (size_t i = 0; i < n; i++) ref[i].gross = false; // so many are no errors but something else
}

void orr_prior_sparse(const orr_track_context *c, const orr_node *list, size_t n, double node_step_s,
                      orr_reference *reference)
{
    for (size_t i = 0; i < n; i++) { // positions in integration axes
        orr_sky_point p;
        orr_sky_force_point(c->sky, list[i].t_s, &p);
        reference[i].r_m = orr_mat3_apply_t(&p.R, list[i].ecef_m);
        reference[i].valid = reference[i].gross = false;
    }
    find_gross(list, reference, n);
    const double broken_s = UNBROKEN_STEPS * node_step_s;
    for (size_t i = 0; i < n; i++) {
        double x[WINDOW];
        orr_vec3 y[WINDOW];
        size_t lo = i, hi = i, count = 1, used = 0, at = 0; // indices of the window's ends in the list
        if (reference[i].gross) continue;
        while (count < WINDOW) { // grow to the nearer side; the second node of an instant is passed over
            double left = lo > 0 ? list[lo].t_s - list[lo - 1].t_s : HUGE_VAL;
            double right = hi + 1 < n ? list[hi + 1].t_s - list[hi].t_s : HUGE_VAL;
            bool can_left = left <= broken_s, can_right = right <= broken_s;
            if (!can_left && !can_right) break;
            double to_left = can_left ? list[i].t_s - list[lo - 1].t_s : HUGE_VAL;
            double to_right = can_right ? list[hi + 1].t_s - list[i].t_s : HUGE_VAL;
            if (to_left <= to_right) {
                lo--;
                if (left > 0) count++;
            } else {
                hi++;
                if (right > 0) count++;
            }
        }
        for (size_t k = lo; k <= hi && used < WINDOW; k++) { // one node an instant
            double from_i_s = list[k].t_s - list[i].t_s;
            bool same_as_i = k != i && fabs(from_i_s) < SAME_S;
            bool same_as_last = k > lo && k != i && list[k].t_s - list[k - 1].t_s < SAME_S;
            if (same_as_i || same_as_last || reference[k].gross) continue;
            if (k == i) at = used;
            x[used] = from_i_s / node_step_s;
            y[used++] = reference[k].r_m;
        }
        if (used >= 3) {
            reference[i].v_mps = orr_vec3_scale(1.0 / node_step_s, polynomial_slope(x, y, used, at));
            reference[i].valid = true;
            continue;
        }
        double dt_left = i > 0 ? list[i - 1].t_s - list[i].t_s : -HUGE_VAL;
        double dt_right = i + 1 < n ? list[i + 1].t_s - list[i].t_s : HUGE_VAL;
        if (dt_right <= -dt_left && dt_right > 0)
            reference[i].valid =
                circular_velocity(reference[i].r_m, reference[i + 1].r_m, dt_right, &reference[i].v_mps);
        else if (dt_left < 0 && isfinite(dt_left))
            reference[i].valid =
                circular_velocity(reference[i].r_m, reference[i - 1].r_m, dt_left, &reference[i].v_mps);
    }
}

size_t orr_prior_broadcast(const orr_track_context *c, orr_sat sat, const orr_node *list, size_t n,
                           double node_step_s, orr_reference *reference)
{
    const orr_broadcast_choice choice = orr_broadcast_choice_default();
    size_t found = 0;
    orr_prior_sparse(c, list, n, node_step_s, reference);
    for (size_t i = 0; i < n; i++) {
        orr_broadcast_state s;
        orr_sky_point p;
        const orr_nav_eph *eph = orr_broadcast_select(c->options->nav, sat, list[i].t, &choice);
        if (eph == NULL || orr_broadcast_eval(eph, list[i].t, &s) != ORR_OK) continue;
        if (orr_sat_system(sat) == 'R') s.pos_m = orr_broadcast_pz90_to_itrf(s.pos_m, list[i].t);
        // Navigation files hold records of one satellite under another's name: a node knows better.
        if (orr_vec3_norm(orr_vec3_sub(s.pos_m, list[i].ecef_m)) > WRONG_RECORD_M) continue;
        orr_sky_at(c->sky, list[i].t_s, &p);
        orr_sky_from_ecef(&p, s.pos_m, s.vel_mps, &reference[i].r_m, &reference[i].v_mps);
        reference[i].valid = true;
        found++;
    }
    return found;
}
