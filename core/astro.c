// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/astro.h"

#include <erfa.h>
#include <erfam.h>

#include "core/time_private.h"

#define MJD_ZERO 2400000.5 // JD of MJD 0: the first part of every two-part date here
#define MJD_J2000 51544.5

typedef struct days {
    double whole, fraction; // MJD
} days;

static days in_scale(orr_time t, orr_scale scale)
{
    int32_t mjd;
    double fraction;
    orr_time_mjd(t, scale, NULL, &mjd, &fraction);
    return (days){mjd, fraction};
}

// --- Earth orientation ---

// Slope at node i of a curve through (x, y): the mean of its two neighbours' chords weighted as a parabola
// through the three points has it there; the end chord at an end.
static double slope(const double *x, const double *y, int i, int n)
{
    if (i == 0) return (y[1] - y[0]) / (x[1] - x[0]);
    if (i == n - 1) return (y[i] - y[i - 1]) / (x[i] - x[i - 1]);
    double h0 = x[i] - x[i - 1], h1 = x[i + 1] - x[i];
    double d0 = (y[i] - y[i - 1]) / h0, d1 = (y[i + 1] - y[i]) / h1;
    return (h1 * d0 + h0 * d1) / (h0 + h1);
}

// Cubic Hermite on [x[k], x[k+1]] of up to four points: value and derivative. It has no kink at a node, as a
// chord has: a kink of the pole or of UT1 would pass into the velocity of every satellite.
static double hermite(const double *x, const double *y, int k, int n, double at, double *derivative)
{
    double h = x[k + 1] - x[k], u = (at - x[k]) / h;
    double m0 = h * slope(x, y, k, n), m1 = h * slope(x, y, k + 1, n), dy = y[k + 1] - y[k];
    double c2 = 3 * dy - 2 * m0 - m1, c3 = m0 + m1 - 2 * dy;
    *derivative = (m0 + u * (2 * c2 + u * 3 * c3)) / h;
    return y[k] + u * (m0 + u * (c2 + u * c3));
}

// TAI - UTC of a series' node: its labels are those of the built-in table.
static int leap_at_mjd(double mjd_utc)
{
    return orr_leap_of_day(orr_leap_builtin(), (int32_t)floor(mjd_utc));
}

// UT1 - TAI by the leap seconds alone, and its slope per day. A leap second is inserted when UT1 - UTC nears
// -0.6 s, so that UT1 crosses the middle of the step; between such instants it is a smooth curve. Three years
// after the last one UT1 - UTC is taken as 0. Right to 0.4 s, and above all without a step: UTC's own would
// turn the Earth by a second.
static double ut1_by_leaps(double tai_day, const orr_leap_table *leap, double *per_day)
{
    const double settled_days = 1096;
    const size_t n = leap->n;
    const double end = leap->entry[n - 1].mjd, settled = -leap->entry[n - 1].tai_minus_utc_s;
    *per_day = 0;
    if (n < 2 || tai_day >= end + settled_days) return settled;
    if (tai_day < leap->entry[1].mjd)
        return -(leap->entry[0].tai_minus_utc_s + leap->entry[1].tai_minus_utc_s) / 2.0;
    size_t k = 1;
    while (k + 1 < n && leap->entry[k + 1].mjd <= tai_day) k++;
    // Up to four points about the interval [k, k + 1], the place three years after the last step being one of
    // them.
    double x[4], y[4];
    int m = 0, at = 0;
    for (size_t i = k > 1 ? k - 1 : 1; i <= k + 2 && i <= n; i++) {
        if (i == k) at = m;
        x[m] = i < n ? leap->entry[i].mjd : end + settled_days;
        y[m++] =
            i < n ? -(leap->entry[i - 1].tai_minus_utc_s + leap->entry[i].tai_minus_utc_s) / 2.0 : settled;
    }
    if (k == n - 1) { // towards the settled place with a slope that ends there
        double h = x[at + 1] - x[at], u = (tai_day - x[at]) / h, m0 = h * slope(x, y, at, m),
               dy = y[at + 1] - y[at];
        double c2 = 3 * dy - 2 * m0, c3 = m0 - 2 * dy;
        *per_day = (m0 + u * (2 * c2 + u * 3 * c3)) / h;
        return y[at] + u * (m0 + u * (c2 + u * c3));
    }
    return hermite(x, y, at, m, tai_day, per_day);
}

