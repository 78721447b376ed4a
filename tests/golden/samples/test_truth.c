// SPDX-License-Identifier: GPL-3.0-or-later
// The samples against their own truth: what the files say, and what the smoother makes of them. The truth is
// asked at any instant, so that SP3's rounding is in the input alone.
#include "testing.h"

#include "ingest/sp3/sp3.h"
#include "orbit/ephemeris/ephemeris.h"
#include "orbit/force/force.h"
#include "orbit/smooth/smoother.h"
#include "samples/make/force.h"
#include "samples/make/truth.h"

#define SAMPLE(day, step) ORR_SOURCE_DIR "/samples/ORR0TSTFIN_20250" day "0000_01D_" step "M_ORB.SP3.gz"

static const char *const DAYS[] = {SAMPLE("79", "15"), SAMPLE("80", "15"), SAMPLE("81", "15")};

// A handful of each system: eclipsing and not, both eccentric ones, and those that something happens to.
static const char CHOSEN[] = "G01,G02,G03,G10,G17,R01,R02,R08,R21,E01,E02,E03,E14,E18,E24";

static orr_sample_truth *truth;

static int make_truth(void **state)
{
    (void)state;
    orr_sat_set set;
    orr_diag d = {0};
    if (orr_sat_set_parse(CHOSEN, &set, &d) != ORR_OK) return -1;
    return orr_sample_truth_new(&set, ORR_SAMPLE_DAYS, &truth, &d) == ORR_OK ? 0 : -1;
}

static int drop_truth(void **state)
{
    (void)state;
    orr_sample_truth_free(truth);
    return 0;
}

static void read_sample(const char *path, orr_sp3 *out)
{
    orr_diag d = {0};
    orr_warnings w = {0};
    ASSERT_OK(orr_sp3_read(path, NULL, out, &w, &d), d);
    if (w.count > 0) fail_msg("%s: %s", path, w.item[0].text);
    orr_warnings_free(&w);
}

static size_t column_of(const orr_sp3 *f, orr_sat sat)
{
    for (size_t k = 0; k < f->n_sats; k++)
        if (f->sat[k] == sat) return k;
    fail_msg("a satellite is not in the file");
    return 0;
}

// ---- the truth itself ----

static orr_vec3 random_place(uint64_t k, double r)
{
    double z = 0.9 * sin(1.7 * (double)k), lon = 2.3 * (double)k, q = sqrt(1 - z * z);
    return (orr_vec3){r * q * cos(lon), r * q * sin(lon), r * z};
}

// Two ways of summing the same harmonics, written apart.
static void two_gravity_fields_agree(void **state)
{
    (void)state;
    orr_sample_gravity ours;
    orr_gravity_field theirs;
    orr_diag d = {0};
    orr_sample_gravity_init(&ours, 12);
    ASSERT_OK(orr_gravity_field_init(&theirs, 12, false, &d), d);
    for (uint64_t k = 0; k < 200; k++) {
        orr_vec3 r = random_place(k, 6.8e6 + 1e5 * (double)k), a = orr_sample_gravitation(&ours, r),
                 b = orr_gravity_field_gravitation(&theirs, r);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(a, b)), 0, 3e-15 * orr_vec3_norm(a) * 4);
    }
}

// The part of the Sun that is seen: ours as the overlap of two discs, the program's with a straight limb, 1 %
// of the penumbra.
static void two_shadows_agree(void **state)
{
    (void)state;
    const orr_vec3 sun = {1.496e11, 0, 0};
    int partial = 0;
    for (double y = 6.0e6; y < 6.8e6; y += 1e3) {
        orr_vec3 r = {-2.6e7, y, 0};
        double a = orr_sample_sunlight(r, sun), b = orr_force_sunlight(r, sun);
        ASSERT_NEAR(a, b, 0.02);
        partial += a > 0 && a < 1 ? 1 : 0;
    }
    assert_true(partial > 100); // the penumbra is 240 km wide there
    ASSERT_NEAR(orr_sample_sunlight((orr_vec3){2.6e7, 1e6, 0}, sun), 1, 0);
    ASSERT_NEAR(orr_sample_sunlight((orr_vec3){-2.6e7, 1e6, 0}, sun), 0, 0);
}

