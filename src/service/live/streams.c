// SPDX-License-Identifier: GPL-3.0-or-later
#define _GNU_SOURCE // processors, priorities, the timer's slack
#include "src/service/live/streams.h"

#include <errno.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <time.h>

#include "proto/fields.h"
#include "src/service/live/ring_made.h"
#include "src/service/live/streams_private.h"

enum { MOST_POLL = 16384 };
static const int64_t SHORTEST_NS = 1000000, LONGEST_NS = 60 * ORR_NS_PER_S, LONGEST_IMU_NS = ORR_NS_PER_S,
                     LONGEST_LEAD_NS = 60 * ORR_NS_PER_S,
                     START_NS = 60000000; // in which what the first block of channels needs is prepared

// Whether the host was suspended or its clock set, a few times a second.
static void compare_clocks(orr_streams *s, int64_t now_ns)
{
    static const int64_t every_ns = ORR_NS_PER_S / 5;
    if (s->looked_ns != 0 && now_ns - s->looked_ns < every_ns) return;
    pthread_mutex_lock(&s->lock);
    const orr_host h = streams_host(s); // in the order in which they are compared
    orr_pace_host(&s->pace, &h);
    pthread_mutex_unlock(&s->lock);
    s->looked_ns = now_ns;
}

static void *run(void *user)
{
    orr_streams *s = user;
    prctl(PR_SET_TIMERSLACK, 1UL); // wakes when it asked to, not up to 50 us later
    for (;;) {
        const int64_t begin_ns = streams_now_ns(s);
        compare_clocks(s, begin_ns);
        const int64_t next_ns = orr_streams_turn(s, begin_ns);
        pthread_mutex_lock(&s->lock);
        const bool stop = s->stop;
        const int64_t now_ns = streams_now_ns(s);
        // What has changed since the turn began has signalled to nobody.
        if (!stop && !s->changed_since && next_ns > now_ns) {
            const int64_t until = next_ns - now_ns > ORR_NS_PER_S ? now_ns + ORR_NS_PER_S : next_ns;
            const struct timespec ts = {until / ORR_NS_PER_S, until % ORR_NS_PER_S};
            pthread_cond_timedwait(&s->changed, &s->lock, &ts);
        }
        s->changed_since = false;
        pthread_mutex_unlock(&s->lock);
        if (stop) return NULL;
    }
}

static orr_status refuse(orr_diag *diag, const char *what, int error)
{
    return orr_diag_set(diag, ORR_E_IO, "%s: %s", what, strerror(error));
}

// As the machine allows: a priority and locked memory need CAP_SYS_NICE and CAP_IPC_LOCK, or limits that permit them.
static orr_status start_thread(orr_streams *s, orr_diag *diag)
{
    const orr_streams_options *o = &s->options;
    pthread_attr_t attr;
    if (o->lock_memory && mlockall(MCL_CURRENT | MCL_FUTURE) != 0)
        return refuse(diag, "memory cannot be locked (raise the limit: ulimit -l, or CAP_IPC_LOCK)", errno);
    if (pthread_attr_init(&attr) != 0) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (o->priority > 0) {
        const struct sched_param p = {.sched_priority = o->priority};
        pthread_attr_setinheritsched(&attr, PTHREAD_EXPLICIT_SCHED);
        pthread_attr_setschedpolicy(&attr, SCHED_FIFO);
        pthread_attr_setschedparam(&attr, &p);
    }
    orr_status status = ORR_OK;
    if (o->processor >= 0) {
        cpu_set_t set;
        CPU_ZERO(&set);
        if (o->processor < CPU_SETSIZE) CPU_SET((size_t)o->processor, &set);
        const int wrong = pthread_attr_setaffinity_np(&attr, sizeof set, &set);
        if (wrong != 0) status = refuse(diag, "no such processor", wrong);
    }
    if (status == ORR_OK) {
        const int wrong = pthread_create(&s->thread, &attr, run, s);
        s->has_thread = wrong == 0;
        if (wrong == EPERM)
            status = refuse(diag, "SCHED_FIFO is not permitted (raise the limit: ulimit -r, or CAP_SYS_NICE)",
                            wrong);
        else if (wrong == EINVAL)
            status = refuse(diag, "no such processor or priority", wrong);
        else if (wrong != 0)
            status = refuse(diag, "no thread", wrong);
    }
    pthread_attr_destroy(&attr);
    return status;
}

