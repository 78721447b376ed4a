// SPDX-License-Identifier: GPL-3.0-or-later
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "src/service/serve/connection_private.h"

bool conn_waits(const output *o) { return o->at < o->size; }

bool conn_grow(uint8_t **data, size_t *capacity, size_t need)
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

int conn_send_some(orr_conn *c, output *o)
{
    while (conn_waits(o)) {
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

bool conn_fill_lane(orr_conn *c)
{
    if (c->lanes.n == 0 || conn_waits(&c->lane)) return true;
    if (c->lane.data == NULL && !conn_grow(&c->lane.data, &c->lane.capacity, ORR_CONN_LANE)) return false;
    orr_wire_writer w = {c->lane.data, 0, c->lane.capacity, ORR_WIRE_OK};
    size_t need = orr_lanes_fill(&c->lanes, &w);
    if (need > 0 && w.size == 0) {
        if (!conn_grow(&c->lane.data, &c->lane.capacity, need)) return false;
        w = (orr_wire_writer){c->lane.data, 0, c->lane.capacity, ORR_WIRE_OK};
        orr_lanes_fill(&c->lanes, &w);
    }
    c->lane.at = 0;
    c->lane.size = w.size;
    return true;
}
