// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include <erfa.h>
#include <erfam.h>

#include "core/astro.h"

static const double AS = ERFA_DAS2R; // one arc second

static orr_time utc(int y, int mo, int d, int h)
{
    orr_time t = ORR_TIME_NONE;
    assert_int_equal(orr_time_from_civil(&(orr_civil){y, mo, d, h, 0, 0, 0}, ORR_SCALE_UTC, NULL, &t),
                     ORR_OK);
    return t;
}

static double largest(const orr_mat3 *a, const orr_mat3 *b)
{
    double max = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) max = fmax(max, fabs(a->m[i][j] - b->m[i][j]));
    return max;
}

static orr_mat3 from_erfa(double m[3][3])
{
    orr_mat3 a;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) a.m[i][j] = m[i][j];
    return a;
}

// "SOFA Tools for Earth Attitude", section 5: 2007 April 5, 12h UTC, xp = 34.9282 mas, yp = 483.3163 mas,
// UT1 - UTC = -72.073685 ms; 5.5, IAU 2006/2000A, CIO based, with CIP corrections dX = +0.1750, dY = -0.2259
// mas.
static void sofa_cookbook(void **state)
{
    (void)state;
    static const orr_mat3 published = {{{+0.973104317697535, +0.230363826239128, -0.000703163482198},
                                        {-0.230363800456037, +0.973104570632801, +0.000118545366625},
                                        {+0.000711560162668, +0.000046626403995, +0.999999745754024}}};
    orr_time t = utc(2007, 4, 5, 12);
    orr_eop eop = {.xp_rad = 0.0349282 * AS, .yp_rad = 0.4833163 * AS, .ut1_utc_s = -0.072073685};
    orr_mat3 R;
    orr_astro_gcrs_to_itrs(t, &eop, NULL, &R, NULL);
    // Ours has no CIP corrections (0.29 mas) and the 2000B nutation (within 1 mas): both are small rotations.
    ASSERT_NEAR(largest(&R, &published), 0, 1.3e-3 * AS);

    // The rest, sidereal rotation, polar motion and the order of things, must agree to rounding: rebuild the
    // published matrix with 2000A and the corrections through ERFA's other road and put our own difference of
    // models between.
    double tt2 = (12 * 3600 + 65.184) / 86400.0, ut2 = 0.5 - 0.072073685 / 86400.0, x, y, s, xb, yb,
           c2i[3][3], pom[3][3], c2t[3][3], dpsi, deps, eps, rb[3][3], rp[3][3], rbp[3][3], rn[3][3],
           rbpn[3][3];
    const double day = 2400000.5 + 54195.0;
    eraXys06a(day, tt2, &x, &y, &s);
    eraPom00(eop.xp_rad, eop.yp_rad, eraSp00(day, tt2), pom);
    eraC2ixys(x + 0.1750e-3 * AS, y - 0.2259e-3 * AS, s, c2i);
    eraC2tcio(c2i, eraEra00(day, ut2), pom, c2t);
    orr_mat3 check = from_erfa(c2t);
    ASSERT_NEAR(largest(&check, &published), 0, 2e-12); // the book moves s with X, Y by 0.0000005" more
    eraNut00b(day, tt2, &dpsi, &deps);
    eraPn06(day, tt2, dpsi, deps, &eps, rb, rp, rbp, rn, rbpn);
    eraBpn2xy(rbpn, &xb, &yb);
    print_message("2000B against 2000A here: dX %+.3f mas, dY %+.3f mas\n", (xb - x) / AS * 1e3,
                  (yb - y) / AS * 1e3);
    ASSERT_NEAR(hypot(xb - x, yb - y), 0, 1e-3 * AS);
    eraC2ixys(xb, yb, eraS06(day, tt2, xb, yb), c2i);
    eraC2tcio(c2i, eraEra00(day, ut2), pom, c2t);
    check = from_erfa(c2t);
    ASSERT_NEAR(largest(&R, &check), 0, 1e-13);
}

