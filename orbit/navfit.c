// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navfit.h"

#include <stddef.h>
#include <string.h>

#include <gsl/gsl_blas.h>
#include <gsl/gsl_linalg.h>

#include "core/astro.h"
#include "orbit/attitude.h"
#include "orbit/broadcast.h"
#include "orbit/kepler.h"

#define MAX_POSITIONS 128
#define MAX_PARAMETERS 15
#define ITERATIONS 12

typedef struct window {
    size_t n;
    orr_time t[MAX_POSITIONS];
    orr_vec3 pos[MAX_POSITIONS];
} window;

// A parameter of a record: where it is, how far to move it for a derivative (metres of effect: some), and its
// LSB.
typedef struct parameter {
    size_t offset;
    double step, lsb;
    int bits; // of the transmitted field, two's complement unless unsigned
    bool is_unsigned;
    const char *name;
} parameter;

#define SEMICIRCLE ORR_PI
#define P2(n) (1.0 / (double)(UINT64_C(1) << (n)))
#define KEPLER(field) (offsetof(orr_nav_eph, kepler) + offsetof(orr_nav_kepler, field))

// IS-GPS-200N table 20-III; angles transmitted in semicircles are held in radians. Rounded in this order:
// what moves the orbit most first, so that the rest can make up for it.
static const parameter lnav[] = {
    {KEPLER(sqrt_a_sqrtm), 1e-4, P2(19), 32, true, "sqrt(A)"},
    {KEPLER(e), 1e-8, P2(33), 32, true, "e"},
    {KEPLER(delta_n_radps), 1e-12, SEMICIRCLE *P2(43), 16, false, "delta n"},
    {KEPLER(omega_dot_radps), 1e-12, SEMICIRCLE *P2(43), 24, false, "OMEGADOT"},
    {KEPLER(idot_radps), 1e-12, SEMICIRCLE *P2(43), 14, false, "IDOT"},
    {KEPLER(crc_m), 1e-1, P2(5), 16, false, "Crc"},
    {KEPLER(crs_m), 1e-1, P2(5), 16, false, "Crs"},
    {KEPLER(cuc_rad), 1e-8, P2(29), 16, false, "Cuc"},
    {KEPLER(cus_rad), 1e-8, P2(29), 16, false, "Cus"},
    {KEPLER(cic_rad), 1e-8, P2(29), 16, false, "Cic"},
    {KEPLER(cis_rad), 1e-8, P2(29), 16, false, "Cis"},
    {KEPLER(i0_rad), 1e-8, SEMICIRCLE *P2(31), 32, false, "i0"},
    {KEPLER(omega0_rad), 1e-8, SEMICIRCLE *P2(31), 32, false, "OMEGA0"},
    {KEPLER(omega_rad), 1e-8, SEMICIRCLE *P2(31), 32, false, "omega"},
    {KEPLER(m0_rad), 1e-8, SEMICIRCLE *P2(31), 32, false, "M0"},
};
#define N_LNAV (sizeof lnav / sizeof lnav[0])

static double *field(orr_nav_eph *e, const parameter *p) { return (double *)(void *)((char *)e + p->offset); }

static orr_status gather(orr_time from, orr_time to, orr_navfit_source source, void *user, window *w,
                         orr_diag *diag)
{
    double length_s = orr_time_diff_s(to, from);
    int n = length_s > 24 * 300.0 ? (int)ceil(length_s / 300 - 1e-9) : 24;
    w->n = 0;
    for (int k = 0; k <= n && w->n < MAX_POSITIONS; k++) {
        orr_time t = orr_time_add_s(from, length_s * k / n);
        if (source(user, t, &w->pos[w->n]) == ORR_OK) w->t[w->n++] = t;
    }
    if (w->n >= 9) return ORR_OK;
    return orr_diag_set(diag, ORR_E_NODATA,
                        "only %zu positions of the window of %g s are in the orbit product", w->n, length_s);
}

