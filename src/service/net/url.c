// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/net/url.h"

#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include "proto/gen/messages.h"

static orr_status not_a_url(const char *text, orr_diag *diag)
{
    return orr_diag_set(diag, ORR_E_ARG,
                        "'%.100s' is no address: tcp://HOST:PORT, tls://HOST:PORT or unix:PATH is wanted",
                        text);
}

static orr_status parse_tcp(const char *text, const char *rest, orr_url *out, orr_diag *diag)
{
    const char *host = rest, *end;
    size_t n;
    if (*rest == '[') {
        host = rest + 1;
        n = strcspn(host, "]");
        if (host[n] != ']') return not_a_url(text, diag);
        end = host + n + 1;
    } else {
        n = strcspn(host, ":/");
        end = host + n;
    }
    if (n >= sizeof out->host) return not_a_url(text, diag);
    for (size_t k = 0; k < n; k++)
        if (host[k] <= ' ' || host[k] > '~' || host[k] == '[') return not_a_url(text, diag);
    if (*rest == '[' && memchr(host, ':', n) == NULL) return not_a_url(text, diag); // brackets are IPv6's
    memcpy(out->host, n > 0 ? host : "127.0.0.1", n > 0 ? n : sizeof "127.0.0.1");
    if (n > 0) out->host[n] = '\0';
    out->port = ORR_MSG_PORT;
    if (*end == '\0') return ORR_OK;
    if (*end != ':' || end[1] < '0' || end[1] > '9') return not_a_url(text, diag);
    char *stop;
    unsigned long port = strtoul(end + 1, &stop, 10);
    if (*stop != '\0' || stop - end > 6) return not_a_url(text, diag);
    if (port > 65535) return orr_diag_set(diag, ORR_E_ARG, "'%.100s': a port is at most 65535", text);
    out->port = (uint16_t)port;
    return ORR_OK;
}

orr_status orr_url_parse(const char *text, orr_url *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    out->tls = strncmp(text, "tls://", 6) == 0;
    if (out->tls || strncmp(text, "tcp://", 6) == 0) return parse_tcp(text, text + 6, out, diag);
    if (strncmp(text, "unix:", 5) != 0 || text[5] == '\0') return not_a_url(text, diag);
    const char *path = text + 5;
    while (strncmp(path, "//", 2) == 0) path++; // unix:///run/x is what other programs write
    if (strlen(path) >= sizeof out->path)
        return orr_diag_set(diag, ORR_E_ARG, "'%.100s': the path of a Unix socket has at most %zu bytes",
                            text, sizeof out->path - 1);
    out->is_unix = true;
    memcpy(out->path, path, strlen(path) + 1);
    return ORR_OK;
}

char *orr_url_text(const orr_url *u, char buf[ORR_URL_TEXT])
{
    bool v6 = strchr(u->host, ':') != NULL;
    if (u->is_unix)
        snprintf(buf, ORR_URL_TEXT, "unix:%s", u->path);
    else
        snprintf(buf, ORR_URL_TEXT, "%s://%s%s%s:%u", u->tls ? "tls" : "tcp", v6 ? "[" : "", u->host,
                 v6 ? "]" : "", (unsigned)u->port);
    return buf;
}

static orr_status complain(const orr_url *u, const char *what, int error, orr_diag *diag)
{
    char text[ORR_URL_TEXT];
    orr_url_text(u, text);
    if (error == EADDRINUSE)
        return orr_diag_set(diag, ORR_E_IO, "%s %s: another program is listening there", what, text);
    return orr_diag_set(diag, ORR_E_IO, "%s %s: %s", what, text, strerror(error));
}

static void unix_address(const orr_url *u, struct sockaddr_un *a)
{
    memset(a, 0, sizeof *a);
    a->sun_family = AF_UNIX;
    memcpy(a->sun_path, u->path, sizeof u->path);
}

// A socket file outlives the server that was killed; one that nobody answers on is in nobody's way.
static orr_status clear_stale(const orr_url *u, orr_diag *diag)
{
    struct stat st;
    if (lstat(u->path, &st) != 0) return ORR_OK;
    if (!S_ISSOCK(st.st_mode))
        return orr_diag_set(diag, ORR_E_IO, "cannot listen on unix:%s: there is a file that is no socket",
                            u->path);
    struct sockaddr_un a;
    unix_address(u, &a);
    int fd = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (fd < 0) return complain(u, "cannot listen on", errno, diag);
    int answer = connect(fd, (struct sockaddr *)&a, sizeof a);
    int error = answer == 0 ? 0 : errno;
    close(fd);
    if (error != ECONNREFUSED) return complain(u, "cannot listen on", EADDRINUSE, diag);
    if (unlink(u->path) != 0 && errno != ENOENT)
        return complain(u, "cannot replace the old socket of", errno, diag);
    return ORR_OK;
}

