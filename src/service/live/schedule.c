// SPDX-License-Identifier: GPL-3.0-or-later
// Which block is made when. Streams that follow the scenario's clock come first, the one that is due earliest; those that are made
// as fast as they are taken share the rest in turns of one block.
#include <string.h>

#include "proto/fields.h"
#include "src/service/live/streams_private.h"

static const int64_t NO_FRAME_NS = 30 * ORR_NS_PER_S;
enum { EPOCHS_SIZE = 20 }; // every request that can be streamed begins with its epochs

typedef enum need {
    NEED_NOTHING, // until something changes
    NEED_LATER,   // at *when
    NEED_NOW,     // was due at *when
    NEED_ENDING,  // it has ended in here
} need;

static bool has_room(const orr_stream *x)
{
    const size_t most = x->pacing == ORR_MSG_PACING_FREE ? ORR_STREAM_QUEUE_FREE : ORR_STREAM_QUEUE;
    return x->n < most && (x->n < 2 || x->bytes < ORR_STREAM_QUEUE_BYTES);
}

static void tell_gap(orr_stream *x, orr_time last, uint64_t blocks, uint8_t reason)
{
    uint8_t data[64];
    orr_wire_writer w = {data, 0, sizeof data, ORR_WIRE_OK};
    const orr_msg_gap m = {x->next, last, blocks < UINT32_MAX ? (uint32_t)blocks : UINT32_MAX, reason};
    orr_msg_gap_encode(&m, &w);
    x->gaps++;
    if (x->way != NULL) (void)x->way->put(x->way, ORR_MSG_TYPE_GAP, data, w.size);
    if (x->way != NULL && !x->way->lossy) return;
    orr_payload *b = orr_payload_new(&x->all->payloads, ORR_MSG_TYPE_GAP, data, w.size);
    if (b != NULL) streams_push(x, b);
}

// Leaves out the blocks whose instants are not after t.
static void skip_to(orr_stream *x, orr_time t, uint8_t reason)
{
    if (x->step_ns == 0) { // their lengths are not known: the next is the one that holds t
        tell_gap(x, t, 0, reason);
        x->next = t;
        return;
    }
    uint64_t blocks = (uint64_t)(orr_time_sub_ns(t, x->next) / x->step_ns) + 1;
    if (blocks > x->left) blocks = x->left;
    const orr_time last = orr_time_add(x->next, (int64_t)(blocks - 1) * x->step_ns); // not after t
    tell_gap(x, last, blocks, reason);
    x->next = orr_time_add(last, x->step_ns);
    if (x->left != UINT64_MAX) x->left -= blocks;
}

static bool has_ended(orr_stream *x)
{
    if (x->left == 0)
        streams_finish(x, ORR_MSG_END_REASON_FINISHED, "all epochs that were asked for have been sent");
    else if (x->next > x->last)
        streams_finish(x, ORR_MSG_END_REASON_OUTSIDE_SPAN, "what is served ends there");
    return x->ended;
}

// Whether a stream that goes by motion has a sample for its next block already.
static bool has_moved_to(const orr_streams *s, const orr_stream *x)
{
    return x->pacing == ORR_MSG_PACING_MOTION && s->options.vehicle != NULL &&
           orr_vehicle_reach(s->options.vehicle) >= x->next;
}

bool streams_follow_motion(const orr_streams *s)
{
    bool any = false;
    for (size_t k = 0; k < s->n && !any && s->pace.clock.state == ORR_CLOCK_RUNNING; k++)
        any = !s->stream[k]->ended && s->stream[k]->credit > 0 && has_moved_to(s, s->stream[k]);
    return any;
}

// A stream that follows the clock.
static need look_paced(orr_streams *s, orr_stream *x, int64_t now_ns, int64_t *when_ns)
{
    if (s->pace.clock.state != ORR_CLOCK_RUNNING) return NEED_NOTHING;
    for (;;) {
        if (has_ended(x)) return NEED_ENDING;
        const int64_t air_ns = orr_clock_when(&s->pace.clock, x->next);
        *when_ns = orr_time_add(air_ns, -x->lead_ns);
        if (now_ns < *when_ns && !has_moved_to(s, x)) return NEED_LATER;
        if (x->credit == 0) { // what passes meanwhile is told when there is credit
            x->dry = true;
            return NEED_NOTHING;
        }
        const bool late = now_ns - ORR_STREAM_GRACE_NS > air_ns;
        if (!late && has_room(x)) return NEED_NOW;
        if (!late) {
            *when_ns = orr_time_add(air_ns, ORR_STREAM_GRACE_NS + 1);
            return NEED_LATER;
        }
        if (!has_room(x)) {
            streams_finish(x, ORR_MSG_END_REASON_SLOW, "its blocks were not taken although there was credit");
            return NEED_ENDING;
        }
        skip_to(x, orr_clock_at(&s->pace.clock, now_ns),
                x->dry ? ORR_MSG_GAP_REASON_CREDIT : ORR_MSG_GAP_REASON_LATE);
        if (x->step_ns == 0) return NEED_NOW;
    }
}

