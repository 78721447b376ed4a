// SPDX-License-Identifier: GPL-3.0-or-later
// LNAV's fifteen parameters: Gauss-Newton on the model's own derivatives, then the nearest point of the
// lattice that table 20-III can transmit.
#include <string.h>

#include "core/linalg.h"
#include "orbit/force/kepler.h"
#include "orbit/navdata/lnav_model.h"
#include "orbit/navdata/navfit_private.h"

#define ITERATIONS 20
#define CONVERGED_M 1e-5
#define SEARCH_NODES 3000
#define N ORR_LNAV_N

// What a window cannot tell (harmonics from a twentieth of a revolution) stays near to what is usual: a
// deviation of so much costs as much as PULL_M in one coordinate. The lattice has directions in which next to
// nothing changes for thousands of LSBs; along them the search may only go so far from the solution that the
// model's curvature (a Delta^2/2) stays about a millimetre: `reach`, which costs as much as REACH_M. HOLD_M
// keeps a parameter where it is whatever the orbit says.
#define PULL_M 3e-3
#define HOLD_M 1e4
#define REACH_M 1e-2
typedef struct parameter {
    orr_navfit_field field; // IS-GPS-200N table 20-III; angles in semicircles are held in radians
    double usual;           // 0: not pulled
    double reach;
} parameter;

// In the order of ORR_LNAV_...; e, omega and M0 in the places of their regular combinations.
static const parameter table[N] = {
    {{"sqrt(A)", P2(19), 32, ORR_FIELD_UNSIGNED}, 0, 5e-2},
    {{"e", P2(33), 32, ORR_FIELD_UNSIGNED}, 0, 1e-5},
    {{"omega", SEMICIRCLE *P2(31), 32, ORR_FIELD_ANGLE}, 0, 1e-4},
    {{"M0", SEMICIRCLE *P2(31), 32, ORR_FIELD_ANGLE}, 0, 1e-5},
    {{"i0", SEMICIRCLE *P2(31), 32, ORR_FIELD_ANGLE}, 0, 1e-5},
    {{"OMEGA0", SEMICIRCLE *P2(31), 32, ORR_FIELD_ANGLE}, 0, 1e-5},
    {{"OMEGADOT", SEMICIRCLE *P2(43), 24, ORR_FIELD_SIGNED}, 1e-8, 1e-9},
    {{"delta n", SEMICIRCLE *P2(43), 16, ORR_FIELD_SIGNED}, 4e-9, 1e-9},
    {{"IDOT", SEMICIRCLE *P2(43), 14, ORR_FIELD_SIGNED}, 5e-10, 5e-10},
    {{"Crc", P2(5), 16, ORR_FIELD_SIGNED}, 300, 100},
    {{"Crs", P2(5), 16, ORR_FIELD_SIGNED}, 300, 100},
    {{"Cuc", P2(29), 16, ORR_FIELD_SIGNED}, 1e-5, 1e-5},
    {{"Cus", P2(29), 16, ORR_FIELD_SIGNED}, 1e-5, 1e-5},
    {{"Cic", P2(29), 16, ORR_FIELD_SIGNED}, 1e-5, 1e-5},
    {{"Cis", P2(29), 16, ORR_FIELD_SIGNED}, 1e-5, 1e-5},
};
enum { E = ORR_LNAV_EX, OMEGA = ORR_LNAV_EY, M0 = ORR_LNAV_LAMBDA };

static void to_array(const orr_nav_kepler *k, double p[N])
{
    const double all[N] = {k->sqrt_a_sqrtm, k->e,          k->omega_rad,       k->m0_rad,
                           k->i0_rad,       k->omega0_rad, k->omega_dot_radps, k->delta_n_radps,
                           k->idot_radps,   k->crc_m,      k->crs_m,           k->cuc_rad,
                           k->cus_rad,      k->cic_rad,    k->cis_rad};
    memcpy(p, all, sizeof all);
}

static void from_array(const double p[N], orr_nav_kepler *k)
{
    k->sqrt_a_sqrtm = p[ORR_LNAV_SQRT_A], k->e = p[E], k->omega_rad = p[OMEGA], k->m0_rad = p[M0];
    k->i0_rad = p[ORR_LNAV_I0], k->omega0_rad = p[ORR_LNAV_OMEGA0];
    k->omega_dot_radps = p[ORR_LNAV_OMEGA_DOT], k->delta_n_radps = p[ORR_LNAV_DELTA_N];
    k->idot_radps = p[ORR_LNAV_IDOT];
    k->crc_m = p[ORR_LNAV_CRC], k->crs_m = p[ORR_LNAV_CRS];
    k->cuc_rad = p[ORR_LNAV_CUC], k->cus_rad = p[ORR_LNAV_CUS];
    k->cic_rad = p[ORR_LNAV_CIC], k->cis_rad = p[ORR_LNAV_CIS];
}

