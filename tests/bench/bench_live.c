// SPDX-License-Identifier: GPL-3.0-or-later
// Live: from motion in to block out beside an echo of the same sizes, a stream of 1 kHz beside a bare timer, and 64 subscribers whose every
// block is compared with direct evaluation, one frozen client among them. Each in one process over TCP loopback, beside what bounds it. Lengths
// are seconds by default; ORRERY_BENCH_SECONDS sets them (of ten minutes: ORRERY_BENCH_SECONDS=600 orr_bench live_timer).
#define _GNU_SOURCE
#include <math.h>
#include <poll.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include "bench/bench.h"
#include "src/scenario/engine/engine.h"
#include "src/service/answers/answers.h"
#include "src/service/live/ring_made.h"
#include "src/service/net/dial.h"
#include "src/service/net/url.h"
#include "src/service/serve/service.h"

enum { MOTIONS = 4000, SUBSCRIBERS = 64 };
static const int64_t MS = 1000000;

static void must(bool good, const char *what)
{
    if (good) return;
    fprintf(stderr, "bench_live: %s\n", what);
    exit(1);
}

static int64_t now_ns(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (int64_t)t.tv_sec * ORR_NS_PER_S + t.tv_nsec;
}

static void sleep_until(int64_t ns)
{
    const struct timespec t = {ns / ORR_NS_PER_S, ns % ORR_NS_PER_S};
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, NULL);
}

