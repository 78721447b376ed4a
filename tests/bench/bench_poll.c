// SPDX-License-Identifier: GPL-3.0-or-later
// A poll of all satellites, and one of all channels of an antenna, over TCP loopback, beside a bare echo of the same reply size: one client, one
// request at a time, both in turns of the same run, so that the machine's mood is the same for both. The echo
// answers a request of the same length with a prepared reply and looks at nothing; its client only counts
// bytes. The poll's client checks the frame and its checksum as any client does.
//
// Where the threads run matters more than what they do: a sleeping core takes tens of microseconds to wake.
// So both pairs are measured twice, client and server on one core, and on two.
#define _GNU_SOURCE // thread affinity
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include "bench/bench.h"
#include "src/scenario/engine/engine.h"
#include "src/service/answers/answers.h"
#include "src/service/net/dial.h"
#include "src/service/net/url.h"
#include "src/service/serve/service.h"

enum { ROUNDS = 60, TURN = 250, WARM_UP = 500 };

static double now_us(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e6 * (double)t.tv_sec + 1e-3 * (double)t.tv_nsec;
}

static void must(bool good, const char *what)
{
    if (good) return;
    fprintf(stderr, "bench_poll: %s\n", what);
    exit(1);
}

static bool recv_all(int fd, uint8_t *data, size_t n)
{
    for (size_t have = 0; have < n;) {
        ssize_t got = recv(fd, data + have, n - have, 0);
        if (got <= 0) return false;
        have += (size_t)got;
    }
    return true;
}

typedef struct echo {
    int listener;
    size_t request, reply;
    uint8_t data[ORR_DIAL_BUFFER];
} echo;

static void *run_echo(void *user)
{
    echo *e = user;
    uint8_t request[256];
    struct pollfd ready = {.fd = e->listener, .events = POLLIN}; // the listener does not block
    must(poll(&ready, 1, 10000) == 1, "no client");
    int fd = accept(e->listener, NULL, NULL);
    while (recv_all(fd, request, e->request))
        if (send(fd, e->data, e->reply, MSG_NOSIGNAL) != (ssize_t)e->reply) break;
    close(fd);
    return NULL;
}

static void *run_service(void *user)
{
    orr_diag diag = {0};
    return orr_service_run(user, NULL, NULL, &diag) == ORR_OK ? NULL : user;
}

// What is polled: a scenario, the request's length, and one exchange, which returns how many things it told.
typedef struct workload {
    const char *name, *scenario;
    size_t request;
    int64_t step_ns; // between polls
    size_t (*poll)(orr_dial *d, int64_t t);
} workload;

static size_t poll_states(orr_dial *d, int64_t t)
{
    orr_msg_poll poll = {.epochs = {.t = t, .count = 1}};
    orr_msg_states m;
    must(orr_client_poll(&d->client, &poll) == ORR_WIRE_OK &&
             orr_client_states(&d->client, &m) == ORR_WIRE_OK && m.epoch.answer == ORR_MSG_ANSWER_OK,
         "no answer");
    return m.satellites.count;
}

static size_t poll_channels(orr_dial *d, int64_t t)
{
    orr_msg_poll_channels poll = {.epochs = {.t = t, .count = 1}};
    orr_msg_channels m;
    must(orr_client_poll_channels(&d->client, &poll) == ORR_WIRE_OK &&
             orr_client_channels(&d->client, &m) == ORR_WIRE_OK && m.epoch.answer == ORR_MSG_ANSWER_OK,
         "no answer");
    return m.channels.count;
}

static double one_poll(orr_dial *d, const workload *w, int64_t t, size_t *told, size_t *reply)
{
    double begin = now_us();
    *told = w->poll(d, t);
    double took = now_us() - begin;
    must(*told > 0, "nothing was told");
    *reply = d->client.used;
    return took;
}

static double one_echo(int fd, const echo *e)
{
    static uint8_t data[ORR_DIAL_BUFFER], request[256];
    double begin = now_us();
    must(send(fd, request, e->request, MSG_NOSIGNAL) == (ssize_t)e->request && recv_all(fd, data, e->reply),
         "no echo");
    return now_us() - begin;
}

// The first two processors that this process may use; false if there is only one.
static bool two_processors(int cpu[2])
{
    cpu_set_t set;
    int n = 0;
    must(sched_getaffinity(0, sizeof set, &set) == 0, "no affinity");
    for (int k = 0; k < CPU_SETSIZE && n < 2; k++)
        if (CPU_ISSET((size_t)k, &set)) cpu[n++] = k;
    return n == 2;
}

