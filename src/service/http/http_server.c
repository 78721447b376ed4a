// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/http/http_server.h"

#include <errno.h>
#include <event2/buffer.h>
#include <event2/bufferevent.h>
#include <event2/event.h>
#include <event2/http.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "src/service/net/loop.h"
#include "src/service/net/url.h"

enum { BACKLOG = 32, MOST_HEADERS = 8192, MOST_BODY = 4096, IDLE_S = 60, NICE = 10 };
static const size_t MOST_WAITING = 4 << 20; // bytes of events that a listener has not taken

typedef struct listener {
    orr_http_server *server;
    const orr_http_route *route;
    struct evhttp_request *request;
    orr_http_ask ask;
    char *query;
    struct event *tick;
} listener;

struct orr_http_server {
    orr_http_route *route;
    size_t n;
    char url[ORR_URL_TEXT + 16];
    uint16_t port;
    orr_loop loop;
    struct evhttp *http;
    listener listener[ORR_HTTP_LISTENERS];
};

bool orr_http_is_own(const char *host, uint16_t port)
{
    static const char *const own[] = {"127.0.0.1", "[::1]", "localhost"};
    char tail[8];
    snprintf(tail, sizeof tail, ":%u", (unsigned)port);
    for (size_t k = 0; k < sizeof own / sizeof own[0]; k++) {
        const size_t n = strlen(own[k]);
        if (strncasecmp(host, own[k], n) != 0) continue;
        return strcmp(host + n, tail) == 0 || (port == 80 && host[n] == '\0');
    }
    return false;
}

// Whether the request comes from a page of this server, or from no page.
static bool is_permitted(const orr_http_server *s, const struct evhttp_request *r)
{
    const struct evkeyvalq *head = evhttp_request_get_input_headers((struct evhttp_request *)r);
    const char *host = evhttp_find_header(head, "Host"), *origin = evhttp_find_header(head, "Origin");
    if (host == NULL || !orr_http_is_own(host, s->port)) return false;
    if (origin == NULL) return true;
    return strncmp(origin, "http://", 7) == 0 && orr_http_is_own(origin + 7, s->port);
}

// What keeps a page to itself: nothing from elsewhere, in no other page, kept nowhere.
static void add_headers(struct evhttp_request *r, const char *type)
{
    struct evkeyvalq *head = evhttp_request_get_output_headers(r);
    evhttp_add_header(head, "Content-Type", type);
    evhttp_add_header(head, "Cache-Control", "no-store");
    evhttp_add_header(head, "X-Content-Type-Options", "nosniff");
    evhttp_add_header(head, "Referrer-Policy", "no-referrer");
    evhttp_add_header(head, "Cross-Origin-Resource-Policy", "same-origin");
    evhttp_add_header(head, "Content-Security-Policy",
                      "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
                      "connect-src 'self'; img-src data:; base-uri 'none'; form-action 'none'; "
                      "frame-ancestors 'none'");
}

static void reply_text(struct evhttp_request *r, int status, const char *text)
{
    struct evbuffer *b = evbuffer_new();
    add_headers(r, "text/plain; charset=utf-8");
    if (b != NULL) evbuffer_add_printf(b, "%s\n", text);
    evhttp_send_reply(r, status, NULL, b);
    if (b != NULL) evbuffer_free(b);
}

// What a route prints, as a buffer; NULL: out of memory.
static struct evbuffer *print_answer(const orr_http_route *route, orr_http_ask *ask, int *status)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    struct evbuffer *b = out != NULL ? evbuffer_new() : NULL;
    if (out == NULL) return NULL;
    *status = route->answer(route->user, ask, out);
    const bool whole = fclose(out) == 0 && b != NULL && evbuffer_add(b, text, size) == 0;
    free(text);
    if (whole) return b;
    if (b != NULL) evbuffer_free(b);
    return NULL;
}

static void forget(listener *l)
{
    event_free(l->tick);
    free(l->query);
    *l = (listener){.server = l->server};
}

static void on_gone(struct evhttp_connection *c, void *user)
{
    (void)c;
    forget(user);
}

// Events since the last time. Who does not take them gets no more until it does.
static void on_tick(evutil_socket_t fd, short what, void *user)
{
    (void)fd, (void)what;
    listener *l = user;
    struct evhttp_connection *c = evhttp_request_get_connection(l->request);
    struct bufferevent *be = evhttp_connection_get_bufferevent(c);
    if (evbuffer_get_length(bufferevent_get_output(be)) > MOST_WAITING) return;
    int status = 0;
    struct evbuffer *b = print_answer(l->route, &l->ask, &status);
    if (b == NULL) return;
    evhttp_send_reply_chunk(l->request, b); // an empty one would end the answer, and libevent sends none
    evbuffer_free(b);
}

static void begin_events(orr_http_server *s, const orr_http_route *route, struct evhttp_request *r,
                         const char *query)
{
    listener *l = NULL;
    for (size_t k = 0; k < ORR_HTTP_LISTENERS && l == NULL; k++)
        if (s->listener[k].request == NULL) l = &s->listener[k];
    if (l == NULL) {
        reply_text(r, 503, "As many pages are open as this server allows; close one.");
        return;
    }
    *l = (listener){.server = s, .route = route, .request = r, .query = strdup(query)};
    l->tick = event_new(s->loop.base, -1, EV_PERSIST, on_tick, l);
    const struct timeval every = {(time_t)route->every_s,
                                  (suseconds_t)((route->every_s - (double)(time_t)route->every_s) * 1e6)};
    if (l->query == NULL || l->tick == NULL || event_add(l->tick, &every) != 0) {
        if (l->tick != NULL) event_free(l->tick);
        free(l->query);
        *l = (listener){.server = s};
        reply_text(r, 503, "The server is out of memory.");
        return;
    }
    l->ask.query = l->query;
    add_headers(r, "text/event-stream");
    evhttp_connection_set_closecb(evhttp_request_get_connection(r), on_gone, l);
    evhttp_connection_set_timeout(evhttp_request_get_connection(r), IDLE_S * 10);
    evhttp_send_reply_start(r, 200, "OK");
    on_tick(-1, 0, l);
}