// The Earth's orientation as far as it is known without measurements.
static orr_eop unmeasured(orr_time t, const orr_leap_table *leap)
{
    days tt = in_scale(t, ORR_SCALE_TT), tai = in_scale(t, ORR_SCALE_TAI);
    double years = (tt.whole - MJD_J2000 + tt.fraction) / 365.25, ut1_per_day;
    const double mas = ERFA_DAS2R * 1e-3, year_s = 365.25 * ORR_S_PER_DAY;
    double ut1_minus_tai_s = ut1_by_leaps(tai.whole + tai.fraction, leap, &ut1_per_day);
    return (orr_eop){.xp_rad = (55.0 + 1.677 * years) * mas,
                     .yp_rad = (320.5 + 3.460 * years) * mas,
                     .ut1_utc_s = ut1_minus_tai_s + orr_leap_tai_minus_utc(t, leap),
                     .lod_s = -ut1_per_day,
                     .xp_rate_radps = 1.677 * mas / year_s,
                     .yp_rate_radps = 3.460 * mas / year_s};
}

// The time of a series' node as days of TAI, in which neither the abscissa nor UT1 steps.
static double node_tai(const orr_eop_series *s, size_t i)
{
    return s->mjd_utc[i] + leap_at_mjd(s->mjd_utc[i]) / (double)ORR_S_PER_DAY;
}

// Daily values are a series; over a longer gap nobody knows what the pole did.
#define SERIES_GAP_DAYS 3.0

// Whether nodes i and i + 1 belong together.
static bool joined(const orr_eop_series *s, size_t i)
{
    return s->mjd_utc[i + 1] - s->mjd_utc[i] <= SERIES_GAP_DAYS + 1e-6;
}

// Between nodes lo and lo + 1; `at` in days of TAI.
static orr_eop inside_series(const orr_eop_series *s, size_t lo, double at, orr_time t,
                             const orr_leap_table *leap)
{
    size_t first = lo > 0 && joined(s, lo - 1) ? lo - 1 : lo;
    size_t last = lo + 2 < s->n && joined(s, lo + 1) ? lo + 2 : lo + 1;
    int n = (int)(last - first + 1), k = (int)(lo - first);
    double x[4], xp[4], yp[4], ut1[4];
    for (int i = 0; i < n; i++) {
        size_t j = first + (size_t)i;
        x[i] = node_tai(s, j);
        xp[i] = s->value[j].xp_rad;
        yp[i] = s->value[j].yp_rad;
        ut1[i] = s->value[j].ut1_utc_s - leap_at_mjd(s->mjd_utc[j]); // UT1 - TAI
    }
    orr_eop e;
    double ut1_per_day;
    e.xp_rad = hermite(x, xp, k, n, at, &e.xp_rate_radps);
    e.yp_rad = hermite(x, yp, k, n, at, &e.yp_rate_radps);
    e.ut1_utc_s = hermite(x, ut1, k, n, at, &ut1_per_day) + orr_leap_tai_minus_utc(t, leap);
    e.xp_rate_radps /= ORR_S_PER_DAY;
    e.yp_rate_radps /= ORR_S_PER_DAY;
    e.lod_s = -ut1_per_day;
    return e;
}

#define SLOPE_DECAY_DAYS 10.0

// Extrapolation beyond the series: the offset at its end is held, its slope decays with a time constant of
// ten days.
static double carried(double difference, double slope_difference, double dt, double *slope)
{
    double rest = exp(-fabs(dt) / SLOPE_DECAY_DAYS);
    *slope = slope_difference * rest;
    return difference + slope_difference * SLOPE_DECAY_DAYS * (1 - rest) * (dt < 0 ? -1 : 1);
}

