// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/almanac_kepler.h"
#include "core/linalg.h"

#include <string.h>

#include "orbit/force/kepler.h"
#include "orbit/navdata/kepler_model.h"
#include "orbit/navdata/navfit_private.h"
#include "orbit/navdata/system_week.h"

#define STEP_S 750.0 // nine positions in two hours
#define LEAST_S 7200.0
#define MOST_S 93600.0
#define ITERATIONS 20
#define CONVERGED_M 1e-3
#define SEARCH_NODES 1000
#define N 7
#define GALILEO_SQRT_A 5440.588203494177 // of 29 600 km

// OMEGADOT from a few hours is noise: a deviation of PULL_RADPS from what the Earth's flattening causes costs
// as much as PULL_M in one coordinate, which a day of positions outweighs.
#define PULL_M 1000.0
#define PULL_RADPS 1e-9

static const size_t column[N] = {ORR_KEPLER_SQRT_A, ORR_KEPLER_EX,     ORR_KEPLER_EY,       ORR_KEPLER_LAMBDA,
                                 ORR_KEPLER_I0,     ORR_KEPLER_OMEGA0, ORR_KEPLER_OMEGA_DOT}; // of the model
struct orr_almanac_lattice {
    char system;
    int most; // numbers of satellites: 1 to so many
    int toa_step_s;
    double i_reference;
    orr_navfit_field field[N], af0, af1;
};

// IS-QZSS-PNT-005, 4.1.2.6: as GPS', but e is sent as what it has above that of the inclined orbits.
#define QZSS_FIELDS(e_reference)                                                                             \
    {ORR_UNSIGNED("sqrt(A)", P2(11), 24),                                                                    \
     {"e", P2(21), 16, ORR_FIELD_UNSIGNED, e_reference},                                                     \
     ORR_ANGLE("omega", 23, 24),                                                                             \
     ORR_ANGLE("M0", 23, 24),                                                                                \
     ORR_SIGNED("delta i", SEMICIRCLE * P2(19), 16),                                                         \
     ORR_ANGLE("OMEGA0", 23, 24),                                                                            \
     ORR_SIGNED("OMEGADOT", SEMICIRCLE * P2(38), 16)},                                                       \
        ORR_SIGNED("af0", P2(20), 11), ORR_SIGNED("af1", P2(38), 11)

// IS-GPS-200N table 20-VI; Galileo OS SIS ICD 2.1, table 85; BDS-SIS-ICD-B1I 3.0, table 5-14; IRNSS SIS ICD for SPS 1.1,
// table 20.
static const orr_almanac_lattice lattices[] = {
    {'G',
     32,
     4096,
     0.30 * ORR_PI,
     {ORR_UNSIGNED("sqrt(A)", P2(11), 24), ORR_UNSIGNED("e", P2(21), 16), ORR_ANGLE("omega", 23, 24),
      ORR_ANGLE("M0", 23, 24), ORR_SIGNED("delta i", SEMICIRCLE *P2(19), 16), ORR_ANGLE("OMEGA0", 23, 24),
      ORR_SIGNED("OMEGADOT", SEMICIRCLE *P2(38), 16)},
     ORR_SIGNED("af0", P2(20), 11),
     ORR_SIGNED("af1", P2(38), 11)},
    {'E',
     36,
     600,
     56 * ORR_RAD_PER_DEG,
     {{"sqrt(A)", P2(9), 13, ORR_FIELD_SIGNED, GALILEO_SQRT_A},
      ORR_UNSIGNED("e", P2(16), 11),
      ORR_ANGLE("omega", 15, 16),
      ORR_ANGLE("M0", 15, 16),
      ORR_SIGNED("delta i", SEMICIRCLE *P2(14), 11),
      ORR_ANGLE("OMEGA0", 15, 16),
      ORR_SIGNED("OMEGADOT", SEMICIRCLE *P2(33), 11)},
     ORR_SIGNED("af0", P2(19), 16),
     ORR_SIGNED("af1", P2(38), 13)},
    {'C',
     63,
     4096,
     0.30 * ORR_PI,
     {ORR_UNSIGNED("sqrt(A)", P2(11), 24), ORR_UNSIGNED("e", P2(21), 17), ORR_ANGLE("omega", 23, 24),
      ORR_ANGLE("M0", 23, 24), ORR_SIGNED("delta i", SEMICIRCLE *P2(19), 16), ORR_ANGLE("OMEGA0", 23, 24),
      ORR_SIGNED("OMEGADOT", SEMICIRCLE *P2(38), 17)},
     ORR_SIGNED("a0", P2(20), 11),
     ORR_SIGNED("a1", P2(38), 11)},
    {'I',
     14,
     16,
     0,
     {ORR_UNSIGNED("sqrt(A)", P2(11), 24), ORR_UNSIGNED("e", P2(21), 16), ORR_ANGLE("omega", 23, 24),
      ORR_ANGLE("M0", 23, 24), ORR_ANGLE("i", 23, 24), ORR_ANGLE("OMEGA0", 23, 24),
      ORR_SIGNED("OMEGADOT", SEMICIRCLE *P2(38), 16)},
     ORR_SIGNED("af0", P2(20), 11),
     ORR_SIGNED("af1", P2(38), 11)},
    {'J', 10, 4096, 0.25 * ORR_PI, QZSS_FIELDS(0.06)},
};
// Those of geostationary satellites, which differ from references of zero.
static const orr_almanac_lattice qzss_geo = {'J', 10, 4096, 0, QZSS_FIELDS(0)};

