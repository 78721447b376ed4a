// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of velocity at noon that all orbits of a file have are found and told, and not where there are none; the votes on
// the noise near the shadow.
#include "testing.h"

#include "made_sp3.h"
#include "orbit/smooth/file_noise.h"
#include "orbit/smooth/smoother.h"

#define SATS 6
#define MANY 9
#define DAY 288 // epochs of 300 s

static size_t noon_steps(const orr_orbit_solution *s, double *mean_mps)
{
    size_t n = 0;
    *mean_mps = 0;
    for (size_t i = 0; i < s->n_sats; i++)
        for (size_t k = 0; k < s->sat[i].n_events; k++) {
            const orr_orbit_event *e = &s->sat[i].event[k];
            if (e->kind != ORR_EVENT_NOON_STEP) continue;
            assert_true(e->t0 == e->t1 && (e->t0 / ORR_NS_PER_S) % 86400 == 43200);
            *mean_mps += e->value;
            n++;
        }
    if (n > 0) *mean_mps /= (double)n;
    return n;
}

// Satellites whose nodes are `apart` rad from each other, as a file of so many epochs; a push at noon, none with 0.
static void make_file(int n, double apart, size_t epochs, double push_mps, made_sky *sky, made_truth *truth,
                      orr_sp3 *f)
{
    const made_truth *all[MANY];
    made_sky_init(sky, "2024-04-20", (double)epochs / DAY);
    for (int k = 0; k < n; k++) {
        made_orbit(sky, orr_sat_make('G', k + 1), 2.656e7, 0.005, 0.96, apart * k, 2.0 + 0.9 * k, 0,
                   push_mps > 0 ? 43200 : -1, push_mps, &truth[k]);
        all[k] = &truth[k];
    }
    made_sp3(sky, all, (size_t)n, 0, epochs, 3, f);
}

static void smooth(const orr_sp3 *f, orr_orbit_solution *s, orr_smoother_report *report,
                   orr_warnings *warnings)
{
    const orr_smoother_input in = {.sp3 = f, .name = "made.sp3"};
    const orr_smoother_options o = orr_smoother_defaults();
    orr_diag d = {0};
    ASSERT_OK(orr_smoother_run(&in, 1, &o, NULL, NULL, s, report, warnings, &d), d);
}

// Orbits as smooth as gravitation, save a push at noon (none with 0), whose truth the smoothed orbit has to meet.
static void a_day(double push_mps, size_t *steps, double *mean_mps, double *worst_m)
{
    static made_truth truth[SATS];
    made_sky sky;
    orr_sp3 f;
    orr_orbit_solution s;
    orr_smoother_report report;
    orr_warnings warnings = {0};
    make_file(SATS, 1.05, DAY, push_mps, &sky, truth, &f);
    smooth(&f, &s, &report, &warnings);
    assert_int_equal(report.nodes_rejected + report.manoeuvres, 0);
    *steps = noon_steps(&s, mean_mps);
    *worst_m = 0;
    for (int k = 0; k < SATS; k++) {
        double rms, max;
        assert_true(made_compare(&sky, &truth[k], &s, 7200, 79200, &rms, &max) > 200);
        *worst_m = fmax(*worst_m, rms);
    }
    orr_warnings_free(&warnings);
    orr_orbit_solution_free(&s);
    made_sp3_free(&f);
    made_sky_free(&sky);
}

static void steps_at_noon_are_found_where_they_are(void **state)
{
    (void)state;
    size_t n;
    double mean, worst;
    a_day(0, &n, &mean, &worst);
    assert_int_equal(n, 0);
    ASSERT_NEAR(worst, 0, 0.5e-3);
    a_day(1e-5, &n, &mean, &worst);
    print_message("%zu steps of %.2e m/s (1e-5 made), orbits %.2f mm RMS\n", n, mean, 1e3 * worst);
    assert_true(n >= SATS - 2); // at most the eclipsed ones are not asked
    ASSERT_NEAR(mean, 1e-5, 2e-6);
    ASSERT_NEAR(worst, 0, 0.6e-3);
}

