// SPDX-License-Identifier: GPL-3.0-or-later
// Laboratories' datagrams, byte by byte, and what becomes of bytes that are none.
#include "src/service/dialect/dialect.h"

#include "core/earth.h"
#include "proto/frame.h"
#include "testing.h"

static const orr_time BEGIN = 1000 * ORR_NS_PER_S;

static orr_dialect_result take(const orr_dialect *d, orr_dialect_state *s, const uint8_t *data, size_t n,
                               orr_msg_motion *m, size_t *n_reply)
{
    static uint8_t reply[ORR_DIALECT_REPLY];
    return d->take(s, data, n, m, reply, n_reply);
}

static size_t put(uint8_t *to, size_t at, const double *v, size_t n)
{
    for (size_t k = 0; k < n; k++) orr_wire_store_f64(to + at + 8 * k, v[k]);
    return at + 8 * n;
}

// ECEF with acceleration: 1 + 1 + 8 + 72 + 4 bytes.
static void skydel_places(void **state)
{
    (void)state;
    uint8_t b[200] = {7, 1};
    const double ms = 1234.5, v[] = {3e6, 2e6, 5.2e6, 10, 20, 30, 1, 2, 3};
    size_t n = put(b, 2, &ms, 1), n_reply;
    n = put(b, n, v, 9);
    orr_wire_store_u32(b + n, 0);
    n += 4;
    assert_int_equal(n, 86);
    orr_dialect_state s = {.begin = BEGIN};
    orr_msg_motion m;
    assert_int_equal(take(&orr_dialect_skydel, &s, b, n, &m, &n_reply), ORR_DIALECT_SAMPLE);
    assert_true(m.t == BEGIN + 1234500000 && m.order == 2 && m.angular_order == 0 && n_reply == 0);
    assert_memory_equal(m.pos_m, v, 24);
    assert_memory_equal(m.vel_mps, v + 3, 24);
    assert_memory_equal(m.acc_mps2, v + 6, 24);
    for (size_t k = 0; k < n; k++)
        assert_int_equal(take(&orr_dialect_skydel, &s, b, k, &m, &n_reply), ORR_DIALECT_WRONG);
    assert_int_equal(take(&orr_dialect_skydel, &s, b, n + 1, &m, &n_reply), ORR_DIALECT_WRONG);
    b[1] = 3;
    assert_int_equal(take(&orr_dialect_skydel, &s, b, n, &m, &n_reply), ORR_DIALECT_WRONG);
    b[1] = 1;
    orr_wire_store_u32(b + n - 4, 2); // of a jammer called "J1"
    b[n] = 'J', b[n + 1] = '1';
    assert_int_equal(take(&orr_dialect_skydel, &s, b, n + 2, &m, &n_reply), ORR_DIALECT_NOTHING);
    // Who has greeted is told where the vehicle is.
    b[0] = 1;
    assert_int_equal(take(&orr_dialect_skydel, &s, b, 1, &m, &n_reply), ORR_DIALECT_NOTHING);
    b[0] = 7;
    orr_wire_store_u32(b + n - 4, 0);
    assert_int_equal(take(&orr_dialect_skydel, &s, b, n, &m, &n_reply), ORR_DIALECT_SAMPLE);
    assert_int_equal(n_reply, 1 + 8 + 72);
}

// Attitude and its rates: the angles come back, and rates are the derivatives of the attitude.
static void skydel_turns(void **state)
{
    (void)state;
    const double angle[3] = {1.0, 0.3, -0.4}, rate[3] = {0.2, -0.1, 0.5}, h = 1e-4;
    const orr_vec3 r = orr_earth_to_ecef((orr_geodetic){0.97, 0.69, 1500});
    orr_msg_motion m[3];
    for (int k = 0; k < 3; k++) {
        uint8_t b[200] = {8, 0};
        const double ms = 0, zero[3] = {0}, place[3] = {r.x, r.y, r.z}, s = (k - 1) * h,
                     now[3] = {angle[0] + s * rate[0], angle[1] + s * rate[1], angle[2] + s * rate[2]};
        size_t n = put(b, 2, &ms, 1), n_reply;
        n = put(b, put(b, put(b, put(b, n, place, 3), now, 3), zero, 3), rate, 3);
        orr_wire_store_u32(b + n, 0);
        assert_int_equal(n + 4, 110);
        orr_dialect_state state_of = {.begin = BEGIN};
        assert_int_equal(take(&orr_dialect_skydel, &state_of, b, n + 4, &m[k], &n_reply), ORR_DIALECT_SAMPLE);
        assert_true(m[k].order == 1 && m[k].angular_order == 2);
    }
    const double *q = m[1].attitude;
    const orr_motion told = {.r_m = r, .q_be = {q[0], q[1], q[2], q[3]}};
    const orr_angles a = orr_motion_angles(&told);
    ASSERT_NEAR(a.heading_rad, angle[0], 1e-12);
    ASSERT_NEAR(a.pitch_rad, angle[1], 1e-12);
    ASSERT_NEAR(a.roll_rad, angle[2], 1e-12);
    const orr_quat back = {m[0].attitude[0], -m[0].attitude[1], -m[0].attitude[2], -m[0].attitude[3]},
                   on = {m[2].attitude[0], m[2].attitude[1], m[2].attitude[2], m[2].attitude[3]};
    const orr_quat d = orr_quat_mul(back, on);
    const double sign = d.w < 0 ? -1 : 1;
    ASSERT_NEAR(sign * d.x / h, m[1].rate_radps[0], 1e-7);
    ASSERT_NEAR(sign * d.y / h, m[1].rate_radps[1], 1e-7);
    ASSERT_NEAR(sign * d.z / h, m[1].rate_radps[2], 1e-7);
    ASSERT_NEAR((m[2].rate_radps[0] - m[0].rate_radps[0]) / (2 * h), m[1].rate2_radps2[0], 1e-5);
}

