// SPDX-License-Identifier: GPL-3.0-or-later
#include "fake.h"
#include "testing.h"

static uint8_t in[400000], out[400000], out2[400000];

static size_t put_frame(uint8_t *buf, uint16_t type, uint32_t sequence, const void *payload, size_t n)
{
    orr_wire_writer w = {buf, 0, n + ORR_FRAME_OVERHEAD, ORR_WIRE_OK};
    size_t start;
    orr_frame_begin(&w, type, sequence, &start);
    orr_wire_put_raw(&w, payload, n);
    orr_frame_end(&w, start);
    assert_int_equal(w.status, ORR_WIRE_OK);
    return w.size;
}

static size_t put_poll(uint8_t *buf, uint32_t sequence, int64_t t, int64_t step, uint32_t count)
{
    uint8_t payload[64];
    orr_wire_writer w = {payload, 0, sizeof payload, ORR_WIRE_OK};
    orr_msg_poll m = {{t, step, count}, {0, NULL, {NULL, 0, 0}}};
    assert_int_equal(orr_msg_poll_encode(&m, &w), ORR_WIRE_OK);
    return put_frame(buf, ORR_MSG_TYPE_POLL, sequence, payload, w.size);
}

static orr_frame frame_at(const uint8_t *data, size_t n, size_t *at)
{
    orr_frame f;
    size_t used;
    assert_int_equal(orr_frame_parse(data + *at, n - *at, ORR_MSG_MAX_PAYLOAD, &f, &used), ORR_WIRE_OK);
    *at += used;
    return f;
}

static orr_msg_error error_at(const uint8_t *data, size_t n, size_t *at, uint32_t sequence)
{
    orr_frame f = frame_at(data, n, at);
    orr_msg_error e;
    assert_int_equal(f.type, ORR_MSG_TYPE_ERROR);
    assert_int_equal(f.sequence, sequence);
    assert_int_equal(orr_msg_error_decode(f.payload, f.size, &e), ORR_WIRE_OK);
    assert_true(e.sentence.size > 10);
    return e;
}

static void a_series_ends_clearly(void **state)
{
    (void)state;
    fake f = {.n_sats = 3};
    orr_server s = fake_server(&f);
    orr_server_conn c = {0};
    orr_server_step step;
    size_t n = put_poll(in, 9, 100, 10, 4), at = 0;
    orr_wire_writer w = {out, 0, sizeof out, ORR_WIRE_OK};
    orr_server_run(&s, &c, in, n, &w, &step);
    assert_true(step.consumed == n && !step.busy && step.closing == 0);
    for (uint32_t k = 0; k < 4; k++) {
        orr_frame fr = frame_at(out, w.size, &at);
        orr_msg_states m;
        assert_int_equal(fr.type, ORR_MSG_TYPE_STATES);
        assert_int_equal(fr.sequence, 9);
        assert_int_equal(orr_msg_states_decode(fr.payload, fr.size, &m), ORR_WIRE_OK);
        assert_true(m.epoch.index == k && m.epoch.count == 4 && m.epoch.t == 100 + 10 * k &&
                    m.satellites.count == 3);
    }
    assert_int_equal(at, w.size);
    assert_true(c.requests == 1 && c.refusals == 0 && f.begun == 1);
}

// Each satellite of a frame is a piece; what they are computed from is kept from the first to the last.
static uint16_t answer_in_pieces(void *user, const orr_msg_poll *poll, orr_server_part *part,
                                 orr_wire_writer *w, orr_server_refusal *why)
{
    (void)why;
    fake *f = user;
    static const uint8_t none;
    bool another = true;
    if (part->done == 0) {
        orr_msg_states m = {{poll->epochs.t, part->index, poll->epochs.count, ORR_MSG_ANSWER_OK},
                            {f->n_sats, NULL, {&none, 0, ORR_MSG_SAT_STATE_SIZE}}};
        part->kept[0] = (double)(poll->epochs.t + part->index);
        orr_msg_states_encode(&m, w);
        f->answered++;
        another = orr_server_next_piece(part, f->n_sats + 1u);
    }
    for (; another; another = orr_server_next_piece(part, f->n_sats + 1u)) {
        orr_msg_sat_state one = fake_state((uint8_t)part->done, (int64_t)part->kept[0]);
        orr_msg_sat_state_records_encode(&(orr_msg_sat_state_list){1, &one, {NULL, 0, 0}}, w);
        f->answered++;
    }
    return 0;
}

static bool count_down(void *owner)
{
    int *left = owner;
    return --*left <= 0;
}

