// SPDX-License-Identifier: MIT
#include "proto/client.h"

void orr_client_init(orr_client *c, orr_client_io io, uint8_t *buffer, size_t capacity)
{
    memset(c, 0, sizeof *c);
    c->io = io;
    c->data = buffer;
    c->capacity = capacity;
}

// Forgets the frame handed out last; what came behind it moves to the front.
static void compact(orr_client *c)
{
    if (c->used == 0) return;
    c->size -= c->used;
    if (c->size > 0) memmove(c->data, c->data + c->used, c->size);
    c->used = 0;
}

void orr_client_begin(orr_client *c, uint16_t type, orr_wire_writer *w, size_t *start)
{
    compact(c);
    // Behind bytes that are already in (a pipelined answer), so that neither disturbs the other.
    w->data = c->data + c->size;
    w->size = 0;
    w->capacity = c->capacity - c->size;
    w->status = ORR_WIRE_OK;
    if (++c->sequence == 0) c->sequence = 1; // 0 is the server's, for an ERROR that answers no request
    c->awaited = c->sequence;
    orr_frame_begin(w, type, c->sequence, start);
}

orr_wire_status orr_client_send(orr_client *c, orr_wire_writer *w, size_t start)
{
    orr_frame_end(w, start);
    if (w->status != ORR_WIRE_OK) return w->status;
    for (size_t done = 0; done < w->size;) {
        ptrdiff_t n = c->io.write(c->io.user, w->data + done, w->size - done);
        if (n <= 0 || (size_t)n > w->size - done) return ORR_WIRE_IO;
        done += (size_t)n;
    }
    return ORR_WIRE_OK;
}

static orr_wire_status receive(orr_client *c, orr_frame *f)
{
    compact(c);
    for (;;) {
        size_t used;
        orr_wire_status s = orr_frame_parse(c->data, c->size, ORR_MSG_MAX_PAYLOAD, f, &used);
        if (s == ORR_WIRE_OK) c->used = used;
        if (s != ORR_WIRE_MORE) return s;
        if (used > c->capacity) return ORR_WIRE_SPACE;
        ptrdiff_t n = c->io.read(c->io.user, c->data + c->size, c->capacity - c->size);
        if (n == 0) return ORR_WIRE_CLOSED;
        if (n < 0 || (size_t)n > c->capacity - c->size) return ORR_WIRE_IO;
        c->size += (size_t)n;
    }
}

static orr_wire_status refused(orr_client *c, const orr_frame *f)
{
    orr_msg_error error;
    orr_wire_status s = orr_msg_error_decode(f->payload, f->size, &error);
    if (s != ORR_WIRE_OK) return s;
    c->error_code = error.code;
    orr_wire_text_copy(error.sentence, c->sentence, sizeof c->sentence);
    return ORR_WIRE_REFUSED;
}

orr_wire_status orr_client_answer(orr_client *c, uint16_t type, orr_frame *f)
{
    for (;;) {
        orr_wire_status s = receive(c, f);
        if (s != ORR_WIRE_OK) return s;
        if (f->type == ORR_MSG_TYPE_ERROR && (f->sequence == c->awaited || f->sequence == 0))
            return refused(c, f);
        if (f->type == type && f->sequence == c->awaited) return ORR_WIRE_OK;
        if (c->stream == NULL || f->sequence == c->awaited || f->sequence == 0) return ORR_WIRE_UNEXPECTED;
        c->stream(c->stream_user, f);
    }
}

orr_wire_status orr_client_next(orr_client *c, orr_frame *f)
{
    orr_wire_status s = receive(c, f);
    if (s == ORR_WIRE_OK && f->type == ORR_MSG_TYPE_ERROR && f->sequence == 0) s = refused(c, f);
    return s;
}

void orr_client_expect(orr_client *c, uint32_t count)
{
    c->index = 0;
    c->count = count;
}

orr_wire_status orr_client_epoch(orr_client *c, uint32_t index, uint32_t count)
{
    if (count != c->count || index != c->index || index >= count) return ORR_WIRE_UNEXPECTED;
    c->index++;
    return ORR_WIRE_OK;
}
