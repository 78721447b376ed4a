// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/generator/play/crew.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#define MOST_THREADS 64

typedef struct member {
    orr_gen_crew *crew;
    orr_gen_worker worker;
    uint8_t aside[8 * ORR_GEN_PIECE]; // of a piece that is not wanted whole
} member;

struct orr_gen_crew {
    unsigned n;
    member *member[MOST_THREADS];
    // The work at hand.
    const orr_gen_stream *stream;
    const orr_gen_block *block;
    size_t n_blocks;
    int64_t from, to;
    uint8_t *bytes;
    pthread_mutex_t lock;
    size_t at_block; // of the next piece
    int64_t at;
};

bool orr_gen_crew_open(unsigned threads, orr_gen_crew **crew, orr_gen_fault *fault)
{
    orr_gen_crew *c = calloc(1, sizeof *c);
    *crew = c;
    if (c == NULL) return orr_gen_fail(fault, "out of memory");
    pthread_mutex_init(&c->lock, NULL);
    for (c->n = 0; c->n < threads && c->n < MOST_THREADS; c->n++) {
        c->member[c->n] = calloc(1, sizeof *c->member[0]);
        if (c->member[c->n] == NULL) return orr_gen_fail(fault, "out of memory");
        c->member[c->n]->crew = c;
    }
    return true;
}

void orr_gen_crew_close(orr_gen_crew *crew)
{
    if (crew == NULL) return;
    for (unsigned k = 0; k < crew->n; k++) free(crew->member[k]);
    pthread_mutex_destroy(&crew->lock);
    free(crew);
}

// The next piece that nobody has taken.
static bool take(orr_gen_crew *c, orr_gen_span *span)
{
    pthread_mutex_lock(&c->lock);
    const bool more = c->at < c->to && c->at_block < c->n_blocks;
    if (more) {
        *span = orr_gen_stream_span(c->stream, &c->block[c->at_block], c->at);
        c->at = span->first + span->n;
        const orr_gen_block *b = &c->block[c->at_block];
        if (c->at >=
            orr_gen_first_sample(b->begin_ns + b->length_ns, orr_gen_stream_plan_of(c->stream)->rate_hz))
            c->at_block++;
    }
    pthread_mutex_unlock(&c->lock);
    return more;
}

static void *work(void *user)
{
    member *m = user;
    orr_gen_crew *c = m->crew;
    const size_t size = orr_gen_output_size(orr_gen_stream_plan_of(c->stream)->format, 1);
    orr_gen_span span;
    while (take(c, &span)) {
        const int64_t end = span.first + span.n;
        if (span.first >= c->from && end <= c->to) {
            orr_gen_stream_play(c->stream, &span, &m->worker,
                                c->bytes + (size_t)(span.first - c->from) * size);
            continue;
        }
        const int64_t from = span.first > c->from ? span.first : c->from, to = end < c->to ? end : c->to;
        orr_gen_stream_play(c->stream, &span, &m->worker, m->aside);
        memcpy(c->bytes + (size_t)(from - c->from) * size, m->aside + (size_t)(from - span.first) * size,
               (size_t)(to - from) * size);
    }
    return NULL;
}

uint64_t orr_gen_crew_play(orr_gen_crew *crew, const orr_gen_stream *stream, const orr_gen_block *block,
                           size_t n, int64_t from, int64_t to, uint8_t *bytes)
{
    orr_gen_crew *c = crew;
    const uint32_t rate = orr_gen_stream_plan_of(stream)->rate_hz;
    c->stream = stream, c->block = block, c->n_blocks = n, c->from = from, c->to = to, c->bytes = bytes;
    c->at = from, c->at_block = 0;
    while (c->at_block + 1 < n &&
           orr_gen_first_sample(block[c->at_block].begin_ns + block[c->at_block].length_ns, rate) <= from)
        c->at_block++;
    pthread_t thread[MOST_THREADS];
    unsigned started = 0;
    uint64_t before = 0, after = 0;
    for (unsigned k = 0; k < c->n; k++) before += c->member[k]->worker.clipped;
    while (started + 1 < c->n && pthread_create(&thread[started], NULL, work, c->member[started + 1]) == 0)
        started++;
    work(c->member[0]);
    for (unsigned k = 0; k < started; k++) pthread_join(thread[k], NULL);
    for (unsigned k = 0; k < c->n; k++) after += c->member[k]->worker.clipped;
    return after - before;
}

uint64_t orr_gen_crew_silent(const orr_gen_crew *crew)
{
    uint64_t silent = 0;
    for (unsigned k = 0; k < crew->n; k++) silent += crew->member[k]->worker.scratch.silent;
    return silent;
}