// However short the turns and however small the output, the bytes are the same; a turn makes as many pieces
// as it has units, and never none.
static void turns_end_between_pieces(void **state)
{
    (void)state;
    fake f = {.n_sats = 3};
    const orr_msg_handlers handlers = {.begin_poll = fake_begin, .poll = answer_in_pieces};
    orr_server s = fake_server(&f);
    s.handlers = &handlers;
    orr_server_conn whole = {0};
    orr_server_step step;
    size_t n = put_poll(in, 9, 100, 1, 4);
    n += put_frame(in + n, ORR_MSG_TYPE_PING, 3, "12345678", 8);
    n += put_poll(in + n, 10, 100, 1, 2);
    orr_wire_writer w = {out, 0, sizeof out, ORR_WIRE_OK};
    orr_server_run(&s, &whole, in, n, &w, &step);
    assert_true(!step.yield && step.consumed == n && f.answered == 6 * 4);
    for (int units = 1; units < 30; units++) {
        for (size_t room = 450; room < 3000; room += 833) { // one STATES takes 389 bytes
            int left = 0;
            orr_server_conn c = {.over = count_down, .owner = &left};
            size_t from = 0, got = 0, held = 0;
            static uint8_t piece[4000];
            orr_wire_writer v = {piece, 0, room, ORR_WIRE_OK};
            do {
                unsigned before = f.answered;
                left = units;
                orr_server_run(&s, &c, in + from, n - from, &v, &step);
                assert_true(f.answered - before <= (unsigned)units);
                assert_true(v.size + c.unfinished > held || step.consumed > 0 || !step.yield);
                held = v.size + c.unfinished;
                from += step.consumed;
                if (step.yield && units % 2 == 0) continue; // others first, the output stays as it is
                memcpy(out2 + got, piece, v.size);
                got += v.size;
                memmove(piece, piece + v.size, c.unfinished);
                v.size = 0;
                held = c.unfinished;
            } while (step.busy);
            assert_true(from == n && c.requests == 3 && c.unfinished == 0);
            memcpy(out2 + got, piece, v.size);
            got += v.size;
            assert_int_equal(got, w.size);
            assert_memory_equal(out, out2, got);
        }
    }
}

// Requests that cost little end a turn as well, when there are many of them.
static void turns_end_between_requests(void **state)
{
    (void)state;
    fake f = {.n_sats = 1};
    orr_server s = fake_server(&f);
    int left = 0;
    orr_server_conn c = {.over = count_down, .owner = &left};
    size_t n = 0, from = 0;
    for (uint32_t k = 0; k < 10; k++) n += put_frame(in + n, ORR_MSG_TYPE_PING, k, "12345678", 8);
    for (uint64_t served = 4; from < n; served += 4) {
        orr_wire_writer w = {out, 0, sizeof out, ORR_WIRE_OK};
        orr_server_step step;
        left = 4;
        orr_server_run(&s, &c, in + from, n - from, &w, &step);
        from += step.consumed;
        assert_true(c.requests == (served < 10 ? served : 10) && step.yield == (from < n) &&
                    step.busy == step.yield);
    }
}

static void byte_by_byte_and_all_at_once_agree(void **state)
{
    (void)state;
    fake f = {.n_sats = 2};
    orr_server s = fake_server(&f);
    size_t n = 0;
    n += put_frame(in + n, ORR_MSG_TYPE_PING, 1, "12345678", 8);
    n += put_poll(in + n, 2, 5, 1, 2);
    n += put_frame(in + n, 999, 3, "", 0);
    n += put_poll(in + n, 4, 5, 1, 0);
    n += put_frame(in + n, ORR_MSG_TYPE_PING, 5, "abcdefgh", 8);
    orr_wire_writer all = {out, 0, sizeof out, ORR_WIRE_OK}, slow = {out2, 0, sizeof out2, ORR_WIRE_OK};
    orr_server_conn c = {0}, d = {0};
    orr_server_step step;
    orr_server_run(&s, &c, in, n, &all, &step);
    assert_true(step.consumed == n && c.requests == 5 && c.refusals == 2);
    size_t from = 0;
    for (size_t to = 1; to <= n; to++) {
        orr_server_run(&s, &d, in + from, to - from, &slow, &step);
        assert_int_equal(step.closing, 0);
        from += step.consumed;
        assert_true(to - from < step.need);
    }
    assert_int_equal(from, n);
    assert_int_equal(all.size, slow.size);
    assert_memory_equal(out, out2, all.size);
    size_t at = 0;
    orr_frame fr = frame_at(out, all.size, &at);
    assert_true(fr.type == ORR_MSG_TYPE_PONG && memcmp(fr.payload, "12345678", 8) == 0);
    frame_at(out, all.size, &at);
    frame_at(out, all.size, &at);
    orr_msg_error e = error_at(out, all.size, &at, 3);
    assert_true(e.code == ORR_MSG_ERROR_CODE_UNKNOWN_TYPE && e.request == 999);
    e = error_at(out, all.size, &at, 4);
    assert_true(e.code == ORR_MSG_ERROR_CODE_BAD_REQUEST && e.request == ORR_MSG_TYPE_POLL);
    fr = frame_at(out, all.size, &at);
    assert_true(fr.type == ORR_MSG_TYPE_PONG && fr.sequence == 5); // the connection has lived on
    assert_int_equal(at, all.size);
}

