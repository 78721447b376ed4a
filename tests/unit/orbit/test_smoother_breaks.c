// SPDX-License-Identifier: GPL-3.0-or-later
// The smoother where nodes are wrong, satellites are pushed, and files do not meet: each told from the others.
#include "testing.h"

#include "orbit/ephemeris/ephemeris.h"
#include "unit/orbit/smoother_made.h"

static void outliers_are_reported_and_not_followed(void **state)
{
    (void)state;
    const double size[] = {1.0, 100.0, 2e3, 1e5};  // from what is hardly seen to what spoils a linearisation
    const size_t where[] = {1, 40, 41, 90, 96, 0}; // young, inside, next to each other, near and at the ends
    for (int k = 0; k < 4; k++)
        for (size_t n = 0; n < 6; n++) {
            orr_sp3 f;
            made_sp3(&sky, all, 3, 0, DAY, 3, &f);
            orr_time bad = orr_time_add_s(sky.t0, 900.0 * (double)where[n]);
            made_record(&f, gps.sat, bad)->pos_m[1] += size[k];
            if (n == 2) made_record(&f, gps.sat, orr_time_add_s(bad, -900))->pos_m[1] += size[k];
            orr_orbit_solution s;
            orr_smoother_report report;
            orr_diag d = {0};
            orr_smoother_options o = orr_smoother_defaults();
            ASSERT_OK(run(&f, 1, &o, &s, &report, NULL, &d), d);
            assert_int_equal(report.nodes_rejected, n == 2 ? 2 : 1);
            double rms, max;
            size_t compared = made_compare(&sky, &gps, &s, 0, 86400, &rms, &max);
            assert_true(compared >= DAY - 3);
            ASSERT_NEAR(max, 0, 0.01);
            const orr_orbit_event *e = NULL;
            assert_int_equal(count_events(&s, gps.sat, ORR_EVENT_OUTLIER, &e), n == 2 ? 2 : 1);
            assert_true(e->t0 == bad);
            ASSERT_NEAR(e->value, size[k], 0.01);
            assert_int_equal(count_events(&s, gps.sat, ORR_EVENT_MANOEUVRE, NULL), 0);
            orr_orbit_solution_free(&s);
            made_sp3_free(&f);
        }
}

// Between nodes half an hour and an hour apart a prediction errs by as much as the outlier: what is good
// after it must not be blamed for it. The orbit through all others tells.
static void sparse_nodes_tell_outliers_from_both_sides(void **state)
{
    (void)state;
    const size_t step[] = {6, 12};
    const double size[] = {1.0, 3.0, 10.0};
    for (int k = 0; k < 2; k++)
        for (int n = 0; n < 3; n++) {
            orr_sp3 f;
            made_sp3(&sky, all, 3, 0, DAY, step[k], &f);
            const double at_s[3] = {5 * 3600.0, 12 * 3600.0, 18 * 3600.0}; // one in each satellite
            for (size_t i = 0; i < 3; i++)
                made_record(&f, all[i]->sat, orr_time_add_s(sky.t0, at_s[i]))->pos_m[n] += size[n];
            orr_orbit_solution s;
            orr_smoother_report report;
            orr_diag d = {0};
            orr_smoother_options o = orr_smoother_defaults();
            ASSERT_OK(run(&f, 1, &o, &s, &report, NULL, &d), d);
            assert_int_equal(report.nodes_rejected, 3);
            assert_int_equal(report.manoeuvres, 0);
            for (size_t i = 0; i < 3; i++) {
                const orr_orbit_event *e = NULL;
                assert_int_equal(count_events(&s, all[i]->sat, ORR_EVENT_OUTLIER, &e), 1);
                assert_true(e->t0 == orr_time_add_s(sky.t0, at_s[i]));
                ASSERT_NEAR(e->value, size[n], 0.02); // two hours without a node: a centimetre
                double rms, max;
                made_compare(&sky, all[i], &s, 7200, 79200, &rms, &max);
                ASSERT_NEAR(max, 0, 0.02);
            }
            orr_orbit_solution_free(&s);
            made_sp3_free(&f);
        }
}

