// SPDX-License-Identifier: GPL-3.0-or-later
// Orbits from broadcast records: one orbit told by many records comes back; two that disagree are joined without a step in
// position, velocity, acceleration or clock; what stands still stands still; two products are one.
#include "testing.h"

#include "orbit/broadcast/broadcast.h"
#include "orbit/ephemeris/broadcast_orbits.h"

#define T0 (INT64_C(1392940800) * ORR_NS_PER_S) // 2024-02-26T00:00:00, a Monday

// Elements of NavIC's IGSO at toe; the mean anomaly of one and the same orbit.
static orr_nav_eph igso(int number, orr_time toe)
{
    orr_nav_eph e = {.sat = orr_sat_make('I', number),
                     .kind = ORR_NAV_KEPLER,
                     .message = ORR_NAV_LNAV,
                     .toe = toe,
                     .toc = toe,
                     .transmission = toe - 3600 * ORR_NS_PER_S,
                     .af0_s = 1e-4 + 2e-11 * orr_time_diff_s(toe, T0),
                     .af1_sps = 2e-11,
                     .accuracy_m = 2.4,
                     .iode = 1,
                     .iodc = 1};
    orr_nav_kepler *k = &e.kepler;
    const double a = 42164200;
    int32_t week;
    int64_t ns;
    orr_time_week(toe, &week, &ns);
    k->toe_sow_s = (double)ns * 1e-9;
    k->sqrt_a_sqrtm = sqrt(a);
    k->e = 0.002;
    k->i0_rad = 0.47;
    k->omega_rad = 3;
    k->m0_rad = remainder(0.3 + sqrt(3.986005e14 / (a * a * a)) * orr_time_diff_s(toe, T0), 2 * ORR_PI);
    // Omega_0 is against Greenwich at the begin of the week: as it was there for all records.
    k->omega0_rad = 0.9 + number;
    return e;
}

static orr_ephemeris *build(orr_nav *nav, const orr_geostationary *geo, size_t n_geo, orr_time from,
                            orr_time to)
{
    orr_ephemeris *e = NULL;
    orr_diag d = {0};
    ASSERT_OK(orr_broadcast_orbits(nav, NULL, geo, n_geo, from, to, &e, NULL, &d), d);
    assert_non_null(e);
    return e;
}

static void one_orbit_told_by_many_records(void **state)
{
    (void)state;
    orr_nav_eph list[5];
    for (int k = 0; k < 5; k++) list[k] = igso(2, T0 + k * 7200 * ORR_NS_PER_S);
    orr_nav nav = {.n_eph = 5, .eph = list};
    orr_ephemeris *e = build(&nav, NULL, 0, ORR_TIME_NONE, ORR_TIME_NONE);
    orr_time from, to;
    orr_ephemeris_span(e, &from, &to);
    assert_true(from == T0 - 7200 * ORR_NS_PER_S && to == T0 + 5 * 7200 * ORR_NS_PER_S); // two hours beyond
    for (orr_time t = from; t <= to; t += 137 * ORR_NS_PER_S) {
        orr_sat_state s;
        orr_broadcast_state b;
        assert_int_equal(orr_ephemeris_eval(e, list[0].sat, t, &s), ORR_OK);
        assert_int_equal(orr_broadcast_eval(&list[0], t, &b), ORR_OK);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(s.pos_m, b.pos_m)), 0, 1e-4);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(s.vel_mps, b.vel_mps)), 0, 1e-6);
        ASSERT_NEAR(s.clock_s, b.clock_s, 1e-15);
        ASSERT_NEAR(s.sigma_m, 2.4, 2.4 / 4096); // products keep 12 bits of a sigma
    }
    orr_ephemeris_free(e);
}

