// SPDX-License-Identifier: GPL-3.0-or-later
// All systems' orbits, geosynchronous ones included, and more satellites than any constellation has: through
// the SP3 reader, the smoother, the product and its states.
#include "testing.h"

#include <unistd.h>

#include "made_sp3.h"
#include "orbit/ephemeris/ephemeris.h"
#include "orbit/smooth/smoother.h"

#define DAY 288 // epochs of 300 s
#define N_CLASSES 9
#define MANY 160

static made_sky sky;
static made_truth truth[N_CLASSES];
static const struct {
    const char *name;
    char system;
    int number;
    double a_m, e, incl;
} class_of[N_CLASSES] = {
    {"GPS", 'G', 7, 2.656e7, 0.01, 0.96},           {"GLONASS", 'R', 3, 2.551e7, 0.001, 1.13},
    {"Galileo", 'E', 11, 2.960e7, 0.0003, 0.98},    {"BeiDou MEO", 'C', 30, 2.790e7, 0.0008, 0.96},
    {"BeiDou IGSO", 'C', 8, 4.2164e7, 0.004, 0.98}, {"BeiDou GEO", 'C', 3, 4.2164e7, 0.0004, 0.02},
    {"QZSS", 'J', 2, 4.2164e7, 0.075, 0.72},        {"NavIC IGSO", 'I', 4, 4.2164e7, 0.002, 0.5},
    {"SBAS GEO", 'S', 23, 4.2164e7, 0.0003, 0.001},
};
#define IS_SYNCHRONOUS(k) ((k) >= 4)

static int make_truth(void **state)
{
    (void)state;
    made_sky_init(&sky, "2024-03-10", 1); // near the equinox: geostationary satellites are eclipsed daily
    for (int k = 0; k < N_CLASSES; k++)
        made_orbit(&sky, orr_sat_make(class_of[k].system, class_of[k].number), class_of[k].a_m, class_of[k].e,
                   class_of[k].incl, 0.7 * k, 2.0 + 0.9 * k, 2e-8, -1, 0, &truth[k]);
    return 0;
}
static int drop_truth(void **state)
{
    (void)state;
    made_sky_free(&sky);
    return 0;
}

static void sp3_of_all(orr_sp3 *f)
{
    const made_truth *all[N_CLASSES];
    for (int k = 0; k < N_CLASSES; k++) all[k] = &truth[k];
    made_sp3(&sky, all, N_CLASSES, 0, DAY, 3, f);
}

static void run(const orr_sp3 *f, const orr_smoother_options *o, orr_orbit_solution *s,
                orr_smoother_report *report)
{
    orr_smoother_input in = {.sp3 = f, .name = "made.sp3"};
    orr_diag d = {0};
    ASSERT_OK(orr_smoother_run(&in, 1, o, NULL, NULL, s, report, NULL, &d), d);
}

// SP3's rounding is 0.5 mm in 3-D per node; a smoother comes out below it inside the day whatever the orbit.
// A geosynchronous orbit bends four times less, so nothing is harder there.
static void every_kind_of_orbit_is_smoothed(void **state)
{
    (void)state;
    orr_sp3 f;
    orr_orbit_solution s;
    orr_smoother_report report;
    const orr_smoother_options o = orr_smoother_defaults();
    sp3_of_all(&f);
    run(&f, &o, &s, &report);
    assert_int_equal(s.n_sats, N_CLASSES);
    assert_int_equal(report.nodes_rejected + report.manoeuvres, 0);
    for (int k = 0; k < N_CLASSES; k++) {
        double rms, max, edge_rms, edge_max;
        assert_true(made_compare(&sky, &truth[k], &s, 7200, 79200, &rms, &max) > 200);
        made_compare(&sky, &truth[k], &s, 0, 86400, &edge_rms, &edge_max);
        print_message("%-12s inside %.2f mm RMS, %.2f mm at most; with the edges %.2f mm at most\n",
                      class_of[k].name, 1e3 * rms, 1e3 * max, 1e3 * edge_max);
        ASSERT_NEAR(rms, 0, 0.5e-3);
        ASSERT_NEAR(max, 0, 2e-3);
        ASSERT_NEAR(edge_max, 0, 4e-3); // one-sided
    }
    orr_orbit_solution_free(&s);
    made_sp3_free(&f);
}

