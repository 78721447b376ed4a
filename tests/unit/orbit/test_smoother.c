// SPDX-License-Identifier: GPL-3.0-or-later
// The smoother on made orbits: right when all is well, honest when something is missing.
#include "testing.h"

#include "orbit/ephemeris/ephemeris.h"
#include "unit/orbit/smoother_made.h"

// Rounding to a millimetre is 0.5 mm RMS in 3-D per node; a smoother must come out below it inside the day.
static void inside_the_day_the_smoother_beats_the_rounding(void **state)
{
    (void)state;
    orr_sp3 f;
    made_sp3(&sky, all, 3, 0, DAY, 3, &f);
    orr_orbit_solution s;
    orr_smoother_report report;
    orr_diag d = {0};
    orr_smoother_options o = orr_smoother_defaults();
    ASSERT_OK(run(&f, 1, &o, &s, &report, NULL, &d), d);
    assert_int_equal(s.n_sats, 3);
    assert_int_equal(report.nodes_used, 3 * 97);
    assert_int_equal(report.nodes_rejected + report.manoeuvres, 0);
    for (size_t i = 0; i < 3; i++) {
        double rms, max;
        assert_true(made_compare(&sky, all[i], &s, 7200, 79200, &rms, &max) > 200);
        ASSERT_NEAR(rms, 0, 0.5e-3);
        ASSERT_NEAR(max, 0, 2e-3);
        assert_true(made_compare(&sky, all[i], &s, 0, 86400, &rms, &max) == DAY + 1);
        ASSERT_NEAR(max, 0, 4e-3); // one-sided at the edges
        // What sigma says is true within a factor of two, neither boast nor fear.
        const orr_orbit_arc *arc = &made_find(&s, all[i]->sat)->arc[0];
        made_compare(&sky, all[i], &s, 7200, 79200, &rms, &max);
        double sigma = (double)arc->sample[arc->n / 2].sigma_m;
        assert_true(sigma > 0.5 * rms && sigma < 2 * rms);
    }
    orr_orbit_solution_free(&s);
    made_sp3_free(&f);
}

// Velocity and acceleration of the samples are the derivatives of their positions: fifth-order differences
// over 150 s.
static void samples_are_one_smooth_curve(void **state)
{
    (void)state;
    orr_sp3 f;
    made_sp3(&sky, all, 3, 0, DAY, 3, &f);
    orr_orbit_solution s;
    orr_diag d = {0};
    orr_smoother_options o = orr_smoother_defaults();
    ASSERT_OK(run(&f, 1, &o, &s, NULL, NULL, &d), d);
    for (size_t i = 0; i < s.n_sats; i++) {
        const orr_orbit_arc *arc = &s.sat[i].arc[0];
        for (size_t k = 0; k + 1 < arc->n;
             k++) { // the quintic through both ends must give the velocity in the middle twice
            const orr_orbit_sample *a = &arc->sample[k], *b = a + 1;
            double h = arc->step_s;
            orr_vec3 dr = orr_vec3_sub(b->pos_m, a->pos_m); // = h (v0+v1)/2 + h^2/12 (a0-a1) + O(h^7)
            orr_vec3 p = orr_vec3_axpy(h / 2, orr_vec3_add(a->vel_mps, b->vel_mps), (orr_vec3){0, 0, 0});
            p = orr_vec3_axpy(h * h / 10, orr_vec3_sub(a->acc_mps2, b->acc_mps2), p);
            // With the jerk's term the rule is h (v0+v1)/2 + h^2/10 (a0-a1) + h^3/120 (j0+j1); j from the
            // accelerations.
            orr_vec3 j = orr_vec3_scale(1 / h, orr_vec3_sub(b->acc_mps2, a->acc_mps2));
            p = orr_vec3_axpy(h * h * h / 60, j, p);
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(dr, p)), 0,
                        2e-3); // j is the mean jerk: off by h^5/720 r^(5), a millimetre
        }
    }
    orr_orbit_solution_free(&s);
    made_sp3_free(&f);
}

