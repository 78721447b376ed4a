// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/live/ahead.h"

#include <assert.h>
#include <pthread.h>
#include <stdlib.h>

enum { LANES = 4 };
static const int64_t CELL_NS = 10 * ORR_NS_PER_S; // what workspaces keep is of one such stretch

// A workspace and the last block that was made with it.
typedef struct side {
    orr_channel_work *work;
    orr_block *block;
    size_t n;
    orr_blocks blocks;
    bool there;
} side;

typedef enum state { IDLE, ASKED, BUSY, READY } state;

// One antenna with one choice of signals.
typedef struct lane {
    bool used, in_use; // in_use: a block is made at its front
    size_t antenna;
    uint64_t signals, turn;
    side side[2]; // the front is of who asks; the other one, while it is BUSY, the thread's
    int front;
    state state; // of the other side
    orr_time wanted;
} lane;

struct orr_ahead {
    const orr_channels *c;
    pthread_t thread;
    pthread_mutex_t lock;
    pthread_cond_t changed;
    bool stop, has_thread;
    uint64_t turn;
    lane lane[LANES];
};

static bool holds(const side *x, orr_time t)
{
    return x->there && t >= x->blocks.t0 && t - x->blocks.t0 < x->blocks.length_ns;
}

static orr_answer make(const orr_ahead *a, const lane *l, side *x, orr_time t)
{
    const orr_answer answer =
        orr_blocks_at(a->c, l->antenna, x->work, t, l->signals, &x->blocks, x->block, &x->n);
    x->there = answer == ORR_ANSWER_OK;
    return answer;
}

static void *run(void *user)
{
    orr_ahead *a = user;
    pthread_mutex_lock(&a->lock);
    while (!a->stop) {
        lane *l = NULL;
        for (int k = 0; k < LANES; k++)
            if (a->lane[k].state == ASKED) l = &a->lane[k];
        if (l == NULL) {
            pthread_cond_wait(&a->changed, &a->lock);
            continue;
        }
        const orr_time t = l->wanted;
        l->state = BUSY;
        pthread_mutex_unlock(&a->lock);
        (void)make(a, l, &l->side[1 - l->front], t);
        pthread_mutex_lock(&a->lock);
        l->state = READY;
    }
    pthread_mutex_unlock(&a->lock);
    return NULL;
}

static orr_status open_side(const orr_channels *c, side *x, orr_diag *diag)
{
    x->block = calloc(orr_channels_max(c) + 1, sizeof *x->block);
    if (x->block == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    return orr_channel_work_open(c, &x->work, diag);
}

orr_status orr_ahead_open(const orr_channels *c, orr_ahead **out, orr_diag *diag)
{
    orr_ahead *a = calloc(1, sizeof *a);
    if (a == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    a->c = c;
    pthread_mutex_init(&a->lock, NULL);
    pthread_cond_init(&a->changed, NULL);
    orr_status s = ORR_OK;
    for (int k = 0; s == ORR_OK && k < 2 * LANES; k++) s = open_side(c, &a->lane[k / 2].side[k % 2], diag);
    a->has_thread = s == ORR_OK && pthread_create(&a->thread, NULL, run, a) == 0;
    if (s == ORR_OK && !a->has_thread) s = orr_diag_set(diag, ORR_E_MEMORY, "no thread could be started");
    if (s == ORR_OK)
        *out = a;
    else
        orr_ahead_close(a);
    return s;
}

void orr_ahead_close(orr_ahead *a)
{
    if (a == NULL) return;
    pthread_mutex_lock(&a->lock);
    a->stop = true;
    pthread_cond_signal(&a->changed);
    pthread_mutex_unlock(&a->lock);
    if (a->has_thread) pthread_join(a->thread, NULL);
    for (int k = 0; k < 2 * LANES; k++) {
        orr_channel_work_close(a->lane[k / 2].side[k % 2].work);
        free(a->lane[k / 2].side[k % 2].block);
    }
    pthread_cond_destroy(&a->changed);
    pthread_mutex_destroy(&a->lock);
    free(a);
}

// The lane of an antenna with these signals; it may take the place of that which was asked longest ago. Under the lock.
static lane *lane_of(orr_ahead *a, size_t antenna, uint64_t signals)
{
    lane *oldest = NULL;
    for (int k = 0; k < LANES; k++) {
        lane *l = &a->lane[k];
        if (l->used && l->antenna == antenna && l->signals == signals) return l;
        if (!l->in_use && l->state != BUSY && (oldest == NULL || l->turn < oldest->turn)) oldest = l;
    }
    if (oldest == NULL) return NULL; // one is made, and one prepared: there are more than two
    oldest->used = true;
    oldest->antenna = antenna;
    oldest->signals = signals;
    oldest->side[0].there = oldest->side[1].there = false;
    oldest->state = IDLE;
    return oldest;
}

// Under the lock.
static void want(orr_ahead *a, lane *l, orr_time t)
{
    if (l->state == BUSY || (l->state != IDLE && l->wanted == t)) return;
    l->state = ASKED;
    l->wanted = t;
    pthread_cond_signal(&a->changed);
}

void orr_ahead_expect(orr_ahead *a, size_t antenna, orr_time t, uint64_t signals)
{
    pthread_mutex_lock(&a->lock);
    lane *l = lane_of(a, antenna, signals);
    if (l != NULL) {
        l->turn = ++a->turn;
        if (!holds(&l->side[l->front], t)) want(a, l, t);
    }
    pthread_mutex_unlock(&a->lock);
}

orr_answer orr_ahead_blocks(orr_ahead *a, size_t antenna, orr_time t, uint64_t signals, orr_blocks *out,
                            const orr_block **block, size_t *n)
{
    pthread_mutex_lock(&a->lock);
    lane *l = lane_of(a, antenna, signals);
    assert(l != NULL); // this thread makes none now, and the other one makes one at most
    l->in_use = true;
    l->turn = ++a->turn;
    if (!holds(&l->side[l->front], t) && l->state == READY && holds(&l->side[1 - l->front], t)) {
        l->front = 1 - l->front;
        l->state = IDLE;
    }
    side *x = &l->side[l->front];
    pthread_mutex_unlock(&a->lock);
    const orr_answer answer = holds(x, t) ? ORR_ANSWER_OK : make(a, l, x, t);
    pthread_mutex_lock(&a->lock);
    l->in_use = false;
    if (answer == ORR_ANSWER_OK) { // the last block of this cell, or, behind that, of the next
        const orr_time end = x->blocks.t0 + x->blocks.length_ns,
                       last = end - 1 - orr_floor_mod(end - 1, CELL_NS) + CELL_NS;
        want(a, l, end < last ? last - 1 : last + CELL_NS - 1);
    }
    pthread_mutex_unlock(&a->lock);
    *out = x->blocks;
    *block = x->block;
    *n = answer == ORR_ANSWER_OK ? x->n : 0;
    return answer;
}
