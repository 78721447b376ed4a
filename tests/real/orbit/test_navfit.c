// SPDX-License-Identifier: GPL-3.0-or-later
// The precise day of 2024-035 turned into broadcast parameters: every GPS and GLONASS satellite, windows
// around the day, residuals after quantisation.
#include "testing.h"

#include "orbit/broadcast.h"
#include "orbit/navfit.h"
#include "real_orbit.h"

static const char *const day[] = {"2024-035/COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz"};

static orr_ephemeris *product(void)
{
    real_files f;
    if (!real_open(day, 1, &f)) return NULL;
    orr_smoother_options o = orr_smoother_defaults();
    o.jobs = 2;
    orr_orbit_solution s;
    orr_diag d = {0};
    orr_ephemeris *e = NULL;
    ASSERT_OK(orr_smoother_run(f.input, f.n, &o, NULL, NULL, &s, NULL, NULL, &d), d);
    ASSERT_OK(orr_ephemeris_build(&s, &e, &d), d);
    orr_orbit_solution_free(&s);
    real_close(&f);
    return e;
}

// Bars: 0.05 m over 2 h and 0.30 m over 4 h for GPS, 0.5 m over +-15 min for GLONASS, all satellites pooled.
static void windows_of_a_day_meet_their_bars(void **state)
{
    (void)state;
    orr_ephemeris *e = product();
    if (e == NULL) SKIP_NO_DATA(day[0]);
    const struct {
        char system;
        double window_s, bar_m;
    } kind[] = {{'G', 7200, 0.05}, {'G', 14400, 0.30}, {'R', 1800, 0.50}};
    const orr_sat *list;
    size_t n = orr_ephemeris_satellites(e, &list);
    orr_time from, to;
    orr_ephemeris_span(e, &from, &to);
    for (size_t k = 0; k < 3; k++) {
        double sum = 0, fit = 0, worst = 0, clock = 0;
        size_t windows = 0, clocks = 0;
        for (size_t i = 0; i < n; i++) {
            if (orr_sat_system(list[i]) != kind[k].system) continue;
            for (double t_s = 7200; t_s <= 86400 - 7200; t_s += 14400) {
                orr_navfit_product p = {.ephemeris = e, .sat = list[i]};
                orr_navfit_report r;
                orr_nav_eph eph;
                orr_diag d = {0};
                orr_time t = orr_time_add_s(from, t_s), w0 = orr_time_add_s(t, -kind[k].window_s / 2),
                         w1 = orr_time_add_s(t, kind[k].window_s / 2);
                if (kind[k].system == 'G')
                    ASSERT_OK(orr_navfit_lnav(list[i], t, w0, w1, kind[k].window_s / 3600,
                                              orr_navfit_from_product, &p, &eph, &r, &d),
                              d);
                else
                    ASSERT_OK(
                        orr_navfit_glonass(list[i], t, w0, w1, orr_navfit_from_product, &p, &eph, &r, &d), d);
                sum += r.rms_m * r.rms_m;
                fit += r.fit_rms_m * r.fit_rms_m;
                if (r.rms_m > worst) worst = r.rms_m;
                windows++;
                double rms_s = 0;
                if (orr_navfit_clock(e, list[i], t, w0, w1, &eph, &rms_s, &d) == ORR_OK) {
                    clock += rms_s * rms_s;
                    clocks++;
                }
            }
        }
        double rms = sqrt(sum / (double)windows);
        print_message("%c, %5.0f s: %zu windows, RMS %.4f m (bar %.2f), %.4f m before quantisation, worst "
                      "%.3f m; clock %.2f ns\n",
                      kind[k].system, kind[k].window_s, windows, rms, kind[k].bar_m,
                      sqrt(fit / (double)windows), worst, 1e9 * sqrt(clock / (double)clocks));
        assert_true(windows > 100);
        ASSERT_NEAR(rms, 0, kind[k].bar_m);
    }
    orr_ephemeris_free(e);
}

// A product begins at midnight: the set of toe = 00:00 is fitted to 00:00..02:00, that of tb = 23:45 of the
// day before to 00:00..00:30. Each LSB now acts over the whole window instead of half of it, hence twice the
// bars.
static void windows_may_lie_to_one_side(void **state)
{
    (void)state;
    orr_ephemeris *e = product();
    if (e == NULL) SKIP_NO_DATA(day[0]);
    const orr_sat *list;
    size_t n = orr_ephemeris_satellites(e, &list), windows[2] = {0};
    double sum[2] = {0}, worst[2] = {0};
    orr_time from, to;
    orr_ephemeris_span(e, &from, &to);
    for (size_t i = 0; i < n; i++) {
        orr_navfit_product p = {.ephemeris = e, .sat = list[i]};
        orr_navfit_report r;
        orr_nav_eph eph;
        orr_diag d = {0};
        char system = orr_sat_system(list[i]);
        size_t k = system == 'R';
        if (system == 'G')
            ASSERT_OK(orr_navfit_lnav(list[i], from, from, orr_time_add_s(from, 7200), 4,
                                      orr_navfit_from_product, &p, &eph, &r, &d),
                      d);
        else if (system == 'R')
            ASSERT_OK(orr_navfit_glonass(list[i], orr_time_add_s(from, -900), from,
                                         orr_time_add_s(from, 1800), orr_navfit_from_product, &p, &eph, &r,
                                         &d),
                      d);
        else
            continue;
        sum[k] += r.rms_m * r.rms_m, windows[k]++;
        if (r.max_m > worst[k]) worst[k] = r.max_m;
        double rms_s = 0;
        ASSERT_OK(orr_navfit_clock(e, list[i], eph.toe, from, orr_time_add_s(from, 1800), &eph, &rms_s, &d),
                  d);
        ASSERT_NEAR(rms_s, 0, 5e-9); // the LSB of GLONASS' tau is 0.9 ns
    }
    for (size_t k = 0; k < 2; k++) {
        double rms = sqrt(sum[k] / (double)windows[k]);
        print_message("%c to one side: %zu windows, RMS %.4f m, largest %.3f m\n", "GR"[k], windows[k], rms,
                      worst[k]);
        assert_true(windows[k] > 15);
        ASSERT_NEAR(rms, 0, k == 0 ? 0.10 : 1.0);
    }
    orr_ephemeris_free(e);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(windows_of_a_day_meet_their_bars),
                                       cmocka_unit_test(windows_may_lie_to_one_side)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
