// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/http/journal.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

struct orr_journal {
    pthread_mutex_t lock;
    uint64_t n; // lines so far; number k stands at (k - 1) % ORR_JOURNAL_LINES
    orr_journal_line line[ORR_JOURNAL_LINES];
};

orr_journal *orr_journal_open(void)
{
    orr_journal *j = calloc(1, sizeof *j);
    if (j != NULL) pthread_mutex_init(&j->lock, NULL);
    return j;
}

void orr_journal_close(orr_journal *j)
{
    if (j == NULL) return;
    pthread_mutex_destroy(&j->lock);
    free(j);
}

void orr_journal_write(void *journal, orr_log_level level, const char *line)
{
    orr_journal *j = journal;
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    pthread_mutex_lock(&j->lock);
    orr_journal_line *l = &j->line[j->n % ORR_JOURNAL_LINES];
    l->number = ++j->n;
    l->unix_s = now.tv_sec;
    l->level = level;
    snprintf(l->text, sizeof l->text, "%s", line);
    pthread_mutex_unlock(&j->lock);
}

bool orr_journal_next(orr_journal *j, uint64_t seen, orr_journal_line *out)
{
    pthread_mutex_lock(&j->lock);
    const uint64_t first = j->n > ORR_JOURNAL_LINES ? j->n - ORR_JOURNAL_LINES : 0;
    const uint64_t k = seen > first ? seen : first;
    const bool some = k < j->n;
    if (some) *out = j->line[k % ORR_JOURNAL_LINES];
    pthread_mutex_unlock(&j->lock);
    return some;
}
