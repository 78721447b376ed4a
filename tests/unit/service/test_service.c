// SPDX-License-Identifier: GPL-3.0-or-later
// The service over real sockets with a made-up answerer: what clients may do to it, and what it does about
// them.
#include "served.h"

static void conversation(void **state)
{
    (void)state;
    bench *b = start(quick_options(), 10);
    orr_dial *d = dial(b);
    orr_msg_caps caps;
    assert_int_equal(orr_client_open(&d->client, "test", "1", &caps), ORR_WIRE_OK);
    assert_int_equal(orr_client_check(&d->client, 7), ORR_WIRE_OK);
    orr_msg_poll poll = {.epochs = {100, 10, 2000}}; // far more than a socket buffer
    assert_int_equal(orr_client_poll(&d->client, &poll), ORR_WIRE_OK);
    for (uint32_t k = 0; k < poll.epochs.count; k++) {
        orr_msg_states m;
        orr_msg_sat_state s;
        assert_int_equal(orr_client_states(&d->client, &m), ORR_WIRE_OK);
        assert_true(m.epoch.index == k && m.satellites.count == 10 &&
                    orr_msg_sat_state_at(&m.satellites, 9, &s));
        assert_true(s.pos_m[0] == (double)(100 + 10 * (int64_t)k + 10));
    }
    assert_int_equal(orr_client_check(&d->client, 8), ORR_WIRE_OK);
    orr_dial_close(d);
    finish(b);
}

static void garbage_is_told_and_closed(void **state)
{
    (void)state;
    bench *b = start(quick_options(), 1);
    uint8_t buf[2000];
    int fd = raw(b);
    assert_int_equal(send(fd, "GET / HTTP/1.1\r\nHost: x\r\n\r\n", 27, 0), 27);
    assert_int_equal(error_code(buf, read_to_end(fd, buf, sizeof buf)), ORR_MSG_ERROR_CODE_BAD_MAGIC);
    close(fd);
    fd = raw(b);
    size_t n = poll_frame(buf, sizeof buf, 1, 1);
    buf[20] ^= 1;
    assert_int_equal(send(fd, buf, n, 0), (ssize_t)n);
    assert_int_equal(error_code(buf, read_to_end(fd, buf, sizeof buf)), ORR_MSG_ERROR_CODE_BAD_CRC);
    close(fd);
    fd = raw(b);
    n = poll_frame(buf, sizeof buf, 1, 1);
    orr_wire_store_u32(buf + 12, 0x7fffffff);
    assert_int_equal(send(fd, buf, 16, 0), 16); // an impossible length is not waited for
    assert_int_equal(error_code(buf, read_to_end(fd, buf, sizeof buf)), ORR_MSG_ERROR_CODE_BAD_LENGTH);
    close(fd);
    assert_true(was_said(b, "BAD_MAGIC") && was_said(b, "BAD_CRC") && was_said(b, "BAD_LENGTH"));
    finish(b);
}

static void half_frames_and_silence_time_out(void **state)
{
    (void)state;
    orr_service_options o = quick_options();
    o.half_frame_s = 0.3;
    o.first_s = 0.6;
    o.idle_s = 0.9;
    bench *b = start(o, 1);
    uint8_t buf[2000], frame[100];
    size_t n = poll_frame(frame, sizeof frame, 1, 1);
    int half = raw(b), silent = raw(b), idle = raw(b);
    assert_int_equal(send(half, frame, n - 1, 0), (ssize_t)n - 1);
    assert_int_equal(send(idle, frame, n, 0), (ssize_t)n);
    assert_int_equal(error_code(buf, read_to_end(half, buf, sizeof buf)), ORR_MSG_ERROR_CODE_TIMEOUT);
    assert_int_equal(error_code(buf, read_to_end(silent, buf, sizeof buf)), ORR_MSG_ERROR_CODE_TIMEOUT);
    n = read_to_end(idle, buf, sizeof buf);
    orr_frame f;
    size_t used;
    assert_int_equal(orr_frame_parse(buf, n, ORR_MSG_MAX_PAYLOAD, &f, &used),
                     ORR_WIRE_OK); // its answer, then the time-out
    assert_int_equal(error_code(buf + used, n - used), ORR_MSG_ERROR_CODE_TIMEOUT);
    close(half), close(silent), close(idle);
    finish(b);
}

