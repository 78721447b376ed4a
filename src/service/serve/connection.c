// SPDX-License-Identifier: GPL-3.0-or-later
// One client: bytes between its socket and the server's state machine. What has been read waits for its turn
// (src/service/serve/turns.h); replies go out by a direct write at the turn's end, so that an answered request costs
// one wait, one read and one write. Only what the socket does not take waits for a write event, and as long as
// something waits no request is answered: a slow client holds one output buffer, no more. Beside the answers go the
// frames of its streams, in a buffer of their own; the two take turns. Input is read all the same, as far as its
// buffer reaches: what a client says of its streams does not wait behind its requests.
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "src/service/serve/lanes.h"
#include "src/service/serve/service_private.h"

static const double linger_s = 0.5;
enum { MOST_FILLS = 6 }; // buffers of streams sent at one go

typedef enum conn_state {
    CONN_OPEN,
    CONN_ENDING, // no more requests; closes its side when the output is sent
    CONN_LINGER, // its side is closed; waits for the peer's end, so that what was sent is not lost by a reset
} conn_state;

// Whole frames that wait to be sent, from `at` on.
typedef struct output {
    uint8_t *data;
    size_t at, size, capacity;
} output;

struct orr_conn {
    orr_turns_member turn; // first, so that the member is the connection
    orr_service *service;
    orr_link *link;
    orr_guest guest;
    conn_state state;
    bool peer_done; // the peer will send nothing more
    orr_server_conn conn;
    uint8_t *in;
    size_t in_size, in_capacity;
    size_t looked;   // bytes of the input in which messages of lanes have been looked for
    output out;      // answers; the begin of a frame that is not finished stands behind its end
    output lane;     // frames of streams
    bool stuck;      // behind `looked` stands a message of lanes for whose answer there was no room
    bool lane_more;  // its streams may have more than one write should hold
    size_t pass_at;  // where in `lane` the frame begins that a descriptor goes along with
    bool lane_first; // which of the two is sent next; what has been begun goes first
    orr_lanes lanes;
    bool busy;  // an answer is not finished
    bool fresh; // bytes have come that the server has not seen
    bool yield; // and takes long: others come first
    bool half;  // the input holds the beginning of a frame
    bool joined, counted;
    orr_allowance requests;                // of its own, beside its address's
    uint64_t charged;                      // requests that have been taken from both
    uint64_t told_requests, told_refusals; // that the service's totals have
    int64_t held_until_ns; // it has asked more than it may: until then it waits. 0: it has not
    bool wants_write;
    int64_t turn_ends_ns;
    int64_t since_ns; // what the deadline counts from
    int64_t last_ns;  // last complete request
    orr_conn *next, *prev;
};

orr_conn *orr_conn_next(const orr_conn *c) { return c->next; }

static void uncount(orr_conn *c)
{
    c->counted = false;
    c->service->n_conns--;
    atomic_fetch_sub(&c->service->clients, 1);
}

void orr_conn_close(orr_conn *c)
{
    orr_service *s = c->service;
    if (c->prev != NULL)
        c->prev->next = c->next;
    else
        s->conns = c->next;
    if (c->next != NULL) c->next->prev = c->prev;
    if (c->counted) uncount(c);
    if (c->joined) orr_turns_leave(&s->turns, &c->turn);
    ORR_LOG(s->log, ORR_LOG_DEBUG, "%s gone after %llu requests", c->guest.peer,
            (unsigned long long)c->conn.requests);
    orr_link_close(c->link);
    orr_peers_leave(c->guest.account);
    orr_lanes_close(&c->lanes);
    free(c->in);
    free(c->out.data);
    free(c->lane.data);
    free(c);
}

static bool waits(const output *o) { return o->at < o->size; }
static bool has_answers(const orr_conn *c) { return waits(&c->out); }
static bool has_frames(const orr_conn *c) { return waits(&c->out) || waits(&c->lane); }
static bool has_output(const orr_conn *c) { return has_frames(c) || orr_link_unsent(c->link); }

static bool grow(uint8_t **data, size_t *capacity, size_t need)
{
    uint8_t *grown = realloc(*data, need);
    if (grown == NULL) return false;
    *data = grown;
    *capacity = need;
    return true;
}

