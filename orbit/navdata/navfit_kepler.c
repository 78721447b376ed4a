// SPDX-License-Identifier: GPL-3.0-or-later
// Kepler elements: Gauss-Newton on the model's own derivatives, then the nearest point of the lattice that the message can
// transmit.
#include <string.h>

#include "core/linalg.h"
#include "orbit/force/kepler.h"
#include "orbit/navdata/kepler_lattice.h"
#include "orbit/navdata/kepler_model.h"
#include "orbit/navdata/navfit_private.h"
#include "orbit/navdata/system_week.h"

#define ITERATIONS 20
#define CONVERGED_M                                                                                          \
    1.0 // every step squares the distance over the orbit's size: a metre leaves less than a micrometre
#define SEARCH_NODES 3000
#define N ORR_KEPLER_N // at most; q->l->n of them

// What a window cannot tell (harmonics from a twentieth of a revolution) stays near to what is usual: a
// deviation of so much costs as much as PULL_M in one coordinate. The lattice has directions in which next to
// nothing changes for thousands of LSBs; along them the search may only go so far from the solution that the
// model's curvature (a Delta^2/2) stays about a millimetre: `reach`, which costs as much as REACH_M. HOLD_M
// keeps a parameter where it is whatever the orbit says.
#define PULL_M 3e-3
#define HOLD_M 1e4
#define REACH_M 1e-2
// In the order of ORR_KEPLER_...; e, omega and M0 in the places of their regular combinations.
static const struct {
    double usual; // 0: not pulled
    double reach;
} guide[N] = {{0, 5e-2},    {0, 1e-5},    {0, 1e-4},      {0, 1e-5},    {0, 1e-5},     {0, 1e-5},
              {1e-8, 1e-9}, {4e-9, 1e-9}, {5e-10, 5e-10}, {300, 100},   {300, 100},    {1e-5, 1e-5},
              {1e-5, 1e-5}, {1e-5, 1e-5}, {1e-5, 1e-5},   {2e-2, 1e-2}, {1e-13, 1e-13}};
#define A_PER_ROOT 1e4 // about 2 sqrt(a): the reach of a where a is sent
enum { E = ORR_KEPLER_EX, OMEGA = ORR_KEPLER_EY, M0 = ORR_KEPLER_LAMBDA };

static void from_array(const orr_kepler_lattice *l, const double p[N], orr_nav_kepler *k)
{
    k->sqrt_a_sqrtm = l->sends_a ? sqrt(p[ORR_KEPLER_SQRT_A]) : p[ORR_KEPLER_SQRT_A];
    k->e = p[E], k->omega_rad = p[OMEGA], k->m0_rad = p[M0];
    k->i0_rad = p[ORR_KEPLER_I0], k->omega0_rad = p[ORR_KEPLER_OMEGA0];
    k->omega_dot_radps = p[ORR_KEPLER_OMEGA_DOT], k->delta_n_radps = p[ORR_KEPLER_DELTA_N];
    k->idot_radps = p[ORR_KEPLER_IDOT];
    k->crc_m = p[ORR_KEPLER_CRC], k->crs_m = p[ORR_KEPLER_CRS];
    k->cuc_rad = p[ORR_KEPLER_CUC], k->cus_rad = p[ORR_KEPLER_CUS];
    k->cic_rad = p[ORR_KEPLER_CIC], k->cis_rad = p[ORR_KEPLER_CIS];
    if (l->n <= ORR_KEPLER_A_DOT) return;
    k->a_dot_mps = p[ORR_KEPLER_A_DOT], k->delta_n_dot_radps2 = p[ORR_KEPLER_N_DOT];
}

typedef struct problem {
    const orr_navfit_window *w; // in the axes of the message
    const orr_kepler_lattice *l;
    size_t n; // parameters
    orr_kepler_axes axes;
    double target[N], weight_m[N]; // of the pulled parameters
    size_t rows;
    double A[ORR_NAVFIT_ROWS * N], b[ORR_NAVFIT_ROWS];
} problem;