// The equinox-based road to the same rotation: sidereal time and the true equator and equinox of date.
static void equinox_and_cio_agree(void **state)
{
    (void)state;
    const orr_eop none = {0};
    for (int year = 1985; year <= 2035; year += 5) {
        orr_time t = utc(year, 3, 3, 7);
        orr_mat3 R, tod;
        orr_astro_gcrs_to_itrs(t, &none, NULL, &R, NULL);
        orr_astro_gcrs_to_tod(t, &tod);
        double rnpb[3][3];
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) rnpb[i][j] = tod.m[i][j];
        int32_t mjd, mjd_utc;
        double tt, ut;
        orr_time_mjd(t, ORR_SCALE_TT, NULL, &mjd, &tt);
        orr_time_mjd(t, ORR_SCALE_UTC, NULL, &mjd_utc, &ut);
        double gst = eraGst06(2400000.5 + mjd_utc, ut, 2400000.5 + mjd, tt, rnpb);
        orr_mat3 spin = orr_mat3_rot3(gst), expected = orr_mat3_mul(&spin, &tod), pole;
        double w[3][3];
        eraPom00(0, 0, eraSp00(2400000.5 + mjd, tt), w);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) pole.m[i][j] = w[i][j];
        expected = orr_mat3_mul(&pole, &expected);
        ASSERT_NEAR(largest(&R, &expected), 0, 1e-13);
    }
}

static void rotation_is_orthogonal_and_its_derivative_is_its_derivative(void **state)
{
    (void)state;
    // Ten days of a made series whose pole, UT1 and rates move as real ones do, and a leap second in the
    // middle.
    enum { N = 11 };
    double mjd[N];
    orr_eop value[N];
    for (int i = 0; i < N; i++) {
        mjd[i] = 57749 + i; // 2016-12-27 .. 2017-01-06
        value[i] =
            (orr_eop){.xp_rad = (0.08 + 0.002 * i + 0.0002 * sin(i)) * AS,
                      .yp_rad = (0.27 - 0.003 * i) * AS,
                      .ut1_utc_s = -0.40 - 0.0012 * i + 0.0002 * cos(i) + (mjd[i] >= 57754 ? 1.0 : 0.0)};
    }
    const orr_eop_series series = {N, mjd, value};
    // Five-point difference: it errs by u^5 h^4 / 30 = 4e-16 1/s, and by the rounding of ERFA's Earth
    // rotation angle, 1e-14 rad over h: 3e-16 1/s. 2e-15 1/s is 5e-8 m/s at a GNSS satellite.
    const double h = 50.0;
    for (int k = 0; k < 40; k++) {
        orr_time t = utc(2016, 12, 27, 3) + (orr_time)k * 6 * 3600 * ORR_NS_PER_S;
        orr_mat3 R, dR, at[5];
        for (int i = -2; i <= 2; i++) {
            bool inside;
            orr_eop eop = orr_eop_at(&series, orr_time_add_s(t, i * h), NULL, &inside);
            assert_true(inside);
            orr_astro_gcrs_to_itrs(orr_time_add_s(t, i * h), &eop, NULL, &at[i + 2], i == 0 ? &dR : NULL);
        }
        R = at[2];
        orr_mat3 rt = orr_mat3_transpose(&R), unit = orr_mat3_mul(&R, &rt), e = orr_mat3_identity();
        ASSERT_NEAR(largest(&unit, &e), 0, 1e-15);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                ASSERT_NEAR(dR.m[i][j],
                            (at[0].m[i][j] - 8 * at[1].m[i][j] + 8 * at[3].m[i][j] - at[4].m[i][j]) /
                                (12 * h),
                            2e-15);
    }
}