// One call of the kernel's: up to the frame that a descriptor goes along with, then that frame, with it.
static ssize_t send_part(orr_conn *c, const output *o)
{
    if (o != &c->lane || c->lanes.n_pass == 0)
        return orr_link_send(c->link, o->data + o->at, o->size - o->at);
    if (o->at < c->pass_at) return orr_link_send(c->link, o->data + o->at, c->pass_at - o->at);
    const ssize_t n =
        orr_link_pass(c->link, o->data + o->at, o->size - o->at, c->lanes.pass, c->lanes.n_pass);
    if (n > 0) orr_lanes_passed(&c->lanes);
    return n;
}

// Sends what the socket takes of one buffer: 1: all, 0: not all, -1: the connection is lost.
static int send_some(orr_conn *c, output *o)
{
    while (waits(o)) {
        const ssize_t n = send_part(c, o);
        if (n > 0) {
            o->at += (size_t)n;
            c->since_ns = 0; // progress: the stall is counted anew
        } else if (n < 0 && errno == EINTR) {
            continue;
        } else if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
            return 0;
        } else {
            ORR_LOG(c->service->log, ORR_LOG_DEBUG, "%s: %s", c->guest.peer, strerror(errno));
            return -1;
        }
    }
    return 1;
}

// Takes frames of the streams while nothing of them waits. False: out of memory for a large one, whose turn it then never is.
static bool fill_lane(orr_conn *c)
{
    if (c->lanes.n == 0 || waits(&c->lane)) return true;
    if (c->lane.data == NULL && !grow(&c->lane.data, &c->lane.capacity, ORR_CONN_LANE)) return false;
    orr_wire_writer w = {c->lane.data, 0, c->lane.capacity, ORR_WIRE_OK};
    size_t need = orr_lanes_fill(&c->lanes, &w);
    if (need > 0 && w.size == 0) {
        if (!grow(&c->lane.data, &c->lane.capacity, need)) return false;
        w = (orr_wire_writer){c->lane.data, 0, c->lane.capacity, ORR_WIRE_OK};
        orr_lanes_fill(&c->lanes, &w);
    }
    c->lane.at = 0;
    c->lane.size = w.size;
    return true;
}

static void take_lanes(orr_conn *c);

// Brings the service's totals up to date, before a client can see that it has been answered.
static void tell_totals(orr_conn *c)
{
    atomic_fetch_add(&c->service->requests, c->conn.requests - c->told_requests);
    atomic_fetch_add(&c->service->refusals, c->conn.refusals - c->told_refusals);
    c->told_requests = c->conn.requests;
    c->told_refusals = c->conn.refusals;
}

// Sends what the socket takes, the two buffers in turns. False: the connection has been closed.
static bool flush(orr_conn *c)
{
    c->lane_more = false;
    for (int fills = 0;; fills++) {
        // Others come first after a while, however fast the streams are made.
        c->lane_more = fills >= MOST_FILLS && c->lanes.n > 0 && !waits(&c->lane);
        if (c->state == CONN_OPEN && !c->lane_more && !fill_lane(c)) break;
        if (!has_frames(c)) break;
        if (!waits(&c->lane))
            c->lane_first = false;
        else if (!waits(&c->out))
            c->lane_first = true;
        output *o = c->lane_first ? &c->lane : &c->out;
        tell_totals(c);
        const int sent = send_some(c, o);
        if (sent < 0) {
            orr_conn_close(c);
            return false;
        }
        if (sent == 0) break;
        if (o == &c->out) { // the begin of a frame that is not finished stays behind the output's end
            if (o->at > 0 && c->conn.unfinished > 0) memmove(o->data, o->data + o->at, c->conn.unfinished);
        }
        o->at = o->size = 0;
        if (c->stuck && o == &c->lane) {
            take_lanes(c);
            c->fresh = c->in_size > 0;
        }
        c->lane_first = !c->lane_first;
    }
    return true;
}

static void end(orr_conn *c)
{
    if (c->state != CONN_OPEN) return;
    c->state = CONN_ENDING;
    orr_lanes_close(&c->lanes);
    c->in_size = c->looked = 0;
    c->busy = false;
    c->conn.unfinished = 0;
    c->since_ns = 0;
}

