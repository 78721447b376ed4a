// SPDX-License-Identifier: GPL-3.0-or-later
// Many files at once: each goes through its places (tier by tier, name by name, mirror by mirror) until one
// of them gives a file that our reader can read.
#include "ingest/fetch/fetch.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/monotonic.h"
#include "ingest/fetch/fetch_private.h"

#define MAX_MIRROR_LINES 10000

typedef enum job_state { JOB_READY, JOB_ACTIVE, JOB_DONE } job_state;

typedef struct job {
    orr_fetch_item *item;
    orr_candidate *place;
    size_t n_places, at;
    int attempt; // at this place, from 1
    double not_before;
    job_state state;
    fetch_transfer transfer;
    char path[1024]; // in the cache, of place[at]
    bool cache_looked_at;
    bool waits;            // for another program's transfer
    bool afresh_done;      // the part was dropped once at this place
    int64_t received_then; // of the transfer, when it last moved
    double moved_at;
} job;

typedef struct fetcher {
    const orr_fetch_options *o;
    CURLM *multi;
    job *job;
    size_t n, active, done;
    int64_t bytes;
    fetch_index index;
    bool *down; // mirrors that cannot be reached, by mirror_index
    orr_diag *diag;
} fetcher;

orr_fetch_options orr_fetch_default_options(const char *cache_dir)
{
    return (orr_fetch_options){.cache_dir = cache_dir,
                               .parallel = 4,
                               .attempts = 3,
                               .backoff_s = 2,
                               .stall_s = 30,
                               .connect_s = 15,
                               .max_bytes = (size_t)2 << 30};
}

static void finish(fetcher *f, job *j, orr_status s, const char *reason)
{
    j->state = JOB_DONE;
    j->item->status = s;
    if (reason != NULL) snprintf(j->item->reason, sizeof j->item->reason, "%s", reason);
    f->done++;
}

static const char *place_text(const orr_candidate *c, char buf[192])
{
    snprintf(buf, 192, "%s from %s", c->name, c->mirror);
    return buf;
}

// On to the next place; says so.
static void next_place(fetcher *f, job *j, const char *why)
{
    char was[192], next[192];
    const orr_candidate *c = &j->place[j->at];
    snprintf(j->item->reason, sizeof j->item->reason, "%s: %s", place_text(c, was), why);
    j->at++;
    while (j->at < j->n_places && f->down[j->place[j->at].mirror_index]) j->at++;
    j->attempt = 0;
    j->not_before = 0;
    j->cache_looked_at = j->afresh_done = false;
    if (j->at >= j->n_places) {
        ORR_LOG(f->o->log, ORR_LOG_WARN, "%s: %s; no place is left", was, why);
        char reason[sizeof j->item->reason];
        snprintf(reason, sizeof reason, "none of %zu places has it; the last was %.380s", j->n_places,
                 j->item->reason);
        finish(f, j, ORR_E_NODATA, reason);
        return;
    }
    const orr_candidate *d = &j->place[j->at];
    ORR_LOG(f->o->log, ORR_LOG_WARN, "%s: %s; trying %s%s%s", was, why, place_text(d, next),
            d->tier != c->tier ? ", tier " : "", d->tier != c->tier ? orr_tier_name(d->tier) : "");
}

// A good file is at j->path.
static void settle(fetcher *f, job *j, bool from_cache, const char *sha256, int64_t bytes)
{
    orr_fetch_item *item = j->item;
    item->found = j->place[j->at];
    item->from_cache = from_cache;
    if (from_cache) snprintf(item->found.mirror, sizeof item->found.mirror, "cache");
    snprintf(item->path, sizeof item->path, "%s", j->path);
    snprintf(item->sha256, sizeof item->sha256, "%s", sha256);
    item->bytes = bytes;
    item->reason[0] = '\0';
    finish(f, j, ORR_OK, NULL);
}