// However little room there is for output, the bytes that go out are the same.
static void small_outputs_change_nothing(void **state)
{
    (void)state;
    fake f = {.n_sats = 5};
    orr_server s = fake_server(&f);
    size_t n = put_poll(in, 1, 0, 7, 20), whole;
    n += put_frame(in + n, 999, 2, "", 0);
    n += put_frame(in + n, ORR_MSG_TYPE_PING, 3, "12345678", 8);
    orr_wire_writer w = {out, 0, sizeof out, ORR_WIRE_OK};
    orr_server_conn c = {0};
    orr_server_step step;
    orr_server_run(&s, &c, in, n, &w, &step);
    whole = w.size;
    for (size_t room = 700; room < 4000; room += 97) { // one STATES of five satellites takes 625 bytes
        orr_server_conn d = {0};
        size_t from = 0, got = 0;
        for (int rounds = 0; from < n; rounds++) {
            assert_true(rounds < 100);
            orr_wire_writer v = {out2 + got, 0, room, ORR_WIRE_OK};
            orr_server_run(&s, &d, in + from, n - from, &v, &step);
            assert_true(step.busy == (from + step.consumed < n));
            from += step.consumed;
            got += v.size;
        }
        assert_int_equal(got, whole);
        assert_memory_equal(out, out2, whole);
        assert_true(d.requests == 3 && d.refusals == 1);
    }
}

static void an_answer_that_never_fits_is_refused(void **state)
{
    (void)state;
    fake f = {.n_sats = 50};
    orr_server s = fake_server(&f);
    orr_server_conn c = {0};
    orr_server_step step;
    size_t n = put_poll(in, 1, 0, 0, 1), at = 0;
    orr_wire_writer w = {out, 0, 1000, ORR_WIRE_OK};
    orr_server_run(&s, &c, in, n, &w, &step);
    assert_true(step.consumed == n && !step.busy);
    assert_int_equal(error_at(out, w.size, &at, 1).code, ORR_MSG_ERROR_CODE_INTERNAL);
}

// A connection that can grow is asked to, and then has the whole answer.
static void an_answer_that_does_not_fit_asks_for_room(void **state)
{
    (void)state;
    fake f = {.n_sats = 50};
    orr_server s = fake_server(&f);
    orr_server_conn c = {.can_grow = true}, d = {0};
    orr_server_step step;
    static uint8_t large[ORR_SERVER_OUT];
    size_t n = put_frame(in, ORR_MSG_TYPE_PING, 7, "12345678", 8);
    n += put_poll(in + n, 1, 0, 1, 2);
    orr_wire_writer w = {out, 0, 1000, ORR_WIRE_OK}, v = {large, 0, sizeof large, ORR_WIRE_OK};
    orr_server_run(&s, &c, in, n, &w, &step);
    assert_true(step.busy && step.room == 0 && w.size == 28); // the PONG goes first
    size_t from = step.consumed;
    w.size = 0;
    orr_server_run(&s, &c, in + from, n - from, &w, &step);
    assert_true(step.busy && step.room == ORR_SERVER_OUT && step.consumed == 0 && w.size == 0);
    orr_server_run(&s, &c, in + from, n - from, &v, &step);
    assert_true(!step.busy && step.room == 0 && from + step.consumed == n && c.refusals == 0);
    orr_wire_writer whole = {out2, 0, sizeof out2, ORR_WIRE_OK};
    orr_server_run(&s, &d, in + from, n - from, &whole, &step);
    assert_int_equal(whole.size, v.size);
    assert_memory_equal(out2, large, v.size);
}