// J07, J08 and J09 (IS-QZSS-PNT-005, table 3.2.1-1).
static bool is_qzss_geo(orr_sat sat)
{
    return orr_sat_system(sat) == 'J' && orr_sat_number(sat) >= 7 && orr_sat_number(sat) <= 9;
}

const orr_almanac_lattice *orr_almanac_lattice_of(orr_sat sat)
{
    if (is_qzss_geo(sat)) return &qzss_geo;
    for (size_t k = 0; k < sizeof lattices / sizeof *lattices; k++)
        if (lattices[k].system == orr_sat_system(sat) && orr_sat_number(sat) <= lattices[k].most)
            return &lattices[k];
    return NULL;
}

const orr_navfit_field *orr_almanac_field(const orr_almanac_lattice *l, orr_almanac_part part)
{
    return part == ORR_ALMANAC_AF0 ? &l->af0 : part == ORR_ALMANAC_AF1 ? &l->af1 : &l->field[part];
}

enum {
    SQRT_A = ORR_ALMANAC_SQRT_A,
    E = ORR_ALMANAC_E,
    OMEGA = ORR_ALMANAC_OMEGA,
    M0 = ORR_ALMANAC_M0,
    DELTA_I = ORR_ALMANAC_DELTA_I,
    OMEGA0 = ORR_ALMANAC_OMEGA0,
    OMEGA_DOT = ORR_ALMANAC_OMEGA_DOT
};

void orr_almanac_values(const orr_almanac *a, double value[ORR_ALMANAC_PARTS])
{
    value[SQRT_A] = a->sqrt_a_sqrtm, value[E] = a->e, value[OMEGA] = a->omega_rad, value[M0] = a->m0_rad;
    value[DELTA_I] = a->i_offset_rad, value[OMEGA0] = a->omega0_rad, value[OMEGA_DOT] = a->omega_dot_radps;
    value[ORR_ALMANAC_AF0] = a->af0_s, value[ORR_ALMANAC_AF1] = a->af1_sps;
}

int orr_almanac_toa_step_s(const orr_almanac_lattice *l) { return l->toa_step_s; }

static double reference_of(const orr_almanac_lattice *l, orr_sat sat)
{
    return orr_nav_beidou_geo(sat) ? 0 : l->i_reference;
}