// Looks for place[at] in the cache. True if it is there and good; a file that is not what the index says is
// put away.
static bool in_cache(fetcher *f, job *j)
{
    struct stat st;
    char sha[ORR_SHA256_HEX];
    orr_diag d = {0};
    const orr_candidate *c = &j->place[j->at];
    if (fetch_cache_path(f->o->cache_dir, c, false, j->path, sizeof j->path, &d) != ORR_OK) return false;
    if (stat(j->path, &st) != 0 || !S_ISREG(st.st_mode)) return false;
    if (orr_sha256_file(j->path, sha, &d) != ORR_OK) return false;
    if (j->waits) { // another program has written the index meanwhile
        fetch_index_free(&f->index);
        (void)fetch_index_read(f->o->cache_dir, &f->index, &d);
        j->waits = false;
    }
    const fetch_entry *e = fetch_index_find(&f->index, f->o->cache_dir, j->path);
    if (e != NULL && (e->bytes != st.st_size || strcmp(e->sha256, sha) != 0)) {
        ORR_LOG(f->o->log, ORR_LOG_WARN,
                "%s in the cache is not the file that was fetched (its SHA-256 differs); %s", c->name,
                f->o->offline ? "it is not used" : "it is fetched again");
        return false;
    }
    if (e == NULL) { // put there by hand
        if (fetch_check(j->path, &j->item->wanted, &d) != ORR_OK) {
            ORR_LOG(f->o->log, ORR_LOG_WARN, "%s in the cache is not used: %s", c->name, d.text);
            return false;
        }
        if (fetch_index_put(f->o->cache_dir, j->path, st.st_size, sha, "(found in the cache)", &d) != ORR_OK)
            ORR_LOG(f->o->log, ORR_LOG_WARN, "%s", d.text);
    }
    settle(f, j, true, sha, st.st_size);
    return true;
}

static bool same_file_is_active(const fetcher *f, const job *j)
{
    for (size_t i = 0; i < f->n; i++) {
        const job *k = &f->job[i];
        if (k != j && k->state == JOB_ACTIVE && strcmp(k->path, j->path) == 0) return true;
    }
    return false;
}

// Looks into the cache and starts the transfer of place[at] if it can be now.
static void begin(fetcher *f, job *j)
{
    const orr_candidate *c = &j->place[j->at];
    orr_diag d = {0};
    if (!j->cache_looked_at) {
        if (in_cache(f, j)) return;
        j->cache_looked_at = true;
        if (f->o->offline) {
            // Mirrors of one name are one file in the cache.
            while (j->at + 1 < j->n_places && strcmp(j->place[j->at + 1].name, c->name) == 0) j->at++;
            j->at++;
            j->cache_looked_at = false;
            if (j->at >= j->n_places)
                finish(f, j, ORR_E_NODATA, "not in the cache, and --offline asks nobody else");
            return;
        }
    }
    orr_status s = fetch_cache_path(f->o->cache_dir, c, true, j->path, sizeof j->path, &d);
    if (s == ORR_OK && same_file_is_active(f, j)) { // a weekly file wanted for several days
        j->cache_looked_at = false;
        j->not_before = orr_monotonic_s() + 0.05;
        return;
    }
    if (s == ORR_OK) s = fetch_transfer_start(&j->transfer, f->o, c, j->path, &d);
    if (s == ORR_OK && j->transfer.busy) { // what comes of it is looked for in the cache
        if (!j->waits)
            ORR_LOG(f->o->log, ORR_LOG_INFO, "%s: another program is fetching it; waiting", c->name);
        j->waits = true;
        j->cache_looked_at = false;
        j->not_before = orr_monotonic_s() + 0.1;
        return;
    }
    if (s == ORR_OK && curl_multi_add_handle(f->multi, j->transfer.easy) != CURLM_OK) {
        fetch_transfer_drop(&j->transfer);
        s = orr_diag_set(&d, ORR_E_IO, "libcurl cannot start %s", c->url);
    }
    if (s != ORR_OK) {
        char text[700];
        finish(f, j, s, orr_diag_format(&d, text, sizeof text));
        return;
    }
    if (j->transfer.resumed_from > 0)
        ORR_LOG(f->o->log, ORR_LOG_INFO, "%s: resumed at byte %lld", c->name,
                (long long)j->transfer.resumed_from);
    j->attempt++;
    j->received_then = 0;
    j->moved_at = orr_monotonic_s();
    j->state = JOB_ACTIVE;
    f->active++;
}

static void again(fetcher *f, job *j, const char *why, bool connect_failed)
{
    const orr_candidate *c = &j->place[j->at];
    if (j->attempt >= f->o->attempts) {
        char text[400];
        snprintf(text, sizeof text, "%s (%d attempts)", why, j->attempt);
        if (connect_failed) f->down[c->mirror_index] = true; // not asked again in this run
        next_place(f, j, text);
        return;
    }
    double wait = f->o->backoff_s;
    for (int i = 1; i < j->attempt; i++) wait *= 2;
    if (wait > 60) wait = 60;
    char where[192];
    ORR_LOG(f->o->log, ORR_LOG_WARN, "%s: %s; attempt %d of %d in %.1f s", place_text(c, where), why,
            j->attempt + 1, f->o->attempts, wait);
    j->not_before = orr_monotonic_s() + wait;
}

