// SPDX-License-Identifier: GPL-3.0-or-later
// Clocks that cannot be, from the SP3 to the state: wrong ones are not passed on, and nothing takes their
// place.
#include "testing.h"

#include "core/nan.h"
#include "made_sp3.h"
#include "orbit/ephemeris/ephemeris.h"
#include "orbit/smooth/smoother.h"

static made_sky sky;
static made_truth gps;
#define NODES 25 // 15-minute nodes of six hours

static int make_truth(void **state)
{
    (void)state;
    made_sky_init(&sky, "2024-03-10", 0.25);
    made_orbit(&sky, orr_sat_make('G', 7), 2.656e7, 0.01, 0.96, 0.3, 1.0, 2e-8, -1, 0, &gps);
    return 0;
}
static int drop_truth(void **state)
{
    (void)state;
    made_sky_free(&sky);
    return 0;
}

static double true_clock(double t_s) { return 1e-5 + 1e-11 * t_s; } // as made_sp3 has it

static double noise(int i) { return 2e-10 * sin(7.3 * i * i); } // 0.2 ns

// clock[] becomes the satellite's clock at the nodes; the product and the number of warnings come out.
static orr_ephemeris *product_of(const double *clock, bool detect, size_t *n_warnings)
{
    const made_truth *const all[] = {&gps};
    orr_sp3 f;
    orr_orbit_solution s;
    orr_warnings w = {0};
    orr_diag d = {0};
    orr_ephemeris *e = NULL;
    orr_smoother_options o = orr_smoother_defaults();
    made_sp3(&sky, all, 1, 0, (NODES - 1) * 3, 3, &f);
    assert_int_equal(f.n_epochs, NODES);
    for (size_t i = 0; i < NODES; i++) f.record[i].clock_s = clock[i];
    orr_smoother_input in = {.sp3 = &f, .name = "made.sp3"};
    o.detect = detect;
    ASSERT_OK(orr_smoother_run(&in, 1, &o, NULL, NULL, &s, NULL, &w, &d), d);
    ASSERT_OK(orr_ephemeris_build(&s, &e, &d), d);
    for (size_t i = 0; i < w.kept; i++) assert_non_null(strstr(w.item[i].text, "G07: the clock"));
    *n_warnings = w.count;
    orr_warnings_free(&w);
    orr_orbit_solution_free(&s);
    made_sp3_free(&f);
    return e;
}

// Whether there is a clock at t; where there is one, it must be within 1 ns of `before` up to jump_s and of
// before + jump after.
static bool clock_at(const orr_ephemeris *e, double t_s, double jump_s, double jump)
{
    orr_sat_state x;
    assert_int_equal(orr_ephemeris_eval(e, gps.sat, orr_time_add_s(sky.t0, t_s), &x), ORR_OK);
    if ((x.flags & ORR_EPH_CLOCK_VALID) == 0) {
        assert_true(isnan(x.clock_s) && isnan(x.clock_rate_sps));
        return false;
    }
    ASSERT_NEAR(x.clock_s, true_clock(t_s) + (t_s > jump_s ? jump : 0), 1e-9);
    ASSERT_NEAR(x.clock_rate_sps, 1e-11, 1e-12);
    return true;
}

static void fill(double *clock)
{
    for (int i = 0; i < NODES; i++) clock[i] = true_clock(900.0 * i) + noise(i);
}

static void one_wrong_value_is_left_out(void **state)
{
    (void)state;
    const double size[] = {1e-3, -1e-3, 1e-6,
                           100e-9}; // a third of it must show beside an end, and 30 ns is the limit
    for (int k = 0; k < 4; k++)
        for (int bad = 0; bad < NODES; bad++) {
            double clock[NODES];
            size_t warnings;
            fill(clock);
            clock[bad] += size[k];
            orr_ephemeris *e = product_of(clock, true, &warnings);
            assert_int_equal(warnings, 1);
            for (double t = 0; t <= 900.0 * (NODES - 1); t += 450) {
                const bool touched = t > 900.0 * (bad - 1) && t < 900.0 * (bad + 1);
                if ((bad == 1 && t == 0) || (bad == NODES - 2 && t == 900.0 * (NODES - 1)))
                    continue; // one node is left at the end, and has no rate
                if (clock_at(e, t, HUGE_VAL, 0) == touched) fail_msg("size %g bad %d t %g", size[k], bad, t);
            }
            orr_ephemeris_free(e);
        }
}