// Velocity is the derivative of position, also across steps; the second difference is the acceleration of the
// forces.
static void truth_is_a_motion(void **state)
{
    (void)state;
    const double h = 20;
    for (size_t k = 0; k < orr_sample_truth_count(truth); k++) {
        for (int i = 0; i < 40; i++) {
            orr_time t = orr_time_add_s(orr_sample_start(), 3600 + i * 6000.7);
            orr_vec3 at[5], v;
            for (int j = -2; j <= 2; j++)
                assert_int_equal(orr_sample_truth_at(truth, k, orr_time_add_s(t, j * h), &at[j + 2],
                                                     j == 0 ? &v : NULL, NULL),
                                 ORR_OK);
            double dx = (at[0].x - 8 * at[1].x + 8 * at[3].x - at[4].x) / (12 * h);
            double dz = (at[0].z - 8 * at[1].z + 8 * at[3].z - at[4].z) / (12 * h);
            // ERFA rounds the Earth rotation angle to 2e-14 rad: 5e-7 m over 20 s; and w^5 h^4 r / 30
            ASSERT_NEAR(v.x, dx, 1e-7);
            ASSERT_NEAR(v.z, dz, 1e-7);
        }
    }
    orr_vec3 r;
    assert_int_equal(orr_sample_truth_at(truth, 0, orr_sample_start() - 1, &r, NULL, NULL), ORR_E_RANGE);
    assert_int_equal(
        orr_sample_truth_at(truth, 0, orr_time_add_s(orr_sample_start(), 3 * 86400.0 + 1), &r, NULL, NULL),
        ORR_E_RANGE);
}

// ---- the files ----

static void files_are_the_truth_rounded(void **state)
{
    (void)state;
    const char *const files[] = {DAYS[0], DAYS[1], DAYS[2], SAMPLE("80", "05")};
    for (size_t i = 0; i < 4; i++) {
        orr_sp3 f;
        read_sample(files[i], &f);
        assert_int_equal(f.n_sats, 80);
        assert_int_equal(f.n_epochs, i < 3 ? 97 : 289);
        assert_int_equal(f.version, 'd');
        for (size_t k = 0; k < orr_sample_truth_count(truth); k++) {
            orr_sat sat = orr_sample_truth_sat(truth, k)->sat;
            size_t column = column_of(&f, sat);
            for (size_t e = 0; e < f.n_epochs; e++) {
                const orr_sp3_record *p = &f.record[e * f.n_sats + column];
                orr_vec3 r;
                double clock;
                assert_int_equal(orr_sample_truth_at(truth, k, f.epoch[e], &r, NULL, &clock), ORR_OK);
                if (!orr_sample_has_position(sat, f.epoch[e])) {
                    assert_true(isnan(p->pos_m[0]));
                    continue;
                }
                // half a millimetre of rounding; 1e-6 for another libm or compiler
                ASSERT_NEAR(p->pos_m[0], r.x, 0.501e-3);
                ASSERT_NEAR(p->pos_m[1], r.y, 0.501e-3);
                ASSERT_NEAR(p->pos_m[2], r.z, 0.501e-3);
                if (orr_sample_has_clock(sat, f.epoch[e]))
                    ASSERT_NEAR(p->clock_s, clock, 0.501e-12);
                else
                    assert_true(isnan(p->clock_s));
            }
        }
        orr_sp3_free(&f);
    }
}

static uint8_t flags_at(const char *path, const char *sat, int hour, int minute)
{
    orr_sp3 f;
    read_sample(path, &f);
    size_t e = (size_t)(hour * 4 + minute / 15);
    uint8_t flags = f.record[e * f.n_sats + column_of(&f, orr_sat_parse(sat))].flags;
    orr_sp3_free(&f);
    return flags;
}

