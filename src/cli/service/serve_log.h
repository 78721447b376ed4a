// SPDX-License-Identifier: GPL-3.0-or-later
// What a running service says: on stderr as text or as JSON, a line each, or to the journal with fields. It may live longer than whoever
// reads that, and must not wait for one who does not: a line that cannot be taken at once is dropped and counted, and the count is said as
// soon as lines are taken again. A line that begins with ORR_ID has an id that stays (docs/operations.md).
#ifndef ORR_CLI_SERVICE_SERVE_LOG_H
#define ORR_CLI_SERVICE_SERVE_LOG_H

#include "core/log.h"

typedef enum orr_serve_log_form {
    ORR_SERVE_LOG_TEXT,    // "orrery serve: warning: sentence [id]"
    ORR_SERVE_LOG_JSON,    // {"time": ..., "level": ..., "id": ..., "message": ...}
    ORR_SERVE_LOG_JOURNAL, // MESSAGE, PRIORITY, SYSLOG_IDENTIFIER, ORRERY_ID
} orr_serve_log_form;

typedef struct orr_serve_log {
    int fd; // stderr, or a socket of the journal
    orr_serve_log_form form;
    uint64_t dropped; // lines since the last that was taken
} orr_serve_log;

// A log on stderr, or by a socket to the journal; stderr as text where there is none.
orr_serve_log orr_serve_log_open(orr_serve_log_form form);
// Closes what was opened.
void orr_serve_log_close(orr_serve_log *l);
// Says a line that is neither warning nor error. False: nobody takes it.
bool orr_serve_log_say(orr_serve_log *l, const char *line);
// `write` of an orr_log whose user is an orr_serve_log.
void orr_serve_log_write(void *user, orr_log_level level, const char *line);

#endif
