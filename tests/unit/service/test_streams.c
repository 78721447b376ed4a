// SPDX-License-Identifier: GPL-3.0-or-later
// Streams on a simulated clock and a made-up answerer: what is made when, what is left out, and who loses what.
#include "src/service/live/streams.h"

#include "fake.h"
#include "testing.h"

static const int64_t MS = 1000000;

typedef struct bench {
    fake fake;
    orr_server server;
    orr_streams *streams;
    int64_t now_ns;
    unsigned woken;
} bench;

static void host_of(void *user, orr_host *h)
{
    const int64_t now = ((bench *)user)->now_ns;
    *h = (orr_host){now, now, now, now};
}

static void control(bench *b, uint8_t action, int64_t t, int64_t delay)
{
    const orr_msg_control m = {.action = action, .t = t, .at = ORR_TIME_NONE, .delay = delay};
    orr_msg_time told;
    orr_server_refusal why;
    assert_int_equal(orr_streams_control(b->streams, &m, &told, &why), 0);
}
static void wake(void *user) { ((bench *)user)->woken++; }

static bool served(void *user, uint16_t request, orr_msg_span *span)
{
    (void)user;
    *span = (orr_msg_span){0, 1000 * ORR_NS_PER_S};
    return request == ORR_MSG_TYPE_POLL;
}

static void start(bench *b)
{
    *b = (bench){.fake.n_sats = 3, .now_ns = 5 * ORR_NS_PER_S};
    b->server = fake_server(&b->fake);
    b->server.served = served;
    const orr_streams_options o = {.maker = &b->server,
                                   .wake = wake,
                                   .wake_user = b,
                                   .host = host_of,
                                   .host_user = b,
                                   .begin = 100 * ORR_NS_PER_S,
                                   .processor = -1};
    orr_diag diag = {0};
    ASSERT_OK(orr_streams_open(&o, &b->streams, &diag), diag);
    control(b, ORR_MSG_CONTROL_ACTION_START, ORR_TIME_NONE, 0);
}

static void finish(bench *b) { orr_streams_close(b->streams); }

static uint16_t ask(bench *b, uint8_t pacing, int64_t t, int64_t step, uint32_t count, int64_t lead,
                    uint32_t credit, orr_stream **x)
{
    uint8_t data[64];
    orr_wire_writer w = {data, 0, sizeof data, ORR_WIRE_OK};
    const orr_msg_poll poll = {.epochs = {t, step, count}};
    orr_msg_poll_encode(&poll, &w);
    const orr_msg_subscribe m = {.request = ORR_MSG_TYPE_POLL,
                                 .pacing = pacing,
                                 .credit = credit,
                                 .lead = lead,
                                 .poll = {data, (uint16_t)w.size}};
    orr_msg_subscribed told;
    orr_server_refusal why;
    return orr_streams_subscribe(b->streams, &b->server, &m, NULL, b, &told, x, &why);
}

// All turns that are due now; when the next is.
static int64_t settle(bench *b)
{
    int64_t next;
    int turns = 0;
    while ((next = orr_streams_turn(b->streams, b->now_ns)) <= b->now_ns) assert_true(++turns < 100000);
    return next;
}

// The next frame's type; its instant in *t.
static uint16_t take(orr_stream *x, int64_t *t)
{
    orr_payload *b = orr_stream_next(x);
    if (b == NULL) return 0;
    const uint16_t type = b->type;
    *t = orr_wire_load_i64(b->data);
    orr_stream_sent(x, b);
    return type;
}

static orr_msg_stream_end end_of(orr_stream *x)
{
    orr_msg_stream_end m = {0};
    orr_payload *b = orr_stream_next(x);
    assert_non_null(b);
    assert_int_equal(b->type, ORR_MSG_TYPE_STREAM_END);
    assert_int_equal(orr_msg_stream_end_decode(b->data, (uint32_t)b->size, &m), ORR_WIRE_OK);
    orr_stream_sent(x, b);
    return m;
}

