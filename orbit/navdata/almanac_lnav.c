// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/almanac_lnav.h"
#include "core/linalg.h"

#include <string.h>

#include "orbit/force/kepler.h"
#include "orbit/navdata/lnav_model.h"
#include "orbit/navdata/navfit_private.h"

#define STEP_S 750.0 // nine positions in two hours
#define LEAST_S 7200.0
#define MOST_S 93600.0
#define TOA_STEP_S 4096
#define ITERATIONS 20
#define CONVERGED_M 1e-3
#define SEARCH_NODES 1000
#define I_REFERENCE (0.30 * ORR_PI)
#define N 7

// OMEGADOT from a few hours is noise: a deviation of PULL_RADPS from what the Earth's flattening causes costs
// as much as PULL_M in one coordinate, which a day of positions outweighs.
#define PULL_M 1000.0
#define PULL_RADPS 1e-9

static const struct {
    size_t column; // of the LNAV model
    orr_navfit_field field;
} table[N] = {
    // IS-GPS-200N table 20-VI
    {ORR_LNAV_SQRT_A, {"sqrt(A)", P2(11), 24, ORR_FIELD_UNSIGNED}},
    {ORR_LNAV_EX, {"e", P2(21), 16, ORR_FIELD_UNSIGNED}},
    {ORR_LNAV_EY, {"omega", SEMICIRCLE *P2(23), 24, ORR_FIELD_ANGLE}},
    {ORR_LNAV_LAMBDA, {"M0", SEMICIRCLE *P2(23), 24, ORR_FIELD_ANGLE}},
    {ORR_LNAV_I0, {"delta i", SEMICIRCLE *P2(19), 16, ORR_FIELD_SIGNED}},
    {ORR_LNAV_OMEGA0, {"OMEGA0", SEMICIRCLE *P2(23), 24, ORR_FIELD_ANGLE}},
    {ORR_LNAV_OMEGA_DOT, {"OMEGADOT", SEMICIRCLE *P2(38), 16, ORR_FIELD_SIGNED}},
};
enum { SQRT_A, E, OMEGA, M0, DELTA_I, OMEGA0, OMEGA_DOT };

typedef struct problem {
    const orr_navfit_window *w;
    orr_time toa;
    double theory_radps; // of OMEGADOT
    size_t rows;
    double A[ORR_NAVFIT_ROWS * N], b[ORR_NAVFIT_ROWS];
} problem;

static void to_array(const orr_nav_kepler *k, double p[N])
{
    p[SQRT_A] = k->sqrt_a_sqrtm, p[E] = k->e, p[OMEGA] = k->omega_rad, p[M0] = k->m0_rad;
    p[DELTA_I] = k->i0_rad - I_REFERENCE, p[OMEGA0] = k->omega0_rad, p[OMEGA_DOT] = k->omega_dot_radps;
}

static void from_array(const double p[N], orr_nav_kepler *k)
{
    k->sqrt_a_sqrtm = p[SQRT_A], k->e = p[E], k->omega_rad = p[OMEGA], k->m0_rad = p[M0];
    k->i0_rad = I_REFERENCE + p[DELTA_I], k->omega0_rad = p[OMEGA0], k->omega_dot_radps = p[OMEGA_DOT];
}

static void fill_rows(double *row, const orr_vec3 d[ORR_LNAV_N])
{
    for (size_t j = 0; j < N; j++) {
        const orr_vec3 c = orr_vec3_scale(table[j].field.lsb, d[table[j].column]);
        row[j] = c.x, row[N + j] = c.y, row[2 * N + j] = c.z;
    }
}

static void linearise(problem *q, const orr_nav_kepler *k)
{
    for (size_t i = 0; i < q->w->n; i++) {
        orr_vec3 d[ORR_LNAV_N];
        orr_vec3 r = orr_vec3_sub(q->w->pos[i], orr_lnav_position(k, orr_time_diff_s(q->w->t[i], q->toa), d));
        fill_rows(&q->A[3 * i * N], d);
        q->b[3 * i] = r.x, q->b[3 * i + 1] = r.y, q->b[3 * i + 2] = r.z;
    }
    q->rows = 3 * q->w->n + 1;
    double *row = &q->A[(q->rows - 1) * N];
    memset(row, 0, N * sizeof *row);
    row[OMEGA_DOT] = PULL_M / PULL_RADPS * table[OMEGA_DOT].field.lsb;
    q->b[q->rows - 1] = PULL_M / PULL_RADPS * (q->theory_radps - k->omega_dot_radps);
}