// At 2.66e7 m the terms that a shorter formula drops: each must be seen in dR.
static void derivative_holds_lod_pole_and_precession(void **state)
{
    (void)state;
    orr_time t = utc(2024, 2, 4, 0);
    orr_mat3 R, dR, other, d;
    orr_eop eop = {.xp_rad = 0.1 * AS, .yp_rad = 0.4 * AS, .ut1_utc_s = 0.01};
    orr_astro_gcrs_to_itrs(t, &eop, NULL, &R, &dR);
    eop.lod_s = 0.002;
    orr_astro_gcrs_to_itrs(t, &eop, NULL, &R, &other);
    ASSERT_NEAR(other.m[0][0] / dR.m[0][0], 1 - 0.002 / 86400, 1e-9);
    assert_true(other.m[0][0] != dR.m[0][0]);
    // without polar motion and precession dR = u hat(e3) R, whose bottom row is zero
    orr_mat3 hat = orr_mat3_hat((orr_vec3){0, 0, 7.292115146706979e-5});
    orr_mat3 simple = orr_mat3_mul(&hat, &R);
    simple = orr_mat3_scale(-1, &simple);
    d = orr_mat3_add(&dR, &simple);
    // pole of 0.4": 1.9e-6 rad of Earth rate in the bottom row
    double bottom = sqrt(d.m[2][0] * d.m[2][0] + d.m[2][1] * d.m[2][1]);
    ASSERT_NEAR(bottom, 7.292115e-5 * hypot(0.1, 0.4) * AS, 1e-11);
    ASSERT_NEAR(bottom * 2.66e7, 3.9e-3, 1e-4); // m/s
}

static void sun_and_moon_at_erfas_check_values(void **state)
{
    (void)state;
    // ERFA's t_erfa_c: eraEpv00 at MJD 53411.52501161 (TDB; TT here, 2 ms and 60 m apart), eraMoon98 at MJD
    // 43999.9
    orr_vec3 s = orr_astro_sun(orr_time_from_mjd(53411, 0.52501161, ORR_SCALE_TT, NULL));
    ASSERT_NEAR(s.x / ERFA_DAU, 0.7757238809297706813, 1e-11);
    ASSERT_NEAR(s.y / ERFA_DAU, -0.5598052241363340596, 1e-11);
    ASSERT_NEAR(s.z / ERFA_DAU, -0.2426998466481686993, 1e-11);
    orr_vec3 m = orr_astro_moon(orr_time_from_mjd(43999, 0.9, ORR_SCALE_TT, NULL));
    ASSERT_NEAR(m.x / ERFA_DAU, -0.2601295959971044180e-2, 1e-13);
    ASSERT_NEAR(m.y / ERFA_DAU, 0.6139750944302742189e-3, 1e-13);
    ASSERT_NEAR(m.z / ERFA_DAU, 0.2640794528229828909e-3, 1e-13);
}

// The solar eclipse of 2017-08-21: greatest at 18:25:32 UT, gamma 0.4367 Earth radii (Espenak): the shadow's
// axis passes the geocentre at that distance.
static void a_total_eclipse(void **state)
{
    (void)state;
    orr_time t = utc(2017, 8, 21, 18) + (25 * 60 + 32) * ORR_NS_PER_S;
    orr_vec3 s = orr_astro_sun(t), m = orr_astro_moon(t);
    orr_vec3 axis = orr_vec3_unit(orr_vec3_sub(m, s));
    double miss = orr_vec3_norm(orr_vec3_cross(axis, m)) / 6378137.0;
    ASSERT_NEAR(miss, 0.4367,
                0.01); // Moon98: some km; light time of 8 min in the Sun's place moves the axis by 20"
}