static need look(orr_streams *s, orr_stream *x, int64_t now_ns, int64_t *when_ns)
{
    if (x->ended || x->closed) return NEED_NOTHING;
    if (x->epochs == NULL) { // beside those that are due now
        *when_ns = now_ns;
        return streams_has_modes(x) && x->credit > 0 && has_room(x) ? NEED_NOW : NEED_NOTHING;
    }
    if (x->pacing != ORR_MSG_PACING_FREE) return look_paced(s, x, now_ns, when_ns);
    if (has_ended(x)) return NEED_ENDING;
    *when_ns = INT64_MAX; // behind all that follow the clock
    return x->credit > 0 && has_room(x) ? NEED_NOW : NEED_NOTHING;
}

// The stream whose block comes next; NULL: none, and *later_ns is when to look again.
static orr_stream *choose(orr_streams *s, int64_t now_ns, int64_t *later_ns)
{
    orr_stream *first = NULL;
    int64_t first_ns = INT64_MAX;
    *later_ns = INT64_MAX;
    if (s->n > 0) s->turn = (s->turn + 1) % s->n; // so that equals take turns
    for (size_t k = 0; k < s->n; k++) {
        orr_stream *x = s->stream[(s->turn + k) % s->n];
        int64_t when_ns = INT64_MAX;
        const need what = look(s, x, now_ns, &when_ns);
        if (what == NEED_LATER && when_ns < *later_ns) *later_ns = when_ns;
        if (what != NEED_NOW || (first != NULL && when_ns >= first_ns)) continue;
        first = x;
        first_ns = when_ns;
    }
    return first;
}

// Whether the last block was made for the same question.
static bool was_made(const orr_streams *s, const orr_stream *x, orr_msg_epochs e)
{
    return s->made != NULL && s->made_type == x->type && s->made_epochs.t == e.t &&
           s->made_epochs.step == e.step && s->made_size == x->poll_size &&
           memcmp(s->made_poll + EPOCHS_SIZE, x->poll + EPOCHS_SIZE, x->poll_size - EPOCHS_SIZE) == 0;
}

// The payload of one block into the thread's room, without the lock. 0 or an ORR_MSG_ERROR_CODE.
static uint16_t encode(orr_streams *s, orr_stream *x, orr_wire_writer *w, orr_server_refusal *why)
{
    const orr_server *maker = s->options.maker;
    orr_server_part part = {.index = 0};
    *w = (orr_wire_writer){s->room, 0, ORR_MSG_LARGEST, ORR_WIRE_OK};
    do { // nobody ends a turn here, but a handler may return in between
        part.more = false;
        const uint16_t code =
            orr_msg_answer(maker->handlers, maker->user, x->type, &x->request, &part, w, why);
        if (code != 0) return code;
    } while (part.more);
    return w->status == ORR_WIRE_OK ? 0 : ORR_MSG_ERROR_CODE_INTERNAL;
}

static bool behind_channels(const orr_payload *b, orr_time *next)
{
    orr_msg_channels m;
    if (orr_msg_channels_decode(b->data, (uint32_t)b->size, &m) != ORR_WIRE_OK ||
        m.epoch.answer != ORR_MSG_ANSWER_OK)
        return false;
    *next = m.block + m.length;
    return true;
}

// Where the first of its frames ends; where nothing is sent, half a minute on.
static bool behind_frames(const orr_payload *b, orr_time *next)
{
    orr_msg_navdata m;
    if (orr_msg_navdata_decode(b->data, (uint32_t)b->size, &m) != ORR_WIRE_OK ||
        m.epoch.answer != ORR_MSG_ANSWER_OK)
        return false;
    *next = orr_time_add(m.epoch.t, NO_FRAME_NS);
    orr_msg_sat_navdata d;
    orr_wire_iter it = {0};
    while (orr_msg_sat_navdata_next(&m.satellites, &it, &d))
        if (d.answer == ORR_MSG_ANSWER_OK && d.frame_to > m.epoch.t && d.frame_to < *next) *next = d.frame_to;
    return true;
}

