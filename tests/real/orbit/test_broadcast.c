// SPDX-License-Identifier: GPL-3.0-or-later
// Broadcast messages of all systems and kinds in a day's global RINEX 4 file, 2023-03-12: what they say of
// motion must be what gravitation does, whatever the message; and the messages of one satellite must agree.
#include "testing.h"

#include "orbit/broadcast/broadcast.h"
#include "orbit/force/force.h"

#define NAV "rinex4-nav/BRD400DLR_S_20230710000_01D_MN.rnx.gz"

static orr_nav nav;
static bool have_nav;

static int open_nav(void **state)
{
    (void)state;
    char path[512];
    orr_diag d = {0};
    have_nav = orr_test_data(NAV, path, sizeof path);
    if (have_nav) ASSERT_OK(orr_nav_read(path, NULL, &nav, NULL, &d), d);
    return 0;
}
static int close_nav(void **state)
{
    (void)state;
    if (have_nav) orr_nav_free(&nav);
    return 0;
}

typedef struct list {
    size_t n;
    double value[16384];
} list;
static list found;

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}
static double quantile(list *l, double q)
{
    assert_true(l->n > 0);
    qsort(l->value, l->n, sizeof *l->value, by_value);
    return l->value[(size_t)(q * (double)(l->n - 1))];
}

// Difference between the second derivative of a record's ecef position and what gravitation and the Earth's
// rotation make of its position and velocity.
static double unexplained(const orr_broadcast_state *x, const orr_sky *sky, const orr_force *force,
                          orr_time t)
{
    orr_sky_point p;
    orr_vec3 r, v;
    orr_sky_at(sky, orr_time_diff_s(t, orr_sky_origin(sky)), &p);
    orr_sky_from_ecef(&p, x->pos_m, x->vel_mps, &r, &v);
    orr_vec3 a = orr_mat3_apply(&p.R, orr_force_acceleration(force, &p, r));
    a = orr_vec3_axpy(2, orr_mat3_apply(&p.dR, v), a);
    a = orr_vec3_add(a, orr_mat3_apply(&p.ddR, r));
    return orr_vec3_norm(orr_vec3_sub(x->acc_mps2, a));
}

static void every_message_obeys_gravitation(void **state)
{
    (void)state;
    if (!have_nav) SKIP_NO_DATA(NAV);
    // Elements meet the true orbit to decimetres over some hours, which are 1e-7 m/s^2 at their harmonics.
    // GLONASS' model holds the Sun and the Moon constant and stops at J2: 1e-6. SBAS sends accelerations in
    // steps of 1.25e-5 (6.25e-5 across the equator), and a parabola is all there is.
    const struct {
        char system;
        orr_nav_message message;
        size_t least;
        double off_s, most_mps2;
    } k[] = {{'G', ORR_NAV_LNAV, 400, 1800, 5e-7},  {'G', ORR_NAV_CNAV, 300, 1800, 5e-7},
             {'R', ORR_NAV_FDMA, 1000, 300, 2e-6},  {'E', ORR_NAV_INAV, 2800, 1800, 5e-7},
             {'E', ORR_NAV_FNAV, 2800, 1800, 5e-7}, {'C', ORR_NAV_D1, 800, 1800, 5e-7},
             {'C', ORR_NAV_D2, 150, 1800, 5e-7},    {'C', ORR_NAV_CNV1, 600, 1800, 5e-7},
             {'C', ORR_NAV_CNV2, 900, 1800, 5e-7},  {'J', ORR_NAV_LNAV, 90, 1800, 5e-7},
             {'J', ORR_NAV_CNAV, 90, 1800, 5e-7},   {'J', ORR_NAV_CNV2, 90, 1800, 5e-7},
             {'I', ORR_NAV_LNAV, 250, 1800, 5e-7},  {'S', ORR_NAV_SBAS, 1000, 60, 2e-4}};
    orr_sky *sky = NULL;
    orr_diag d = {0};
    orr_time from = 0;
    assert_int_equal(orr_time_parse("2023-03-10", NULL, &from, NULL), ORR_OK);
    ASSERT_OK(orr_sky_init(from, orr_time_add_s(from, 5 * 86400.0), ORR_SKY_GCRS, NULL, NULL, &sky, NULL, &d),
              d);
    orr_force force = {.sun_moon = true, .srp_mps2 = 1e-7};
    ASSERT_OK(orr_gravity_field_init(&force.earth, 8, false, &d), d);
    for (size_t i = 0; i < sizeof k / sizeof k[0]; i++) {
        found.n = 0;
        for (size_t j = 0; j < nav.n_eph && found.n < sizeof found.value / sizeof found.value[0]; j++) {
            const orr_nav_eph *e = &nav.eph[j];
            orr_broadcast_state x;
            const orr_time t = orr_time_add_s(e->toe, k[i].off_s);
            if (orr_sat_system(e->sat) != k[i].system || e->message != k[i].message) continue;
            // Many SBAS satellites are not for ranging (URA 15), and send a place that is good to kilometres.
            if (k[i].system == 'S' && !(e->geo.ura_m < 1000)) continue;
            assert_int_equal(orr_broadcast_eval(e, t, &x), ORR_OK);
            found.value[found.n++] = unexplained(&x, sky, &force, t);
        }
        print_message("%c %-4s %5zu records, not explained by gravitation: median %.1e, 95 %% %.1e m/s^2\n",
                      k[i].system, orr_nav_message_name(k[i].message), found.n, quantile(&found, 0.5),
                      quantile(&found, 0.95));
        assert_true(found.n >= k[i].least);
        ASSERT_NEAR(quantile(&found, 0.95), 0, k[i].most_mps2);
    }
    orr_sky_free(sky);
}