static void outliers_are_not_followed_anywhere(void **state)
{
    (void)state;
    const double size[] = {1.0, 100.0};
    const size_t where[] = {1, 40, 41, 90, 96}; // young, inside, two in a row, near and at the end
    for (int m = 0; m < 2; m++)
        for (size_t n = 0; n < 5; n++) {
            orr_sp3 f;
            orr_orbit_solution s;
            orr_smoother_report report;
            const orr_smoother_options o = orr_smoother_defaults();
            const orr_time bad = orr_time_add_s(sky.t0, 900.0 * (double)where[n]);
            const size_t each = n == 2 ? 2 : 1;
            sp3_of_all(&f);
            for (int k = 0; k < N_CLASSES; k++) {
                made_record(&f, truth[k].sat, bad)->pos_m[k % 3] += size[m];
                if (each == 2)
                    made_record(&f, truth[k].sat, orr_time_add_s(bad, -900))->pos_m[k % 3] += size[m];
            }
            run(&f, &o, &s, &report);
            assert_int_equal(report.nodes_rejected, N_CLASSES * each);
            assert_int_equal(report.manoeuvres, 0);
            for (int k = 0; k < N_CLASSES; k++) {
                double rms, max;
                made_compare(&sky, &truth[k], &s, 0, 86400, &rms, &max);
                if (max > 0.01)
                    fail_msg("%s, %g m at node %zu: %.4f m", class_of[k].name, size[m], where[n], max);
            }
            orr_orbit_solution_free(&s);
            made_sp3_free(&f);
        }
}

// One node missing costs nothing that rounding does not; longer gaps cost what their sigma says, up to six
// hours.
static void gaps_are_bridged_anywhere(void **state)
{
    (void)state;
    const double hours[] = {0.25, 1, 3, 6};
    for (size_t n = 0; n < 4; n++) {
        orr_sp3 f;
        orr_orbit_solution s;
        orr_smoother_options o = orr_smoother_defaults();
        orr_interval out = {orr_time_add_s(sky.t0, 36900), orr_time_add_s(sky.t0, 36900 + hours[n] * 3600)};
        sp3_of_all(&f);
        o.exclude = &out;
        o.n_exclude = 1;
        run(&f, &o, &s, NULL);
        for (int k = 0; k < N_CLASSES; k++) {
            double rms, max;
            const orr_orbit_sat *sat = made_find(&s, truth[k].sat);
            assert_int_equal(sat->n_arcs, 1);
            made_compare(&sky, &truth[k], &s, 36000, 36900 + hours[n] * 3600, &rms, &max);
            const size_t middle = (size_t)((36450 + hours[n] * 1800) / sat->arc[0].step_s);
            const orr_orbit_sample *sample = &sat->arc[0].sample[middle];
            if (hours[n] <= 1) ASSERT_NEAR(rms, 0, 3e-3);
            assert_true(hours[n] < 1 || (sample->flags & ORR_EPH_GAP) != 0);
            if (!(max < 5 * (double)sample->sigma_m + 1e-3))
                fail_msg("%s, %g h: %.4f m, sigma %.4f m", class_of[k].name, hours[n], max,
                         (double)sample->sigma_m);
        }
        orr_orbit_solution_free(&s);
        made_sp3_free(&f);
    }
}