// One ERROR straight to the socket, which is empty: it takes that much, or the peer is gone.
static void send_error(const orr_conn *c, uint16_t code, const char *sentence)
{
    uint8_t frame[ORR_FRAME_OVERHEAD + ORR_SERVER_SENTENCE + 64];
    orr_wire_writer w = {frame, 0, sizeof frame, ORR_WIRE_OK};
    orr_server_error(&w, code, sentence);
    if (orr_link_send(c->link, frame, w.size) < 0)
        ORR_LOG(c->service->log, ORR_LOG_DEBUG, "%s: %s", c->guest.peer, strerror(errno));
}

// Puts an ERROR behind the output, if there is room, and ends.
static void end_with(orr_conn *c, uint16_t code, const char *sentence)
{
    if (c->state != CONN_OPEN) return;
    if (c->out.data == NULL) { // a client that has sent nothing yet: its ERROR goes past the buffers
        send_error(c, code, sentence);
        end(c);
        return;
    }
    orr_wire_writer w = {c->out.data, c->out.size, c->out.capacity, ORR_WIRE_OK};
    orr_server_error(&w, code, sentence);
    c->out.size = w.size;
    end(c);
}

static bool turn_over(void *owner)
{
    const orr_conn *c = owner;
    return orr_service_clock_ns(c->service) >= c->turn_ends_ns;
}

// Only who has sent something has buffers.
static bool get_buffers(orr_conn *c)
{
    return grow(&c->in, &c->in_capacity, ORR_CONN_IN) && grow(&c->out.data, &c->out.capacity, ORR_CONN_OUT);
}

// Blocks that wait in the kernel grow old there, and hide that nobody takes them.
static void keep_short(const orr_conn *c)
{
    if (!orr_link_keep_short(c->link, ORR_CONN_KERNEL))
        ORR_LOG(c->service->log, ORR_LOG_DEBUG, "%s: SO_SNDBUF: %s", c->guest.peer, strerror(errno));
}

// Takes what the input holds for the connection's streams, wherever it stands among the requests.
static void take_lanes(orr_conn *c)
{
    while (c->lanes.streams != NULL && c->state == CONN_OPEN && c->in_size - c->looked >= ORR_FRAME_HEADER) {
        uint8_t *at = c->in + c->looked;
        orr_frame f;
        size_t used;
        if (!orr_msg_is_lane(
                orr_wire_load_u16(at + 6))) { // a request, or nothing that makes sense: the server's
            const size_t size = orr_wire_load_u32(at + 12);
            if (size > ORR_MSG_MAX_REQUEST || size + ORR_FRAME_OVERHEAD > c->in_size - c->looked) return;
            c->looked += size + ORR_FRAME_OVERHEAD;
            continue;
        }
        if (orr_frame_parse(at, c->in_size - c->looked, ORR_MSG_MAX_REQUEST, &f, &used) != ORR_WIRE_OK)
            return;
        if (c->lane.data == NULL && !grow(&c->lane.data, &c->lane.capacity, ORR_CONN_LANE)) return;
        orr_wire_writer w = {c->lane.data, c->lane.size, c->lane.capacity, ORR_WIRE_OK};
        const size_t streams = c->lanes.n;
        const bool passing = c->lanes.n_pass > 0;
        c->stuck = !orr_lanes_take(&c->lanes, &f, &w);
        if (!passing && c->lanes.n_pass > 0) c->pass_at = c->lane.size;
        if (c->stuck) return; // until what waits has been sent
        if (streams == 0 && c->lanes.n > 0) keep_short(c);
        c->lane.size = w.size;
        c->in_size -= used;
        memmove(at, at + used, c->in_size - c->looked);
        c->conn.requests++;
        c->last_ns = orr_service_clock_ns(c->service);
        c->since_ns = 0;
    }
}