// Two messages of one satellite come from one orbit: GPS' L1 C/A and CNAV are two fits of one prediction;
// F/NAV and I/NAV, B1C and B2a, QZSS' CNAV and CNAV-2 send the same elements; D1 and B1C have different phase
// centres.
static void messages_of_a_satellite_agree(void **state)
{
    (void)state;
    if (!have_nav) SKIP_NO_DATA(NAV);
    const struct {
        char system;
        orr_nav_message one, other;
        double most_m, most_clock_m; // of 95 %
    } k[] = {{'G', ORR_NAV_LNAV, ORR_NAV_CNAV, 1.5, 0.6},  {'E', ORR_NAV_INAV, ORR_NAV_FNAV, 0.01, 1},
             {'C', ORR_NAV_CNV1, ORR_NAV_CNV2, 0.01, 0.1}, {'C', ORR_NAV_D1, ORR_NAV_CNV1, 0.25, 0.1},
             {'J', ORR_NAV_LNAV, ORR_NAV_CNAV, 0.2, 0.2},  {'J', ORR_NAV_CNAV, ORR_NAV_CNV2, 0.01, 0.1}};
    static list clocks;
    orr_time midnight = 0;
    assert_int_equal(orr_time_parse("2023-03-12", NULL, &midnight, NULL), ORR_OK);
    for (size_t i = 0; i < sizeof k / sizeof k[0]; i++) {
        orr_broadcast_choice one = orr_broadcast_choice_default(), other = one;
        one.healthy = other.healthy = false;
        one.messages = UINT32_C(1) << k[i].one;
        other.messages = UINT32_C(1) << k[i].other;
        found.n = clocks.n = 0;
        for (int p = 1; p < 64; p++)
            for (int h = 0; h < 24; h++) {
                const orr_sat sat = orr_sat_make(k[i].system, p);
                const orr_time t = orr_time_add_s(midnight, 3600.0 * h + 1800);
                const orr_nav_eph *a = orr_broadcast_select(&nav, sat, t, &one);
                const orr_nav_eph *b = orr_broadcast_select(&nav, sat, t, &other);
                orr_broadcast_state x, y;
                if (a == NULL || b == NULL) continue;
                assert_int_equal(orr_broadcast_eval(a, t, &x), ORR_OK);
                assert_int_equal(orr_broadcast_eval(b, t, &y), ORR_OK);
                found.value[found.n++] = orr_vec3_norm(orr_vec3_sub(x.pos_m, y.pos_m));
                clocks.value[clocks.n++] = ORR_LIGHT_MPS * fabs(x.clock_s - y.clock_s);
            }
        print_message("%c %-4s %-4s %4zu times: 95 %% within %.3f m, clocks %.3f m\n", k[i].system,
                      orr_nav_message_name(k[i].one), orr_nav_message_name(k[i].other), found.n,
                      quantile(&found, 0.95), quantile(&clocks, 0.95));
        assert_true(found.n >= 90);
        ASSERT_NEAR(quantile(&found, 0.95), 0, k[i].most_m);
        ASSERT_NEAR(quantile(&clocks, 0.95), 0,
                    k[i].most_clock_m); // I/NAV's and F/NAV's are of different signals
    }
}