static void a_jump_is_not_interpolated_across(void **state)
{
    (void)state;
    for (int after = 1; after < NODES - 1; after++) {
        double clock[NODES];
        size_t warnings;
        fill(clock);
        for (int i = after; i < NODES; i++) clock[i] += 1e-6;
        orr_ephemeris *e = product_of(clock, true, &warnings);
        assert_int_equal(warnings, 1);
        for (double t = 0; t <= 900.0 * (NODES - 1); t += 450) {
            const bool touched = t > 900.0 * (after - 1) && t < 900.0 * after;
            if (after == 1 && t == 0) continue; // one node alone before the jump has no rate
            assert_int_equal(clock_at(e, t, 900.0 * after - 1, 1e-6), !touched);
        }
        orr_ephemeris_free(e);
    }
}

// A change of frequency is what clocks do; 999999.999999 was never a clock; two files' clocks meet at
// midnight.
static void what_clocks_do_is_let_be(void **state)
{
    (void)state;
    double clock[NODES];
    size_t warnings;
    fill(clock);
    for (int i = 13; i < NODES; i++) clock[i] += 1e-10 * 900.0 * (i - 12); // 90 ns a step faster
    orr_ephemeris *e = product_of(clock, true, &warnings);
    assert_int_equal(warnings, 0);
    orr_sat_state x;
    for (double t = 0; t <= 900.0 * (NODES - 1); t += 450) {
        assert_int_equal(orr_ephemeris_eval(e, gps.sat, orr_time_add_s(sky.t0, t), &x), ORR_OK);
        ASSERT_NEAR(x.clock_s, true_clock(t) + (t > 10800 ? 1e-10 * (t - 10800) : 0), 1e-9);
    }
    orr_ephemeris_free(e);

    fill(clock);
    clock[10] = ORR_NAN; // what the reader makes of 999999.999999
    e = product_of(clock, true, &warnings);
    assert_int_equal(warnings, 0);
    assert_true(clock_at(e, 8100, HUGE_VAL, 0));
    assert_false(clock_at(e, 8550, HUGE_VAL, 0));
    assert_false(clock_at(e, 9000, HUGE_VAL, 0));
    assert_true(clock_at(e, 9900, HUGE_VAL, 0));
    orr_ephemeris_free(e);

    // Noise of half a microsecond, as selective availability's was: nothing is singled out.
    for (int i = 0; i < NODES; i++) clock[i] = true_clock(900.0 * i) + 2.5e3 * noise(i);
    e = product_of(clock, true, &warnings);
    assert_int_equal(warnings, 0);
    orr_ephemeris_free(e);

    // By option everything is taken as it is.
    fill(clock);
    clock[10] += 1e-3;
    e = product_of(clock, false, &warnings);
    assert_int_equal(warnings, 0);
    assert_int_equal(orr_ephemeris_eval(e, gps.sat, orr_time_add_s(sky.t0, 9000), &x), ORR_OK);
    ASSERT_NEAR(x.clock_s, clock[10], 1e-15);
    orr_ephemeris_free(e);
}

// Files of two days whose clocks differ: each side keeps its own, the second holds from the joint on, and
// that is no fault of either.
static void a_joint_of_files_is_no_jump(void **state)
{
    (void)state;
    const made_truth *const all[] = {&gps};
    orr_sp3 f[2];
    orr_orbit_solution s;
    orr_warnings w = {0};
    orr_diag d = {0};
    orr_ephemeris *e = NULL;
    const orr_smoother_options o = orr_smoother_defaults();
    made_sp3(&sky, all, 1, 0, 36, 3, &f[0]); // 00:00 to 03:00, 03:00 to 06:00
    made_sp3(&sky, all, 1, 36, 72, 3, &f[1]);
    for (size_t i = 0; i < f[1].n_epochs; i++) f[1].record[i].clock_s += 500e-9;
    const orr_smoother_input in[2] = {{.sp3 = &f[0], .name = "first.sp3"},
                                      {.sp3 = &f[1], .name = "second.sp3"}};
    ASSERT_OK(orr_smoother_run(in, 2, &o, NULL, NULL, &s, NULL, &w, &d), d);
    ASSERT_OK(orr_ephemeris_build(&s, &e, &d), d);
    assert_int_equal(w.count, 0);
    for (double t = 0; t <= 21600; t += 450) assert_true(clock_at(e, t, 10799, 500e-9));
    orr_ephemeris_free(e);
    orr_orbit_solution_free(&s);
    made_sp3_free(&f[0]);
    made_sp3_free(&f[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_wrong_value_is_left_out),
        cmocka_unit_test(a_jump_is_not_interpolated_across),
        cmocka_unit_test(what_clocks_do_is_let_be),
        cmocka_unit_test(a_joint_of_files_is_no_jump),
    };
    return cmocka_run_group_tests(tests, make_truth, drop_truth);
}