// What the Earth's flattening does twice a revolution to a near-circular orbit, and to its mean motion: not
// sent, but known, so that it does not go into what is sent when the window is no whole number of
// revolutions. (Clohessy and Wiltshire's equations under J2; out of the plane it is a constant tilt.)
static void short_period(double a, double i, double delta_n, orr_nav_kepler *k)
{
    const double j2 = ORR_GPS_J2, re = ORR_WGS84_A_M, s2 = sin(i) * sin(i);
    k->crc_m = j2 * re * re / a * s2 / 4;
    k->cus_rad = j2 * re * re / (a * a) * s2 / 8;
    k->delta_n_radps = delta_n;
}

// The model without them that has the same mean motion.
static void without_short_period(orr_nav_kepler *k)
{
    double s = k->sqrt_a_sqrtm, n = sqrt(ORR_GPS_GM) / (s * s * s) + k->delta_n_radps;
    k->sqrt_a_sqrtm = cbrt(sqrt(ORR_GPS_GM) / n);
    k->crc_m = k->cus_rad = k->delta_n_radps = 0;
}

static orr_status first_guess(problem *q, orr_nav_kepler *k)
{
    orr_vec3 r, v;
    size_t mid = orr_navfit_middle(q->w, q->toa, ORR_GPS_EARTH_RATE_RADPS, &r, &v);
    orr_kepler el;
    orr_status s = orr_kepler_from_state(r, v, ORR_GPS_GM, &el);
    if (s != ORR_OK) return s;
    double dt = orr_time_diff_s(q->w->t[mid], q->toa), delta_n;
    orr_lnav_secular(el.a_m, el.e, el.i_rad, &q->theory_radps, &delta_n);
    short_period(el.a_m, el.i_rad, delta_n, k);
    k->sqrt_a_sqrtm = sqrt(el.a_m);
    k->e = el.e;
    k->i0_rad = el.i_rad;
    k->omega_dot_radps = q->theory_radps;
    k->omega_rad = el.argp_rad;
    k->m0_rad = el.m_rad - sqrt(ORR_GPS_GM / pow(el.a_m, 3)) * dt;
    k->omega0_rad = el.raan_rad + ORR_GPS_EARTH_RATE_RADPS * k->toe_sow_s - k->omega_dot_radps * dt;
    return ORR_OK;
}

static orr_status gauss_newton(problem *q, orr_nav_kepler *k)
{
    double moved = HUGE_VAL;
    for (int it = 0; it < ITERATIONS && moved > CONVERGED_M; it++) {
        double x[N], p[N], sum = 0;
        linearise(q, k);
        double tau[N];
        orr_status s = orr_least_squares(q->A, q->rows, N, q->b, tau, x);
        if (s != ORR_OK) return s;
        for (size_t j = 0; j < N; j++) {
            sum += q->b[j] * q->b[j];
            x[j] *= table[j].field.lsb;
        }
        moved = sqrt(sum / (double)q->w->n);
        double ex = k->e * cos(k->omega_rad) + x[E], ey = k->e * sin(k->omega_rad) + x[OMEGA];
        double lambda = k->omega_rad + k->m0_rad + x[M0];
        to_array(k, p);
        for (size_t j = 0; j < N; j++) p[j] += x[j];
        p[E] = hypot(ex, ey);
        p[OMEGA] = atan2(ey, ex);
        p[M0] = lambda - p[OMEGA];
        from_array(p, k);
        if (!(k->e < 0.9) || !(k->sqrt_a_sqrtm > 2500 && k->sqrt_a_sqrtm < 3e4)) return ORR_E_NUMERIC;
    }
    return moved <= 1 ? ORR_OK : ORR_E_NUMERIC;
}