static void a_client_that_does_not_read(void **state)
{
    (void)state;
    orr_service_options o = quick_options();
    o.stall_s = 0.5;
    bench *b = start(o, 90);
    uint8_t frame[100], buf[100000];
    size_t n = poll_frame(frame, sizeof frame, 1, 86400); // 900 MB, if it were let
    int lazy = raw(b);
    assert_int_equal(send(lazy, frame, n, 0), (ssize_t)n);
    orr_dial *d = dial(b); // others are served meanwhile
    for (int k = 0; k < 50; k++) assert_int_equal(orr_client_check(&d->client, 1), ORR_WIRE_OK);
    orr_dial_close(d);
    struct timespec nap = {0, 50000000};
    for (int k = 0; k < 200 && !was_said(b, "takes no answers"); k++) nanosleep(&nap, NULL);
    assert_true(was_said(b, "takes no answers"));
    while (recv(lazy, buf, sizeof buf, 0) > 0) continue;
    close(lazy);
    finish(b);
}

static void disconnects_in_mid_answer(void **state)
{
    (void)state;
    bench *b = start(quick_options(), 50);
    uint8_t frame[100], buf[1000];
    size_t n = poll_frame(frame, sizeof frame, 1, 5000);
    for (int k = 0; k < 20; k++) {
        int fd = raw(b);
        assert_int_equal(send(fd, frame, n, 0), (ssize_t)n);
        assert_true(recv(fd, buf, sizeof buf, 0) > 0);
        if (k % 2 == 0) { // with a reset
            struct linger hard = {1, 0};
            setsockopt(fd, SOL_SOCKET, SO_LINGER, &hard, sizeof hard);
        }
        close(fd);
    }
    orr_dial *d = dial(b);
    assert_int_equal(orr_client_check(&d->client, 1), ORR_WIRE_OK);
    orr_dial_close(d);
    finish(b);
}

static void too_many_clients(void **state)
{
    (void)state;
    orr_service_options o = quick_options();
    o.max_clients = 2;
    bench *b = start(o, 1);
    orr_dial *one = dial(b), *two = dial(b);
    assert_int_equal(orr_client_check(&one->client, 1), ORR_WIRE_OK);
    assert_int_equal(orr_client_check(&two->client, 1), ORR_WIRE_OK);
    orr_dial *three = dial(b);
    orr_frame f;
    assert_int_equal(orr_client_answer(&three->client, ORR_MSG_TYPE_PONG, &f), ORR_WIRE_REFUSED);
    assert_int_equal(three->client.error_code, ORR_MSG_ERROR_CODE_BUSY);
    orr_dial_close(three);
    orr_dial_close(one); // a place becomes free
    struct timespec nap = {0, 20000000};
    bool served = false;
    for (int k = 0; k < 100 && !served; k++) {
        orr_dial *again = dial(b);
        served = orr_client_check(&again->client, 2) == ORR_WIRE_OK;
        orr_dial_close(again);
        nanosleep(&nap, NULL);
    }
    assert_true(served);
    orr_dial_close(two);
    finish(b);
}

static void a_half_closed_client_gets_its_answer(void **state)
{
    (void)state;
    bench *b = start(quick_options(), 3);
    uint8_t frame[100], buf[100000];
    size_t n = poll_frame(frame, sizeof frame, 1, 100);
    int fd = raw(b);
    assert_int_equal(send(fd, frame, n, 0), (ssize_t)n);
    shutdown(fd, SHUT_WR);
    assert_int_equal(read_to_end(fd, buf, sizeof buf), 100 * (20 + 21 + 3 * ORR_MSG_SAT_STATE_SIZE));
    close(fd);
    finish(b);
}

