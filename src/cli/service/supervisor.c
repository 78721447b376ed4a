// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/service/supervisor.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

enum { FIRST_SOCKET = 3 };

// A number of the environment; -1 where there is none.
static long long number_of(const char *name)
{
    const char *text = getenv(name);
    char *end;
    if (text == NULL || *text < '0' || *text > '9') return -1;
    const long long n = strtoll(text, &end, 10);
    return *end == '\0' ? n : -1;
}

static bool is_for_us(const char *name)
{
    const long long pid = number_of(name);
    return pid < 0 || pid == (long long)getpid();
}

void orr_supervisor_find(orr_supervisor *s)
{
    const long long us = number_of("WATCHDOG_USEC");
    *s = (orr_supervisor){.every_ns = us > 0 && is_for_us("WATCHDOG_PID") ? us * 1000 / 3 : 0};
}

bool orr_supervisor_say(const char *message)
{
    const char *path = getenv("NOTIFY_SOCKET");
    struct sockaddr_un a = {.sun_family = AF_UNIX};
    if (path == NULL || (*path != '/' && *path != '@') || strlen(path) >= sizeof a.sun_path) return false;
    const size_t n = strlen(path);
    memcpy(a.sun_path, path, n);
    if (*path == '@') a.sun_path[0] = '\0'; // of the abstract names
    const int fd = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (fd < 0) return false;
    const socklen_t length = (socklen_t)(offsetof(struct sockaddr_un, sun_path) + n);
    const bool sent = sendto(fd, message, strlen(message), MSG_NOSIGNAL, (struct sockaddr *)&a, length) >= 0;
    close(fd);
    return sent;
}

void orr_supervisor_alive(orr_supervisor *s, int64_t now_ns)
{
    if (s->every_ns == 0 || (s->told_ns != 0 && now_ns - s->told_ns < s->every_ns)) return;
    s->told_ns = now_ns;
    (void)orr_supervisor_say("WATCHDOG=1"); // one who does not hear it says so by ending us
}

size_t orr_supervisor_sockets(orr_handed_socket out[ORR_SUPERVISOR_SOCKETS])
{
    const long long n = number_of("LISTEN_FDS");
    if (n <= 0 || n > ORR_SUPERVISOR_SOCKETS || number_of("LISTEN_PID") != (long long)getpid()) return 0;
    const char *names = getenv("LISTEN_FDNAMES");
    for (long long k = 0; k < n; k++) {
        const size_t length = names != NULL ? strcspn(names, ":") : 0;
        out[k] = (orr_handed_socket){.fd = FIRST_SOCKET + (int)k,
                                     .tls = length == 3 && strncmp(names, "tls", 3) == 0};
        if (names != NULL) names = names[length] == ':' ? names + length + 1 : NULL;
        (void)fcntl(out[k].fd, F_SETFD, FD_CLOEXEC);
        (void)fcntl(out[k].fd, F_SETFL, O_NONBLOCK);
    }
    return (size_t)n;
}
