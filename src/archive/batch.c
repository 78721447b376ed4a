// SPDX-License-Identifier: GPL-3.0-or-later
#define _GNU_SOURCE // pipe2
#include "src/archive/batch.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/monotonic.h"
#include "src/archive/store.h"

#define RUN 8 // consecutive days that a process makes: neighbours share what is smoothed about a midnight
#define LOOK_MS 50 // how often stop() is asked while days are made

// What a process tells of a day, through a pipe.
typedef struct told {
    orr_status status;
    double seconds;
    orr_diag failure;
} told;

// A process with consecutive days [next, end) before it.
typedef struct worker {
    pid_t pid; // 0: free
    int from;  // the pipe; what arrived of the next message stands in told
    size_t n_told, next, end;
    told told;
} worker;

typedef struct run {
    const orr_batch *b;
    const orr_archive_index *index;
    orr_batch_report *report;
    size_t n_done, n_working;
    worker *worker;
    pid_t parent;
} run;

static void finish(run *r, size_t i, orr_batch_outcome outcome)
{
    orr_batch_day *day = &r->report->day[i];
    day->outcome = outcome;
    r->report->made += outcome == ORR_BATCH_MADE;
    r->report->fresh += outcome == ORR_BATCH_FRESH;
    r->report->failed += outcome == ORR_BATCH_FAILED;
    r->n_done++;
    if (r->b->done != NULL) r->b->done(r->b->user, day, r->n_done, r->report->n);
}

// In the child: days [first, end), then the end of it. The parent's death ends it too.
static _Noreturn void work(const run *r, size_t first, size_t end, int to)
{
    const int usual[] = {SIGTERM, SIGHUP, SIGQUIT, SIGALRM};
    for (size_t k = 0; k < sizeof usual / sizeof *usual; k++) signal(usual[k], SIG_DFL);
    signal(SIGINT, SIG_IGN); // Ctrl-C goes to the whole group: the parent says what ends
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != r->parent) _exit(1); // it died before that
    orr_archive_midnight last = {0};
    orr_archive_record *record = malloc(sizeof *record);
    for (size_t i = first; record != NULL && i < end; i++) {
        told t = {0};
        const double begin_s = orr_monotonic_s();
        const int32_t mjd = r->report->day[i].mjd;
        t.status = orr_archive_day_plan(&r->b->settings, r->index, mjd, record, &t.failure);
        if (t.status == ORR_OK)
            t.status = orr_archive_day_make(&r->b->settings, r->index, &last, record, &t.failure);
        t.failure.status = t.status;
        t.seconds = orr_monotonic_s() - begin_s;
        if (write(to, &t, sizeof t) != (ssize_t)sizeof t) _exit(1); // within a pipe's room: all or nothing
    }
    _exit(record != NULL ? 0 : 1);
}

static orr_status start(run *r, size_t first, size_t end, orr_diag *diag)
{
    int ends[2];
    worker *w = r->worker;
    while (w->pid != 0) w++;
    if (pipe2(ends, O_CLOEXEC) != 0)
        return orr_diag_set(diag, ORR_E_IO, "no pipe to another process: %s", strerror(errno));
    const pid_t pid = fork();
    if (pid == 0) {
        close(ends[0]);
        work(r, first, end, ends[1]);
    }
    close(ends[1]);
    if (pid < 0) {
        close(ends[0]);
        return orr_diag_set(diag, ORR_E_IO, "no further process: %s", strerror(errno));
    }
    *w = (worker){.pid = pid, .from = ends[0], .next = first, .end = end};
    r->n_working++;
    return ORR_OK;
}

// A process tells of its next day.
static void take(run *r, worker *w)
{
    orr_batch_day *day = &r->report->day[w->next];
    day->seconds = w->told.seconds;
    day->failure = w->told.failure;
    w->n_told = 0;
    w->next++;
    finish(r, w->next - 1, w->told.status == ORR_OK ? ORR_BATCH_MADE : ORR_BATCH_FAILED);
}

// A process has closed its pipe: it is done, or dead, and takes the day that it was at with it. The others go to another.
static orr_status collect(run *r, worker *w, orr_diag *diag)
{
    int status = 0;
    close(w->from);
    while (waitpid(w->pid, &status, 0) < 0 && errno == EINTR) {
    }
    w->pid = 0;
    r->n_working--;
    if (w->next == w->end) return ORR_OK;
    orr_diag_set(&r->report->day[w->next].failure, ORR_E_INTERRUPTED, "its process was ended%s%s",
                 WIFSIGNALED(status) ? " by a signal: " : "",
                 WIFSIGNALED(status) ? strsignal(WTERMSIG(status)) : "");
    finish(r, w->next, ORR_BATCH_FAILED);
    return w->next + 1 < w->end ? start(r, w->next + 1, w->end, diag) : ORR_OK;
}