static void series_and_its_ends(void **state)
{
    (void)state;
    double mjd[] = {57752, 57753, 57754, 57755};
    orr_eop value[4];
    for (int i = 0; i < 4; i++)
        value[i] = (orr_eop){.xp_rad = 1e-7 + 1e-8 * i,
                             .yp_rad = 2e-7 - 2e-8 * i,
                             .ut1_utc_s = -0.4 - 0.001 * i + (mjd[i] >= 57754 ? 1 : 0)};
    const orr_eop_series series = {4, mjd, value};
    bool inside;
    // straight lines stay straight, and UT1 does not feel the leap second of 2017-01-01
    orr_time noon = utc(2016, 12, 31, 12);
    orr_eop e = orr_eop_at(&series, noon, NULL, &inside);
    assert_true(inside);
    // its day has 86401 s: noon is that little before the middle
    ASSERT_NEAR(e.xp_rad, 1e-7 + 1e-8 * (1 + 43200.0 / 86401), 1e-18); // days of unequal length: no line
    ASSERT_NEAR(e.xp_rate_radps, 1e-8 / 86401, 2e-18);                 // the neighbours' days are 1 s shorter
    ASSERT_NEAR(e.ut1_utc_s, -0.4015, 1e-7);
    ASSERT_NEAR(e.lod_s, 0.001, 1e-7);
    orr_time midnight = utc(2017, 1, 1, 0);
    orr_eop a = orr_eop_at(&series, midnight - 1, NULL, NULL), b = orr_eop_at(&series, midnight, NULL, NULL);
    ASSERT_NEAR(b.ut1_utc_s - a.ut1_utc_s, 1, 1e-12);
    ASSERT_NEAR(b.ut1_utc_s, value[2].ut1_utc_s, 1e-12);
    // beyond the end: no step and no kink, and told so
    orr_time end = utc(2017, 1, 2, 0);
    a = orr_eop_at(&series, end - ORR_NS_PER_S, NULL, &inside);
    assert_true(inside);
    b = orr_eop_at(&series, end + ORR_NS_PER_S, NULL, &inside);
    assert_false(inside);
    ASSERT_NEAR(b.xp_rad - a.xp_rad, 2 * a.xp_rate_radps, 1e-17);
    ASSERT_NEAR(b.yp_rad - a.yp_rad, 2 * a.yp_rate_radps, 1e-17);
    ASSERT_NEAR(b.ut1_utc_s - a.ut1_utc_s, -2 * a.lod_s / 86400, 1e-11);
    ASSERT_NEAR(b.xp_rate_radps, a.xp_rate_radps,
                1e-17); // 1e-8 rad a day, of which ten days forget 2e-6 in 2 s
    ASSERT_NEAR(b.lod_s, a.lod_s, 1e-8);
    // long after: the slope of the secular pole, and the derivative is the derivative
    a = orr_eop_at(&series, end + 90 * 86400 * ORR_NS_PER_S, NULL, NULL);
    b = orr_eop_at(&series, end + 91 * 86400 * ORR_NS_PER_S, NULL, NULL);
    ASSERT_NEAR(b.xp_rad - a.xp_rad, 1.677e-3 * AS / 365.25, 1e-11);
    ASSERT_NEAR(b.ut1_utc_s - a.ut1_utc_s, -(a.lod_s + b.lod_s) / 2, 1e-9);
    // without a series the secular pole
    e = orr_eop_at(NULL, utc(2017, 1, 2, 1), NULL, &inside);
    assert_false(inside);
    ASSERT_NEAR(e.xp_rad, (55.0 + 1.677 * 17.003538) * 1e-3 * AS, 1e-14);
    ASSERT_NEAR(e.yp_rad, (320.5 + 3.460 * 17.003538) * 1e-3 * AS, 1e-14);
    orr_eop later = orr_eop_at(NULL, utc(2018, 1, 2, 1), NULL, &inside);
    assert_false(inside);
    ASSERT_NEAR(later.xp_rad - e.xp_rad, e.xp_rate_radps * 365 * 86400, 1e-16);
    ASSERT_NEAR(later.yp_rad - e.yp_rad, e.yp_rate_radps * 365 * 86400, 1e-16);
    const orr_eop_series empty = {0};
    (void)orr_eop_at(&empty, noon, NULL, &inside);
    assert_false(inside);
}

// A run's table has a leap second that the built-in one lacks: UT1 begins from it, and a series, whose labels are the
// built-in table's, says the same of UT1 - TAI by either.
static void another_table_of_leap_seconds(void **state)
{
    (void)state;
    const orr_leap_table *own = orr_leap_builtin();
    orr_leap_entry entry[64];
    assert_true(own->n < 64);
    for (size_t i = 0; i < own->n; i++) entry[i] = own->entry[i];
    entry[own->n] = (orr_leap_entry){60126, own->entry[own->n - 1].tai_minus_utc_s + 1}; // 2023-07-01
    const orr_leap_table run = {own->n + 1, entry, 61000};
    const orr_time t = utc(2024, 2, 4, 6);
    const orr_eop by_own = orr_eop_at(NULL, t, NULL, NULL), by_run = orr_eop_at(NULL, t, &run, NULL);
    assert_int_equal(orr_leap_tai_minus_utc(t, &run) - orr_leap_tai_minus_utc(t, NULL), 1);
    const double later_s = by_run.ut1_utc_s - 1 - by_own.ut1_utc_s; // of UT1
    assert_true(later_s < -0.4 && later_s > -1);
    ASSERT_NEAR(orr_eop_node(NULL, t, &run).ut1_utc_s, by_run.ut1_utc_s - 1, 1e-12);
    double mjd[4];
    orr_eop value[4];
    for (int i = 0; i < 4; i++) {
        mjd[i] = 60343 + i;
        value[i] = (orr_eop){.xp_rad = 1e-7 * i, .ut1_utc_s = -0.01 + 0.001 * i};
    }
    const orr_eop_series series = {4, mjd, value};
    const orr_eop a = orr_eop_at(&series, t, NULL, NULL), b = orr_eop_at(&series, t, &run, NULL);
    ASSERT_NEAR(b.ut1_utc_s - a.ut1_utc_s, 1, 1e-12);
    ASSERT_NEAR(b.xp_rad, a.xp_rad, 0);
    orr_mat3 by_a, by_b;
    orr_astro_gcrs_to_itrs(t, &a, NULL, &by_a, NULL);
    orr_astro_gcrs_to_itrs(t, &b, &run, &by_b, NULL);
    for (int i = 0; i < 9; i++) ASSERT_NEAR(by_a.m[i / 3][i % 3], by_b.m[i / 3][i % 3], 1e-12);
}

