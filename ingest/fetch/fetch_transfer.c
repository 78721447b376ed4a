// SPDX-License-Identifier: GPL-3.0-or-later
// One transfer by libcurl into a part file: resumed where it broke, bounded in size and patience.
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "ingest/fetch/fetch_private.h"

static size_t take(char *data, size_t size, size_t n, void *user)
{
    fetch_transfer *t = user;
    size_t bytes = size * n; // libcurl: size is always 1
    if (t->resumed_from + t->received + (int64_t)bytes > t->max_bytes) {
        t->too_big = true;
        return 0;
    }
    if (fwrite(data, 1, bytes, t->file) != bytes) {
        t->write_failed = true;
        return 0;
    }
    t->received += (int64_t)bytes;
    return bytes;
}

// A part belongs to one URL: what another mirror began is not continued here.
static unsigned mark_of(const char *url)
{
    unsigned h = 2166136261U; // FNV-1a
    for (; *url != '\0'; url++) h = (h ^ (unsigned char)*url) * 16777619U;
    return h;
}

static CURLcode set_up(fetch_transfer *t, const orr_fetch_options *o, const orr_candidate *c)
{
    CURL *e = t->easy;
    CURLcode r = curl_easy_setopt(e, CURLOPT_URL, c->url);
    curl_easy_setopt(e, CURLOPT_PRIVATE, t);
    curl_easy_setopt(e, CURLOPT_ERRORBUFFER, t->error);
    curl_easy_setopt(e, CURLOPT_WRITEFUNCTION, take);
    curl_easy_setopt(e, CURLOPT_WRITEDATA, t);
    curl_easy_setopt(e, CURLOPT_NOSIGNAL, 1L);
    curl_easy_setopt(e, CURLOPT_FAILONERROR, 1L); // the body of a 404 is no part of a file
    curl_easy_setopt(e, CURLOPT_FOLLOWLOCATION, 1L);
    curl_easy_setopt(e, CURLOPT_MAXREDIRS, 10L);
    curl_easy_setopt(e, CURLOPT_CONNECTTIMEOUT_MS, (long)(o->connect_s * 1e3));
    curl_easy_setopt(e, CURLOPT_USERAGENT, "orrery/" ORR_VERSION);
    if (t->resumed_from > 0) curl_easy_setopt(e, CURLOPT_RESUME_FROM_LARGE, (curl_off_t)t->resumed_from);
    if (r == CURLE_OK) r = curl_easy_setopt(e, CURLOPT_PROTOCOLS_STR, "https,http,ftp,ftps,file");
    if (r == CURLE_OK && o->ca_file != NULL) r = curl_easy_setopt(e, CURLOPT_CAINFO, o->ca_file);
    // A login is sent over plain http only where the table itself says so.
    t->https_only = c->login && strncmp(c->url, "http:", 5) != 0;
    if (r == CURLE_OK)
        r = curl_easy_setopt(e, CURLOPT_REDIR_PROTOCOLS_STR, t->https_only ? "https" : "https,http");
    if (c->login) {
        // The archive sends us to the login host, which asks for the name that .netrc has for it, and back
        // with a cookie: kept, so that the next file needs no login.
        char jar[1100];
        snprintf(jar, sizeof jar, "%s/cookies.txt", o->cache_dir);
        int jar_fd = open(jar, O_WRONLY | O_CREAT | O_CLOEXEC, 0600); // a session is nobody else's business
        if (jar_fd >= 0) close(jar_fd);
        curl_easy_setopt(e, CURLOPT_NETRC, (long)CURL_NETRC_OPTIONAL);
        if (o->netrc != NULL) curl_easy_setopt(e, CURLOPT_NETRC_FILE, o->netrc);
        curl_easy_setopt(e, CURLOPT_COOKIEFILE, jar);
        curl_easy_setopt(e, CURLOPT_COOKIEJAR, jar);
    }
    return r;
}

