// SPDX-License-Identifier: MIT
#include "proto/server.h"

#include <stdio.h>

// Appends an ERROR frame, or nothing and false where it does not fit.
static bool put_error(orr_wire_writer *out, uint32_t sequence, uint16_t request, uint16_t code,
                      const char *sentence)
{
    size_t mark = out->size, start;
    orr_msg_error error = {code, request, orr_wire_text(sentence)};
    orr_frame_begin(out, ORR_MSG_TYPE_ERROR, sequence, &start);
    orr_msg_error_encode(&error, out);
    orr_frame_end(out, start);
    if (out->status == ORR_WIRE_OK) return true;
    out->size = mark;
    out->status = ORR_WIRE_OK;
    return false;
}

void orr_server_error(orr_wire_writer *out, uint16_t code, const char *sentence)
{
    put_error(out, 0, 0, code, sentence);
}

// (I13) What a client calls itself goes into logs: printable ASCII only.
static void note_client(orr_server_conn *c, const orr_msg_hello *hello)
{
    char name[65], version[33];
    orr_wire_text_copy(hello->name, name, sizeof name);
    orr_wire_text_copy(hello->version, version, sizeof version);
    snprintf(c->client, sizeof c->client, "%s %s", name, version);
    for (char *p = c->client; *p != '\0'; p++)
        if (*p < ' ' || *p > '~') *p = '?';
}

static uint16_t begin_hello(orr_server_conn *c, const orr_frame *f, orr_server_refusal *why)
{
    orr_msg_hello hello;
    orr_wire_status ws = orr_msg_hello_decode(f->payload, f->size, &hello);
    if (ws != ORR_WIRE_OK) {
        snprintf(why->sentence, sizeof why->sentence, "HELLO: %s", orr_wire_status_text(ws));
        return ORR_MSG_ERROR_CODE_BAD_PAYLOAD;
    }
    note_client(c, &hello);
    if (hello.major_min <= ORR_MSG_MAJOR && hello.major_max >= ORR_MSG_MAJOR) return 0;
    snprintf(why->sentence, sizeof why->sentence, "this server speaks version %u, the client %u to %u",
             ORR_MSG_MAJOR, (unsigned)hello.major_min, (unsigned)hello.major_max);
    return ORR_MSG_ERROR_CODE_BAD_VERSION;
}

void orr_server_caps(const orr_server *s, uint16_t access, orr_wire_writer *w)
{
    const orr_msg_span never = {INT64_MIN, INT64_MIN};
    orr_msg_served_request requests[64] = {{ORR_MSG_TYPE_HELLO, ORR_MSG_TYPE_CAPS, never},
                                           {ORR_MSG_TYPE_PING, ORR_MSG_TYPE_PONG, never}};
    uint16_t n = 2;
    uint16_t type;
    for (size_t i = 0; n < 64 && (type = orr_msg_request_type(i)) != 0; i++) {
        requests[n] = (orr_msg_served_request){type, orr_msg_handled(s->handlers, type), never};
        if (requests[n].answer == 0) continue;
        if (s->served == NULL || s->served(s->user, type, &requests[n].span)) n++;
    }
    for (size_t i = 0; s->lanes && n < 64 && (type = orr_msg_lane_request(i, &requests[n].answer)) != 0;
         i++) {
        requests[n].request = type;
        requests[n++].span = never;
    }
    orr_msg_caps caps;
    memset(&caps, 0, sizeof caps);
    if (s->caps != NULL) s->caps(s->user, &caps);
    caps.major = ORR_MSG_MAJOR;
    caps.minor = ORR_MSG_MINOR;
    caps.max_request = ORR_MSG_MAX_REQUEST;
    caps.max_epochs = ORR_MSG_MAX_EPOCHS;
    caps.access = access;
    caps.requests.count = n;
    caps.requests.item = requests;
    orr_msg_caps_encode(&caps, w);
}

static uint16_t answer_ping(const orr_frame *f, orr_wire_writer *w)
{
    orr_msg_ping ping;
    orr_msg_ping_decode(f->payload, f->size, &ping); // begin has seen that it decodes
    orr_msg_pong pong = {ping.token};
    orr_msg_pong_encode(&pong, w);
    return 0;
}

static void next_part(orr_server_conn *c, uint32_t index)
{
    c->part.index = index;
    c->part.done = 0;
    c->part.over = c->over;
    c->part.owner = c->owner;
    c->unfinished = 0;
}

