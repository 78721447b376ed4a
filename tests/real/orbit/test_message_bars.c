// SPDX-License-Identifier: GPL-3.0-or-later
// How closely each message's Kepler parameters, on its lattice, describe precise orbits: RMS over the windows of a day, satellite by
// satellite, at instants between those of the fit too.
#include "testing.h"

#include <stdlib.h>

#include "core/parallel.h"
#include "ingest/sp3/sp3.h"
#include "orbit/broadcast/broadcast.h"
#include "orbit/ephemeris/ephemeris.h"
#include "orbit/navdata/navfit.h"
#include "orbit/smooth/smoother.h"
#include "real/orbit/real_orbit.h"

static orr_ephemeris *product_of(const char *name)
{
    real_files f;
    if (!real_open(&name, 1, &f)) return NULL;
    orr_smoother_options o = orr_smoother_defaults();
    o.jobs = orr_parallel_cores();
    orr_orbit_solution s;
    orr_ephemeris *e = NULL;
    orr_diag d = {0};
    ASSERT_OK(orr_smoother_run(f.input, f.n, &o, NULL, NULL, &s, NULL, NULL, &d), d);
    ASSERT_OK(orr_ephemeris_build(&s, &e, &d), d);
    orr_orbit_solution_free(&s);
    real_close(&f);
    return e;
}

typedef struct bar {
    const char *what;
    char system;
    orr_nav_message message;
    double window_s;
    bool geo, eccentric; // of these satellites alone, or of all others
    double bar_m;        // of a satellite
    double held_m;       // where one satellite of a day misses the bar: what is held; 0: the bar
} bar;

static const bar bars[] = {
    {"LNAV", 'G', ORR_NAV_LNAV, 7200, false, false, 0.025, 0},
    {"CNAV", 'G', ORR_NAV_CNAV, 7200, false, false, 0.004, 0},
    {"CNAV", 'G', ORR_NAV_CNAV, 10800, false, false, 0.02, 0},
    {"I/NAV, F/NAV", 'E', ORR_NAV_INAV, 7200, false, false, 0.02, 0},
    {"I/NAV, F/NAV", 'E', ORR_NAV_INAV, 14400, false, false, 0.2, 0.25},
    {"I/NAV, F/NAV, E14 and E18", 'E', ORR_NAV_INAV, 3600, false, true, 0.02, 0},
    {"D1", 'C', ORR_NAV_D1, 7200, false, false, 0.02, 0},
    {"D2", 'C', ORR_NAV_D2, 7200, true, false, 0.02, 0},
    {"B-CNAV", 'C', ORR_NAV_CNV1, 7200, false, false, 0.004, 0},
    {"B-CNAV", 'C', ORR_NAV_CNV1, 10800, false, false, 0.02, 0},
};

static bool belongs(const bar *b, orr_sat sat)
{
    const int n = orr_sat_number(sat);
    const bool geo = orr_sat_system(sat) == 'C' && (n <= 5 || n >= 59),
               eccentric = orr_sat_system(sat) == 'E' && (n == 14 || n == 18);
    return orr_sat_system(sat) == b->system && geo == b->geo && eccentric == b->eccentric;
}

// What a set errs every two minutes of its window, m^2 summed.
static double squares(const orr_nav_eph *eph, const orr_ephemeris *e, orr_time from, double window_s,
                      size_t *n)
{
    double sum = 0;
    for (double t_s = 0; t_s <= window_s; t_s += 120, ++*n) {
        orr_sat_state truth;
        orr_broadcast_state s;
        const orr_time t = orr_time_add_s(from, t_s);
        assert_int_equal(orr_ephemeris_eval(e, eph->sat, t, &truth), ORR_OK);
        assert_int_equal(orr_broadcast_eval(eph, t, &s), ORR_OK);
        const orr_vec3 d = orr_vec3_sub(s.pos_m, truth.pos_m);
        sum += orr_vec3_dot(d, d);
    }
    return sum;
}

