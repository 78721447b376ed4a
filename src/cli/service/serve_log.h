// SPDX-License-Identifier: GPL-3.0-or-later
// What a running service says on stderr. It may live longer than whoever reads that, and must not wait for
// one who does not: a line that cannot be taken at once is dropped and counted, and the count is said as soon
// as lines are taken again.
#ifndef ORR_CLI_SERVICE_SERVE_LOG_H
#define ORR_CLI_SERVICE_SERVE_LOG_H

#include "core/log.h"

typedef struct orr_serve_log {
    int fd;
    uint64_t dropped; // lines since the last that was taken
} orr_serve_log;

// Says "orrery serve: TEXT" and a newline. False: nobody takes it.
bool orr_serve_log_say(orr_serve_log *l, const char *text);
// `write` of an orr_log whose user is an orr_serve_log.
void orr_serve_log_write(void *user, orr_log_level level, const char *line);

#endif
