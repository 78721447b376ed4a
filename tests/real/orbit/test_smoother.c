// SPDX-License-Identifier: GPL-3.0-or-later
// What the smoother promises, on CODE's 5-minute orbits of 2024-035: every third epoch is input, the rest is
// truth. The truth itself is rounded to a millimetre, 0.5 mm RMS in 3-D.
#include "testing.h"

#include "orbit/ephemeris/ephemeris.h"
#include "real_orbit.h"

static const char *const days[] = {"2024-035/COD0OPSFIN_20240340000_01D_05M_ORB.SP3.gz",
                                   "2024-035/COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz",
                                   "2024-035/COD0OPSFIN_20240360000_01D_05M_ORB.SP3.gz"};

static void smooth(real_files *f, const orr_smoother_options *o, orr_orbit_solution *s,
                   orr_smoother_report *r)
{
    orr_diag d = {0};
    ASSERT_OK(orr_smoother_run(f->input, f->n, o, NULL, NULL, s, r, NULL, &d), d);
}

static void expect(const char *what, real_stats s, double rms_mm, double max_mm)
{
    print_message("%-34s n %5zu  RMS %6.3f mm (bar %.2f)  max %6.2f mm\n", what, s.n, 1e3 * s.rms_m, rms_mm,
                  1e3 * s.max_m);
    assert_true(s.n > 50);
    ASSERT_NEAR(1e3 * s.rms_m, 0, rms_mm);
    ASSERT_NEAR(1e3 * s.max_m, 0, max_mm);
}

static void one_day_inside_and_at_its_edges(void **state)
{
    (void)state;
    for (int drop = 0; drop < 2; drop++) {
        real_files f;
        if (!real_open(&days[1], 1, &f)) SKIP_NO_DATA(days[1]);
        real_files truth = f;
        if (drop) real_drop_midnight(&f, 0);
        orr_smoother_options o = orr_smoother_defaults();
        o.node_step_s = 900;
        orr_orbit_solution s;
        orr_smoother_report r;
        smooth(&f, &o, &s, &r);
        assert_int_equal(s.n_sats, 80);
        assert_int_equal(r.nodes_rejected, 0);
        assert_int_equal(r.passes_max, 1);
        for (const char *c = "GRE"; *c != '\0'; c++) {
            char name[64];
            snprintf(name, sizeof name, "%c inside%s", *c, drop ? ", no 24:00 node" : "");
            expect(name, real_judge(&s, &truth, *c, REAL_INNER), 0.75, 6);
            snprintf(name, sizeof name, "%c edges%s", *c, drop ? ", no 24:00 node" : "");
            expect(name, real_judge(&s, &truth, *c, REAL_EDGE), drop ? 1.5 : 1.2, 6);
        }
        orr_orbit_solution_free(&s);
        real_close(&truth);
    }
}

static void hourly_nodes(void **state)
{
    (void)state;
    real_files f;
    if (!real_open(&days[1], 1, &f)) SKIP_NO_DATA(days[1]);
    orr_smoother_options o = orr_smoother_defaults();
    o.node_step_s = 3600;
    orr_orbit_solution s;
    smooth(&f, &o, &s, NULL);
    expect("G, nodes every 3600 s", real_judge(&s, &f, 'G', REAL_INNER), 2.5, 30);
    expect("E, nodes every 3600 s", real_judge(&s, &f, 'E', REAL_INNER), 2.5, 30);
    expect("R, nodes every 3600 s", real_judge(&s, &f, 'R', REAL_INNER), 4.0, 40);
    orr_orbit_solution_free(&s);
    real_close(&f);
}

// An hour of nodes gone: at three places of the day, so that no lucky hour is picked. 10:00, 10:15, 10:30 and
// 10:45 removed.
static void an_hour_without_nodes(void **state)
{
    (void)state;
    real_files f;
    if (!real_open(&days[1], 1, &f)) SKIP_NO_DATA(days[1]);
    for (int hour = 6; hour <= 18; hour += 6) {
        orr_interval out = {orr_time_add_s(f.sp3[0].epoch[0], 3600.0 * hour),
                            orr_time_add_s(f.sp3[0].epoch[0], 3600.0 * hour + 3600)};
        orr_smoother_options o = orr_smoother_defaults();
        o.node_step_s = 900;
        o.exclude = &out;
        o.n_exclude = 1;
        orr_orbit_solution s;
        smooth(&f, &o, &s, NULL);
        for (const char *c = "GRE"; *c != '\0'; c++) {
            char name[64];
            snprintf(name, sizeof name, "%c, four nodes gone at %02d:00", *c, hour);
            expect(name, real_judge(&s, &f, *c, REAL_GAP), 3.0, 40);
        }
        orr_orbit_solution_free(&s);
    }
    real_close(&f);
}