// Answers what is in the input, as far as the output buffer allows.
static void answer(orr_conn *c)
{
    orr_wire_writer w = {c->out.data, c->out.size, c->out.capacity, ORR_WIRE_OK};
    orr_server_step step;
    uint64_t before = c->conn.requests;
    orr_server_run(c->service->server, &c->conn, c->in, c->stuck ? c->looked : c->in_size, &w, &step);
    c->out.size = w.size;
    c->busy = step.busy;
    c->fresh = false;
    c->yield = step.yield;
    c->in_size -= step.consumed;
    c->looked -= step.consumed < c->looked ? step.consumed : c->looked;
    if (c->in_size > 0 && step.consumed > 0) memmove(c->in, c->in + step.consumed, c->in_size);
    bool half = c->in_size > 0 && !c->busy;
    if (half && !c->half) c->since_ns = 0;
    c->half = half;
    if (c->conn.requests != before) {
        c->last_ns = orr_service_clock_ns(c->service);
        c->since_ns = 0;
    }
    if (step.closing != 0) {
        const char *name = orr_msg_error_code_name(step.closing);
        orr_service_tell(c->service, ORR_ID("N11") "%s%s%s: closing: %s (%s)", c->guest.peer,
                         c->conn.client[0] != '\0' ? ", " : "", c->conn.client, step.reason,
                         name != NULL ? name : "?");
        end(c);
        return;
    }
    // A request above the usual, whose length has been checked, or an answer; both have their limits.
    if ((!step.busy && step.need > c->in_capacity && !grow(&c->in, &c->in_capacity, step.need)) ||
        (step.room > c->out.capacity && !grow(&c->out.data, &c->out.capacity, step.room)))
        end_with(c, ORR_MSG_ERROR_CODE_INTERNAL, "the server is out of memory");
}

// Nothing is under way: all that was asked is answered and sent.
static bool at_rest(const orr_conn *c)
{
    return c->held_until_ns == 0 && c->state == CONN_OPEN && !c->busy && !has_output(c) &&
           c->turn.place == 0 && c->lanes.n == 0;
}

static void shut_down(orr_conn *c) { end_with(c, ORR_MSG_ERROR_CODE_CLOSING, "the server is shutting down"); }

// Whether there is room for more of its input, or can be.
static bool can_read(const orr_conn *c)
{
    return c->state != CONN_OPEN || c->in_size < c->in_capacity || c->in_capacity < ORR_CONN_IN_MOST;
}

// Takes what it has asked from what it and its address may ask.
static void charge(orr_conn *c)
{
    const double n = (double)(c->conn.requests - c->charged);
    c->charged = c->conn.requests;
    if (!c->guest.limited || n == 0 || c->state != CONN_OPEN) return;
    const orr_access_limits limits = orr_access_limits_of(c->service->access);
    c->held_until_ns =
        orr_peers_charge(&c->requests, c->guest.account, n, &limits, orr_service_clock_ns(c->service));
    if (c->held_until_ns != 0) atomic_fetch_add(&c->service->held, 1);
}

// False: it cannot be waited for.
static bool want(orr_conn *c, bool read, bool write)
{
    c->wants_write = write;
    return orr_link_want(c->link, read, write);
}

// What to wait for next; also closes when all is done. The connection may be gone afterwards.
static void settle(orr_conn *c)
{
    tell_totals(c);
    charge(c);
    if (c->peer_done && at_rest(c)) {
        orr_conn_close(c);
        return;
    }
    if (c->state == CONN_ENDING && !has_output(c)) {
        if (c->peer_done) {
            orr_conn_close(c);
            return;
        }
        orr_link_finish(c->link);
        c->state = CONN_LINGER;
        c->since_ns = 0;
    }
    bool write = has_output(c) || c->lane_more;
    // With streams its input is read whatever else is under way.
    const bool held = c->held_until_ns != 0 && c->state == CONN_OPEN;
    bool read = !c->peer_done && !held && (c->lanes.n > 0 ? can_read(c) : !write && !c->busy);
    if (!want(c, read, write)) { // nobody would ever hear of it again
        orr_service_tell(c->service, ORR_ID("N07") "out of memory for %s", c->guest.peer);
        orr_conn_close(c);
        return;
    }
    if ((c->busy || c->fresh) && !has_answers(c) && !held) orr_turns_wait(&c->service->turns, &c->turn);
}

// The last answer before a stop has gone out: until the next sweep it would answer what is asked meanwhile.
static void go_on(orr_conn *c)
{
    if (!flush(c)) return;
    if (c->service->draining && at_rest(c)) {
        shut_down(c);
        if (!flush(c)) return;
    }
    settle(c);
}

