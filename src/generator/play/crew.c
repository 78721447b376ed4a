// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/generator/play/crew.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#define MOST_THREADS 64

// A piece that a thread is at, and what of its channels is still to be had. All but the sums is guarded by the crew's lock.
typedef struct work {
    orr_gen_task *task; // NULL: none
    orr_gen_span span;
    size_t next;     // channel of the block: those from there on nobody has
    double most;     // that the sum of the groups so far can be
    unsigned others; // threads that are at a group of it
    pthread_mutex_t lock;
    bool summed; // whether sums hold anything, both under `lock`
    _Alignas(64) int32_t sum_re[ORR_GEN_PIECE];
    _Alignas(64) int32_t sum_im[ORR_GEN_PIECE];
} work;

typedef struct member {
    orr_gen_crew *crew;
    size_t number;
    orr_gen_worker worker;
    work work;
    uint8_t aside[8 * ORR_GEN_PIECE]; // of a piece that is not wanted whole
} member;

struct orr_gen_crew {
    unsigned n;
    member *member[MOST_THREADS];
    // What is being played.
    const orr_gen_block *block;
    size_t n_blocks, n_tasks;
    orr_gen_task *task;
    pthread_mutex_t lock;
    pthread_cond_t group_done;
};

bool orr_gen_crew_open(unsigned threads, orr_gen_crew **crew, orr_gen_fault *fault)
{
    orr_gen_crew *c = calloc(1, sizeof *c);
    *crew = c;
    if (c == NULL) return orr_gen_fail(fault, "out of memory");
    pthread_mutex_init(&c->lock, NULL);
    pthread_cond_init(&c->group_done, NULL);
    for (; c->n < threads && c->n < MOST_THREADS; c->n++) {
        member *m = aligned_alloc(_Alignof(member), sizeof *m);
        if (m == NULL) return orr_gen_fail(fault, "out of memory");
        memset(m, 0, sizeof *m);
        m->crew = c;
        m->number = c->n;
        pthread_mutex_init(&m->work.lock, NULL);
        c->member[c->n] = m;
    }
    return true;
}

void orr_gen_crew_close(orr_gen_crew *crew)
{
    if (crew == NULL) return;
    for (unsigned k = 0; k < crew->n; k++) {
        pthread_mutex_destroy(&crew->member[k]->work.lock);
        free(crew->member[k]);
    }
    pthread_cond_destroy(&crew->group_done);
    pthread_mutex_destroy(&crew->lock);
    free(crew);
}

static int64_t end_of(const orr_gen_block *b, const orr_gen_stream *s)
{
    return orr_gen_first_sample(b->begin_ns + b->length_ns, orr_gen_stream_plan_of(s)->rate_hz);
}

// --- What is to be had: under the crew's lock ---

// The next piece that nobody has, of a member's own stream before the others.
static bool take_piece(member *m)
{
    orr_gen_crew *c = m->crew;
    for (size_t k = 0; k < c->n_tasks; k++) {
        orr_gen_task *t = &c->task[(m->number + k) % c->n_tasks];
        if (t->at >= t->to || t->at_block >= c->n_blocks) continue;
        const orr_gen_block *b = &c->block[t->at_block];
        m->work.task = t;
        m->work.span = orr_gen_stream_span(t->stream, b, t->at);
        m->work.next = 0;
        m->work.most = 0;
        m->work.summed = false;
        t->at = m->work.span.first + m->work.span.n;
        if (t->at >= end_of(b, t->stream)) t->at_block++;
        return true;
    }
    return false;
}

// The next group of channels of a piece; false where all are taken.
static bool take_group(work *w, size_t *from, size_t *to)
{
    if (w->task == NULL || w->next >= w->span.block->n) return false;
    *from = w->next;
    *to = w->next = orr_gen_stream_group(w->task->stream, w->span.block, w->next, &w->most);
    return true;
}

// A group of a piece that another is at.
static work *take_from_others(member *m, size_t *from, size_t *to)
{
    const orr_gen_crew *c = m->crew;
    for (unsigned k = 1; k < c->n; k++) {
        work *w = &c->member[(m->number + k) % c->n]->work;
        if (!take_group(w, from, to)) continue;
        w->others++;
        return w;
    }
    return NULL;
}

// --- Playing ---