// The lattice point whose orbit is nearest to the solution's over a day about toa.
static orr_status to_lattice(problem *q, orr_nav_kepler *k, orr_diag *diag)
{
    double fitted[N], p[N], whole[N], R[N * N], z[N];
    to_array(k, fitted);
    for (size_t j = 0; j < N; j++) {
        whole[j] = round(fitted[j] / table[j].field.lsb);
        p[j] = whole[j] * table[j].field.lsb;
    }
    from_array(p, k);
    const int hours = 12;
    q->rows = 0;
    for (int h = -hours; h <= hours; h++) {
        orr_vec3 d[ORR_LNAV_N];
        (void)orr_lnav_position(k, 3600.0 * h, d);
        orr_lnav_by_elements(k, d);
        fill_rows(&q->A[q->rows * N], d);
        for (int c = 0; c < 3; c++, q->rows++) {
            q->b[q->rows] = 0;
            for (size_t j = 0; j < N; j++)
                q->b[q->rows] += q->A[q->rows * N + j] * (fitted[j] - p[j]) / table[j].field.lsb;
        }
    }
    double tau[N];
    orr_status s = orr_least_squares(q->A, q->rows, N, q->b, tau, NULL);
    if (s != ORR_OK) return s;
    memcpy(R, q->A, sizeof R);
    s = orr_lattice_closest(N, R, q->b, SEARCH_NODES, z);
    for (size_t j = 0; j < N; j++) whole[j] += z[j];
    if (s == ORR_OK && whole[E] < 0) { // the same ellipse from its other end: pi is 2^23 LSBs
        whole[E] = -whole[E];
        whole[OMEGA] += 0x1p23, whole[M0] -= 0x1p23;
    }
    for (size_t j = 0; j < N && s == ORR_OK; j++)
        s = orr_navfit_to_field(&table[j].field, whole[j], &p[j], diag);
    if (s == ORR_OK) from_array(p, k);
    return s;
}

static void judge(const orr_nav_kepler *k, const problem *q, double *rms_m, double *max_m)
{
    double sum = 0, largest = 0;
    for (size_t i = 0; i < q->w->n; i++) {
        orr_vec3 pos = orr_lnav_position(k, orr_time_diff_s(q->w->t[i], q->toa), NULL);
        double d = orr_vec3_norm(orr_vec3_sub(q->w->pos[i], pos));
        sum += d * d;
        if (d > largest) largest = d;
    }
    *rms_m = sqrt(sum / (double)q->w->n);
    if (max_m != NULL) *max_m = largest;
}

static orr_status check(orr_sat sat, orr_time toa, orr_time from, orr_time to, double *toa_s, orr_diag *diag)
{
    int32_t week;
    int64_t ns;
    orr_time_week(toa, &week, &ns);
    *toa_s = (double)(ns / ORR_NS_PER_S);
    double length_s = orr_time_diff_s(to, from);
    if (orr_sat_system(sat) != 'G' || orr_sat_number(sat) > 32)
        return orr_diag_set(diag, ORR_E_ARG, "LNAV almanacs are of GPS satellites 1 to 32");
    if (ns % (TOA_STEP_S * ORR_NS_PER_S) != 0)
        return orr_diag_set(diag, ORR_E_ARG, "toa is transmitted in steps of 4096 s of the week");
    if (!(length_s >= LEAST_S && length_s <= MOST_S))
        return orr_diag_set(diag, ORR_E_ARG, "an almanac's window of %g s is not in %g..%g s", length_s,
                            LEAST_S, MOST_S);
    if (orr_time_diff_s(from, toa) > ORR_S_PER_WEEK / 2.0 || orr_time_diff_s(toa, to) > ORR_S_PER_WEEK / 2.0)
        return orr_diag_set(diag, ORR_E_ARG, "toa is further than half a week from the almanac's window");
    return ORR_OK;
}