static void events_are_flagged(void **state)
{
    (void)state;
    assert_int_equal(flags_at(DAYS[2], "G10", 14, 15), ORR_SP3_MANOEUVRE);
    assert_int_equal(flags_at(DAYS[2], "G10", 14, 0), 0);
    assert_int_equal(flags_at(DAYS[2], "G10", 14, 30), 0);
    assert_int_equal(flags_at(DAYS[1], "G17", 10, 0), ORR_SP3_CLOCK_EVENT);
    assert_int_equal(flags_at(DAYS[1], "G17", 10, 15), 0);
}

// ---- what the smoother makes of them ----

typedef struct tally {
    double n, sum2, max, vel2;
} tally;

static void count(tally *t, double d, double dv)
{
    t->n += 1;
    t->sum2 += d * d;
    t->max = fmax(t->max, d);
    t->vel2 += dv * dv;
}

static orr_ephemeris *smooth(const char *const *path, size_t n, double node_step_s)
{
    orr_sp3 f[3];
    orr_smoother_input input[3] = {0};
    orr_sat_set set;
    orr_diag d = {0};
    ASSERT_OK(orr_sat_set_parse(CHOSEN, &set, &d), d);
    for (size_t i = 0; i < n; i++) {
        read_sample(path[i], &f[i]);
        input[i].sp3 = &f[i];
        snprintf(input[i].name, sizeof input[i].name, "day %zu", i + 1);
    }
    orr_smoother_options options = orr_smoother_defaults();
    options.sats = &set;
    options.node_step_s = node_step_s;
    orr_orbit_solution solution;
    orr_smoother_report report;
    orr_warnings warnings = {0};
    ASSERT_OK(orr_smoother_run(input, n, &options, NULL, NULL, &solution, &report, &warnings, &d), d);
    orr_ephemeris *e = NULL;
    ASSERT_OK(orr_ephemeris_build(&solution, &e, &d), d);
    orr_orbit_solution_free(&solution);
    orr_warnings_free(&warnings);
    for (size_t i = 0; i < n; i++) orr_sp3_free(&f[i]);
    return e;
}

// Differences from the truth every 100 s, which seldom meets a node, of the satellites that `skip` does not
// name.
static tally compare(const orr_ephemeris *e, char system, double from_h, double to_h, const char *skip)
{
    tally t = {0};
    for (size_t k = 0; k < orr_sample_truth_count(truth); k++) {
        orr_sat sat = orr_sample_truth_sat(truth, k)->sat;
        char text[ORR_SAT_TEXT];
        if (orr_sat_system(sat) != system || strstr(skip, orr_sat_text(sat, text)) != NULL) continue;
        for (double s = from_h * 3600 + 50; s < to_h * 3600; s += 100) {
            orr_time at = orr_time_add_s(orr_sample_start(), s);
            orr_sat_state got;
            orr_vec3 r, v;
            assert_int_equal(orr_ephemeris_eval(e, sat, at, &got), ORR_OK);
            assert_int_equal(orr_sample_truth_at(truth, k, at, &r, &v, NULL), ORR_OK);
            count(&t, orr_vec3_norm(orr_vec3_sub(got.pos_m, r)), orr_vec3_norm(orr_vec3_sub(got.vel_mps, v)));
        }
    }
    print_message("  %c  RMS %.3f mm, max %.3f mm, velocity RMS %.2e m/s (%.0f samples)\n", system,
                  1e3 * sqrt(t.sum2 / t.n), 1e3 * t.max, sqrt(t.vel2 / t.n), t.n);
    return t;
}

// Rounding to 1 mm is an error of 0.5 mm in 3-D at each node; a smoother must do better than that inside.
static void one_day_alone(void **state)
{
    (void)state;
    orr_ephemeris *e = smooth(&DAYS[1], 1, 0);
    for (const char *system = "GRE"; *system != '\0'; system++) {
        tally inner = compare(e, *system, 26, 46, "");
        assert_true(sqrt(inner.sum2 / inner.n) < 0.5e-3);
        assert_true(inner.max < 2e-3);
        assert_true(sqrt(inner.vel2 / inner.n) < 5e-6);
        tally edge = compare(e, *system, 24, 24.75, "");
        assert_true(sqrt(edge.sum2 / edge.n) < 1.0e-3);
    }
    orr_ephemeris_free(e);
}