// All bytes came: read the file; only then it gets its name.
static void arrived(fetcher *f, job *j)
{
    const orr_candidate *c = &j->place[j->at];
    orr_diag d = {0};
    char text[700], sha[ORR_SHA256_HEX], where[192];
    struct stat st;
    orr_status s = fetch_check(j->transfer.part, &j->item->wanted, &d);
    if (s != ORR_OK) {
        unlink(j->transfer.part);
        snprintf(text, sizeof text, "not usable: %s", d.text);
        // A resumed file may be two halves of different files; bytes can be lost on the way. A page of HTML
        // stays one.
        bool worth = (s == ORR_E_FORMAT || s == ORR_E_IO) && !j->afresh_done;
        j->afresh_done = true;
        if (worth)
            again(f, j, text, false);
        else
            next_place(f, j, text);
        return;
    }
    s = orr_sha256_stream(j->transfer.file, j->transfer.part, sha, &d);
    if (s == ORR_OK && fstat(fileno(j->transfer.file), &st) != 0)
        s = orr_diag_at(&d, ORR_E_IO, j->transfer.part, 0, 0, "%s", strerror(errno));
    if (s == ORR_OK && rename(j->transfer.part, j->path) != 0)
        s = orr_diag_at(&d, ORR_E_IO, j->path, 0, 0, "cannot be put in place: %s", strerror(errno));
    if (s == ORR_OK) s = fetch_index_put(f->o->cache_dir, j->path, st.st_size, sha, c->url, &d);
    if (s != ORR_OK) {
        finish(f, j, s, orr_diag_format(&d, text, sizeof text));
        return;
    }
    ORR_LOG(f->o->log, ORR_LOG_INFO, "%s: %lld bytes", place_text(c, where), (long long)st.st_size);
    settle(f, j, false, sha, st.st_size);
}

static void ended(fetcher *f, job *j, CURLcode code)
{
    char why[400] = "";
    bool connect_failed = false;
    curl_multi_remove_handle(f->multi, j->transfer.easy);
    f->active--;
    j->state = JOB_READY;
    f->bytes += j->transfer.received;
    fetch_outcome o = fetch_transfer_end(&j->transfer, code, why, sizeof why, &connect_failed);
    // Nothing came: an empty part is only a file in the way.
    if (o != FETCH_DONE && j->transfer.resumed_from + j->transfer.received == 0) unlink(j->transfer.part);
    switch (o) {
    case FETCH_DONE:
        arrived(f, j);
        break;
    case FETCH_NOT_THERE:
    case FETCH_REFUSED:
        unlink(j->transfer.part);
        next_place(f, j, why);
        break;
    case FETCH_AFRESH:
        unlink(j->transfer.part);
        if (j->afresh_done) {
            again(f, j, why, false);
        } else {
            j->afresh_done = true;
            j->attempt--; // costs no attempt: the first from the start
            j->not_before = 0;
        }
        break;
    case FETCH_AGAIN:
        again(f, j, why, connect_failed);
        break;
    case FETCH_HOPELESS:
        unlink(j->transfer.part);
        next_place(f, j, why);
        break;
    }
    fetch_transfer_drop(&j->transfer);
}

static void report(fetcher *f)
{
    if (f->o->progress == NULL) return;
    orr_fetch_progress p = {
        .done = f->done, .total = f->n, .active = f->active, .bytes = f->bytes, .name = ""};
    for (size_t i = 0; i < f->n; i++) {
        if (f->job[i].state != JOB_ACTIVE) continue;
        p.bytes += f->job[i].transfer.received;
        p.name = f->job[i].place[f->job[i].at].name;
    }
    f->o->progress(f->o->user, &p);
}

static void cancel(fetcher *f)
{
    for (size_t i = 0; i < f->n; i++) {
        job *j = &f->job[i];
        if (j->state == JOB_DONE) continue;
        if (j->state == JOB_ACTIVE) {
            curl_multi_remove_handle(f->multi, j->transfer.easy);
            fetch_transfer_drop(&j->transfer); // its part stays and is resumed next time
        }
        finish(f, j, ORR_E_INTERRUPTED, "interrupted");
    }
}

// Gives up transfers that nothing has come for. (libcurl's own limit of speed looks at averages of several
// seconds.)
static bool end_stalled(fetcher *f)
{
    bool any = false;
    double now = orr_monotonic_s();
    for (size_t i = 0; i < f->n; i++) {
        job *j = &f->job[i];
        if (j->state != JOB_ACTIVE) continue;
        if (j->transfer.received != j->received_then) {
            j->received_then = j->transfer.received;
            j->moved_at = now;
        } else if (now - j->moved_at > f->o->stall_s) {
            snprintf(j->transfer.error, sizeof j->transfer.error, "nothing came for %.1f s", f->o->stall_s);
            ended(f, j, CURLE_OPERATION_TIMEDOUT);
            any = true;
        }
    }
    return any;
}