static void a_refusal_in_mid_series_ends_it(void **state)
{
    (void)state;
    fake f = {.n_sats = 1};
    orr_server s = fake_server(&f);
    orr_server_conn c = {0};
    orr_server_step step;
    size_t n = put_poll(in, 1, 664, 1, 5), at = 0;
    n += put_frame(in + n, ORR_MSG_TYPE_PING, 2, "12345678", 8);
    orr_wire_writer w = {out, 0, sizeof out, ORR_WIRE_OK};
    orr_server_run(&s, &c, in, n, &w, &step);
    assert_int_equal(frame_at(out, w.size, &at).type, ORR_MSG_TYPE_STATES);
    assert_int_equal(frame_at(out, w.size, &at).type, ORR_MSG_TYPE_STATES);
    assert_int_equal(error_at(out, w.size, &at, 1).code, ORR_MSG_ERROR_CODE_INTERNAL);
    assert_int_equal(frame_at(out, w.size, &at).type, ORR_MSG_TYPE_PONG);
    assert_int_equal(at, w.size);
}

static void hello_tells_what_is_served(void **state)
{
    (void)state;
    fake f = {.n_sats = 1};
    orr_server s = fake_server(&f);
    orr_server_conn c = {0};
    orr_server_step step;
    uint8_t payload[100];
    orr_wire_writer p = {payload, 0, sizeof payload, ORR_WIRE_OK}, w = {out, 0, sizeof out, ORR_WIRE_OK};
    orr_msg_hello hello = {1, 3, orr_wire_text("gen\n\033[31m"), orr_wire_text("2")};
    orr_msg_hello_encode(&hello, &p);
    size_t n = put_frame(in, ORR_MSG_TYPE_HELLO, 1, payload, p.size), at = 0;
    orr_server_run(&s, &c, in, n, &w, &step);
    orr_frame fr = frame_at(out, w.size, &at);
    orr_msg_caps caps;
    assert_int_equal(orr_msg_caps_decode(fr.payload, fr.size, &caps), ORR_WIRE_OK);
    assert_true(caps.major == 1 && caps.minor == 0 && caps.span.first == -5 && caps.span.last == 1000);
    orr_msg_served_request r;
    assert_true(caps.requests.count == 3 && orr_msg_served_request_at(&caps.requests, 2, &r) &&
                r.request == ORR_MSG_TYPE_POLL && r.answer == ORR_MSG_TYPE_STATES &&
                r.span.first == INT64_MIN);
    assert_string_equal(c.client, "gen??[31m 2"); // a name goes into a log: no control characters
    assert_int_equal(step.closing, 0);
    // no common version: an ERROR, then the end
    hello.major_min = 2;
    p.size = 0;
    orr_msg_hello_encode(&hello, &p);
    n = put_frame(in, ORR_MSG_TYPE_HELLO, 7, payload, p.size), w.size = at = 0;
    orr_server_run(&s, &c, in, n, &w, &step);
    assert_int_equal(error_at(out, w.size, &at, 7).code, ORR_MSG_ERROR_CODE_BAD_VERSION);
    assert_int_equal(step.closing, ORR_MSG_ERROR_CODE_BAD_VERSION);
}

static void broken_streams_close(void **state)
{
    (void)state;
    fake f = {.n_sats = 1};
    orr_server s = fake_server(&f);
    const struct {
        size_t byte;
        uint8_t value;
        uint16_t code;
    } cases[] = {{0, 'X', ORR_MSG_ERROR_CODE_BAD_MAGIC},
                 {4, 2, ORR_MSG_ERROR_CODE_BAD_VERSION},
                 {15, 1, ORR_MSG_ERROR_CODE_BAD_LENGTH},
                 {17, 'X', ORR_MSG_ERROR_CODE_BAD_CRC}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        orr_server_conn c = {0};
        orr_server_step step;
        size_t n = put_frame(in, ORR_MSG_TYPE_PING, 1, "12345678", 8), at = 0;
        size_t m = put_frame(in + n, ORR_MSG_TYPE_PING, 2, "12345678", 8);
        m += put_frame(in + n + m, ORR_MSG_TYPE_PING, 3, "12345678", 8);
        in[n + cases[k].byte] = cases[k].value;
        orr_wire_writer w = {out, 0, sizeof out, ORR_WIRE_OK};
        orr_server_run(&s, &c, in, n + m, &w, &step);
        assert_int_equal(frame_at(out, w.size, &at).type,
                         ORR_MSG_TYPE_PONG); // what came before it is answered
        assert_int_equal(error_at(out, w.size, &at, 0).code, cases[k].code);
        assert_int_equal(at, w.size); // what came behind it is not
        assert_int_equal(step.closing, cases[k].code);
        assert_true(strlen(step.reason) > 10);
    }
}