static void hourly_nodes_need_passes_and_get_them(void **state)
{
    (void)state;
    orr_sp3 f;
    made_sp3(&sky, all, 3, 0, DAY, 1, &f);
    orr_orbit_solution s;
    orr_smoother_report report;
    orr_diag d = {0};
    orr_smoother_options o = orr_smoother_defaults();
    o.node_step_s = 3600;
    ASSERT_OK(run(&f, 1, &o, &s, &report, NULL, &d), d);
    assert_int_equal(report.nodes_used, 3 * 25);
    assert_true(report.passes_max >= 2);
    for (size_t i = 0; i < 3; i++) {
        double rms, max;
        made_compare(&sky, all[i], &s, 7200, 79200, &rms, &max);
        ASSERT_NEAR(rms, 0, 5e-3);
        // Between hourly nodes sigma is what f0's walk makes of it: not better than the error, nor
        // decimetres.
        const orr_orbit_arc *arc = &made_find(&s, all[i]->sat)->arc[0];
        const double sigma_m = (double)arc->sample[(size_t)(45000 / arc->step_s)].sigma_m;
        assert_true(sigma_m > 0.5 * rms && sigma_m < 20e-3);
    }
    orr_orbit_solution_free(&s);
    made_sp3_free(&f);
}

static void gaps_are_bridged_flagged_and_worth_their_sigma(void **state)
{
    (void)state;
    const double hours[] = {0.5, 1.0, 3.0, 6.0};
    for (size_t n = 0; n < 4; n++) {
        orr_sp3 f;
        made_sp3(&sky, all, 3, 0, DAY, 3, &f);
        orr_interval out = {orr_time_add_s(sky.t0, 36000 + 900),
                            orr_time_add_s(sky.t0, 36900 + hours[n] * 3600)};
        orr_smoother_options o = orr_smoother_defaults();
        o.exclude = &out;
        o.n_exclude = 1;
        orr_orbit_solution s;
        orr_diag d = {0};
        ASSERT_OK(run(&f, 1, &o, &s, NULL, NULL, &d), d);
        for (size_t i = 0; i < 3; i++) {
            double rms, max, inside_rms, inside_max;
            made_compare(&sky, all[i], &s, 36000, 36900 + hours[n] * 3600, &rms, &max);
            made_compare(&sky, all[i], &s, 7200, 30000, &inside_rms, &inside_max);
            if (hours[n] <= 1) ASSERT_NEAR(rms, 0, 3e-3);
            ASSERT_NEAR(inside_rms, 0, 0.5e-3);
            const orr_orbit_sat *sat = made_find(&s, all[i]->sat);
            assert_int_equal(sat->n_arcs, 1);
            assert_int_equal(count_events(&s, sat->sat, ORR_EVENT_GAP, NULL), 1);
            size_t mid = (size_t)((36450 + hours[n] * 1800) / sat->arc[0].step_s);
            const orr_orbit_sample *sample = &sat->arc[0].sample[mid];
            assert_true(sample->flags & ORR_EPH_GAP);
            assert_true(max <
                        5 * (double)sample->sigma_m + 1e-3); // sigma grows with the gap as the error does
        }
        orr_orbit_solution_free(&s);
        made_sp3_free(&f);
    }
}

static void too_long_a_gap_ends_the_arc(void **state)
{
    (void)state;
    orr_sp3 f;
    made_sp3(&sky, all, 3, 0, DAY, 3, &f);
    orr_interval out = {orr_time_add_s(sky.t0, 30000), orr_time_add_s(sky.t0, 66000)};
    orr_smoother_options o = orr_smoother_defaults();
    o.exclude = &out;
    o.n_exclude = 1;
    orr_orbit_solution s;
    orr_diag d = {0};
    ASSERT_OK(run(&f, 1, &o, &s, NULL, NULL, &d), d);
    assert_int_equal(s.sat[0].n_arcs, 2);
    assert_int_equal(count_events(&s, s.sat[0].sat, ORR_EVENT_GAP, NULL), 1);
    orr_orbit_solution_free(&s);
    made_sp3_free(&f);
}

// A file that counts in UTC has its quarters of an hour at 18 s past those of GPS; decimation goes by what it
// says.
static void decimation_goes_by_the_files_own_clock(void **state)
{
    (void)state;
    const orr_scale scale[] = {ORR_SCALE_GPS, ORR_SCALE_UTC, ORR_SCALE_BDT, ORR_SCALE_TAI};
    const int64_t ahead_s[] = {0, 18, 14, -19}; // of the label 00:00, in GPS time
    for (size_t k = 0; k < 4; k++) {
        orr_sp3 f;
        made_sp3(&sky, all, 3, 0, DAY, 1, &f);
        f.scale = scale[k];
        for (size_t e = 0; e < f.n_epochs; e++) f.epoch[e] += ahead_s[k] * ORR_NS_PER_S;
        orr_smoother_options o = orr_smoother_defaults();
        o.node_step_s = 900;
        o.detect = false; // the Earth does not turn as far as the labels were moved
        orr_orbit_solution s;
        orr_smoother_report report;
        orr_diag d = {0};
        ASSERT_OK(run(&f, 1, &o, &s, &report, NULL, &d), d);
        assert_int_equal(report.nodes_used, 3 * 97);
        assert_true(s.from == f.epoch[0] && s.node_step_s > 899 && s.node_step_s < 901);
        orr_orbit_solution_free(&s);
        made_sp3_free(&f);
    }
}