double orr_almanac_inclination(orr_sat sat, const orr_almanac *a)
{
    return reference_of(orr_almanac_lattice_of(sat), sat) + a->i_offset_rad;
}

typedef struct problem {
    const orr_navfit_window *w;
    const orr_almanac_lattice *l;
    orr_kepler_axes axes;
    double i_reference;
    orr_time toa;
    double theory_radps; // of OMEGADOT
    size_t rows;
    double A[ORR_NAVFIT_ROWS * N], b[ORR_NAVFIT_ROWS];
} problem;

static void to_array(const problem *q, const orr_nav_kepler *k, double p[N])
{
    p[SQRT_A] = k->sqrt_a_sqrtm, p[E] = k->e, p[OMEGA] = k->omega_rad, p[M0] = k->m0_rad;
    p[DELTA_I] = k->i0_rad - q->i_reference, p[OMEGA0] = k->omega0_rad, p[OMEGA_DOT] = k->omega_dot_radps;
}

static void from_array(const problem *q, const double p[N], orr_nav_kepler *k)
{
    k->sqrt_a_sqrtm = p[SQRT_A], k->e = p[E], k->omega_rad = p[OMEGA], k->m0_rad = p[M0];
    k->i0_rad = q->i_reference + p[DELTA_I], k->omega0_rad = p[OMEGA0], k->omega_dot_radps = p[OMEGA_DOT];
}

static void fill_rows(const problem *q, double *row, const orr_vec3 d[ORR_KEPLER_N])
{
    for (size_t j = 0; j < N; j++) {
        const orr_vec3 c = orr_vec3_scale(q->l->field[j].lsb, d[column[j]]);
        row[j] = c.x, row[N + j] = c.y, row[2 * N + j] = c.z;
    }
}

static void linearise(problem *q, const orr_nav_kepler *k)
{
    for (size_t i = 0; i < q->w->n; i++) {
        orr_vec3 d[ORR_KEPLER_N];
        orr_vec3 r = orr_vec3_sub(q->w->pos[i],
                                  orr_kepler_position(&q->axes, k, orr_time_diff_s(q->w->t[i], q->toa), d));
        fill_rows(q, &q->A[3 * i * N], d);
        q->b[3 * i] = r.x, q->b[3 * i + 1] = r.y, q->b[3 * i + 2] = r.z;
    }
    q->rows = 3 * q->w->n + 1;
    double *row = &q->A[(q->rows - 1) * N];
    memset(row, 0, N * sizeof *row);
    row[OMEGA_DOT] = PULL_M / PULL_RADPS * q->l->field[OMEGA_DOT].lsb;
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
static void without_short_period(const problem *q, orr_nav_kepler *k)
{
    double s = k->sqrt_a_sqrtm, n = sqrt(q->axes.gm) / (s * s * s) + k->delta_n_radps;
    k->sqrt_a_sqrtm = cbrt(sqrt(q->axes.gm) / n);
    k->crc_m = k->cus_rad = k->delta_n_radps = 0;
}

static orr_status first_guess(problem *q, orr_nav_kepler *k)
{
    orr_vec3 r, v;
    size_t mid = orr_navfit_middle(q->w, q->toa, q->axes.earth_rate, &r, &v);
    orr_kepler el;
    orr_status s = orr_kepler_from_state(r, v, q->axes.gm, &el);
    if (s != ORR_OK) return s;
    double dt = orr_time_diff_s(q->w->t[mid], q->toa), delta_n;
    orr_kepler_secular(el.a_m, el.e, el.i_rad, &q->theory_radps, &delta_n);
    short_period(el.a_m, el.i_rad, delta_n, k);
    k->sqrt_a_sqrtm = sqrt(el.a_m);
    k->e = el.e;
    k->i0_rad = el.i_rad;
    k->omega_dot_radps = q->theory_radps;
    k->omega_rad = el.argp_rad;
    k->m0_rad = el.m_rad - sqrt(q->axes.gm / pow(el.a_m, 3)) * dt;
    k->omega0_rad = el.raan_rad + q->axes.earth_rate * k->toe_sow_s - k->omega_dot_radps * dt;
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
            x[j] *= q->l->field[j].lsb;
        }
        moved = sqrt(sum / (double)q->w->n);
        double ex = k->e * cos(k->omega_rad) + x[E], ey = k->e * sin(k->omega_rad) + x[OMEGA];
        double lambda = k->omega_rad + k->m0_rad + x[M0];
        to_array(q, k, p);
        for (size_t j = 0; j < N; j++) p[j] += x[j];
        p[E] = hypot(ex, ey);
        p[OMEGA] = atan2(ey, ex);
        p[M0] = lambda - p[OMEGA];
        from_array(q, p, k);
        if (!(k->e < 0.9) || !(k->sqrt_a_sqrtm > 2500 && k->sqrt_a_sqrtm < 3e4)) return ORR_E_NUMERIC;
    }
    return moved <= 1 ? ORR_OK : ORR_E_NUMERIC;
}

