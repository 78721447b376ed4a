// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/generator/feed/link.h"

#include <errno.h>
#include <netdb.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <time.h>
#include <unistd.h>

#define TIMEOUT_S 20 // without progress of a read or write

struct orr_gen_link {
    orr_client client;
    int fd;
    char url[300];
    double patience_s;
    void (*log)(void *user, const char *text);
    void *user;
    uint8_t buffer[ORR_FRAME_OVERHEAD + ORR_MSG_LARGEST];
};

static ptrdiff_t link_read(void *user, uint8_t *data, size_t n)
{
    const orr_gen_link *l = user;
    ssize_t got;
    do got = read(l->fd, data, n);
    while (got < 0 && errno == EINTR);
    return got;
}

static ptrdiff_t link_write(void *user, const uint8_t *data, size_t n)
{
    const orr_gen_link *l = user;
    ssize_t sent;
    do sent = send(l->fd, data, n, MSG_NOSIGNAL);
    while (sent < 0 && errno == EINTR);
    return sent;
}

static void limit_waits(int fd)
{
    const struct timeval t = {TIMEOUT_S, 0};
    setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &t, sizeof t);
    setsockopt(fd, SOL_SOCKET, SO_SNDTIMEO, &t, sizeof t);
}

static bool connect_unix(orr_gen_link *l, const char *path, orr_gen_fault *fault)
{
    struct sockaddr_un a = {.sun_family = AF_UNIX};
    if (strlen(path) >= sizeof a.sun_path)
        return orr_gen_fail(fault, "%s: the path is too long for a socket", l->url);
    memcpy(a.sun_path, path, strlen(path) + 1);
    l->fd = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (l->fd >= 0 && connect(l->fd, (struct sockaddr *)&a, sizeof a) == 0) return true;
    const int why = errno;
    if (l->fd >= 0) close(l->fd);
    l->fd = -1;
    return orr_gen_fail(fault, "%s cannot be reached: %s", l->url, strerror(why));
}

static bool connect_tcp(orr_gen_link *l, const char *where, orr_gen_fault *fault)
{
    char host[256], port[16];
    snprintf(host, sizeof host, "%s", where);
    snprintf(port, sizeof port, "%u", ORR_MSG_PORT);
    char *colon = strrchr(host, ':'), *bracket = strchr(host, ']');
    if (colon != NULL && colon > bracket) {
        snprintf(port, sizeof port, "%s", colon + 1);
        *colon = '\0';
    }
    char *name = host;
    if (host[0] == '[' && bracket != NULL) name++, *bracket = '\0';
    const struct addrinfo hints = {.ai_socktype = SOCK_STREAM};
    struct addrinfo *list = NULL;
    const int bad = getaddrinfo(name, port, &hints, &list);
    if (bad != 0) return orr_gen_fail(fault, "%s: %s", l->url, gai_strerror(bad));
    int why = ECONNREFUSED;
    for (const struct addrinfo *a = list; a != NULL && l->fd < 0; a = a->ai_next) {
        l->fd = socket(a->ai_family, a->ai_socktype | SOCK_CLOEXEC, a->ai_protocol);
        if (l->fd >= 0 && connect(l->fd, a->ai_addr, a->ai_addrlen) == 0) break;
        why = errno;
        if (l->fd >= 0) close(l->fd);
        l->fd = -1;
    }
    freeaddrinfo(list);
    return l->fd >= 0 || orr_gen_fail(fault, "%s cannot be reached: %s", l->url, strerror(why));
}

static bool connect_once(orr_gen_link *l, orr_gen_fault *fault)
{
    bool done;
    if (strncmp(l->url, "unix:", 5) == 0)
        done = connect_unix(l, l->url + 5, fault);
    else if (strncmp(l->url, "tcp://", 6) == 0)
        done = connect_tcp(l, l->url + 6, fault);
    else
        return orr_gen_fail(fault, "%s: a service is named by tcp://HOST:PORT or unix:PATH", l->url);
    if (!done) return false;
    limit_waits(l->fd);
    orr_client_init(&l->client, (orr_client_io){l, link_read, link_write}, l->buffer, sizeof l->buffer);
    return true;
}