// Blocks of 1 ms, 20 ms ahead: each is made when the clock says, not before, and the thread sleeps until then.
static void each_block_in_its_time(void **state)
{
    (void)state;
    bench b;
    orr_stream *x;
    int64_t t;
    start(&b);
    assert_int_equal(ask(&b, ORR_MSG_PACING_CLOCK, ORR_TIME_NONE, MS, 0, 20 * MS, 1000, &x), 0);
    for (int k = 0; k < 200; k++) {
        assert_int_equal(settle(&b), b.now_ns + MS);
        assert_int_equal(take(x, &t), ORR_MSG_TYPE_STATES);
        assert_int_equal(t, 100 * ORR_NS_PER_S + 20 * MS + k * MS);
        assert_int_equal(take(x, &t), 0);
        b.now_ns += MS;
    }
    orr_stream_close(x);
    finish(&b);
}

// The machine was suspended, or held up, for 3 s: what has passed by more than half a second is left out and told.
static void a_hole_is_told(void **state)
{
    (void)state;
    bench b;
    orr_stream *x;
    int64_t t;
    start(&b);
    assert_int_equal(ask(&b, ORR_MSG_PACING_CLOCK, 100 * ORR_NS_PER_S, 10 * MS, 0, 0, 1000, &x), 0);
    settle(&b);
    assert_int_equal(take(x, &t), ORR_MSG_TYPE_STATES);
    b.now_ns += 3 * ORR_NS_PER_S;
    settle(&b);
    orr_payload *p = orr_stream_next(x);
    orr_msg_gap gap;
    assert_int_equal(p->type, ORR_MSG_TYPE_GAP);
    assert_int_equal(orr_msg_gap_decode(p->data, (uint32_t)p->size, &gap), ORR_WIRE_OK);
    orr_stream_sent(x, p);
    assert_int_equal(gap.first, 100 * ORR_NS_PER_S + 10 * MS);
    assert_int_equal(gap.last, 103 * ORR_NS_PER_S);
    assert_int_equal(gap.blocks, 300);
    assert_int_equal(gap.reason, ORR_MSG_GAP_REASON_LATE);
    assert_int_equal(take(x, &t), 0);
    b.now_ns += 10 * MS;
    settle(&b);
    assert_int_equal(take(x, &t), ORR_MSG_TYPE_STATES);
    assert_int_equal(t, 103 * ORR_NS_PER_S + 10 * MS);
    // 0.4 s late is late, and made all the same.
    b.now_ns += 400 * MS;
    settle(&b);
    for (int k = 2; k <= 41; k++) {
        assert_int_equal(take(x, &t), ORR_MSG_TYPE_STATES);
        assert_int_equal(t, 103 * ORR_NS_PER_S + k * 10 * MS);
    }
    orr_stream_close(x);
    finish(&b);
}

static void credit_is_kept(void **state)
{
    (void)state;
    bench b;
    orr_stream *x;
    int64_t t;
    start(&b);
    assert_int_equal(ask(&b, ORR_MSG_PACING_FREE, 0, MS, 7, 0, 2, &x), 0);
    assert_int_equal(settle(&b), INT64_MAX);
    for (int k = 0; k < 2; k++) assert_int_equal(take(x, &t), ORR_MSG_TYPE_STATES);
    assert_int_equal(take(x, &t), 0);
    orr_stream_credit(x, 100);
    settle(&b);
    for (int k = 2; k < 7; k++) {
        assert_int_equal(take(x, &t), ORR_MSG_TYPE_STATES);
        assert_int_equal(t, k * MS);
    }
    const orr_msg_stream_end m = end_of(x);
    assert_int_equal(m.reason, ORR_MSG_END_REASON_FINISHED);
    assert_int_equal(m.next, 7 * MS);
    orr_stream_close(x);
    finish(&b);
}

// A stream that is not taken: its queue is bounded, its end told, and the one beside it has every block in time.
static void who_takes_nothing_loses_alone(void **state)
{
    (void)state;
    bench b;
    orr_stream *lazy, *busy;
    int64_t t;
    start(&b);
    assert_int_equal(ask(&b, ORR_MSG_PACING_CLOCK, 100 * ORR_NS_PER_S, MS, 0, 0, UINT32_MAX, &lazy), 0);
    assert_int_equal(ask(&b, ORR_MSG_PACING_CLOCK, 100 * ORR_NS_PER_S, MS, 0, 0, UINT32_MAX, &busy), 0);
    for (int k = 0; k < 2000; k++, b.now_ns += MS) {
        settle(&b);
        assert_int_equal(take(busy, &t), ORR_MSG_TYPE_STATES);
        assert_int_equal(t, 100 * ORR_NS_PER_S + k * MS);
    }
    for (int k = 0; k < ORR_STREAM_QUEUE; k++) assert_int_equal(take(lazy, &t), ORR_MSG_TYPE_STATES);
    const orr_msg_stream_end m = end_of(lazy);
    assert_int_equal(m.reason, ORR_MSG_END_REASON_SLOW);
    assert_int_equal(m.next, 100 * ORR_NS_PER_S + ORR_STREAM_QUEUE * MS);
    orr_stream_close(lazy);
    orr_stream_close(busy);
    finish(&b);
}

