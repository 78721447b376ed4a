// SPDX-License-Identifier: GPL-3.0-or-later
// Products of the IGS from their mirrors into a cache folder. A file counts as fetched when our own reader
// has read it, not when a server said so: pages of errors, logins and half files are common. The cache is
// CACHE/yyyy/ddd/NAME with an index of SHA-256 sums; a transfer in progress is NAME.<mark>.part beside its
// place and is resumed where it broke.
#ifndef ORR_INGEST_FETCH_FETCH_H
#define ORR_INGEST_FETCH_FETCH_H

#include "core/log.h"
#include "core/sha256.h"
#include "ingest/fetch/archives.h"

typedef struct orr_fetch_progress {
    size_t done, total; // files
    size_t active;      // transfers under way
    int64_t bytes;      // received so far, of all files
    const char *name;   // a file under way, "" for none
} orr_fetch_progress;

typedef struct orr_fetch_options {
    const char *cache_dir;
    bool offline;     // the cache alone
    int parallel;     // transfers at once, 1 to 32
    int attempts;     // at one place before the next is tried
    double backoff_s; // wait before the second attempt; doubled each time, at most a minute
    double stall_s;   // give a transfer up when nothing comes for so long
    double connect_s;
    size_t max_bytes;              // of one file as transferred
    const char *netrc;             // NULL: ~/.netrc
    const char *ca_file;           // certificates (PEM) that vouch for servers; NULL: those of the system
    const orr_log *log;            // WARN: each fallback and each new attempt; INFO: each file
    bool (*cancelled)(void *user); // may be NULL
    void (*progress)(void *user, const orr_fetch_progress *p); // may be NULL
    void *user;
} orr_fetch_options;
orr_fetch_options
orr_fetch_default_options(const char *cache_dir); // 4 at once, 3 attempts, 2 s, 30 s, 15 s, 2 GiB

// One file: what is wanted and, afterwards, what came of it.
typedef struct orr_fetch_item {
    orr_wanted wanted;
    orr_status status;   // ORR_OK; ORR_E_NODATA: nowhere to be had; ORR_E_INTERRUPTED; ORR_E_IO: the cache
                         // cannot be written
    bool from_cache;     // no transfer was needed
    orr_candidate found; // where it came from (name, tier, centre; mirror "cache" if it was there)
    char path[1024];     // in the cache
    int64_t bytes;
    char sha256[ORR_SHA256_HEX];
    char reason[512]; // why not
} orr_fetch_item;

// Fetches several products, several at once.
//   Given:    a           the table of archives
//             o           where to, how, and who is told
//             item        n items with what is wanted
//   Returned: item        what came of each: status, path, sum, or the reason
//             diag        ORR_E_NODATA if one is missing, ORR_E_INTERRUPTED, ORR_E_IO, ORR_E_MEMORY
//   Notes:    curl_global_init is called; it may be repeated.
orr_status orr_fetch(const orr_archives *a, const orr_fetch_options *o, orr_fetch_item *item, size_t n,
                     orr_diag *diag);

// The user's cache folder: $ORRERY_CACHE, $XDG_CACHE_HOME/orrery, ~/.cache/orrery. False if there is none.
bool orr_fetch_default_cache(char *buf, size_t n);

#endif
