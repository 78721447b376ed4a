// SPDX-License-Identifier: GPL-3.0-or-later
// The engine of a product alone: elements and broadcast data are what orbit/ says of the same product, and
// where there is nothing it says why.
#include "src/scenario/engine/engine.h"

#include <unistd.h>

#include "elements_at.h"
#include "testing.h"
#include "unit/orbit/made_orbit.h"

#define PRODUCT ORR_BINARY_DIR "/engine.nc"

// n satellites of the made constellation (G01, R01, E01, G02, ...) over `hours`, those of `only` if not 0.
static void write_product(size_t n, double hours, char only)
{
    orr_diag diag = {0};
    orr_orbit_solution s = made_solution(n, hours, 900, 6);
    if (only != 0) {
        size_t kept = 0;
        for (size_t i = 0; i < s.n_sats; i++)
            if (orr_sat_system(s.sat[i].sat) == only) {
                orr_orbit_sat swap = s.sat[kept];
                s.sat[kept++] = s.sat[i];
                s.sat[i] = swap;
            }
        s.n_sats = kept;
    }
    orr_ephemeris *e = NULL;
    ASSERT_OK(orr_ephemeris_build(&s, &e, &diag), diag);
    ASSERT_OK(orr_ephemeris_save(e, PRODUCT, "made for a test", &diag), diag);
    orr_ephemeris_free(e);
    s.n_sats = n;
    made_solution_free(&s);
}

static orr_status open_product(const volatile int *cancel, orr_navdata_window window, orr_engine **e,
                               orr_diag *diag)
{
    orr_scenario s;
    ASSERT_OK(orr_scenario_of_product(PRODUCT, NULL, &s, diag), *diag);
    s.navdata.window = (int)window;
    orr_status status = orr_engine_open(&s, NULL, cancel, NULL, e, diag);
    orr_scenario_free(&s);
    return status;
}

static orr_time at(double t_s) { return orr_time_add_s(made_midnight, t_s); }

static orr_answer elements(const orr_engine *e, double t_s, orr_elements_frame frame, int method,
                           const orr_sat *sats, size_t n, orr_kepler *k, uint32_t *flags, orr_answer *answer)
{
    orr_elements_axes axes;
    orr_answer all = orr_engine_axes(e, at(t_s), frame, (orr_elements_method)method, &axes);
    return all != ORR_ANSWER_OK ? all : orr_engine_elements(e, &axes, sats, n, k, flags, answer);
}

static void elements_are_those_of_the_orbits(void **state)
{
    (void)state;
    write_product(6, 24, 0);
    orr_engine *e;
    orr_ephemeris *p;
    orr_diag diag = {0};
    ASSERT_OK(open_product(NULL, ORR_NAVDATA_NONE, &e, &diag), diag);
    ASSERT_OK(orr_ephemeris_load(PRODUCT, &p, &diag), diag);
    const orr_sat asked[4] = {orr_sat_make('R', 2), orr_sat_make('G', 1), orr_sat_make('G', 9),
                              orr_sat_make('R', 2)};
    orr_kepler k[6];
    uint32_t flags[6];
    orr_answer answer[6];
    for (int m = ORR_ELEMENTS_STATE; m <= ORR_ELEMENTS_MEAN; m++) {
        const orr_elements_options o = {.frame = ORR_ELEMENTS_J2000, .method = (orr_elements_method)m};
        assert_int_equal(elements(e, 43000, ORR_ELEMENTS_J2000, m, asked, 4, k, flags, answer),
                         ORR_ANSWER_OK);
        assert_int_equal(answer[2], ORR_ANSWER_NOT_SERVED);
        for (size_t i = 0; i < 4; i++) {
            orr_kepler want;
            if (i == 2) continue;
            assert_int_equal(elements_at(p, asked[i], at(43000), &o, &want), ORR_OK);
            assert_int_equal(answer[i], ORR_ANSWER_OK);
            assert_true(k[i].a_m == want.a_m && k[i].e == want.e && k[i].u_rad == want.u_rad);
        }
        // All of them, in their order; near the begin the means have no value.
        assert_int_equal(elements(e, 400, ORR_ELEMENTS_DATE, m, NULL, 6, k, flags, answer), ORR_ANSWER_OK);
        for (size_t i = 0; i < 6; i++)
            assert_int_equal(answer[i], m == ORR_ELEMENTS_MEAN ? ORR_ANSWER_NO_VALUE : ORR_ANSWER_OK);
    }
    // The made eclipse of 1060 to 4000 s is the state's flag.
    assert_int_equal(elements(e, 2000, ORR_ELEMENTS_DATE, ORR_ELEMENTS_STATE, NULL, 6, k, flags, answer),
                     ORR_ANSWER_OK);
    assert_true((flags[0] & ORR_EPH_ECLIPSE) != 0);
    assert_int_equal(elements(e, -1, ORR_ELEMENTS_DATE, ORR_ELEMENTS_STATE, NULL, 6, k, flags, answer),
                     ORR_ANSWER_OUTSIDE_SPAN);
    orr_ephemeris_free(p);
    orr_engine_close(e);
}