// Nodes that are missing are no reason to doubt the others, first ones before a gap least of all; and an
// outlier right after a gap is no manoeuvre.
static void missing_nodes_make_no_outliers(void **state)
{
    (void)state;
    for (unsigned pattern = 0; pattern < 32; pattern++) {
        orr_sp3 f;
        made_sp3(&sky, all, 3, 0, DAY, 3, &f);
        for (size_t e = 0; e < f.n_epochs;
             e++) // of the first ten nodes some, then every seventh, are not there
            for (size_t i = 0; i < 3; i++)
                if ((e >= 2 && e < 7 && (pattern >> (e - 2) & 1) != 0) || (e > 7 && e % 7 == 0))
                    f.record[e * 3 + i].pos_m[0] = (double)NAN;
        const bool spoilt = pattern % 4 == 3;
        if (spoilt)
            made_record(&f, gps.sat, orr_time_add_s(sky.t0, 50 * 900.0))->pos_m[1] += 1.0; // 49 is missing
        orr_orbit_solution s;
        orr_smoother_report report;
        orr_diag d = {0};
        orr_smoother_options o = orr_smoother_defaults();
        ASSERT_OK(run(&f, 1, &o, &s, &report, NULL, &d), d);
        assert_int_equal(report.nodes_rejected, spoilt ? 1 : 0);
        assert_int_equal(report.manoeuvres, 0);
        const orr_orbit_event *e = NULL;
        assert_int_equal(count_events(&s, gps.sat, ORR_EVENT_OUTLIER, &e), spoilt ? 1 : 0);
        if (spoilt) assert_true(e->t0 == orr_time_add_s(sky.t0, 50 * 900.0));
        orr_orbit_solution_free(&s);
        made_sp3_free(&f);
    }
}

static void manoeuvre_is_found_placed_and_passed(void **state)
{
    (void)state;
    const made_truth *const with[] = {&pushed};
    for (int flagged = 0; flagged < 2; flagged++) {
        orr_sp3 f;
        made_sp3(&sky, with, 1, 0, DAY, 3, &f);
        if (flagged)
            made_record(&f, pushed.sat, orr_time_add_s(sky.t0, 11 * 3600.0 + 45 * 60))->flags |=
                ORR_SP3_MANOEUVRE;
        orr_orbit_solution s;
        orr_smoother_report report;
        orr_diag d = {0};
        orr_smoother_options o = orr_smoother_defaults();
        ASSERT_OK(run(&f, 1, &o, &s, &report, NULL, &d), d);
        assert_int_equal(report.manoeuvres, 1);
        assert_int_equal(report.nodes_rejected, 0);
        const orr_orbit_event *e = NULL;
        assert_int_equal(count_events(&s, pushed.sat, ORR_EVENT_MANOEUVRE, &e), 1);
        orr_time push = orr_time_add_s(sky.t0, PUSH_S);
        assert_true(e->t0 < push && e->t1 > push && e->t1 - e->t0 == 900 * ORR_NS_PER_S);
        ASSERT_NEAR(e->value, 0.10, 0.001);
        const orr_orbit_sat *sat = made_find(&s, pushed.sat);
        assert_int_equal(sat->n_arcs, 2);
        // The arcs meet where the push was: velocity uncertain to 1e-5 m/s of 0.1 m/s leaves a fraction of a
        // second.
        ASSERT_NEAR(orr_time_diff_s(sat->arc[1].t0, push), 0, 1.0);
        double rms, max;
        made_compare(&sky, &pushed, &s, 7200, 10 * 3600, &rms, &max);
        ASSERT_NEAR(max, 0, 0.002);
        made_compare(&sky, &pushed, &s, 13 * 3600, 79200, &rms, &max);
        ASSERT_NEAR(max, 0, 0.003);
        orr_orbit_solution_free(&s);
        made_sp3_free(&f);
    }
}

static void without_detection_nothing_is_rejected(void **state)
{
    (void)state;
    orr_sp3 f;
    made_sp3(&sky, all, 3, 0, DAY, 3, &f);
    made_record(&f, gps.sat, orr_time_add_s(sky.t0, 36000))->pos_m[0] += 100;
    orr_orbit_solution s;
    orr_smoother_report report;
    orr_diag d = {0};
    orr_smoother_options o = orr_smoother_defaults();
    o.detect = false;
    ASSERT_OK(run(&f, 1, &o, &s, &report, NULL, &d), d);
    assert_int_equal(report.nodes_rejected, 0);
    orr_orbit_solution_free(&s);
    made_sp3_free(&f);
}