// Opens a part to be continued and locks it, so that programs side by side do not write into one. NULL with *busy where
// another has it, NULL with errno where it cannot be opened.
static FILE *open_part(const char *path, bool *busy)
{
    *busy = false;
    for (;;) {
        struct stat open_one, there;
        FILE *f = fopen(path, "a+b");
        if (f == NULL) return NULL;
        *busy = flock(fileno(f), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
        // Meanwhile another may have finished it and given it its name: then this is no part any more.
        if (!*busy && fstat(fileno(f), &open_one) == 0 && stat(path, &there) == 0 &&
            open_one.st_ino == there.st_ino && open_one.st_dev == there.st_dev)
            return f;
        fclose(f);
        if (*busy) return NULL;
    }
}

orr_status fetch_transfer_start(fetch_transfer *t, const orr_fetch_options *o, const orr_candidate *c,
                                const char *path, orr_diag *diag)
{
    *t = (fetch_transfer){.max_bytes = (int64_t)o->max_bytes};
    snprintf(t->part, sizeof t->part, "%s.%08x.part", path, mark_of(c->url));
    t->file = open_part(t->part, &t->busy);
    if (t->busy) return ORR_OK;
    if (t->file == NULL)
        return orr_diag_at(diag, ORR_E_IO, t->part, 0, 0, "cannot be written: %s", strerror(errno));
    setvbuf(t->file, NULL, _IONBF,
            0); // libcurl hands over kilobytes; whatever came can be resumed after a crash too
    struct stat st;
    if (fstat(fileno(t->file), &st) == 0) t->resumed_from = st.st_size;
    t->easy = curl_easy_init();
    if (t->easy == NULL || set_up(t, o, c) != CURLE_OK) {
        fetch_transfer_drop(t);
        return orr_diag_set(diag, ORR_E_IO, "libcurl cannot prepare %s", c->url);
    }
    return ORR_OK;
}

void fetch_transfer_drop(fetch_transfer *t)
{
    if (t->easy != NULL) curl_easy_cleanup(t->easy);
    if (t->file != NULL) fclose(t->file);
    t->easy = NULL;
    t->file = NULL;
}

static fetch_outcome judge_http(long status, CURLcode code, const fetch_transfer *t, char *why, size_t n)
{
    if (status == 404 || status == 410) return snprintf(why, n, "not there (%ld)", status), FETCH_NOT_THERE;
    if (status == 401 || status == 403)
        return snprintf(why, n, "refused (%ld); a login in .netrc may be needed", status), FETCH_REFUSED;
    if (status == 416 && t->resumed_from > 0)
        return snprintf(why, n, "cannot be resumed (416)"), FETCH_AFRESH;
    if (status == 408 || status == 425 || status == 429 || status >= 500)
        return snprintf(why, n, "the server is busy or broken (%ld)", status), FETCH_AGAIN;
    if (status >= 400) return snprintf(why, n, "refused (%ld)", status), FETCH_NOT_THERE;
    return snprintf(why, n, "%s", curl_easy_strerror(code)), FETCH_NOT_THERE;
}

fetch_outcome fetch_transfer_end(fetch_transfer *t, CURLcode code, char *why, size_t n, bool *connect_failed)
{
    long status = 0;
    curl_easy_getinfo(t->easy, CURLINFO_RESPONSE_CODE, &status);
    const bool flushed = fflush(t->file) == 0 && fsync(fileno(t->file)) == 0;
    char detail[CURL_ERROR_SIZE];
    snprintf(detail, sizeof detail, "%s", t->error[0] != '\0' ? t->error : curl_easy_strerror(code));
    curl_easy_cleanup(t->easy);
    t->easy = NULL;
    *connect_failed = code == CURLE_COULDNT_RESOLVE_HOST || code == CURLE_COULDNT_CONNECT ||
                      code == CURLE_SSL_CONNECT_ERROR;
    if (t->write_failed || (code == CURLE_OK && !flushed))
        return snprintf(why, n, "the cache cannot be written (disk full?)"), FETCH_HOPELESS;
    if (t->too_big)
        return snprintf(why, n, "larger than %lld bytes", (long long)t->max_bytes), FETCH_HOPELESS;
    switch (code) {
    case CURLE_OK:
        return FETCH_DONE;
    case CURLE_HTTP_RETURNED_ERROR:
        return judge_http(status, code, t, why, n);
    case CURLE_RANGE_ERROR:
    case CURLE_BAD_DOWNLOAD_RESUME:
        return snprintf(why, n, "the server does not resume"), FETCH_AFRESH;
    case CURLE_REMOTE_FILE_NOT_FOUND:
    case CURLE_FILE_COULDNT_READ_FILE:
        return snprintf(why, n, "not there"), FETCH_NOT_THERE;
    case CURLE_LOGIN_DENIED:
    case CURLE_REMOTE_ACCESS_DENIED:
        return snprintf(why, n, "refused: %s", detail), FETCH_REFUSED;
    case CURLE_PEER_FAILED_VERIFICATION:
    case CURLE_SSL_CACERT_BADFILE:
        return snprintf(
                   why, n,
                   "%s; where the server is to be trusted, name a file of certificates that vouch for it "
                   "(--ca-file, CURL_CA_BUNDLE)",
                   detail),
               FETCH_REFUSED;
    case CURLE_TOO_MANY_REDIRECTS:
        return snprintf(why, n, "redirected in circles"), FETCH_NOT_THERE;
    case CURLE_UNSUPPORTED_PROTOCOL:
        if (t->https_only)
            return snprintf(why, n,
                            "redirected to another protocol than https while a login is sent; not followed"),
                   FETCH_HOPELESS;
        return snprintf(why, n, "%s", detail), FETCH_HOPELESS;
    case CURLE_URL_MALFORMAT:
        return snprintf(why, n, "%s", detail), FETCH_HOPELESS;
    case CURLE_PARTIAL_FILE:
        return snprintf(why, n, "broke off after %lld bytes", (long long)t->received), FETCH_AGAIN;
    case CURLE_OPERATION_TIMEDOUT:
        return snprintf(why, n, "too slow: %s", detail), FETCH_AGAIN;
    default:
        return snprintf(why, n, "%s", detail), FETCH_AGAIN;
    }
}
