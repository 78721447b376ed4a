// SPDX-License-Identifier: GPL-3.0-or-later
// The last lines of the service's log, kept for who opens a page. Lines come from any thread.
#ifndef ORR_SERVICE_HTTP_JOURNAL_H
#define ORR_SERVICE_HTTP_JOURNAL_H

#include "core/log.h"

enum { ORR_JOURNAL_LINES = 200, ORR_JOURNAL_TEXT = 300 };

typedef struct orr_journal_line {
    uint64_t number; // from 1
    int64_t unix_s;  // when it was written
    orr_log_level level;
    char text[ORR_JOURNAL_TEXT];
} orr_journal_line;

typedef struct orr_journal orr_journal;

// Begins an empty one; NULL: out of memory. Close it when nobody writes any more.
orr_journal *orr_journal_open(void);
void orr_journal_close(orr_journal *j); // NULL is allowed
// Keeps a line; a log's `write`, with the journal as its user.
void orr_journal_write(void *journal, orr_log_level level, const char *line);
// The oldest line that is kept with a number above `seen`; false: there is none.
bool orr_journal_next(orr_journal *j, uint64_t seen, orr_journal_line *out);

#endif