orr_status orr_streams_open(const orr_streams_options *options, orr_streams **out, orr_diag *diag)
{
    orr_streams *s = calloc(1, sizeof *s);
    if (s == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    s->options = *options;
    orr_pace_init(&s->pace, options->begin, options->leap);
    orr_modes_init(&s->modes);
    if (options->clock.state != ORR_CLOCK_STOPPED) s->pace.clock = options->clock;
    pthread_condattr_t attr;
    pthread_condattr_init(&attr);
    pthread_condattr_setclock(&attr, CLOCK_MONOTONIC);
    pthread_mutex_init(&s->lock, NULL);
    pthread_cond_init(&s->changed, &attr);
    pthread_condattr_destroy(&attr);
    s->room = malloc(ORR_MSG_LARGEST);
    s->made_poll = malloc(MOST_POLL);
    s->stream = calloc(ORR_STREAMS_MOST, sizeof(orr_stream *));
    orr_status status = ORR_OK;
    if (s->room == NULL || s->stream == NULL || s->made_poll == NULL)
        status = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    else if (options->host == NULL)
        status = start_thread(s, diag);
    if (status != ORR_OK) {
        orr_streams_close(s);
        return status;
    }
    *out = s;
    return ORR_OK;
}

// Lets go of the lock after something that the thread waits for may have changed. It is woken behind the lock, so that it does not
// wake only to wait for that.
static void unlock_changed(orr_streams *s)
{
    s->changed_since = true;
    pthread_mutex_unlock(&s->lock);
    pthread_cond_signal(&s->changed);
}

void orr_streams_halt(orr_streams *s)
{
    if (s == NULL || !s->has_thread) return;
    pthread_mutex_lock(&s->lock);
    s->stop = true;
    unlock_changed(s);
    pthread_join(s->thread, NULL);
    s->has_thread = false;
}

void orr_streams_close(orr_streams *s)
{
    if (s == NULL) return;
    orr_streams_halt(s);
    while (s->n > 0) streams_forget(s->stream[0]);
    if (s->made != NULL) orr_payload_drop(&s->payloads, s->made);
    orr_payloads_free(&s->payloads);
    pthread_cond_destroy(&s->changed);
    pthread_mutex_destroy(&s->lock);
    free(s->room);
    free(s->made_poll);
    free(s->stream);
    free(s);
}

// Another scenario, by whoever owns the service.
static uint16_t load(const orr_streams *s, const orr_msg_control *m, orr_server_refusal *why)
{
    char name[65];
    if (m->action != ORR_MSG_CONTROL_ACTION_LOAD) {
        snprintf(why->sentence, sizeof why->sentence, "CONTROL: a scenario is named with LOAD alone");
        return ORR_MSG_ERROR_CODE_BAD_REQUEST;
    }
    if (s->options.load == NULL) {
        snprintf(why->sentence, sizeof why->sentence,
                 "CONTROL: this server loads no other scenarios (serve --scenarios)");
        return ORR_MSG_ERROR_CODE_NOT_SERVED;
    }
    return s->options.load(s->options.load_user, orr_wire_text_copy(m->scenario, name, sizeof name), m->t,
                           why);
}

uint16_t orr_streams_control(orr_streams *s, const orr_msg_control *m, orr_msg_time *told,
                             orr_server_refusal *why)
{
    if (m->scenario.size > 0) {
        const uint16_t code = load(s, m, why);
        if (code == 0) orr_streams_time(s, told);
        return code;
    }
    const orr_host h = streams_host(s);
    pthread_mutex_lock(&s->lock);
    const uint16_t code = orr_pace_control(&s->pace, &h, m, why);
    orr_pace_time(&s->pace, &h, told);
    streams_note_modes(s, h.mono_ns);
    unlock_changed(s);
    return code;
}

uint16_t orr_streams_radio(orr_streams *s, const orr_msg_radio_time *m, orr_time made, orr_msg_pace *told,
                           orr_server_refusal *why)
{
    const orr_host h = streams_host(s);
    pthread_mutex_lock(&s->lock);
    const uint16_t code = orr_pace_radio(&s->pace, &h, m, why);
    orr_pace_told(&s->pace, &h, made, told);
    streams_note_modes(s, h.mono_ns);
    unlock_changed(s);
    return code;
}

uint16_t orr_streams_motion(orr_streams *s, const orr_msg_motion *m, orr_server_refusal *why)
{
    if (s->options.vehicle == NULL) {
        snprintf(why->sentence, sizeof why->sentence, "MOTION: this server takes no motion (serve --motion)");
        return ORR_MSG_ERROR_CODE_NOT_SERVED;
    }
    const orr_host h = streams_host(s);
    pthread_mutex_lock(&s->lock);
    const orr_time now =
        s->pace.clock.state == ORR_CLOCK_STOPPED ? ORR_TIME_NONE : orr_clock_at(&s->pace.clock, h.mono_ns);
    pthread_mutex_unlock(&s->lock);
    const uint16_t code = orr_vehicle_take(s->options.vehicle, m, now, why);
    if (code != 0) return code;
    pthread_mutex_lock(&s->lock);
    if (streams_follow_motion(s)) atomic_store(&s->moved, true);
    unlock_changed(s);
    return 0;
}

bool orr_streams_moved(orr_streams *s) { return s->has_thread && atomic_exchange(&s->moved, false); }

bool orr_streams_motion_stats(orr_streams *s, bool reset, orr_msg_motion_stats *told)
{
    if (s->options.vehicle != NULL) orr_vehicle_stats(s->options.vehicle, reset, told);
    return s->options.vehicle != NULL;
}

orr_time orr_streams_begin(orr_streams *s)
{
    pthread_mutex_lock(&s->lock);
    const orr_time begin = s->pace.begin;
    pthread_mutex_unlock(&s->lock);
    return begin;
}

orr_clock orr_streams_clock(orr_streams *s)
{
    pthread_mutex_lock(&s->lock);
    const orr_clock clock = s->pace.clock;
    pthread_mutex_unlock(&s->lock);
    return clock;
}

void orr_streams_time(orr_streams *s, orr_msg_time *told)
{
    pthread_mutex_lock(&s->lock);
    const uint64_t before = (uint64_t)s->pace.sets + s->pace.suspends;
    const orr_host h = streams_host(s);
    if (s->has_thread) orr_pace_host(&s->pace, &h); // what has happened since the thread last compared them
    orr_pace_time(&s->pace, &h, told);
    if ((uint64_t)s->pace.sets + s->pace.suspends != before)
        unlock_changed(s);
    else
        pthread_mutex_unlock(&s->lock);
}

orr_time orr_stream_made(orr_stream *x)
{
    pthread_mutex_lock(&x->all->lock);
    const orr_time made = x->made;
    pthread_mutex_unlock(&x->all->lock);
    return made;
}

static uint16_t wrong(orr_server_refusal *why, uint16_t code, const char *sentence)
{
    snprintf(why->sentence, sizeof why->sentence, "SUBSCRIBE: %.240s", sentence);
    return code;
}

static uint16_t check_step(uint16_t type, int64_t step_ns, orr_server_refusal *why)
{
    if (step_ns == 0 && (type == ORR_MSG_TYPE_POLL_CHANNELS || type == ORR_MSG_TYPE_POLL_NAVDATA)) return 0;
    const int64_t longest = type == ORR_MSG_TYPE_POLL_IMU ? LONGEST_IMU_NS : LONGEST_NS;
    if (step_ns >= SHORTEST_NS && step_ns <= longest) return 0;
    return wrong(why, ORR_MSG_ERROR_CODE_BAD_REQUEST,
                 type == ORR_MSG_TYPE_POLL_IMU ? "its step is 1 ms to 1 s" : "its step is 1 ms to 60 s");
}

// What can be streamed, decoded; its lists borrow the stream's own copy.
static uint16_t read_request(const orr_server *judge, const orr_msg_subscribe *m, orr_stream *x,
                             orr_server_refusal *why)
{
    static const uint16_t kinds[] = {
        ORR_MSG_TYPE_POLL,       ORR_MSG_TYPE_POLL_NAVDATA, ORR_MSG_TYPE_POLL_CHANNELS, ORR_MSG_TYPE_POLL_IMU,
        ORR_MSG_TYPE_POLL_TRUTH, ORR_MSG_TYPE_POLL_EVENTS,  ORR_MSG_TYPE_GET_MODES};
    bool known = false;
    for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) known = known || kinds[k] == m->request;
    if (!known)
        return wrong(why, ORR_MSG_ERROR_CODE_BAD_REQUEST,
                     "POLL, POLL_NAVDATA, POLL_CHANNELS, POLL_IMU, POLL_TRUTH, POLL_EVENTS and "
                     "GET_MODES can be streamed, nothing else");
    const bool modes = m->request == ORR_MSG_TYPE_GET_MODES; // which the streams know themselves
    if (!modes && orr_msg_handled(judge->handlers, m->request) == 0)
        return wrong(why, ORR_MSG_ERROR_CODE_NOT_SERVED, "this server does not answer that request");
    if (m->pacing > ORR_MSG_PACING_MOTION)
        return wrong(why, ORR_MSG_ERROR_CODE_BAD_REQUEST, "pacing is FREE, CLOCK or MOTION");
    if (m->delivery > ORR_MSG_DELIVERY_DATAGRAMS)
        return wrong(why, ORR_MSG_ERROR_CODE_BAD_REQUEST, "delivery is FRAMES, RING or DATAGRAMS");
    if (m->lead < 0 || m->lead > LONGEST_LEAD_NS)
        return wrong(why, ORR_MSG_ERROR_CODE_BAD_REQUEST, "lead is 0 to 60 s");
    if (orr_message_of(m->request)->decode(x->poll, x->poll_size, &x->request) != ORR_WIRE_OK)
        return wrong(why, ORR_MSG_ERROR_CODE_BAD_PAYLOAD,
                     "poll is not the payload of the request that is named");
    if (modes) return 0;
    const orr_record *r = orr_message_of(m->request)->record;
    x->epochs = (orr_msg_epochs *)(void *)((char *)&x->request + orr_record_field(r, "epochs")->offset);
    return 0;
}