// The second record is 3 m and 4 ns off: at its own time each record holds, and between them nothing steps.
static void records_that_disagree_are_joined(void **state)
{
    (void)state;
    orr_nav_eph list[3];
    for (int k = 0; k < 3; k++) list[k] = igso(2, T0 + k * 7200 * ORR_NS_PER_S);
    list[1].kepler.omega0_rad += 3.0 / 42e6;
    list[1].af0_s += 4e-9;
    orr_nav nav = {.n_eph = 3, .eph = list};
    orr_ephemeris *e = build(&nav, NULL, 0, ORR_TIME_NONE, ORR_TIME_NONE);
    for (int k = 0; k < 3; k++) {
        orr_sat_state s;
        orr_broadcast_state b;
        assert_int_equal(orr_ephemeris_eval(e, list[0].sat, list[k].toe, &s), ORR_OK);
        assert_int_equal(orr_broadcast_eval(&list[k], list[k].toe, &b), ORR_OK);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(s.pos_m, b.pos_m)), 0, 1e-4);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(s.vel_mps, b.vel_mps)), 0, 1e-6);
        ASSERT_NEAR(s.clock_s, b.clock_s, 1e-13);
    }
    double bend = 0;
    for (orr_time t = T0 - 3600 * ORR_NS_PER_S; t < T0 + 18000 * ORR_NS_PER_S; t += 20 * ORR_NS_PER_S) {
        orr_sat_state a, b;
        assert_int_equal(orr_ephemeris_eval(e, list[0].sat, t, &a), ORR_OK);
        assert_int_equal(orr_ephemeris_eval(e, list[0].sat, t + 20 * ORR_NS_PER_S, &b), ORR_OK);
        // Against the first record's own smooth orbit: the trapezium of the velocities is the way but for h^3 / 12 of the
        // third derivative, 60 times 3 m in (2 h)^3.
        orr_broadcast_state p, q;
        assert_int_equal(orr_broadcast_eval(&list[0], t, &p), ORR_OK);
        assert_int_equal(orr_broadcast_eval(&list[0], t + 20 * ORR_NS_PER_S, &q), ORR_OK);
        const orr_vec3 va = orr_vec3_sub(a.vel_mps, p.vel_mps), vb = orr_vec3_sub(b.vel_mps, q.vel_mps),
                       way = orr_vec3_sub(orr_vec3_sub(b.pos_m, q.pos_m), orr_vec3_sub(a.pos_m, p.pos_m)),
                       mean = orr_vec3_axpy(10, orr_vec3_add(va, vb), (orr_vec3){0});
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(way, mean)), 0, 2e-5);
        bend = fmax(bend, orr_vec3_norm(orr_vec3_sub(orr_vec3_sub(b.acc_mps2, q.acc_mps2),
                                                     orr_vec3_sub(a.acc_mps2, p.acc_mps2))));
        assert_true(fabs(b.clock_s - a.clock_s - 20 * 2e-11) < 20 * 4e-9 / 7200 * 2.5);
    }
    assert_true(bend < 1e-7); // the weight bends by 6 / (2 h)^2 of 3 m at most, and does so smoothly
    orr_ephemeris_free(e);
}

// A gap of more than twice two hours ends an arc: nothing is made up in it.
static void gaps_stay_gaps(void **state)
{
    (void)state;
    orr_nav_eph list[2] = {igso(2, T0), igso(2, T0 + 15000 * ORR_NS_PER_S)};
    orr_nav nav = {.n_eph = 2, .eph = list};
    orr_ephemeris *e = build(&nav, NULL, 0, ORR_TIME_NONE, ORR_TIME_NONE);
    orr_sat_state s;
    assert_int_equal(orr_ephemeris_eval(e, list[0].sat, T0 + 7500 * ORR_NS_PER_S, &s), ORR_E_NODATA);
    assert_int_equal(orr_ephemeris_eval(e, list[0].sat, T0 + 6000 * ORR_NS_PER_S, &s), ORR_OK);
    assert_int_equal(orr_ephemeris_eval(e, list[0].sat, T0 + 9000 * ORR_NS_PER_S, &s), ORR_OK);
    orr_ephemeris_free(e);
}

static void what_stands_still(void **state)
{
    (void)state;
    const orr_geostationary geo[2] = {{orr_sat_parse("S23"), 0.5}, {orr_sat_parse("S20"), -2}};
    const orr_time to = T0 + 86400 * ORR_NS_PER_S;
    orr_ephemeris *e = build(NULL, geo, 2, T0, to);
    const orr_sat *list;
    assert_int_equal(orr_ephemeris_satellites(e, &list), 2);
    assert_true(list[0] == geo[1].sat);
    for (orr_time t = T0; t <= to; t += 7777 * ORR_NS_PER_S) {
        orr_sat_state s;
        assert_int_equal(orr_ephemeris_eval(e, geo[0].sat, t, &s), ORR_OK);
        // Kepler's third law for a sidereal day, in closed form.
        const double day = 2 * ORR_PI / ORR_EARTH_RATE_RADPS,
                     a = cbrt(3.986004418e14 * pow(day / 2 / ORR_PI, 2));
        ASSERT_NEAR(orr_vec3_norm(s.pos_m), a, 10);
        ASSERT_NEAR(atan2(s.pos_m.y, s.pos_m.x), 0.5, 1e-12);
        ASSERT_NEAR(s.pos_m.z, 0, 1e-6);
        ASSERT_NEAR(orr_vec3_norm(s.vel_mps), 0, 1e-9);
        ASSERT_NEAR(s.clock_s, 0, 0);
    }
    orr_diag d = {0};
    orr_ephemeris *none;
    const orr_geostationary twice[2] = {geo[0], geo[0]};
    assert_int_equal(orr_broadcast_orbits(NULL, NULL, twice, 2, T0, to, &none, NULL, &d), ORR_E_ARG);
    assert_non_null(strstr(d.text, "S23 has two longitudes"));
    assert_int_equal(orr_broadcast_orbits(NULL, NULL, geo, 2, ORR_TIME_NONE, ORR_TIME_NONE, &none, NULL, &d),
                     ORR_E_NODATA);
    orr_ephemeris_free(e);
}