// Streams that ask for the same have one copy: the answerer is asked once.
static void the_same_is_made_once(void **state)
{
    (void)state;
    bench b;
    orr_stream *x[64];
    int64_t t;
    start(&b);
    for (int k = 0; k < 64; k++)
        assert_int_equal(ask(&b, ORR_MSG_PACING_CLOCK, 100 * ORR_NS_PER_S, 10 * MS, 0, 0, 100, &x[k]), 0);
    const unsigned before = b.fake.answered;
    for (int n = 0; n < 10; n++, b.now_ns += 10 * MS) {
        settle(&b);
        for (int k = 0; k < 64; k++) {
            assert_int_equal(take(x[k], &t), ORR_MSG_TYPE_STATES);
            assert_int_equal(t, 100 * ORR_NS_PER_S + n * 10 * MS);
        }
    }
    assert_int_equal(b.fake.answered - before, 10);
    for (int k = 0; k < 64; k++) orr_stream_close(x[k]);
    finish(&b);
}

// The clock stands: nothing is due. It is set: what is due follows it.
static void the_clock_rules(void **state)
{
    (void)state;
    bench b;
    orr_stream *x;
    int64_t t;
    start(&b);
    control(&b, ORR_MSG_CONTROL_ACTION_PAUSE, ORR_TIME_NONE, 0);
    assert_int_equal(ask(&b, ORR_MSG_PACING_CLOCK, ORR_TIME_NONE, 10 * MS, 0, 0, 100, &x), 0);
    b.now_ns += 60 * ORR_NS_PER_S;
    assert_int_equal(settle(&b), INT64_MAX);
    assert_int_equal(take(x, &t), 0);
    control(&b, ORR_MSG_CONTROL_ACTION_START, ORR_TIME_NONE, 5 * MS);
    assert_int_equal(settle(&b), b.now_ns + 5 * MS);
    b.now_ns += 5 * MS;
    settle(&b);
    assert_int_equal(take(x, &t), ORR_MSG_TYPE_STATES);
    assert_int_equal(t, 100 * ORR_NS_PER_S);
    orr_stream_close(x);
    finish(&b);
}

// A block that cannot be made ends its stream with the sentence; one that is closed while others live is forgotten.
static void failures_and_ends(void **state)
{
    (void)state;
    bench b;
    orr_stream *x, *y;
    int64_t t;
    start(&b);
    assert_int_equal(ask(&b, ORR_MSG_PACING_FREE, 666 - MS, MS, 0, 0, 100, &x),
                     ORR_MSG_ERROR_CODE_BAD_REQUEST);
    assert_int_equal(ask(&b, ORR_MSG_PACING_FREE, 666, MS, 0, 0, 100, &x), 0);
    assert_int_equal(ask(&b, ORR_MSG_PACING_FREE, 0, ORR_NS_PER_S, 0, 0, 5, &y), 0);
    settle(&b);
    orr_payload *p = orr_stream_next(x);
    orr_msg_stream_end m;
    assert_int_equal(orr_msg_stream_end_decode(p->data, (uint32_t)p->size, &m), ORR_WIRE_OK);
    assert_int_equal(m.reason, ORR_MSG_END_REASON_FAILED);
    assert_memory_equal(m.sentence.data, "broken at 666", 13);
    orr_stream_sent(x, p);
    orr_stream_close(x);
    assert_int_equal(take(y, &t), ORR_MSG_TYPE_STATES);
    orr_stream_end(y);
    const orr_msg_stream_end e = end_of(y);
    assert_int_equal(e.reason, ORR_MSG_END_REASON_UNSUBSCRIBED);
    assert_int_equal(e.next, ORR_NS_PER_S); // the first that was not taken
    orr_stream_close(y);
    assert_int_equal(ask(&b, ORR_MSG_PACING_FREE, 1000 * ORR_NS_PER_S, MS, 0, 0, 100, &x), 0);
    settle(&b);
    assert_int_equal(take(x, &t), ORR_MSG_TYPE_STATES);
    assert_int_equal(end_of(x).reason, ORR_MSG_END_REASON_OUTSIDE_SPAN);
    orr_stream_close(x);
    assert_true(b.woken > 0);
    finish(&b);
}