orr_status orr_almanac_lnav_fit(orr_sat sat, orr_time toa, orr_time from, orr_time to,
                                orr_navfit_source source, void *user, orr_lnav_almanac *almanac,
                                orr_navfit_report *report, orr_diag *diag)
{
    orr_nav_kepler k = {0};
    orr_status s = check(sat, toa, from, to, &k.toe_sow_s, diag);
    if (s != ORR_OK) return s;
    orr_navfit_window w;
    s = orr_navfit_gather(from, to, STEP_S, source, user, &w, diag);
    if (s != ORR_OK) return s;
    if (orr_time_diff_s(w.t[w.n - 1], w.t[0]) < LEAST_S - 2 * STEP_S) // two hours need not begin on a step
        return orr_diag_set(diag, ORR_E_NODATA, "an almanac needs two hours of positions");
    problem q;
    q.w = &w, q.toa = toa;
    s = first_guess(&q, &k);
    if (s == ORR_OK) s = gauss_newton(&q, &k);
    if (s != ORR_OK) return orr_diag_set(diag, s, "the orbit over the window cannot be fitted by an almanac");
    without_short_period(&k);
    judge(&k, &q, &report->fit_rms_m, NULL);
    s = to_lattice(&q, &k, diag);
    if (s != ORR_OK) return s;
    judge(&k, &q, &report->rms_m, &report->max_m);
    report->n = w.n;
    *almanac = (orr_lnav_almanac){.number = orr_sat_number(sat),
                                  .e = k.e,
                                  .toa_s = k.toe_sow_s,
                                  .i_offset_rad = k.i0_rad - I_REFERENCE,
                                  .omega_dot_radps = k.omega_dot_radps,
                                  .sqrt_a_sqrtm = k.sqrt_a_sqrtm,
                                  .omega0_rad = k.omega0_rad,
                                  .omega_rad = k.omega_rad,
                                  .m0_rad = k.m0_rad};
    return ORR_OK;
}

orr_status orr_almanac_lnav_clock(const orr_ephemeris *e, orr_sat sat, orr_time toa, orr_time from,
                                  orr_time to, orr_lnav_almanac *almanac, double *rms_s, orr_diag *diag)
{
    static const orr_navfit_field af0 = {"af0", P2(20), 11, ORR_FIELD_SIGNED},
                                  af1 = {"af1", P2(38), 11, ORR_FIELD_SIGNED};
    orr_navfit_line line;
    orr_status s = orr_navfit_clock_line(e, sat, toa, from, to, false, &line, diag);
    if (s == ORR_OK) s = orr_navfit_to_field(&af1, round(line.slope / af1.lsb), &almanac->af1_sps, diag);
    if (s != ORR_OK) return s;
    // The mean of the window is kept, whatever the slope became; then rounded.
    double value = line.mean - almanac->af1_sps * line.mean_dt_s;
    s = orr_navfit_to_field(&af0, round(value / af0.lsb), &almanac->af0_s, diag);
    if (s == ORR_OK && rms_s != NULL) *rms_s = orr_navfit_line_rms(&line, almanac->af0_s, almanac->af1_sps);
    return s;
}

orr_status orr_almanac_lnav_eval(const orr_lnav_almanac *a, orr_time toa, orr_time t, orr_vec3 *pos,
                                 double *clock_s)
{
    const double tk = orr_time_diff_s(t, toa);
    if (!(fabs(tk) <= 4.0 * ORR_S_PER_WEEK)) return ORR_E_RANGE;
    if (!(a->sqrt_a_sqrtm > 2500 && a->sqrt_a_sqrtm < 3e4) || !(a->e >= 0 && a->e < 0.9))
        return ORR_E_NUMERIC;
    const orr_nav_kepler k = {.sqrt_a_sqrtm = a->sqrt_a_sqrtm,
                              .e = a->e,
                              .i0_rad = I_REFERENCE + a->i_offset_rad,
                              .omega_dot_radps = a->omega_dot_radps,
                              .omega0_rad = a->omega0_rad,
                              .omega_rad = a->omega_rad,
                              .m0_rad = a->m0_rad,
                              .toe_sow_s = a->toa_s};
    orr_vec3 at = orr_lnav_position(&k, tk, NULL);
    if (!isfinite(at.x + at.y + at.z)) return ORR_E_NUMERIC;
    if (pos != NULL) *pos = at;
    if (clock_s != NULL) *clock_s = a->af0_s + a->af1_sps * tk;
    return ORR_OK;
}
