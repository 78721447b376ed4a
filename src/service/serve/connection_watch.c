// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdio.h>
#include <string.h>

#include "src/service/serve/connection_private.h"

static const double linger_s = 0.5;

bool orr_conn_is_idle(const orr_conn *c) { return c->counted && conn_at_rest(c); }

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
        conn_settle(c);
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
    if (conn_has_output(c) || c->busy) {
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
    conn_end_with(c, ORR_MSG_ERROR_CODE_TIMEOUT, why);
    conn_go_on(c);
}

void orr_conn_drain(orr_conn *c, int64_t now_ns)
{
    orr_lanes_close(&c->lanes); // a stream has no end that could be waited for
    if (c->state == CONN_LINGER)
        orr_conn_sweep(c, now_ns);
    else if (conn_at_rest(c)) {
        conn_shut_down(c);
        conn_go_on(c);
    }
}
