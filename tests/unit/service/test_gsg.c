// SPDX-License-Identifier: GPL-3.0-or-later
// GSG's words of motion: units, axes and which sample they make, by what the vehicle gets of them.
#include "core/constants.h"
#include "core/earth.h"
#include "fake.h"
#include "src/service/text/session.h"
#include "testing.h"

typedef struct bench {
    fake fake;
    orr_server server;
    orr_vehicle *vehicle;
    orr_streams *streams;
    orr_asked asked;
    orr_text_session session;
    orr_msg_motion last;
    unsigned n;
} bench;

static void host_of(void *user, orr_host *h)
{
    (void)user;
    *h = (orr_host){5 * ORR_NS_PER_S, 5 * ORR_NS_PER_S, 5 * ORR_NS_PER_S, 5 * ORR_NS_PER_S};
}

static void record(void *user, const orr_msg_motion *m, orr_time from)
{
    (void)from;
    bench *b = user;
    b->last = *m;
    b->n++;
}

static void say(bench *b, const char *line)
{
    FILE *out = tmpfile();
    assert_non_null(out);
    orr_text_session_take(&b->session, line, strlen(line), out);
    orr_text_session_take(&b->session, "\n", 1, out);
    assert_int_equal(ftell(out), 0); // none of them answers
    fclose(out);
    assert_int_equal(b->session.scpi.n_errors, 0);
}

static int set_up(void **state)
{
    static bench b;
    orr_diag diag = {0};
    b = (bench){.fake.n_sats = 3};
    b.server = fake_server(&b.fake);
    const orr_vehicle_options live = {
        .join_s = 0.065, .length_ns = 5000000, .record = record, .record_user = &b};
    ASSERT_OK(orr_vehicle_open(&live, &b.vehicle, &diag), diag);
    const orr_streams_options o = {
        .maker = &b.server, .host = host_of, .host_user = &b, .vehicle = b.vehicle, .processor = -1};
    ASSERT_OK(orr_streams_open(&o, &b.streams, &diag), diag);
    b.asked = (orr_asked){.server = &b.server, .streams = b.streams, .may = ORR_MAY_ALL};
    assert_true(orr_text_session_open(&b.session, &b.asked));
    say(&b, "SCEN:STAR");
    *state = &b;
    return 0;
}

static int tear_down(void **state)
{
    bench *b = *state;
    orr_text_session_close(&b->session);
    orr_streams_close(b->streams);
    orr_vehicle_close(b->vehicle);
    return 0;
}

static void place_and_derivatives(void **state)
{
    bench *b = *state;
    const orr_geodetic g = {56 * ORR_RAD_PER_DEG, 40 * ORR_RAD_PER_DEG, 150};
    const orr_vec3 r = orr_earth_to_ecef(g);
    const orr_mat3 enu = orr_earth_enu_from_ecef(g.lat_rad, g.lon_rad);
    say(b, "SOUR:SCEN:POS 1,56,40,150");
    assert_int_equal(b->n, 1);
    assert_int_equal(b->last.t, ORR_NS_PER_S);
    assert_int_equal(b->last.order, 0);
    const double at[3] = {r.x, r.y, r.z};
    for (int k = 0; k < 3; k++) ASSERT_NEAR(b->last.pos_m[k], at[k], 1e-6);
    say(b, "SOURce:SCENario:ENUVELocity 2,3,4,5;ENUACC 2,0.1,0.2,0.3");
    say(b, "SOUR:SCEN:POS 2,56,40,150");
    assert_int_equal(b->n, 2);
    assert_int_equal(b->last.order, 2);
    const orr_vec3 v = orr_mat3_apply(&enu,
                                      (orr_vec3){b->last.vel_mps[0], b->last.vel_mps[1], b->last.vel_mps[2]}),
                   a = orr_mat3_apply(
                       &enu, (orr_vec3){b->last.acc_mps2[0], b->last.acc_mps2[1], b->last.acc_mps2[2]});
    ASSERT_NEAR(v.x, 3, 1e-9);
    ASSERT_NEAR(v.y, 4, 1e-9);
    ASSERT_NEAR(v.z, 5, 1e-9);
    ASSERT_NEAR(a.x, 0.1, 1e-12);
    ASSERT_NEAR(a.z, 0.3, 1e-12);
    char line[200];
    say(b, "SOUR:SCEN:ECEFVEL 3,7,8,9;ECEFACC 3,-1,-2,-3");
    snprintf(line, sizeof line, "SOUR:SCEN:ECEFPOS 3,%.6f,%.6f,%.6f", r.x, r.y, r.z);
    say(b, line);
    assert_true(b->last.vel_mps[0] == 7 && b->last.vel_mps[2] == 9 && b->last.acc_mps2[1] == -2);
}

static void attitudes_in_radians_and_degrees(void **state)
{
    bench *b = *state;
    orr_msg_motion in_degrees;
    const unsigned before = b->n;
    say(b, "SOUR:SCEN:DPRY 4,10,-20,30;POS 4,56,40,150");
    in_degrees = b->last;
    assert_int_equal(in_degrees.angular_order, 1);
    char line[200];
    snprintf(line, sizeof line, "SOUR:SCEN:PRY 5,%.15f,%.15f,%.15f;POS 5,56,40,150", 10 * ORR_RAD_PER_DEG,
             -20 * ORR_RAD_PER_DEG, 30 * ORR_RAD_PER_DEG);
    say(b, line);
    assert_int_equal(b->n, before + 2);
    for (int k = 0; k < 4; k++) ASSERT_NEAR(b->last.attitude[k], in_degrees.attitude[k], 1e-12);
    // The body stands level and looks North: rates of pitch, roll and yaw are those about right, forward and down.
    say(b, "SOUR:SCEN:PRY 6,0,0,0;PRYRate 6,0.1,0.2,0.3;POS 6,56,40,150");
    assert_int_equal(b->last.angular_order, 2);
    ASSERT_NEAR(b->last.rate_radps[0], 0.1, 1e-12);
    ASSERT_NEAR(b->last.rate_radps[1], 0.2, 1e-12);
    ASSERT_NEAR(b->last.rate_radps[2], -0.3, 1e-12);
    say(b, "SOUR:SCEN:DPRYR 7,18,0,0;POS 7,56,40,150");
    ASSERT_NEAR(b->last.rate_radps[0], ORR_PI / 10, 1e-12);
    ASSERT_NEAR(b->last.rate_radps[2], 0, 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(place_and_derivatives),
        cmocka_unit_test(attitudes_in_radians_and_degrees),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
