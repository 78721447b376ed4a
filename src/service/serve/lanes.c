// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/serve/lanes.h"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

// Appends a frame; false, and nothing, where it does not fit.
static bool put_frame(orr_wire_writer *out, uint16_t type, uint32_t id, const uint8_t *payload, size_t size)
{
    size_t start;
    if (out->capacity - out->size < ORR_FRAME_OVERHEAD + size) return false;
    orr_frame_begin(out, type, id, &start);
    orr_wire_put_raw(out, payload, size);
    orr_frame_end(out, start);
    return true;
}

static bool put_error(orr_wire_writer *out, const orr_frame *f, uint16_t code, const char *sentence)
{
    uint8_t data[ORR_SERVER_SENTENCE + 16];
    orr_wire_writer w = {data, 0, sizeof data, ORR_WIRE_OK};
    const orr_msg_error m = {code, f->type, orr_wire_text(sentence)};
    orr_msg_error_encode(&m, &w);
    return put_frame(out, ORR_MSG_TYPE_ERROR, f->sequence, data, w.size);
}

// What a message asks for, as far as its type tells.
static unsigned needed(uint16_t type)
{
    switch (type) {
    case ORR_MSG_TYPE_MOTION:
    case ORR_MSG_TYPE_OPEN_MOTION_RING:
        return ORR_MAY_MOTION;
    case ORR_MSG_TYPE_CONTROL:
    case ORR_MSG_TYPE_RADIO_TIME:
        return ORR_MAY_CONTROL;
    case ORR_MSG_TYPE_SUBSCRIBE:
        return ORR_MAY_READ;
    default: // what the clock shows, and what becomes of one's own
        return ORR_MAY_NOTHING;
    }
}

static bool put_not_permitted(orr_wire_writer *out, const orr_frame *f, unsigned what)
{
    const char *sentence = what == ORR_MAY_READ     ? "you have no permission to read"
                           : what == ORR_MAY_MOTION ? "you have no permission to send motion"
                                                    : "you have no permission to control";
    return put_error(out, f, ORR_MSG_ERROR_CODE_NOT_PERMITTED, sentence);
}

static size_t place_of(const orr_lanes *l, uint32_t id)
{
    size_t k = 0;
    while (k < l->n && l->id[k] != id) k++;
    return k;
}

static bool has_ended(const orr_lanes *l, uint32_t id)
{
    const size_t n = l->n_ended < ORR_LANES_ENDED ? l->n_ended : ORR_LANES_ENDED;
    for (size_t k = 0; k < n; k++)
        if (l->ended[k] == id) return true;
    return false;
}

static bool subscribe(orr_lanes *l, const orr_frame *f, orr_wire_writer *out)
{
    orr_msg_subscribe m;
    orr_msg_subscribed told;
    orr_server_refusal why = {""};
    uint8_t data[64];
    orr_wire_writer w = {data, 0, sizeof data, ORR_WIRE_OK};
    const orr_wire_status decoded = orr_msg_subscribe_decode(f->payload, f->size, &m);
    if (decoded != ORR_WIRE_OK) {
        snprintf(why.sentence, sizeof why.sentence, "SUBSCRIBE: %s", orr_wire_status_text(decoded));
        return put_error(out, f, ORR_MSG_ERROR_CODE_BAD_PAYLOAD, why.sentence);
    }
    if (f->sequence == 0 || place_of(l, f->sequence) < l->n)
        return put_error(
            out, f, ORR_MSG_ERROR_CODE_BAD_REQUEST,
            "SUBSCRIBE: its sequence number is the stream's: not 0, and not that of an open stream");
    if (l->n == ORR_LANES_MOST)
        return put_error(out, f, ORR_MSG_ERROR_CODE_LIMIT, "SUBSCRIBE: a connection has at most 32 streams");
    if (m.delivery == ORR_MSG_DELIVERY_RING && !l->passes)
        return put_error(out, f, ORR_MSG_ERROR_CODE_NOT_SERVED,
                         "SUBSCRIBE: a ring is shared with clients of a Unix socket alone");
    if (m.delivery == ORR_MSG_DELIVERY_RING && l->n_pass > 0) return false; // those of one frame at a time
    orr_way *way = NULL;
    uint32_t channel = 0;
    uint16_t code = 0;
    if (m.delivery == ORR_MSG_DELIVERY_DATAGRAMS)
        code = orr_datagram_lane_way(&l->datagrams, m.port, f->sequence, &way, &channel, &why);
    if (code == 0)
        code = orr_streams_subscribe(l->streams, l->judge, &m, way, l->owner, &told, &l->stream[l->n], &why);
    if (code != 0) return put_error(out, f, code, why.sentence);
    told.channel = channel;
    l->id[l->n] = f->sequence;
    l->held[l->n] = NULL;
    if (m.delivery == ORR_MSG_DELIVERY_RING) {
        l->pass[0] = fcntl(orr_stream_ring(l->stream[l->n]), F_DUPFD_CLOEXEC, 3);
        l->n_pass = 1;
    }
    l->n++;
    orr_msg_subscribed_encode(&told, &w);
    return put_frame(out, ORR_MSG_TYPE_SUBSCRIBED, f->sequence, data, w.size);
}