// The first instant: that of the request, or the next one of the clock on the lattice of steps.
static uint16_t find_first(orr_streams *s, orr_stream *x, orr_msg_span span, orr_server_refusal *why)
{
    orr_time t = x->epochs->t;
    if (t == ORR_TIME_NONE) {
        t = span.first;
        if (x->pacing != ORR_MSG_PACING_FREE) {
            orr_msg_time now;
            orr_streams_time(s, &now);
            t = orr_time_add(now.t, x->lead_ns);
            if (s->options.expect != NULL && x->type == ORR_MSG_TYPE_POLL_CHANNELS)
                t = orr_time_add(t, START_NS);
            if (x->step_ns > 0)
                t = orr_time_add(t, x->step_ns - 1 - orr_floor_mod(orr_time_add(t, -1), x->step_ns));
            if (t < span.first) t = span.first;
        }
    }
    if (t < span.first || t > span.last)
        return wrong(why, ORR_MSG_ERROR_CODE_BAD_REQUEST,
                     "its first instant is outside the span that CAPS tells of the request");
    x->next = t;
    x->last = span.last;
    return 0;
}

static uint16_t prepare(orr_streams *s, const orr_server *judge, const orr_msg_subscribe *m, orr_stream *x,
                        orr_server_refusal *why)
{
    orr_msg_span span = {-INT64_MAX, INT64_MAX};
    uint16_t code = read_request(judge, m, x, why);
    if (code != 0) return code;
    x->type = m->request;
    x->pacing = m->pacing;
    x->lead_ns = m->lead;
    x->credit = m->credit;
    if (x->epochs == NULL) {
        streams_begin_modes(s, x);
        return 0;
    }
    x->step_ns = x->epochs->step;
    x->left = x->epochs->count > 0 ? x->epochs->count : UINT64_MAX;
    code = check_step(x->type, x->step_ns, why);
    if (code != 0) return code;
    if (judge->served != NULL && !judge->served(judge->user, x->type, &span))
        return wrong(why, ORR_MSG_ERROR_CODE_NOT_SERVED, "this scenario has nothing to answer it with");
    code = find_first(s, x, span, why);
    if (code != 0) return code;
    *x->epochs = (orr_msg_epochs){x->next, x->step_ns, 1};
    return orr_msg_begin(judge->handlers, judge->user, x->type, &x->request, why);
}

