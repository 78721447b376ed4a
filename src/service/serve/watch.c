// SPDX-License-Identifier: GPL-3.0-or-later
// Who is connected, for whoever watches the service from another thread: noted at every sweep while somebody asks, so that nothing
// of a connection is shared and nobody pays for a page that is not open.
#include <stdlib.h>
#include <string.h>

#include "src/service/serve/service_private.h"

static const int64_t FORGOTTEN_NS = INT64_C(5000000000); // nobody asks any more

void orr_watch_note(orr_service *s)
{
    orr_watch *w = &s->watch;
    const int64_t now_ns = orr_service_clock_ns(s);
    pthread_mutex_lock(&w->lock);
    const bool watched = w->asked_ns != 0 && now_ns - w->asked_ns < FORGOTTEN_NS;
    if (watched && w->row == NULL) w->row = calloc(ORR_CLIENTS_LOOKED, sizeof *w->row);
    w->n = w->all = 0;
    for (orr_conn *c = watched && w->row != NULL ? s->conns : NULL; c != NULL; c = orr_conn_next(c)) {
        if (w->n < ORR_CLIENTS_LOOKED) orr_conn_look(c, now_ns, &w->row[w->n++]);
        w->all++;
    }
    pthread_mutex_unlock(&w->lock);
}

size_t orr_service_clients(orr_service *s, orr_client_look *out, size_t most)
{
    orr_watch *w = &s->watch;
    pthread_mutex_lock(&w->lock);
    w->asked_ns = orr_service_clock_ns(s);
    const size_t n = w->n < most ? w->n : most, all = w->all;
    if (n > 0) memcpy(out, w->row, n * sizeof *out);
    pthread_mutex_unlock(&w->lock);
    return all;
}
