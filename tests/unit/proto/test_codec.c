// SPDX-License-Identifier: GPL-3.0-or-later
// The generated codec against frames that are written down (docs/protocol.md) and against bytes that are no
// messages.
#include "proto/frame.h"
#include "proto/gen/messages.h"
#include "testing.h"
#include "tests/golden/proto/frames.h"

static orr_frame open_frame(const uint8_t *data, size_t n, uint16_t type, uint32_t sequence)
{
    orr_frame f;
    size_t used;
    assert_int_equal(orr_frame_parse(data, n, ORR_MSG_MAX_PAYLOAD, &f, &used), ORR_WIRE_OK);
    assert_int_equal(used, n);
    assert_int_equal(f.type, type);
    assert_int_equal(f.sequence, sequence);
    return f;
}

#define GOLDEN(name, type, sequence) open_frame(frame_##name, sizeof frame_##name, type, sequence)

// Frames what was put between begin and end and compares it with the golden bytes.
#define ASSERT_FRAME(name, type, sequence, encode, message)                                                  \
    do {                                                                                                     \
        uint8_t buf_[1024];                                                                                  \
        orr_wire_writer w_ = {buf_, 0, sizeof buf_, ORR_WIRE_OK};                                            \
        size_t start_;                                                                                       \
        orr_frame_begin(&w_, type, sequence, &start_);                                                       \
        assert_int_equal(encode(message, &w_), ORR_WIRE_OK);                                                 \
        orr_frame_end(&w_, start_);                                                                          \
        assert_int_equal(w_.size, sizeof frame_##name);                                                      \
        assert_memory_equal(buf_, frame_##name, sizeof frame_##name);                                        \
    } while (0)

static void golden_ping(void **state)
{
    (void)state;
    orr_msg_ping m = {UINT64_C(0x0123456789abcdef)}, d;
    ASSERT_FRAME(ping, 3, 1, orr_msg_ping_encode, &m);
    orr_frame f = GOLDEN(ping, 3, 1);
    assert_int_equal(orr_msg_ping_decode(f.payload, f.size, &d), ORR_WIRE_OK);
    assert_true(d.token == m.token);
}

static void golden_hello(void **state)
{
    (void)state;
    orr_msg_hello m = {1, 1, orr_wire_text("gen"), orr_wire_text("2.1")}, d;
    ASSERT_FRAME(hello, 1, 1, orr_msg_hello_encode, &m);
    orr_frame f = GOLDEN(hello, 1, 1);
    assert_int_equal(orr_msg_hello_decode(f.payload, f.size, &d), ORR_WIRE_OK);
    char text[8];
    assert_string_equal(orr_wire_text_copy(d.name, text, sizeof text), "gen");
    assert_string_equal(orr_wire_text_copy(d.version, text, sizeof text), "2.1");
    assert_string_equal(orr_wire_text_copy(d.version, text, 3), "2.");
    assert_int_equal(d.major_min, 1);
    assert_int_equal(d.major_max, 1);
}

static void golden_poll(void **state)
{
    (void)state;
    const orr_msg_sat_id sats[2] = {{'G', 5}, {'E', 11}};
    orr_msg_poll m = {{INT64_C(1391040900000000000), 100000000, 2}, {2, sats, {NULL, 0, 0}}}, d;
    ASSERT_FRAME(poll, 6, 2, orr_msg_poll_encode, &m);
    orr_frame f = GOLDEN(poll, 6, 2);
    assert_int_equal(orr_msg_poll_decode(f.payload, f.size, &d), ORR_WIRE_OK);
    assert_true(d.epochs.t == m.epochs.t && d.epochs.step == m.epochs.step && d.epochs.count == 2 &&
                d.satellites.count == 2);
    orr_msg_sat_id s;
    orr_wire_iter it = {0, 0};
    assert_true(orr_msg_sat_id_next(&d.satellites, &it, &s) && s.system == 'G' && s.number == 5);
    assert_true(orr_msg_sat_id_next(&d.satellites, &it, &s) && s.system == 'E' && s.number == 11);
    assert_false(orr_msg_sat_id_next(&d.satellites, &it, &s));
    assert_false(orr_msg_sat_id_at(&d.satellites, 2, &s));
    ASSERT_FRAME(poll, 6, 2, orr_msg_poll_encode, &d); // what was decoded can be sent on as it is
}

static void golden_states(void **state)
{
    (void)state;
    const int64_t none = INT64_MIN;
    const double nan_ = -(double)NAN; // any NAN goes out as the same bits
    const orr_msg_sat_state sats[2] = {
        {{'G', 5},
         ORR_MSG_ANSWER_OK,
         0,
         ORR_MSG_STATE_FLAGS_CLOCK_VALID,
         {15600000.25, -20100000.5, 7250000.125},
         {1500.5, 250.25, -2750.125},
         {-0.25, 0.5, -0.125},
         -0.0001220703125,
         0x1p-37,
         INT64_C(1391040000000000000),
         INT64_C(1391126400000000000),
         0.0078125f,
         0x1p-33f},
        {{'E', 11},
         ORR_MSG_ANSWER_NO_ARC,
         0,
         0,
         {nan_, nan_, nan_},
         {nan_, nan_, nan_},
         {nan_, nan_, nan_},
         nan_,
         nan_,
         none,
         none,
         (float)nan_,
         (float)nan_},
    };
    orr_msg_states m = {{INT64_C(1391040900000000000), 0, 2, ORR_MSG_ANSWER_OK}, {2, sats, {NULL, 0, 0}}}, d;
    ASSERT_FRAME(states, 7, 2, orr_msg_states_encode, &m);
    orr_frame f = GOLDEN(states, 7, 2);
    assert_int_equal(orr_msg_states_decode(f.payload, f.size, &d), ORR_WIRE_OK);
    assert_true(d.epoch.t == m.epoch.t && d.epoch.index == 0 && d.epoch.count == 2 &&
                d.epoch.answer == ORR_MSG_ANSWER_OK);
    orr_msg_sat_state s;
    assert_true(orr_msg_sat_state_at(&d.satellites, 0, &s));
    assert_memory_equal(&s.sat, &sats[0].sat, sizeof s.sat);
    assert_true(s.answer == 0 && s.flags == 1 && s.pos_m[1] == -20100000.5 && s.vel_mps[2] == -2750.125);
    assert_true(s.acc_mps2[0] == -0.25 && s.clock_s == -0.0001220703125 && s.clock_rate_sps == 0x1p-37);
    assert_true(s.valid_from == sats[0].valid_from && s.valid_to == sats[0].valid_to &&
                s.sigma_m == 0.0078125f && s.clock_sigma_s == 0x1p-33f);
    assert_true(orr_msg_sat_state_at(&d.satellites, 1, &s));
    assert_true(s.answer == ORR_MSG_ANSWER_NO_ARC && isnan(s.pos_m[0]) && isnan(s.sigma_m) &&
                isnan(s.clock_sigma_s) && s.valid_to == none);
}

static void golden_error(void **state)
{
    (void)state;
    orr_msg_error m = {ORR_MSG_ERROR_CODE_UNKNOWN_TYPE, 999, orr_wire_text("unknown message type 999")}, d;
    ASSERT_FRAME(error, 5, 3, orr_msg_error_encode, &m);
    orr_frame f = GOLDEN(error, 5, 3);
    assert_int_equal(orr_msg_error_decode(f.payload, f.size, &d), ORR_WIRE_OK);
    assert_true(d.code == 5 && d.request == 999 && d.sentence.size == 24);
}

static void golden_elements(void **state)
{
    (void)state;
    const orr_msg_sat_id r07 = {'R', 7};
    orr_msg_poll_elements p = {{INT64_C(1391040900000000000), 0, 1},
                               ORR_MSG_ELEMENTS_FRAME_J2000,
                               ORR_MSG_ELEMENTS_METHOD_MEAN,
                               {1, &r07, {NULL, 0, 0}}},
                          q;
    ASSERT_FRAME(poll_elements, 8, 4, orr_msg_poll_elements_encode, &p);
    orr_frame f = GOLDEN(poll_elements, 8, 4);
    assert_int_equal(orr_msg_poll_elements_decode(f.payload, f.size, &q), ORR_WIRE_OK);
    assert_true(q.epochs.t == p.epochs.t && q.epochs.count == 1 && q.frame == 1 && q.method == 2 &&
                q.satellites.count == 1);
    const double none = (double)NAN;
    const orr_msg_sat_elements sats[2] = {
        {{'R', 7}, ORR_MSG_ANSWER_OK, 0, 17, 25508000.5, 0x1p-10, 1.125, 0.5, 6.25, 3.5, 3.46875},
        {{'E', 11}, ORR_MSG_ANSWER_NO_VALUE, 0, 0, none, none, none, none, none, none, none}};
    orr_msg_elements m = {{p.epochs.t, 0, 1, ORR_MSG_ANSWER_OK}, 1, 2, {2, sats, {NULL, 0, 0}}}, d;
    ASSERT_FRAME(elements, 9, 4, orr_msg_elements_encode, &m);
    f = GOLDEN(elements, 9, 4);
    assert_int_equal(orr_msg_elements_decode(f.payload, f.size, &d), ORR_WIRE_OK);
    orr_msg_sat_elements s;
    assert_true(orr_msg_sat_elements_at(&d.satellites, 0, &s));
    assert_true(s.flags == 17 && s.a_m == 25508000.5 && s.e == 0x1p-10 && s.i_rad == 1.125);
    assert_true(s.raan_rad == 0.5 && s.argp_rad == 6.25 && s.m_rad == 3.5 && s.u_rad == 3.46875);
    assert_true(orr_msg_sat_elements_at(&d.satellites, 1, &s));
    assert_true(s.answer == ORR_MSG_ANSWER_NO_VALUE && isnan(s.a_m) && isnan(s.u_rad));
}

// Lists of variable and of fixed records within records of variable size, blobs, and lists of none.
static void golden_navdata(void **state)
{
    (void)state;
    static const uint8_t bits[11] = {0x08, 0xbb, 0xb8, 0xc8, 0x57, 0x80, 0x0e, 0xd3, 0x3e, 0xc0, 0xa8};
    const int64_t none = INT64_MIN, t = INT64_C(1391040900000000000), s_ns = 1000000000;
    const double nan_ = (double)NAN;
    const orr_msg_nav_page page = {t - 12 * s_ns, 17 * s_ns / 10, 1, 2, 85, {bits, sizeof bits}};
    const orr_msg_glonass_set g = {.pos_m = {15180980.46875, -15362846.6796875, 13572087.890625},
                                   .vel_mps = {1565.1702880859375, -1001.896858215332, -2898.8704681396484},
                                   .acc_mps2 = {0, -1e3 * 0x1p-30, -4e3 * 0x1p-30},
                                   .delta_tau_s = 0x1p-29,
                                   .channel = 5};
    const orr_msg_sat_navdata sats[2] = {{.sat = {'R', 7},
                                          .message = ORR_MSG_NAV_MESSAGE_FDMA,
                                          .signals = {(const uint8_t *)"L1OF L2OF", 9},
                                          .notes = ORR_MSG_NAV_NOTES_NOMINAL_CHANNEL,
                                          .set_from = t - 882 * s_ns,
                                          .set_to = t + 918 * s_ns,
                                          .toe = t + 18 * s_ns,
                                          .toc = t + 18 * s_ns,
                                          .week = -1,
                                          .iode = -1,
                                          .iodc = -1,
                                          .accuracy_m = nan_,
                                          .fit_rms_m = 0.25,
                                          .fit_max_m = 0.5,
                                          .clock_rms_s = 0x1p-32,
                                          .af0_s = -0x1p-30,
                                          .frame_from = t - 12 * s_ns,
                                          .frame_to = t + 18 * s_ns,
                                          .glonass = {1, &g, {NULL, 0, 0}},
                                          .pages = {1, &page, {NULL, 0, 0}}},
                                         {.sat = {'E', 11},
                                          .answer = ORR_MSG_ANSWER_NOT_SERVED,
                                          .set_from = none,
                                          .set_to = none,
                                          .toe = none,
                                          .toc = none,
                                          .week = -1,
                                          .iode = -1,
                                          .iodc = -1,
                                          .accuracy_m = nan_,
                                          .fit_rms_m = nan_,
                                          .fit_max_m = nan_,
                                          .clock_rms_s = nan_,
                                          .af0_s = nan_,
                                          .af1_sps = nan_,
                                          .af2_sps2 = nan_,
                                          .frame_from = none,
                                          .frame_to = none}};
    orr_msg_navdata m = {{t, 0, 1, ORR_MSG_ANSWER_OK}, {2, sats, {NULL, 0, 0}}}, d;
    ASSERT_FRAME(navdata, 11, 5, orr_msg_navdata_encode, &m);
    orr_frame f = GOLDEN(navdata, 11, 5);
    assert_int_equal(orr_msg_navdata_decode(f.payload, f.size, &d), ORR_WIRE_OK);
    ASSERT_FRAME(navdata, 11, 5, orr_msg_navdata_encode, &d); // what was decoded can be sent on as it is
    orr_msg_sat_navdata s;
    orr_msg_glonass_set glonass;
    orr_msg_kepler_set lnav;
    orr_msg_nav_page p;
    orr_wire_iter it = {0, 0}, in = {0, 0};
    assert_true(orr_msg_sat_navdata_next(&d.satellites, &it, &s));
    assert_true(s.message == 10 && s.notes == 32 && s.toe == t + 18 * s_ns && s.week == -1 && s.iodc == -1);
    assert_true(isnan(s.accuracy_m) && s.fit_max_m == 0.5 && s.af0_s == -0x1p-30 && s.frame_to == s.toe);
    assert_true(s.kepler.count == 0 && !orr_msg_kepler_set_at(&s.kepler, 0, &lnav));
    assert_true(orr_msg_glonass_set_at(&s.glonass, 0, &glonass));
    assert_true(glonass.pos_m[1] == g.pos_m[1] && glonass.acc_mps2[2] == g.acc_mps2[2]);
    assert_true(glonass.delta_tau_s == 0x1p-29 && glonass.channel == 5);
    assert_true(orr_msg_nav_page_next(&s.pages, &in, &p) && p.t == page.t && p.number == 1 && p.bits == 85);
    assert_int_equal(p.data.size, sizeof bits);
    assert_memory_equal(p.data.data, bits, sizeof bits);
    assert_false(orr_msg_nav_page_next(&s.pages, &in, &p));
    assert_true(orr_msg_sat_navdata_next(&d.satellites, &it, &s));
    assert_true(s.answer == ORR_MSG_ANSWER_NOT_SERVED && s.toe == none && isnan(s.af0_s) &&
                s.pages.count == 0);
    assert_false(orr_msg_sat_navdata_next(&d.satellites, &it, &s));
    for (uint32_t n = 0; n < f.size; n++)
        assert_int_equal(orr_msg_navdata_decode(f.payload, n, &d), ORR_WIRE_SHORT);
}

static void caps_round_trip(void **state)
{
    (void)state;
    const orr_msg_served_request types[3] = {{1, 2, {INT64_MIN, INT64_MIN}}, {3, 4, {0, 0}}, {6, 7, {-4, 5}}};
    const orr_msg_inertial_unit units[2] = {{.unit = 0},
                                            {1, orr_wire_text("second"), {0.5, -2, 1.25}, 1, 2, 3}};
    const orr_msg_sat_id sats[2] = {{'R', 1}, {'J', 7}};
    orr_msg_caps m = {.major = 1,
                      .max_request = 2,
                      .max_epochs = 3,
                      .span = {-4, 5},
                      .name = orr_wire_text("orrery"),
                      .version = orr_wire_text("0.1.0"),
                      .title = orr_wire_text("t"),
                      .frame = orr_wire_text("IGS20"),
                      .leap = {18, 17, 4},
                      .navdata_point = ORR_MSG_ORBIT_POINT_PHASE_CENTRE,
                      .receiver_source = ORR_MSG_RECEIVER_SOURCE_TRAJECTORY,
                      .receiver_unit = 1,
                      .receiver_m = {1, 2, 3},
                      .imu_rate_hz = 100,
                      .units = {2, units, {NULL, 0, 0}},
                      .requests = {3, types, {NULL, 0, 0}},
                      .satellites = {2, sats, {NULL, 0, 0}}},
                 d;
    uint8_t buf[400];
    orr_wire_writer w = {buf, 0, sizeof buf, ORR_WIRE_OK};
    assert_int_equal(orr_msg_caps_encode(&m, &w), ORR_WIRE_OK);
    assert_int_equal(orr_msg_caps_decode(buf, w.size, &d), ORR_WIRE_OK);
    assert_true(d.major == 1 && d.minor == 0 && d.max_request == 2 && d.max_epochs == 3);
    assert_true(d.span.first == -4 && d.span.last == 5 && d.requests.count == 3 && d.satellites.count == 2);
    assert_true(d.frame.size == 5 && memcmp(d.frame.data, "IGS20", 5) == 0);
    orr_msg_served_request r;
    assert_true(orr_msg_served_request_at(&d.requests, 2, &r) && r.request == 6 && r.answer == 7);
    assert_true(r.span.first == -4 && r.span.last == 5);
    assert_true(d.leap.gps_utc_s == 18 && d.leap.next_gps_utc_s == 17 && d.leap.next == 4);
    assert_true(d.navdata_point == 2 && d.receiver_source == 2 && d.receiver_unit == 1);
    assert_true(d.receiver_m[2] == 3 && d.imu_rate_hz == 100 && d.units.count == 2);
    orr_msg_inertial_unit u;
    orr_wire_iter it = {0};
    assert_true(orr_msg_inertial_unit_next(&d.units, &it, &u) && u.unit == 0 && u.name.size == 0);
    assert_true(orr_msg_inertial_unit_next(&d.units, &it, &u) && u.unit == 1 && u.name.size == 6);
    assert_true(u.lever_m[1] == -2 && u.heading_rad == 1 && u.pitch_rad == 2 && u.roll_rad == 3);
    // every strict prefix is too short; a byte more is of a later version
    for (size_t n = 0; n < w.size; n++) assert_int_equal(orr_msg_caps_decode(buf, n, &d), ORR_WIRE_SHORT);
    buf[w.size] = 0xff;
    assert_int_equal(orr_msg_caps_decode(buf, w.size + 1, &d), ORR_WIRE_OK);
    // and a buffer that is too small is told, at every size
    size_t whole = w.size;
    for (size_t n = 0; n < whole; n++) {
        orr_wire_writer small = {buf, 0, n, ORR_WIRE_OK};
        assert_int_equal(orr_msg_caps_encode(&m, &small), ORR_WIRE_SPACE);
    }
}

static void prefixes_are_short(void **state)
{
    (void)state;
    orr_msg_states s;
    orr_msg_poll p;
    orr_frame f = GOLDEN(states, 7, 2);
    for (uint32_t n = 0; n < f.size; n++)
        assert_int_equal(orr_msg_states_decode(f.payload, n, &s), ORR_WIRE_SHORT);
    f = GOLDEN(poll, 6, 2);
    for (uint32_t n = 0; n < f.size; n++)
        assert_int_equal(orr_msg_poll_decode(f.payload, n, &p), ORR_WIRE_SHORT);
}

static void limits(void **state)
{
    (void)state;
    uint8_t b[64] = {0};
    orr_msg_poll p;
    orr_wire_store_u16(b + 20, ORR_MSG_MAX_SATELLITES + 1); // count of satellites
    orr_wire_store_u16(b + 22, 2);
    assert_int_equal(orr_msg_poll_decode(b, sizeof b, &p), ORR_WIRE_LIMIT);
    orr_wire_store_u16(b + 20, 3);
    orr_wire_store_u16(b + 22, 1); // records of one byte
    assert_int_equal(orr_msg_poll_decode(b, sizeof b, &p), ORR_WIRE_SHORT);
    orr_wire_store_u16(b + 22, 5); // records of a later version, three bytes longer
    b[24] = 'G', b[25] = 1, b[29] = 'R', b[30] = 2;
    assert_int_equal(orr_msg_poll_decode(b, sizeof b, &p), ORR_WIRE_OK);
    orr_msg_sat_id s;
    assert_true(orr_msg_sat_id_at(&p.satellites, 1, &s) && s.system == 'R' && s.number == 2);
    orr_msg_sat_id many[ORR_MSG_MAX_SATELLITES + 1];
    memset(many, 0, sizeof many);
    static uint8_t big[4096];
    orr_wire_writer w = {big, 0, sizeof big, ORR_WIRE_OK};
    orr_msg_poll q = {{0, 0, 1}, {ORR_MSG_MAX_SATELLITES + 1, many, {NULL, 0, 0}}};
    assert_int_equal(orr_msg_poll_encode(&q, &w), ORR_WIRE_LIMIT);
    char text[70];
    memset(text, 'x', sizeof text - 1);
    text[sizeof text - 1] = '\0';
    orr_msg_hello h = {1, 1, orr_wire_text(text), orr_wire_text("")};
    orr_wire_writer v = {big, 0, sizeof big, ORR_WIRE_OK};
    assert_int_equal(orr_msg_hello_encode(&h, &v), ORR_WIRE_LIMIT);
}

// A small generator with a seed: the same bytes in every run.
static uint32_t next_random(uint32_t *x)
{
    *x = *x * 1664525u + 1013904223u;
    return *x >> 8;
}

// What decodes, encodes; and what was encoded decodes to the same bytes again.
#define STABLE(name)                                                                                         \
    do {                                                                                                     \
        orr_msg_##name m_;                                                                                   \
        if (orr_msg_##name##_decode(b, n, &m_) == ORR_WIRE_OK) {                                             \
            uint8_t one_[600], two_[600];                                                                    \
            orr_wire_writer w1_ = {one_, 0, sizeof one_, ORR_WIRE_OK},                                       \
                            w2_ = {two_, 0, sizeof two_, ORR_WIRE_OK};                                       \
            assert_int_equal(orr_msg_##name##_encode(&m_, &w1_), ORR_WIRE_OK);                               \
            assert_true(w1_.size <= n);                                                                      \
            assert_int_equal(orr_msg_##name##_decode(one_, w1_.size, &m_), ORR_WIRE_OK);                     \
            assert_int_equal(orr_msg_##name##_encode(&m_, &w2_), ORR_WIRE_OK);                               \
            assert_int_equal(w1_.size, w2_.size);                                                            \
            assert_memory_equal(one_, two_, w1_.size);                                                       \
            decoded++;                                                                                       \
        }                                                                                                    \
    } while (0)

static void random_bytes(void **state)
{
    (void)state;
    uint32_t x = 20240204;
    int decoded = 0;
    for (int k = 0; k < 20000; k++) {
        uint8_t b[512];
        size_t n = next_random(&x) % sizeof b;
        unsigned sparse = next_random(&x) % 8; // mostly zeros: small counts and lengths, which go deeper
        for (size_t i = 0; i < n; i++) b[i] = next_random(&x) % 8 < sparse ? 0 : (uint8_t)next_random(&x);
#define ONE(name) STABLE(name);
        ORR_MSG_EACH(ONE)
    }
    assert_true(decoded > 1000);
}

static void names(void **state)
{
    (void)state;
    assert_string_equal(orr_msg_type_name(ORR_MSG_TYPE_STATES), "STATES");
    assert_null(orr_msg_type_name(999));
    assert_string_equal(orr_msg_answer_name(ORR_MSG_ANSWER_NO_ARC), "NO_ARC");
    assert_string_equal(orr_msg_state_flags_name(4), "ECLIPSE");
    assert_null(orr_msg_state_flags_name(31));
    assert_true(orr_msg_error_code_closes(ORR_MSG_ERROR_CODE_BAD_CRC));
    assert_false(orr_msg_error_code_closes(ORR_MSG_ERROR_CODE_UNKNOWN_TYPE));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(golden_ping),        cmocka_unit_test(golden_hello),
        cmocka_unit_test(golden_poll),        cmocka_unit_test(golden_states),
        cmocka_unit_test(golden_error),       cmocka_unit_test(golden_elements),
        cmocka_unit_test(golden_navdata),     cmocka_unit_test(caps_round_trip),
        cmocka_unit_test(prefixes_are_short), cmocka_unit_test(limits),
        cmocka_unit_test(random_bytes),       cmocka_unit_test(names),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