// Five minutes on one day, a quarter of an hour on the next: neither has gaps, and both have clocks.
static void files_of_different_steps_go_together(void **state)
{
    (void)state;
    orr_sp3 f[2];
    made_sp3(&sky, all, 3, 0, DAY, 1, &f[0]);
    made_sp3(&sky, all, 3, DAY, 2 * DAY, 3, &f[1]);
    for (int k = 0; k < 2; k++)
        for (size_t e = 0; e < f[k].n_epochs * 3; e++) f[k].record[e].clock_s = 1e-5;
    orr_orbit_solution s;
    orr_smoother_report report;
    orr_diag d = {0};
    orr_smoother_options o = orr_smoother_defaults();
    ASSERT_OK(run(f, 2, &o, &s, &report, NULL, &d), d);
    assert_int_equal(report.nodes_rejected + report.manoeuvres, 0);
    ASSERT_NEAR(s.node_step_s, 900, 1e-9);
    assert_true(s.clock_max_gap_s > 900 && s.clock_max_gap_s < 1800);
    for (size_t i = 0; i < 3; i++) {
        double rms, max;
        assert_int_equal(count_events(&s, all[i]->sat, ORR_EVENT_GAP, NULL), 0);
        made_compare(&sky, all[i], &s, 7200, 2 * 86400 - 7200, &rms, &max);
        ASSERT_NEAR(max, 0, 2e-3);
    }
    orr_orbit_solution_free(&s);
    made_sp3_free(&f[0]);
    made_sp3_free(&f[1]);
}

static void a_file_given_twice_counts_once(void **state)
{
    (void)state;
    orr_sp3 f;
    made_sp3(&sky, all, 3, 0, DAY, 3, &f);
    orr_smoother_input in[2] = {{.sp3 = &f, .name = "a", .sha256 = "0123"},
                                {.sp3 = &f, .name = "b", .sha256 = "0123"}};
    orr_smoother_options o = orr_smoother_defaults();
    orr_orbit_solution s;
    orr_smoother_report report;
    orr_warnings w = {0};
    orr_diag d = {0};
    ASSERT_OK(orr_smoother_run(in, 2, &o, NULL, NULL, &s, &report, &w, &d), d);
    assert_int_equal(report.nodes_used, 3 * 97);
    assert_int_equal(w.count, 1);
    assert_non_null(strstr(w.item[0].text, "same content"));
    orr_orbit_solution_free(&s);
    orr_warnings_free(&w);
    made_sp3_free(&f);
}

static void predictions_yield_to_observations(void **state)
{
    (void)state;
    orr_sp3 f[2];
    made_sp3(&sky, all, 3, 0, DAY, 3, &f[0]);
    made_sp3(&sky, all, 3, DAY / 2, DAY / 2 + DAY, 3, &f[1]);
    for (size_t e = 49; e < f[0].n_epochs; e++) // the first file's second half is predicted, 20 cm off
        for (size_t i = 0; i < 3; i++) {
            f[0].record[e * 3 + i].flags |= ORR_SP3_ORBIT_PREDICTED;
            f[0].record[e * 3 + i].pos_m[0] += 0.2;
        }
    orr_orbit_solution s;
    orr_diag d = {0};
    orr_smoother_options o = orr_smoother_defaults();
    orr_warnings w = {0};
    ASSERT_OK(run(f, 2, &o, &s, NULL, &w, &d), d);
    assert_int_equal(w.count, 1);
    assert_non_null(strstr(w.item[0].text, "flag P")); // all that overlaps is superseded
    orr_warnings_free(&w);
    double rms, max;
    made_compare(&sky, &gps, &s, 7200, 86400 + 30000, &rms, &max);
    ASSERT_NEAR(max, 0, 2e-3);
    // Alone, the predicted half is flagged.
    orr_orbit_solution alone;
    ASSERT_OK(run(f, 1, &o, &alone, NULL, NULL, &d), d);
    const orr_orbit_arc *arc = &alone.sat[0].arc[0];
    assert_false(arc->sample[10].flags & ORR_EPH_PREDICTED);
    assert_true(arc->sample[arc->n - 10].flags & ORR_EPH_PREDICTED);
    orr_orbit_solution_free(&s);
    orr_orbit_solution_free(&alone);
    made_sp3_free(&f[0]);
    made_sp3_free(&f[1]);
}

