// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/ports/ntrip.h"

#include <openssl/crypto.h>
#include <openssl/evp.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

// A line of the head, without its end.
typedef struct line {
    const char *text;
    size_t n;
} line;

// The next line from *at on; false at the end of data, or where the line has not ended.
static bool next_line(const char *data, size_t n, size_t *at, line *out)
{
    const char *end = *at < n ? memchr(data + *at, '\n', n - *at) : NULL;
    if (end == NULL) return false;
    out->text = data + *at;
    out->n = (size_t)(end - out->text);
    *at += out->n + 1;
    if (out->n > 0 && out->text[out->n - 1] == '\r') out->n--;
    return true;
}

// Whether a line begins with a word, whatever the case; *rest is what stands behind it and blanks.
static bool begins(const line *l, const char *word, line *rest)
{
    const size_t n = strlen(word);
    if (l->n < n || strncasecmp(l->text, word, n) != 0) return false;
    *rest = (line){l->text + n, l->n - n};
    while (rest->n > 0 && rest->text[0] == ' ') rest->text++, rest->n--;
    while (rest->n > 0 && rest->text[rest->n - 1] == ' ') rest->n--;
    return true;
}

static bool is(const line *l, const char *word)
{
    return l->n == strlen(word) && strncasecmp(l->text, word, l->n) == 0;
}

// GET /MOUNT HTTP/1.x
static orr_ntrip_verdict read_first(const line *l, orr_ntrip_request *out)
{
    line rest;
    for (size_t k = 0; k < l->n; k++)
        if ((unsigned char)l->text[k] < ' ' || (unsigned char)l->text[k] > '~') return ORR_NTRIP_NO_HTTP;
    if (!begins(l, "GET ", &rest)) {
        line other;
        return begins(l, "SOURCE ", &other) || begins(l, "POST ", &other) || begins(l, "PUT ", &other) ||
                       begins(l, "HEAD ", &other)
                   ? ORR_NTRIP_NOT_GET
                   : ORR_NTRIP_NO_HTTP;
    }
    const char *space = memchr(rest.text, ' ', rest.n);
    if (space == NULL || rest.text[0] != '/') return ORR_NTRIP_NO_HTTP;
    const size_t n = (size_t)(space - rest.text) - 1;
    const line version = {space + 1, rest.n - n - 2};
    out->http_1_1 = is(&version, "HTTP/1.1");
    if (!out->http_1_1 && !is(&version, "HTTP/1.0")) return ORR_NTRIP_NO_HTTP;
    out->too_long = n >= sizeof out->mount;
    if (!out->too_long) memcpy(out->mount, rest.text + 1, n);
    return ORR_NTRIP_WHOLE;
}

static void read_field(const line *l, orr_ntrip_request *out)
{
    line value, login;
    if (begins(l, "Ntrip-Version:", &value) && is(&value, "Ntrip/2.0")) out->revision = 2;
    if (!begins(l, "Authorization:", &value) || !begins(&value, "Basic ", &login)) return;
    if (login.n > ORR_NTRIP_LOGIN || memchr(login.text, '\0', login.n) != NULL) return; // nobody's
    memcpy(out->login, login.text, login.n);
    out->login[login.n] = '\0';
}

orr_ntrip_verdict orr_ntrip_read(const char *data, size_t n, orr_ntrip_request *out)
{
    size_t at = 0;
    line l;
    *out = (orr_ntrip_request){.revision = 1};
    if (!next_line(data, n, &at, &l)) return n >= ORR_NTRIP_REQUEST ? ORR_NTRIP_TOO_LONG : ORR_NTRIP_MORE;
    const orr_ntrip_verdict first = read_first(&l, out);
    if (first != ORR_NTRIP_WHOLE) return first;
    while (next_line(data, n, &at, &l)) {
        if (at > ORR_NTRIP_REQUEST) break;
        if (l.n == 0) return ORR_NTRIP_WHOLE;
        read_field(&l, out);
    }
    return n >= ORR_NTRIP_REQUEST ? ORR_NTRIP_TOO_LONG : ORR_NTRIP_MORE;
}