// Half a day whose first record is off by 3 cm in so many satellites, each elsewhere: how many of them do without it, and how
// well the first 45 minutes are met.
static size_t half_a_day(int n_off, double *worst_m)
{
    static made_truth truth[MANY];
    made_sky sky;
    orr_sp3 f;
    orr_orbit_solution s;
    orr_smoother_report report;
    orr_warnings warnings = {0};
    make_file(MANY, 0.7, DAY / 2, 0, &sky, truth, &f);
    for (int k = 0; k < n_off; k++) made_record(&f, truth[k].sat, f.epoch[0])->pos_m[k % 3] += 0.03;
    smooth(&f, &s, &report, &warnings);
    *worst_m = 0;
    for (int k = 0; k < MANY; k++) {
        double rms, max;
        assert_true(made_compare(&sky, &truth[k], &s, 0, 2700, &rms, &max) == 10);
        *worst_m = fmax(*worst_m, max);
    }
    size_t told = 0;
    for (size_t i = 0; i < warnings.kept; i++)
        told += strstr(warnings.item[i].text, "its first, holds another orbit") != NULL;
    assert_true(told == (report.nodes_rejected > 0));
    orr_warnings_free(&warnings);
    orr_orbit_solution_free(&s);
    made_sp3_free(&f);
    made_sky_free(&sky);
    return report.nodes_rejected;
}

// Some files begin with the last record of the day before: 3 cm are no outlier of one satellite, but of all of them together. What
// four of nine have is theirs.
static void a_first_record_of_another_orbit_is_left_out(void **state)
{
    (void)state;
    double clean_m, worst_m;
    assert_int_equal(half_a_day(0, &clean_m), 0);
    assert_int_equal(half_a_day(MANY, &worst_m), MANY);
    print_message("first 45 min: %.1f mm at most, of a clean file %.1f mm\n", 1e3 * worst_m, 1e3 * clean_m);
    ASSERT_NEAR(clean_m, 0, 2e-3);
    ASSERT_NEAR(worst_m, 0, 6e-3); // carried on over the first quarter of an hour
    assert_int_equal(half_a_day(4, &worst_m), 0);
    ASSERT_NEAR(worst_m, 0.03, 3e-3); // followed
}

// Satellites vote together; one alone, however loud, is heard as 25.
static void votes_are_counted_together(void **state)
{
    (void)state;
    orr_file_evidence e[4] = {{.eclipsing = true, .shadow = {0, 8, 4, 1}},
                              {.eclipsing = true, .shadow = {0, 6, 7, 1}},
                              {.noon = true, .noon_gain = 3},
                              {.noon = true, .noon_gain = 9}};
    orr_file_noise file;
    assert_int_equal(orr_file_noise_decide(e, 4, 1, &file), ORR_OK);
    ASSERT_NEAR(file.shadow_factor, 30, 0);
    assert_true(file.noon_step && file.eclipsing == 2 && file.telling == 2);
    e[1].shadow[1] = -40; // one denies it, and so loudly that two would be needed against it
    e[1].shadow[2] = -40;
    e[1].shadow[3] = -40;
    assert_int_equal(orr_file_noise_decide(e, 4, 1, &file), ORR_OK);
    ASSERT_NEAR(file.shadow_factor, 1, 0);
    e[0].shadow[3] = 500;
    assert_int_equal(orr_file_noise_decide(e, 4, 1, &file), ORR_OK);
    ASSERT_NEAR(file.shadow_factor, 1, 0);
    e[3].noon_gain = -4;
    assert_int_equal(orr_file_noise_decide(e, 4, 1, &file), ORR_OK);
    assert_false(file.noon_step);
    assert_int_equal(orr_file_noise_decide(e, 0, 1, &file), ORR_OK); // nobody votes
    assert_true(file.shadow_factor >= 1 && file.shadow_factor <= 1 && !file.noon_step);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_at_noon_are_found_where_they_are),
        cmocka_unit_test(a_first_record_of_another_orbit_is_left_out),
        cmocka_unit_test(votes_are_counted_together),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