static void satellites_come_and_go(void **state)
{
    (void)state;
    orr_sp3 f;
    made_sp3(&sky, all, 3, 0, DAY, 3, &f);
    for (size_t e = 0; e < f.n_epochs;
         e++) // gps only 06:00-09:00; eccentric one node alone; glonass two nodes
        for (size_t i = 0; i < 3; i++) {
            bool keep = i == 0 ? e >= 24 && e <= 36 : i == 1 ? e == 50 : e == 60 || e == 61;
            if (!keep) f.record[e * 3 + i].pos_m[0] = (double)NAN;
        }
    orr_orbit_solution s;
    orr_warnings w = {0};
    orr_diag d = {0};
    orr_smoother_options o = orr_smoother_defaults();
    ASSERT_OK(run(&f, 1, &o, &s, NULL, &w, &d), d);
    assert_null(made_find(&s, eccentric.sat));
    bool told = false;
    for (size_t i = 0; i < w.kept; i++) told = told || strstr(w.item[i].text, "E18") != NULL;
    assert_true(told);
    double rms, max;
    assert_int_equal(made_compare(&sky, &gps, &s, 0, 86400, &rms, &max), 37);
    ASSERT_NEAR(max, 0, 5e-3);
    const orr_orbit_sat *two = made_find(&s, glonass.sat);
    assert_non_null(two); // two nodes make an orbit, and its sigma says what it is worth
    made_compare(&sky, &glonass, &s, 0, 86400, &rms, &max);
    assert_true(max < 5 * (double)two->arc[0].sample[two->arc[0].n / 2].sigma_m + 0.01);
    // They are met whatever they are, so that nothing tells their noise but what was assumed of it: 2.5 cm a
    // coordinate.
    ASSERT_NEAR((double)two->arc[0].sample[0].sigma_m, 0.025 * sqrt(3), 0.002);
    orr_orbit_solution_free(&s);
    orr_warnings_free(&w);
    made_sp3_free(&f);
}

static void threads_do_not_change_a_bit(void **state)
{
    (void)state;
    orr_sp3 f;
    made_sp3(&sky, all, 3, 0, DAY, 3, &f);
    orr_orbit_solution one, four;
    orr_diag d = {0};
    orr_smoother_options o = orr_smoother_defaults();
    ASSERT_OK(run(&f, 1, &o, &one, NULL, NULL, &d), d);
    o.jobs = 4;
    ASSERT_OK(run(&f, 1, &o, &four, NULL, NULL, &d), d);
    for (size_t i = 0; i < 3; i++)
        assert_memory_equal(one.sat[i].arc[0].sample, four.sat[i].arc[0].sample,
                            one.sat[i].arc[0].n * sizeof *one.sat[i].arc[0].sample);
    orr_orbit_solution_free(&one);
    orr_orbit_solution_free(&four);
    made_sp3_free(&f);
}

// The dissertation's letter is reachable and as good as its force model: centimetres inside, a metre and more
// at edges.
static void literal_settings_work_and_are_worse(void **state)
{
    (void)state;
    orr_sp3 f;
    made_sp3(&sky, all, 3, 0, DAY, 3, &f);
    orr_orbit_solution s;
    orr_diag d = {0};
    orr_smoother_options o = orr_smoother_literal();
    ASSERT_OK(run(&f, 1, &o, &s, NULL, NULL, &d), d);
    double rms, max;
    made_compare(&sky, &gps, &s, 7200, 79200, &rms, &max);
    assert_true(rms > 2e-3 && rms < 0.1);
    made_compare(&sky, &gps, &s, 0, 2700, &rms, &max);
    assert_true(max > 0.1);
    orr_orbit_solution_free(&s);
    made_sp3_free(&f);
}

