// SPDX-License-Identifier: GPL-3.0-or-later
// GPS almanacs fitted to precise orbits: a week of 2011 from one of its days, and products of a few hours.
#include "testing.h"

#include "almanac_receiver.h"
#include "orbit/navdata/almanac_kepler.h"
#include "real_orbit.h"

static const char *const week[] = {"2011-week1651/COD16510.EPH_R.gz", "2011-week1651/COD16511.EPH_R.gz",
                                   "2011-week1651/COD16512.EPH_R.gz", "2011-week1651/COD16513.EPH_R.gz",
                                   "2011-week1651/COD16514.EPH_R.gz", "2011-week1651/COD16515.EPH_R.gz",
                                   "2011-week1651/COD16516.EPH_R.gz"};
static const char *const one_day[] = {"2024-035/COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz"};

static orr_ephemeris *product(const char *const *names, size_t n)
{
    real_files f;
    if (!real_open(names, n, &f)) return NULL;
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

static double distance_rms(const orr_almanac *a, orr_time toa, orr_navfit_product *p, orr_time from,
                           orr_time to)
{
    double sum = 0;
    int n = 0;
    for (orr_time t = from; t <= to; t += 900 * ORR_NS_PER_S) {
        orr_vec3 truth, pos;
        if (orr_navfit_from_product(p, t, &truth) != ORR_OK) continue;
        assert_int_equal(almanac_receive(a, toa, t, &pos, NULL), ORR_OK);
        orr_vec3 d = orr_vec3_sub(pos, truth);
        sum += orr_vec3_dot(d, d);
        n++;
    }
    return n > 0 ? sqrt(sum / n) : (double)NAN;
}

typedef struct tally {
    double fit, day, next, last;
    int n, n_last;
    double worst;
} tally;

// The almanac of one satellite from the middle `length_h` hours of the week's first day.
static void add(const orr_ephemeris *e, orr_sat sat, orr_time from, double length_h, tally *t)
{
    const orr_time hour = 3600 * ORR_NS_PER_S, toa = from + INT64_C(11) * 4096 * ORR_NS_PER_S;
    const orr_time half = (orr_time)(length_h / 2 * (double)hour), noon = from + 12 * hour;
    orr_navfit_product p = {.ephemeris = e, .sat = sat};
    orr_almanac a;
    orr_navfit_report r;
    orr_diag d = {0};
    ASSERT_OK(orr_almanac_fit(sat, toa, noon - half, noon + half, orr_navfit_from_product, &p, &a, &r, &d),
              d);
    double day = distance_rms(&a, toa, &p, from, from + 24 * hour);
    double next = distance_rms(&a, toa, &p, from + 24 * hour, from + 48 * hour);
    double last = distance_rms(&a, toa, &p, from + 144 * hour, from + 168 * hour);
    t->fit += r.rms_m * r.rms_m, t->day += day * day, t->next += next * next;
    t->n++;
    if (day > t->worst) t->worst = day;
    if (isnan(last)) return;
    t->last += last * last;
    t->n_last++;
}

// A whole day: 0.67 km in the day, where the missing harmonics and the radius that belongs to another mean
// motion make 0.57 km (test_almanac_lnav). Later the Moon decides: from day to day the fitted mean motion of
// these satellites swings by up to 8e-6 to either side with a period of a fortnight, the same in each plane;
// 1e-5 is 12 km along the orbit in five days. A few hours: the terms with e are not allowed for and make the
// mean motion of two hours uncertain by a few 1e-5. Bars are a quarter above what was found. Satellites that
// were moved during the week (G02, G13) are left out.
static void a_week_by_its_first_day(void **state)
{
    (void)state;
    orr_ephemeris *e = product(week, 7);
    if (e == NULL) SKIP_NO_DATA(week[0]);
    const orr_sat *list;
    size_t n = orr_ephemeris_satellites(e, &list);
    orr_time from, to;
    orr_ephemeris_span(e, &from, &to);
    static const struct {
        double length_h, day_km, next_km, last_km;
    } bar[] = {{24, 0.84, 1.4, 12}, {12, 0.87, 1.5, 12}, {6, 1.7, 4.5, 25}, {2, 2.9, 8.6, 49}};
    for (size_t k = 0; k < 4; k++) {
        tally t = {0};
        for (size_t i = 0; i < n; i++)
            if (orr_sat_system(list[i]) == 'G' && orr_sat_number(list[i]) != 2 &&
                orr_sat_number(list[i]) != 13)
                add(e, list[i], from, bar[k].length_h, &t);
        double day = 1e-3 * sqrt(t.day / t.n), next = 1e-3 * sqrt(t.next / t.n),
               last = 1e-3 * sqrt(t.last / t.n_last);
        print_message("%2.0f h of positions: RMS %.3f km there, %.3f km in the day (worst %.3f), %.1f km the "
                      "day after, "
                      "%.1f km on the seventh\n",
                      bar[k].length_h, 1e-3 * sqrt(t.fit / t.n), day, 1e-3 * t.worst, next, last);
        assert_true(t.n >= 28 && t.n_last >= 25);
        ASSERT_NEAR(day, 0, bar[k].day_km);
        ASSERT_NEAR(next, 0, bar[k].next_km);
        ASSERT_NEAR(last, 0, bar[k].last_km);
    }
    orr_ephemeris_free(e);
}

// Clocks of a day: what is left is the LSB of 0.95 us (0.28 us RMS) and half a day of af1's (0.08 us).
static void clocks_of_a_day(void **state)
{
    (void)state;
    orr_ephemeris *e = product(one_day, 1);
    if (e == NULL) SKIP_NO_DATA(one_day[0]);
    const orr_sat *list;
    size_t n = orr_ephemeris_satellites(e, &list), clocks = 0;
    orr_time from, to;
    orr_ephemeris_span(e, &from, &to);
    double sum = 0;
    int32_t w;
    int64_t ns;
    orr_time_week(from, &w, &ns);
    orr_time toa = from - ns + (ns / (4096 * ORR_NS_PER_S) + 11) * 4096 * ORR_NS_PER_S;
    for (size_t i = 0; i < n; i++) {
        if (orr_sat_system(list[i]) != 'G') continue;
        orr_almanac a = {0};
        double rms = 0;
        orr_diag d = {0};
        ASSERT_OK(orr_almanac_clock(e, list[i], toa, from, to, &a, &rms, &d), d);
        ASSERT_NEAR(rms, 0, 0.6e-6);
        sum += rms * rms;
        clocks++;
    }
    print_message("%zu clocks: RMS %.2f us\n", clocks, 1e6 * sqrt(sum / (double)clocks));
    assert_true(clocks >= 30);
    orr_ephemeris_free(e);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_week_by_its_first_day),
                                       cmocka_unit_test(clocks_of_a_day)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
