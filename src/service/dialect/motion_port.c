// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/dialect/motion_port.h"

#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <poll.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

struct orr_motion_port {
    int fd, stop[2];
    uint16_t number;
    const orr_dialect *dialect;
    orr_streams *streams;
    orr_dialect_state state;
    pthread_t thread;
    bool has_thread;
};

static void take_one(orr_motion_port *p)
{
    uint8_t data[ORR_DIALECT_DATAGRAM + 1], reply[ORR_DIALECT_REPLY];
    struct sockaddr_in from;
    socklen_t n_from = sizeof from;
    size_t n_reply = 0;
    orr_msg_motion m;
    orr_msg_time now;
    orr_server_refusal why;
    const ssize_t n = recvfrom(p->fd, data, sizeof data, 0, (struct sockaddr *)&from, &n_from);
    if (n <= 0) return;
    orr_streams_time(p->streams, &now);
    p->state.now = now.t;
    p->state.begin = orr_streams_begin(p->streams);
    const orr_dialect_result result = p->dialect->take(&p->state, data, (size_t)n, &m, reply, &n_reply);
    if (result == ORR_DIALECT_WRONG)
        m = (orr_msg_motion){.order = 255}; // counted as dropped: a datagram that is none
    if (result != ORR_DIALECT_NOTHING) (void)orr_streams_motion(p->streams, &m, &why);
    if (n_reply > 0 && sendto(p->fd, reply, n_reply, MSG_NOSIGNAL, (struct sockaddr *)&from, n_from) < 0)
        return; // who asked is gone
}

static void *run(void *user)
{
    orr_motion_port *p = user;
    for (;;) {
        struct pollfd f[2] = {{.fd = p->stop[0], .events = POLLIN}, {.fd = p->fd, .events = POLLIN}};
        if (poll(f, 2, -1) < 0) continue;
        if (f[0].revents != 0) return NULL;
        if (f[1].revents != 0) take_one(p);
    }
}

orr_status orr_motion_port_open(uint16_t port, const orr_dialect *dialect, orr_streams *streams,
                                orr_motion_port **out, orr_diag *diag)
{
    orr_motion_port *p = calloc(1, sizeof *p);
    if (p == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    p->dialect = dialect;
    p->streams = streams;
    p->stop[0] = p->stop[1] = -1;
    struct sockaddr_in at = {.sin_family = AF_INET, .sin_port = htons(port)};
    socklen_t n = sizeof at;
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    p->fd = socket(AF_INET, SOCK_DGRAM, 0);
    orr_status s = ORR_OK;
    if (p->fd < 0 || bind(p->fd, (struct sockaddr *)&at, sizeof at) != 0 ||
        getsockname(p->fd, (struct sockaddr *)&at, &n) != 0 || pipe(p->stop) != 0)
        s = orr_diag_set(diag, ORR_E_IO, "UDP port %u for motion: %s", (unsigned)port, strerror(errno));
    p->number = ntohs(at.sin_port);
    if (s == ORR_OK && pthread_create(&p->thread, NULL, run, p) != 0)
        s = orr_diag_set(diag, ORR_E_IO, "no thread for motion");
    p->has_thread = s == ORR_OK;
    if (s != ORR_OK) {
        orr_motion_port_close(p);
        return s;
    }
    *out = p;
    return ORR_OK;
}

uint16_t orr_motion_port_number(const orr_motion_port *p) { return p->number; }

void orr_motion_port_close(orr_motion_port *p)
{
    if (p == NULL) return;
    if (p->has_thread && write(p->stop[1], "s", 1) == 1) pthread_join(p->thread, NULL);
    if (p->fd >= 0) close(p->fd);
    for (int k = 0; k < 2; k++)
        if (p->stop[k] >= 0) close(p->stop[k]);
    free(p);
}
