// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/net/datagrams.h"

#include <pthread.h>
#include <stdlib.h>

typedef struct channel {
    orr_datagram_reader reader;
    orr_seal *seal; // NULL: none
    bool may;
    struct channel *next;
} channel;

struct orr_datagrams {
    pthread_mutex_t lock;
    channel *first;
    uint32_t last; // number that was given out
    uint16_t port;
};

orr_datagrams *orr_datagrams_open(void)
{
    orr_datagrams *d = calloc(1, sizeof *d);
    if (d != NULL) pthread_mutex_init(&d->lock, NULL);
    return d;
}

static void forget(channel *c)
{
    orr_seal_close(c->seal);
    free(c);
}

void orr_datagrams_close(orr_datagrams *d)
{
    if (d == NULL) return;
    for (channel *c = d->first, *next; c != NULL; c = next) {
        next = c->next;
        forget(c);
    }
    pthread_mutex_destroy(&d->lock);
    free(d);
}

void orr_datagrams_listen(orr_datagrams *d, uint16_t port)
{
    pthread_mutex_lock(&d->lock);
    d->port = port;
    pthread_mutex_unlock(&d->lock);
}

uint16_t orr_datagrams_port(orr_datagrams *d)
{
    pthread_mutex_lock(&d->lock);
    const uint16_t port = d->port;
    pthread_mutex_unlock(&d->lock);
    return port;
}

// Where a channel hangs in the list; points to NULL where there is none.
static channel **find(orr_datagrams *d, uint32_t number)
{
    channel **at = &d->first;
    while (*at != NULL && (*at)->reader.channel != number) at = &(*at)->next;
    return at;
}

// Under the lock. After 2^32 numbers those of long ago come again, with other keys.
static uint32_t next_number(orr_datagrams *d)
{
    do d->last++;
    while (d->last == 0 || *find(d, d->last) != NULL);
    return d->last;
}

uint32_t orr_datagrams_number(orr_datagrams *d)
{
    pthread_mutex_lock(&d->lock);
    const uint32_t number = next_number(d);
    pthread_mutex_unlock(&d->lock);
    return number;
}

uint32_t orr_datagrams_admit(orr_datagrams *d, const uint8_t *key, bool may)
{
    channel *c = calloc(1, sizeof *c);
    if (c == NULL) return 0;
    if (key != NULL && (c->seal = orr_seal_open(key)) == NULL) {
        free(c);
        return 0;
    }
    c->may = may;
    c->reader.holds = c->seal != NULL ? orr_seal_holds : NULL;
    c->reader.user = c->seal;
    pthread_mutex_lock(&d->lock);
    const uint32_t number = c->reader.channel = next_number(d);
    c->next = d->first;
    d->first = c;
    pthread_mutex_unlock(&d->lock);
    return number;
}

void orr_datagrams_permit(orr_datagrams *d, uint32_t number, bool may)
{
    pthread_mutex_lock(&d->lock);
    channel *c = *find(d, number);
    if (c != NULL) c->may = may;
    pthread_mutex_unlock(&d->lock);
}

void orr_datagrams_leave(orr_datagrams *d, uint32_t number)
{
    pthread_mutex_lock(&d->lock);
    channel **at = find(d, number), *c = *at;
    if (c != NULL) {
        *at = c->next;
        forget(c);
    }
    pthread_mutex_unlock(&d->lock);
}

orr_datagram_counts orr_datagrams_count(orr_datagrams *d, uint32_t number)
{
    orr_datagram_counts told = {0};
    pthread_mutex_lock(&d->lock);
    const channel *c = *find(d, number);
    if (c != NULL)
        told = (orr_datagram_counts){c->reader.window.taken, c->reader.window.replayed, c->reader.refused};
    pthread_mutex_unlock(&d->lock);
    return told;
}

orr_datagram_verdict orr_datagrams_take(orr_datagrams *d, const uint8_t *data, size_t n, bool local,
                                        orr_frame *f)
{
    orr_datagram_verdict verdict = ORR_DATAGRAM_REFUSED;
    pthread_mutex_lock(&d->lock);
    channel *c = *find(d, orr_datagram_channel(data, n));
    if (c != NULL && c->seal == NULL && !local) {
        c->reader.refused++;
    } else if (c != NULL) {
        const uint64_t replayed = c->reader.window.replayed;
        if (orr_datagram_read(&c->reader, data, n, f))
            verdict = c->may ? ORR_DATAGRAM_TAKEN : ORR_DATAGRAM_NOT_ALLOWED;
        else if (c->reader.window.replayed != replayed)
            verdict = ORR_DATAGRAM_REPLAYED;
    }
    pthread_mutex_unlock(&d->lock);
    return verdict;
}
