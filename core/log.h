// SPDX-License-Identifier: GPL-3.0-or-later
// Talk that is neither result nor error. Nothing below src/cli prints: it hands lines to the caller's
// callback, and the level is looked at before a line's arguments are evaluated.
#ifndef ORR_CORE_LOG_H
#define ORR_CORE_LOG_H

#include "core/status.h"

typedef enum orr_log_level {
    ORR_LOG_ERROR = 0,
    ORR_LOG_WARN = 1,
    ORR_LOG_INFO = 2,
    ORR_LOG_DEBUG = 3
} orr_log_level;

typedef struct orr_log {
    orr_log_level level;                                              // lines above it are not made
    void (*write)(void *user, orr_log_level level, const char *line); // line without newline
    void *user;
} orr_log;

// The begin of a line that has an id which stays whatever the sentence becomes, for programs that read logs: ORR_ID("N03") "%s refused".
#define ORR_ID(id) "[" id "] "

// Formats one line and hands it to log->write. Call it through ORR_LOG, which looks at the level.
//   Given:    log        where to; NULL, or one without `write`: nowhere
//             level      of the line
//             fmt, ...   the line without its newline, as of printf; cut with "..." at 1023 bytes
void orr_log_write(const orr_log *log, orr_log_level level, const char *fmt, ...) ORR_PRINTF(3, 4);

// A limit to lines that others cause: `burst` at once, then one every `every_ns`. Zero-initialise but for
// these two.
typedef struct orr_log_rate {
    int burst;
    int64_t every_ns;
    bool begun;
    int64_t spent_ns; // when all that was said is paid for
    uint64_t held;    // lines not said since the last one that was
} orr_log_rate;
// Whether a line may be said at a time of any monotonic clock; *held is how many before it were not.
bool orr_log_rate_allows(orr_log_rate *r, int64_t now_ns, uint64_t *held);

// ORR_LOG(log, ORR_LOG_INFO, "read %s", name); log may be NULL.
#define ORR_LOG(log, lvl, ...)                                                                               \
    do {                                                                                                     \
        if ((log) != NULL && (lvl) <= (log)->level) orr_log_write((log), (lvl), __VA_ARGS__);                \
    } while (0)

#endif