static job *job_of(fetcher *f, CURL *easy)
{
    for (size_t i = 0; i < f->n; i++)
        if (f->job[i].state == JOB_ACTIVE && f->job[i].transfer.easy == easy) return &f->job[i];
    return NULL;
}

static void run(fetcher *f)
{
    while (f->done < f->n) {
        if (f->o->cancelled != NULL && f->o->cancelled(f->o->user)) {
            cancel(f);
            return;
        }
        double now = orr_monotonic_s();
        bool changed = false;
        for (size_t i = 0; i < f->n && f->active < (size_t)f->o->parallel; i++) {
            job *j = &f->job[i];
            if (j->state != JOB_READY || j->not_before > now) continue;
            begin(f, j);
            changed = true;
        }
        report(f);
        if (f->done == f->n) return;
        int running = 0, left = 0;
        curl_multi_perform(f->multi, &running);
        CURLMsg *m;
        while ((m = curl_multi_info_read(f->multi, &left)) != NULL) {
            CURL *easy = m->easy_handle;
            CURLcode code = m->data.result;
            job *j = m->msg == CURLMSG_DONE ? job_of(f, easy) : NULL;
            if (j == NULL) continue;
            ended(f, j, code);
            changed = true;
        }
        changed |= end_stalled(f);
        if (!changed)
            curl_multi_poll(f->multi, NULL, 0, 100,
                            NULL); // wakes with data; looks at the clock ten times a second
    }
}

static orr_status prepare(fetcher *f, const orr_archives *a, orr_fetch_item *item, size_t n)
{
    f->job = calloc(n > 0 ? n : 1, sizeof *f->job);
    f->down = calloc(MAX_MIRROR_LINES, sizeof *f->down);
    if (f->job == NULL || f->down == NULL)
        return orr_diag_set(f->diag, ORR_E_MEMORY, "no memory for %zu files", n);
    f->n = n;
    for (size_t i = 0; i < n; i++) {
        job *j = &f->job[i];
        orr_diag d = {0};
        j->item = &item[i];
        orr_wanted w = item[i].wanted;
        item[i] = (orr_fetch_item){.wanted = w};
        orr_status s = orr_archives_candidates(a, &w, &j->place, &j->n_places, &d);
        if (s == ORR_E_MEMORY) return orr_diag_set(f->diag, s, "%s", d.text);
        if (s != ORR_OK) finish(f, j, s, d.text);
    }
    return fetch_index_read(f->o->cache_dir, &f->index, f->diag);
}

orr_status orr_fetch(const orr_archives *a, const orr_fetch_options *o, orr_fetch_item *item, size_t n,
                     orr_diag *diag)
{
    if (o->cache_dir == NULL || o->cache_dir[0] == '\0')
        return orr_diag_set(diag, ORR_E_ARG, "no cache folder is named");
    if (o->parallel < 1 || o->parallel > 32 || o->attempts < 1)
        return orr_diag_set(diag, ORR_E_ARG, "1 to 32 transfers at once, and one attempt at least");
    if (curl_global_init(CURL_GLOBAL_DEFAULT) != CURLE_OK)
        return orr_diag_set(diag, ORR_E_IO, "libcurl does not start");
    fetcher f = {.o = o, .diag = diag, .multi = curl_multi_init()};
    orr_status s = f.multi == NULL ? orr_diag_set(diag, ORR_E_MEMORY, "libcurl does not start")
                                   : prepare(&f, a, item, n);
    if (s == ORR_OK) run(&f);
    size_t missing = 0;
    for (size_t i = 0; s == ORR_OK && i < n; i++) {
        if (item[i].status == ORR_E_INTERRUPTED) s = orr_diag_set(diag, ORR_E_INTERRUPTED, "interrupted");
        missing += item[i].status != ORR_OK;
    }
    if (s == ORR_OK && missing > 0)
        s = orr_diag_set(diag, ORR_E_NODATA, "%zu of %zu files are missing", missing, n);
    for (size_t i = 0; f.job != NULL && i < f.n; i++) free(f.job[i].place);
    free(f.job);
    free(f.down);
    fetch_index_free(&f.index);
    if (f.multi != NULL) curl_multi_cleanup(f.multi);
    curl_global_cleanup();
    return s;
}