typedef struct problem {
    const orr_navfit_window *w;
    double target[N], weight_m[N]; // of the pulled parameters
    size_t rows;
    double A[ORR_NAVFIT_ROWS * N], b[ORR_NAVFIT_ROWS];
} problem;

// Jacobian in units of the parameters' LSBs, and residuals, over the window; by the elements that are sent,
// or by their regular combinations.
static void linearise(problem *q, const orr_nav_eph *e, bool by_elements)
{
    for (size_t i = 0; i < q->w->n; i++) {
        orr_vec3 d[N];
        orr_vec3 r =
            orr_vec3_sub(q->w->pos[i], orr_lnav_position(&e->kepler, orr_time_diff_s(q->w->t[i], e->toe), d));
        if (by_elements) orr_lnav_by_elements(&e->kepler, d);
        double *row = &q->A[3 * i * N];
        for (size_t j = 0; j < N; j++) {
            row[j] = d[j].x * table[j].field.lsb;
            row[N + j] = d[j].y * table[j].field.lsb;
            row[2 * N + j] = d[j].z * table[j].field.lsb;
        }
        q->b[3 * i] = r.x, q->b[3 * i + 1] = r.y, q->b[3 * i + 2] = r.z;
    }
    q->rows = 3 * q->w->n;
}

// A row that asks parameter j to move by `by` (its unit); the row is returned for other columns.
static double *pull(problem *q, size_t j, double weight_m, double unit, double by)
{
    double *row = &q->A[q->rows * N];
    memset(row, 0, N * sizeof *row);
    row[j] = weight_m / unit * table[j].field.lsb;
    q->b[q->rows++] = weight_m / unit * by;
    return row;
}

// Elements at toe from a state in the window, wherever toe is.
static orr_status first_guess(orr_nav_eph *e, const orr_navfit_window *w)
{
    orr_vec3 r, v;
    size_t mid = orr_navfit_middle(w, e->toe, ORR_GPS_EARTH_RATE_RADPS, &r, &v);
    orr_kepler el;
    orr_status s = orr_kepler_from_state(r, v, ORR_GPS_GM, &el);
    if (s != ORR_OK) return s;
    double dt = orr_time_diff_s(w->t[mid], e->toe);
    orr_nav_kepler *k = &e->kepler;
    orr_lnav_secular(el.a_m, el.e, el.i_rad, &k->omega_dot_radps, &k->delta_n_radps);
    k->sqrt_a_sqrtm = sqrt(el.a_m);
    k->e = el.e;
    k->i0_rad = el.i_rad;
    k->omega_rad = el.argp_rad;
    k->m0_rad = el.m_rad - (sqrt(ORR_GPS_GM / pow(el.a_m, 3)) + k->delta_n_radps) * dt;
    k->omega0_rad = el.raan_rad + ORR_GPS_EARTH_RATE_RADPS * k->toe_sow_s - k->omega_dot_radps * dt;
    return ORR_OK;
}

static orr_status gauss_newton(problem *q, orr_nav_eph *e)
{
    orr_nav_kepler *k = &e->kepler;
    double moved = HUGE_VAL;
    for (int it = 0; it < ITERATIONS && moved > CONVERGED_M; it++) {
        double x[N], p[N], sum = 0;
        to_array(k, p);
        linearise(q, e, false);
        for (size_t j = 0; j < N; j++)
            if (table[j].usual > 0) (void)pull(q, j, q->weight_m[j], table[j].usual, q->target[j] - p[j]);
        double tau[N];
        orr_status s = orr_least_squares(q->A, q->rows, N, q->b, tau, x);
        if (s != ORR_OK) return s;
        for (size_t j = 0; j < N; j++) sum += q->b[j] * q->b[j];
        moved = sqrt(sum / (double)q->w->n);
        double ex = k->e * cos(k->omega_rad) + x[ORR_LNAV_EX] * table[ORR_LNAV_EX].field.lsb;
        double ey = k->e * sin(k->omega_rad) + x[ORR_LNAV_EY] * table[ORR_LNAV_EY].field.lsb;
        double lambda = k->omega_rad + k->m0_rad + x[ORR_LNAV_LAMBDA] * table[ORR_LNAV_LAMBDA].field.lsb;
        for (size_t j = 0; j < N; j++) p[j] += x[j] * table[j].field.lsb;
        p[E] = hypot(ex, ey);
        p[OMEGA] = atan2(ey, ex);
        p[M0] = lambda - p[OMEGA];
        from_array(p, k);
        if (!(k->e < 0.9) || !(k->sqrt_a_sqrtm > 2500 && k->sqrt_a_sqrtm < 3e4)) return ORR_E_NUMERIC;
    }
    return moved <= 1e-3 ? ORR_OK : ORR_E_NUMERIC;
}