// Stopping lets a client that reads have the whole of its answer, and tells the idle.
static void stopping_drains(void **state)
{
    (void)state;
    orr_service_options o = quick_options();
    o.drain_s = 60; // a slow machine is not what is tested
    bench *b = start(o, 90);
    orr_dial *busy = dial(b), *idle = dial(b);
    assert_int_equal(orr_client_check(&idle->client, 1), ORR_WIRE_OK);
    orr_msg_poll poll = {.epochs = {100, 10, 3000}}; // 30 MB
    orr_msg_states m;
    assert_int_equal(orr_client_poll(&busy->client, &poll), ORR_WIRE_OK);
    assert_int_equal(orr_client_states(&busy->client, &m), ORR_WIRE_OK);
    orr_service_stop(b->service);
    for (uint32_t k = 1; k < poll.epochs.count; k++) {
        assert_int_equal(orr_client_states(&busy->client, &m), ORR_WIRE_OK);
        assert_int_equal(m.epoch.index, k);
    }
    orr_frame f;
    assert_int_equal(orr_client_answer(&busy->client, ORR_MSG_TYPE_PONG, &f), ORR_WIRE_REFUSED);
    assert_int_equal(busy->client.error_code, ORR_MSG_ERROR_CODE_CLOSING);
    assert_int_equal(orr_client_answer(&idle->client, ORR_MSG_TYPE_PONG, &f), ORR_WIRE_REFUSED);
    assert_int_equal(idle->client.error_code, ORR_MSG_ERROR_CODE_CLOSING);
    assert_int_equal(orr_client_answer(&idle->client, ORR_MSG_TYPE_PONG, &f), ORR_WIRE_CLOSED);
    orr_dial_close(busy);
    orr_dial_close(idle);
    void *result;
    pthread_join(b->thread, &result);
    assert_null(result);
    orr_service_close(b->service);
    free(b);
}

static void addresses_that_cannot_be_listened_on(void **state)
{
    (void)state;
    bench *b = start(quick_options(), 1);
    const char *const url[] = {"tcp://127.0.0.1:0", orr_service_url(b->service, 0)}, *const bad[] = {
                                                                                         "tcp://127.0.0.1:x"};
    orr_service_options o = quick_options();
    orr_service *s;
    orr_diag diag = {0};
    o.url = url;
    o.n_urls = 2;
    assert_int_equal(orr_service_open(&o, &b->server, NULL, &s, &diag), ORR_E_IO);
    assert_non_null(strstr(diag.text, "another program"));
    o.url = bad;
    o.n_urls = 1;
    assert_int_equal(orr_service_open(&o, &b->server, NULL, &s, &diag), ORR_E_ARG);
    finish(b);
}

// An idle client gives its place to a new one; one that is asking keeps it.
static void the_idle_give_way(void **state)
{
    (void)state;
    orr_service_options o = quick_options();
    o.max_clients = 2;
    o.spare_s = 0;
    bench *b = start(o, 1);
    orr_dial *idle = dial(b), *one = dial(b);
    orr_frame f;
    assert_int_equal(orr_client_check(&idle->client, 1), ORR_WIRE_OK);
    assert_int_equal(orr_client_check(&one->client, 1), ORR_WIRE_OK);
    orr_dial *other = dial(b);
    assert_int_equal(orr_client_check(&other->client, 1), ORR_WIRE_OK);
    assert_int_equal(orr_client_answer(&idle->client, ORR_MSG_TYPE_PONG, &f), ORR_WIRE_REFUSED);
    assert_int_equal(idle->client.error_code, ORR_MSG_ERROR_CODE_BUSY);
    assert_int_equal(orr_client_check(&one->client, 1), ORR_WIRE_OK);
    assert_true(was_said(b, "its place is needed"));
    orr_dial_close(idle);
    // A crowd that says nothing at all holds nobody up.
    int silent[20];
    for (int k = 0; k < 20; k++) silent[k] = raw(b);
    orr_dial *late = dial(b);
    assert_int_equal(orr_client_check(&late->client, 1), ORR_WIRE_OK);
    for (int k = 0; k < 20; k++) close(silent[k]);
    orr_dial_close(late);
    orr_dial_close(one);
    orr_dial_close(other);
    finish(b);
}

// A clock that work moves: each frame of a slow answer takes a tenth of a millisecond of it.
typedef struct workshop {
    int64_t now_ns;
    int n_light;          // polls of one frame answered
    int64_t heavy, until; // frames of long answers so far, and when the light poll was answered
} workshop;