// A window of so many seconds, and the parameters' instant within it or not further outside than it is long.
static orr_status check_window(orr_time t0, orr_time from, orr_time to, double least_s, double most_s,
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

static orr_status residuals(const orr_nav_eph *e, const window *w, double *out, double *rms_m, double *max_m)
{
    double sum = 0, largest = 0;
    for (size_t i = 0; i < w->n; i++) {
        orr_broadcast_state s;
        orr_status status = orr_broadcast_eval(e, w->t[i], &s);
        if (status != ORR_OK) return status;
        orr_vec3 d = orr_vec3_sub(w->pos[i], s.pos_m);
        if (out != NULL) out[3 * i] = d.x, out[3 * i + 1] = d.y, out[3 * i + 2] = d.z;
        double n2 = orr_vec3_dot(d, d);
        sum += n2;
        if (n2 > largest) largest = n2;
    }
    if (rms_m != NULL) *rms_m = sqrt(sum / (double)w->n);
    if (max_m != NULL) *max_m = sqrt(largest);
    return ORR_OK;
}

// One Gauss-Newton step in the parameters listed: central differences, columns scaled to unit length (argp
// and M0 are nearly one direction in a near-circular orbit), least squares by SVD with directions of no
// effect left out.
static orr_status gauss_newton(orr_nav_eph *e, const window *w, const parameter *p, size_t n, double *moved_m)
{
    const size_t rows = 3 * w->n;
    double r[3 * MAX_POSITIONS], plus[3 * MAX_POSITIONS], minus[3 * MAX_POSITIONS], scale[MAX_PARAMETERS];
    orr_status s = residuals(e, w, r, NULL, NULL);
    if (s != ORR_OK) return s;
    gsl_matrix *A = gsl_matrix_alloc(rows, n), *V = gsl_matrix_alloc(n, n);
    gsl_vector *S = gsl_vector_alloc(n), *work = gsl_vector_alloc(n), *x = gsl_vector_alloc(n);
    gsl_vector_view b = gsl_vector_view_array(r, rows);
    if (A == NULL || V == NULL || S == NULL || work == NULL || x == NULL) s = ORR_E_MEMORY;
    for (size_t k = 0; k < n && s == ORR_OK; k++) {
        orr_nav_eph moved = *e;
        *field(&moved, &p[k]) += p[k].step;
        s = residuals(&moved, w, plus, NULL, NULL);
        *field(&moved, &p[k]) -= 2 * p[k].step;
        if (s == ORR_OK) s = residuals(&moved, w, minus, NULL, NULL);
        double length = 0;
        for (size_t i = 0; i < rows; i++) {
            plus[i] = (minus[i] - plus[i]) / (2 * p[k].step);
            length += plus[i] * plus[i];
        }
        scale[k] = length > 0 ? 1 / sqrt(length) : 1;
        for (size_t i = 0; i < rows; i++) gsl_matrix_set(A, i, k, plus[i] * scale[k]);
    }
    if (s == ORR_OK && gsl_linalg_SV_decomp(A, V, S, work) != 0) s = ORR_E_NUMERIC;
    if (s == ORR_OK) {
        double largest = gsl_vector_get(S, 0);
        for (size_t k = 0; k < n; k++)
            if (gsl_vector_get(S, k) < 1e-11 * largest) gsl_vector_set(S, k, 0);
        if (gsl_linalg_SV_solve(A, V, S, &b.vector, x) != 0) s = ORR_E_NUMERIC;
        *moved_m = gsl_blas_dnrm2(x) / sqrt((double)w->n);
    }
    for (size_t k = 0; k < n && s == ORR_OK; k++) *field(e, &p[k]) += gsl_vector_get(x, k) * scale[k];
    gsl_matrix_free(A);
    gsl_matrix_free(V);
    gsl_vector_free(S);
    gsl_vector_free(work);
    gsl_vector_free(x);
    return s;
}

static orr_status converge(orr_nav_eph *e, const window *w, const parameter *p, size_t n, int iterations)
{
    double moved = HUGE_VAL;
    orr_status s = ORR_OK;
    for (int k = 0; k < iterations && s == ORR_OK && moved > 1e-5; k++) s = gauss_newton(e, w, p, n, &moved);
    return s;
}

static orr_status round_to_field(orr_nav_eph *e, const parameter *p, orr_diag *diag)
{
    double *v = field(e, p), whole = round(*v / p->lsb);
    double top = ldexp(1.0, p->is_unsigned ? p->bits : p->bits - 1);
    if (!(whole < top && whole >= (p->is_unsigned ? 0 : -top)))
        return orr_diag_set(diag, ORR_E_RANGE, "%s = %.10g does not fit its %d bits", p->name, *v, p->bits);
    *v = whole * p->lsb;
    return ORR_OK;
}

static double wrap(double a) { return remainder(a, 2 * ORR_PI); } // [-pi, pi]: the field's semicircles

// Position and velocity in the middle of the window, in inertial axes that coincide with ecef at t0: the
// derivative of the polynomial through the five positions that are closest together (there may be gaps).
// Returns which position it is.
static size_t middle_state(const window *w, orr_time t0, double earth_rate, orr_vec3 *r, orr_vec3 *v)
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

// Elements at toe from a state in the window, wherever toe is.
static orr_status first_guess(orr_nav_eph *e, const window *w, double gm, double earth_rate)
{
    orr_vec3 r, v;
    size_t mid = middle_state(w, e->toe, earth_rate, &r, &v);
    orr_kepler el;
    orr_status s = orr_kepler_from_state(r, v, gm, &el);
    if (s != ORR_OK) return s;
    double dt = orr_time_diff_s(w->t[mid], e->toe);
    orr_nav_kepler *k = &e->kepler;
    k->sqrt_a_sqrtm = sqrt(el.a_m);
    k->e = el.e;
    k->i0_rad = el.i_rad;
    k->omega_rad = wrap(el.argp_rad);
    k->m0_rad = wrap(el.m_rad - sqrt(gm / pow(el.a_m, 3)) * dt);
    k->omega0_rad = wrap(el.raan_rad + earth_rate * k->toe_sow_s);
    k->omega_dot_radps = -8e-9;
    k->delta_n_radps = 4.5e-9;
    return ORR_OK;
}

orr_status orr_navfit_lnav(orr_sat sat, orr_time toe, orr_time from, orr_time to, double fit_interval_h,
                           orr_navfit_source source, void *user, orr_nav_eph *eph, orr_navfit_report *report,
                           orr_diag *diag)
{
    window w;
    orr_status s = check_window(toe, from, to, 1800, 21600, diag);
    if (s != ORR_OK) return s;
    if (!(fit_interval_h > 0)) return orr_diag_set(diag, ORR_E_ARG, "a fit interval of %g h", fit_interval_h);
    int32_t week;
    int64_t sow_ns;
    orr_time_week(toe, &week, &sow_ns);
    if (sow_ns % (16 * ORR_NS_PER_S) != 0)
        return orr_diag_set(diag, ORR_E_ARG, "toe is transmitted in steps of 16 s of the week");
    s = gather(from, to, source, user, &w, diag);
    if (s != ORR_OK) return s;
    orr_nav_eph e = {.sat = sat,
                     .kind = ORR_NAV_KEPLER,
                     .message = ORR_NAV_LNAV,
                     .toe = toe,
                     .toc = toe,
                     .transmission = ORR_TIME_NONE,
                     .week = week,
                     .fit_interval_h = fit_interval_h,
                     .iode = ORR_NAV_NO_IOD,
                     .iodc = ORR_NAV_NO_IOD};
    e.kepler.toe_sow_s = (double)sow_ns * 1e-9;
    e.kepler.top_sow_s = (double)NAN;
    s = first_guess(&e, &w, 3.986005e14, 7.2921151467e-5);
    if (s == ORR_OK) s = converge(&e, &w, lnav, N_LNAV, ITERATIONS);
    if (s == ORR_OK) s = residuals(&e, &w, NULL, &report->fit_rms_m, NULL);
    e.kepler.m0_rad = wrap(e.kepler.m0_rad), e.kepler.omega_rad = wrap(e.kepler.omega_rad);
    e.kepler.omega0_rad = wrap(e.kepler.omega0_rad);
    for (size_t k = 0; k < N_LNAV && s == ORR_OK;
         k++) { // one parameter is fixed, the others make up for its rounding
        s = round_to_field(&e, &lnav[k], diag);
        if (s == ORR_E_RANGE) return s;
        if (s == ORR_OK && k + 1 < N_LNAV) s = converge(&e, &w, lnav + k + 1, N_LNAV - k - 1, 1);
    }
    if (s == ORR_OK) s = residuals(&e, &w, NULL, &report->rms_m, &report->max_m);
    if (s != ORR_OK)
        return orr_diag_set(diag, s, "the orbit over the window cannot be fitted by Kepler elements");
    report->n = w.n;
    *eph = e;
    return ORR_OK;
}

#define STATE(vector, axis)                                                                                  \
    (offsetof(orr_nav_eph, glonass) + offsetof(orr_nav_glonass, vector) + offsetof(orr_vec3, axis))

// GLONASS ICD 5.1, table 4.5; 27, 24 and 5 bits of sign and magnitude: one bit less than two's complement
// would hold.
static const parameter glonass[] = {
    {STATE(pos_m, x), 1.0, 1e3 * P2(11), 27, false, "x"},
    {STATE(pos_m, y), 1.0, 1e3 * P2(11), 27, false, "y"},
    {STATE(pos_m, z), 1.0, 1e3 * P2(11), 27, false, "z"},
    {STATE(vel_mps, x), 1e-3, 1e3 * P2(20), 24, false, "vx"},
    {STATE(vel_mps, y), 1e-3, 1e3 * P2(20), 24, false, "vy"},
    {STATE(vel_mps, z), 1e-3, 1e3 * P2(20), 24, false, "vz"},
    {STATE(acc_mps2, x), 1e-6, 1e3 * P2(30), 5, false, "ax"},
    {STATE(acc_mps2, y), 1e-6, 1e3 * P2(30), 5, false, "ay"},
    {STATE(acc_mps2, z), 1e-6, 1e3 * P2(30), 5, false, "az"},
};

// Tide of Sun and Moon at r, ecef axes: what the message calls the lunisolar acceleration.
static orr_vec3 lunisolar(orr_time t, orr_vec3 r)
{
    orr_mat3 R;
    orr_eop eop = orr_eop_at(NULL, t, NULL, NULL);
    orr_astro_gcrs_to_itrs(t, &eop, NULL, &R, NULL);
    orr_vec3 body[2] = {orr_mat3_apply(&R, orr_astro_sun(t)), orr_mat3_apply(&R, orr_astro_moon(t))},
             a = {0, 0, 0};
    const double gm[2] = {ORR_GM_SUN, ORR_GM_MOON};
    for (int k = 0; k < 2; k++) {
        orr_vec3 d = orr_vec3_sub(body[k], r);
        a = orr_vec3_axpy(gm[k] / pow(orr_vec3_norm(d), 3), d, a);
        a = orr_vec3_axpy(-gm[k] / pow(orr_vec3_norm(body[k]), 3), body[k], a);
    }
    return a;
}

// The axes hardly mix over a quarter of an hour: per axis the best of the 27 lattice points of position,
// velocity and acceleration about the solution, judged on the whole orbit.
static orr_status search_lattice(orr_nav_eph *e, const window *w)
{
    double best = 0;
    orr_status s = residuals(e, w, NULL, &best, NULL);
    for (int round_no = 0; round_no < 2 && s == ORR_OK; round_no++)
        for (size_t axis = 0; axis < 3 && s == ORR_OK; axis++) {
            orr_nav_eph centre = *e;
            for (int code = 0; code < 27 && s == ORR_OK; code++) {
                orr_nav_eph moved = centre;
                *field(&moved, &glonass[axis]) += (code % 3 - 1) * glonass[axis].lsb;
                *field(&moved, &glonass[3 + axis]) += (code / 3 % 3 - 1) * glonass[3 + axis].lsb;
                *field(&moved, &glonass[6 + axis]) += (code / 9 - 1) * glonass[6 + axis].lsb;
                double rms = 0;
                if (fabs(*field(&moved, &glonass[6 + axis])) > 15.5 * glonass[6 + axis].lsb) continue;
                s = residuals(&moved, w, NULL, &rms, NULL);
                if (s == ORR_OK && rms < best) {
                    best = rms;
                    *e = moved;
                }
            }
        }
    return s;
}

// State at tb: that of the window's middle, carried to tb by the message's own model.
static orr_status glonass_guess(orr_nav_eph *e, const window *w)
{
    orr_vec3 r, v;
    size_t mid = middle_state(w, w->t[w->n / 2], 0, &r, &v);
    orr_nav_eph there = *e;
    there.toe = w->t[mid];
    there.glonass.pos_m = r, there.glonass.vel_mps = v;
    there.glonass.acc_mps2 = lunisolar(there.toe, r);
    orr_broadcast_state at_tb;
    orr_status s = orr_broadcast_eval(&there, e->toe, &at_tb);
    if (s != ORR_OK) return s;
    e->glonass.pos_m = at_tb.pos_m;
    e->glonass.vel_mps = at_tb.vel_mps;
    e->glonass.acc_mps2 = lunisolar(e->toe, at_tb.pos_m);
    return ORR_OK;
}

orr_status orr_navfit_glonass(orr_sat sat, orr_time tb, orr_time from, orr_time to, orr_navfit_source source,
                              void *user, orr_nav_eph *eph, orr_navfit_report *report, orr_diag *diag)
{
    window w;
    orr_status s = check_window(tb, from, to, 600, 7200, diag);
    if (s == ORR_OK) s = gather(from, to, source, user, &w, diag);
    if (s != ORR_OK) return s;
    orr_nav_eph e = {.sat = sat,
                     .kind = ORR_NAV_GLONASS,
                     .message = ORR_NAV_FDMA,
                     .toe = tb,
                     .toc = tb,
                     .transmission = ORR_TIME_NONE,
                     .week = -1,
                     .fit_interval_h = (double)NAN,
                     .iode = ORR_NAV_NO_IOD,
                     .iodc = ORR_NAV_NO_IOD};
    e.glonass.frame_time_s = e.glonass.delta_tau_s = e.glonass.ura = (double)NAN;
    s = glonass_guess(&e, &w);
    if (s == ORR_OK) s = converge(&e, &w, glonass, 6, ITERATIONS);
    if (s == ORR_OK) s = residuals(&e, &w, NULL, &report->fit_rms_m, NULL);
    for (size_t k = 6; k < 9 && s == ORR_OK; k++) s = round_to_field(&e, &glonass[k], diag);
    if (s == ORR_OK) s = converge(&e, &w, glonass, 6, ITERATIONS);
    for (size_t k = 0; k < 6 && s == ORR_OK; k++) s = round_to_field(&e, &glonass[k], diag);
    if (s == ORR_E_RANGE) return s;
    if (s == ORR_OK) s = search_lattice(&e, &w);
    if (s == ORR_OK) s = residuals(&e, &w, NULL, &report->rms_m, &report->max_m);
    if (s != ORR_OK)
        return orr_diag_set(diag, s, "the orbit over the window cannot be fitted by a GLONASS state");
    report->n = w.n;
    *eph = e;
    return ORR_OK;
}

orr_status orr_navfit_clock(const orr_ephemeris *e, orr_sat sat, orr_time t0, orr_time from, orr_time to,
                            orr_nav_eph *eph, double *rms_s, orr_diag *diag)
{
    const bool is_glonass = eph->kind == ORR_NAV_GLONASS;
    const int points = 24;
    double x[25], y[25], sx = 0, sy = 0, sxx = 0, sxy = 0, sum = 0;
    int n = 0;
    for (int k = 0; k <= points; k++) {
        orr_time t = orr_time_add_s(from, orr_time_diff_s(to, from) * k / points);
        double dt = orr_time_diff_s(t, t0);
        orr_sat_state s;
        if (orr_ephemeris_eval(e, sat, t, &s) != ORR_OK || !(s.flags & ORR_EPH_CLOCK_VALID)) continue;
        double clock = s.clock_s;
        if (is_glonass) {
            orr_vec3 v =
                orr_vec3_add(s.vel_mps, orr_vec3_cross((orr_vec3){0, 0, ORR_EARTH_RATE_RADPS}, s.pos_m));
            clock -= 2 * orr_vec3_dot(s.pos_m, v) / (ORR_SPEED_OF_LIGHT * ORR_SPEED_OF_LIGHT);
        }
        x[n] = dt, y[n] = clock, n++;
        sx += dt, sy += clock, sxx += dt * dt, sxy += dt * clock;
    }
    if (n < 2)
        return orr_diag_set(diag, ORR_E_NODATA, "the product has no clock of the satellite in the window");
    double den = n * sxx - sx * sx, slope = (n * sxy - sx * sy) / den, value = (sy - slope * sx) / n;
    double af0_lsb = is_glonass ? P2(30) : P2(31), af1_lsb = is_glonass ? P2(40) : P2(43);
    eph->af1_sps = round(slope / af1_lsb) * af1_lsb;
    value = (sy - eph->af1_sps * sx) / n;
    eph->af0_s = round(value / af0_lsb) * af0_lsb;
    eph->af2_sps2 = 0;
    for (int k = 0; k < n; k++) {
        double d = y[k] - eph->af0_s - eph->af1_sps * x[k];
        sum += d * d;
    }
    if (rms_s != NULL) *rms_s = sqrt(sum / n);
    return ORR_OK;
}

orr_status orr_navfit_from_product(void *product, orr_time t, orr_vec3 *pos)
{
    const orr_navfit_product *p = product;
    orr_sat_state s;
    orr_status status = orr_ephemeris_eval(p->ephemeris, p->sat, t, &s);
    if (status != ORR_OK) return status;
    *pos = s.pos_m;
    if (fabs(p->offset_m[0]) + fabs(p->offset_m[1]) + fabs(p->offset_m[2]) <= 0) return ORR_OK;
    orr_mat3 R;
    orr_eop eop = orr_eop_at(NULL, t, NULL, NULL);
    orr_astro_gcrs_to_itrs(t, &eop, NULL, &R, NULL);
    orr_vec3 v = orr_vec3_add(s.vel_mps, orr_vec3_cross((orr_vec3){0, 0, ORR_EARTH_RATE_RADPS}, s.pos_m));
    orr_attitude a;
    status = orr_attitude_nominal(s.pos_m, v, orr_mat3_apply(&R, orr_astro_sun(t)), &a);
    if (status != ORR_OK) return status;
    *pos = orr_vec3_add(
        s.pos_m, orr_mat3_apply_t(&a.body, (orr_vec3){p->offset_m[0], p->offset_m[1], p->offset_m[2]}));
    return ORR_OK;
}
