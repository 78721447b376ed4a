// SPDX-License-Identifier: GPL-3.0-or-later
// Predictions from two days of a centre's orbits, every quarter of an hour, against its next day, which was left out:
// medians over sunlit satellites an hour, six and a day after the last position, and the error over its sigma.
#include "testing.h"

#include "orbit/ephemeris/ephemeris.h"
#include "orbit/judge/prediction.h"
#include "orbit/predict/predict.h"
#include "real_orbit.h"

typedef struct bar {
    char system;
    double most_m[3]; // at 1, 6, 24 h
} bar;

static const double ages_h[3] = {1, 6, 24};

static const orr_prediction_row *row_of(const orr_prediction_judgement *j, char system, double age_h)
{
    for (size_t i = 0; i < j->n; i++)
        if (j->row[i].system == system && !j->row[i].eclipses && j->row[i].age_h == age_h) return &j->row[i];
    return NULL;
}

static void judge(const char *const *names, size_t n, const char *next, const orr_smoother_options *o,
                  const bar *bars, size_t n_bars)
{
    real_files f, truth;
    if (!real_open(names, n, &f)) SKIP_NO_DATA(names[0]);
    if (!real_open(&next, 1, &truth)) SKIP_NO_DATA(next);
    orr_orbit_solution s;
    orr_smoother_report r;
    orr_predict_report p;
    orr_prediction_judgement j;
    orr_ephemeris *e = NULL;
    orr_diag d = {0};
    ASSERT_OK(orr_smoother_run(f.input, f.n, o, NULL, NULL, &s, &r, NULL, &d), d);
    const orr_predict_options po = {.to = orr_time_add_s(s.to, 86400), .jobs = 2};
    const orr_time last = s.to;
    ASSERT_OK(orr_predict(&s, f.input, f.n, &po, NULL, NULL, &p, NULL, &d), d);
    assert_true(p.eop_estimated && p.from == last && p.orbits >= s.n_sats - 1);
    ASSERT_OK(orr_ephemeris_build(&s, &e, &d), d);
    ASSERT_OK(orr_prediction_judge(e, truth.sp3, 1, &j, &d), d);
    for (size_t b = 0; b < n_bars; b++)
        for (int k = 0; k < 3; k++) {
            const orr_prediction_row *row = row_of(&j, bars[b].system, ages_h[k]);
            assert_non_null(row);
            print_message("%c %2.0f h: %4.1f cm (bar %.0f), error over sigma %.2f, %zu satellites\n",
                          row->system, row->age_h, 100 * row->orbit.median, 100 * bars[b].most_m[k],
                          row->orbit.ratio, row->orbit.satellites);
            assert_true(row->orbit.satellites >= 14);
            ASSERT_NEAR(row->orbit.median, 0, bars[b].most_m[k]);
            assert_true(row->orbit.ratio > 0.5 && row->orbit.ratio < 1.5);
        }
    orr_prediction_judgement_free(&j);
    orr_ephemeris_free(e);
    orr_orbit_solution_free(&s);
    real_close(&f);
    real_close(&truth);
}

static orr_smoother_options options(void)
{
    orr_smoother_options o = orr_smoother_defaults();
    o.node_step_s = 900;
    o.jobs = 2;
    return o;
}

static void three_systems_of_2024(void **state)
{
    (void)state;
    static const char *const days[] = {"2024-035/COD0OPSFIN_20240340000_01D_05M_ORB.SP3.gz",
                                       "2024-035/COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz"};
    static const bar bars[] = {
        {'G', {0.04, 0.08, 0.15}}, {'R', {0.08, 0.11, 0.30}}, {'E', {0.08, 0.15, 0.27}}};
    const orr_smoother_options o = options();
    judge(days, 2, "2024-035/COD0OPSFIN_20240360000_01D_05M_ORB.SP3.gz", &o, bars, 3);
}

static void gps_of_2009(void **state)
{
    (void)state;
    static const char *const days[] = {"2009-265/igs15502.sp3.gz", "2009-265/igs15503.sp3.gz"};
    static const bar bars[] = {{'G', {0.04, 0.08, 0.15}}};
    const orr_smoother_options o = options();
    judge(days, 2, "2009-265/igs15504.sp3.gz", &o, bars, 1);
}

// The orbits of 2011 are not as smooth: 18 and 33 cm after a day.
static void two_systems_of_2011(void **state)
{
    (void)state;
    static const char *const days[] = {"2011-week1651/COD16511.EPH_R.gz", "2011-week1651/COD16512.EPH_R.gz"};
    static const bar bars[] = {{'G', {0.04, 0.08, 0.18}}, {'R', {0.08, 0.11, 0.33}}};
    const orr_smoother_options o = options();
    judge(days, 2, "2011-week1651/COD16513.EPH_R.gz", &o, bars, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(three_systems_of_2024),
        cmocka_unit_test(gps_of_2009),
        cmocka_unit_test(two_systems_of_2011),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
