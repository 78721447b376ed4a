// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/generator/record/writer.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define SLICE_S 0.01
#define LATE_S 0.001
#define BUFFERS 2

typedef struct buffer {
    uint8_t *data;
    size_t capacity, size; // size > 0: to be written
} buffer;

struct orr_gen_writer {
    int fd;
    char path[1024];
    double pace_bytes_s;
    pthread_t thread;
    pthread_mutex_t lock;
    pthread_cond_t change;
    buffer buffer[BUFFERS];
    size_t filling, writing; // buffers, by turns
    bool ending, failed;
    orr_gen_written written;
    struct timespec begun; // with pace
    orr_gen_fault fault;
};

static double since(const struct timespec *t)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)(now.tv_sec - t->tv_sec) + 1e-9 * (double)(now.tv_nsec - t->tv_nsec);
}

static void pace(orr_gen_writer *w)
{
    if (w->written.bytes == 0) clock_gettime(CLOCK_MONOTONIC, &w->begun);
    const double due = (double)w->written.bytes / w->pace_bytes_s, late = since(&w->begun) - due;
    if (late < 0) {
        const double s = -late;
        const struct timespec t = {(time_t)s, (long)((s - (double)(time_t)s) * 1e9)};
        nanosleep(&t, NULL);
        return;
    }
    pthread_mutex_lock(&w->lock);
    if (late > LATE_S) w->written.underruns++;
    if (late > w->written.latest_s) w->written.latest_s = late;
    pthread_mutex_unlock(&w->lock);
}

static bool write_out(orr_gen_writer *w, const uint8_t *data, size_t size)
{
    const size_t slice = w->pace_bytes_s > 0 ? (size_t)(w->pace_bytes_s * SLICE_S) + 1 : (size_t)1 << 20;
    size_t in_slice = 0;
    for (size_t done = 0; done < size;) {
        if (w->pace_bytes_s > 0 && in_slice == 0) pace(w);
        const size_t left = slice - in_slice, n = size - done < left ? size - done : left;
        const ssize_t wrote = write(w->fd, data + done, n);
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote <= 0) {
            const int why = wrote < 0 ? errno : ENOSPC;
            return orr_gen_fail(&w->fault, "%s: %s after %llu bytes", w->path,
                                why == EPIPE ? "whoever reads the samples has closed the pipe"
                                             : strerror(why),
                                (unsigned long long)w->written.bytes);
        }
        done += (size_t)wrote;
        in_slice = (in_slice + (size_t)wrote) % slice;
        pthread_mutex_lock(&w->lock);
        w->written.bytes += (uint64_t)wrote;
        pthread_mutex_unlock(&w->lock);
    }
    return true;
}

static void *run(void *user)
{
    orr_gen_writer *w = user;
    pthread_mutex_lock(&w->lock);
    for (;;) {
        buffer *b = &w->buffer[w->writing];
        while (b->size == 0 && !w->ending) pthread_cond_wait(&w->change, &w->lock);
        if (b->size == 0) break;
        const size_t size = b->size;
        pthread_mutex_unlock(&w->lock);
        const bool good = write_out(w, b->data, size);
        pthread_mutex_lock(&w->lock);
        b->size = 0;
        w->writing = (w->writing + 1) % BUFFERS;
        if (!good) w->failed = true;
        pthread_cond_broadcast(&w->change);
        if (!good) break;
    }
    pthread_mutex_unlock(&w->lock);
    return NULL;
}

bool orr_gen_writer_open(const char *path, double pace_bytes_s, orr_gen_writer **writer, orr_gen_fault *fault)
{
    orr_gen_writer *w = calloc(1, sizeof *w);
    *writer = NULL;
    if (w == NULL) return orr_gen_fail(fault, "out of memory");
    const bool out = strcmp(path, "-") == 0;
    snprintf(w->path, sizeof w->path, "%s", out ? "standard output" : path);
    w->pace_bytes_s = pace_bytes_s;
    w->fd = out ? STDOUT_FILENO : open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (w->fd < 0) {
        orr_gen_fail(fault, "%s cannot be written: %s", path, strerror(errno));
        free(w);
        return false;
    }
    pthread_mutex_init(&w->lock, NULL);
    pthread_cond_init(&w->change, NULL);
    if (pthread_create(&w->thread, NULL, run, w) != 0) {
        if (!out) close(w->fd);
        free(w);
        return orr_gen_fail(fault, "a thread cannot be started");
    }
    *writer = w;
    return true;
}

uint8_t *orr_gen_writer_buffer(orr_gen_writer *writer, size_t size)
{
    orr_gen_writer *w = writer;
    pthread_mutex_lock(&w->lock);
    buffer *b = &w->buffer[w->filling];
    while (b->size > 0 && !w->failed) pthread_cond_wait(&w->change, &w->lock);
    const bool good = !w->failed;
    pthread_mutex_unlock(&w->lock);
    if (!good) return NULL;
    if (b->capacity < size) {
        free(b->data);
        b->data = malloc(size);
        b->capacity = b->data != NULL ? size : 0;
        if (b->data == NULL) orr_gen_fail(&w->fault, "out of memory");
    }
    return b->data;
}

void orr_gen_writer_submit(orr_gen_writer *writer, size_t size)
{
    orr_gen_writer *w = writer;
    pthread_mutex_lock(&w->lock);
    w->buffer[w->filling].size = size;
    if (size > 0) w->filling = (w->filling + 1) % BUFFERS;
    pthread_cond_broadcast(&w->change);
    pthread_mutex_unlock(&w->lock);
}

orr_gen_written orr_gen_writer_done(orr_gen_writer *writer)
{
    pthread_mutex_lock(&writer->lock);
    const orr_gen_written done = writer->written;
    pthread_mutex_unlock(&writer->lock);
    return done;
}

bool orr_gen_writer_close(orr_gen_writer *writer, bool abandon, orr_gen_written *written,
                          orr_gen_fault *fault)
{
    orr_gen_writer *w = writer;
    pthread_mutex_lock(&w->lock);
    w->ending = true;
    if (abandon)
        for (size_t k = 0; k < BUFFERS; k++)
            if (k != w->writing) w->buffer[k].size = 0;
    pthread_cond_broadcast(&w->change);
    pthread_mutex_unlock(&w->lock);
    pthread_join(w->thread, NULL);
    bool good = w->fault.text[0] == '\0';
    if (w->fd != STDOUT_FILENO && close(w->fd) != 0 && good)
        good = orr_gen_fail(&w->fault, "%s: %s", w->path, strerror(errno));
    *written = w->written;
    if (!good) *fault = w->fault;
    pthread_mutex_destroy(&w->lock);
    pthread_cond_destroy(&w->change);
    for (size_t k = 0; k < BUFFERS; k++) free(w->buffer[k].data);
    free(w);
    return good;
}