// The lattice point whose orbit is nearest to the solution's over a day about toa.
static orr_status to_lattice(problem *q, orr_nav_kepler *k, orr_diag *diag)
{
    double fitted[N], p[N], whole[N], R[N * N], z[N];
    to_array(q, k, fitted);
    for (size_t j = 0; j < N; j++) {
        whole[j] = orr_navfit_whole(&q->l->field[j], fitted[j]);
        p[j] = q->l->field[j].base + whole[j] * q->l->field[j].lsb;
    }
    from_array(q, p, k);
    const int hours = 12;
    q->rows = 0;
    for (int h = -hours; h <= hours; h++) {
        orr_vec3 d[ORR_KEPLER_N];
        (void)orr_kepler_position(&q->axes, k, 3600.0 * h, d);
        orr_kepler_by_elements(k, d);
        fill_rows(q, &q->A[q->rows * N], d);
        for (int c = 0; c < 3; c++, q->rows++) {
            q->b[q->rows] = 0;
            for (size_t j = 0; j < N; j++)
                q->b[q->rows] += q->A[q->rows * N + j] * (fitted[j] - p[j]) / q->l->field[j].lsb;
        }
    }
    double tau[N];
    orr_status s = orr_least_squares(q->A, q->rows, N, q->b, tau, NULL);
    if (s != ORR_OK) return s;
    memcpy(R, q->A, sizeof R);
    s = orr_lattice_closest(N, R, q->b, SEARCH_NODES, z);
    for (size_t j = 0; j < N; j++) whole[j] += z[j];
    if (s == ORR_OK &&
        q->l->field[E].base + whole[E] * q->l->field[E].lsb < 0) { // the same ellipse from its other end
        const double half_turn = round(ORR_PI / q->l->field[OMEGA].lsb);
        whole[E] = -whole[E]; // references of e are far from zero, or zero
        whole[OMEGA] += half_turn, whole[M0] -= half_turn;
    }
    for (size_t j = 0; j < N && s == ORR_OK; j++)
        s = orr_navfit_to_field(&q->l->field[j], whole[j], &p[j], diag);
    if (s == ORR_OK) from_array(q, p, k);
    return s;
}

static void judge(const orr_nav_kepler *k, const problem *q, double *rms_m, double *max_m)
{
    double sum = 0, largest = 0;
    for (size_t i = 0; i < q->w->n; i++) {
        orr_vec3 pos = orr_kepler_position(&q->axes, k, orr_time_diff_s(q->w->t[i], q->toa), NULL);
        double d = orr_vec3_norm(orr_vec3_sub(q->w->pos[i], pos));
        sum += d * d;
        if (d > largest) largest = d;
    }
    *rms_m = sqrt(sum / (double)q->w->n);
    if (max_m != NULL) *max_m = largest;
}