// Jacobian in units of the parameters' LSBs, and residuals, over the window, by the regular combinations of e, omega and M0.
static void linearise(problem *q, const orr_nav_eph *e)
{
    for (size_t i = 0; i < q->w->n; i++) {
        orr_vec3 d[N];
        orr_vec3 r = orr_vec3_sub(
            q->w->pos[i], orr_kepler_position(&q->axes, &e->kepler, orr_time_diff_s(q->w->t[i], e->toe), d));
        if (q->l->sends_a)
            d[ORR_KEPLER_SQRT_A] = orr_vec3_scale(0.5 / e->kepler.sqrt_a_sqrtm, d[ORR_KEPLER_SQRT_A]);
        double *row = &q->A[3 * i * q->n];
        for (size_t j = 0; j < q->n; j++) {
            const double lsb = q->l->element[j].lsb;
            row[j] = d[j].x * lsb;
            row[q->n + j] = d[j].y * lsb;
            row[2 * q->n + j] = d[j].z * lsb;
        }
        q->b[3 * i] = r.x, q->b[3 * i + 1] = r.y, q->b[3 * i + 2] = r.z;
    }
    q->rows = 3 * q->w->n;
}

// A row that asks parameter j to move by `by` (its unit); the row is returned for other columns.
static double *pull(problem *q, size_t j, double weight_m, double unit, double by)
{
    double *row = &q->A[q->rows * q->n];
    memset(row, 0, q->n * sizeof *row);
    row[j] = weight_m / unit * q->l->element[j].lsb;
    q->b[q->rows++] = weight_m / unit * by;
    return row;
}

// Elements at toe from a state in the window, wherever toe is.
static orr_status first_guess(const problem *q, orr_nav_eph *e)
{
    const orr_kepler_axes *x = &q->axes;
    orr_vec3 r, v;
    size_t mid = orr_navfit_middle(q->w, e->toe, x->turn, &r, &v);
    orr_kepler el;
    orr_status s = orr_kepler_from_state(r, v, x->gm, &el);
    if (s != ORR_OK) return s;
    double dt = orr_time_diff_s(q->w->t[mid], e->toe);
    orr_nav_kepler *k = &e->kepler;
    orr_kepler_secular(el.a_m, el.e, el.i_rad, &k->omega_dot_radps, &k->delta_n_radps);
    k->sqrt_a_sqrtm = sqrt(el.a_m);
    k->e = el.e;
    k->i0_rad = el.i_rad;
    k->omega_rad = el.argp_rad;
    k->m0_rad = el.m_rad - (sqrt(x->gm / pow(el.a_m, 3)) + k->delta_n_radps) * dt;
    k->omega0_rad = el.raan_rad + x->earth_rate * k->toe_sow_s - k->omega_dot_radps * dt;
    return ORR_OK;
}

static double lsb(const problem *q, size_t j) { return q->l->element[j].lsb; }

static orr_status gauss_newton(problem *q, orr_nav_eph *e)
{
    orr_nav_kepler *k = &e->kepler;
    double moved = HUGE_VAL;
    for (int it = 0; it < ITERATIONS && moved > CONVERGED_M; it++) {
        double x[N], p[N], sum = 0;
        orr_kepler_lattice_values(q->l, k, p);
        linearise(q, e);
        for (size_t j = 0; j < q->n; j++)
            if (guide[j].usual > 0) (void)pull(q, j, q->weight_m[j], guide[j].usual, q->target[j] - p[j]);
        double tau[N];
        orr_status s = orr_least_squares(q->A, q->rows, q->n, q->b, tau, x);
        if (s != ORR_OK) return s;
        for (size_t j = 0; j < q->n; j++) sum += q->b[j] * q->b[j];
        moved = sqrt(sum / (double)q->w->n);
        double ex = k->e * cos(k->omega_rad) + x[ORR_KEPLER_EX] * lsb(q, E);
        double ey = k->e * sin(k->omega_rad) + x[ORR_KEPLER_EY] * lsb(q, OMEGA);
        double lambda = k->omega_rad + k->m0_rad + x[ORR_KEPLER_LAMBDA] * lsb(q, M0);
        for (size_t j = 0; j < q->n; j++) p[j] += x[j] * lsb(q, j);
        p[E] = hypot(ex, ey);
        p[OMEGA] = atan2(ey, ex);
        p[M0] = lambda - p[OMEGA];
        from_array(q->l, p, k);
        if (!(k->e < 0.9) || !(k->sqrt_a_sqrtm > 2500 && k->sqrt_a_sqrtm < 3e4)) return ORR_E_NUMERIC;
    }
    return moved <= CONVERGED_M ? ORR_OK : ORR_E_NUMERIC;
}