static void short_payloads_and_server_messages(void **state)
{
    (void)state;
    fake f = {.n_sats = 1};
    orr_server s = fake_server(&f);
    orr_server_conn c = {0};
    orr_server_step step;
    const struct {
        uint16_t type, code;
    } cases[] = {{ORR_MSG_TYPE_PING, ORR_MSG_ERROR_CODE_BAD_PAYLOAD},
                 {ORR_MSG_TYPE_HELLO, ORR_MSG_ERROR_CODE_BAD_PAYLOAD},
                 {ORR_MSG_TYPE_POLL, ORR_MSG_ERROR_CODE_BAD_PAYLOAD},
                 {ORR_MSG_TYPE_STATES, ORR_MSG_ERROR_CODE_NOT_SERVED},
                 {ORR_MSG_TYPE_ERROR, ORR_MSG_ERROR_CODE_NOT_SERVED},
                 {0, ORR_MSG_ERROR_CODE_UNKNOWN_TYPE},
                 {65535, ORR_MSG_ERROR_CODE_UNKNOWN_TYPE}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        size_t n = put_frame(in, cases[k].type, 40, "abc", 3), at = 0;
        orr_wire_writer w = {out, 0, sizeof out, ORR_WIRE_OK};
        orr_server_run(&s, &c, in, n, &w, &step);
        orr_msg_error e = error_at(out, w.size, &at, 40);
        assert_int_equal(e.code, cases[k].code);
        assert_int_equal(e.request, cases[k].type);
        assert_true(step.consumed == n && step.closing == 0);
    }
    assert_int_equal(f.begun + f.answered, 0); // no handler has seen any of them
}

// A payload that is cut, or whose count is above its limit, is refused before a handler sees it.
static void handlers_see_decoded_requests_alone(void **state)
{
    (void)state;
    fake f = {.n_sats = 1};
    orr_server s = fake_server(&f);
    orr_server_step step;
    uint8_t payload[64] = {0};
    orr_wire_store_u32(payload + 16, 1);                           // count of epochs
    orr_wire_store_u16(payload + 20, ORR_MSG_MAX_SATELLITES + 1u); // of satellites
    for (size_t size = 0; size <= 24; size++) {
        orr_server_conn c = {0};
        size_t n = put_frame(in, ORR_MSG_TYPE_POLL, 40, (const char *)payload, size), at = 0;
        orr_wire_writer w = {out, 0, sizeof out, ORR_WIRE_OK};
        orr_server_run(&s, &c, in, n, &w, &step);
        assert_int_equal(error_at(out, w.size, &at, 40).code,
                         size < 24 ? ORR_MSG_ERROR_CODE_BAD_PAYLOAD : ORR_MSG_ERROR_CODE_LIMIT);
        assert_int_equal(at, w.size);
    }
    assert_int_equal(f.begun + f.answered, 0);
}

static void random_streams(void **state)
{
    (void)state;
    fake f = {.n_sats = 2};
    orr_server s = fake_server(&f);
    uint32_t x = 99;
    for (int k = 0; k < 3000; k++) {
        orr_server_conn c = {0};
        orr_server_step step;
        size_t n = 0;
        for (int i = 0; i < 3; i++) n += put_poll(in + n, (uint32_t)i, k, 1, (uint32_t)(k % 4));
        for (int i = 0; i < k % 5; i++) {
            x = x * 1664525u + 1013904223u;
            in[(x >> 8) % n] ^= (uint8_t)(1u << (x >> 29));
        }
        orr_wire_writer w = {out, 0, ORR_SERVER_OUT, ORR_WIRE_OK};
        orr_server_run(&s, &c, in, n, &w, &step);
        assert_true(step.consumed <= n && w.size <= w.capacity);
        size_t at = 0;
        while (at < w.size) frame_at(out, w.size, &at); // whole frames only
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_series_ends_clearly),
        cmocka_unit_test(turns_end_between_pieces),
        cmocka_unit_test(turns_end_between_requests),
        cmocka_unit_test(byte_by_byte_and_all_at_once_agree),
        cmocka_unit_test(small_outputs_change_nothing),
        cmocka_unit_test(an_answer_that_never_fits_is_refused),
        cmocka_unit_test(an_answer_that_does_not_fit_asks_for_room),
        cmocka_unit_test(a_refusal_in_mid_series_ends_it),
        cmocka_unit_test(hello_tells_what_is_served),
        cmocka_unit_test(broken_streams_close),
        cmocka_unit_test(short_payloads_and_server_messages),
        cmocka_unit_test(handlers_see_decoded_requests_alone),
        cmocka_unit_test(random_streams),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
