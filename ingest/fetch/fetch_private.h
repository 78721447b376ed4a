// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of fetching among themselves: the cache and single transfers. Private to the ingest room.
#ifndef ORR_INGEST_FETCH_FETCH_PRIVATE_H
#define ORR_INGEST_FETCH_FETCH_PRIVATE_H

#include <curl/curl.h>
#include <stdio.h>

#include "ingest/fetch/fetch.h"

// ---- cache ----

typedef struct fetch_entry {
    char *name; // relative to the cache folder
    int64_t bytes;
    char sha256[ORR_SHA256_HEX];
    char *url;
} fetch_entry;

typedef struct fetch_index {
    size_t n;
    fetch_entry *entry;
} fetch_index;

// "CACHE/yyyy/ddd/NAME", and its folders made.
orr_status fetch_cache_path(const char *cache_dir, const orr_candidate *c, bool make, char *path, size_t n,
                            orr_diag *diag);
orr_status fetch_index_read(const char *cache_dir, fetch_index *x,
                            orr_diag *diag); // no index is an empty one
void fetch_index_free(fetch_index *x);
const fetch_entry *fetch_index_find(const fetch_index *x, const char *cache_dir, const char *path);
// Adds or replaces one line, under a lock, so that programs side by side do not lose each other's.
orr_status fetch_index_put(const char *cache_dir, const char *path, int64_t bytes, const char *sha256,
                           const char *url, orr_diag *diag);
// Whether the file at `path` is this product, whole and legible, and of this day; a sentence in diag if not.
orr_status fetch_check(const char *path, const orr_wanted *w, orr_diag *diag);

// ---- one transfer ----

typedef struct fetch_transfer {
    CURL *easy;
    FILE *file; // the part, locked as long as it is open
    bool busy;  // another program has the part: nothing was begun
    char part[1152];
    int64_t resumed_from; // bytes that were there
    int64_t received;     // of this transfer
    int64_t max_bytes;
    bool too_big, write_failed;
    bool https_only; // a login is sent: no redirect to anything else
    char error[CURL_ERROR_SIZE];
} fetch_transfer;

typedef enum fetch_outcome {
    FETCH_DONE,      // all bytes are in t->part
    FETCH_NOT_THERE, // 404 and the like: the next place
    FETCH_REFUSED,   // 401, 403: the next place
    FETCH_AGAIN,     // broken, slow, busy: another attempt makes sense
    FETCH_AFRESH,    // the part cannot be resumed: drop it, try at once
    FETCH_HOPELESS,  // too big, cannot be written, bad URL
} fetch_outcome;

orr_status fetch_transfer_start(fetch_transfer *t, const orr_fetch_options *o, const orr_candidate *c,
                                const char *path, orr_diag *diag);
// Judges a transfer that ended; its part stays open until fetch_transfer_drop. `why` says what happened.
fetch_outcome fetch_transfer_end(fetch_transfer *t, CURLcode code, char *why, size_t n, bool *connect_failed);
void fetch_transfer_drop(fetch_transfer *t); // ends it without judgement; the part stays

#endif