static orr_dialect_result text(const orr_dialect *d, orr_dialect_state *s, const char *line,
                               orr_msg_motion *m)
{
    size_t n_reply;
    return take(d, s, (const uint8_t *)line, strlen(line), m, &n_reply);
}

static void lines(void **state)
{
    (void)state;
    orr_dialect_state s = {.begin = BEGIN};
    orr_msg_motion m;
    assert_int_equal(text(&orr_dialect_lines, &s, "0.1, 3e6,2e6, 5.2e6\n", &m), ORR_DIALECT_SAMPLE);
    assert_true(m.t == BEGIN + 100000000 && m.order == 0 && m.pos_m[2] == 5.2e6);
    assert_int_equal(text(&orr_dialect_lines, &s, "2 1 2 3 4 5 6 7 8 9 10 11 12", &m), ORR_DIALECT_SAMPLE);
    assert_true(m.order == 3 && m.jerk_mps3[0] == 10);
    assert_int_equal(text(&orr_dialect_lines, &s, "# a remark", &m), ORR_DIALECT_NOTHING);
    static const char *const bad[] = {"1,2,3", "1,2,3,x", "1,2,3,4,5", "nan,1,2,3",
                                      "1,2,3,4,5,6,7,8,9,10,11,12,13,14"};
    for (int k = 0; k < 5; k++) assert_int_equal(text(&orr_dialect_lines, &s, bad[k], &m), ORR_DIALECT_WRONG);
}

static void nmea(void **state)
{
    (void)state;
    orr_dialect_state s = {.begin = BEGIN, .now = BEGIN + 7};
    orr_msg_motion m;
    assert_int_equal(text(&orr_dialect_nmea, &s,
                          "$GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W*6A", &m),
                     ORR_DIALECT_NOTHING);
    assert_int_equal(text(&orr_dialect_nmea, &s,
                          "$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n", &m),
                     ORR_DIALECT_SAMPLE);
    const orr_geodetic g = orr_earth_from_ecef((orr_vec3){m.pos_m[0], m.pos_m[1], m.pos_m[2]});
    ASSERT_NEAR(g.lat_rad * ORR_DEG_PER_RAD, 48 + 7.038 / 60, 1e-9);
    ASSERT_NEAR(g.lon_rad * ORR_DEG_PER_RAD, 11 + 31.0 / 60, 1e-9);
    ASSERT_NEAR(g.height_m, 545.4 + 46.9, 1e-6);
    ASSERT_NEAR(sqrt(m.vel_mps[0] * m.vel_mps[0] + m.vel_mps[1] * m.vel_mps[1] + m.vel_mps[2] * m.vel_mps[2]),
                22.4 * 1852 / 3600, 1e-9);
    assert_true(m.t == BEGIN + 7 && m.order == 1);
    assert_int_equal(
        text(&orr_dialect_nmea, &s, "$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*48", &m),
        ORR_DIALECT_WRONG);
    assert_int_equal(text(&orr_dialect_nmea, &s, "hello", &m), ORR_DIALECT_WRONG);
}

static void frames(void **state)
{
    (void)state;
    uint8_t b[400];
    orr_wire_writer w = {b, 0, sizeof b, ORR_WIRE_OK};
    orr_dialect_state s = {.begin = BEGIN};
    orr_msg_motion m = {.t = 5, .order = 1, .pos_m = {1, 2, 3}}, got;
    size_t start, n_reply;
    orr_frame_begin(&w, ORR_MSG_TYPE_MOTION, 7, &start);
    orr_msg_motion_encode(&m, &w);
    orr_frame_end(&w, start);
    assert_int_equal(take(&orr_dialect_frames, &s, b, w.size, &got, &n_reply), ORR_DIALECT_SAMPLE);
    assert_true(got.t == 5 && got.pos_m[2] == 3);
    b[30] ^= 1;
    assert_int_equal(take(&orr_dialect_frames, &s, b, w.size, &got, &n_reply), ORR_DIALECT_WRONG);
    assert_null(orr_dialect_of("klingon"));
    assert_ptr_equal(orr_dialect_of("nmea"), &orr_dialect_nmea);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(skydel_places), cmocka_unit_test(skydel_turns), cmocka_unit_test(lines),
        cmocka_unit_test(nmea),          cmocka_unit_test(frames),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
