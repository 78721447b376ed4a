// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/almanac_glonass.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_linalg.h>

#include "core/astro.h"
#include "orbit/navdata/glonass_time.h"

#define STEP_S 900
#define MAX_POSITIONS (ORR_S_PER_DAY / STEP_S + 1)
#define MIN_POSITIONS (MAX_POSITIONS / 2)
#define ITERATIONS 12
#define USUAL_PERIOD_S 40544.0 // draconic; the fit starts from it
#define MEAN_PERIOD_S 43200.0
#define USUAL_DELTA_I_RAD (1.8 * ORR_RAD_PER_DEG)
#define WORST_RMS_M 20e3 // the algorithm's own jump leaves 1 km

typedef struct day_positions {
    size_t n;
    orr_time start; // that t_lambda counts from
    orr_time t[MAX_POSITIONS];
    orr_vec3 pos[MAX_POSITIONS];
} day_positions;

// What is solved for, in the order of rounding. h and l stand for e and omega, which a round orbit does not
// have.
// Every step squares the distance over the orbit's size: of 30 m less than a millimetre is left.
#define CONVERGED_M 30.0

enum { T_LAMBDA, LAMBDA, DELTA_I, DELTA_T, H, L, UNKNOWNS };
static const double step[UNKNOWNS] = {1e-2, 1e-6, 1e-6, 1e-2, 1e-6, 1e-6}; // some 40 m each
static const double lsb[H] = {ORR_GLONASS_ALM_T_LAMBDA_LSB_S, ORR_GLONASS_ALM_ANGLE_LSB_RAD,
                              ORR_GLONASS_ALM_ANGLE_LSB_RAD, ORR_GLONASS_ALM_DELTA_T_LSB_S};

static void take(const double x[UNKNOWNS], orr_glonass_almanac *a)
{
    a->t_lambda_s = x[T_LAMBDA], a->lambda_rad = x[LAMBDA];
    a->delta_i_rad = x[DELTA_I], a->delta_t_s = x[DELTA_T];
    a->e = hypot(x[H], x[L]), a->omega_rad = atan2(x[H], x[L]);
}

static orr_status residuals(const orr_glonass_almanac *a, const day_positions *p, double *out, double *rms_m,
                            double *max_m)
{
    double sum = 0, largest = 0;
    for (size_t i = 0; i < p->n; i++) {
        orr_vec3 r, v;
        orr_status s = orr_glonass_almanac_eval(a, p->t[i], &r, &v);
        if (s != ORR_OK) return s;
        orr_vec3 d = orr_vec3_sub(p->pos[i], r);
        if (out != NULL) out[3 * i] = d.x, out[3 * i + 1] = d.y, out[3 * i + 2] = d.z;
        double n2 = orr_vec3_dot(d, d);
        sum += n2;
        if (n2 > largest) largest = n2;
    }
    if (rms_m != NULL) *rms_m = sqrt(sum / (double)p->n);
    if (max_m != NULL) *max_m = sqrt(largest);
    return ORR_OK;
}