static void add(work *w, const orr_gen_worker *worker)
{
    pthread_mutex_lock(&w->lock);
    orr_gen_stream_add(w->task->stream, &w->span, !w->summed, worker, w->sum_re, w->sum_im);
    w->summed = true;
    pthread_mutex_unlock(&w->lock);
}

// All groups of the member's piece that no other takes. True where the last of the piece is left in the worker, not yet added.
static bool play_groups(member *m)
{
    work *w = &m->work;
    bool held = false, more = true;
    while (more) {
        size_t from, to;
        pthread_mutex_lock(&m->crew->lock);
        more = take_group(w, &from, &to);
        while (!more && w->others > 0) pthread_cond_wait(&m->crew->group_done, &m->crew->lock);
        pthread_mutex_unlock(&m->crew->lock);
        if (!more) break;
        if (held) add(w, &m->worker);
        orr_gen_stream_mix(w->task->stream, &w->span, from, to, &m->worker);
        held = true;
    }
    return held;
}

// The part of a piece that is wanted, as bytes.
static uint64_t write_piece(member *m, bool held)
{
    work *w = &m->work;
    const orr_gen_task *t = w->task;
    if (!held)
        orr_gen_stream_mix(t->stream, &w->span, 0, 0,
                           &m->worker); // silence: others had all groups, or there are none
    const orr_gen_sums sums = {m->worker.re, m->worker.im, w->summed ? w->sum_re : NULL,
                               w->summed ? w->sum_im : NULL, w->most};
    const size_t size = orr_gen_output_size(orr_gen_stream_plan_of(t->stream)->format, 1);
    const int64_t first = w->span.first, end = first + w->span.n;
    if (first >= t->from && end <= t->to)
        return orr_gen_stream_write(t->stream, &w->span, &sums, t->bytes + (size_t)(first - t->from) * size);
    const int64_t from = first > t->from ? first : t->from, to = end < t->to ? end : t->to;
    const uint64_t clipped = orr_gen_stream_write(t->stream, &w->span, &sums, m->aside);
    memcpy(t->bytes + (size_t)(from - t->from) * size, m->aside + (size_t)(from - first) * size,
           (size_t)(to - from) * size);
    return clipped;
}

static void play_piece(member *m)
{
    const uint64_t clipped = write_piece(m, play_groups(m));
    pthread_mutex_lock(&m->crew->lock);
    m->work.task->clipped += clipped;
    m->work.task = NULL;
    pthread_mutex_unlock(&m->crew->lock);
}

static void play_for_others(member *m, work *w, size_t from, size_t to)
{
    orr_gen_stream_mix(w->task->stream, &w->span, from, to, &m->worker);
    add(w, &m->worker);
    pthread_mutex_lock(&m->crew->lock);
    w->others--;
    pthread_cond_broadcast(&m->crew->group_done);
    pthread_mutex_unlock(&m->crew->lock);
}

static void *run(void *user)
{
    member *m = user;
    for (;;) {
        size_t from, to;
        pthread_mutex_lock(&m->crew->lock);
        const bool piece = take_piece(m);
        work *w = piece ? NULL : take_from_others(m, &from, &to);
        pthread_mutex_unlock(&m->crew->lock);
        if (piece)
            play_piece(m);
        else if (w != NULL)
            play_for_others(m, w, from, to);
        else
            return NULL;
    }
}

void orr_gen_crew_play(orr_gen_crew *crew, const orr_gen_block *block, size_t n, orr_gen_task *task,
                       size_t n_tasks)
{
    orr_gen_crew *c = crew;
    c->block = block, c->n_blocks = n, c->task = task, c->n_tasks = n_tasks;
    for (size_t k = 0; k < n_tasks; k++) {
        orr_gen_task *t = &task[k];
        t->at = t->from, t->at_block = 0, t->clipped = 0;
        while (t->at_block + 1 < n && end_of(&block[t->at_block], t->stream) <= t->from) t->at_block++;
    }
    pthread_t thread[MOST_THREADS];
    unsigned started = 0;
    while (started + 1 < c->n && pthread_create(&thread[started], NULL, run, c->member[started + 1]) == 0)
        started++;
    run(c->member[0]);
    for (unsigned k = 0; k < started; k++) pthread_join(thread[k], NULL);
}

uint64_t orr_gen_crew_silent(const orr_gen_crew *crew)
{
    uint64_t silent = 0;
    for (unsigned k = 0; k < crew->n; k++) silent += crew->member[k]->worker.scratch.silent;
    return silent;
}