static void pin(pthread_t thread, int cpu)
{
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET((size_t)cpu, &set);
    must(pthread_setaffinity_np(thread, sizeof set, &set) == 0, "a thread cannot be pinned");
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static int connect_to(const char *text)
{
    orr_url u;
    orr_diag diag = {0};
    int fd = -1;
    must(orr_url_parse(text, &u, &diag) == ORR_OK && orr_url_connect(&u, 10, &fd, &diag) == ORR_OK,
         diag.text);
    return fd;
}

static orr_engine *engine_of(const char *text)
{
    orr_scenario scenario;
    orr_engine *e;
    orr_diag diag = {0};
    must(orr_scenario_parse("bench", text, strlen(text), ORR_SOURCE_DIR "/samples", NULL, &scenario, &diag) ==
             ORR_OK,
         diag.text);
    must(orr_engine_open(&scenario, NULL, NULL, NULL, &e, &diag) == ORR_OK, diag.text);
    orr_scenario_free(&scenario);
    return e;
}

static void exchange(bench *b, const workload *w)
{
    static double poll_us[ROUNDS * TURN], echo_us[ROUNDS * TURN];
    static echo e;
    static const char *const url[] = {"tcp://127.0.0.1:0"};
    orr_diag diag = {0};
    orr_engine *engine = engine_of(w->scenario);
    orr_answers *answers;
    orr_service *service;
    orr_service_options options = orr_service_defaults();
    options.url = url;
    options.n_urls = 1;
    options.signals = false;
    must(orr_answers_open(engine, &answers, &diag) == ORR_OK, diag.text);
    must(orr_service_open(&options, orr_answers_server(answers), NULL, &service, &diag) == ORR_OK, diag.text);
    pthread_t service_thread, echo_thread;
    pthread_create(&service_thread, NULL, run_service, service);
    orr_dial *d;
    must(orr_dial_open(orr_service_url(service, 0), NULL, 10, &d, &diag) == ORR_OK, diag.text);
    orr_time from, to;
    size_t told;
    orr_engine_span(engine, &from, &to);
    from = orr_time_add(from, ORR_NS_PER_S);
    for (int k = 0; k < WARM_UP; k++) one_poll(d, w, from + k, &told, &e.reply);

    e.request = ORR_FRAME_OVERHEAD + w->request;
    orr_url loopback, bound;
    char text[ORR_URL_TEXT];
    must(orr_url_parse(url[0], &loopback, &diag) == ORR_OK, diag.text);
    must(orr_url_listen(&loopback, 1, &e.listener, &bound, &diag) == ORR_OK, diag.text);
    pthread_create(&echo_thread, NULL, run_echo, &e);
    int fd = connect_to(orr_url_text(&bound, text));
    for (int k = 0; k < WARM_UP; k++) one_echo(fd, &e);

    int cpu[2];
    bool two = two_processors(cpu);
    cpu_set_t before;
    must(pthread_getaffinity_np(pthread_self(), sizeof before, &before) == 0, "no affinity");
    pin(service_thread, cpu[0]);
    pin(echo_thread, cpu[0]);
    for (int place = 0; place < (two ? 2 : 1); place++) {
        pin(pthread_self(), cpu[place]);
        int n = 0;
        for (int round = 0; round < ROUNDS; round++, n += TURN) {
            for (int k = n; k < n + TURN; k++)
                poll_us[k] = one_poll(d, w, from + k * w->step_ns, &told, &e.reply);
            for (int k = n; k < n + TURN; k++) echo_us[k] = one_echo(fd, &e);
        }
        qsort(poll_us, ROUNDS * TURN, sizeof poll_us[0], ascending);
        qsort(echo_us, ROUNDS * TURN, sizeof echo_us[0], ascending);
        char name[96];
        const char *where = place == 0 ? "one core" : "two cores";
        snprintf(name, sizeof name, "poll of %zu %s, %zu bytes, %s, p50", told, w->name, e.reply, where);
        bench_row(b, name, poll_us[n / 2], echo_us[n / 2], "us", "bare echo of that size");
        snprintf(name, sizeof name, "the same, p99");
        bench_row(b, name, poll_us[n * 99 / 100], echo_us[n * 99 / 100], "us", "bare echo of that size");
    }
    must(pthread_setaffinity_np(pthread_self(), sizeof before, &before) == 0, "no affinity");

    close(fd);
    orr_dial_close(d);
    pthread_join(echo_thread, NULL);
    orr_service_stop(service);
    pthread_join(service_thread, NULL);
    orr_service_close(service);
    orr_answers_close(answers);
    orr_engine_close(engine);
    close(e.listener);
}

void bench_poll(bench *b)
{
    static const workload loads[] = {
        {.name = "satellites",
         .scenario = "orbit: {sp3: ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz}\nnavdata: {window: none}\n",
         .request = 24, // a POLL that names no satellite
         .step_ns = 5 * ORR_NS_PER_S,
         .poll = poll_states},
        {.name = "channels",
         .scenario =
             "orbit: {sp3: ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz}\nnavdata: {window: none}\n"
             "ionosphere: {field: ionosphere.ION}\ntroposphere: {model: saastamoinen}\n"
             "signals: [\"G:L1CA\", \"G:L2C\", \"G:L5\", \"R:L1OF\", \"R:L2OF\", \"R:L3OC\", \"E:E1\", "
             "\"E:E5a\", \"E:E5b\"]\nmask: {elevation: 0}\nantennas: [{name: A, position: [56, 40, 150]}]\n",
         .request = 28,
         .step_ns = ORR_NS_PER_S,
         .poll = poll_channels},
    };
    bench_group(b, "service over TCP loopback");
    for (size_t k = 0; k < sizeof loads / sizeof *loads; k++) exchange(b, &loads[k]);
}
