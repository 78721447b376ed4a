// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/service/serve_log.h"

#include <errno.h>
#include <limits.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

// A pipe that is ready has room for PIPE_BUF bytes, so one write of at most so many does not wait. (O_NONBLOCK
// would be a property of the open file, which other programs share.)
static bool put(int fd, const char *data, size_t n)
{
    struct pollfd p = {.fd = fd, .events = POLLOUT};
    int ready;
    do ready = poll(&p, 1, 0);
    while (ready < 0 && errno == EINTR);
    if (ready != 1 || (p.revents & POLLOUT) == 0) return false;
    ssize_t put;
    do put = write(fd, data, n);
    while (put < 0 && errno == EINTR);
    return put == (ssize_t)n;
}

bool orr_serve_log_say(orr_serve_log *l, const char *text)
{
    char line[1400];
    _Static_assert(sizeof line <= PIPE_BUF, "one write of a line does not wait");
    int n = 0;
    if (l->dropped > 0)
        n = snprintf(line, sizeof line, "orrery serve: %llu lines were dropped, nobody took them\n",
                     (unsigned long long)l->dropped);
    size_t at = (size_t)n;
    n = snprintf(line + at, sizeof line - at, "orrery serve: %.1200s\n", text);
    if (put(l->fd, line, at + (size_t)n)) {
        l->dropped = 0;
        return true;
    }
    l->dropped++;
    return false;
}

void orr_serve_log_write(void *user, orr_log_level level, const char *line)
{
    char text[1100];
    snprintf(text, sizeof text, "%s%s",
             level == ORR_LOG_ERROR  ? "error: "
             : level == ORR_LOG_WARN ? "warning: "
                                     : "",
             line);
    orr_serve_log_say(user, text);
}