// One Gauss-Newton step in the unknowns from `first` on; *moved_m is its size in the positions.
static orr_status gauss_newton(double x[UNKNOWNS], int first, orr_glonass_almanac *a, const day_positions *p,
                               double *moved_m)
{
    const size_t rows = 3 * p->n, n = (size_t)(UNKNOWNS - first);
    double b[3 * MAX_POSITIONS], plus[3 * MAX_POSITIONS], minus[3 * MAX_POSITIONS];
    double design[3 * MAX_POSITIONS * UNKNOWNS], right[UNKNOWNS * UNKNOWNS], s[UNKNOWNS], work[UNKNOWNS];
    double dx[UNKNOWNS], scale[UNKNOWNS];
    take(x, a);
    orr_status status = residuals(a, p, b, NULL, NULL);
    for (size_t k = 0; k < n && status == ORR_OK; k++) {
        double *moved = &x[(size_t)first + k], at = *moved, length = 0, h = step[(size_t)first + k];
        *moved = at + h, take(x, a);
        status = residuals(a, p, plus, NULL, NULL);
        *moved = at - h, take(x, a);
        if (status == ORR_OK) status = residuals(a, p, minus, NULL, NULL);
        *moved = at;
        if (status != ORR_OK) return status;
        for (size_t i = 0; i < rows; i++) {
            plus[i] = (minus[i] - plus[i]) / (2 * h);
            length += plus[i] * plus[i];
        }
        scale[k] = length > 0 ? 1 / sqrt(length) : 1;
        for (size_t i = 0; i < rows; i++) design[i * n + k] = plus[i] * scale[k];
    }
    if (status != ORR_OK) return status;
    gsl_matrix_view A = gsl_matrix_view_array(design, rows, n), V = gsl_matrix_view_array(right, n, n);
    gsl_vector_view S = gsl_vector_view_array(s, n), W = gsl_vector_view_array(work, n);
    gsl_vector_view B = gsl_vector_view_array(b, rows), X = gsl_vector_view_array(dx, n);
    if (gsl_linalg_SV_decomp(&A.matrix, &V.matrix, &S.vector, &W.vector) != 0) return ORR_E_NUMERIC;
    for (size_t k = 0; k < n; k++)
        if (s[k] < 1e-9 * s[0]) s[k] = 0;
    if (gsl_linalg_SV_solve(&A.matrix, &V.matrix, &S.vector, &B.vector, &X.vector) != 0) return ORR_E_NUMERIC;
    *moved_m = gsl_blas_dnrm2(&X.vector) / sqrt((double)p->n);
    for (size_t k = 0; k < n; k++) x[(size_t)first + k] += dx[k] * scale[k];
    return ORR_OK;
}

static orr_status converge(double x[UNKNOWNS], int first, orr_glonass_almanac *a, const day_positions *p)
{
    double moved_m = 2 * CONVERGED_M;
    orr_status s = ORR_OK;
    for (int k = 0; k < ITERATIONS && s == ORR_OK && moved_m > CONVERGED_M; k++)
        s = gauss_newton(x, first, a, p, &moved_m);
    take(x, a);
    return s;
}

static orr_status gather(const orr_glonass_almanac *a, orr_navfit_source source, void *user, day_positions *p,
                         orr_diag *diag)
{
    p->n = 0;
    p->start =
        orr_time_add_s(orr_glonass_day(orr_time_add_s(a->day, 1.5 * ORR_S_PER_DAY), a->leap), -ORR_S_PER_DAY);
    for (int k = 0; k < MAX_POSITIONS; k++) {
        orr_time t = orr_time_add_s(p->start, (double)k * STEP_S);
        if (source(user, t, &p->pos[p->n]) == ORR_OK) p->t[p->n++] = t;
    }
    if (p->n >= MIN_POSITIONS) return ORR_OK;
    return orr_diag_set(diag, ORR_E_NODATA, "only %zu of the day's %d positions are in the orbit product",
                        p->n, MAX_POSITIONS);
}

// Longitude of the node moves back by about this much a revolution.
static double node_step_rad(double period_s) { return -ORR_EARTH_RATE_RADPS * period_s; }

// An ascending node between two neighbouring positions, taken back by whole revolutions to the day's first.
static bool first_guess(const day_positions *p, double x[UNKNOWNS])
{
    for (size_t i = 0; i + 1 < p->n; i++) {
        orr_vec3 r = p->pos[i], q = p->pos[i + 1];
        if (!(r.z < 0 && q.z >= 0) || orr_time_diff_s(p->t[i + 1], p->t[i]) > STEP_S + 1) continue;
        double part = r.z / (r.z - q.z), t_s = orr_time_diff_s(p->t[i], p->start) + part * STEP_S;
        orr_vec3 node = orr_vec3_axpy(part, orr_vec3_sub(q, r), r);
        double whole = floor(t_s / USUAL_PERIOD_S);
        x[T_LAMBDA] = t_s - whole * USUAL_PERIOD_S;
        x[LAMBDA] = atan2(node.y, node.x) - whole * node_step_rad(USUAL_PERIOD_S);
        x[DELTA_I] = USUAL_DELTA_I_RAD, x[DELTA_T] = USUAL_PERIOD_S - MEAN_PERIOD_S;
        x[H] = 0, x[L] = 0;
        return true;
    }
    return false;
}

// The fitted node may have slipped out of the day at its begin, or be the second.
static orr_status to_first_node(double x[UNKNOWNS], orr_glonass_almanac *a, const day_positions *p)
{
    double period_s = MEAN_PERIOD_S + x[DELTA_T], whole = floor(x[T_LAMBDA] / period_s);
    if (!(fabs(whole) > 0)) return ORR_OK;
    x[T_LAMBDA] -= whole * period_s;
    x[LAMBDA] -= whole * node_step_rad(period_s);
    return converge(x, 0, a, p);
}