// Over a gap of more than three days a series says nothing: both ends are carried on and blended without a step or a kink,
// and far inside the gap of a year only the offsets at its ends are left.
static void gaps_are_no_series(void **state)
{
    (void)state;
    double mjd[] = {60344, 60345, 60346, 60346 + 365, 60347 + 365};
    orr_eop value[5] = {0};
    for (int i = 0; i < 5; i++)
        value[i] = (orr_eop){.xp_rad = (100 + 3 * i + (i > 2 ? 60 : 0)) * 1e-9,
                             .yp_rad = (1500 - 2 * i) * 1e-9,
                             .ut1_utc_s = 0.01 - 0.001 * i + (i > 2 ? 0.05 : 0)};
    const orr_eop_series series = {5, mjd, value};
    bool inside;
    const orr_time first = orr_time_from_mjd(60346, 0, ORR_SCALE_UTC, NULL),
                   last = orr_time_from_mjd(60346 + 365, 0, ORR_SCALE_UTC, NULL);
    (void)orr_eop_at(&series, first - ORR_NS_PER_S, NULL, &inside);
    assert_true(inside);
    orr_eop mid = orr_eop_at(&series, first + (last - first) / 2, NULL, &inside);
    assert_false(inside);
    // Between the ends plus what their slopes carry in ten days each (3e-9 and 2 ms a day at most).
    assert_true(mid.xp_rad > 100e-9 && mid.xp_rad < 250e-9);
    assert_true(fabs(mid.ut1_utc_s) < 0.2);
    const orr_time edges[2] = {first, last};
    for (int k = 0; k < 2; k++) {
        orr_eop a = orr_eop_at(&series, edges[k] - 1000, NULL, NULL),
                b = orr_eop_at(&series, edges[k] + 1000, NULL, NULL);
        ASSERT_NEAR(a.xp_rad, b.xp_rad, 1e-16);
        ASSERT_NEAR(a.ut1_utc_s, b.ut1_utc_s, 1e-12);
        ASSERT_NEAR(a.xp_rate_radps, b.xp_rate_radps, 1e-19);
        ASSERT_NEAR(a.lod_s, b.lod_s, 1e-9);
    }
    // The rates are the derivatives of the values in the gap too.
    const orr_time t = first + 20 * 86400 * ORR_NS_PER_S;
    orr_eop a = orr_eop_at(&series, t - 600 * ORR_NS_PER_S, NULL, NULL),
            b = orr_eop_at(&series, t, NULL, NULL),
            c = orr_eop_at(&series, t + 600 * ORR_NS_PER_S, NULL, NULL);
    ASSERT_NEAR((c.xp_rad - a.xp_rad) / 1200, b.xp_rate_radps, 1e-18);
    ASSERT_NEAR(-(c.ut1_utc_s - a.ut1_utc_s) / 1200 * 86400, b.lod_s, 1e-8);
}

