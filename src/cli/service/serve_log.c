// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/service/serve_log.h"

#include <errno.h>
#include <jansson.h>
#include <limits.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <time.h>
#include <unistd.h>

#define JOURNAL "/run/systemd/journal/socket"
enum { ID = 8, SENTENCE = 1200 };

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

// Divides "[N03] sentence"; the id is "" where there is none.
static const char *divide(const char *line, char id[ID])
{
    const char *end = line[0] == '[' ? strchr(line, ']') : NULL;
    id[0] = '\0';
    if (end == NULL || end - line > ID || end[1] != ' ') return line;
    snprintf(id, ID, "%.*s", (int)(end - line - 1), line + 1);
    return end + 2;
}

static const char *level_name(orr_log_level level)
{
    return level == ORR_LOG_ERROR  ? "error"
           : level == ORR_LOG_WARN ? "warning"
           : level == ORR_LOG_INFO ? "info"
                                   : "debug";
}

// --- One line in each form, into buf; how long it is, 0 where it cannot be made ---

static size_t as_text(char *buf, size_t n, orr_log_level level, const char *id, const char *sentence)
{
    const int k = snprintf(buf, n, "orrery serve: %s%.*s%s%s%s\n",
                           level == ORR_LOG_ERROR  ? "error: "
                           : level == ORR_LOG_WARN ? "warning: "
                                                   : "",
                           SENTENCE, sentence, id[0] != '\0' ? " [" : "", id, id[0] != '\0' ? "]" : "");
    return (size_t)k;
}

static size_t as_json(char *buf, size_t n, orr_log_level level, const char *id, const char *sentence)
{
    char when[40] = "";
    struct timespec t;
    struct tm utc;
    clock_gettime(CLOCK_REALTIME, &t);
    if (gmtime_r(&t.tv_sec, &utc) != NULL) {
        const size_t k = strftime(when, sizeof when, "%Y-%m-%dT%H:%M:%S", &utc);
        snprintf(when + k, sizeof when - k, ".%03ldZ", t.tv_nsec / 1000000);
    }
    char kept[SENTENCE + 1];
    snprintf(kept, sizeof kept, "%s", sentence);
    json_t *j = json_pack("{s:s, s:s, s:s, s:s}", "time", when, "level", level_name(level), "id", id,
                          "message", kept);
    size_t size = j != NULL ? json_dumpb(j, buf, n - 1, JSON_COMPACT | JSON_ENSURE_ASCII) : 0;
    json_decref(j);
    if (size == 0 || size > n - 1) return 0;
    buf[size++] = '\n';
    return size;
}

static size_t as_fields(char *buf, size_t n, orr_log_level level, const char *id, const char *sentence)
{
    static const int priority[] = {3, 4, 6, 7}; // of syslog
    const int k =
        snprintf(buf, n, "MESSAGE=%.*s\nPRIORITY=%d\nSYSLOG_IDENTIFIER=orrery\n%s%s%s", SENTENCE, sentence,
                 priority[level], id[0] != '\0' ? "ORRERY_ID=" : "", id, id[0] != '\0' ? "\n" : "");
    return (size_t)k;
}

static bool emit(orr_serve_log *l, orr_log_level level, const char *line)
{
    char buf[3 * PIPE_BUF / 4], id[ID]; // one write of it does not wait
    const char *sentence = divide(line, id);
    const size_t n = l->form == ORR_SERVE_LOG_TEXT   ? as_text(buf, sizeof buf, level, id, sentence)
                     : l->form == ORR_SERVE_LOG_JSON ? as_json(buf, sizeof buf, level, id, sentence)
                                                     : as_fields(buf, sizeof buf, level, id, sentence);
    if (n == 0) return false;
    if (l->form == ORR_SERVE_LOG_JOURNAL)
        return send(l->fd, buf, n, MSG_NOSIGNAL | MSG_DONTWAIT) == (ssize_t)n;
    return put(l->fd, buf, n);
}

static bool say(orr_serve_log *l, orr_log_level level, const char *line)
{
    if (l->dropped > 0) {
        char told[100];
        snprintf(told, sizeof told, ORR_ID("R08") "%llu lines were dropped, nobody took them",
                 (unsigned long long)l->dropped);
        if (emit(l, ORR_LOG_INFO, told)) l->dropped = 0;
    }
    if (l->dropped == 0 && emit(l, level, line)) return true;
    l->dropped++;
    return false;
}

orr_serve_log orr_serve_log_open(orr_serve_log_form form)
{
    orr_serve_log l = {.fd = STDERR_FILENO, .form = form};
    if (form != ORR_SERVE_LOG_JOURNAL) return l;
    const struct sockaddr_un a = {.sun_family = AF_UNIX, .sun_path = JOURNAL};
    const int fd = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (fd >= 0 && connect(fd, (const struct sockaddr *)&a, sizeof a) == 0) {
        l.fd = fd;
        return l;
    }
    if (fd >= 0) close(fd);
    l.form = ORR_SERVE_LOG_TEXT;
    return l;
}

void orr_serve_log_close(orr_serve_log *l)
{
    if (l->form == ORR_SERVE_LOG_JOURNAL) close(l->fd);
}

bool orr_serve_log_say(orr_serve_log *l, const char *line) { return say(l, ORR_LOG_INFO, line); }

void orr_serve_log_write(void *user, orr_log_level level, const char *line) { (void)say(user, level, line); }
