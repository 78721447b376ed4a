// SPDX-License-Identifier: GPL-3.0-or-later
// A service over real sockets with a made-up answerer, in a thread of the test's own.
#ifndef ORR_TESTS_UNIT_SERVICE_SERVED_H
#define ORR_TESTS_UNIT_SERVICE_SERVED_H

#include <errno.h>
#include <pthread.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include "fake.h"
#include "src/service/net/dial.h"
#include "src/service/net/url.h"
#include "src/service/serve/service.h"
#include "testing.h"

typedef struct bench {
    fake fake;
    orr_server server;
    orr_service *service;
    pthread_t thread;
    orr_log log;
    pthread_mutex_t lock;
    char talk[8000]; // what was logged
} bench;

static inline void note(void *user, orr_log_level level, const char *line)
{
    (void)level;
    bench *b = user;
    pthread_mutex_lock(&b->lock);
    size_t n = strlen(b->talk);
    snprintf(b->talk + n, sizeof b->talk - n, "%s\n", line);
    pthread_mutex_unlock(&b->lock);
}

static inline bool was_said(bench *b, const char *words)
{
    pthread_mutex_lock(&b->lock);
    bool found = strstr(b->talk, words) != NULL;
    pthread_mutex_unlock(&b->lock);
    return found;
}

// The same, said a moment later at the latest.
static inline bool said_soon(bench *b, const char *words)
{
    const struct timespec pause = {0, 10000000};
    for (int k = 0; k < 1000 && !was_said(b, words); k++) nanosleep(&pause, NULL);
    return was_said(b, words);
}

static inline void *serve(void *user)
{
    bench *b = user;
    orr_diag diag = {0};
    return orr_service_run(b->service, NULL, NULL, &diag) == ORR_OK ? NULL : user;
}

static inline orr_service_options quick_options(void)
{
    orr_service_options o = orr_service_defaults();
    static const char *const url[] = {"tcp://127.0.0.1:0"};
    o.url = url;
    o.n_urls = 1;
    o.signals = false;
    return o;
}

static inline bench *start(orr_service_options o, uint16_t n_sats)
{
    bench *b = calloc(1, sizeof *b);
    b->fake.n_sats = n_sats;
    b->server = fake_server(&b->fake);
    b->log = (orr_log){ORR_LOG_WARN, note, b};
    pthread_mutex_init(&b->lock, NULL);
    orr_diag diag = {0};
    ASSERT_OK(orr_service_open(&o, &b->server, &b->log, &b->service, &diag), diag);
    assert_int_equal(pthread_create(&b->thread, NULL, serve, b), 0);
    return b;
}

static inline void finish(bench *b)
{
    void *result;
    orr_service_stop(b->service);
    pthread_join(b->thread, &result);
    assert_null(result);
    orr_service_close(b->service);
    free(b);
}

static inline orr_dial *dial(const bench *b)
{
    orr_dial *d;
    orr_diag diag = {0};
    ASSERT_OK(orr_dial_open(orr_service_url(b->service, 0), NULL, 10, &d, &diag), diag);
    return d;
}

static inline int raw(const bench *b)
{
    orr_url u;
    orr_diag diag = {0};
    int fd;
    assert_int_equal(orr_url_parse(orr_service_url(b->service, 0), &u, &diag), ORR_OK);
    ASSERT_OK(orr_url_connect(&u, 10, &fd, &diag), diag);
    return fd;
}

// All bytes until the server closes.
static inline size_t read_to_end(int fd, uint8_t *buf, size_t n)
{
    size_t have = 0;
    for (;;) {
        ssize_t got = recv(fd, buf + have, n - have, 0);
        assert_true(got >= 0); // not a reset, not a time-out
        if (got == 0) return have;
        have += (size_t)got;
    }
}

static inline uint16_t error_code(const uint8_t *data, size_t n)
{
    orr_frame f;
    size_t used;
    orr_msg_error e;
    if (orr_frame_parse(data, n, ORR_MSG_MAX_PAYLOAD, &f, &used) != ORR_WIRE_OK ||
        f.type != ORR_MSG_TYPE_ERROR || orr_msg_error_decode(f.payload, f.size, &e) != ORR_WIRE_OK)
        return 0;
    return e.code;
}

static inline size_t poll_frame(uint8_t *buf, size_t n, int64_t t, uint32_t count)
{
    orr_wire_writer w = {buf, 0, n, ORR_WIRE_OK};
    orr_msg_poll m = {.epochs = {t, 1, count}};
    size_t start_;
    orr_frame_begin(&w, ORR_MSG_TYPE_POLL, 1, &start_);
    orr_msg_poll_encode(&m, &w);
    orr_frame_end(&w, start_);
    return w.size;
}

#endif