static orr_status listen_unix(const orr_url *u, int backlog, int *fd, orr_diag *diag)
{
    orr_status s = clear_stale(u, diag);
    if (s != ORR_OK) return s;
    struct sockaddr_un a;
    unix_address(u, &a);
    *fd = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    // Its mode is set before it listens: until then nobody connects.
    if (*fd >= 0 && bind(*fd, (struct sockaddr *)&a, sizeof a) == 0 && chmod(u->path, 0660) == 0 &&
        listen(*fd, backlog) == 0)
        return ORR_OK;
    s = complain(u, "cannot listen on", errno, diag);
    if (*fd >= 0) close(*fd);
    return s;
}

// Every address of this machine, as a listener alone can have it.
static bool is_any(const orr_url *u) { return strcmp(u->host, "*") == 0; }

static orr_status resolve(const orr_url *u, struct addrinfo **list, orr_diag *diag)
{
    char port[8], text[ORR_URL_TEXT];
    snprintf(port, sizeof port, "%u", (unsigned)u->port);
    struct addrinfo hints = {.ai_socktype = SOCK_STREAM, .ai_flags = AI_NUMERICSERV | AI_PASSIVE};
    int error = getaddrinfo(is_any(u) ? NULL : u->host, port, &hints, list);
    if (error == 0) return ORR_OK;
    return orr_diag_set(diag, ORR_E_IO, "%s: %s", orr_url_text(u, text), gai_strerror(error));
}

// One socket of IPv6 takes clients of IPv4 too; only a machine without it needs the other.
static void ipv6_first(struct addrinfo **list)
{
    for (struct addrinfo **p = list; *p != NULL; p = &(*p)->ai_next) {
        struct addrinfo *a = *p;
        if (a->ai_family != AF_INET6) continue;
        *p = a->ai_next;
        a->ai_next = *list;
        *list = a;
        return;
    }
}

// The address of a bound socket of IP, with its host where that is wanted.
static bool name_socket(int fd, bool with_host, orr_url *bound)
{
    struct sockaddr_storage got;
    socklen_t n = sizeof got;
    char host[128], port[8];
    if (getsockname(fd, (struct sockaddr *)&got, &n) != 0 ||
        getnameinfo((struct sockaddr *)&got, n, host, sizeof host, port, sizeof port,
                    NI_NUMERICHOST | NI_NUMERICSERV) != 0)
        return false;
    if (with_host) memcpy(bound->host, host, sizeof host);
    bound->port = (uint16_t)strtoul(port, NULL, 10);
    return true;
}