static uint16_t make_ring(orr_stream *x, orr_server_refusal *why)
{
    orr_diag diag = {0};
    if (orr_ring_way_open(&x->way, &diag) == ORR_OK) return 0;
    return wrong(why, ORR_MSG_ERROR_CODE_INTERNAL, diag.text);
}

uint16_t orr_streams_subscribe(orr_streams *s, const orr_server *judge, const orr_msg_subscribe *m,
                               orr_way *way, void *owner, orr_msg_subscribed *told, orr_stream **out,
                               orr_server_refusal *why)
{
    orr_stream *x = calloc(1, sizeof *x);
    if (x != NULL) x->poll = malloc(m->poll.size + (size_t)1);
    if (x == NULL || x->poll == NULL) {
        if (way != NULL) way->close(way);
        free(x);
        return wrong(why, ORR_MSG_ERROR_CODE_INTERNAL, "out of memory");
    }
    x->all = s;
    x->way = way;
    x->made = x->margin_ns = x->least_ns = ORR_TIME_NONE;
    x->owner = owner;
    x->poll_size = m->poll.size;
    if (m->poll.size > 0) memcpy(x->poll, m->poll.data, m->poll.size);
    uint16_t code = prepare(s, judge, m, x, why);
    if (code == 0 && m->delivery == ORR_MSG_DELIVERY_RING) code = make_ring(x, why);
    if (code != 0) {
        streams_free(x);
        return code;
    }
    *told = (orr_msg_subscribed){.first = x->next, .step = x->step_ns};
    if (s->options.expect != NULL) s->options.expect(s->options.maker->user, x->type, &x->request);
    pthread_mutex_lock(&s->lock);
    if (s->n < ORR_STREAMS_MOST && (orr_stream_ring(x) < 0 || s->n_rings < ORR_STREAMS_RINGS)) {
        s->n_rings += orr_stream_ring(x) >= 0;
        s->stream[s->n++] = x;
    } else {
        code = wrong(why, ORR_MSG_ERROR_CODE_LIMIT, "as many streams are open as this server allows");
    }
    unlock_changed(s);
    if (code != 0)
        streams_free(x);
    else
        *out = x;
    return code;
}