// Two days whose files disagree by centimetres: one continuous orbit, the jump told.
static void midnight_is_continuous_and_its_jump_reported(void **state)
{
    (void)state;
    orr_sp3 f[2];
    made_sp3(&sky, all, 3, 0, DAY, 3, &f[0]);
    made_sp3(&sky, all, 3, DAY, 2 * DAY, 3, &f[1]);
    for (size_t e = 0; e < f[1].n_epochs; e++)
        for (size_t i = 0; i < 3; i++) f[1].record[e * 3 + i].pos_m[2] += 0.03;
    orr_orbit_solution s;
    orr_smoother_report report;
    orr_warnings w = {0};
    orr_diag d = {0};
    orr_smoother_options o = orr_smoother_defaults();
    ASSERT_OK(run(f, 2, &o, &s, &report, &w, &d), d);
    assert_int_equal(report.nodes_rejected, 0);
    assert_int_equal(w.count, 0); // files that join do not overlap
    for (size_t i = 0; i < 3; i++) {
        const orr_orbit_event *e = NULL;
        assert_int_equal(s.sat[i].n_arcs, 1);
        assert_int_equal(count_events(&s, s.sat[i].sat, ORR_EVENT_DAY_JUMP, &e), 1);
        ASSERT_NEAR(e->value, 0.03, 0.002);
        double rms, max;
        made_compare(&sky, made_find(&s, all[i]->sat) != NULL ? all[i] : NULL, &s, 7200, 70000, &rms, &max);
        ASSERT_NEAR(max, 0, 2e-3); // hours before midnight nothing of the jump is left
    }
    // The same in the other order of files, to the bit.
    orr_sp3 swapped[2] = {f[1], f[0]};
    orr_orbit_solution s2;
    ASSERT_OK(run(swapped, 2, &o, &s2, NULL, NULL, &d), d);
    for (size_t i = 0; i < 3; i++)
        assert_memory_equal(s.sat[i].arc[0].sample, s2.sat[i].arc[0].sample,
                            s.sat[i].arc[0].n * sizeof *s.sat[i].arc[0].sample);
    orr_orbit_solution_free(&s);
    orr_orbit_solution_free(&s2);
    orr_warnings_free(&w);
    made_sp3_free(&f[0]);
    made_sp3_free(&f[1]);
}

// A day that goes on 0.8 m elsewhere, with no instant in common: nobody pushed the satellite. One orbit goes
// over from one file to the other, and the jump is told.
static void files_that_disagree_by_a_metre_are_no_manoeuvre(void **state)
{
    (void)state;
    orr_sp3 f[2];
    made_sp3(&sky, all, 3, 0, DAY - 3, 3, &f[0]);
    made_sp3(&sky, all, 3, DAY, 2 * DAY, 3, &f[1]);
    for (size_t e = 0; e < f[1].n_epochs; e++)
        for (size_t i = 0; i < 3; i++) f[1].record[e * 3 + i].pos_m[2] += 0.8;
    orr_orbit_solution s;
    orr_smoother_report report;
    orr_diag d = {0};
    orr_smoother_options o = orr_smoother_defaults();
    ASSERT_OK(run(f, 2, &o, &s, &report, NULL, &d), d);
    assert_int_equal(report.nodes_rejected + report.manoeuvres, 0);
    for (size_t i = 0; i < 3; i++) {
        const orr_orbit_event *e = NULL;
        assert_int_equal(made_find(&s, all[i]->sat)->n_arcs, 1);
        assert_int_equal(count_events(&s, all[i]->sat, ORR_EVENT_DAY_JUMP, &e), 1);
        assert_true(e->t0 == f[1].epoch[0]);
        // The first day's prediction errs by centimetres, and what follows the first node adds to it.
        assert_true(e->value > 0.7 && e->value < 2.0);
        double rms, max;
        made_compare(&sky, all[i], &s, 7200, 70000, &rms, &max);
        ASSERT_NEAR(max, 0, 3e-3); // four hours before midnight next to nothing of the jump is left
    }
    orr_orbit_solution_free(&s);
    made_sp3_free(&f[0]);
    made_sp3_free(&f[1]);
}

