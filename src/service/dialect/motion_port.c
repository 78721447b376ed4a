// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/dialect/motion_port.h"

#include <event2/event.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "src/service/net/loop.h"
#include "src/service/net/url.h"

struct orr_motion_port {
    int fd;
    uint16_t number;
    char where[ORR_URL_TEXT]; // as bound
    const orr_dialect *dialect;
    orr_streams *streams;
    orr_datagrams *datagrams;
    orr_dialect_state state;
    orr_loop loop;
    struct event *on_datagram;
};

static void reply_to(const orr_motion_port *p, const uint8_t *data, size_t n,
                     const struct sockaddr_storage *to, socklen_t n_to)
{
    const ssize_t sent =
        sendto(p->fd, data, n, MSG_NOSIGNAL | MSG_DONTWAIT, (const struct sockaddr *)to, n_to);
    (void)sent; // who asked may be gone
}

// A datagram of a client's channel: a frame of MOTION. What is not new and his is counted with the channel, not with the motion.
static void take_sealed(const orr_motion_port *p, const uint8_t *data, size_t n, bool local)
{
    orr_frame f;
    orr_msg_motion m;
    orr_server_refusal why;
    if (orr_datagrams_take(p->datagrams, data, n, local, &f) != ORR_DATAGRAM_TAKEN) return;
    if (f.type != ORR_MSG_TYPE_MOTION || orr_msg_motion_decode(f.payload, f.size, &m) != ORR_WIRE_OK)
        m = (orr_msg_motion){.order = 255}; // counted as dropped
    (void)orr_streams_motion(p->streams, &m, &why);
}

static void take_spoken(orr_motion_port *p, const uint8_t *data, size_t n,
                        const struct sockaddr_storage *from, socklen_t n_from)
{
    uint8_t reply[ORR_DIALECT_REPLY];
    size_t n_reply = 0;
    orr_msg_motion m;
    orr_msg_time now;
    orr_server_refusal why;
    orr_streams_time(p->streams, &now);
    p->state.now = now.t;
    p->state.begin = orr_streams_begin(p->streams);
    const orr_dialect_result result = p->dialect->take(&p->state, data, n, &m, reply, &n_reply);
    if (result == ORR_DIALECT_WRONG)
        m = (orr_msg_motion){.order = 255}; // counted as dropped: a datagram that is none
    if (result != ORR_DIALECT_NOTHING) (void)orr_streams_motion(p->streams, &m, &why);
    if (n_reply > 0) reply_to(p, reply, n_reply, from, n_from);
}

static void on_datagram(evutil_socket_t fd, short what, void *user)
{
    (void)what;
    orr_motion_port *p = user;
    uint8_t data[ORR_DIALECT_DATAGRAM + 1];
    struct sockaddr_storage from;
    socklen_t n_from = sizeof from;
    const ssize_t n = recvfrom(fd, data, sizeof data, MSG_DONTWAIT, (struct sockaddr *)&from, &n_from);
    if (n <= 0) return;
    const bool local = orr_address_is_local((struct sockaddr *)&from);
    if (orr_datagram_channel(data, (size_t)n) != 0)
        take_sealed(p, data, (size_t)n, local);
    else if (local) // others are answered nothing, and do not spoil the counts
        take_spoken(p, data, (size_t)n, &from, n_from);
}

// PORT, or ADDRESS:PORT.
static orr_status bind_port(orr_motion_port *p, const char *where, orr_diag *diag)
{
    char text[ORR_URL_TEXT];
    orr_url u, bound;
    snprintf(text, sizeof text, "tcp://%s%.200s", strchr(where, ':') == NULL ? "127.0.0.1:" : "", where);
    if (strspn(where, "0123456789") != strlen(where) && strrchr(where, ':') == NULL)
        return orr_diag_set(diag, ORR_E_ARG,
                            "'%.100s' is no place for datagrams: PORT or ADDRESS:PORT is wanted", where);
    orr_status s = orr_url_parse(text, &u, diag);
    if (s == ORR_OK) s = orr_url_bind_datagrams(&u, &p->fd, &bound, diag);
    if (s != ORR_OK) return s;
    if (!orr_url_is_local(&bound) && p->dialect != &orr_dialect_frames)
        return orr_diag_set(
            diag, ORR_E_ARG,
            "motion by UDP from other machines is sealed, and of the dialects 'orrery' alone has "
            "seals: leave out --dialect, or take a port of 127.0.0.1");
    snprintf(p->where, sizeof p->where, "%s", orr_url_text(&bound, text) + strlen("tcp://"));
    p->number = bound.port;
    return ORR_OK;
}

orr_status orr_motion_port_listen(const char *where, const orr_dialect *dialect, orr_motion_port **out,
                                  orr_diag *diag)
{
    orr_motion_port *p = calloc(1, sizeof *p);
    if (p == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    p->fd = -1;
    p->dialect = dialect;
    orr_status s = bind_port(p, where, diag);
    if (s == ORR_OK) s = orr_loop_open(&p->loop, NULL, NULL, diag);
    if (s == ORR_OK) p->on_datagram = event_new(p->loop.base, p->fd, EV_READ | EV_PERSIST, on_datagram, p);
    if (s == ORR_OK && (p->on_datagram == NULL || event_add(p->on_datagram, NULL) != 0))
        s = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (s != ORR_OK) {
        orr_motion_port_close(p);
        return s;
    }
    *out = p;
    return ORR_OK;
}

orr_status orr_motion_port_start(orr_motion_port *p, orr_streams *streams, orr_datagrams *datagrams,
                                 orr_diag *diag)
{
    p->streams = streams;
    p->datagrams = datagrams;
    orr_datagrams_listen(datagrams, p->number);
    return orr_loop_start(&p->loop, "motion", diag);
}

const char *orr_motion_port_where(const orr_motion_port *p) { return p->where; }

void orr_motion_port_close(orr_motion_port *p)
{
    if (p == NULL) return;
    orr_loop_halt(&p->loop);
    if (p->on_datagram != NULL) event_free(p->on_datagram);
    orr_loop_close(&p->loop);
    if (p->datagrams != NULL) orr_datagrams_listen(p->datagrams, 0);
    if (p->fd >= 0) close(p->fd);
    free(p);
}
