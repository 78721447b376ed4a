// SPDX-License-Identifier: GPL-3.0-or-later
// The smoother on made orbits: right when all is well, honest when it is not.
#include "testing.h"

#include "made_sp3.h"
#include "orbit/ephemeris/ephemeris.h"
#include "orbit/smooth/smoother.h"

static made_sky sky;
static made_truth gps, eccentric, glonass, pushed; // pushed: 0.10 m/s along track at 11:37:30
#define PUSH_S (11 * 3600.0 + 37 * 60 + 30)

static int make_truth(void **state)
{
    (void)state;
    made_sky_init(&sky, "2024-03-10", 2); // eclipse season of some planes
    made_orbit(&sky, orr_sat_make('G', 7), 2.656e7, 0.01, 0.96, 0.3, 1.0, 2e-8, -1, 0, &gps);
    made_orbit(&sky, orr_sat_make('E', 18), 2.798e7, 0.16, 0.87, 2.0, 4.0, 2e-8, -1, 0, &eccentric);
    made_orbit(&sky, orr_sat_make('R', 3), 2.551e7, 0.001, 1.13, 4.0, 2.0, 3e-8, -1, 0, &glonass);
    made_orbit(&sky, orr_sat_make('G', 11), 2.656e7, 0.005, 0.95, 5.0, 3.0, 2e-8, PUSH_S, 0.10, &pushed);
    return 0;
}
static int drop_truth(void **state)
{
    (void)state;
    made_sky_free(&sky);
    return 0;
}

static const made_truth *const all[] = {&gps, &eccentric, &glonass};
#define DAY 288 // epochs of 300 s

static orr_status run(const orr_sp3 *files, size_t n, const orr_smoother_options *o, orr_orbit_solution *s,
                      orr_smoother_report *report, orr_warnings *w, orr_diag *d)
{
    orr_smoother_input in[4] = {{0}};
    for (size_t i = 0; i < n; i++) {
        in[i].sp3 = &files[i];
        snprintf(in[i].name, sizeof in[i].name, "made%zu.sp3", i);
    }
    return orr_smoother_run(in, n, o, NULL, NULL, s, report, w, d);
}

static size_t count_events(const orr_orbit_solution *s, orr_sat sat, orr_event_kind kind,
                           const orr_orbit_event **last)
{
    const orr_orbit_sat *q = made_find(s, sat);
    size_t n = 0;
    for (size_t i = 0; q != NULL && i < q->n_events; i++)
        if (q->event[i].kind == kind) {
            n++;
            if (last != NULL) *last = &q->event[i];
        }
    return n;
}

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
        cmocka_unit_test(outliers_are_reported_and_not_followed),
        cmocka_unit_test(sparse_nodes_tell_outliers_from_both_sides),
        cmocka_unit_test(missing_nodes_make_no_outliers),
        cmocka_unit_test(manoeuvre_is_found_placed_and_passed),
        cmocka_unit_test(without_detection_nothing_is_rejected),
        cmocka_unit_test(gaps_are_bridged_flagged_and_worth_their_sigma),
        cmocka_unit_test(too_long_a_gap_ends_the_arc),
        cmocka_unit_test(midnight_is_continuous_and_its_jump_reported),
        cmocka_unit_test(files_that_disagree_by_a_metre_are_no_manoeuvre),
        cmocka_unit_test(a_push_near_a_joint_is_found),
        cmocka_unit_test(a_push_near_an_end_is_found),
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