void orr_conn_turn(orr_turns_member *m)
{
    orr_conn *c = (orr_conn *)m;
    const int64_t begin_ns = orr_service_clock_ns(c->service);
    c->turn_ends_ns = begin_ns + ORR_CONN_TURN_NS;
    for (bool more = true; more && c->state == CONN_OPEN && !has_answers(c);) {
        answer(c);
        more = c->busy && !c->yield; // for want of room alone
        if (more && !flush(c)) return;
        more = more && !turn_over(c);
    }
    orr_turns_charge(&c->turn, orr_service_clock_ns(c->service) - begin_ns);
    go_on(c);
}

static void on_read(void *user)
{
    orr_conn *c = user;
    uint8_t waste[4096];
    bool open = c->state == CONN_OPEN;
    if (open && c->turn.place > 0 && c->lanes.n == 0) { // it waits for its turn with what it has sent before
        (void)want(c, false, c->wants_write);           // what is not read only makes it wait
        return;
    }
    if (open && c->in == NULL && !get_buffers(c)) {
        end_with(c, ORR_MSG_ERROR_CODE_INTERNAL, "the server is out of memory");
        go_on(c);
        return;
    }
    if (open && c->in_size == c->in_capacity &&
        (!can_read(c) || !grow(&c->in, &c->in_capacity, ORR_CONN_IN_MOST))) {
        (void)want(c, false, c->wants_write); // until requests have been answered
        return;
    }
    ssize_t n = orr_link_recv(c->link, open ? c->in + c->in_size : waste,
                              open ? c->in_capacity - c->in_size : sizeof waste);
    if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) return;
    if (n < 0 || (n == 0 && c->state == CONN_LINGER)) {
        orr_conn_close(c);
        return;
    }
    if (!open) return;
    if (n == 0) c->peer_done = true; // it may still be reading
    c->in_size += (size_t)n;
    take_lanes(c);
    if (n > 0) c->fresh = c->in_size > 0;
    if (n == 0)
        settle(c);
    else if (c->fresh && !has_answers(c))
        orr_turns_wait(&c->service->turns, &c->turn);
    else if (!c->fresh)
        go_on(c);
}

// What its client may do, to those who ask.
static void permit(orr_conn *c)
{
    orr_lanes_permit(&c->lanes, c->guest.may);
    c->conn.access = (uint16_t)(((c->guest.may & ORR_MAY_READ) == 0 ? ORR_MSG_ACCESS_NO_READING : 0) |
                                ((c->guest.may & ORR_MAY_MOTION) == 0 ? ORR_MSG_ACCESS_NO_MOTION : 0) |
                                ((c->guest.may & ORR_MAY_CONTROL) == 0 ? ORR_MSG_ACCESS_NO_CONTROL : 0) |
                                (c->guest.insecure ? ORR_MSG_ACCESS_INSECURE : 0));
}

static void on_write(void *user) { go_on(user); }

orr_conn *orr_conn_open(orr_service *s, orr_link *link, const orr_guest *guest)
{
    orr_conn *c = calloc(1, sizeof *c);
    if (c == NULL) {
        orr_service_tell(s, ORR_ID("N07") "out of memory for %s", guest->peer);
        orr_link_close(link);
        orr_peers_leave(guest->account);
        return NULL;
    }
    c->service = s;
    c->link = link;
    c->guest = *guest;
    c->next = s->conns;
    if (s->conns != NULL) s->conns->prev = c;
    s->conns = c;
    c->conn.can_grow = true;
    c->conn.over = turn_over;
    c->conn.owner = c;
    c->lanes = (orr_lanes){.streams = s->streams,
                           .judge = s->server,
                           .owner = c,
                           .datagrams = {.all = s->datagrams, .link = link},
                           .passes = orr_link_passes(link),
                           .base = s->loop.base};
    permit(c);
    orr_link_serve(link, c, on_read, on_write);
    c->last_ns = orr_service_clock_ns(s);
    c->joined = orr_turns_join(&s->turns, &c->turn);
    if (!c->joined) {
        orr_service_tell(s, ORR_ID("N07") "out of memory for %s", c->guest.peer);
        orr_conn_close(c);
        return NULL;
    }
    return c;
}

