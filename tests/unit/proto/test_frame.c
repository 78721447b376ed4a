// SPDX-License-Identifier: GPL-3.0-or-later
#include "proto/frame.h"

#include "proto/crc32.h"
#include "proto/gen/messages.h"
#include "testing.h"

static size_t make_ping(uint8_t *buf, size_t capacity)
{
    orr_wire_writer w = {buf, 0, capacity, ORR_WIRE_OK};
    size_t start;
    orr_frame_begin(&w, ORR_MSG_TYPE_PING, 77, &start);
    orr_msg_ping ping = {42};
    orr_msg_ping_encode(&ping, &w);
    orr_frame_end(&w, start);
    return w.status == ORR_WIRE_OK ? w.size : 0;
}

static void layout(void **state)
{
    (void)state;
    uint8_t b[64];
    size_t n = make_ping(b, sizeof b);
    assert_int_equal(n, ORR_FRAME_OVERHEAD + 8);
    assert_memory_equal(b, "ORRY", 4);
    assert_int_equal(b[4], 1);             // major
    assert_int_equal(b[5], 0);             // minor
    assert_int_equal(b[6] | b[7] << 8, 3); // PING
    assert_int_equal(b[8], 77);            // sequence
    assert_int_equal(b[12], 8);            // payload
    assert_int_equal(orr_wire_load_u32(b + n - 4), orr_crc32(0, b, n - 4));
}

static void parse_what_was_made(void **state)
{
    (void)state;
    uint8_t b[64];
    size_t n = make_ping(b, sizeof b), used;
    orr_frame f;
    assert_int_equal(orr_frame_parse(b, n, 100, &f, &used), ORR_WIRE_OK);
    assert_int_equal(used, n);
    assert_int_equal(f.type, ORR_MSG_TYPE_PING);
    assert_int_equal(f.sequence, 77);
    assert_int_equal(f.size, 8);
    assert_ptr_equal(f.payload, b + 16);
    // more bytes behind it are another frame's
    assert_int_equal(orr_frame_parse(b, sizeof b, 100, &f, &used), ORR_WIRE_OK);
    assert_int_equal(used, n);
}

static void every_prefix_wants_more(void **state)
{
    (void)state;
    uint8_t b[64];
    size_t n = make_ping(b, sizeof b), used;
    orr_frame f;
    for (size_t k = 0; k < n; k++) {
        assert_int_equal(orr_frame_parse(b, k, 100, &f, &used), ORR_WIRE_MORE);
        assert_int_equal(used, k < ORR_FRAME_HEADER ? ORR_FRAME_OVERHEAD : n);
    }
}

static void every_flipped_bit_is_noticed(void **state)
{
    (void)state;
    uint8_t b[64];
    size_t n = make_ping(b, sizeof b), used;
    orr_frame f;
    for (size_t bit = 0; bit < 8 * n; bit++) {
        b[bit / 8] ^= (uint8_t)(1u << bit % 8);
        orr_wire_status s = orr_frame_parse(b, n, 100, &f, &used);
        size_t byte = bit / 8;
        if (byte < 4)
            assert_int_equal(s, ORR_WIRE_MAGIC);
        else if (byte == 4)
            assert_int_equal(s, ORR_WIRE_VERSION);
        else if (byte >= 12 &&
                 byte < 16) // a longer length waits for more or is refused; a shorter one breaks the checksum
            assert_true(s == ORR_WIRE_MORE || s == ORR_WIRE_LENGTH || s == ORR_WIRE_CRC);
        else
            assert_int_equal(s, ORR_WIRE_CRC);
        b[bit / 8] ^= (uint8_t)(1u << bit % 8);
    }
}

static void header_alone_tells(void **state)
{
    (void)state;
    uint8_t b[64];
    orr_frame f;
    size_t used;
    make_ping(b, sizeof b);
    assert_int_equal(orr_frame_parse((const uint8_t *)"G", 1, 100, &f, &used),
                     ORR_WIRE_MAGIC); // "GET / HTTP/1.1"
    orr_wire_store_u32(b + 12, 101);
    assert_int_equal(orr_frame_parse(b, 16, 100, &f, &used), ORR_WIRE_LENGTH);
    assert_int_equal(f.sequence, 77);
    orr_wire_store_u32(b + 12, UINT32_MAX);
    assert_int_equal(orr_frame_parse(b, 16, 100, &f, &used), ORR_WIRE_LENGTH);
    b[4] = 9;
    assert_int_equal(orr_frame_parse(b, 16, 100, &f, &used), ORR_WIRE_VERSION);
    assert_int_equal(f.major, 9);
}

static void no_room_is_no_frame(void **state)
{
    (void)state;
    uint8_t b[64];
    for (size_t capacity = 0; capacity < ORR_FRAME_OVERHEAD + 8; capacity++) {
        memset(b, 0xaa, sizeof b);
        assert_int_equal(make_ping(b, capacity), 0);
        assert_int_equal(b[capacity], 0xaa); // nothing is written behind the end
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(layout),
        cmocka_unit_test(parse_what_was_made),
        cmocka_unit_test(every_prefix_wants_more),
        cmocka_unit_test(every_flipped_bit_is_noticed),
        cmocka_unit_test(header_alone_tells),
        cmocka_unit_test(no_room_is_no_frame),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