// Without a series the Earth turns on evenly where UTC steps, UT1 stays within 0.4 s of what it was (IERS EOP
// C04), its derivative is its derivative, and from 2020 on UT1 is UTC.
static void ut1_without_a_series_has_no_step(void **state)
{
    (void)state;
    static const struct {
        int year, month, day;
        double ut1_utc_s;
    } published[] = {{2000, 1, 1, 0.3555}, {2003, 1, 1, -0.2894}, {2006, 1, 1, 0.3389},
                     {2009, 1, 1, 0.4073}, {2012, 7, 1, 0.4130},  {2015, 7, 1, 0.3238},
                     {2017, 1, 1, 0.5914}, {2021, 1, 1, -0.1757}, {2024, 1, 1, 0.0088}};
    for (size_t k = 0; k < sizeof published / sizeof published[0]; k++) {
        orr_time t = utc(published[k].year, published[k].month, published[k].day, 0);
        ASSERT_NEAR(orr_eop_at(NULL, t, NULL, NULL).ut1_utc_s, published[k].ut1_utc_s, 0.4);
    }
    const orr_leap_table *leap = orr_leap_builtin();
    for (size_t k = 2; k < leap->n; k++) {
        orr_time t = orr_time_from_mjd(leap->entry[k].mjd, 0, ORR_SCALE_UTC, NULL);
        orr_mat3 before, after;
        orr_eop a = orr_eop_at(NULL, t - 1, NULL, NULL), b = orr_eop_at(NULL, t, NULL, NULL);
        orr_astro_gcrs_to_itrs(t - 1, &a, NULL, &before, NULL);
        orr_astro_gcrs_to_itrs(t, &b, NULL, &after, NULL);
        ASSERT_NEAR(largest(&before, &after), 0, 1e-11); // 1 ns of rotation and the rounding of days
        ASSERT_NEAR(a.lod_s, b.lod_s, 1e-9);
    }
    for (int year = 1973; year < 2030; year++) {
        orr_time t = utc(year, 3, 10, 0);
        orr_eop a = orr_eop_at(NULL, t, NULL, NULL),
                b = orr_eop_at(NULL, t + 86400 * ORR_NS_PER_S, NULL, NULL);
        ASSERT_NEAR(b.ut1_utc_s - a.ut1_utc_s, -(a.lod_s + b.lod_s) / 2, 1e-6);
        assert_true(fabs(a.lod_s) < 0.006);
        if (year >= 2020) assert_true(a.ut1_utc_s == 0 && a.lod_s == 0);
    }
}

// No kink at a node: the rates from both sides agree.
static void series_is_smooth_at_its_nodes(void **state)
{
    (void)state;
    enum { N = 8 };
    double mjd[N] = {58000, 58001, 58002, 58003, 58005, 58006, 58007.5, 58008};
    orr_eop value[N];
    for (int i = 0; i < N; i++)
        value[i] = (orr_eop){.xp_rad = 1e-7 * sin(mjd[i]), .ut1_utc_s = 1e-3 * cos(mjd[i])};
    const orr_eop_series series = {N, mjd, value};
    for (int i = 1; i < N - 1; i++) {
        orr_time t = orr_time_from_mjd((int32_t)floor(mjd[i]), mjd[i] - floor(mjd[i]), ORR_SCALE_UTC, NULL);
        orr_eop a = orr_eop_at(&series, t - 1000, NULL, NULL), b = orr_eop_at(&series, t + 1000, NULL, NULL);
        ASSERT_NEAR(a.xp_rate_radps, b.xp_rate_radps, 1e-21);
        ASSERT_NEAR(a.lod_s, b.lod_s, 1e-12);
        ASSERT_NEAR(a.xp_rad, value[i].xp_rad, 1e-15);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sofa_cookbook),
        cmocka_unit_test(equinox_and_cio_agree),
        cmocka_unit_test(rotation_is_orthogonal_and_its_derivative_is_its_derivative),
        cmocka_unit_test(derivative_holds_lod_pole_and_precession),
        cmocka_unit_test(sun_and_moon_at_erfas_check_values),
        cmocka_unit_test(a_total_eclipse),
        cmocka_unit_test(series_and_its_ends),
        cmocka_unit_test(another_table_of_leap_seconds),
        cmocka_unit_test(gaps_are_no_series),
        cmocka_unit_test(ut1_without_a_series_has_no_step),
        cmocka_unit_test(series_is_smooth_at_its_nodes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
