// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/serve/motion_ring.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/eventfd.h>
#include <unistd.h>

// One message, whatever it is; samples that are refused are counted where all are (MOTION_STATS).
static void take(orr_motion_ring *r, uint16_t type, const uint8_t *data, size_t n)
{
    orr_msg_motion m;
    orr_server_refusal why;
    r->taken++;
    if (!r->may) return;
    if (type != ORR_MSG_TYPE_MOTION || orr_msg_motion_decode(data, (uint32_t)n, &m) != ORR_WIRE_OK)
        m = (orr_msg_motion){.order = 255}; // counted as dropped
    (void)orr_streams_motion(r->streams, &m, &why);
}

static void on_bell(evutil_socket_t fd, short what, void *user)
{
    (void)what;
    orr_motion_ring *r = user;
    uint64_t times;
    uint8_t data[ORR_MOTION_RING_STRIDE];
    uint16_t type;
    size_t n;
    if (read(fd, &times, sizeof times) < 0 && errno == EAGAIN) return;
    for (int k = 0; k < ORR_MOTION_RING_SLOTS; k++) {
        if (!orr_ring_read(&r->made.ring, &type, data, sizeof data, &n)) return;
        take(r, type, data, n);
    }
    event_active(r->on_bell, EV_READ, 0); // others come first after a ring's length
}

orr_status orr_motion_ring_open(struct event_base *base, orr_streams *streams, orr_motion_ring **out,
                                orr_diag *diag)
{
    orr_motion_ring *r = calloc(1, sizeof *r);
    if (r == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    r->streams = streams;
    r->may = true;
    r->bell = -1;
    orr_status s = orr_ring_made_theirs(&r->made, ORR_MOTION_RING_SLOTS, ORR_MOTION_RING_STRIDE, diag);
    if (s == ORR_OK && (r->bell = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) < 0)
        s = orr_diag_set(diag, ORR_E_IO, "no eventfd: %s", strerror(errno));
    if (s == ORR_OK) r->on_bell = event_new(base, r->bell, EV_READ | EV_PERSIST, on_bell, r);
    if (s == ORR_OK && (r->on_bell == NULL || event_add(r->on_bell, NULL) != 0))
        s = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (s != ORR_OK) {
        orr_motion_ring_close(r);
        return s;
    }
    *out = r;
    return ORR_OK;
}

void orr_motion_ring_close(orr_motion_ring *r)
{
    if (r == NULL) return;
    if (r->on_bell != NULL) event_free(r->on_bell);
    orr_ring_made_close(&r->made);
    if (r->bell >= 0) close(r->bell);
    free(r);
}
