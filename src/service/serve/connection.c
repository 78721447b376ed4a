// SPDX-License-Identifier: GPL-3.0-or-later
// One client: bytes between its socket and the server's state machine. What has been read waits for its turn
// (src/service/serve/turns.h); replies go out by a direct write at the turn's end, so that an answered request costs
// one wait, one read and one write. Only what the socket does not take waits for a write event, and as long as
// something waits no request is answered: a slow client holds one output buffer, no more. Beside the answers go the
// frames of its streams, in a buffer of their own; the two take turns. Input is read all the same, as far as its
// buffer reaches: what a client says of its streams does not wait behind its requests.
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "src/service/serve/connection_private.h"

enum { MOST_FILLS = 6 }; // buffers of streams sent at one go

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

static bool has_answers(const orr_conn *c) { return conn_waits(&c->out); }
static bool has_frames(const orr_conn *c) { return conn_waits(&c->out) || conn_waits(&c->lane); }
bool conn_has_output(const orr_conn *c) { return has_frames(c) || orr_link_unsent(c->link); }

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
        c->lane_more = fills >= MOST_FILLS && c->lanes.n > 0 && !conn_waits(&c->lane);
        if (c->state == CONN_OPEN && !c->lane_more && !conn_fill_lane(c)) break;
        if (!has_frames(c)) break;
        if (!conn_waits(&c->lane))
            c->lane_first = false;
        else if (!conn_waits(&c->out))
            c->lane_first = true;
        output *o = c->lane_first ? &c->lane : &c->out;
        tell_totals(c);
        const int sent = conn_send_some(c, o);
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

void conn_end_with(orr_conn *c, uint16_t code, const char *sentence)
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
    return conn_grow(&c->in, &c->in_capacity, ORR_CONN_IN) &&
           conn_grow(&c->out.data, &c->out.capacity, ORR_CONN_OUT);
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
        if (c->lane.data == NULL && !conn_grow(&c->lane.data, &c->lane.capacity, ORR_CONN_LANE)) return;
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
    if ((!step.busy && step.need > c->in_capacity && !conn_grow(&c->in, &c->in_capacity, step.need)) ||
        (step.room > c->out.capacity && !conn_grow(&c->out.data, &c->out.capacity, step.room)))
        conn_end_with(c, ORR_MSG_ERROR_CODE_INTERNAL, "the server is out of memory");
}

bool conn_at_rest(const orr_conn *c)
{
    return c->held_until_ns == 0 && c->state == CONN_OPEN && !c->busy && !conn_has_output(c) &&
           c->turn.place == 0 && c->lanes.n == 0;
}

void conn_shut_down(orr_conn *c)
{
    conn_end_with(c, ORR_MSG_ERROR_CODE_CLOSING, "the server is shutting down");
}

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

void conn_settle(orr_conn *c)
{
    tell_totals(c);
    charge(c);
    if (c->peer_done && conn_at_rest(c)) {
        orr_conn_close(c);
        return;
    }
    if (c->state == CONN_ENDING && !conn_has_output(c)) {
        if (c->peer_done) {
            orr_conn_close(c);
            return;
        }
        orr_link_finish(c->link);
        c->state = CONN_LINGER;
        c->since_ns = 0;
    }
    bool write = conn_has_output(c) || c->lane_more;
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
void conn_go_on(orr_conn *c)
{
    if (!flush(c)) return;
    if (c->service->draining && conn_at_rest(c)) {
        conn_shut_down(c);
        if (!flush(c)) return;
    }
    conn_settle(c);
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
    conn_go_on(c);
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
        conn_end_with(c, ORR_MSG_ERROR_CODE_INTERNAL, "the server is out of memory");
        conn_go_on(c);
        return;
    }
    if (open && c->in_size == c->in_capacity &&
        (!can_read(c) || !conn_grow(&c->in, &c->in_capacity, ORR_CONN_IN_MOST))) {
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
        conn_settle(c);
    else if (c->fresh && !has_answers(c))
        orr_turns_wait(&c->service->turns, &c->turn);
    else if (!c->fresh)
        conn_go_on(c);
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

static void on_write(void *user) { conn_go_on(user); }

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
    if (c->state != CONN_OPEN) return;
    const bool stays = orr_guest_readmit(&c->guest, c->service->access);
    permit(c);
    if (stays) return;
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
    conn_go_on(c);
}

void orr_conn_refuse(orr_conn *c, uint16_t code, const char *sentence)
{
    conn_end_with(c, code, sentence);
    if (c->counted) { // its place is free at once
        uncount(c);
    }
    conn_go_on(c);
}

void orr_conn_stream(orr_conn *c)
{
    if (c->state == CONN_OPEN && flush(c)) conn_settle(c);
}
