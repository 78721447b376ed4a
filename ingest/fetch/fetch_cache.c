// SPDX-License-Identifier: GPL-3.0-or-later
// The cache folder: where files lie, the index of their sums, and the check that a file is what its name
// says.
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/outfile.h"
#include "ingest/fetch/fetch_private.h"
#include "ingest/input/text_records.h"
#include "ingest/inspect/inspect.h"

#define INDEX_NAME "index.tsv"
#define INDEX_MAX ((size_t)1000000)

bool orr_fetch_default_cache(char *buf, size_t n)
{
    static const char *const variable[] = {"ORRERY_CACHE", "XDG_CACHE_HOME", "HOME"};
    static const char *const below[] = {"", "/orrery", "/.cache/orrery"};
    for (int i = 0; i < 3; i++) {
        const char *v = getenv(variable[i]);
        if (v == NULL || *v == '\0') continue;
        int k = snprintf(buf, n, "%s%s", v, below[i]);
        return k > 0 && (size_t)k < n;
    }
    return false;
}

// mkdir -p of the folder part of a path.
static orr_status make_folders(const char *path, orr_diag *diag)
{
    char folder[1024];
    int n = snprintf(folder, sizeof folder, "%s", path);
    if (n < 0 || (size_t)n >= sizeof folder)
        return orr_diag_set(diag, ORR_E_ARG, "a path of the cache is too long");
    for (char *p = folder + 1; *p != '\0'; p++) {
        if (*p != '/') continue;
        *p = '\0';
        if (mkdir(folder, 0777) != 0 && errno != EEXIST)
            return orr_diag_at(diag, ORR_E_IO, folder, 0, 0, "the folder cannot be made: %s",
                               strerror(errno));
        *p = '/';
    }
    return ORR_OK;
}

orr_status fetch_cache_path(const char *cache_dir, const orr_candidate *c, bool make, char *path, size_t n,
                            orr_diag *diag)
{
    int year, month, day;
    orr_date_from_mjd(c->folder_mjd, &year, &month, &day);
    int k = snprintf(path, n, "%s/%04d/%03d/%s", cache_dir, year, orr_day_of_year(year, month, day), c->name);
    if (k < 0 || (size_t)k >= n || k > 1000)
        return orr_diag_set(diag, ORR_E_ARG, "the cache folder's name is too long");
    return make ? make_folders(path, diag) : ORR_OK;
}

// ---- index: NAME <tab> bytes <tab> sha256 <tab> url ----

void fetch_index_free(fetch_index *x)
{
    for (size_t i = 0; i < x->n; i++) {
        free(x->entry[i].name);
        free(x->entry[i].url);
    }
    free(x->entry);
    *x = (fetch_index){0};
}

static orr_status index_line(fetch_index *x, orr_view line, const orr_cursor *at, orr_diag *diag)
{
    orr_view f[4], rest = line;
    int64_t bytes;
    for (int i = 0; i < 4; i++)
        if (!orr_view_split(&rest, '\t', &f[i])) return ORR_OK; // a line that was damaged is as good as none
    if (f[0].n == 0 || orr_view_int(f[1], &bytes) != ORR_FIELD_OK || bytes < 0 ||
        f[2].n != ORR_SHA256_HEX - 1)
        return ORR_OK;
    orr_status s = orr_records_grow(&x->entry, x->n, sizeof *x->entry, INDEX_MAX,
                                    "lines of the cache's index", at, diag);
    if (s != ORR_OK) return s;
    fetch_entry e = {.name = orr_view_dup(f[0]), .bytes = bytes, .url = orr_view_dup(f[3])};
    orr_view_copy(f[2], e.sha256, sizeof e.sha256);
    if (e.name == NULL || e.url == NULL) {
        free(e.name);
        free(e.url);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the cache's index");
    }
    x->entry[x->n++] = e;
    return ORR_OK;
}

orr_status fetch_index_read(const char *cache_dir, fetch_index *x, orr_diag *diag)
{
    char path[1100];
    *x = (fetch_index){0};
    snprintf(path, sizeof path, "%s/" INDEX_NAME, cache_dir);
    struct stat st;
    if (stat(path, &st) != 0 || st.st_size == 0) return ORR_OK;
    orr_bytes b;
    orr_status s = orr_records_load(path, NULL, 0, &b, diag);
    if (s != ORR_OK) return s;
    orr_cursor c;
    orr_view line;
    orr_cursor_init(&c, path, b.text, b.n);
    while (s == ORR_OK && orr_cursor_next(&c, &line))
        if (line.n > 0 && line.p[0] != '#') s = index_line(x, line, &c, diag);
    orr_bytes_free(&b);
    if (s != ORR_OK) fetch_index_free(x);
    return s;
}