static void navdata_are_those_of_the_navset(void **state)
{
    (void)state;
    write_product(6, 12, 0); // G01 G02 R01 R02 E01 E02
    orr_engine *e;
    orr_ephemeris *p;
    orr_navset *set;
    orr_diag diag = {0};
    ASSERT_OK(open_product(NULL, ORR_NAVDATA_2H, &e, &diag), diag);
    ASSERT_OK(orr_ephemeris_load(PRODUCT, &p, &diag), diag);
    const orr_navset_options o = orr_navset_defaults();
    ASSERT_OK(orr_navset_build(p, &o, &set, NULL, &diag), diag);
    assert_null(orr_engine_no_navdata(e));
    const orr_sat *sat;
    size_t n = orr_engine_satellites(e, &sat), sent = 0;
    const orr_navset_item *item;
    for (double t_s = 1; t_s < 12 * 3600; t_s += 997.3) {
        static orr_navframe frame, want;
        for (size_t i = 0; i < n; i++) {
            const orr_nav_stream *streams[ORR_NAVSET_STREAMS];
            const size_t m = orr_engine_navdata_streams(e, sat[i], UINT32_MAX, streams);
            const orr_navset_item *list; // none of orbits without J2 by GLONASS' model
            if (orr_navset_items(set, sat[i], ORR_NAV_NONE, &list) == 0) {
                assert_true(orr_sat_system(sat[i]) == 'R' && m == 0);
                assert_int_equal(orr_engine_navdata(e, at(t_s), sat[i], NULL, false, &item, &frame),
                                 ORR_ANSWER_NOT_SERVED);
                assert_null(item);
                continue;
            }
            const char system = orr_sat_system(sat[i]);
            // FDMA; LNAV, CNAV on L2C and L5, CNAV-2; I/NAV on E1 and E5b, F/NAV.
            assert_int_equal(m, system == 'R' ? 1 : system == 'G' ? 4 : 3);
            const orr_nav_stream *first[ORR_NAVSET_STREAMS];
            assert_int_equal(orr_engine_navdata_streams(e, sat[i], 0, first), 1);
            assert_ptr_equal(first[0], streams[0]);
            for (size_t k = 0; k < m; k++) {
                const orr_navset_item *there =
                    orr_navset_at(set, sat[i], (orr_nav_message)streams[k]->message, at(t_s));
                memset(&frame, 0, sizeof frame);
                assert_int_equal(orr_engine_navdata(e, at(t_s), sat[i], streams[k], k == 1, &item, &frame),
                                 there != NULL ? ORR_ANSWER_OK : ORR_ANSWER_NO_ARC);
                if (there == NULL) continue;
                ASSERT_OK(orr_navframe_at(set, sat[i], streams[k], at(t_s), k == 1, &want, &diag), diag);
                assert_memory_equal(&frame, &want, sizeof want);
                assert_true(item->from == there->from && item->eph.toe == there->eph.toe);
                sent++;
            }
        }
    }
    assert_true(sent > 80);
    assert_int_equal(orr_engine_navdata(e, at(43201), sat[0], NULL, false, &item, NULL),
                     ORR_ANSWER_OUTSIDE_SPAN);
    orr_navset_free(set);
    orr_ephemeris_free(p);
    orr_engine_close(e);
}

