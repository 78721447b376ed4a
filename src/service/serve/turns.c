// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/serve/turns.h"

#include <stdlib.h>

void orr_turns_init(orr_turns *q, int64_t credit) { *q = (orr_turns){.credit = credit}; }

void orr_turns_free(orr_turns *q)
{
    free(q->heap);
    *q = (orr_turns){0};
}

static bool before(const orr_turns_member *a, const orr_turns_member *b)
{
    return a->used != b->used ? a->used < b->used : a->number < b->number;
}

static void put(orr_turns *q, size_t i, orr_turns_member *m)
{
    q->heap[i] = m;
    m->place = i + 1;
}

static void up(orr_turns *q, size_t i, orr_turns_member *m)
{
    for (; i > 0 && before(m, q->heap[(i - 1) / 2]); i = (i - 1) / 2) put(q, i, q->heap[(i - 1) / 2]);
    put(q, i, m);
}

static void down(orr_turns *q, size_t i, orr_turns_member *m)
{
    for (size_t child; (child = 2 * i + 1) < q->n; i = child) {
        if (child + 1 < q->n && before(q->heap[child + 1], q->heap[child])) child++;
        if (!before(q->heap[child], m)) break;
        put(q, i, q->heap[child]);
    }
    put(q, i, m);
}

static void take_out(orr_turns *q, orr_turns_member *m)
{
    size_t i = m->place - 1;
    orr_turns_member *last = q->heap[--q->n];
    m->place = 0;
    if (last == m) return;
    if (i > 0 && before(last, q->heap[(i - 1) / 2]))
        up(q, i, last);
    else
        down(q, i, last);
}

bool orr_turns_join(orr_turns *q, orr_turns_member *m)
{
    if (q->joined == q->capacity) {
        size_t capacity = q->capacity > 0 ? 2 * q->capacity : 64;
        orr_turns_member **grown = realloc(q->heap, capacity * sizeof(orr_turns_member *));
        if (grown == NULL) return false;
        q->heap = grown;
        q->capacity = capacity;
    }
    q->joined++;
    *m = (orr_turns_member){.used = q->floor - q->credit};
    return true;
}

void orr_turns_leave(orr_turns *q, orr_turns_member *m)
{
    if (m->place > 0) take_out(q, m);
    q->joined--;
}

void orr_turns_wait(orr_turns *q, orr_turns_member *m)
{
    if (m->place > 0) return;
    if (m->used < q->floor - q->credit) m->used = q->floor - q->credit;
    m->number = q->arrivals++;
    up(q, q->n++, m);
}

orr_turns_member *orr_turns_next(orr_turns *q)
{
    if (q->n == 0) return NULL;
    orr_turns_member *m = q->heap[0];
    take_out(q, m);
    if (m->used > q->floor) q->floor = m->used;
    return m;
}