// Node i, with the slopes of the side that it ends or begins; of a node that stands alone the secular ones.
static orr_eop at_node(const orr_eop_series *s, size_t i, orr_time t, const orr_leap_table *leap)
{
    if (i > 0 && joined(s, i - 1)) return inside_series(s, i - 1, node_tai(s, i), t, leap);
    if (i + 1 < s->n && joined(s, i)) return inside_series(s, i, node_tai(s, i), t, leap);
    orr_eop e = unmeasured(t, leap);
    e.xp_rad = s->value[i].xp_rad;
    e.yp_rad = s->value[i].yp_rad;
    e.ut1_utc_s = s->value[i].ut1_utc_s - leap_at_mjd(s->mjd_utc[i]) + orr_leap_tai_minus_utc(t, leap);
    return e;
}

// Beyond a series' end, dt days from it: no step and no kink.
static orr_eop beyond_series(const orr_eop *end, orr_time t_end, double dt, orr_time t,
                             const orr_leap_table *leap)
{
    const orr_eop base = unmeasured(t_end, leap);
    orr_eop e = unmeasured(t, leap);
    double slope;
    e.xp_rad += carried(end->xp_rad - base.xp_rad, (end->xp_rate_radps - base.xp_rate_radps) * ORR_S_PER_DAY,
                        dt, &slope);
    e.xp_rate_radps += slope / ORR_S_PER_DAY;
    e.yp_rad += carried(end->yp_rad - base.yp_rad, (end->yp_rate_radps - base.yp_rate_radps) * ORR_S_PER_DAY,
                        dt, &slope);
    e.yp_rate_radps += slope / ORR_S_PER_DAY;
    e.ut1_utc_s += carried(end->ut1_utc_s - base.ut1_utc_s, base.lod_s - end->lod_s, dt, &slope);
    e.lod_s -= slope;
    return e;
}

// What node i and nothing else says of t; `at` is t in days of TAI.
static orr_eop carried_from(const orr_eop_series *s, size_t i, double at, orr_time t,
                            const orr_leap_table *leap)
{
    const double x = node_tai(s, i);
    const orr_time t_node = orr_time_add_s(t, (x - at) * ORR_S_PER_DAY);
    const orr_eop node = at_node(s, i, t_node, leap);
    return beyond_series(&node, t_node, at - x, t, leap);
}

// Between two nodes that do not belong together: from what the one says of t to what the other does, without a step or
// a kink.
static orr_eop across_gap(const orr_eop_series *s, size_t lo, double at, orr_time t,
                          const orr_leap_table *leap)
{
    const orr_eop a = carried_from(s, lo, at, t, leap), b = carried_from(s, lo + 1, at, t, leap);
    const double h = node_tai(s, lo + 1) - node_tai(s, lo), u = (at - node_tai(s, lo)) / h;
    const double w = u * u * (3 - 2 * u), per_s = 6 * u * (1 - u) / (h * ORR_S_PER_DAY);
    orr_eop e;
    e.xp_rad = a.xp_rad + w * (b.xp_rad - a.xp_rad);
    e.yp_rad = a.yp_rad + w * (b.yp_rad - a.yp_rad);
    e.ut1_utc_s = a.ut1_utc_s + w * (b.ut1_utc_s - a.ut1_utc_s);
    e.xp_rate_radps =
        a.xp_rate_radps + w * (b.xp_rate_radps - a.xp_rate_radps) + per_s * (b.xp_rad - a.xp_rad);
    e.yp_rate_radps =
        a.yp_rate_radps + w * (b.yp_rate_radps - a.yp_rate_radps) + per_s * (b.yp_rad - a.yp_rad);
    e.lod_s = a.lod_s + w * (b.lod_s - a.lod_s) - per_s * ORR_S_PER_DAY * (b.ut1_utc_s - a.ut1_utc_s);
    return e;
}

