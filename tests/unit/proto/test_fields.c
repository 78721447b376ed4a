// SPDX-License-Identifier: GPL-3.0-or-later
// Field descriptors: they read a message as the generated codec does.
#include "proto/fields.h"
#include "proto/frame.h"
#include "tests/golden/proto/frames.h"
#include "tests/testing.h"

#define EACH_FRAME(X) X(ping) X(hello) X(poll) X(states) X(error) X(poll_elements) X(elements) X(navdata)

// Every example frame comes out of a descriptor's codec as it went in.
static void frames_pass_through(void **state)
{
    (void)state;
    static const struct {
        const uint8_t *data;
        size_t n;
    } frames[] = {
#define FRAME(name) {frame_##name, sizeof frame_##name},
        EACH_FRAME(FRAME)
#undef FRAME
    };
    for (size_t i = 0; i < sizeof frames / sizeof frames[0]; i++) {
        orr_frame f;
        size_t used;
        assert_int_equal(orr_frame_parse(frames[i].data, frames[i].n, ORR_MSG_MAX_PAYLOAD, &f, &used),
                         ORR_WIRE_OK);
        const orr_message_info *info = orr_message_of(f.type);
        assert_non_null(info);
        assert_string_equal(info->name, orr_msg_type_name(f.type));
        orr_msg_any m;
        assert_true(info->record->size <= sizeof m);
        assert_int_equal(info->decode(f.payload, f.size, &m), ORR_WIRE_OK);
        uint8_t buf[1024];
        orr_wire_writer w = {buf, 0, sizeof buf, ORR_WIRE_OK};
        assert_int_equal(info->encode(&m, &w), ORR_WIRE_OK);
        assert_int_equal(w.size, f.size);
        assert_memory_equal(buf, f.payload, f.size);
    }
    assert_null(orr_message_of(0));
    assert_null(orr_message_of(999));
}

static void fields_read_what_is_there(void **state)
{
    (void)state;
    const orr_record *states = orr_message_of(ORR_MSG_TYPE_STATES)->record;
    const orr_field *list = orr_record_field(states, "satellites"), *f;
    assert_true(list != NULL && list->kind == ORR_FIELD_LIST && list->limit == ORR_MSG_MAX_SATELLITES);
    const orr_msg_sat_state sats[2] = {
        {.sat = {'G', 5}, .flags = 18, .vel_mps = {1, 2.5, 3}, .sigma_m = 0.25F},
        {.sat = {'E', 11}, .answer = ORR_MSG_ANSWER_NO_ARC, .valid_from = -7}};
    const orr_msg_sat_state_list two = {.count = 2, .item = sats};
    orr_msg_sat_state s;
    orr_wire_iter it = {0};
    assert_true(list->next(&two, &it, &s));
    const orr_record *r = list->record;
    assert_non_null(f = orr_record_field(r, "vel_mps"));
    assert_true(f->length == 3 && orr_field_number(f, (const char *)&s + f->offset, 1) == 2.5);
    assert_string_equal(f->unit, "m/s");
    assert_non_null(f = orr_record_field(r, "sigma_m"));
    assert_true(orr_field_number(f, (const char *)&s + f->offset, 0) == 0.25);
    assert_non_null(f = orr_record_field(r, "flags"));
    assert_true(f->show == ORR_SHOW_BITS && orr_field_bits(f, (const char *)&s + f->offset) == 18);
    for (size_t i = 0; i < f->n_words; i++)
        assert_string_equal(f->word[i].name, orr_msg_state_flags_name((unsigned)i));
    assert_true(list->next(&two, &it, &s));
    assert_non_null(f = orr_record_field(r, "valid_from"));
    assert_true(f->show == ORR_SHOW_TIME && orr_field_integer(f, (const char *)&s + f->offset) == -7);
    assert_non_null(f = orr_record_field(r, "answer"));
    assert_true(f->show == ORR_SHOW_ANSWER &&
                orr_field_integer(f, (const char *)&s + f->offset) == ORR_MSG_ANSWER_NO_ARC);
    assert_false(list->next(&two, &it, &s));
    assert_null(orr_record_field(r, "no_such_field"));
}

// Integers of every kind and sign.
static void integers(void **state)
{
    (void)state;
    const int8_t i8 = -8;
    const int16_t i16 = -16;
    const int32_t i32 = -32;
    const int64_t i64 = INT64_MIN;
    const uint8_t u8 = 200;
    const uint16_t u16 = 60000;
    const uint32_t u32 = UINT32_C(4000000000);
    const uint64_t u64 = UINT64_MAX;
    const struct {
        orr_field_kind kind;
        const void *at;
        double value;
    } all[] = {{ORR_FIELD_I8, &i8, -8},        {ORR_FIELD_I16, &i16, -16},   {ORR_FIELD_I32, &i32, -32},
               {ORR_FIELD_I64, &i64, -0x1p63}, {ORR_FIELD_U8, &u8, 200},     {ORR_FIELD_U16, &u16, 60000},
               {ORR_FIELD_U32, &u32, 4e9},     {ORR_FIELD_U64, &u64, 0x1p64}};
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        const orr_field f = {.name = "x", .kind = all[i].kind};
        assert_true(orr_field_number(&f, all[i].at, 0) == all[i].value);
    }
    const orr_field f = {.name = "x", .kind = ORR_FIELD_U64};
    assert_true(orr_field_bits(&f, &u64) == UINT64_MAX);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(frames_pass_through),
                                       cmocka_unit_test(fields_read_what_is_there),
                                       cmocka_unit_test(integers)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