// (I9) A request of the table of handlers, decoded or not: 0 and the frames of its answer, or a code.
static uint16_t begin_handled(const orr_server *s, orr_server_conn *c, const orr_frame *f,
                              const orr_msg_any *request, orr_wire_status decoded, orr_server_refusal *why)
{
    const char *name = orr_msg_type_name(f->type);
    if ((c->access & ORR_MSG_ACCESS_NO_READING) != 0) {
        snprintf(why->sentence, sizeof why->sentence, "%s: you have no permission to read", name);
        return ORR_MSG_ERROR_CODE_NOT_PERMITTED;
    }
    if (decoded == ORR_WIRE_LIMIT) {
        snprintf(why->sentence, sizeof why->sentence, "%s: more members than a list may have", name);
        return ORR_MSG_ERROR_CODE_LIMIT;
    }
    if (decoded != ORR_WIRE_OK) {
        snprintf(why->sentence, sizeof why->sentence, "%s: %s", name, orr_wire_status_text(decoded));
        return ORR_MSG_ERROR_CODE_BAD_PAYLOAD;
    }
    c->frames = orr_msg_request_frames(f->type, request);
    uint16_t code = orr_msg_begin(s->handlers, s->user, f->type, request, why);
    if (code != 0 || c->frames > 0) return code;
    snprintf(why->sentence, sizeof why->sentence, "%s: count is 0, no epoch is asked for", name);
    return ORR_MSG_ERROR_CODE_BAD_REQUEST;
}

static uint16_t begin(const orr_server *s, orr_server_conn *c, const orr_frame *f, const orr_msg_any *request,
                      orr_wire_status decoded, orr_server_refusal *why)
{
    c->frames = 1;
    next_part(c, 0);
    if (f->type == ORR_MSG_TYPE_HELLO) return begin_hello(c, f, why);
    if (f->type == ORR_MSG_TYPE_PING) {
        orr_msg_ping ping;
        orr_wire_status ws = orr_msg_ping_decode(f->payload, f->size, &ping);
        if (ws == ORR_WIRE_OK) return 0;
        snprintf(why->sentence, sizeof why->sentence, "PING: %s", orr_wire_status_text(ws));
        return ORR_MSG_ERROR_CODE_BAD_PAYLOAD;
    }
    if (orr_msg_handled(s->handlers, f->type) != 0) return begin_handled(s, c, f, request, decoded, why);
    const char *name = orr_msg_type_name(f->type);
    if (name == NULL)
        snprintf(why->sentence, sizeof why->sentence, "unknown message type %u", (unsigned)f->type);
    else
        snprintf(why->sentence, sizeof why->sentence, "this server does not answer %s", name);
    return name == NULL ? ORR_MSG_ERROR_CODE_UNKNOWN_TYPE : ORR_MSG_ERROR_CODE_NOT_SERVED;
}

// One call of a handler: begins a frame at the writer's end or goes on with it there; `more` when it is not
// finished.
static uint16_t answer(const orr_server *s, orr_server_conn *c, const orr_frame *f,
                       const orr_msg_any *request, orr_wire_writer *w, orr_server_refusal *why)
{
    uint16_t handled = orr_msg_handled(s->handlers, f->type), code = 0;
    uint16_t reply = f->type == ORR_MSG_TYPE_PING ? ORR_MSG_TYPE_PONG
                     : handled != 0               ? handled
                                                  : ORR_MSG_TYPE_CAPS;
    size_t start = w->size;
    if (c->unfinished > 0)
        w->size += c->unfinished;
    else
        orr_frame_begin(w, reply, f->sequence, &start);
    c->part.more = false;
    if (handled != 0)
        code = orr_msg_answer(s->handlers, s->user, f->type, request, &c->part, w, why);
    else if (f->type == ORR_MSG_TYPE_PING)
        code = answer_ping(f, w);
    else
        orr_server_caps(s, c->access, w);
    if (code == 0 && !c->part.more) orr_frame_end(w, start);
    return code;
}

