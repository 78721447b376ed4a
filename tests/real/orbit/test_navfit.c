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
                orr_time t = orr_time_add_s(from, t_s);
                if (kind[k].system == 'G')
                    ASSERT_OK(orr_navfit_lnav(list[i], t, kind[k].window_s, orr_navfit_from_product, &p, &eph,
                                              &r, &d),
                              d);
                else
                    ASSERT_OK(orr_navfit_glonass(list[i], t, kind[k].window_s, orr_navfit_from_product, &p,
                                                 &eph, &r, &d),
                              d);
                sum += r.rms_m * r.rms_m;
                fit += r.fit_rms_m * r.fit_rms_m;
                if (r.rms_m > worst) worst = r.rms_m;
                windows++;
                double rms_s = 0;
                if (orr_navfit_clock(e, list[i], t, kind[k].window_s, &eph, &rms_s, &d) == ORR_OK) {
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

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(windows_of_a_day_meet_their_bars)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