static double now_s(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void wait_s(double s)
{
    const struct timespec t = {(time_t)s, (long)((s - (double)(time_t)s) * 1e9)};
    nanosleep(&t, NULL);
}

static void keep_caps(const orr_msg_caps *caps, orr_gen_service *s)
{
    memset(s, 0, sizeof *s);
    orr_wire_text_copy(caps->title, s->title, sizeof s->title);
    s->leap = caps->leap;
    orr_wire_iter it = {0};
    orr_msg_signal signal;
    while (s->n_signals < ORR_MSG_MAX_SIGNALS && orr_msg_signal_next(&caps->signals, &it, &signal)) {
        orr_gen_signal_info *i = &s->signal[s->n_signals++];
        *i = (orr_gen_signal_info){.number = signal.signal, .system = (char)signal.system};
        orr_wire_text_copy(signal.name, i->name, sizeof i->name);
        i->carrier_hz = signal.carrier_hz;
        i->channel_hz = signal.channel_hz;
        i->chips_per_s = signal.chips_per_s;
    }
    orr_msg_antenna antenna;
    it = (orr_wire_iter){0};
    while (s->n_antennas < ORR_MSG_MAX_ANTENNAS && orr_msg_antenna_next(&caps->antennas, &it, &antenna))
        orr_wire_text_copy(antenna.name, s->antenna[s->n_antennas++], ORR_GEN_NAME);
    orr_msg_served_request request;
    it = (orr_wire_iter){0};
    while (orr_msg_served_request_next(&caps->requests, &it, &request)) {
        if (request.request == ORR_MSG_TYPE_POLL_CHANNELS) s->has_channels = true, s->channels = request.span;
        if (request.request == ORR_MSG_TYPE_POLL_NAVDATA) s->has_navdata = true, s->navdata = request.span;
    }
}

// Whether it is worth while to try again is said too: not where the service answers and refuses.
static bool hello(orr_gen_link *l, orr_gen_service *service, bool *again, orr_gen_fault *fault)
{
    orr_msg_caps caps;
    const orr_wire_status ws = orr_client_open(&l->client, "orrery-generator", ORR_VERSION, &caps);
    *again = ws == ORR_WIRE_IO || ws == ORR_WIRE_CLOSED;
    if (ws == ORR_WIRE_OK && service != NULL) keep_caps(&caps, service);
    if (ws == ORR_WIRE_OK) return true;
    close(l->fd);
    l->fd = -1;
    if (ws == ORR_WIRE_REFUSED) return orr_gen_fail(fault, "%s refuses: %s", l->url, l->client.sentence);
    return orr_gen_fail(fault, "%s: HELLO: %s", l->url, orr_wire_status_text(ws));
}

// A service that is being restarted refuses connections for a while, and one that is getting ready takes them and answers
// later; a URL that is none is refused at once.
static bool reach(orr_gen_link *l, orr_gen_service *service, orr_gen_fault *fault)
{
    const double until = now_s() + l->patience_s;
    for (double pause = 0.05;; pause = pause < 0.5 ? 2 * pause : 1.0) {
        bool again = strncmp(l->url, "unix:", 5) == 0 || strncmp(l->url, "tcp://", 6) == 0;
        if (connect_once(l, fault) && hello(l, service, &again, fault)) return true;
        if (!again || now_s() + pause > until) return false;
        wait_s(pause);
    }
}

bool orr_gen_link_open(const char *url, double patience_s, void (*log)(void *user, const char *text),
                       void *user, orr_gen_link **link, orr_gen_service *service, orr_gen_fault *fault)
{
    orr_gen_link *l = calloc(1, sizeof *l);
    *link = NULL;
    if (l == NULL) return orr_gen_fail(fault, "out of memory");
    *l = (orr_gen_link){.fd = -1, .patience_s = patience_s, .log = log, .user = user};
    snprintf(l->url, sizeof l->url, "%s", url);
    if (!reach(l, service, fault)) {
        orr_gen_link_close(l);
        return false;
    }
    *link = l;
    return true;
}

void orr_gen_link_close(orr_gen_link *link)
{
    if (link == NULL) return;
    if (link->fd >= 0) close(link->fd);
    free(link);
}

orr_client *orr_gen_link_client(orr_gen_link *link) { return &link->client; }

static void tell(const orr_gen_link *l, const char *text)
{
    if (l->log != NULL) l->log(l->user, text);
}

bool orr_gen_link_again(orr_gen_link *link, orr_wire_status status, const char *doing, orr_gen_fault *fault)
{
    orr_gen_link *l = link;
    const bool closing = status == ORR_WIRE_REFUSED && (l->client.error_code == ORR_MSG_ERROR_CODE_CLOSING ||
                                                        l->client.error_code == ORR_MSG_ERROR_CODE_TIMEOUT ||
                                                        l->client.error_code == ORR_MSG_ERROR_CODE_BUSY);
    if (status == ORR_WIRE_REFUSED && !closing)
        return orr_gen_fail(fault, "%s refuses %s: %s", l->url, doing, l->client.sentence);
    if (!closing && status != ORR_WIRE_IO && status != ORR_WIRE_CLOSED)
        return orr_gen_fail(fault, "%s: %s: %s", l->url, doing, orr_wire_status_text(status));
    close(l->fd);
    l->fd = -1;
    tell(l, "the service has gone; waiting for it to come back");
    if (!reach(l, NULL, fault)) {
        char why[sizeof fault->text];
        memcpy(why, fault->text, sizeof why);
        return orr_gen_fail(fault, "the service has gone and did not come back within %g s: %.450s",
                            l->patience_s, why);
    }
    tell(l, "the service is back");
    return true;
}
