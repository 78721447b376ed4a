// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/text/text_server.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "core/outfile.h"
#include "src/service/net/url.h"
#include "src/service/text/session.h"

enum { CLIENTS = 32, MOST_WAITING = 1 << 20 };

typedef struct text_client {
    int fd;
    orr_text_session session;
    char *out; // what waits to be sent
    size_t n, at;
} text_client;

struct orr_text_server {
    orr_asked asked;
    orr_url url;
    char text[ORR_URL_TEXT];
    int listener, stop[2];
    pthread_t thread;
    bool has_thread;
    size_t n;
    text_client client[CLIENTS];
};

static void drop(orr_text_server *s, size_t k)
{
    text_client *c = &s->client[k];
    close(c->fd);
    orr_text_session_close(&c->session);
    free(c->out);
    *c = s->client[--s->n];
}

static bool flush(text_client *c)
{
    while (c->at < c->n) {
        const ssize_t sent = send(c->fd, c->out + c->at, c->n - c->at, MSG_NOSIGNAL);
        if (sent < 0) return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
        c->at += (size_t)sent;
    }
    c->at = c->n = 0;
    return true;
}

// Appends an answer to what waits; false where too much does.
static bool append(text_client *c, const char *text, size_t n)
{
    if (n == 0) return true;
    if (c->n - c->at + n > MOST_WAITING && c->n > c->at) return false;
    char *grown = realloc(c->out, c->n + n);
    if (grown == NULL) return false;
    memcpy(grown + c->n, text, n);
    c->out = grown;
    c->n += n;
    return true;
}

static bool serve(text_client *c)
{
    char data[4096];
    const ssize_t n = recv(c->fd, data, sizeof data, 0);
    if (n < 0) return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
    if (n == 0) return false;
    char *answer = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&answer, &size);
    if (out == NULL) return false;
    orr_text_session_take(&c->session, data, (size_t)n, out);
    fclose(out);
    const bool good = append(c, answer, size) && flush(c);
    free(answer);
    return good;
}

static void welcome(orr_text_server *s)
{
    const int fd = accept(s->listener, NULL, NULL);
    if (fd < 0) return;
    if (s->n == CLIENTS || fcntl(fd, F_SETFL, O_NONBLOCK) != 0 || fcntl(fd, F_SETFD, FD_CLOEXEC) != 0) {
        close(fd);
        return;
    }
    text_client *c = &s->client[s->n];
    *c = (text_client){.fd = fd};
    if (orr_text_session_open(&c->session, &s->asked))
        s->n++;
    else
        close(fd);
}

static void *run(void *user)
{
    orr_text_server *s = user;
    struct pollfd p[CLIENTS + 2];
    for (;;) {
        const size_t n = s->n;
        p[0] = (struct pollfd){.fd = s->stop[0], .events = POLLIN};
        p[1] = (struct pollfd){.fd = s->listener, .events = POLLIN};
        for (size_t k = 0; k < n; k++) // while answers wait nothing more is asked
            p[k + 2] =
                (struct pollfd){.fd = s->client[k].fd, .events = s->client[k].n > 0 ? POLLOUT : POLLIN};
        if (poll(p, (nfds_t)n + 2, -1) < 0) continue;
        if (p[0].revents != 0) return NULL;
        for (size_t k = n; k-- > 0;) {
            text_client *c = &s->client[k];
            if (p[k + 2].revents == 0) continue;
            const bool good = (p[k + 2].revents & POLLOUT) != 0 ? flush(c) : serve(c);
            if (!good) drop(s, k);
        }
        if (p[1].revents != 0) welcome(s);
    }
}

static orr_status listen_on(orr_text_server *s, const char *url, orr_diag *diag)
{
    orr_url u;
    orr_status status = orr_url_parse(url, &u, diag);
    if (status == ORR_OK && !orr_url_is_local(&u))
        status =
            orr_diag_set(diag, ORR_E_ARG,
                         "%s: text is served on this machine alone: tcp://127.0.0.1:PORT or unix:PATH", url);
    if (status == ORR_OK) status = orr_url_listen(&u, CLIENTS, &s->listener, &s->url, diag);
    if (status != ORR_OK) return status;
    if (s->url.is_unix) orr_outfile_remember(s->url.path);
    orr_url_text(&s->url, s->text);
    return ORR_OK;
}

orr_status orr_text_server_open(const char *url, const orr_asked *asked, orr_text_server **out,
                                orr_diag *diag)
{
    orr_text_server *s = calloc(1, sizeof *s);
    if (s == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    s->listener = s->stop[0] = s->stop[1] = -1;
    s->asked = *asked;
    s->asked.room = malloc(ORR_MSG_LARGEST);
    orr_status status =
        s->asked.room != NULL ? listen_on(s, url, diag) : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (status == ORR_OK && (pipe(s->stop) != 0 || pthread_create(&s->thread, NULL, run, s) != 0))
        status = orr_diag_set(diag, ORR_E_IO, "no thread for text");
    s->has_thread = status == ORR_OK;
    if (status != ORR_OK) {
        orr_text_server_close(s);
        return status;
    }
    *out = s;
    return ORR_OK;
}

const char *orr_text_server_url(const orr_text_server *s) { return s->text; }

void orr_text_server_close(orr_text_server *s)
{
    if (s == NULL) return;
    if (s->has_thread && write(s->stop[1], "s", 1) == 1) pthread_join(s->thread, NULL);
    while (s->n > 0) drop(s, s->n - 1);
    if (s->listener >= 0) close(s->listener);
    if (s->url.is_unix && s->listener >= 0) {
        unlink(s->url.path);
        orr_outfile_forget(s->url.path);
    }
    for (int k = 0; k < 2; k++)
        if (s->stop[k] >= 0) close(s->stop[k]);
    free(s->asked.room);
    free(s);
}