// How far from its base a field reaches.
static double field_end(const problem *q, size_t j)
{
    return ldexp(q->l->element[j].lsb, q->l->element[j].bits - 1);
}

// A rate or harmonic that its field cannot hold is kept within, whatever the orbit wants; the others make up
// for it as they can. Returns whether there was one.
static bool hold_in_fields(problem *q, const orr_nav_kepler *k)
{
    bool any = false;
    double p[N];
    orr_kepler_lattice_values(q->l, k, p);
    for (size_t j = 0; j < q->n; j++) {
        const double top = 0.95 * field_end(q, j), off = p[j] - q->l->element[j].base;
        if (!(guide[j].usual > 0) || fabs(off) <= top || q->weight_m[j] > PULL_M) continue;
        q->target[j] = q->l->element[j].base + copysign(top, off);
        q->weight_m[j] = HOLD_M;
        any = true;
    }
    return any;
}

// The triangle that the last step left, by the elements that are sent in the place of their regular combinations, as rows of q->A;
// q->b: what they say of the way from the parameters p to the fitted ones.
static void by_elements(problem *q, const orr_nav_kepler *k, const double fitted[N], const double p[N])
{
    const double cw = cos(k->omega_rad), sw = sin(k->omega_rad), e = k->e, by_e = lsb(q, E) / lsb(q, OMEGA),
                 by_m = lsb(q, OMEGA) / lsb(q, M0);
    for (size_t i = 0; i < q->n; i++) {
        double *row = &q->A[i * q->n];
        for (size_t j = 0; j < i; j++) row[j] = 0;
        const double ex = row[E], ey = row[OMEGA], lambda = row[M0];
        row[E] = cw * ex + sw * by_e * ey;
        row[OMEGA] = e * (cw * ey - sw / by_e * ex) + by_m * lambda;
        q->b[i] = 0;
        for (size_t j = 0; j < q->n; j++) q->b[i] += row[j] * (fitted[j] - p[j]) / lsb(q, j);
    }
    q->rows = q->n;
}

// The nearest lattice point by the linear model of the last step, about the parameters rounded one by one.
static orr_status to_lattice(problem *q, orr_nav_eph *e, orr_diag *diag)
{
    double fitted[N], p[N], whole[N], R[N * N], z[N];
    orr_kepler_lattice_values(q->l, &e->kepler, fitted);
    for (size_t j = 0; j < q->n; j++) {
        whole[j] = orr_navfit_whole(&q->l->element[j], fitted[j]);
        p[j] = q->l->element[j].base + whole[j] * lsb(q, j);
    }
    by_elements(q, &e->kepler, fitted, p);
    for (size_t j = 0; j < q->n; j++) {
        double by = fitted[j] - p[j], reach = guide[j].reach;
        if (j == ORR_KEPLER_SQRT_A && q->l->sends_a) reach *= A_PER_ROOT;
        if (guide[j].usual > 0) {
            const double off = fabs(fitted[j] - q->l->element[j].base);
            reach = fmin(reach, fmax(field_end(q, j) - off, 0) / 20);
        }
        if (j == M0) by += fitted[OMEGA] - p[OMEGA]; // what acts is their sum
        double *row = pull(q, j, fmax(REACH_M, q->weight_m[j]), reach, by);
        if (j == M0) row[OMEGA] = row[M0];
    }
    double tau[N];
    orr_status s = orr_least_squares(q->A, q->rows, q->n, q->b, tau, NULL);
    if (s != ORR_OK) return s;
    memcpy(R, q->A, q->n * q->n * sizeof *R);
    s = orr_lattice_closest(q->n, R, q->b, SEARCH_NODES, z);
    if (s != ORR_OK) return s;
    for (size_t j = 0; j < q->n; j++) whole[j] += z[j];
    if (whole[E] < 0) { // the same ellipse from its other end
        const double half_turn = round(ORR_PI / lsb(q, OMEGA));
        whole[E] = -whole[E];
        whole[OMEGA] += half_turn, whole[M0] -= half_turn;
    }
    for (size_t j = 0; j < q->n; j++) {
        s = orr_navfit_to_field(&q->l->element[j], whole[j], &p[j], diag);
        if (s != ORR_OK) return s;
    }
    from_array(q->l, p, &e->kepler);
    return ORR_OK;
}