orr_eop orr_eop_at(const orr_eop_series *s, orr_time t, const orr_leap_table *leap, bool *from_series)
{
    if (leap == NULL) leap = orr_leap_builtin();
    if (from_series != NULL) *from_series = false;
    if (s == NULL || s->n < 2) return unmeasured(t, leap);
    days tai = in_scale(t, ORR_SCALE_TAI);
    const double at = tai.whole + tai.fraction;
    size_t lo = 0, hi = s->n - 1;
    const double first = node_tai(s, 0), last = node_tai(s, hi);
    if (at < first || at > last) return carried_from(s, at < first ? 0 : hi, at, t, leap);
    while (hi - lo > 1) {
        size_t mid = lo + (hi - lo) / 2;
        if (at >= node_tai(s, mid))
            lo = mid;
        else
            hi = mid;
    }
    if (!joined(s, lo)) return across_gap(s, lo, at, t, leap);
    if (from_series != NULL) *from_series = true;
    return inside_series(s, lo, at, t, leap);
}

orr_eop orr_eop_node(const orr_eop_series *s, orr_time t, const orr_leap_table *leap)
{
    orr_eop e = orr_eop_at(s, t, leap, NULL);
    e.ut1_utc_s += orr_leap_tai_minus_utc(t, NULL) - orr_leap_tai_minus_utc(t, leap);
    return e;
}

// --- rotations ---

static orr_mat3 from_erfa(double m[3][3])
{
    orr_mat3 a;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) a.m[i][j] = m[i][j];
    return a;
}

// Bias, precession (IAU 2006) and nutation (IAU 2000B): GCRS to the true equator and equinox of date.
static void bias_precession_nutation(days tt, double rbpn[3][3])
{
    double dpsi, deps, epsa, rb[3][3], rp[3][3], rbp[3][3], rn[3][3];
    eraNut00b(MJD_ZERO + tt.whole, tt.fraction, &dpsi, &deps);
    eraPn06(MJD_ZERO + tt.whole, tt.fraction, dpsi, deps, &epsa, rb, rp, rbp, rn, rbpn);
}

// GCRS to the celestial intermediate frame.
static orr_mat3 to_cirs(days tt)
{
    double rbpn[3][3], x, y, rc2i[3][3];
    bias_precession_nutation(tt, rbpn);
    eraBpn2xy(rbpn, &x, &y);
    double s = eraS06(MJD_ZERO + tt.whole, tt.fraction, x, y);
    eraC2ixys(x, y, s, rc2i);
    return from_erfa(rc2i);
}

// W(t) = R1(-yp) R2(-xp) R3(s'), IERS Conventions 2010, eq. (5.3) transposed, and its rate.
static void polar_motion(days tt, const orr_eop *eop, orr_mat3 *w, orr_mat3 *dw)
{
    double sp = eraSp00(MJD_ZERO + tt.whole, tt.fraction), rpom[3][3];
    eraPom00(eop->xp_rad, eop->yp_rad, sp, rpom);
    *w = from_erfa(rpom);
    // d/dt of small rotations about axes 1 and 2: first order in the pole is enough for a rate of 1e-13 rad/s
    double x = eop->xp_rate_radps, y = eop->yp_rate_radps;
    *dw = (orr_mat3){{{0, 0, x}, {0, 0, -y}, {-x, y, 0}}};
}

// ERA is 2 pi (0.7790572732640 + 1.00273781191135448 (JD(UT1) - 2451545)), Capitaine et al. 2000; UT1 runs
// slower than TAI by LOD a day.
#define ERA_RATE_RADPS (ERFA_D2PI * 1.00273781191135448 / ORR_S_PER_DAY)