// A geostationary satellite whose record says so in SBAS' way, and its parabola.
static void sbas_by_its_records(void **state)
{
    (void)state;
    orr_nav_eph list[12];
    for (int k = 0; k < 12; k++)
        list[k] = (orr_nav_eph){
            .sat = orr_sat_parse("S23"),
            .kind = ORR_NAV_GEO,
            .message = ORR_NAV_SBAS,
            .toe = T0 + k * 160 * ORR_NS_PER_S,
            .toc = T0 + k * 160 * ORR_NS_PER_S,
            .transmission = T0 + k * 160 * ORR_NS_PER_S,
            .health = 31,
            .accuracy_m = (double)NAN,
            .geo = {.pos_m = {42164000 - 0.5 * 160.0 * k, 0.3 * 160 * k, 20}, .vel_mps = {-0.5, 0.3, 0}}};
    orr_nav nav = {.n_eph = 12, .eph = list};
    orr_ephemeris *e = build(&nav, NULL, 0, ORR_TIME_NONE, ORR_TIME_NONE);
    orr_sat_state s;
    assert_int_equal(orr_ephemeris_eval(e, list[0].sat, T0 + 1000 * ORR_NS_PER_S, &s), ORR_OK);
    ASSERT_NEAR(s.pos_m.x, 42164000 - 500, 1e-4);
    ASSERT_NEAR(s.vel_mps.y, 0.3, 1e-6);
    orr_ephemeris_free(e);
}

static void two_products_are_one(void **state)
{
    (void)state;
    orr_nav_eph list[6];
    for (int k = 0; k < 6; k++) list[k] = igso(k < 3 ? 2 : 6, T0 + k % 3 * 7200 * ORR_NS_PER_S);
    orr_nav nav = {.n_eph = 6, .eph = list};
    const orr_time to = T0 + 14400 * ORR_NS_PER_S;
    orr_ephemeris *a = build(&nav, NULL, 0, T0, to), *both;
    const orr_geostationary geo = {orr_sat_parse("S23"), 0.5};
    orr_ephemeris *b = build(NULL, &geo, 1, T0, to);
    orr_diag d = {0};
    ASSERT_OK(orr_ephemeris_join(b, a, &both, &d), d);
    const orr_sat *sats;
    assert_int_equal(orr_ephemeris_satellites(both, &sats), 3);
    for (orr_time t = T0; t <= to; t += 999 * ORR_NS_PER_S)
        for (int k = 0; k < 3; k++) {
            orr_sat_state x, y;
            assert_int_equal(orr_ephemeris_eval(sats[k] == geo.sat ? b : a, sats[k], t, &x), ORR_OK);
            assert_int_equal(orr_ephemeris_eval(both, sats[k], t, &y), ORR_OK);
            assert_memory_equal(&x.pos_m, &y.pos_m, 3 * sizeof x.pos_m);
            assert_true(x.clock_s == y.clock_s && x.sigma_m == y.sigma_m);
        }
    orr_ephemeris *none;
    assert_int_equal(orr_ephemeris_join(a, a, &none, &d), ORR_E_FORMAT);
    orr_sat_set except = {0};
    orr_sat_set_add(&except, orr_sat_parse("I02"));
    orr_sat_set_add(&except, orr_sat_parse("I06"));
    ASSERT_OK(orr_broadcast_orbits(&nav, &except, NULL, 0, T0, to, &none, NULL, &d), d);
    assert_null(none); // nobody is left
    orr_ephemeris_free(both);
    orr_ephemeris_free(a);
    orr_ephemeris_free(b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_orbit_told_by_many_records),
        cmocka_unit_test(records_that_disagree_are_joined),
        cmocka_unit_test(gaps_stay_gaps),
        cmocka_unit_test(what_stands_still),
        cmocka_unit_test(sbas_by_its_records),
        cmocka_unit_test(two_products_are_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