static int64_t clock_of_work(void *user) { return ((workshop *)user)->now_ns; }

static uint16_t answer_by_work(void *user, const orr_msg_poll *poll, orr_server_part *part,
                               orr_wire_writer *w, orr_server_refusal *why)
{
    (void)why;
    workshop *x = user;
    x->now_ns += 100000;
    if (poll->epochs.count > 1)
        x->heavy++;
    else if (x->n_light++ == 0)
        x->until = x->heavy;
    orr_msg_states m = {.epoch = {poll->epochs.t, part->index, poll->epochs.count, ORR_MSG_ANSWER_OK}};
    orr_msg_states_encode(&m, w);
    return 0;
}

// Twenty clients whose answers take 20 x 2000 frames, asked before one that wants one frame: it is answered
// when each of them has had a few turns, long before they have what they want. Counted in frames.
static void long_answers_hold_nobody_up(void **state)
{
    (void)state;
    enum { HEAVY = 20, FRAMES = 2000 };
    workshop x = {.now_ns = 1000000000};
    const orr_msg_handlers handlers = {.poll = answer_by_work};
    const orr_server server = {.handlers = &handlers, .user = &x};
    orr_service_options o = quick_options();
    o.clock_ns = clock_of_work;
    o.clock_user = &x;
    orr_service *service;
    orr_diag diag = {0};
    ASSERT_OK(orr_service_open(&o, &server, NULL, &service, &diag), diag);
    bench b = {.service = service};
    // All have connected and asked before the loop begins, so that nothing depends on how fast it is.
    int heavy[HEAVY], light;
    uint8_t frame[100];
    for (int k = 0; k < HEAVY; k++) {
        heavy[k] = raw(&b);
        size_t n = poll_frame(frame, sizeof frame, 1, FRAMES);
        assert_int_equal(send(heavy[k], frame, n, 0), (ssize_t)n);
    }
    light = raw(&b);
    size_t n = poll_frame(frame, sizeof frame, 1, 1);
    assert_int_equal(send(light, frame, n, 0), (ssize_t)n);
    assert_int_equal(pthread_create(&b.thread, NULL, serve, &b), 0);
    uint8_t answer[1000];
    assert_true(recv(light, answer, sizeof answer, 0) > 0);
    assert_true(x.until <= HEAVY * 20);
    for (int k = 0; k < HEAVY; k++) close(heavy[k]);
    close(light);
    orr_service_stop(service);
    void *result;
    pthread_join(b.thread, &result);
    assert_null(result);
    orr_service_close(service);
}

// Garbage from a crowd is told at a limited rate, and what was left out is counted.
static void a_crowd_fills_no_log(void **state)
{
    (void)state;
    workshop still = {.now_ns = 1000000000};
    orr_service_options o = quick_options();
    o.clock_ns = clock_of_work;
    o.clock_user = &still;
    bench *b = start(o, 1);
    uint8_t buf[1000];
    for (int k = 0; k < 60; k++) {
        int fd = raw(b);
        assert_int_equal(send(fd, "X", 1, 0), 1);
        assert_int_equal(error_code(buf, read_to_end(fd, buf, sizeof buf)), ORR_MSG_ERROR_CODE_BAD_MAGIC);
        close(fd);
    }
    pthread_mutex_lock(&b->lock);
    int lines = 0;
    for (const char *p = b->talk; (p = strstr(p, "BAD_MAGIC")) != NULL; p++) lines++;
    pthread_mutex_unlock(&b->lock);
    assert_int_equal(lines, 20);
    finish(b);
}

// Blocks that came while something else was waited for.
typedef struct heard {
    uint32_t stream, blocks;
    int64_t next;
} heard;

static void hear(void *user, const orr_frame *f)
{
    heard *h = user;
    orr_msg_states m;
    assert_int_equal(f->type, ORR_MSG_TYPE_STATES);
    assert_int_equal(f->sequence, h->stream);
    assert_int_equal(orr_msg_states_decode(f->payload, f->size, &m), ORR_WIRE_OK);
    assert_int_equal(m.epoch.t, h->next);
    h->next += 1000000;
    h->blocks++;
}