static const char *relative(const char *cache_dir, const char *path)
{
    size_t n = strlen(cache_dir);
    return strncmp(path, cache_dir, n) == 0 && path[n] == '/' ? path + n + 1 : path;
}

const fetch_entry *fetch_index_find(const fetch_index *x, const char *cache_dir, const char *path)
{
    const char *name = relative(cache_dir, path);
    for (size_t i = 0; i < x->n; i++)
        if (strcmp(x->entry[i].name, name) == 0) return &x->entry[i];
    return NULL;
}

static orr_status write_index(const char *cache_dir, const fetch_index *x, const fetch_entry *put,
                              orr_diag *diag)
{
    char path[1100];
    orr_outfile f;
    snprintf(path, sizeof path, "%s/" INDEX_NAME, cache_dir);
    orr_status s = orr_outfile_open(path, &f, diag);
    if (s != ORR_OK) return s;
    fputs("# name\tbytes\tsha256\turl\n", f.stream);
    for (size_t i = 0; i < x->n; i++) {
        const fetch_entry *e = &x->entry[i];
        if (strcmp(e->name, put->name) == 0) continue;
        fprintf(f.stream, "%s\t%lld\t%s\t%s\n", e->name, (long long)e->bytes, e->sha256, e->url);
    }
    fprintf(f.stream, "%s\t%lld\t%s\t%s\n", put->name, (long long)put->bytes, put->sha256, put->url);
    return orr_outfile_commit(&f, diag);
}

orr_status fetch_index_put(const char *cache_dir, const char *path, int64_t bytes, const char *sha256,
                           const char *url, orr_diag *diag)
{
    char lock_path[1100];
    snprintf(lock_path, sizeof lock_path, "%s/index.lock", cache_dir);
    int fd = open(lock_path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (fd < 0) return orr_diag_at(diag, ORR_E_IO, lock_path, 0, 0, "cannot be opened: %s", strerror(errno));
    struct flock lock = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    while (fcntl(fd, F_SETLKW, &lock) != 0 && errno == EINTR) {
    }
    fetch_index x;
    orr_status s = fetch_index_read(cache_dir, &x, diag);
    if (s == ORR_OK) {
        char name[1024], from[600];
        snprintf(name, sizeof name, "%s", relative(cache_dir, path));
        snprintf(from, sizeof from, "%s", url);
        fetch_entry put = {.name = name, .bytes = bytes, .url = from};
        snprintf(put.sha256, sizeof put.sha256, "%s", sha256);
        s = write_index(cache_dir, &x, &put, diag);
        fetch_index_free(&x);
    }
    close(fd); // gives the lock back
    return s;
}

// ---- content ----

orr_status fetch_check(const char *path, const orr_wanted *w, orr_diag *diag)
{
    orr_inspection r;
    orr_status s = orr_inspect(path, NULL, &r, diag);
    if (s == ORR_OK && !orr_product_holds(w->product, r.kind))
        s = orr_diag_set(diag, ORR_E_KIND, "this is %s, not %s", orr_kind_name(r.kind),
                         orr_product_name(w->product));
    // An antenna table is of a reference frame, not of a day.
    const bool of_day = w->product != ORR_PRODUCT_ANTEX;
    if (s == ORR_OK && of_day && r.from != ORR_TIME_NONE && r.to != ORR_TIME_NONE) {
        // Labels may be of another scale, daily values stand at noon, weekly coordinates in the middle: a day
        // of grace.
        orr_time start = orr_time_from_mjd(w->mjd - 1, 0, ORR_SCALE_GPS, NULL);
        orr_time end = orr_time_from_mjd(w->mjd + 2, 0, ORR_SCALE_GPS, NULL);
        char from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
        if (r.to < start || r.from > end)
            s = orr_diag_set(diag, ORR_E_RANGE, "it covers %s to %s, which is another day",
                             orr_time_text(r.from, from), orr_time_text(r.to, to));
    }
    orr_inspection_free(&r);
    return s;
}