static double on_lattice(int k, double value)
{
    if (k == T_LAMBDA && value < 0) value = 0;
    if (k == LAMBDA) value = remainder(value, 2 * ORR_PI);
    double whole = round(value / lsb[k]);
    if (k == LAMBDA && fabs(whole) > ORR_PI / lsb[k] - 0.5) whole -= copysign(1, whole); // no half turn
    return whole * lsb[k];
}

// Each word is fixed in turn, the rest make up for its rounding.
static orr_status quantise(double x[UNKNOWNS], orr_glonass_almanac *a, const day_positions *p)
{
    orr_status s = ORR_OK;
    for (int k = 0; k < H && s == ORR_OK; k++) {
        x[k] = on_lattice(k, x[k]);
        s = converge(x, k + 1, a, p);
    }
    a->e = round(a->e / ORR_GLONASS_ALM_E_LSB) * ORR_GLONASS_ALM_E_LSB;
    double whole = round(a->omega_rad / ORR_GLONASS_ALM_OMEGA_LSB_RAD);
    if (fabs(whole) > ORR_PI / ORR_GLONASS_ALM_OMEGA_LSB_RAD - 0.5) whole -= copysign(1, whole);
    a->omega_rad = whole * ORR_GLONASS_ALM_OMEGA_LSB_RAD;
    return s;
}

static orr_status fits_its_fields(const orr_glonass_almanac *a, orr_diag *diag)
{
    const struct {
        const char *name;
        double value, limit;
    } word[] = {{"delta i_n", a->delta_i_rad, 131072 * ORR_GLONASS_ALM_ANGLE_LSB_RAD},
                {"delta T_n", a->delta_t_s, 2097152 * ORR_GLONASS_ALM_DELTA_T_LSB_S},
                {"t_lambda_n", a->t_lambda_s, 2097152 * ORR_GLONASS_ALM_T_LAMBDA_LSB_S},
                {"epsilon_n", a->e, 32768 * ORR_GLONASS_ALM_E_LSB}};
    for (size_t k = 0; k < sizeof word / sizeof word[0]; k++)
        if (!(fabs(word[k].value) < word[k].limit))
            return orr_diag_set(diag, ORR_E_RANGE, "%s = %.10g of the almanac does not fit its field",
                                word[k].name, word[k].value);
    return ORR_OK;
}

orr_status orr_glonass_almanac_fit(orr_sat sat, orr_time day, const orr_leap_table *leap,
                                   orr_navfit_source source, void *user, orr_glonass_almanac *out,
                                   orr_navfit_report *report, orr_diag *diag)
{
    if (orr_sat_system(sat) != 'R' || orr_sat_number(sat) < 1 || orr_sat_number(sat) > 24)
        return orr_diag_set(diag, ORR_E_ARG, "GLONASS almanacs are of slots 1 to 24");
    orr_glonass_almanac a = {.number = orr_sat_number(sat),
                             .operational = true,
                             .type = 1,
                             .day = orr_glonass_day(day, leap),
                             .leap = leap};
    day_positions p;
    double x[UNKNOWNS];
    orr_status s = gather(&a, source, user, &p, diag);
    if (s != ORR_OK) return s;
    if (!first_guess(&p, x))
        return orr_diag_set(diag, ORR_E_NODATA, "no ascending node among the day's positions");
    s = converge(x, 0, &a, &p);
    if (s == ORR_OK) s = to_first_node(x, &a, &p);
    if (s == ORR_OK) s = residuals(&a, &p, NULL, &report->fit_rms_m, NULL);
    if (s == ORR_OK) s = quantise(x, &a, &p);
    if (s == ORR_OK) s = residuals(&a, &p, NULL, &report->rms_m, &report->max_m);
    if (s != ORR_OK || !(report->rms_m < WORST_RMS_M))
        return orr_diag_set(diag, ORR_E_NUMERIC,
                            "the orbit over the day cannot be fitted by a GLONASS almanac");
    report->n = p.n;
    s = fits_its_fields(&a, diag);
    if (s == ORR_OK) *out = a;
    return s;
}
