// SPDX-License-Identifier: GPL-3.0-or-later
// Every feature of the type system, by a message set of its own (toy.yaml): what later messages will be made
// of.
#include "toy.h"

#include "testing.h"

static const double runs[2] = {1.5, -2.25};
static const orr_toy_point points[1] = {{-7, 0.5f}};
static const uint16_t run[3] = {1, 2, 65535};
static const orr_toy_grown grown[2] = {{1, 2, {3.0, 4.0}}, {5, 6, {7.0, 8.0}}};

static orr_toy_everything sample(orr_toy_loose loose[2])
{
    loose[0] =
        (orr_toy_loose){ORR_TOY_COLOUR_BLUE,     orr_wire_text("ab"),       {(const uint8_t *)"\0\1\2", 3},
                        {2, runs, {NULL, 0, 0}}, {1, points, {NULL, 0, 0}}, 9};
    loose[1] = (orr_toy_loose){
        99, orr_wire_text(""), {NULL, 0}, {0, NULL, {NULL, 0, 0}}, {0, NULL, {NULL, 0, 0}}, 8};
    return (orr_toy_everything){.v_u8 = 255,
                                .v_i8 = -128,
                                .v_u16 = 65535,
                                .v_i16 = -32768,
                                .v_u32 = UINT32_MAX,
                                .v_i32 = INT32_MIN,
                                .v_u64 = UINT64_MAX,
                                .v_i64 = INT64_MIN,
                                .v_f32 = -0.0f,
                                .v_f64 = 0x1p-1074,
                                .when_ns = -1,
                                .matrix = {1, 2, 3, 4},
                                .corner = {-2, 3.5f},
                                .parts = ORR_TOY_PARTS_NOTE | ORR_TOY_PARTS_PLACE | ORR_TOY_PARTS_RUN,
                                .note = orr_wire_text("note"),
                                .place = {4, 5.5f},
                                .run = {3, run, {NULL, 0, 0}},
                                .grown = {2, grown, {NULL, 0, 0}},
                                .loose = {2, loose, {NULL, 0, 0}},
                                .memo = {6, orr_wire_text("memo")},
                                .tail = 123,
                                .tail_text = orr_wire_text("end")};
}

static size_t encoded(const orr_toy_everything *m, uint8_t *buf, size_t n)
{
    orr_wire_writer w = {buf, 0, n, ORR_WIRE_OK};
    assert_int_equal(orr_toy_everything_encode(m, &w), ORR_WIRE_OK);
    return w.size;
}

static void every_field_survives(void **state)
{
    (void)state;
    uint8_t b[1024], again[1024];
    orr_toy_loose loose[2], l;
    orr_toy_everything m = sample(loose), d;
    size_t n = encoded(&m, b, sizeof b);
    assert_int_equal(orr_toy_everything_decode(b, n, &d), ORR_WIRE_OK);
    assert_true(d.v_u8 == 255 && d.v_i8 == -128 && d.v_u16 == 65535 && d.v_i16 == -32768 &&
                d.v_u32 == UINT32_MAX);
    assert_true(d.v_i32 == INT32_MIN && d.v_u64 == UINT64_MAX && d.v_i64 == INT64_MIN && d.when_ns == -1);
    assert_true(d.v_f32 == 0 && signbit(d.v_f32) && d.v_f64 == 0x1p-1074 && d.matrix[0] == 1 &&
                d.matrix[3] == 4);
    assert_true(d.corner.x == -2 && d.corner.y == 3.5f && d.place.x == 4 && d.place.y == 5.5f);
    assert_true(d.note.size == 4 && memcmp(d.note.data, "note", 4) == 0 && d.tail == 123 &&
                d.tail_text.size == 3);
    assert_true(d.memo.size == 6 && d.memo.text.size == 4);
    uint16_t u;
    assert_true(d.run.count == 3 && orr_toy_u16_at(&d.run, 2, &u) && u == 65535);
    orr_toy_grown g;
    assert_true(d.grown.count == 2 && orr_toy_grown_at(&d.grown, 1, &g) && g.a == 5 && g.b == 6 &&
                g.c[1] == 8.0);
    orr_wire_iter it = {0, 0};
    assert_true(orr_toy_loose_next(&d.loose, &it, &l));
    assert_true(l.kind == 7 && l.label.size == 2 && l.raw.size == 3 && l.raw.data[2] == 2 && l.late == 9);
    double v;
    assert_true(l.runs.count == 2 && orr_toy_f64_at(&l.runs, 1, &v) && v == -2.25);
    orr_toy_point p;
    assert_true(l.points.count == 1 && orr_toy_point_at(&l.points, 0, &p) && p.x == -7 && p.y == 0.5f);
    assert_true(orr_toy_loose_next(&d.loose, &it, &l) && l.kind == 99 && l.late == 8 && l.runs.count == 0);
    assert_false(orr_toy_loose_next(&d.loose, &it, &l));
    assert_int_equal(encoded(&d, again, sizeof again), n); // decoded lists are sent on as they came
    assert_memory_equal(b, again, n);
    assert_true(n <= ORR_TOY_EVERYTHING_LARGEST);
}

