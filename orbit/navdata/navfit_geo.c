// SPDX-License-Identifier: GPL-3.0-or-later
// SBAS' state at t0: position, velocity and acceleration of message 9. The model is a parabola in ecef, linear in its nine parameters and
// without a connection of the axes: each is fitted, and brought to the nearest point of its lattice, on its own.
#include <math.h>
#include <string.h>

#include "core/linalg.h"
#include "orbit/navdata/geo_fields.h"
#include "orbit/navdata/navfit_private.h"

#define SEARCH_NODES 1000
#define N 3
#define T0_STEP_NS (16 * ORR_NS_PER_S)

// RTCA DO-229E table A-18.
const orr_navfit_field orr_geo_fields[3][3] = {
    {ORR_SIGNED("x", 0.08, 30), ORR_SIGNED("vx", 0.000625, 17), ORR_SIGNED("ax", 0.0000125, 10)},
    {ORR_SIGNED("y", 0.08, 30), ORR_SIGNED("vy", 0.000625, 17), ORR_SIGNED("ay", 0.0000125, 10)},
    {ORR_SIGNED("z", 0.4, 25), ORR_SIGNED("vz", 0.004, 18), ORR_SIGNED("az", 0.0000625, 10)},
};
const orr_navfit_field orr_geo_clock[2] = {ORR_SIGNED("aGf0", P2(31), 12), ORR_SIGNED("aGf1", P2(40), 8)};

static double component(orr_vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

typedef struct axis_fit {
    double whole[N]; // of p, v, a in their LSBs
    double left_m2;  // squares of what the real numbers leave
} axis_fit;

static orr_status fit_axis(const orr_navfit_window *w, orr_time t0, int axis, axis_fit *out)
{
    double A[ORR_NAVFIT_POSITIONS * N], b[ORR_NAVFIT_POSITIONS], tau[N], x[N], R[N * N], y[N];
    const orr_navfit_field *f = orr_geo_fields[axis];
    for (size_t i = 0; i < w->n; i++) {
        const double t = orr_time_diff_s(w->t[i], t0);
        A[N * i] = f[0].lsb, A[N * i + 1] = t * f[1].lsb, A[N * i + 2] = 0.5 * t * t * f[2].lsb;
        b[i] = component(w->pos[i], axis);
    }
    orr_status s = orr_least_squares(A, w->n, N, b, tau, x);
    if (s != ORR_OK) return s;
    // The search is about the rounded solution, where its numbers are small.
    for (int i = 0; i < N; i++) {
        y[i] = 0;
        for (int j = i; j < N; j++) {
            R[N * i + j] = A[N * i + j];
            y[i] += A[N * i + j] * (x[j] - round(x[j]));
        }
        for (int j = 0; j < i; j++) R[N * i + j] = 0;
    }
    double z[N];
    s = orr_lattice_closest(N, R, y, SEARCH_NODES, z);
    for (int j = 0; j < N; j++) out->whole[j] = round(x[j]) + z[j];
    out->left_m2 = 0;
    for (size_t i = 0; i < w->n; i++) {
        const double t = orr_time_diff_s(w->t[i], t0), d = component(w->pos[i], axis) - x[0] * f[0].lsb -
                                                           x[1] * f[1].lsb * t -
                                                           0.5 * x[2] * f[2].lsb * t * t;
        out->left_m2 += d * d;
    }
    return s;
}

orr_status orr_navfit_geo(orr_sat sat, orr_time t0, orr_time from, orr_time to, orr_navfit_source source,
                          void *user, orr_nav_eph *eph, orr_navfit_report *report, orr_diag *diag)
{
    int32_t week;
    int64_t ns;
    orr_time_week(t0, &week, &ns);
    if (orr_sat_system(sat) != 'S')
        return orr_diag_set(diag, ORR_E_ARG, "message 9 is that of SBAS satellites");
    if (ns % T0_STEP_NS != 0)
        return orr_diag_set(diag, ORR_E_ARG, "t0 is transmitted in steps of 16 s of the day");
    orr_navfit_window w;
    orr_status s = orr_navfit_check_window(t0, from, to, 60, 900, diag);
    if (s == ORR_OK) s = orr_navfit_gather(from, to, 300, source, user, &w, diag);
    if (s != ORR_OK) return s;
    orr_nav_eph e = orr_navfit_blank(sat, ORR_NAV_GEO, ORR_NAV_SBAS, t0, week);
    double value[3][N], left = 0;
    for (int axis = 0; axis < 3 && s == ORR_OK; axis++) {
        axis_fit a;
        s = fit_axis(&w, t0, axis, &a);
        for (int j = 0; j < N && s == ORR_OK; j++) {
            s = orr_navfit_to_field(&orr_geo_fields[axis][j], a.whole[j], &value[axis][j], diag);
            if (s != ORR_OK) return s;
        }
        left += a.left_m2;
    }
    if (s == ORR_OK) {
        e.geo = (orr_nav_geo){.pos_m = orr_vec3_make(value[0][0], value[1][0], value[2][0]),
                              .vel_mps = orr_vec3_make(value[0][1], value[1][1], value[2][1]),
                              .acc_mps2 = orr_vec3_make(value[0][2], value[1][2], value[2][2]),
                              .ura_m = (double)NAN,
                              .iodn = ORR_NAV_NO_IOD};
        s = orr_navfit_judge(&e, &w, &report->rms_m, &report->max_m);
    }
    if (s != ORR_OK) return orr_diag_set(diag, s, "the orbit over the window cannot be fitted by a parabola");
    report->n = w.n;
    report->fit_rms_m = sqrt(left / (double)w.n);
    *eph = e;
    return ORR_OK;
}