static void answer(const orr_http_route *route, struct evhttp_request *r, const char *query)
{
    orr_http_ask ask = {.query = query};
    int status = 500;
    struct evbuffer *b = print_answer(route, &ask, &status);
    if (b == NULL) {
        reply_text(r, 500, "The server is out of memory.");
        return;
    }
    add_headers(r, route->type);
    evhttp_send_reply(r, status, NULL, b);
    evbuffer_free(b);
}

static void on_request(struct evhttp_request *r, void *user)
{
    orr_http_server *s = user;
    const struct evhttp_uri *uri = evhttp_request_get_evhttp_uri(r);
    const char *path = uri != NULL ? evhttp_uri_get_path(uri) : NULL;
    const char *raw = uri != NULL ? evhttp_uri_get_query(uri) : NULL;
    if (!is_permitted(s, r)) {
        reply_text(r, 403, "This server answers its own pages on its own machine alone (Host and Origin).");
        return;
    }
    for (size_t k = 0; k < s->n && path != NULL; k++) {
        if (strcmp(path, s->route[k].path) != 0) continue;
        char *query = evhttp_uridecode(raw != NULL ? raw : "", 0, NULL);
        if (query == NULL)
            reply_text(r, 500, "The server is out of memory.");
        else if (s->route[k].every_s > 0)
            begin_events(s, &s->route[k], r, query);
        else
            answer(&s->route[k], r, query);
        free(query);
        return;
    }
    reply_text(r, 404, "There is nothing of that name.");
}

static orr_status listen_on(orr_http_server *s, const char *address, int *fd, orr_diag *diag)
{
    char text[ORR_URL_TEXT];
    orr_url u, bound;
    const char *rest = strncmp(address, "http://", 7) == 0 ? address + 7 : address;
    snprintf(text, sizeof text, "tcp://%.200s", rest);
    orr_status status = orr_url_parse(text, &u, diag);
    if (status == ORR_OK && strcmp(u.host, "localhost") == 0) memcpy(u.host, "127.0.0.1", sizeof "127.0.0.1");
    if (status == ORR_OK && (!orr_url_is_local(&u) || strrchr(rest, ':') == NULL))
        status = orr_diag_set(
            diag, ORR_E_ARG,
            "'%.100s': pages are served on this machine alone, at 127.0.0.1:PORT or [::1]:PORT", address);
    if (status != ORR_OK) return status;
    status = orr_url_listen(&u, BACKLOG, fd, &bound, diag);
    if (status != ORR_OK) return status;
    s->port = bound.port;
    snprintf(s->url, sizeof s->url, "http%s/", orr_url_text(&bound, text) + 3);
    return ORR_OK;
}

static orr_status prepare(orr_http_server *s, int fd, orr_diag *diag)
{
    s->loop.nice = NICE;
    const orr_status status = orr_loop_open(&s->loop, NULL, NULL, diag);
    if (status == ORR_OK) s->http = evhttp_new(s->loop.base);
    if (s->http == NULL || evhttp_accept_socket(s->http, fd) != 0) {
        close(fd);
        return status != ORR_OK ? status : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    evhttp_set_allowed_methods(s->http, EVHTTP_REQ_GET | EVHTTP_REQ_HEAD);
    evhttp_set_max_headers_size(s->http, MOST_HEADERS);
    evhttp_set_max_body_size(s->http, MOST_BODY);
    evhttp_set_timeout(s->http, IDLE_S);
    evhttp_set_gencb(s->http, on_request, s);
    return ORR_OK;
}

orr_status orr_http_server_listen(const char *address, orr_http_server **out, orr_diag *diag)
{
    orr_http_server *s = calloc(1, sizeof *s);
    if (s == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    int fd = -1;
    orr_status status = listen_on(s, address, &fd, diag);
    if (status == ORR_OK) status = prepare(s, fd, diag);
    if (status != ORR_OK) {
        orr_http_server_close(s);
        return status;
    }
    *out = s;
    return ORR_OK;
}

orr_status orr_http_server_start(orr_http_server *s, const orr_http_route *route, size_t n, orr_diag *diag)
{
    s->route = calloc(n, sizeof *route);
    if (s->route == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    memcpy(s->route, route, n * sizeof *route);
    s->n = n;
    return orr_loop_start(&s->loop, "pages", diag);
}

const char *orr_http_server_url(const orr_http_server *s) { return s->url; }

void orr_http_server_close(orr_http_server *s)
{
    if (s == NULL) return;
    orr_loop_halt(&s->loop);
    for (size_t k = 0; k < ORR_HTTP_LISTENERS; k++) { // before their connections, which would tell them
        if (s->listener[k].request == NULL) continue;
        evhttp_connection_set_closecb(evhttp_request_get_connection(s->listener[k].request), NULL, NULL);
        forget(&s->listener[k]);
    }
    if (s->http != NULL) evhttp_free(s->http);
    orr_loop_close(&s->loop);
    free(s->route);
    free(s);
}