// Where a stream without a step goes on behind a block; false where there was none.
static bool behind_block(const orr_payload *b, orr_time *next)
{
    return b->type == ORR_MSG_TYPE_NAVDATA ? behind_frames(b, next) : behind_channels(b, next);
}

// How long before its instant the present block is made.
static void note_margin(orr_stream *x)
{
    const orr_streams *s = x->all;
    if (x->pacing == ORR_MSG_PACING_FREE || s->pace.clock.state != ORR_CLOCK_RUNNING) return;
    x->margin_ns = orr_clock_when(&s->pace.clock, x->next) - streams_now_ns(s);
    if (x->least_ns == ORR_TIME_NONE || x->margin_ns < x->least_ns) x->least_ns = x->margin_ns;
}

// Puts a block behind its stream's queue and moves the cursor.
static void deliver(orr_stream *x, orr_payload *b)
{
    orr_time next = orr_time_add(x->next, x->step_ns);
    if (x->step_ns == 0 && !behind_block(b, &next)) {
        streams_finish(x, ORR_MSG_END_REASON_OUTSIDE_SPAN,
                       x->type == ORR_MSG_TYPE_POLL_CHANNELS ? "the antenna is not there any more"
                                                             : "no navigation data are served there");
        return;
    }
    if (x->way == NULL) {
        b->owners++;
        streams_push(x, b);
    } else if (!x->way->put(x->way, b->type, b->data, b->size)) {
        streams_finish(x, ORR_MSG_END_REASON_FAILED,
                       "a block is larger than a slot of the ring or a datagram");
        return;
    }
    note_margin(x);
    x->blocks++;
    x->made = x->next;
    x->next = next;
    x->dry = false;
    x->credit--;
    if (x->left != UINT64_MAX) x->left--;
    (void)has_ended(x);
}

// Makes the next block of a stream; the lock is let go meanwhile.
static void make(orr_streams *s, orr_stream *x)
{
    if (x->epochs == NULL) {
        streams_make_modes(x);
        return;
    }
    const orr_msg_epochs e = {x->next, x->step_ns, 1};
    orr_server_refusal why = {""};
    uint16_t code = 0;
    orr_wire_writer w = {0};
    if (!was_made(s, x, e)) {
        if (s->made != NULL) orr_payload_drop(&s->payloads, s->made);
        s->made = NULL;
        x->making = true;
        *x->epochs = e;
        pthread_mutex_unlock(&s->lock);
        code = encode(s, x, &w, &why);
        pthread_mutex_lock(&s->lock);
        x->making = false;
        if (code == 0)
            s->made = orr_payload_new(&s->payloads, orr_message_of(x->type)->answer, w.data, w.size);
        s->made_type = x->type;
        s->made_epochs = e;
        s->made_size = x->poll_size;
        memcpy(s->made_poll, x->poll, x->poll_size);
    }
    if (x->closed)
        streams_forget(x);
    else if (s->made != NULL && !x->ended)
        deliver(x, s->made);
    else if (!x->ended)
        streams_finish(x, ORR_MSG_END_REASON_FAILED, code != 0 ? why.sentence : "out of memory");
}

int64_t orr_streams_turn(orr_streams *s, int64_t now_ns)
{
    int64_t later_ns;
    pthread_mutex_lock(&s->lock);
    streams_note_modes(s, now_ns);
    orr_stream *x = choose(s, now_ns, &later_ns);
    // A start that was fixed is noted when it comes.
    if (s->modes.now[ORR_MSG_MODE_KIND_CLOCK] == ORR_MSG_MODE_WAITING && s->pace.start_t != ORR_TIME_NONE) {
        const int64_t start_ns = orr_clock_when(&s->pace.clock, s->pace.start_t);
        if (start_ns < later_ns) later_ns = start_ns;
    }
    if (x != NULL) {
        make(s, x);
        later_ns = now_ns;
    }
    const bool wake = s->told;
    s->told = false;
    pthread_mutex_unlock(&s->lock);
    if (wake && s->options.wake != NULL) s->options.wake(s->options.wake_user);
    return later_ns;
}