// The stream that a message names; NULL where there is none, which is an error only if there never was.
static orr_stream *find(const orr_lanes *l, uint32_t id, bool *unknown)
{
    const size_t k = place_of(l, id);
    *unknown = k == l->n && !has_ended(l, id);
    return k < l->n ? l->stream[k] : NULL;
}

static bool take_credit(orr_lanes *l, const orr_frame *f, orr_wire_writer *out)
{
    orr_stream *x = NULL;
    bool unknown = false;
    orr_wire_status decoded;
    if (f->type == ORR_MSG_TYPE_CREDIT) {
        orr_msg_credit m;
        decoded = orr_msg_credit_decode(f->payload, f->size, &m);
        if (decoded == ORR_WIRE_OK) x = find(l, m.stream, &unknown);
        if (x != NULL) orr_stream_credit(x, m.blocks);
    } else {
        orr_msg_unsubscribe m;
        decoded = orr_msg_unsubscribe_decode(f->payload, f->size, &m);
        if (decoded == ORR_WIRE_OK) x = find(l, m.stream, &unknown);
        if (x != NULL) orr_stream_end(x);
    }
    if (decoded != ORR_WIRE_OK)
        return put_error(out, f, ORR_MSG_ERROR_CODE_BAD_PAYLOAD, orr_wire_status_text(decoded));
    return !unknown ||
           put_error(out, f, ORR_MSG_ERROR_CODE_BAD_REQUEST, "this connection has no stream of that number");
}

// Messages of the clock: each is answered by one that fits into a small room.
static bool take_time(orr_lanes *l, const orr_frame *f, orr_wire_writer *out)
{
    uint8_t data[256];
    orr_wire_writer w = {data, 0, sizeof data, ORR_WIRE_OK};
    orr_server_refusal why = {""};
    uint16_t code = 0, answer = ORR_MSG_TYPE_TIME;
    orr_wire_status decoded = ORR_WIRE_OK;
    orr_msg_time told;
    if (f->type == ORR_MSG_TYPE_GET_TIME) {
        orr_streams_time(l->streams, &told);
        orr_msg_time_encode(&told, &w);
        return put_frame(out, answer, f->sequence, data, w.size);
    }
    if (f->type == ORR_MSG_TYPE_CONTROL) {
        orr_msg_control m;
        decoded = orr_msg_control_decode(f->payload, f->size, &m);
        if (decoded == ORR_WIRE_OK) code = orr_streams_control(l->streams, &m, &told, &why);
        if (decoded == ORR_WIRE_OK) orr_msg_time_encode(&told, &w);
    } else {
        orr_msg_radio_time m;
        orr_msg_pace pace;
        answer = ORR_MSG_TYPE_PACE;
        decoded = orr_msg_radio_time_decode(f->payload, f->size, &m);
        const orr_time made = l->n > 0 ? orr_stream_made(l->stream[0]) : ORR_TIME_NONE;
        if (decoded == ORR_WIRE_OK) code = orr_streams_radio(l->streams, &m, made, &pace, &why);
        if (decoded == ORR_WIRE_OK) orr_msg_pace_encode(&pace, &w);
    }
    if (decoded != ORR_WIRE_OK)
        return put_error(out, f, ORR_MSG_ERROR_CODE_BAD_PAYLOAD, orr_wire_status_text(decoded));
    if (code != 0) return put_error(out, f, code, why.sentence);
    return put_frame(out, answer, f->sequence, data, w.size);
}

static bool take_motion(orr_lanes *l, const orr_frame *f, orr_wire_writer *out)
{
    orr_server_refusal why = {""};
    orr_msg_motion m;
    const orr_wire_status decoded = orr_msg_motion_decode(f->payload, f->size, &m);
    if (decoded != ORR_WIRE_OK)
        return put_error(out, f, ORR_MSG_ERROR_CODE_BAD_PAYLOAD, orr_wire_status_text(decoded));
    const uint16_t code = orr_streams_motion(l->streams, &m, &why);
    return code == 0 || put_error(out, f, code, why.sentence);
}