static void what_is_not_there_is_told(void **state)
{
    (void)state;
    orr_engine *e;
    orr_diag diag = {0};
    write_product(6, 6, 'R'); // orbits without J2 are none by GLONASS' model
    ASSERT_OK(open_product(NULL, ORR_NAVDATA_2H, &e, &diag), diag); // the rest of it is served
    assert_non_null(strstr(orr_engine_no_navdata(e), "sends one of the messages"));
    orr_engine_close(e);
    write_product(6, 6, 0);
    ASSERT_OK(open_product(NULL, ORR_NAVDATA_NONE, &e, &diag), diag);
    assert_non_null(strstr(orr_engine_no_navdata(e), "navdata.window"));
    orr_engine_close(e);
    // An interrupt ends the preparation, and leaves nothing behind.
    const volatile int stop = 1;
    e = NULL;
    assert_int_equal(open_product(&stop, ORR_NAVDATA_2H, &e, &diag), ORR_E_INTERRUPTED);
    assert_null(e);
    unlink(PRODUCT);
}

static void open_text(const char *text, orr_engine **e)
{
    orr_scenario s;
    orr_diag diag = {0};
    ASSERT_OK(orr_scenario_parse("s.yaml", text, strlen(text), ORR_BINARY_DIR, NULL, &s, &diag), diag);
    ASSERT_OK(orr_engine_open(&s, NULL, NULL, NULL, e, &diag), diag);
    orr_scenario_free(&s);
}

#define FIELD "ionosphere: {field: engine.ION}\n"
static void copy_field(void)
{
    char line[200];
    FILE *in = fopen(ORR_SOURCE_DIR "/samples/ionosphere.ION", "r"),
         *out = fopen(ORR_BINARY_DIR "/engine.ION", "w");
    assert_true(in != NULL && out != NULL);
    while (fgets(line, sizeof line, in) != NULL) fputs(line, out);
    fclose(in);
    assert_int_equal(fclose(out), 0);
}