// Earth rotation of other days is carried on, which is said, for a month; of these days it is taken as given.
static void earth_rotation_of_other_days_is_said(void **state)
{
    (void)state;
    orr_sp3 f;
    made_sp3(&sky, all, 3, 0, DAY, 3, &f);
    for (int other = 0; other < 3; other++) {
        double mjd[4], fraction;
        orr_eop value[4];
        for (int k = 0; k < 4; k++) {
            const orr_time t = orr_time_add_s(sky.t0, (k - 1 + 20 * other) * 86400.0);
            int32_t day;
            orr_time_mjd(t, ORR_SCALE_UTC, NULL, &day, &fraction);
            mjd[k] = (double)day + fraction;
            value[k] = orr_eop_at(NULL, t, NULL, NULL);
        }
        const orr_eop_series eop = {4, mjd, value};
        orr_smoother_options o = orr_smoother_defaults();
        o.eop = &eop;
        orr_orbit_solution s;
        orr_smoother_report report;
        orr_warnings w = {0};
        orr_diag d = {0};
        if (other == 2) { // from forty days away, and three satellites do not tell it
            assert_int_equal(run(&f, 1, &o, &s, &report, &w, &d), ORR_E_NODATA);
            assert_non_null(strstr(d.text, "give a file that covers them"));
            continue;
        }
        ASSERT_OK(run(&f, 1, &o, &s, &report, &w, &d), d);
        assert_int_equal(report.eop_known, other == 0);
        assert_int_equal(report.eop_carried_on, other == 1);
        assert_int_equal(w.count, (size_t)other);
        if (other) assert_non_null(strstr(w.item[0].text, "2024-03-29"));
        orr_warnings_free(&w);
        orr_orbit_solution_free(&s);
    }
    made_sp3_free(&f);
}

static void bad_options_and_empty_input_are_said(void **state)
{
    (void)state;
    orr_sp3 f;
    made_sp3(&sky, all, 3, 0, DAY, 3, &f);
    orr_orbit_solution s;
    orr_diag d = {0};
    orr_smoother_options o = orr_smoother_defaults();
    o.sigma_m = 0;
    assert_int_equal(run(&f, 1, &o, &s, NULL, NULL, &d), ORR_E_ARG);
    o = orr_smoother_defaults();
    orr_interval all_day = {f.epoch[0], f.epoch[f.n_epochs - 1] + 1};
    o.exclude = &all_day;
    o.n_exclude = 1;
    assert_int_equal(run(&f, 1, &o, &s, NULL, NULL, &d), ORR_E_NODATA);
    assert_non_null(strstr(d.text, "exclusion"));
    volatile int cancel = 1;
    orr_smoother_input in = {.sp3 = &f};
    o = orr_smoother_defaults();
    assert_int_equal(orr_smoother_run(&in, 1, &o, NULL, &cancel, &s, NULL, NULL, &d), ORR_E_INTERRUPTED);
    // Positions that are no orbit: left out and said, not integrated into nonsense.
    for (size_t e = 0; e < f.n_epochs; e++)
        for (int k = 0; k < 3; k++)
            f.record[e * 3].pos_m[k] = 1000.0 * (double)((e * 7919 + (size_t)k * 104729) % 40000);
    orr_warnings w = {0};
    ASSERT_OK(run(&f, 1, &o, &s, NULL, &w, &d), d);
    assert_int_equal(s.n_sats, 2);
    assert_true(w.count >= 1);
    assert_non_null(strstr(w.item[w.kept - 1].text, "G07"));
    orr_orbit_solution_free(&s);
    orr_warnings_free(&w);
    made_sp3_free(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(inside_the_day_the_smoother_beats_the_rounding),
        cmocka_unit_test(samples_are_one_smooth_curve),
        cmocka_unit_test(hourly_nodes_need_passes_and_get_them),
        cmocka_unit_test(gaps_are_bridged_flagged_and_worth_their_sigma),
        cmocka_unit_test(too_long_a_gap_ends_the_arc),
        cmocka_unit_test(decimation_goes_by_the_files_own_clock),
        cmocka_unit_test(files_of_different_steps_go_together),
        cmocka_unit_test(a_file_given_twice_counts_once),
        cmocka_unit_test(predictions_yield_to_observations),
        cmocka_unit_test(satellites_come_and_go),
        cmocka_unit_test(threads_do_not_change_a_bit),
        cmocka_unit_test(literal_settings_work_and_are_worse),
        cmocka_unit_test(earth_rotation_of_other_days_is_said),
        cmocka_unit_test(bad_options_and_empty_input_are_said),
    };
    return cmocka_run_group_tests(tests, make_truth, drop_truth);
}