// Neighbouring records half way between their reference times: what a receiver sees as a jump when it changes
// over. SBAS: those that are for ranging. NavIC: metres for I02 and I03; I06 and I09 jump by up to 60 m,
// though each record obeys gravitation as well as the others: the predictions differ, not the model.
static void records_go_over_into_each_other(void **state)
{
    (void)state;
    if (!have_nav) SKIP_NO_DATA(NAV);
    const struct {
        char system;
        orr_nav_message message;
        double longest_s, half_m, most_m; // of 50 and 95 %
    } k[] = {{'G', ORR_NAV_LNAV, 7300, 1, 4},     {'R', ORR_NAV_FDMA, 1900, 1.5, 3},
             {'E', ORR_NAV_INAV, 3700, 0.3, 1},   {'C', ORR_NAV_D1, 3700, 0.3, 1},
             {'C', ORR_NAV_D2, 3700, 0.5, 2},     {'C', ORR_NAV_CNV1, 3700, 0.2, 0.5},
             {'J', ORR_NAV_LNAV, 3700, 0.6, 1.5}, {'I', ORR_NAV_LNAV, 7300, 5, 80},
             {'S', ORR_NAV_SBAS, 400, 1, 3}};
    for (size_t i = 0; i < sizeof k / sizeof k[0]; i++) {
        found.n = 0;
        for (size_t j = 0; j + 1 < nav.n_eph; j++) {
            const orr_nav_eph *a = &nav.eph[j], *b = NULL;
            if (orr_sat_system(a->sat) != k[i].system || a->message != k[i].message) continue;
            if (k[i].system == 'S' && !(a->geo.ura_m < 1000)) continue;
            for (size_t m = j + 1; m < nav.n_eph && nav.eph[m].sat == a->sat && b == NULL; m++)
                if (nav.eph[m].message == a->message && nav.eph[m].toe > a->toe) b = &nav.eph[m];
            if (b == NULL || orr_time_diff_s(b->toe, a->toe) > k[i].longest_s) continue;
            orr_broadcast_state x, y;
            const orr_time t = a->toe + (b->toe - a->toe) / 2;
            assert_int_equal(orr_broadcast_eval(a, t, &x), ORR_OK);
            assert_int_equal(orr_broadcast_eval(b, t, &y), ORR_OK);
            found.value[found.n++] = orr_vec3_norm(orr_vec3_sub(x.pos_m, y.pos_m));
        }
        print_message("%c %-4s %5zu changes: median %.2f m, 95 %% within %.2f m\n", k[i].system,
                      orr_nav_message_name(k[i].message), found.n, quantile(&found, 0.5),
                      quantile(&found, 0.95));
        assert_true(found.n >= 80);
        ASSERT_NEAR(quantile(&found, 0.5), 0, k[i].half_m);
        ASSERT_NEAR(quantile(&found, 0.95), 0, k[i].most_m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(messages_of_a_satellite_agree),
        cmocka_unit_test(records_go_over_into_each_other),
        cmocka_unit_test(every_message_obeys_gravitation),
    };
    return cmocka_run_group_tests(tests, open_nav, close_nav);
}