// Three days: one arc per satellite across both midnights; what the product jumps there is told.
static void three_days_are_one(void **state)
{
    (void)state;
    real_files f;
    if (!real_open(days, 3, &f)) SKIP_NO_DATA(days[0]);
    orr_smoother_options o = orr_smoother_defaults();
    o.node_step_s = 900;
    o.jobs = 2;
    orr_orbit_solution s;
    orr_smoother_report r;
    smooth(&f, &o, &s, &r);
    assert_int_equal(r.nodes_rejected + r.manoeuvres, 0);
    assert_int_equal(r.arcs, s.n_sats);
    double jump[256] = {0};
    size_t joints = 0;
    for (size_t i = 0; i < s.n_sats; i++)
        for (size_t e = 0; e < s.sat[i].n_events; e++)
            if (s.sat[i].event[e].kind == ORR_EVENT_DAY_JUMP) {
                joints++;
                char c = orr_sat_system(s.sat[i].sat);
                if (s.sat[i].event[e].value > jump[(unsigned char)c])
                    jump[(unsigned char)c] = s.sat[i].event[e].value;
            }
    print_message("largest jump of the product at midnight: G %.1f, R %.1f, E %.1f mm over %zu joints\n",
                  1e3 * jump['G'], 1e3 * jump['R'], 1e3 * jump['E'], joints);
    assert_true(joints >= 2 * 78);
    expect("G, three days", real_judge(&s, &f, 'G', REAL_INNER), 0.80, 30);
    orr_orbit_solution_free(&s);
    real_close(&f);
}

// The source's own settings on the same day: what its force model costs.
static void the_dissertations_letter(void **state)
{
    (void)state;
    real_files f;
    if (!real_open(&days[1], 1, &f)) SKIP_NO_DATA(days[1]);
    orr_smoother_options o = orr_smoother_literal();
    o.node_step_s = 900;
    orr_orbit_solution s;
    smooth(&f, &o, &s, NULL);
    real_stats inner = real_judge(&s, &f, 'G', REAL_INNER), edge = real_judge(&s, &f, 'G', REAL_EDGE);
    print_message("literal (33): G inside %.1f mm, edges %.0f mm\n", 1e3 * inner.rms_m, 1e3 * edge.rms_m);
    assert_true(inner.rms_m > 0.005 && inner.rms_m < 0.03); // the source claims 2-3 cm
    assert_true(edge.rms_m > 0.5);
    orr_orbit_solution_free(&s);
    real_close(&f);
}

static const char *const week[] = {"2011-week1651/COD16510.EPH_R.gz", "2011-week1651/COD16511.EPH_R.gz",
                                   "2011-week1651/COD16512.EPH_R.gz", "2011-week1651/COD16513.EPH_R.gz",
                                   "2011-week1651/COD16514.EPH_R.gz", "2011-week1651/COD16515.EPH_R.gz",
                                   "2011-week1651/COD16516.EPH_R.gz"};

// The week's two GPS manoeuvres, flagged by CODE, are found with and without looking at the flags.
static void manoeuvres_of_a_week(void **state)
{
    (void)state;
    for (int blind = 0; blind < 2; blind++) {
        real_files f;
        if (!real_open(week, 7, &f)) SKIP_NO_DATA(week[0]);
        orr_sat_set set = {0};
        orr_sat_set_add(&set, orr_sat_parse("G02"));
        orr_sat_set_add(&set, orr_sat_parse("G13"));
        orr_sat_set_add(&set, orr_sat_parse("G05"));
        if (blind)
            for (size_t i = 0; i < f.n; i++)
                for (size_t k = 0; k < f.sp3[i].n_epochs * f.sp3[i].n_sats; k++)
                    f.sp3[i].record[k].flags &= (uint8_t)~ORR_SP3_MANOEUVRE;
        orr_smoother_options o = orr_smoother_defaults();
        o.sats = &set;
        orr_orbit_solution s;
        orr_smoother_report r;
        smooth(&f, &o, &s, &r);
        assert_int_equal(r.manoeuvres, 2);
        for (size_t i = 0; i < s.n_sats; i++) {
            bool pushed = s.sat[i].sat != orr_sat_parse("G05");
            assert_int_equal(s.sat[i].n_arcs, pushed ? 2 : 1);
            for (size_t e = 0; e < s.sat[i].n_events; e++)
                if (s.sat[i].event[e].kind == ORR_EVENT_MANOEUVRE) {
                    char t0[ORR_TIME_TEXT], t1[ORR_TIME_TEXT], sat[ORR_SAT_TEXT];
                    print_message("%s: manoeuvre between %s and %s, %.3f m/s%s\n",
                                  orr_sat_text(s.sat[i].sat, sat), orr_time_text(s.sat[i].event[e].t0, t0),
                                  orr_time_text(s.sat[i].event[e].t1, t1), s.sat[i].event[e].value,
                                  blind ? " (flags not looked at)" : "");
                    assert_true(pushed);
                    ASSERT_NEAR(s.sat[i].event[e].value, 0.177, 0.01); // both were of this size
                }
        }
        orr_orbit_solution_free(&s);
        real_close(&f);
    }
}

static void predicted_half_is_flagged(void **state)
{
    (void)state;
    static const char *const name[] = {"ultra/igu16295_00.sp3.gz"};
    real_files f;
    if (!real_open(name, 1, &f)) SKIP_NO_DATA(name[0]);
    orr_smoother_options o = orr_smoother_defaults();
    orr_orbit_solution s;
    smooth(&f, &o, &s, NULL);
    for (size_t i = 0; i < s.n_sats; i++) {
        const orr_orbit_arc *arc = &s.sat[i].arc[0];
        assert_false(arc->sample[1].flags & ORR_EPH_PREDICTED);
        assert_true(arc->sample[arc->n - 2].flags & ORR_EPH_PREDICTED);
    }
    orr_orbit_solution_free(&s);
    real_close(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_day_inside_and_at_its_edges), cmocka_unit_test(hourly_nodes),
        cmocka_unit_test(an_hour_without_nodes),           cmocka_unit_test(three_days_are_one),
        cmocka_unit_test(the_dissertations_letter),        cmocka_unit_test(manoeuvres_of_a_week),
        cmocka_unit_test(predicted_half_is_flagged),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