orr_status orr_url_bind_datagrams(const orr_url *u, int *fd, orr_url *bound, orr_diag *diag)
{
    struct addrinfo *at = NULL, want = {.ai_socktype = SOCK_DGRAM, .ai_flags = AI_NUMERICHOST | AI_PASSIVE};
    struct sockaddr_storage a;
    socklen_t n = sizeof a;
    char port[8];
    const char *host = strcmp(u->host, "*") == 0           ? NULL
                       : strcmp(u->host, "localhost") == 0 ? "127.0.0.1"
                                                           : u->host;
    snprintf(port, sizeof port, "%u", (unsigned)u->port);
    *fd = -1;
    if (u->is_unix || getaddrinfo(host, port, &want, &at) != 0)
        return orr_diag_set(diag, ORR_E_ARG, "'%.100s' is no address of this machine: ADDRESS:PORT is wanted",
                            u->host);
    const int f = socket(at->ai_family, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    const bool good =
        f >= 0 && bind(f, at->ai_addr, at->ai_addrlen) == 0 && getsockname(f, (struct sockaddr *)&a, &n) == 0;
    const int error = errno;
    freeaddrinfo(at);
    if (!good) {
        if (f >= 0) close(f);
        return orr_diag_set(diag, ORR_E_IO, "UDP port %s of %s: %s", port, u->host, strerror(error));
    }
    *fd = f;
    *bound = *u;
    bound->port = ntohs(a.ss_family == AF_INET6 ? ((struct sockaddr_in6 *)(void *)&a)->sin6_port
                                                : ((struct sockaddr_in *)(void *)&a)->sin_port);
    return ORR_OK;
}

orr_status orr_url_of_socket(int fd, orr_url *out, orr_diag *diag)
{
    struct sockaddr_un a;
    socklen_t n = sizeof a;
    int listens = 0;
    socklen_t size = sizeof listens;
    memset(out, 0, sizeof *out);
    memset(&a, 0, sizeof a);
    if (getsockopt(fd, SOL_SOCKET, SO_ACCEPTCONN, &listens, &size) != 0 || listens == 0 ||
        getsockname(fd, (struct sockaddr *)&a, &n) != 0)
        return orr_diag_set(diag, ORR_E_ARG, "descriptor %d is no listening socket of a stream", fd);
    out->is_unix = a.sun_family == AF_UNIX;
    if (out->is_unix)
        memcpy(out->path, a.sun_path, sizeof out->path - 1);
    else if (!name_socket(fd, true, out))
        return orr_diag_set(diag, ORR_E_ARG, "descriptor %d is no socket of IP or of Unix", fd);
    return ORR_OK;
}

static orr_status listen_tcp(const orr_url *u, int backlog, int *fd, orr_url *bound, orr_diag *diag)
{
    struct addrinfo *list;
    orr_status s = resolve(u, &list, diag);
    if (s != ORR_OK) return s;
    int error = EADDRNOTAVAIL;
    *fd = -1;
    if (is_any(u)) ipv6_first(&list);
    for (struct addrinfo *a = list; a != NULL && *fd < 0; a = a->ai_next) {
        int one = 1, f = socket(a->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
        if (f >= 0) setsockopt(f, SOL_SOCKET, SO_REUSEADDR, &one, sizeof one);
        int v6_alone = is_any(u) ? 0 : 1;
        if (f >= 0 && a->ai_family == AF_INET6)
            setsockopt(f, IPPROTO_IPV6, IPV6_V6ONLY, &v6_alone, sizeof v6_alone);
        if (f >= 0 && bind(f, a->ai_addr, a->ai_addrlen) == 0 && listen(f, backlog) == 0) {
            *fd = f;
            break;
        }
        error = errno;
        if (f >= 0) close(f);
    }
    freeaddrinfo(list);
    if (*fd < 0) return complain(u, "cannot listen on", error, diag);
    (void)name_socket(*fd, !is_any(u), bound);
    return ORR_OK;
}

orr_status orr_url_listen(const orr_url *u, int backlog, int *fd, orr_url *bound, orr_diag *diag)
{
    *bound = *u;
    return u->is_unix ? listen_unix(u, backlog, fd, diag) : listen_tcp(u, backlog, fd, bound, diag);
}

bool orr_url_is_local(const orr_url *u)
{
    return u->is_unix || strncmp(u->host, "127.", 4) == 0 || strcmp(u->host, "::1") == 0;
}

bool orr_address_is_local(const struct sockaddr *a)
{
    if (a->sa_family == AF_INET) {
        const struct sockaddr_in *v4 = (const struct sockaddr_in *)(const void *)a;
        return ntohl(v4->sin_addr.s_addr) >> 24 == IN_LOOPBACKNET;
    }
    if (a->sa_family != AF_INET6) return false;
    const struct in6_addr *v6 = &((const struct sockaddr_in6 *)(const void *)a)->sin6_addr;
    return IN6_IS_ADDR_LOOPBACK(v6) || (IN6_IS_ADDR_V4MAPPED(v6) && v6->s6_addr[12] == IN_LOOPBACKNET);
}

static void set_timeouts(int fd, double timeout_s)
{
    struct timeval tv = {.tv_sec = (time_t)timeout_s};
    tv.tv_usec = (suseconds_t)((timeout_s - (double)tv.tv_sec) * 1e6);
    setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &tv, sizeof tv);
    setsockopt(fd, SOL_SOCKET, SO_SNDTIMEO, &tv, sizeof tv); // connect waits no longer than this either
}

orr_status orr_url_connect(const orr_url *u, double timeout_s, int *fd, orr_diag *diag)
{
    int error = 0, one = 1;
    *fd = -1;
    if (u->is_unix) {
        struct sockaddr_un a;
        unix_address(u, &a);
        int f = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
        if (f >= 0) set_timeouts(f, timeout_s);
        if (f >= 0 && connect(f, (struct sockaddr *)&a, sizeof a) == 0) return *fd = f, ORR_OK;
        error = errno;
        if (f >= 0) close(f);
        return complain(u, "cannot connect to", error, diag);
    }
    if (is_any(u))
        return orr_diag_set(diag, ORR_E_ARG, "tcp://* is where a server listens; a client needs one address");
    struct addrinfo *list;
    orr_status s = resolve(u, &list, diag);
    if (s != ORR_OK) return s;
    for (struct addrinfo *a = list; a != NULL && *fd < 0; a = a->ai_next) {
        int f = socket(a->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
        if (f >= 0) set_timeouts(f, timeout_s);
        if (f >= 0 && connect(f, a->ai_addr, a->ai_addrlen) == 0) {
            setsockopt(f, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
            *fd = f;
            break;
        }
        error = errno == EINPROGRESS ? ETIMEDOUT : errno;
        if (f >= 0) close(f);
    }
    freeaddrinfo(list);
    return *fd >= 0 ? ORR_OK : complain(u, "cannot connect to", error, diag);
}
