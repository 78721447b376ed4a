// SPDX-License-Identifier: GPL-3.0-or-later
// What waits behind a stream, and which streams have something new; all of it under the lock.
#include <stdlib.h>

#include "src/service/live/streams_private.h"

void streams_free(orr_stream *x)
{
    if (x->way != NULL) x->way->close(x->way);
    free(x->poll);
    free(x);
}

static void list(orr_stream *x)
{
    orr_streams *s = x->all;
    if (x->listed || x->closed) return;
    x->listed = true;
    x->follow = NULL;
    if (s->ready_last != NULL)
        s->ready_last->follow = x;
    else
        s->ready = x;
    s->ready_last = x;
    s->told = true;
}

void streams_push(orr_stream *x, orr_payload *b)
{
    x->queue[(x->head + x->n++) % (sizeof x->queue / sizeof x->queue[0])] = b;
    x->bytes += b->size;
    list(x);
}

orr_payload *streams_pop(orr_stream *x)
{
    orr_payload *b = x->queue[x->head];
    x->head = (x->head + 1) % (sizeof x->queue / sizeof x->queue[0]);
    x->n--;
    x->bytes -= b->size;
    return b;
}

void streams_finish(orr_stream *x, uint8_t reason, const char *sentence)
{
    uint8_t data[256];
    orr_wire_writer w = {data, 0, sizeof data, ORR_WIRE_OK};
    const orr_msg_stream_end m = {x->next, reason, orr_wire_text(sentence)};
    orr_msg_stream_end_encode(&m, &w);
    orr_payload *b = orr_payload_new(&x->all->payloads, ORR_MSG_TYPE_STREAM_END, data, w.size);
    x->ended = true;
    if (x->way != NULL) (void)x->way->put(x->way, ORR_MSG_TYPE_STREAM_END, data, w.size);
    if (b != NULL) streams_push(x, b);
}

void streams_unlist(orr_stream *x)
{
    orr_streams *s = x->all;
    orr_stream *before = NULL;
    for (orr_stream *y = s->ready; y != NULL && y != x; y = y->follow) before = y;
    if (before != NULL)
        before->follow = x->follow;
    else
        s->ready = x->follow;
    if (s->ready_last == x) s->ready_last = before;
    x->listed = false;
}

void streams_forget(orr_stream *x)
{
    orr_streams *s = x->all;
    while (x->n > 0) orr_payload_drop(&s->payloads, streams_pop(x));
    for (size_t k = 0; k < s->n; k++)
        if (s->stream[k] == x) s->stream[k] = s->stream[--s->n];
    s->n_rings -= x->way != NULL && x->way->fd >= 0;
    streams_free(x);
}