static void hourly_nodes(void **state)
{
    (void)state;
    orr_ephemeris *e = smooth(&DAYS[1], 1, 3600);
    for (const char *system = "GRE"; *system != '\0'; system++) {
        tally inner = compare(e, *system, 26, 46, "");
        assert_true(sqrt(inner.sum2 / inner.n) < (*system == 'R' ? 4e-3 : 2.5e-3));
    }
    orr_ephemeris_free(e);
}

// Clocks are linear between nodes: at a node they are the truth rounded to a picosecond, also where two files
// meet.
static void check_clocks(const orr_ephemeris *e)
{
    for (size_t k = 0; k < orr_sample_truth_count(truth); k++) {
        orr_sat sat = orr_sample_truth_sat(truth, k)->sat;
        for (int i = 0; i <= 3 * 96; i++) {
            orr_time at = orr_time_add_s(orr_sample_start(), i * 900.0);
            orr_sat_state got;
            orr_vec3 r;
            double clock;
            if (!orr_sample_has_clock(sat, at) || !orr_sample_has_position(sat, at)) continue;
            assert_int_equal(orr_sample_truth_at(truth, k, at, &r, NULL, &clock), ORR_OK);
            assert_int_equal(orr_ephemeris_eval(e, sat, at, &got), ORR_OK);
            if ((got.flags & ORR_EPH_CLOCK_VALID) == 0) continue; // beside a gap or a reset
            ASSERT_NEAR(got.clock_s, clock, 0.501e-12);
            assert_true(isfinite(got.clock_rate_sps));
        }
    }
}

static void three_days_with_their_events(void **state)
{
    (void)state;
    orr_diag d = {0};
    orr_ephemeris *e = smooth(DAYS, 3, 0);
    check_clocks(e);
    ASSERT_OK(orr_ephemeris_save(e, "truth-test.nc", "a test", &d), d);
    orr_ephemeris_free(e);
    ASSERT_OK(orr_ephemeris_load("truth-test.nc", &e, &d), d); // all below holds for the product as a file
    remove("truth-test.nc");
    check_clocks(e);
    // across both midnights
    for (const char *system = "GRE"; *system != '\0'; system++) {
        tally t = compare(e, *system, 22, 50, "E24"); // it is gone on the third day
        assert_true(sqrt(t.sum2 / t.n) < 0.5e-3);
    }
    // the burn is G10's alone: before 14:00 and after 14:15 of the third day the orbit is as good as ever at
    // an edge
    const double burn_h = 48 + 14;
    tally before = compare(e, 'G', burn_h - 6, burn_h - 0.01, "G01,G02,G03,G17");
    tally after = compare(e, 'G', burn_h + 0.26, burn_h + 6, "G01,G02,G03,G17");
    assert_true(before.max < 5e-3 && after.max < 5e-3);
    const orr_orbit_event *event;
    size_t n = orr_ephemeris_events(e, orr_sat_make('G', 10), &event), burns = 0;
    for (size_t i = 0; i < n; i++) burns += event[i].kind == ORR_EVENT_MANOEUVRE ? 1 : 0;
    assert_int_equal(burns, 1);
    // the gap of three hours in R08 is bridged, and worse than elsewhere
    tally gap = compare(e, 'R', 9, 12, "R01,R02,R21");
    assert_true(gap.max < 0.05);
    // after its last node E24 has no orbit, and says so
    orr_sat_state got;
    assert_int_equal(
        orr_ephemeris_eval(e, orr_sat_make('E', 24), orr_time_add_s(orr_sample_start(), 50 * 3600.0), &got),
        ORR_E_NODATA);
    orr_ephemeris_free(e);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_gravity_fields_agree),
        cmocka_unit_test(two_shadows_agree),
        cmocka_unit_test(truth_is_a_motion),
        cmocka_unit_test(files_are_the_truth_rounded),
        cmocka_unit_test(events_are_flagged),
        cmocka_unit_test(one_day_alone),
        cmocka_unit_test(hourly_nodes),
        cmocka_unit_test(three_days_with_their_events),
    };
    return cmocka_run_group_tests(tests, make_truth, drop_truth);
}