static orr_status check(orr_sat sat, orr_time toa, orr_time from, orr_time to, double *toa_s, orr_diag *diag)
{
    const orr_almanac_lattice *l = orr_almanac_lattice_of(sat);
    if (l == NULL)
        return orr_diag_set(
            diag, ORR_E_ARG,
            "almanacs are of GPS 1 to 32, Galileo 1 to 36, BeiDou 1 to 63, QZSS 1 to 10 and NavIC 1 to 14");
    const int64_t ns = orr_nav_seconds_of_week(sat, toa, NULL);
    *toa_s = (double)(ns / ORR_NS_PER_S);
    double length_s = orr_time_diff_s(to, from);
    if (ns % (l->toa_step_s * ORR_NS_PER_S) != 0)
        return orr_diag_set(diag, ORR_E_ARG, "toa is transmitted in steps of %d s of the week",
                            l->toa_step_s);
    if (!(length_s >= LEAST_S && length_s <= MOST_S))
        return orr_diag_set(diag, ORR_E_ARG, "an almanac's window of %g s is not in %g..%g s", length_s,
                            LEAST_S, MOST_S);
    if (orr_time_diff_s(from, toa) > ORR_S_PER_WEEK / 2.0 || orr_time_diff_s(toa, to) > ORR_S_PER_WEEK / 2.0)
        return orr_diag_set(diag, ORR_E_ARG, "toa is further than half a week from the almanac's window");
    return ORR_OK;
}

orr_status orr_almanac_fit(orr_sat sat, orr_time toa, orr_time from, orr_time to, orr_navfit_source source,
                           void *user, orr_almanac *almanac, orr_navfit_report *report, orr_diag *diag)
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
    q.w = &w, q.toa = toa, q.l = orr_almanac_lattice_of(sat);
    q.axes = orr_kepler_axes_of(sat, ORR_NAV_NONE);
    q.i_reference = reference_of(q.l, sat);
    s = first_guess(&q, &k);
    if (s == ORR_OK) s = gauss_newton(&q, &k);
    if (s != ORR_OK) return orr_diag_set(diag, s, "the orbit over the window cannot be fitted by an almanac");
    without_short_period(&q, &k);
    judge(&k, &q, &report->fit_rms_m, NULL);
    s = to_lattice(&q, &k, diag);
    if (s != ORR_OK) return s;
    judge(&k, &q, &report->rms_m, &report->max_m);
    report->n = w.n;
    *almanac = (orr_almanac){.number = orr_sat_number(sat),
                             .e = k.e,
                             .toa_s = k.toe_sow_s,
                             .i_offset_rad = k.i0_rad - q.i_reference,
                             .omega_dot_radps = k.omega_dot_radps,
                             .sqrt_a_sqrtm = k.sqrt_a_sqrtm,
                             .omega0_rad = k.omega0_rad,
                             .omega_rad = k.omega_rad,
                             .m0_rad = k.m0_rad};
    return ORR_OK;
}

orr_status orr_almanac_clock(const orr_ephemeris *e, orr_sat sat, orr_time toa, orr_time from, orr_time to,
                             orr_almanac *almanac, double *rms_s, orr_diag *diag)
{
    const orr_almanac_lattice *l = orr_almanac_lattice_of(sat);
    orr_navfit_line line;
    if (l == NULL) return orr_diag_set(diag, ORR_E_ARG, "the satellite has no almanac");
    orr_status s = orr_navfit_clock_line(e, sat, toa, from, to, false, &line, diag);
    if (s == ORR_OK)
        s = orr_navfit_to_field(&l->af1, orr_navfit_whole(&l->af1, line.slope), &almanac->af1_sps, diag);
    if (s != ORR_OK) return s;
    // The mean of the window is kept, whatever the slope became; then rounded.
    double value = line.mean - almanac->af1_sps * line.mean_dt_s;
    s = orr_navfit_to_field(&l->af0, orr_navfit_whole(&l->af0, value), &almanac->af0_s, diag);
    if (s == ORR_OK && rms_s != NULL) *rms_s = orr_navfit_line_rms(&line, almanac->af0_s, almanac->af1_sps);
    return s;
}