// Waits a little for any process to tell something or to end.
static orr_status wait_for_any(run *r, orr_diag *diag)
{
    struct pollfd wait[256];
    worker *of[256];
    nfds_t n = 0;
    for (int k = 0; k < r->b->jobs && n < 256; k++)
        if (r->worker[k].pid != 0) {
            of[n] = &r->worker[k];
            wait[n++] = (struct pollfd){.fd = r->worker[k].from, .events = POLLIN};
        }
    orr_status s = ORR_OK;
    if (poll(wait, n, LOOK_MS) <= 0) return ORR_OK;
    for (nfds_t k = 0; s == ORR_OK && k < n; k++) {
        worker *w = of[k];
        if (wait[k].revents == 0) continue;
        char *to = (char *)&w->told;
        const ssize_t got = read(w->from, to + w->n_told, sizeof w->told - w->n_told);
        if (got > 0)
            w->n_told += (size_t)got;
        else
            s = collect(r, w, diag);
        if (w->n_told == sizeof w->told && w->next < w->end) take(r, w);
    }
    return s;
}

static void give_up(run *r)
{
    for (int k = 0; k < r->b->jobs; k++)
        if (r->worker[k].pid != 0) kill(r->worker[k].pid, SIGKILL);
    for (int k = 0; k < r->b->jobs; k++)
        if (r->worker[k].pid != 0) {
            close(r->worker[k].from);
            while (waitpid(r->worker[k].pid, NULL, 0) < 0 && errno == EINTR) {
            }
            r->worker[k].pid = 0;
        }
    (void)orr_archive_strays(r->b->settings.archive, true, NULL, NULL, NULL);
}

static bool stopped(const run *r) { return r->b->stop != NULL && r->b->stop(r->b->user); }

// Which days are to be made: the others are told at once.
static orr_status sort_out(run *r, orr_archive_index *index, bool *stale, orr_diag *diag)
{
    orr_archive_record *record = malloc(sizeof *record);
    orr_status s = record != NULL ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "no memory for a record");
    for (size_t i = 0; s == ORR_OK && i < r->report->n; i++) {
        orr_batch_day *day = &r->report->day[i];
        if (stopped(r)) {
            s = ORR_E_INTERRUPTED;
            break;
        }
        s = orr_archive_index_hash(index, day->mjd - 1, day->mjd + 1, diag);
        if (s != ORR_OK) break;
        if (orr_archive_day_plan(&r->b->settings, r->index, day->mjd, record, &day->failure) != ORR_OK)
            finish(r, i, ORR_BATCH_FAILED);
        else if (!r->b->again && orr_archive_day_is_fresh(&r->b->settings, record))
            finish(r, i, ORR_BATCH_FRESH);
        else
            stale[i] = true;
    }
    free(record);
    return s;
}

// Gives the stale days to processes, in runs of consecutive ones.
static orr_status make_all(run *r, const bool *stale, orr_diag *diag)
{
    orr_status s = ORR_OK;
    const size_t n = r->report->n;
    size_t share = 0, next = 0;
    for (size_t i = 0; i < n; i++) share += stale[i];
    share = (share + (size_t)r->b->jobs - 1) / (size_t)r->b->jobs;
    if (share > RUN) share = RUN;
    while (s == ORR_OK && (next < n || r->n_working > 0)) {
        while (next < n && !stale[next]) next++;
        if (stopped(r))
            s = ORR_E_INTERRUPTED;
        else if (next < n && r->n_working < (size_t)r->b->jobs) {
            const size_t first = next;
            while (next < n && stale[next] && next - first < share) next++;
            s = start(r, first, next, diag);
        } else if (r->n_working > 0)
            s = wait_for_any(r, diag);
    }
    return s;
}

orr_status orr_batch_run(const orr_batch *b, orr_archive_index *index, orr_batch_report *out, orr_diag *diag)
{
    run r = {.b = b, .index = index, .report = out, .parent = getpid()};
    *out = (orr_batch_report){0};
    if (b->last < b->first) return orr_diag_set(diag, ORR_E_ARG, "the last day is before the first");
    out->n = (size_t)(b->last - b->first + 1);
    out->day = calloc(out->n, sizeof *out->day);
    r.worker = calloc((size_t)b->jobs, sizeof *r.worker);
    bool *stale = calloc(out->n, sizeof *stale);
    orr_status s = ORR_OK;
    if (out->day == NULL || r.worker == NULL || stale == NULL)
        s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu days", out->n);
    for (size_t i = 0; s == ORR_OK && i < out->n; i++) out->day[i].mjd = b->first + (int32_t)i;
    if (s == ORR_OK) s = sort_out(&r, index, stale, diag);
    if (s == ORR_OK) s = make_all(&r, stale, diag);
    if (s == ORR_E_INTERRUPTED)
        orr_diag_set(diag, s, "interrupted: %zu of %zu days are done", r.n_done, out->n);
    if (r.worker != NULL) give_up(&r);
    free(stale);
    free(r.worker);
    return s;
}

void orr_batch_report_free(orr_batch_report *r)
{
    free(r->day);
    *r = (orr_batch_report){0};
}