static void optional_fields_cost_nothing(void **state)
{
    (void)state;
    uint8_t b[1024] = {0};
    orr_toy_loose loose[2];
    orr_toy_everything m = sample(loose), d;
    size_t all = encoded(&m, b, sizeof b);
    m.parts = ORR_TOY_PARTS_PLACE;
    size_t n = encoded(&m, b, sizeof b);
    assert_int_equal(all - n, (2 + 4) + (4 + 3 * 2)); // without the note and the run
    assert_int_equal(orr_toy_everything_decode(b, n, &d), ORR_WIRE_OK);
    assert_true(d.note.size == 0 && d.run.count == 0 && d.place.x == 4);
}

static void older_senders(void **state)
{
    (void)state;
    uint8_t b[1024] = {0};
    orr_toy_loose loose[2];
    orr_toy_everything m = sample(loose), d;
    size_t n = encoded(&m, b, sizeof b);
    assert_int_equal(orr_toy_everything_decode(b, n - 5, &d), ORR_WIRE_OK); // minor 1: no tail_text
    assert_true(d.tail == 123 && d.tail_text.size == 0);
    assert_int_equal(orr_toy_everything_decode(b, n - 9, &d), ORR_WIRE_OK); // minor 0: no tail
    assert_true(d.tail == 0 && d.memo.text.size == 4);
    for (size_t k = 0; k < n; k++)
        if (k != n - 5 && k != n - 9) assert_int_equal(orr_toy_everything_decode(b, k, &d), ORR_WIRE_SHORT);
    // Records of minor 1 (6 bytes) and of minor 0 (2 bytes): what they lack is zero. 4 bytes cut a field in
    // two.
    orr_toy_grown g;
    orr_toy_grown_list list = {2, NULL, {b, 12, 6}};
    orr_wire_store_u16(b + 6, 11);
    orr_wire_store_u32(b + 8, 12);
    m.grown = list;
    uint8_t c[1024];
    n = encoded(&m, c, sizeof c);
    assert_int_equal(orr_toy_everything_decode(c, n, &d), ORR_WIRE_OK);
    assert_true(orr_toy_grown_at(&d.grown, 1, &g) && g.a == 11 && g.b == 12 && g.c[0] == 0 && g.c[1] == 0);
    m.grown.wire.stride = 4, m.grown.wire.size = 8;
    n = encoded(&m, c, sizeof c);
    assert_int_equal(orr_toy_everything_decode(c, n, &d), ORR_WIRE_SHORT);
}

static void damage_is_found(void **state)
{
    (void)state;
    uint8_t b[1024] = {0}, c[1024];
    orr_toy_loose loose[2];
    orr_toy_everything m = sample(loose), d;
    size_t n = encoded(&m, b, sizeof b);
    uint32_t x = 7;
    size_t ok = 0, bad = 0;
    for (int k = 0; k < 20000; k++) {
        memcpy(c, b, n);
        for (int i = 0; i < 3; i++) {
            x = x * 1664525u + 1013904223u;
            c[(x >> 8) % n] = (uint8_t)(x >> 24);
        }
        if (orr_toy_everything_decode(c, n, &d) != ORR_WIRE_OK) {
            bad++;
            continue;
        }
        ok++;
        orr_toy_loose l;
        orr_wire_iter it = {0, 0};
        uint16_t seen = 0;
        while (orr_toy_loose_next(&d.loose, &it, &l)) seen++;
        assert_int_equal(seen, d.loose.count); // what has been accepted can be read to its end
        uint8_t e[1024];
        encoded(&d, e, sizeof e);
    }
    assert_true(ok > 100 && bad > 100);
}

static void a_list_without_records_is_a_bug_that_is_told(void **state)
{
    (void)state;
    uint8_t b[1024] = {0};
    orr_toy_loose loose[2];
    orr_toy_everything m = sample(loose);
    m.grown = (orr_toy_grown_list){2, NULL, {NULL, 0, 0}};
    orr_wire_writer w = {b, 0, sizeof b, ORR_WIRE_OK};
    assert_int_not_equal(orr_toy_everything_encode(&m, &w), ORR_WIRE_OK);
}

static void no_fields(void **state)
{
    (void)state;
    uint8_t b[4] = {0};
    orr_toy_nothing m;
    orr_wire_writer w = {b, 0, sizeof b, ORR_WIRE_OK};
    assert_int_equal(orr_toy_nothing_decode(b, 0, &m), ORR_WIRE_OK);
    assert_int_equal(orr_toy_nothing_encode(&m, &w), ORR_WIRE_OK);
    assert_int_equal(w.size, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_field_survives),
        cmocka_unit_test(optional_fields_cost_nothing),
        cmocka_unit_test(older_senders),
        cmocka_unit_test(damage_is_found),
        cmocka_unit_test(a_list_without_records_is_a_bug_that_is_told),
        cmocka_unit_test(no_fields),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