static bool same(orr_vec3 a, orr_vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

// What is written down holds; else what moves, at each epoch and to the bit; else nothing, and it says so.
static void the_receiver_is_on_the_trajectory(void **state)
{
    (void)state;
#define MADE "orbit: {product: engine.nc}\nnavdata: {window: none}\n"
#define FLIGHT                                                                                               \
    "trajectory: {kind: analytic, duration: 600, lat: 56, lon: 40, height: 900, motions: [{kind: eight}]}\n" \
    "units: [{name: antenna, up: 2.5, forward: -1}]\n"
    orr_engine *e;
    orr_truth truth;
    orr_vec3 r;
    write_product(3, 6, 0);
    copy_field();
    open_text(MADE, &e);
    assert_int_equal(orr_engine_receiver(e, at(60), &r), ORR_ANSWER_NOT_SERVED);
    orr_engine_close(e);
    for (size_t unit = 0; unit < 2; unit++) {
        orr_vec3 before = {0};
        open_text(unit == 0 ? MADE FLIGHT : MADE FLIGHT FIELD "receiver: {unit: 1}\n", &e);
        for (double t_s = 0; t_s <= 600; t_s += 60) {
            assert_int_equal(orr_engine_receiver(e, at(t_s), &r), ORR_ANSWER_OK);
            assert_int_equal(orr_engine_truth(e, unit, at(t_s), &truth), ORR_ANSWER_OK);
            assert_true(same(r, truth.motion.r_m) && !same(r, before));
            before = r;
        }
        assert_int_equal(orr_engine_receiver(e, at(-1e-3), &r), ORR_ANSWER_OUTSIDE_SPAN);
        assert_int_equal(orr_engine_receiver(e, at(600.001), &r), ORR_ANSWER_OUTSIDE_SPAN);
        orr_engine_close(e);
    }
    open_text(MADE FLIGHT FIELD "receiver: {position: [56.1, 40, 1500]}\n", &e);
    assert_int_equal(orr_engine_receiver_kind(e, NULL), ORR_RECEIVER_PLACE);
    for (double t_s = -60; t_s <= 660; t_s += 360) {
        assert_int_equal(orr_engine_receiver(e, at(t_s), &r), ORR_ANSWER_OK);
        orr_geodetic g = orr_earth_from_ecef(r);
        ASSERT_NEAR(g.lat_rad * ORR_DEG_PER_RAD, 56.1, 1e-12);
        ASSERT_NEAR(g.height_m, 1500, 1e-8);
    }
    orr_engine_close(e);
    unlink(PRODUCT);
}

static bool holds(const orr_engine *e, orr_engine_part part, orr_time from, orr_time to)
{
    orr_span span;
    return orr_engine_part_span(e, part, &span) && span.from == from && span.to == to;
}

// An IMU alone on the wire: motion is served, and what needs satellites says that there are none.
static void a_trajectory_without_satellites(void **state)
{
    (void)state;
    orr_engine *e;
    orr_truth truth;
    orr_vec3 r;
    const orr_sat *sats;
    orr_sat_state sat_state;
    orr_kepler k;
    orr_answer answer;
    uint32_t flags;
    orr_span span;
    const orr_sat g1 = orr_sat_make('G', 1);
    const orr_navset_item *item;
    orr_realisation delay;
    static orr_navframe frame;
    open_text("title: alone\n"
              "trajectory: {kind: analytic, start: 2024-02-04T12:00:00, duration: 60, lat: 50, lon: 20}\n"
              "units: [{name: tail, forward: -3, heading: 90}]\nimu: {rate: 50}\n",
              &e);
    orr_time start = orr_time_from_week(2300, 12 * 3600 * ORR_NS_PER_S), end = orr_time_add_s(start, 60),
             from, to;
    assert_string_equal(orr_engine_title(e), "alone");
    assert_string_equal(orr_engine_frame(e), "WGS84");
    orr_engine_span(e, &from, &to);
    assert_true(from == start && to == end && holds(e, ORR_PART_MOTION, start, end));
    assert_false(orr_engine_part_span(e, ORR_PART_ORBITS, &span) ||
                 orr_engine_part_span(e, ORR_PART_NAVDATA, &span) ||
                 orr_engine_part_span(e, ORR_PART_IONOSPHERE, &span));
    assert_int_equal(orr_engine_satellites(e, &sats), 0);
    assert_int_equal(orr_engine_states(e, NULL, start, &g1, 1, &sat_state, &answer), ORR_ANSWER_NOT_SERVED);
    assert_int_equal(orr_engine_states(e, NULL, start, NULL, 0, &sat_state, &answer), ORR_ANSWER_NOT_SERVED);
    orr_elements_axes axes = {.t = start};
    assert_int_equal(orr_engine_axes(e, start, ORR_ELEMENTS_DATE, ORR_ELEMENTS_STATE, &axes),
                     ORR_ANSWER_NOT_SERVED);
    assert_int_equal(orr_engine_elements(e, &axes, &g1, 1, &k, &flags, &answer), ORR_ANSWER_NOT_SERVED);
    assert_non_null(strstr(orr_engine_no_navdata(e), "no satellites"));
    assert_int_equal(orr_engine_navdata(e, start, g1, NULL, false, &item, &frame), ORR_ANSWER_NOT_SERVED);
    assert_int_equal(orr_engine_delays(e, start, (orr_vec3){6.4e6, 0, 0}, &g1, 1, &delay, &answer),
                     ORR_ANSWER_NOT_SERVED);

    orr_unit unit;
    assert_int_equal(orr_engine_units(e), 2);
    assert_true(orr_engine_unit(e, 0, &unit) && unit.name[0] == '\0' && orr_vec3_norm(unit.arm_m) == 0);
    assert_true(orr_engine_unit(e, 1, &unit) && strcmp(unit.name, "tail") == 0 && unit.arm_m.y == -3);
    ASSERT_NEAR(unit.turn.heading_rad, ORR_PI / 2, 1e-15);
    assert_false(orr_engine_unit(e, 2, &unit));
    assert_true(orr_engine_imu_rate(e) == 50 && orr_engine_imu_physical(e));
    size_t at_unit = 9;
    assert_int_equal(orr_engine_receiver_kind(e, &at_unit), ORR_RECEIVER_UNIT);
    assert_int_equal(at_unit, 0);
    // At rest the readings are the Earth's turn and the pull upward of normal gravity.
    assert_int_equal(orr_engine_truth(e, 0, start, &truth), ORR_ANSWER_OK);
    orr_sensors_sum sum;
    assert_int_equal(orr_engine_imu_begin(e, 0, start, orr_time_add_s(start, 1), &sum), ORR_ANSWER_OK);
    while (!orr_engine_imu_add(e, 0, &sum, 1)) continue;
    const orr_vec3 dtheta = sum.dtheta_rad, dv = sum.dv_mps;
    ASSERT_NEAR(orr_vec3_norm(dtheta), ORR_EARTH_RATE_RADPS, 1e-15);
    // The force turns with the body: over a second its integral is that of the middle to (w t)^2/24 = 2e-10.
    ASSERT_NEAR(orr_vec3_norm(dv), orr_vec3_norm(truth.force_mps2), 9.8 * 2.3e-10);
    assert_int_equal(orr_engine_receiver(e, end, &r), ORR_ANSWER_OK);
    assert_int_equal(orr_engine_truth(e, 0, orr_time_add_s(end, 1), &truth), ORR_ANSWER_OUTSIDE_SPAN);
    assert_int_equal(orr_engine_truth(e, 2, start, &truth), ORR_ANSWER_NOT_SERVED);
    orr_engine_close(e);
}

// Every part tells the time that it covers, and what is missing is told apart from what does not cover t.
static void parts_tell_their_spans(void **state)
{
    (void)state;
    write_product(3, 6, 0);
    orr_engine *e;
    orr_span span;
    orr_truth truth;
    open_text(MADE FLIGHT "imu: {approach: 1}\n", &e);
    assert_true(holds(e, ORR_PART_ORBITS, at(0), at(6 * 3600)) && holds(e, ORR_PART_MOTION, at(0), at(600)));
    assert_false(orr_engine_part_span(e, ORR_PART_NAVDATA, &span)); // window: none
    assert_false(orr_engine_part_span(e, ORR_PART_IONOSPHERE, &span) || orr_engine_navdata_phase_centres(e));
    assert_int_equal(orr_engine_receiver_kind(e, NULL), ORR_RECEIVER_UNIT);
    orr_sensors_sum sum;
    assert_false(orr_engine_imu_physical(e));
    assert_int_equal(orr_engine_imu_begin(e, 0, at(1), at(2), &sum), ORR_ANSWER_NOT_SERVED);
    assert_int_equal(orr_engine_truth(e, 0, at(1), &truth), ORR_ANSWER_OK);
    orr_engine_close(e);
    open_text("orbit: {product: engine.nc}\n", &e);
    assert_true(holds(e, ORR_PART_NAVDATA, at(0), at(6 * 3600)));
    assert_false(orr_engine_part_span(e, ORR_PART_MOTION, &span));
    assert_true(orr_engine_units(e) == 0 && orr_engine_imu_rate(e) == 0);
    assert_int_equal(orr_engine_receiver_kind(e, NULL), ORR_RECEIVER_NONE);
    assert_int_equal(orr_engine_truth(e, 0, at(1), &truth), ORR_ANSWER_NOT_SERVED);
    orr_engine_close(e);
    unlink(PRODUCT);
}

// satellites.unhealthy is what the broadcast data say of these satellites; what they say of others stays.
static void unhealthy_satellites_say_so(void **state)
{
    (void)state;
    write_product(4, 6, 0);
    orr_engine *plain, *e;
    open_text("orbit: {product: engine.nc}\n", &plain);
    open_text("orbit: {product: engine.nc}\nsatellites: {unhealthy: E01}\nsignals: [G]\n"
              "antennas: [{name: A, position: [50, 10, 100]}]\n",
              &e);
    const orr_sat *sat;
    const size_t n = orr_engine_satellites(e, &sat);
    size_t changed = 0;
    for (size_t i = 0; i < n; i++) {
        const orr_nav_stream *stream[ORR_NAVSET_STREAMS];
        const orr_navset_item *item, *was;
        static orr_navframe frame;
        const size_t m = orr_engine_navdata_streams(e, sat[i], UINT32_MAX, stream);
        for (size_t k = 0; k < m; k++) {
            assert_int_equal(orr_engine_navdata(e, at(19000), sat[i], stream[k], false, &item, &frame),
                             ORR_ANSWER_OK);
            assert_int_equal(orr_engine_navdata(plain, at(19000), sat[i], stream[k], false, &was, &frame),
                             ORR_ANSWER_OK);
            const bool marked = sat[i] == orr_sat_make('E', 1);
            assert_true(marked ? item->eph.health != 0 : item->eph.health == was->eph.health);
            changed += item->eph.health != was->eph.health;
        }
    }
    assert_int_equal(changed, 3); // I/NAV on E1 and E5b, F/NAV
    orr_engine_close(plain);
    orr_engine_close(e);
    unlink(PRODUCT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(elements_are_those_of_the_orbits),
        cmocka_unit_test(navdata_are_those_of_the_navset),
        cmocka_unit_test(what_is_not_there_is_told),
        cmocka_unit_test(the_receiver_is_on_the_trajectory),
        cmocka_unit_test(a_trajectory_without_satellites),
        cmocka_unit_test(parts_tell_their_spans),
        cmocka_unit_test(unhealthy_satellites_say_so),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