// How far the model is from the window.
static double rms_of(const problem *q, const orr_nav_eph *e)
{
    double sum = 0;
    for (size_t i = 0; i < q->w->n; i++) {
        const double tk = orr_time_diff_s(q->w->t[i], e->toe);
        const orr_vec3 d = orr_vec3_sub(q->w->pos[i], orr_kepler_position(&q->axes, &e->kepler, tk, NULL));
        sum += orr_vec3_dot(d, d);
    }
    return sqrt(sum / (double)q->w->n);
}

static orr_status begin(orr_sat sat, uint8_t message, orr_time toe, const orr_kepler_lattice *l,
                        orr_nav_eph *e, orr_diag *diag)
{
    int32_t week;
    const int64_t sow_ns = orr_nav_seconds_of_week(sat, toe, &week);
    if (sow_ns % ((int64_t)l->toe.lsb * ORR_NS_PER_S) != 0)
        return orr_diag_set(diag, ORR_E_ARG, "toe is transmitted in steps of %.0f s of the week", l->toe.lsb);
    *e = orr_navfit_blank(sat, ORR_NAV_KEPLER, message, toe, week);
    e->kepler.toe_sow_s = (double)sow_ns * 1e-9;
    e->kepler.top_sow_s = (double)NAN;
    return ORR_OK;
}

orr_status orr_navfit_kepler(orr_sat sat, orr_nav_message message, orr_time toe, orr_time from, orr_time to,
                             orr_navfit_source source, void *user, orr_nav_eph *eph,
                             orr_navfit_report *report, orr_diag *diag)
{
    problem q;
    orr_nav_eph e;
    q.l = orr_kepler_lattice_of(sat, (uint8_t)message);
    if (q.l == NULL || (orr_nav_messages_of(orr_sat_system(sat)) & UINT32_C(1) << message) == 0)
        return orr_diag_set(diag, ORR_E_ARG, "%s satellites send no Kepler elements in a message %s",
                            orr_system_name(orr_sat_system(sat)), orr_nav_message_name(message));
    orr_status s = orr_navfit_check_window(toe, from, to, 1800, 21600, diag);
    if (s == ORR_OK) s = begin(sat, (uint8_t)message, toe, q.l, &e, diag);
    if (s != ORR_OK) return s;
    orr_navfit_window w, tilted;
    // A model with rates errs most at the ends of its window: it is judged by the whole window only where instants are close.
    const double step_s = q.l->n > ORR_KEPLER_A_DOT ? fmax(100, orr_time_diff_s(to, from) / 120) : 300;
    s = orr_navfit_gather(from, to, step_s, source, user, &w, diag);
    if (s != ORR_OK) return s;
    q.n = q.l->n;
    q.axes = orr_kepler_axes_of(sat, (uint8_t)message);
    q.w = &w;
    if (message == ORR_NAV_D2) {
        tilted = w;
        for (size_t i = 0; i < w.n; i++)
            tilted.pos[i] = orr_kepler_tilted(&q.axes, orr_time_diff_s(w.t[i], toe), w.pos[i]);
        q.w = &tilted;
    }
    s = first_guess(&q, &e);
    orr_kepler_lattice_values(q.l, &e.kepler, q.target);
    for (size_t j = 0; j < q.n; j++) q.weight_m[j] = PULL_M;
    do {
        if (s == ORR_OK) s = gauss_newton(&q, &e);
    } while (s == ORR_OK && hold_in_fields(&q, &e.kepler));
    if (s == ORR_OK) report->fit_rms_m = rms_of(&q, &e);
    if (s == ORR_OK) s = to_lattice(&q, &e, diag);
    if (s == ORR_E_RANGE) return s;
    if (s == ORR_OK) s = orr_navfit_judge(&e, &w, &report->rms_m, &report->max_m);
    if (s != ORR_OK)
        return orr_diag_set(diag, s, "the orbit over the window cannot be fitted by Kepler elements");
    report->n = w.n;
    *eph = e;
    return ORR_OK;
}