static bool take_stats(orr_lanes *l, const orr_frame *f, orr_wire_writer *out)
{
    uint8_t data[512];
    orr_wire_writer w = {data, 0, sizeof data, ORR_WIRE_OK};
    orr_msg_get_motion_stats m;
    orr_msg_motion_stats told;
    const orr_wire_status decoded = orr_msg_get_motion_stats_decode(f->payload, f->size, &m);
    if (decoded != ORR_WIRE_OK)
        return put_error(out, f, ORR_MSG_ERROR_CODE_BAD_PAYLOAD, orr_wire_status_text(decoded));
    if (m.reset != 0 && (l->may & ORR_MAY_MOTION) == 0) return put_not_permitted(out, f, ORR_MAY_MOTION);
    if (!orr_streams_motion_stats(l->streams, m.reset != 0, &told))
        return put_error(out, f, ORR_MSG_ERROR_CODE_NOT_SERVED,
                         "this server takes no motion (serve --motion)");
    orr_msg_motion_stats_encode(&told, &w);
    return put_frame(out, ORR_MSG_TYPE_MOTION_STATS, f->sequence, data, w.size);
}

static bool tell_modes(orr_lanes *l, const orr_frame *f, orr_wire_writer *out)
{
    uint8_t data[ORR_MSG_MODES_LARGEST];
    orr_wire_writer w = {data, 0, sizeof data, ORR_WIRE_OK};
    orr_msg_get_modes m;
    const orr_wire_status decoded = orr_msg_get_modes_decode(f->payload, f->size, &m);
    if (decoded != ORR_WIRE_OK)
        return put_error(out, f, ORR_MSG_ERROR_CODE_BAD_PAYLOAD, orr_wire_status_text(decoded));
    orr_streams_modes(l->streams, m.after, &w);
    return put_frame(out, ORR_MSG_TYPE_MODES, f->sequence, data, w.size);
}

static bool open_datagrams(orr_lanes *l, const orr_frame *f, orr_wire_writer *out)
{
    uint8_t data[ORR_MSG_DATAGRAMS_LARGEST];
    orr_wire_writer w = {data, 0, sizeof data, ORR_WIRE_OK};
    orr_msg_open_datagrams m;
    orr_msg_datagrams told;
    orr_seal_keys keys;
    orr_server_refusal why = {""};
    const orr_wire_status decoded = orr_msg_open_datagrams_decode(f->payload, f->size, &m);
    if (decoded != ORR_WIRE_OK)
        return put_error(out, f, ORR_MSG_ERROR_CODE_BAD_PAYLOAD, orr_wire_status_text(decoded));
    const uint16_t code =
        orr_datagram_lane_open(&l->datagrams, (l->may & ORR_MAY_MOTION) != 0, &keys, &told, &why);
    if (code != 0) return put_error(out, f, code, why.sentence);
    orr_msg_datagrams_encode(&told, &w);
    return put_frame(out, ORR_MSG_TYPE_DATAGRAMS, f->sequence, data, w.size);
}

// The first time its descriptors go along.
static bool open_motion_ring(orr_lanes *l, const orr_frame *f, orr_wire_writer *out)
{
    uint8_t data[64];
    orr_wire_writer w = {data, 0, sizeof data, ORR_WIRE_OK};
    orr_msg_open_motion_ring m;
    orr_diag diag = {0};
    const orr_wire_status decoded = orr_msg_open_motion_ring_decode(f->payload, f->size, &m);
    if (decoded != ORR_WIRE_OK)
        return put_error(out, f, ORR_MSG_ERROR_CODE_BAD_PAYLOAD, orr_wire_status_text(decoded));
    if (!l->passes || l->base == NULL)
        return put_error(out, f, ORR_MSG_ERROR_CODE_NOT_SERVED,
                         "OPEN_MOTION_RING: memory is shared with clients of a Unix socket alone");
    if (l->motion == NULL && l->n_pass > 0) return false; // those of one frame at a time
    if (l->motion == NULL) {
        if (orr_motion_ring_open(l->base, l->streams, &l->motion, &diag) != ORR_OK)
            return put_error(out, f, ORR_MSG_ERROR_CODE_INTERNAL, diag.text);
        l->pass[0] = fcntl(l->motion->made.fd, F_DUPFD_CLOEXEC, 3);
        l->pass[1] = fcntl(l->motion->bell, F_DUPFD_CLOEXEC, 3);
        l->n_pass = 2;
    }
    const orr_msg_motion_ring told = {ORR_MOTION_RING_SLOTS, ORR_MOTION_RING_STRIDE, l->motion->taken,
                                      l->motion->made.ring.lost};
    orr_msg_motion_ring_encode(&told, &w);
    return put_frame(out, ORR_MSG_TYPE_MOTION_RING, f->sequence, data, w.size);
}