// The C client: a stream as fast as it is taken, and polls beside it; then frame by frame to its end. Frames of a stream may come
// before an answer that was asked for earlier, so the credit of the last blocks is kept until all polls are answered.
static void streams_beside_polls(void **state)
{
    (void)state;
    bench *b = calloc(1, sizeof *b);
    b->fake.n_sats = 20;
    fake maker_fake = {.n_sats = 20};
    const orr_server maker = fake_server(&maker_fake);
    orr_streams *streams;
    orr_diag diag = {0};
    b->server = fake_server(&b->fake);
    b->server.lanes = true;
    pthread_mutex_init(&b->lock, NULL);
    orr_service_options o = quick_options();
    ASSERT_OK(orr_service_open(&o, &b->server, NULL, &b->service, &diag), diag);
    const orr_streams_options so = {
        .maker = &maker, .wake = orr_service_wake, .wake_user = b->service, .processor = -1};
    ASSERT_OK(orr_streams_open(&so, &streams, &diag), diag);
    orr_service_stream(b->service, streams);
    assert_int_equal(pthread_create(&b->thread, NULL, serve, b), 0);
    orr_dial *d = dial(b);
    uint8_t payload[64];
    orr_wire_writer w = {payload, 0, sizeof payload, ORR_WIRE_OK};
    const orr_msg_poll asked = {.epochs = {1000, 1000000, 5010}};
    orr_msg_poll_encode(&asked, &w);
    const orr_msg_subscribe subscribe = {
        .request = ORR_MSG_TYPE_POLL, .credit = 3000, .poll = {payload, (uint16_t)w.size}};
    orr_msg_subscribed told;
    assert_int_equal(orr_client_subscribe(&d->client, &subscribe, &told), ORR_WIRE_OK);
    assert_true(told.first == 1000 && told.step == 1000000);
    heard h = {.stream = d->client.sequence, .next = told.first};
    d->client.stream = hear;
    d->client.stream_user = &h;
    for (uint32_t n = 0; n < 200; n++) {
        const orr_msg_poll poll = {.epochs = {7, 3, 2}};
        orr_msg_states m;
        assert_int_equal(orr_client_poll(&d->client, &poll), ORR_WIRE_OK);
        const orr_msg_credit more = {h.stream, 10}; // in the middle of the answer
        assert_int_equal(orr_client_credit(&d->client, &more), ORR_WIRE_OK);
        for (uint32_t k = 0; k < 2; k++) {
            assert_int_equal(orr_client_states(&d->client, &m), ORR_WIRE_OK);
            assert_int_equal(m.epoch.t, 7 + 3 * k);
        }
    }
    const orr_msg_credit last = {h.stream, 10};
    assert_int_equal(orr_client_credit(&d->client, &last), ORR_WIRE_OK);
    orr_frame f;
    assert_int_equal(orr_client_next(&d->client, &f), ORR_WIRE_OK);
    while (f.type != ORR_MSG_TYPE_STREAM_END) {
        hear(&h, &f);
        assert_int_equal(orr_client_next(&d->client, &f), ORR_WIRE_OK);
    }
    assert_int_equal(f.sequence, h.stream);
    assert_int_equal(h.blocks, 5010);
    assert_int_equal(orr_client_check(&d->client, 4), ORR_WIRE_OK);
    orr_dial_close(d);
    orr_streams_halt(streams);
    finish(b);
    orr_streams_close(streams);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(conversation),
        cmocka_unit_test(garbage_is_told_and_closed),
        cmocka_unit_test(half_frames_and_silence_time_out),
        cmocka_unit_test(a_client_that_does_not_read),
        cmocka_unit_test(disconnects_in_mid_answer),
        cmocka_unit_test(too_many_clients),
        cmocka_unit_test(a_half_closed_client_gets_its_answer),
        cmocka_unit_test(stopping_drains),
        cmocka_unit_test(addresses_that_cannot_be_listened_on),
        cmocka_unit_test(the_idle_give_way),
        cmocka_unit_test(long_answers_hold_nobody_up),
        cmocka_unit_test(a_crowd_fills_no_log),
        cmocka_unit_test(streams_beside_polls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