// Geosynchronous satellites are pushed back to their places every few weeks, by centimetres to metres a
// second.
static void station_keeping_is_found_and_placed(void **state)
{
    (void)state;
    static made_truth pushed[3];
    const double push[] = {0.05, 0.3, 2.0}, when = 9 * 3600.0 + 20 * 60 + 50; // kicks are given every 50 s
    const made_truth *all[3];
    for (int k = 0; k < 3; k++) {
        const int like = 4 + k; // IGSO, GEO, QZSS
        made_orbit(&sky, truth[like].sat, class_of[like].a_m, class_of[like].e, class_of[like].incl,
                   0.7 * like, 2.0 + 0.9 * like, 2e-8, when, push[k], &pushed[k]);
        all[k] = &pushed[k];
    }
    orr_sp3 f;
    orr_orbit_solution s;
    orr_smoother_report report;
    const orr_smoother_options o = orr_smoother_defaults();
    made_sp3(&sky, all, 3, 0, DAY, 3, &f);
    run(&f, &o, &s, &report);
    assert_int_equal(report.manoeuvres, 3);
    assert_int_equal(report.nodes_rejected, 0);
    for (int k = 0; k < 3; k++) {
        const orr_orbit_sat *sat = made_find(&s, pushed[k].sat);
        double rms, max;
        assert_int_equal(sat->n_arcs, 2);
        // The velocity between the arcs is known to 1e-5 m/s: a part of the push in time.
        ASSERT_NEAR(orr_time_diff_s(sat->arc[1].t0, sky.t0), when, 1.0 + 0.1 / push[k]);
        for (size_t i = 0; i < sat->n_events; i++)
            if (sat->event[i].kind == ORR_EVENT_MANOEUVRE) ASSERT_NEAR(sat->event[i].value, push[k], 0.001);
        made_compare(&sky, &pushed[k], &s, 7200, 8 * 3600, &rms, &max);
        ASSERT_NEAR(max, 0, 3e-3);
        made_compare(&sky, &pushed[k], &s, 11 * 3600, 79200, &rms, &max);
        ASSERT_NEAR(max, 0, 3e-3);
    }
    orr_orbit_solution_free(&s);
    made_sp3_free(&f);
}

// G01-G36, R01-R30, E01-E36, C01-C45, J01-J07, S20-S25: 160 in all, those of a system on its classes' orbits
// in turn. Every tenth appears at 02:00, every other tenth vanishes at 04:00.
static size_t name_many(orr_sat *sat, int *class)
{
    const struct {
        char system;
        int first, last;
    } range[] = {{'G', 1, 36}, {'R', 1, 30}, {'E', 1, 36}, {'C', 1, 45}, {'J', 1, 7}, {'S', 20, 25}};
    size_t n = 0;
    for (size_t i = 0; i < sizeof range / sizeof range[0]; i++)
        for (int p = range[i].first; p <= range[i].last; p++, n++) {
            int of_system[N_CLASSES], m = 0;
            for (int k = 0; k < N_CLASSES; k++)
                if (class_of[k].system == range[i].system) of_system[m++] = k;
            sat[n] = orr_sat_make(range[i].system, p);
            class[n] = of_system[p % m];
        }
    return n;
}
static bool is_late(size_t i) { return i % 20 == 7; }
static bool is_early(size_t i) { return i % 20 == 17; }

static void make_many(const orr_sat *sat, const int *class, orr_sp3 *f)
{
    const made_truth *all[MANY];
    orr_sp3 made;
    orr_diag d = {0};
    for (size_t i = 0; i < MANY; i++) all[i] = &truth[class[i]];
    made_sp3(&sky, all, MANY, 0, 72, 3, &made); // six hours
    ASSERT_OK(orr_sp3_alloc(MANY, made.n_epochs, f, &d), d);
    f->version = 'd';
    f->interval_s = made.interval_s;
    for (size_t i = 0; i < MANY; i++) f->sat[i] = sat[i];
    for (size_t e = 0; e < f->n_epochs; e++) {
        f->epoch[e] = made.epoch[e];
        for (size_t i = 0; i < MANY; i++) {
            if ((is_late(i) && e < 8) || (is_early(i) && e > 16)) continue;
            const orr_sp3_record *from = &made.record[e * MANY + i];
            orr_sp3_record *r = &f->record[e * MANY + i];
            memcpy(r->pos_m, from->pos_m, sizeof r->pos_m);
            r->clock_s = from->clock_s + 1e-7 * (double)i; // each its own
        }
    }
    made_sp3_free(&made);
}