bool orr_lanes_take(orr_lanes *l, const orr_frame *f, orr_wire_writer *out)
{
    // Room for whatever is to be said at once, so that nothing is done twice.
    if (out->capacity - out->size < ORR_FRAME_OVERHEAD + 512) return false;
    const unsigned needs = needed(f->type);
    if ((needs & ~l->may) != 0) return put_not_permitted(out, f, needs);
    switch (f->type) {
    case ORR_MSG_TYPE_SUBSCRIBE:
        return subscribe(l, f, out);
    case ORR_MSG_TYPE_CREDIT:
    case ORR_MSG_TYPE_UNSUBSCRIBE:
        return take_credit(l, f, out);
    case ORR_MSG_TYPE_MOTION:
        return take_motion(l, f, out);
    case ORR_MSG_TYPE_GET_MOTION_STATS:
        return take_stats(l, f, out);
    case ORR_MSG_TYPE_GET_MODES:
        return tell_modes(l, f, out);
    case ORR_MSG_TYPE_OPEN_DATAGRAMS:
        return open_datagrams(l, f, out);
    case ORR_MSG_TYPE_OPEN_MOTION_RING:
        return open_motion_ring(l, f, out);
    default:
        return take_time(l, f, out);
    }
}

static void drop(orr_lanes *l, size_t k)
{
    orr_stream_close(l->stream[k]);
    l->ended[l->n_ended++ % ORR_LANES_ENDED] = l->id[k];
    l->n--;
    l->stream[k] = l->stream[l->n];
    l->id[k] = l->id[l->n];
    l->held[k] = l->held[l->n];
}

// The next frame of stream k. False: no room.
static bool put_next(orr_lanes *l, size_t k, orr_wire_writer *out, bool *sent)
{
    orr_payload *b = l->held[k] != NULL ? l->held[k] : orr_stream_next(l->stream[k]);
    l->held[k] = b;
    *sent = b != NULL;
    if (b == NULL) return true;
    if (!put_frame(out, b->type, l->id[k], b->data, b->size)) return false;
    const bool last = b->type == ORR_MSG_TYPE_STREAM_END;
    l->held[k] = NULL;
    orr_stream_sent(l->stream[k], b);
    if (last) drop(l, k);
    return true;
}

size_t orr_lanes_fill(orr_lanes *l, orr_wire_writer *out)
{
    for (size_t idle = 0; idle < l->n;) {
        bool sent;
        if (l->next >= l->n) l->next = 0;
        if (!put_next(l, l->next, out, &sent)) return ORR_FRAME_OVERHEAD + l->held[l->next]->size;
        idle = sent ? 0 : idle + 1;
        l->next++;
    }
    return 0;
}

bool orr_lanes_can_go_on(const orr_lanes *l)
{
    for (size_t k = 0; k < l->n; k++) {
        orr_stream_look look;
        orr_stream_looked(l->stream[k], &look);
        if (look.credit > 0 || look.waiting > 0 || l->held[k] != NULL) return true;
    }
    return false;
}

void orr_lanes_passed(orr_lanes *l)
{
    for (; l->n_pass > 0; l->n_pass--)
        if (l->pass[l->n_pass - 1] >= 0) close(l->pass[l->n_pass - 1]);
}

void orr_lanes_permit(orr_lanes *l, unsigned may)
{
    l->may = may;
    if (l->motion != NULL) l->motion->may = (may & ORR_MAY_MOTION) != 0;
    orr_datagram_lane_permit(&l->datagrams, (may & ORR_MAY_MOTION) != 0);
}

void orr_lanes_close(orr_lanes *l)
{
    orr_datagram_lane_close(&l->datagrams);
    orr_motion_ring_close(l->motion);
    l->motion = NULL;
    orr_lanes_passed(l);
    while (l->n > 0) {
        if (l->held[l->n - 1] != NULL) orr_stream_sent(l->stream[l->n - 1], l->held[l->n - 1]);
        orr_stream_close(l->stream[--l->n]);
    }
}