int orr_stream_ring(const orr_stream *x) { return x->way != NULL ? x->way->fd : -1; }

void orr_stream_credit(orr_stream *x, uint32_t blocks)
{
    orr_streams *s = x->all;
    pthread_mutex_lock(&s->lock);
    x->credit += blocks; // 2^64 blocks need 2^32 messages
    unlock_changed(s);
}

void orr_stream_end(orr_stream *x)
{
    orr_streams *s = x->all;
    pthread_mutex_lock(&s->lock);
    if (!x->ended) {
        const bool told = s->told; // of others, while the thread makes a block
        // What waits is not sent: another stream would go on from the first of it, and all payloads begin with their instant.
        if (x->n > 0) x->next = orr_wire_load_i64(x->queue[x->head]->data);
        while (x->n > 0) orr_payload_drop(&s->payloads, streams_pop(x));
        streams_finish(x, ORR_MSG_END_REASON_UNSUBSCRIBED, "as the client wished");
        s->told = told; // the caller looks at this one by itself
    }
    pthread_mutex_unlock(&s->lock);
}

void orr_stream_close(orr_stream *x)
{
    orr_streams *s = x->all;
    pthread_mutex_lock(&s->lock);
    if (x->listed) streams_unlist(x);
    x->closed = true;
    if (!x->making) streams_forget(x); // otherwise the thread does, when the block is made
    pthread_mutex_unlock(&s->lock);
}

void *orr_streams_ready(orr_streams *s)
{
    pthread_mutex_lock(&s->lock);
    orr_stream *x = s->ready;
    void *owner = NULL;
    if (x != NULL) {
        owner = x->owner;
        streams_unlist(x);
    }
    pthread_mutex_unlock(&s->lock);
    return owner;
}

orr_payload *orr_stream_next(orr_stream *x)
{
    orr_streams *s = x->all;
    pthread_mutex_lock(&s->lock);
    // A queue that was full may have held the thread up.
    const bool full = x->n >= ORR_STREAM_QUEUE_FREE || x->bytes > ORR_STREAM_QUEUE_BYTES / 2;
    orr_payload *b = x->n > 0 ? streams_pop(x) : NULL;
    if (b != NULL && full)
        unlock_changed(s);
    else
        pthread_mutex_unlock(&s->lock);
    return b;
}

void orr_stream_sent(orr_stream *x, orr_payload *b)
{
    pthread_mutex_lock(&x->all->lock);
    orr_payload_drop(&x->all->payloads, b);
    pthread_mutex_unlock(&x->all->lock);
}

void orr_stream_looked(orr_stream *x, orr_stream_look *out)
{
    pthread_mutex_lock(&x->all->lock);
    *out = (orr_stream_look){.request = x->type,
                             .pacing = x->pacing,
                             .lead_ns = x->lead_ns,
                             .made = x->made,
                             .blocks = x->blocks,
                             .gaps = x->gaps,
                             .credit = x->credit,
                             .waiting = x->n,
                             .margin_ns = x->margin_ns,
                             .least_ns = x->least_ns};
    pthread_mutex_unlock(&x->all->lock);
}