static void many_satellites_go_all_the_way(void **state)
{
    (void)state;
    orr_sat sat[MANY];
    int class[MANY];
    assert_int_equal(name_many(sat, class), MANY);
    orr_sp3 made, read;
    orr_diag d = {0};
    make_many(sat, class, &made);
    char path[] = "/tmp/orrery-constellation-XXXXXX";
    const int fd = mkstemp(path);
    assert_true(fd >= 0);
    close(fd);
    ASSERT_OK(orr_sp3_write(&made, path, &d), d);
    ASSERT_OK(orr_sp3_read(path, NULL, &read, NULL, &d), d);
    remove(path);
    assert_int_equal(read.n_sats, MANY);

    orr_orbit_solution s;
    orr_smoother_report report;
    orr_smoother_options o = orr_smoother_defaults();
    o.jobs = 2;
    run(&read, &o, &s, &report);
    assert_int_equal(s.n_sats, MANY);
    assert_int_equal(report.nodes_rejected + report.manoeuvres, 0);
    orr_ephemeris *e = NULL;
    ASSERT_OK(orr_ephemeris_build(&s, &e, &d), d);
    const orr_sat *list;
    assert_int_equal(orr_ephemeris_satellites(e, &list), MANY);

    static orr_sat_state out[MANY];
    for (double h = 0.5; h < 6; h += 1) { // 06, 18, 30 ... epochs of the truth
        const orr_time t = orr_time_add_s(sky.t0, h * 3600);
        const size_t n = orr_ephemeris_eval_all(e, t, out, MANY), epoch = (size_t)(h * 12);
        size_t expected = 0, found = 0;
        for (size_t i = 0; i < MANY; i++) {
            const bool there = !(is_late(i) && h < 2) && !(is_early(i) && h > 4);
            orr_sat_state one;
            expected += there;
            assert_int_equal(orr_ephemeris_eval(e, sat[i], t, &one), there ? ORR_OK : ORR_E_NODATA);
            for (size_t k = 0; k < n && there; k++) {
                if (out[k].sat != sat[i]) continue;
                found++;
                const orr_vec3 error = orr_vec3_sub(out[k].pos_m, truth[class[i]].r[epoch]);
                ASSERT_NEAR(orr_vec3_norm(error), 0, 5e-3); // six hours have two edges
                ASSERT_NEAR(out[k].clock_s, 1e-5 + 1e-11 * h * 3600 + 1e-7 * (double)i, 1e-12);
            }
        }
        assert_int_equal(n, expected);
        assert_int_equal(found, expected);
    }
    // A caller's array that is too short is filled and no further.
    out[100].sat = ORR_SAT_NONE;
    assert_int_equal(orr_ephemeris_eval_all(e, orr_time_add_s(sky.t0, 9000), out, 100), 100);
    assert_int_equal(out[100].sat, ORR_SAT_NONE);
    orr_ephemeris_free(e);
    orr_orbit_solution_free(&s);
    orr_sp3_free(&read);
    orr_sp3_free(&made);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kind_of_orbit_is_smoothed),
        cmocka_unit_test(outliers_are_not_followed_anywhere),
        cmocka_unit_test(gaps_are_bridged_anywhere),
        cmocka_unit_test(station_keeping_is_found_and_placed),
        cmocka_unit_test(many_satellites_go_all_the_way),
    };
    return cmocka_run_group_tests(tests, make_truth, drop_truth);
}