// Status lines by revision.
static const char *status_of(const orr_ntrip_request *r, orr_ntrip_answer answer)
{
    const bool two = r != NULL && r->revision == 2;
    switch (answer) {
    case ORR_NTRIP_STREAM:
        return two ? "HTTP/1.1 200 OK" : "ICY 200 OK";
    case ORR_NTRIP_TABLE:
        return two ? "HTTP/1.1 200 OK" : "SOURCETABLE 200 OK";
    case ORR_NTRIP_UNAUTHORISED:
        return two ? "HTTP/1.1 401 Unauthorized" : "HTTP/1.0 401 Unauthorized";
    case ORR_NTRIP_NOT_FOUND:
        return "HTTP/1.1 404 Not Found";
    case ORR_NTRIP_NO_SOURCES:
        return "HTTP/1.1 405 Method Not Allowed";
    default:
        return "HTTP/1.1 400 Bad Request";
    }
}

size_t orr_ntrip_head(const orr_ntrip_request *r, orr_ntrip_answer answer, size_t size,
                      char text[ORR_NTRIP_HEAD])
{
    const bool two = r == NULL || r->revision == 2;
    // A receiver of revision 1 takes what follows an empty line for data, and some take the first line alone for the head.
    size_t n = (size_t)snprintf(text, ORR_NTRIP_HEAD, "%s\r\n", status_of(r, answer));
    if (answer == ORR_NTRIP_STREAM && !two) return n + (size_t)snprintf(text + n, ORR_NTRIP_HEAD - n, "\r\n");
    if (two) n += (size_t)snprintf(text + n, ORR_NTRIP_HEAD - n, "Ntrip-Version: Ntrip/2.0\r\n");
    n += (size_t)snprintf(text + n, ORR_NTRIP_HEAD - n, "Server: NTRIP Orrery/" ORR_VERSION "\r\n");
    if (answer == ORR_NTRIP_UNAUTHORISED)
        n += (size_t)snprintf(text + n, ORR_NTRIP_HEAD - n, "WWW-Authenticate: Basic realm=\"/%s\"\r\n",
                              r->mount);
    if (answer == ORR_NTRIP_NO_SOURCES) n += (size_t)snprintf(text + n, ORR_NTRIP_HEAD - n, "Allow: GET\r\n");
    if (answer == ORR_NTRIP_STREAM)
        n += (size_t)snprintf(text + n, ORR_NTRIP_HEAD - n,
                              "Cache-Control: no-store, no-cache, max-age=0\r\nPragma: no-cache\r\n"
                              "Content-Type: gnss/data\r\n%s",
                              r->http_1_1 ? "Transfer-Encoding: chunked\r\n" : "");
    else
        n += (size_t)snprintf(text + n, ORR_NTRIP_HEAD - n, "Content-Type: %s\r\nContent-Length: %zu\r\n",
                              two && answer == ORR_NTRIP_TABLE ? "gnss/sourcetable" : "text/plain", size);
    return n + (size_t)snprintf(text + n, ORR_NTRIP_HEAD - n, "Connection: close\r\n\r\n");
}

bool orr_ntrip_login(const char *base64, const char *user_password)
{
    unsigned char right[ORR_NTRIP_LOGIN + 4] = {0}, came[ORR_NTRIP_LOGIN + 4] = {0};
    const size_t n = strlen(user_password);
    if (n > ORR_NTRIP_LOGIN / 4 * 3 || strlen(base64) > ORR_NTRIP_LOGIN) return false;
    (void)EVP_EncodeBlock(right, (const unsigned char *)user_password, (int)n);
    memcpy(came, base64, strlen(base64));
    return CRYPTO_memcmp(right, came, sizeof right) == 0;
}