void orr_astro_gcrs_to_itrs(orr_time t, const orr_eop *eop, const orr_leap_table *leap, orr_mat3 *R,
                            orr_mat3 *dR)
{
    days tt = in_scale(t, ORR_SCALE_TT), tai = in_scale(t, ORR_SCALE_TAI);
    double ut1_minus_tai_s = eop->ut1_utc_s - orr_leap_tai_minus_utc(t, leap);
    double era = eraEra00(MJD_ZERO + tai.whole, tai.fraction + ut1_minus_tai_s / ORR_S_PER_DAY);
    orr_mat3 w, dw, spin = orr_mat3_rot3(era), q = to_cirs(tt);
    polar_motion(tt, eop, &w, &dw);
    orr_mat3 spin_q = orr_mat3_mul(&spin, &q);
    *R = orr_mat3_mul(&w, &spin_q);
    if (dR == NULL) return;
    // The intermediate frame turns by at most 1e-11 rad/s and smoothly: over +-10 min a central difference
    // errs by less than 1e-17 rad/s, a nanometre per second at the height of a GNSS satellite.
    const double step_s = 600.0, step = step_s / ORR_S_PER_DAY;
    orr_mat3 before = to_cirs((days){tt.whole, tt.fraction - step});
    orr_mat3 after = to_cirs((days){tt.whole, tt.fraction + step});
    before = orr_mat3_scale(-1.0, &before);
    orr_mat3 dq = orr_mat3_add(&after, &before);
    dq = orr_mat3_scale(0.5 / step_s, &dq);
    double rate = ERA_RATE_RADPS * (1.0 - eop->lod_s / ORR_S_PER_DAY);
    orr_mat3 hat = orr_mat3_hat((orr_vec3){0, 0, rate});
    orr_mat3 turning = orr_mat3_mul(&hat, &spin_q), drifting = orr_mat3_mul(&spin, &dq);
    orr_mat3 sum = orr_mat3_add(&turning, &drifting);
    orr_mat3 of_spin = orr_mat3_mul(&w, &sum), of_pole = orr_mat3_mul(&dw, &spin_q);
    *dR = orr_mat3_add(&of_spin, &of_pole);
}

orr_mat3 orr_astro_gcrs_to_cirs(orr_time t)
{
    const days tt = in_scale(t, ORR_SCALE_TT);
    double x, y, s, rc2i[3][3];
    eraXys06a(MJD_ZERO + tt.whole, tt.fraction, &x, &y, &s);
    eraC2ixys(x, y, s, rc2i);
    return from_erfa(rc2i);
}

orr_mat3 orr_astro_cirs_to_itrs(orr_time t, const orr_eop *eop, const orr_leap_table *leap)
{
    const days tt = in_scale(t, ORR_SCALE_TT), tai = in_scale(t, ORR_SCALE_TAI);
    const double ut1_minus_tai_s = eop->ut1_utc_s - orr_leap_tai_minus_utc(t, leap);
    const double era = eraEra00(MJD_ZERO + tai.whole, tai.fraction + ut1_minus_tai_s / ORR_S_PER_DAY);
    orr_mat3 w, dw, spin = orr_mat3_rot3(era);
    polar_motion(tt, eop, &w, &dw);
    return orr_mat3_mul(&w, &spin);
}

void orr_astro_gcrs_to_tod(orr_time t, orr_mat3 *R)
{
    double rbpn[3][3];
    bias_precession_nutation(in_scale(t, ORR_SCALE_TT), rbpn);
    *R = from_erfa(rbpn);
}

// --- Sun and Moon ---

// Both series want TDB; TT differs by less than 2 ms, in which the Moon moves 2 m and the Sun 60 m.
orr_vec3 orr_astro_sun(orr_time t)
{
    days tt = in_scale(t, ORR_SCALE_TT);
    double heliocentric[2][3], barycentric[2][3];
    // its warning, a date outside 1900-2100, means a slow loss of accuracy and not a failure
    (void)eraEpv00(MJD_ZERO + tt.whole, tt.fraction, heliocentric, barycentric);
    return orr_vec3_scale(-ERFA_DAU, (orr_vec3){heliocentric[0][0], heliocentric[0][1], heliocentric[0][2]});
}

orr_vec3 orr_astro_moon(orr_time t)
{
    days tt = in_scale(t, ORR_SCALE_TT);
    double pv[2][3];
    eraMoon98(MJD_ZERO + tt.whole, tt.fraction, pv);
    return orr_vec3_scale(ERFA_DAU, (orr_vec3){pv[0][0], pv[0][1], pv[0][2]});
}
