// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/navfit_private.h"

#include "core/astro.h"
#include "orbit/broadcast/broadcast.h"
#include "orbit/spacecraft/attitude.h"

orr_status orr_navfit_check_window(orr_time t0, orr_time from, orr_time to, double least_s, double most_s,
                                   orr_diag *diag)
{
    double length_s = orr_time_diff_s(to, from);
    if (!(length_s >= least_s && length_s <= most_s))
        return orr_diag_set(diag, ORR_E_ARG, "a fit window of %g s is not in %g..%g s", length_s, least_s,
                            most_s);
    if (orr_time_diff_s(from, t0) > length_s || orr_time_diff_s(t0, to) > length_s)
        return orr_diag_set(
            diag, ORR_E_ARG,
            "the instant of the parameters is further outside the fit window than it is long");
    return ORR_OK;
}

orr_nav_eph orr_navfit_blank(orr_sat sat, orr_nav_kind kind, uint8_t message, orr_time toe, int32_t week)
{
    orr_nav_eph e = {.sat = sat,
                     .kind = (uint8_t)kind,
                     .message = message,
                     .toe = toe,
                     .toc = toe,
                     .transmission = ORR_TIME_NONE,
                     .week = week,
                     .fit_interval_h = (double)NAN,
                     .accuracy_m = (double)NAN,
                     .iode = ORR_NAV_NO_IOD,
                     .iodc = ORR_NAV_NO_IOD,
                     .l2p_flag = -1,
                     .sat_type = -1,
                     .ura_ed = -128,
                     .ura_ned = {-128, -128, -128},
                     .sisai_oe = -128,
                     .sisai_ocb = -128,
                     .sisai_oc1 = -128,
                     .sisai_oc2 = -128,
                     .sismai = -128,
                     .integrity_flags = -128};
    double *delay = (double *)&e.delay;
    for (size_t k = 0; k < sizeof e.delay / sizeof *delay; k++) delay[k] = (double)NAN;
    return e;
}

orr_status orr_navfit_gather(orr_time from, orr_time to, double step_s, orr_navfit_source source, void *user,
                             orr_navfit_window *w, orr_diag *diag)
{
    double length_s = orr_time_diff_s(to, from);
    int n = length_s > 24 * step_s ? (int)ceil(length_s / step_s - 1e-9) : 24;
    w->n = 0;
    for (int k = 0; k <= n && w->n < ORR_NAVFIT_POSITIONS; k++) {
        orr_time t = orr_time_add_s(from, length_s * k / n);
        if (source(user, t, &w->pos[w->n]) == ORR_OK) w->t[w->n++] = t;
    }
    if (w->n >= 9) return ORR_OK;
    return orr_diag_set(diag, ORR_E_NODATA,
                        "only %zu positions of the window of %g s are in the orbit product", w->n, length_s);
}

size_t orr_navfit_middle(const orr_navfit_window *w, orr_time t0, double earth_rate, orr_vec3 *r, orr_vec3 *v)
{
    size_t first = 0;
    double best = HUGE_VAL;
    for (size_t i = 0; i + 5 <= w->n; i++) {
        double span = orr_time_diff_s(w->t[i + 4], w->t[i]),
               aside = fabs((double)i + 2 - 0.5 * (double)(w->n - 1));
        if (span + 1e-3 * aside < best) best = span + 1e-3 * aside, first = i;
    }
    const size_t mid = first + 2;
    double x[5];
    orr_vec3 in[5];
    for (size_t k = 0; k < 5; k++) {
        orr_mat3 back = orr_mat3_rot3(-earth_rate * orr_time_diff_s(w->t[first + k], t0));
        in[k] = orr_mat3_apply(&back, w->pos[first + k]);
        x[k] = orr_time_diff_s(w->t[first + k], w->t[mid]);
    }
    *r = in[2];
    *v = (orr_vec3){0, 0, 0};
    for (size_t k = 0; k < 5; k++) { // Lagrange's basis: l_k'(0), the node at 0 being in[2]
        double slope = 0;
        if (k == 2) {
            for (size_t j = 0; j < 5; j++)
                if (j != 2) slope -= 1 / x[j];
        } else {
            slope = 1 / x[k];
            for (size_t j = 0; j < 5; j++)
                if (j != k && j != 2) slope *= x[j] / (x[j] - x[k]);
        }
        *v = orr_vec3_axpy(slope, in[k], *v);
    }
    return mid;
}

orr_status orr_navfit_judge(const orr_nav_eph *e, const orr_navfit_window *w, double *rms_m, double *max_m)
{
    double sum = 0, largest = 0;
    for (size_t i = 0; i < w->n; i++) {
        orr_broadcast_state s;
        orr_status status = orr_broadcast_eval(e, w->t[i], &s);
        if (status != ORR_OK) return status;
        orr_vec3 d = orr_vec3_sub(w->pos[i], s.pos_m);
        double n2 = orr_vec3_dot(d, d);
        sum += n2;
        if (n2 > largest) largest = n2;
    }
    *rms_m = sqrt(sum / (double)w->n);
    if (max_m != NULL) *max_m = sqrt(largest);
    return ORR_OK;
}

orr_vec3 orr_navfit_rough_sun(orr_time t)
{
    int32_t mjd;
    double fraction;
    orr_time_mjd(t, ORR_SCALE_UTC, NULL, &mjd, &fraction);
    const double d = (double)(mjd - 51544) + fraction - 0.5, deg = ORR_RAD_PER_DEG; // days from J2000
    const double g = (357.528 + 0.9856003 * d) * deg;
    const double lambda = (280.460 + 0.9856474 * d + 1.915 * sin(g) + 0.020 * sin(2 * g)) * deg;
    const double eps = (23.439 - 0.0000004 * d) * deg;
    const double ra = atan2(cos(eps) * sin(lambda), cos(lambda)), dec = asin(sin(eps) * sin(lambda));
    const double lon = ra - (280.46061837 + 360.98564736629 * d) * deg;
    const double r = ORR_AU_M * (1.00014 - 0.01671 * cos(g) - 0.00014 * cos(2 * g));
    return orr_vec3_make(r * cos(dec) * cos(lon), r * cos(dec) * sin(lon), r * sin(dec));
}

orr_status orr_navfit_from_product(void *product, orr_time t, orr_vec3 *pos)
{
    const orr_navfit_product *p = product;
    orr_sat_state s;
    orr_status status = orr_ephemeris_eval(p->ephemeris, p->sat, t, &s);
    if (status != ORR_OK) return status;
    *pos = s.pos_m;
    if (fabs(p->offset_m[0]) + fabs(p->offset_m[1]) + fabs(p->offset_m[2]) <= 0) return ORR_OK;
    orr_attitude a;
    // The Sun only turns the antenna's horizontal offset, less than half a metre, about the vertical: 0.1 mm.
    status =
        orr_attitude_nominal(s.pos_m, orr_velocity_inertial(s.pos_m, s.vel_mps), orr_navfit_rough_sun(t), &a);
    if (status != ORR_OK) return status;
    *pos = orr_vec3_add(
        s.pos_m, orr_mat3_apply_t(&a.body, (orr_vec3){p->offset_m[0], p->offset_m[1], p->offset_m[2]}));
    return ORR_OK;
}