orr_status orr_navfit_mean(orr_time t, orr_time from, orr_time to, orr_navfit_source source, void *user,
                           orr_mean_elements *out, orr_diag *diag)
{
    // GPS' fields serve as units alone: nothing is held within them, nothing rounded.
    problem q = {.l = orr_kepler_lattice_of(orr_sat_make('G', 1), ORR_NAV_LNAV),
                 .axes = {ORR_EGM96_GM, ORR_EARTH_RATE_RADPS, ORR_EARTH_RATE_RADPS}};
    orr_navfit_window w;
    orr_nav_eph e = orr_navfit_blank(orr_sat_make('G', 1), ORR_NAV_KEPLER, ORR_NAV_LNAV, t, 0);
    orr_status s = orr_navfit_check_window(t, from, to, 1800, 2 * ORR_S_PER_DAY, diag);
    if (s == ORR_OK)
        s = orr_navfit_gather(from, to, fmax(300, orr_time_diff_s(to, from) / (ORR_NAVFIT_POSITIONS - 1)),
                              source, user, &w, diag);
    if (s != ORR_OK) return s;
    q.n = q.l->n;
    q.w = &w;
    e.kepler.toe_sow_s = 0; // the node is counted from the instant itself
    s = first_guess(&q, &e);
    orr_kepler_lattice_values(q.l, &e.kepler, q.target);
    for (size_t j = 0; j < q.n; j++) q.weight_m[j] = PULL_M;
    if (s == ORR_OK) s = gauss_newton(&q, &e);
    if (s != ORR_OK)
        return orr_diag_set(diag, s, "the orbit over the span cannot be fitted by mean elements");
    const orr_nav_kepler *k = &e.kepler;
    const double nu = orr_kepler_true_anomaly(k->m0_rad, k->e);
    *out = (orr_mean_elements){.k = {.a_m = k->sqrt_a_sqrtm * k->sqrt_a_sqrtm,
                                     .e = k->e,
                                     .i_rad = k->i0_rad,
                                     .raan_rad = orr_kepler_turn(k->omega0_rad),
                                     .argp_rad = orr_kepler_turn(k->omega_rad),
                                     .m_rad = orr_kepler_turn(k->m0_rad),
                                     .u_rad = orr_kepler_turn(k->omega_rad + nu)},
                               .delta_n_radps = k->delta_n_radps,
                               .idot_radps = k->idot_radps,
                               .raan_dot_radps = k->omega_dot_radps,
                               .crc_m = k->crc_m,
                               .crs_m = k->crs_m,
                               .cuc_rad = k->cuc_rad,
                               .cus_rad = k->cus_rad,
                               .cic_rad = k->cic_rad,
                               .cis_rad = k->cis_rad,
                               .rms_m = rms_of(&q, &e)};
    return ORR_OK;
}