static double field_end(size_t j) { return ldexp(table[j].field.lsb, table[j].field.bits - 1); }

// A rate or harmonic that its field cannot hold is kept within, whatever the orbit wants; the others make up
// for it as they can. Returns whether there was one.
static bool hold_in_fields(problem *q, const orr_nav_kepler *k)
{
    bool any = false;
    double p[N];
    to_array(k, p);
    for (size_t j = 0; j < N; j++) {
        double top = 0.95 * field_end(j);
        if (!(table[j].usual > 0) || fabs(p[j]) <= top || q->weight_m[j] > PULL_M) continue;
        q->target[j] = copysign(top, p[j]);
        q->weight_m[j] = HOLD_M;
        any = true;
    }
    return any;
}

// The nearest lattice point by the linear model about the parameters rounded one by one.
static orr_status to_lattice(problem *q, orr_nav_eph *e, orr_diag *diag)
{
    double fitted[N], p[N], whole[N], R[N * N], z[N];
    to_array(&e->kepler, fitted);
    for (size_t j = 0; j < N; j++) {
        whole[j] = round(fitted[j] / table[j].field.lsb);
        p[j] = whole[j] * table[j].field.lsb;
    }
    from_array(p, &e->kepler);
    linearise(q, e, true);
    for (size_t j = 0; j < N; j++) {
        double by = fitted[j] - p[j], reach = table[j].reach;
        if (table[j].usual > 0) reach = fmin(reach, fmax(field_end(j) - fabs(fitted[j]), 0) / 20);
        if (j == M0) by += fitted[OMEGA] - p[OMEGA]; // what acts is their sum
        double *row = pull(q, j, fmax(REACH_M, q->weight_m[j]), reach, by);
        if (j == M0) row[OMEGA] = row[M0];
    }
    double tau[N];
    orr_status s = orr_least_squares(q->A, q->rows, N, q->b, tau, NULL);
    if (s != ORR_OK) return s;
    memcpy(R, q->A, sizeof R);
    s = orr_lattice_closest(N, R, q->b, SEARCH_NODES, z);
    if (s != ORR_OK) return s;
    for (size_t j = 0; j < N; j++) whole[j] += z[j];
    if (whole[E] < 0) { // the same ellipse from its other end: pi is 2^31 LSBs
        whole[E] = -whole[E];
        whole[OMEGA] += 0x1p31, whole[M0] -= 0x1p31;
    }
    for (size_t j = 0; j < N; j++) {
        s = orr_navfit_to_field(&table[j].field, whole[j], &p[j], diag);
        if (s != ORR_OK) return s;
    }
    from_array(p, &e->kepler);
    return ORR_OK;
}

orr_status orr_navfit_lnav(orr_sat sat, orr_time toe, orr_time from, orr_time to, double fit_interval_h,
                           orr_navfit_source source, void *user, orr_nav_eph *eph, orr_navfit_report *report,
                           orr_diag *diag)
{
    if (orr_sat_system(sat) != 'G' && orr_sat_system(sat) != 'J')
        return orr_diag_set(diag, ORR_E_ARG, "LNAV is sent by GPS and QZSS satellites");
    orr_status s = orr_navfit_check_window(toe, from, to, 1800, 21600, diag);
    if (s != ORR_OK) return s;
    if (!(fit_interval_h > 0)) return orr_diag_set(diag, ORR_E_ARG, "a fit interval of %g h", fit_interval_h);
    int32_t week;
    int64_t sow_ns;
    orr_time_week(toe, &week, &sow_ns);
    if (sow_ns % (16 * ORR_NS_PER_S) != 0)
        return orr_diag_set(diag, ORR_E_ARG, "toe is transmitted in steps of 16 s of the week");
    orr_navfit_window w;
    s = orr_navfit_gather(from, to, 300, source, user, &w, diag);
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
    problem q;
    q.w = &w;
    s = first_guess(&e, &w);
    to_array(&e.kepler, q.target);
    for (size_t j = 0; j < N; j++) q.weight_m[j] = PULL_M;
    do {
        if (s == ORR_OK) s = gauss_newton(&q, &e);
    } while (s == ORR_OK && hold_in_fields(&q, &e.kepler));
    if (s == ORR_OK) s = orr_navfit_judge(&e, &w, &report->fit_rms_m, NULL);
    if (s == ORR_OK) s = to_lattice(&q, &e, diag);
    if (s == ORR_E_RANGE) return s;
    if (s == ORR_OK) s = orr_navfit_judge(&e, &w, &report->rms_m, &report->max_m);
    if (s != ORR_OK)
        return orr_diag_set(diag, s, "the orbit over the window cannot be fitted by Kepler elements");
    report->n = w.n;
    *eph = e;
    return ORR_OK;
}