static void refuse_stream(orr_wire_status status, const orr_frame *f, orr_wire_writer *out,
                          orr_server_step *step)
{
    uint16_t code = ORR_MSG_ERROR_CODE_BAD_MAGIC;
    snprintf(step->reason, sizeof step->reason, "%s", orr_wire_status_text(status));
    if (status == ORR_WIRE_VERSION) {
        code = ORR_MSG_ERROR_CODE_BAD_VERSION;
        snprintf(step->reason, sizeof step->reason, "a frame of version %u, this server speaks %u",
                 (unsigned)f->major, ORR_MSG_MAJOR);
    } else if (status == ORR_WIRE_LENGTH) {
        code = ORR_MSG_ERROR_CODE_BAD_LENGTH;
        snprintf(step->reason, sizeof step->reason, "a payload of %lu bytes, a request may have %lu",
                 (unsigned long)f->size, (unsigned long)ORR_MSG_MAX_REQUEST);
    } else if (status == ORR_WIRE_CRC) {
        code = ORR_MSG_ERROR_CODE_BAD_CRC;
        snprintf(step->reason, sizeof step->reason,
                 "the checksum of the frame with sequence %lu does not match", (unsigned long)f->sequence);
    }
    // If there is no room the connection closes without the sentence: the peer is not reading anyway.
    put_error(out, 0, 0, code, step->reason);
    step->closing = code;
}

// Answers the request under way as far as there is room and time. True when it is done with.
static bool answer_some(const orr_server *s, orr_server_conn *c, const orr_frame *f,
                        const orr_msg_any *request, uint16_t refused, orr_server_refusal *why,
                        orr_wire_writer *out, orr_server_step *step)
{
    while (refused == 0 && c->part.index < c->frames) {
        size_t mark = out->size;
        refused = answer(s, c, f, request, out, why);
        if (refused == 0 && out->status == ORR_WIRE_OK) {
            if (c->part.more) {
                c->unfinished = out->size - mark;
                out->size = mark;
                step->busy = step->yield = true;
                return false;
            }
            next_part(c, c->part.index + 1);
            if (c->part.index == c->frames || !orr_server_turn_over(&c->part)) continue;
            step->busy = step->yield = true;
            return false;
        }
        orr_wire_status status = out->status;
        out->size = mark;
        out->status = ORR_WIRE_OK;
        next_part(c, c->part.index); // what there is of the frame is lost
        if (refused != 0) break;
        bool grows = c->can_grow && out->capacity < ORR_SERVER_OUT;
        if (status == ORR_WIRE_SPACE && (mark > 0 || grows)) {
            step->busy = true;
            step->room = mark == 0 ? ORR_SERVER_OUT : 0;
            return false;
        }
        refused = ORR_MSG_ERROR_CODE_INTERNAL; // it would not fit into an empty buffer either
        snprintf(why->sentence, sizeof why->sentence, "the answer cannot be encoded: %s",
                 orr_wire_status_text(status));
    }
    if (refused == 0) return true;
    if (!put_error(out, f->sequence, f->type, refused, why->sentence)) {
        step->busy = true; // asked again, the handler refuses again
        return false;
    }
    c->refusals++;
    if (orr_msg_error_code_closes(refused)) {
        step->closing = refused;
        snprintf(step->reason, sizeof step->reason, "%s", why->sentence);
    }
    return true;
}

void orr_server_run(const orr_server *s, orr_server_conn *c, const uint8_t *in, size_t n,
                    orr_wire_writer *out, orr_server_step *step)
{
    memset(step, 0, sizeof *step);
    while (step->closing == 0) {
        orr_frame f;
        size_t used;
        bool under_way = c->frames > 0;
        orr_wire_status status =
            orr_frame_parse(in + step->consumed, n - step->consumed, ORR_MSG_MAX_REQUEST, &f, &used);
        step->need = used;
        if (status == ORR_WIRE_MORE) return;
        if (status != ORR_WIRE_OK) {
            refuse_stream(status, &f, out, step);
            return;
        }
        orr_server_refusal why = {""};
        uint16_t refused = 0;
        orr_msg_any request;
        orr_wire_status decoded = orr_msg_request_decode(f.type, f.payload, f.size, &request);
        if (!under_way) refused = begin(s, c, &f, &request, decoded, &why);
        if (!answer_some(s, c, &f, &request, refused, &why, out, step)) {
            if (refused != 0) c->frames = 0;
            return;
        }
        c->frames = 0;
        c->requests++;
        step->consumed += used;
        if (step->closing != 0 || step->consumed == n || !orr_server_turn_over(&c->part)) continue;
        step->busy = step->yield = true;
        return;
    }
}