void orr_conn_readmit(orr_conn *c)
{
    if (c->state != CONN_OPEN || c->guest.name[0] == '\0') return;
    c->guest.may = orr_access_named(c->service->access, c->guest.name);
    permit(c);
    if (c->guest.may != ORR_MAY_NOTHING) return;
    orr_service_tell(c->service, ORR_ID("N14") "%s: closing: the access file does not name it any more",
                     c->guest.peer);
    orr_conn_refuse(c, ORR_MSG_ERROR_CODE_NOT_PERMITTED, "your permissions have been withdrawn");
}

void orr_conn_serve(orr_conn *c)
{
    ORR_LOG(c->service->log, ORR_LOG_DEBUG, "%s connected", c->guest.peer);
    c->counted = true;
    c->service->n_conns++;
    atomic_fetch_add(&c->service->clients, 1);
    go_on(c);
}

void orr_conn_refuse(orr_conn *c, uint16_t code, const char *sentence)
{
    end_with(c, code, sentence);
    if (c->counted) { // its place is free at once
        uncount(c);
    }
    go_on(c);
}

bool orr_conn_is_idle(const orr_conn *c) { return c->counted && at_rest(c); }
void orr_conn_stream(orr_conn *c)
{
    if (c->state == CONN_OPEN && flush(c)) settle(c);
}

void orr_conn_look(const orr_conn *c, int64_t now_ns, orr_client_look *out)
{
    *out = (orr_client_look){
        .requests = c->conn.requests, .quiet_ns = now_ns - c->last_ns, .n_streams = c->lanes.n};
    memcpy(out->peer, c->guest.peer, sizeof out->peer);
    snprintf(out->name, sizeof out->name, "%s", c->conn.client);
    for (size_t k = 0; k < c->lanes.n && k < ORR_CLIENT_STREAMS; k++)
        orr_stream_looked(c->lanes.stream[k], &out->stream[k]);
}

int64_t orr_conn_last_ns(const orr_conn *c) { return c->last_ns; }
const char *orr_conn_peer(const orr_conn *c) { return c->guest.peer; }

void orr_conn_sweep(orr_conn *c, int64_t now_ns)
{
    const orr_service_options *o = &c->service->options;
    if (c->held_until_ns != 0) {
        if (now_ns < c->held_until_ns) return;
        c->held_until_ns = 0;
        c->since_ns = 0;
        settle(c);
        return;
    }
    if (c->since_ns == 0) { // something has happened since the last look
        c->since_ns = now_ns;
        return;
    }
    double waited = (double)(now_ns - c->since_ns) * 1e-9, quiet = (double)(now_ns - c->last_ns) * 1e-9;
    const char *why = NULL;
    if (c->state == CONN_LINGER) {
        if (waited > linger_s) orr_conn_close(c);
        return;
    }
    if (c->turn.place > 0) return; // it waits for us
    if (has_output(c) || c->busy) {
        if (waited <= o->stall_s) return;
        orr_service_tell(c->service, ORR_ID("N12") "%s closed: it takes no answers", c->guest.peer);
        orr_conn_close(c); // it would not read an ERROR either
        return;
    }
    if (c->lanes.n > 0) { // it listens
        // One that says nothing more gives no credit either.
        if (c->peer_done && !orr_lanes_can_go_on(&c->lanes)) orr_conn_close(c);
        return;
    }
    if (c->in_size > 0 && waited > o->half_frame_s)
        why = "half a frame, and no more for too long";
    else if (c->in_size == 0 && c->conn.requests == 0 && quiet > o->first_s)
        why = "no request since the connection opened";
    else if (c->in_size == 0 && c->conn.requests > 0 && quiet > o->idle_s)
        why = "no request for too long";
    if (why == NULL) return;
    orr_service_tell(c->service, ORR_ID("N13") "%s: closing: %s", c->guest.peer, why);
    end_with(c, ORR_MSG_ERROR_CODE_TIMEOUT, why);
    go_on(c);
}

void orr_conn_drain(orr_conn *c, int64_t now_ns)
{
    orr_lanes_close(&c->lanes); // a stream has no end that could be waited for
    if (c->state == CONN_LINGER)
        orr_conn_sweep(c, now_ns);
    else if (at_rest(c)) {
        shut_down(c);
        go_on(c);
    }
}