// RMS of a satellite's windows about every second hour; a negative number where it has none of them whole. *e_max is its
// greatest eccentricity, *lost by how much rounding made the worst fit worse.
static double satellite_rms(const orr_ephemeris *e, const bar *b, orr_sat sat, orr_time from, double *e_max,
                            double *lost)
{
    double sum = 0;
    size_t n = 0;
    orr_navfit_product p = {.ephemeris = e, .sat = sat};
    const int64_t shift = b->system == 'C' ? ORR_BDT_BEHIND_GPS_NS : 0;
    for (int hour = 2; hour <= 22; hour += 2) {
        const orr_time toe = from + hour * 3600 * ORR_NS_PER_S + shift;
        orr_navfit_report r;
        orr_nav_eph eph;
        orr_diag d = {0};
        orr_sat_state s0, s1;
        const orr_time w0 = orr_time_add_s(toe, -b->window_s / 2), w1 = orr_time_add_s(toe, b->window_s / 2);
        if (orr_ephemeris_eval(e, sat, w0, &s0) != ORR_OK || orr_ephemeris_eval(e, sat, w1, &s1) != ORR_OK ||
            s0.valid_from != s1.valid_from)
            continue;
        ASSERT_OK(orr_navfit_kepler(sat, b->message, toe, w0, w1, orr_navfit_from_product, &p, &eph, &r, &d),
                  d);
        sum += squares(&eph, e, w0, b->window_s, &n);
        *e_max = fmax(*e_max, eph.kepler.e);
        *lost = fmax(*lost, r.rms_m - r.fit_rms_m);
    }
    return n > 0 ? sqrt(sum / (double)n) : -1;
}

static void check(const char *name)
{
    orr_ephemeris *e = product_of(name);
    if (e == NULL) SKIP_NO_DATA(name);
    const orr_sat *list;
    orr_time from, to;
    const size_t n = orr_ephemeris_satellites(e, &list);
    orr_ephemeris_span(e, &from, &to);
    const size_t stride = getenv("ORRERY_ALL_SATELLITES") != NULL ? 1 : 5; // 15 s of one core
    for (size_t k = 0; k < sizeof bars / sizeof *bars; k++) {
        const bar *b = &bars[k];
        double least = HUGE_VAL, most = 0, sum = 0;
        size_t sats = 0, place = 0;
        orr_sat worst = ORR_SAT_NONE;
        for (size_t i = 0; i < n; i++) {
            if (!belongs(b, list[i]) || place++ % stride != 0) continue;
            double ecc = 0, lost = 0;
            const double rms = satellite_rms(e, b, list[i], from, &ecc, &lost);
            if (rms < 0) continue;
            // LNAV's fifteen parameters leave 3 cm of GPS' most eccentric orbits (G02, G21), CNAV's seventeen over three hours 2.1 cm
            // (G21), whatever they are rounded to: harmonics of twice the argument of latitude do not follow those of once and
            // three times, which flattening and eccentricity together make. No other values of the parameters come closer.
            if (b->system == 'G' && ecc > 0.015 && (b->message == ORR_NAV_LNAV || b->window_s > 7200))
                ASSERT_NEAR(lost, 0, 0.002);
            else
                ASSERT_NEAR(rms, 0, b->held_m > 0 ? b->held_m : b->bar_m);
            sum += rms * rms, sats++;
            least = fmin(least, rms);
            if (rms > most) most = rms, worst = list[i];
        }
        char text[ORR_SAT_TEXT];
        if (sats == 0) continue;
        print_message("%-26s %5.1f h: %2zu satellites, %.4f to %.4f m (%s), all %.4f m, bar %.3f\n", b->what,
                      b->window_s / 3600, sats, least, most, orr_sat_text(worst, text),
                      sqrt(sum / (double)sats), b->bar_m);
        if (b->message == ORR_NAV_LNAV && stride == 1) ASSERT_NEAR(sqrt(sum / (double)sats), 0, 0.02);
    }
    orr_ephemeris_free(e);
}

static void code_2024(void **state)
{
    (void)state;
    check("2024-035/COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz");
}

static void iac_2020(void **state)
{
    (void)state;
    check("2020-177/Sta21114.sp3.gz");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(code_2024), cmocka_unit_test(iac_2020)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