static double seconds(double usual)
{
    const char *text = getenv("ORRERY_BENCH_SECONDS");
    return text != NULL ? atof(text) : usual;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// A service with streams and a body, and its threads.
typedef struct live {
    orr_engine *engine;
    orr_answers *answers, *maker, *direct;
    orr_vehicle *vehicle;
    orr_streams *streams;
    orr_service *service;
    pthread_t thread;
    orr_time begin;
} live;

static void *run_service(void *user)
{
    orr_diag diag = {0};
    return orr_service_run(user, NULL, NULL, &diag) == ORR_OK ? NULL : user;
}

static void start(live *l)
{
    static const char text[] =
        "orbit: {sp3: ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz}\nnavdata: {window: none}\n"
        "ionosphere: {field: ionosphere.ION}\ntroposphere: {model: saastamoinen}\n"
        "signals: [\"G:L1CA\", \"G:L5\", \"R:L1OF\", \"E:E1\"]\nmask: {elevation: 0}\n"
        "trajectory: {kind: analytic, start: 2025-03-21T10:00:00, duration: 7200, lat: 56, lon: 40, height: "
        "150}\n"
        "antennas: [{name: A, up: 1}]\n";
    static const char *const url[] = {"tcp://127.0.0.1:0"};
    orr_scenario scenario;
    orr_diag diag = {0};
    must(orr_scenario_parse("bench", text, strlen(text), ORR_SOURCE_DIR "/samples", NULL, &scenario, &diag) ==
             ORR_OK,
         diag.text);
    must(orr_engine_open(&scenario, NULL, NULL, NULL, &l->engine, &diag) == ORR_OK, diag.text);
    orr_scenario_free(&scenario);
    orr_service_options o = orr_service_defaults();
    o.url = url;
    o.n_urls = 1;
    o.signals = false;
    const orr_vehicle_options v = {.join_s = 0.065, .length_ns = MS};
    must(orr_answers_open(l->engine, &l->answers, &diag) == ORR_OK &&
             orr_answers_open(l->engine, &l->maker, &diag) == ORR_OK &&
             orr_answers_look_ahead(l->maker, &diag) == ORR_OK &&
             orr_answers_open(l->engine, &l->direct, &diag) == ORR_OK &&
             orr_service_open(&o, orr_answers_server(l->answers), NULL, &l->service, &diag) == ORR_OK &&
             orr_vehicle_open(&v, &l->vehicle, &diag) == ORR_OK &&
             orr_answers_ride(l->maker, l->vehicle, &diag) == ORR_OK,
         diag.text);
    l->begin = 1426586400 * ORR_NS_PER_S + 60 * ORR_NS_PER_S; // 2025-03-21T10:01:00
    const orr_streams_options so = {.maker = orr_answers_server(l->maker),
                                    .expect = orr_answers_expect,
                                    .wake = orr_service_wake,
                                    .wake_user = l->service,
                                    .begin = l->begin,
                                    .vehicle = l->vehicle,
                                    .processor = -1};
    must(orr_streams_open(&so, &l->streams, &diag) == ORR_OK, diag.text);
    orr_service_stream(l->service, l->streams);
    pthread_create(&l->thread, NULL, run_service, l->service);
    const orr_msg_control go = {
        .action = ORR_MSG_CONTROL_ACTION_START, .t = ORR_TIME_NONE, .at = ORR_TIME_NONE};
    orr_msg_time told;
    orr_server_refusal why;
    must(orr_streams_control(l->streams, &go, &told, &why) == 0, why.sentence);
}

static void finish(live *l)
{
    orr_streams_halt(l->streams);
    orr_service_stop(l->service);
    pthread_join(l->thread, NULL);
    orr_service_close(l->service);
    orr_streams_close(l->streams);
    orr_answers_close(l->direct);
    orr_answers_close(l->maker);
    orr_answers_close(l->answers);
    orr_vehicle_close(l->vehicle);
    orr_engine_close(l->engine);
}

static orr_dial *dial(const live *l)
{
    orr_dial *d;
    orr_diag diag = {0};
    must(orr_dial_open(orr_service_url(l->service, 0), NULL, 30, &d, &diag) == ORR_OK, diag.text);
    return d;
}

static orr_time scenario_now(const live *l)
{
    orr_msg_time t;
    orr_streams_time(l->streams, &t);
    return t.t;
}

static uint32_t subscribe(orr_dial *d, uint8_t pacing, orr_time t, int64_t step, int64_t lead,
                          orr_time *first)
{
    uint8_t data[64];
    orr_wire_writer w = {data, 0, sizeof data, ORR_WIRE_OK};
    const orr_msg_poll_channels poll = {.epochs = {t, step, 0}};
    orr_msg_poll_channels_encode(&poll, &w);
    const orr_msg_subscribe m = {.request = ORR_MSG_TYPE_POLL_CHANNELS,
                                 .pacing = pacing,
                                 .credit = UINT32_MAX,
                                 .lead = lead,
                                 .poll = {data, (uint16_t)w.size}};
    orr_msg_subscribed told;
    must(orr_client_subscribe(&d->client, &m, &told) == ORR_WIRE_OK, d->client.sentence);
    *first = told.first;
    return d->client.sequence;
}

// --- Motion in, block out ---

typedef struct echo {
    int fd;
    size_t up, down;
} echo;

static bool recv_all(int fd, uint8_t *data, size_t n)
{
    for (size_t have = 0; have < n;) {
        const ssize_t got = recv(fd, data + have, n - have, 0);
        if (got <= 0) return false;
        have += (size_t)got;
    }
    return true;
}

static void *run_echo(void *user)
{
    static uint8_t data[ORR_DIAL_BUFFER];
    const echo *e = user;
    while (recv_all(e->fd, data, e->up))
        if (send(e->fd, data, e->down, MSG_NOSIGNAL) != (ssize_t)e->down) break;
    close(e->fd);
    return NULL;
}

static int echo_pair(echo *e, pthread_t *thread)
{
    orr_url u, bound;
    orr_diag diag = {0};
    int listener = -1, fd = -1;
    must(orr_url_parse("tcp://127.0.0.1:0", &u, &diag) == ORR_OK &&
             orr_url_listen(&u, 1, &listener, &bound, &diag) == ORR_OK &&
             orr_url_connect(&bound, 10, &fd, &diag) == ORR_OK,
         diag.text);
    struct pollfd ready = {.fd = listener, .events = POLLIN};
    must(poll(&ready, 1, 10000) == 1, "no client");
    e->fd = accept(listener, NULL, NULL);
    close(listener);
    pthread_create(thread, NULL, run_echo, e);
    return fd;
}

static orr_msg_motion still(orr_time t)
{
    const orr_vec3 r = orr_earth_to_ecef((orr_geodetic){56 * ORR_RAD_PER_DEG, 40 * ORR_RAD_PER_DEG, 150});
    return (orr_msg_motion){.t = t, .order = 2, .pos_m = {r.x, r.y, r.z}};
}

// From a sample to the block that begins at its tag; how many channels it has, and the frame's size.
static double one_motion(orr_dial *d, orr_time t, size_t *n, size_t *size)
{
    const orr_msg_motion m = still(t);
    orr_frame f;
    orr_msg_channels c;
    const int64_t begin = now_ns();
    must(orr_client_motion(&d->client, &m) == ORR_WIRE_OK, "motion");
    do {
        must(orr_client_next(&d->client, &f) == ORR_WIRE_OK && f.type == ORR_MSG_TYPE_CHANNELS &&
                 orr_msg_channels_decode(f.payload, f.size, &c) == ORR_WIRE_OK,
             "no block");
    } while (c.epoch.t < t);
    *n = c.channels.count;
    *size = f.size + ORR_FRAME_OVERHEAD;
    return (double)(now_ns() - begin) / 1e3;
}

static double epoch_us(const live *l, orr_time from)
{
    const orr_server *s = orr_answers_server(l->direct);
    static uint8_t room[ORR_DIAL_BUFFER];
    static double took[1000];
    for (int k = 0; k < 1000; k++) {
        const orr_msg_any m = {.poll_channels = {.epochs = {from + k * 100 * MS, MS, 1}}};
        orr_server_part part = {.index = 0};
        orr_wire_writer w = {room, 0, sizeof room, ORR_WIRE_OK};
        orr_server_refusal why;
        const int64_t begin = now_ns();
        orr_msg_answer(s->handlers, s->user, ORR_MSG_TYPE_POLL_CHANNELS, &m, &part, &w, &why);
        took[k] = (double)(now_ns() - begin) / 1e3;
    }
    qsort(took, 1000, sizeof took[0], ascending);
    return took[500];
}

static void motion_rows(bench *b, live *l)
{
    static double us[MOTIONS], echo_us[MOTIONS];
    static uint8_t data[ORR_DIAL_BUFFER];
    orr_dial *d = dial(l);
    orr_time first;
    size_t n = 0, size = 0;
    const orr_msg_motion m = still(scenario_now(l));
    must(orr_client_motion(&d->client, &m) == ORR_WIRE_OK, "motion");
    const orr_time begin =
        scenario_now(l) + 5 * ORR_NS_PER_S; // ahead of the clock: blocks wait for motion alone
    subscribe(d, ORR_MSG_PACING_MOTION, begin - begin % MS, MS, 0, &first);
    for (int k = 0; k < 200; k++) (void)one_motion(d, first + k * MS, &n, &size);
    echo e = {.up = ORR_FRAME_OVERHEAD + ORR_MSG_MOTION_SIZE, .down = size};
    pthread_t thread;
    const int fd = echo_pair(&e, &thread);
    int64_t at = now_ns();
    for (int k = 0; k < MOTIONS; k++) { // 1 kHz, an echo in between
        sleep_until(at += MS / 2);
        us[k] = one_motion(d, first + (200 + k) * MS, &n, &size);
        sleep_until(at += MS / 2);
        const int64_t t0 = now_ns();
        must(send(fd, data, e.up, MSG_NOSIGNAL) == (ssize_t)e.up && recv_all(fd, data, e.down), "no echo");
        echo_us[k] = (double)(now_ns() - t0) / 1e3;
    }
    close(fd);
    pthread_join(thread, NULL);
    orr_dial_close(d);
    qsort(us, MOTIONS, sizeof us[0], ascending);
    qsort(echo_us, MOTIONS, sizeof echo_us[0], ascending);
    char name[120];
    static const int per_mille[] = {500, 990, 999};
    for (int k = 0; k < 3; k++) {
        snprintf(name, sizeof name, "motion in to block out, 1 kHz, %zu signals, %zu bytes, p%g", n, size,
                 per_mille[k] / 10.0);
        bench_row(b, name, us[MOTIONS * per_mille[k] / 1000], echo_us[MOTIONS * per_mille[k] / 1000], "us",
                  "echo of these sizes");
    }
    bench_note(b, "an engine epoch of these signals: %.1f us", epoch_us(l, l->begin + 600 * ORR_NS_PER_S));
}

// --- 1 kHz beside a bare timer ---

typedef struct timer {
    volatile bool stop;
    int64_t stalls;   // ms in which it woke more than 20 ms late
    int64_t at[4096]; // when
} timer;

static void *run_timer(void *user)
{
    timer *t = user;
    for (int64_t at = now_ns(); !t->stop; at += MS) {
        sleep_until(at);
        const int64_t late = now_ns() - at;
        if (late > 20 * MS && t->stalls < 4096) t->at[t->stalls++] = at;
        if (late > MS) at += late / MS * MS;
    }
    return NULL;
}

static bool has_stalled(const timer *t, int64_t at)
{
    bool has = false;
    for (int64_t k = 0; k < t->stalls; k++) has = has || llabs(t->at[k] - at) < 100 * MS;
    return has;
}

static void timer_rows(bench *b, live *l)
{
    static timer t;
    orr_dial *d = dial(l);
    const double length = seconds(10);
    orr_time first;
    orr_frame f;
    struct rusage u0, u1;
    pthread_t thread;
    int64_t missed = 0, stalled = 0, blocks = 0, left_out = 0;
    subscribe(d, ORR_MSG_PACING_CLOCK, ORR_TIME_NONE, MS, 20 * MS, &first);
    pthread_create(&thread, NULL, run_timer, &t);
    getrusage(RUSAGE_SELF, &u0);
    orr_msg_time now;
    orr_streams_time(l->streams, &now);
    const int64_t base = now.host - now.t; // host less scenario: nothing paces it but the host
    const int64_t end = now_ns() + (int64_t)(length * 1e9);
    while (now_ns() < end) {
        must(orr_client_next(&d->client, &f) == ORR_WIRE_OK, "no block");
        const int64_t arrived = now_ns();
        int64_t lost = 0, air = 0;
        if (f.type == ORR_MSG_TYPE_GAP) {
            orr_msg_gap g;
            must(orr_msg_gap_decode(f.payload, f.size, &g) == ORR_WIRE_OK, "gap");
            lost = (int64_t)g.blocks;
            left_out += lost;
            air = g.last + base;
        } else {
            must(f.type == ORR_MSG_TYPE_CHANNELS, "the stream ended");
            air = orr_wire_load_i64(f.payload) + base;
            lost = arrived > air;
        }
        blocks += f.type == ORR_MSG_TYPE_GAP ? lost : 1;
        missed += lost;
        if (lost > 0 && has_stalled(&t, air)) stalled += lost;
    }
    getrusage(RUSAGE_SELF, &u1);
    t.stop = true;
    pthread_join(thread, NULL);
    orr_dial_close(d);
    const double cpu =
        (double)(u1.ru_utime.tv_sec - u0.ru_utime.tv_sec + u1.ru_stime.tv_sec - u0.ru_stime.tv_sec) +
        (double)(u1.ru_utime.tv_usec - u0.ru_utime.tv_usec + u1.ru_stime.tv_usec - u0.ru_stime.tv_usec) *
            1e-6;
    char name[120];
    snprintf(name, sizeof name, "1 kHz at 20 ms lead for %.0f s: blocks missed of %lld", length,
             (long long)blocks);
    bench_row(b, name, (double)(missed - stalled), 0, "", "");
    bench_note(b,
               "and %lld within 100 ms of when a bare timer woke 20 ms late (%lld times); %lld of all left "
               "out, the others "
               "late on air; processor %.0f %% of one, all threads and the client",
               (long long)stalled, (long long)t.stalls, (long long)left_out, 100 * cpu / length);
}

// --- 64 subscribers, every block compared ---

static void crowd_rows(bench *b, live *l)
{
    static orr_dial *d[SUBSCRIBERS];
    static uint8_t room[ORR_DIAL_BUFFER];
    orr_time first = 0, t[SUBSCRIBERS];
    const orr_server *s = orr_answers_server(l->direct);
    const double length = seconds(10);
    orr_dial *frozen = dial(l);
    for (int k = 0; k < 8; k++)
        subscribe(frozen, ORR_MSG_PACING_CLOCK, ORR_TIME_NONE, MS, 0, &first); // and never reads on
    for (int k = 0; k < SUBSCRIBERS; k++) {
        d[k] = dial(l);
        subscribe(d[k], ORR_MSG_PACING_CLOCK, ORR_TIME_NONE, 10 * MS, 0, &t[k]);
    }
    long blocks = 0, wrong = 0, gaps = 0;
    double worst_ms = 0;
    orr_time made = ORR_TIME_NONE;
    size_t size = 0;
    orr_msg_time now;
    orr_streams_time(l->streams, &now);
    const int64_t base = now.host - now.t, end = now_ns() + (int64_t)(length * 1e9);
    while (now_ns() < end)
        for (int k = 0; k < SUBSCRIBERS; k++) {
            orr_frame f;
            must(orr_client_next(&d[k]->client, &f) == ORR_WIRE_OK, "no block");
            if (f.type == ORR_MSG_TYPE_GAP) {
                orr_msg_gap g;
                must(orr_msg_gap_decode(f.payload, f.size, &g) == ORR_WIRE_OK, "gap");
                t[k] = g.last + 10 * MS;
                gaps++;
                k--;
                continue;
            }
            must(f.type == ORR_MSG_TYPE_CHANNELS, "a stream ended");
            worst_ms = fmax(worst_ms, (double)(now_ns() - base - t[k]) / 1e6);
            if (made != t[k]) {
                const orr_msg_any m = {.poll_channels = {.epochs = {t[k], 10 * MS, 1}}};
                orr_server_part part = {.index = 0};
                orr_wire_writer w = {room, 0, sizeof room, ORR_WIRE_OK};
                orr_server_refusal why;
                must(orr_msg_answer(s->handlers, s->user, ORR_MSG_TYPE_POLL_CHANNELS, &m, &part, &w, &why) ==
                         0,
                     why.sentence);
                made = t[k];
                size = w.size;
            }
            wrong += f.size != size || memcmp(f.payload, room, size) != 0;
            blocks++;
            t[k] += 10 * MS;
        }
    for (int k = 0; k < SUBSCRIBERS; k++) orr_dial_close(d[k]);
    orr_dial_close(frozen);
    char name[120];
    snprintf(name, sizeof name,
             "64 subscribers x 100 Hz for %.0f s, one client frozen: blocks unlike direct evaluation of %ld",
             length, blocks);
    bench_row(b, name, (double)wrong, 0, "", "");
    bench_note(b, "%ld gaps; the oldest block was %.1f ms behind its instant when it was compared", gaps,
               worst_ms);
}

// --- The ring beside a bare hand-over ---

enum { HANDED = 20000, HANDED_BYTES = 5120 }; // a block of 40 signals

// One thread hands buffers to another on a second processor, by turns through the ring and through one buffer with a flag.
typedef struct handing {
    orr_ring_made ring;
    _Alignas(64) _Atomic uint64_t flag;
    _Alignas(64) uint8_t buffer[HANDED_BYTES];
    _Atomic uint64_t seen;
    double us[2][HANDED / 2];
} handing;

static void *take_all(void *user)
{
    handing *h = user;
    static uint8_t got[HANDED_BYTES];
    orr_ring r;
    uint16_t type;
    size_t n;
    must(orr_ring_open(&r, h->ring.ring.memory, orr_ring_size(ORR_RING_SLOTS, ORR_RING_STRIDE)), "no ring");
    for (uint64_t k = 0; k < HANDED; k++) {
        if (k % 2 == 0) {
            while (!orr_ring_read(&r, &type, got, sizeof got, &n)) {
            }
        } else {
            while (atomic_load_explicit(&h->flag, memory_order_acquire) != k) {
            }
            memcpy(got, h->buffer, sizeof got);
        }
        int64_t begin;
        memcpy(&begin, got, sizeof begin);
        h->us[k % 2][k / 2] = (double)(now_ns() - begin) / 1e3;
        atomic_store_explicit(&h->seen, k + 1, memory_order_release);
    }
    return NULL;
}

static void ring_rows(bench *b)
{
    static handing h;
    static uint8_t data[HANDED_BYTES];
    orr_diag diag = {0};
    pthread_t thread;
    must(orr_ring_made_open(&h.ring, &diag) == ORR_OK, diag.text);
    pthread_create(&thread, NULL, take_all, &h);
    for (uint64_t k = 0; k < HANDED; k++) {
        while (atomic_load_explicit(&h.seen, memory_order_acquire) != k) {
        }
        const int64_t begin = now_ns();
        memcpy(data, &begin, sizeof begin);
        if (k % 2 == 0) {
            must(orr_ring_made_write(&h.ring, ORR_MSG_TYPE_CHANNELS, data, sizeof data), "too large");
        } else {
            memcpy(h.buffer, data, sizeof data);
            atomic_store_explicit(&h.flag, k, memory_order_release);
        }
    }
    pthread_join(thread, NULL);
    for (int w = 0; w < 2; w++) qsort(h.us[w], HANDED / 2, sizeof h.us[w][0], ascending);
    char name[120];
    snprintf(name, sizeof name, "ring, publish to seen, %d bytes, p50", HANDED_BYTES);
    bench_row(b, name, h.us[0][HANDED / 4], h.us[1][HANDED / 4], "us", "bare hand-over between two cores");
    orr_ring_made_close(&h.ring);
}

static void with_live(bench *b, const char *title, void (*rows)(bench *b, live *l))
{
    live l = {.begin = 0};
    bench_group(b, title);
    start(&l);
    rows(b, &l);
    finish(&l);
}

void bench_live_ring(bench *b)
{
    bench_group(b, "live, through shared memory");
    ring_rows(b);
}

void bench_live_timer(bench *b) { with_live(b, "live, a stream of 1 kHz over TCP loopback", timer_rows); }
void bench_live_crowd(bench *b) { with_live(b, "live, 64 subscribers over TCP loopback", crowd_rows); }
void bench_live_motion(bench *b)
{
    with_live(b, "live, from motion in to block out over TCP loopback", motion_rows);
}