static orr_msg_modes modes_of(bench *b, uint64_t after, orr_msg_mode_change last[3])
{
    static uint8_t data[ORR_MSG_MODES_LARGEST];
    orr_wire_writer w = {data, 0, sizeof data, ORR_WIRE_OK};
    orr_msg_modes m;
    orr_streams_modes(b->streams, after, &w);
    assert_int_equal(w.status, ORR_WIRE_OK);
    assert_int_equal(orr_msg_modes_decode(data, (uint32_t)w.size, &m), ORR_WIRE_OK);
    for (uint16_t k = 0; k < 3 && k < m.changes.count; k++)
        assert_true(orr_msg_mode_change_at(&m.changes, (uint16_t)(m.changes.count - 1 - k), &last[k]));
    return m;
}

// A start that was fixed is an event when it comes, at its own instant; a generator that falls silent one two seconds later; of more
// changes than are kept it is told how many are not.
static void modes_change(void **state)
{
    (void)state;
    bench b;
    orr_msg_mode_change c[3];
    start(&b);
    assert_int_equal(modes_of(&b, 0, c).last, 1);
    assert_int_equal(c[0].mode, ORR_MSG_MODE_RUNNING);
    control(&b, ORR_MSG_CONTROL_ACTION_STOP, ORR_TIME_NONE, 0);
    control(&b, ORR_MSG_CONTROL_ACTION_START, ORR_TIME_NONE, 3 * ORR_NS_PER_S);
    assert_int_equal(settle(&b), b.now_ns + 3 * ORR_NS_PER_S); // it wakes for it
    assert_int_equal(modes_of(&b, 0, c).last, 3);
    assert_int_equal(c[0].mode, ORR_MSG_MODE_WAITING);
    b.now_ns += 3 * ORR_NS_PER_S + 7 * MS;
    settle(&b);
    assert_int_equal(modes_of(&b, 3, c).changes.count, 1);
    assert_int_equal(c[0].mode, ORR_MSG_MODE_RUNNING);
    assert_int_equal(c[0].at, 100 * ORR_NS_PER_S);

    const orr_msg_radio_time radio = {.elapsed = ORR_NS_PER_S};
    orr_msg_pace pace;
    orr_server_refusal why;
    assert_int_equal(orr_streams_radio(b.streams, &radio, ORR_TIME_NONE, &pace, &why), 0);
    (void)modes_of(&b, 0, c);
    assert_int_equal(c[0].mode, ORR_MSG_MODE_LOCKED);
    b.now_ns += 2 * ORR_NS_PER_S;
    assert_int_equal(modes_of(&b, 0, c).last, 5);
    b.now_ns += 1;
    assert_int_equal(modes_of(&b, 0, c).last, 6);
    assert_int_equal(c[0].before, ORR_MSG_MODE_LOCKED);
    assert_int_equal(c[0].mode, ORR_MSG_MODE_SILENT);

    for (int k = 0; k < 600; k++) {
        control(&b, ORR_MSG_CONTROL_ACTION_PAUSE, ORR_TIME_NONE, 0);
        settle(&b);
        control(&b, ORR_MSG_CONTROL_ACTION_START, ORR_TIME_NONE, 0);
        settle(&b);
    }
    orr_msg_modes m = modes_of(&b, 0, c);
    assert_int_equal(m.lost, 1206 - 1024);
    assert_int_equal(m.last, m.lost + ORR_MSG_MAX_CHANGES);
    assert_int_equal(m.more, 1);
    assert_int_equal(c[0].number, m.last);
    m = modes_of(&b, 1205, c);
    assert_int_equal(m.changes.count, 1);
    assert_int_equal(m.lost + m.more, 0);
    assert_int_equal(modes_of(&b, 5000, c).last, 1206); // numbers that there are not yet
    finish(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_block_in_its_time), cmocka_unit_test(a_hole_is_told),
        cmocka_unit_test(credit_is_kept),         cmocka_unit_test(who_takes_nothing_loses_alone),
        cmocka_unit_test(the_same_is_made_once),  cmocka_unit_test(the_clock_rules),
        cmocka_unit_test(failures_and_ends),      cmocka_unit_test(modes_change),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