// Half an hour after a joint, or with the joint in its very interval, a push remains a push.
static void a_push_near_a_joint_is_found(void **state)
{
    (void)state;
    const made_truth *const with[] = {&pushed};
    const size_t joint[] = {132, 135, 138, 141}; // the push is between epochs 138 and 141
    for (size_t n = 0; n < 4; n++) {
        orr_sp3 f[2];
        made_sp3(&sky, with, 1, 0, joint[n] - 3, 3, &f[0]);
        made_sp3(&sky, with, 1, joint[n], DAY, 3, &f[1]);
        orr_orbit_solution s;
        orr_smoother_report report;
        orr_diag d = {0};
        orr_smoother_options o = orr_smoother_defaults();
        ASSERT_OK(run(f, 2, &o, &s, &report, NULL, &d), d);
        assert_int_equal(report.manoeuvres, 1);
        assert_int_equal(report.nodes_rejected, 0);
        const orr_orbit_event *e = NULL;
        assert_int_equal(count_events(&s, pushed.sat, ORR_EVENT_MANOEUVRE, &e), 1);
        ASSERT_NEAR(e->value, 0.10, 0.001);
        assert_int_equal(count_events(&s, pushed.sat, ORR_EVENT_DAY_JUMP, NULL), 0);
        orr_orbit_solution_free(&s);
        made_sp3_free(&f[0]);
        made_sp3_free(&f[1]);
    }
}

// Three nodes before or after a push are told from wrong ones, flagged or not: the orbits meet where the push was.
static void a_push_near_an_end_is_found(void **state)
{
    (void)state;
    const made_truth *const with[] = {&pushed};        // at 11:37:30
    const size_t from[] = {132, 0}, to[] = {DAY, 147}; // 11:00, 11:15, 11:30; 11:45, 12:00, 12:15
    for (int k = 0; k < 4; k++) {
        const int end = k % 2;
        orr_sp3 f;
        made_sp3(&sky, with, 1, from[end], to[end], 3, &f);
        if (k > 1) made_record(&f, pushed.sat, orr_time_add_s(sky.t0, 42300))->flags |= ORR_SP3_MANOEUVRE;
        orr_orbit_solution s;
        orr_smoother_report report;
        orr_diag d = {0};
        orr_smoother_options o = orr_smoother_defaults();
        ASSERT_OK(run(&f, 1, &o, &s, &report, NULL, &d), d);
        const orr_orbit_event *e = NULL;
        assert_int_equal(report.nodes_rejected, 0);
        assert_int_equal(report.manoeuvres, 1);
        assert_int_equal(count_events(&s, pushed.sat, ORR_EVENT_MANOEUVRE, &e), 1);
        ASSERT_NEAR(e->value, 0.10, 0.001);
        double rms, max;
        made_compare(&sky, &pushed, &s, 39600, 41400, &rms, &max);
        ASSERT_NEAR(max, 0, 0.01); // three nodes alone
        made_compare(&sky, &pushed, &s, 42300, 44100, &rms, &max);
        ASSERT_NEAR(max, 0, 0.01);
        orr_orbit_solution_free(&s);
        made_sp3_free(&f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(outliers_are_reported_and_not_followed),
        cmocka_unit_test(sparse_nodes_tell_outliers_from_both_sides),
        cmocka_unit_test(missing_nodes_make_no_outliers),
        cmocka_unit_test(manoeuvre_is_found_placed_and_passed),
        cmocka_unit_test(without_detection_nothing_is_rejected),
        cmocka_unit_test(midnight_is_continuous_and_its_jump_reported),
        cmocka_unit_test(files_that_disagree_by_a_metre_are_no_manoeuvre),
        cmocka_unit_test(a_push_near_a_joint_is_found),
        cmocka_unit_test(a_push_near_an_end_is_found),
    };
    return cmocka_run_group_tests(tests, make_truth, drop_truth);
}
