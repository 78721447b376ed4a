// SPDX-License-Identifier: GPL-3.0-or-later
// Workspaces: what evaluations find and keep for the next. All of it is a function of scenario and time, so that nothing which is
// kept changes an answer.
#include <stdlib.h>

#include "src/scenario/channel/seen.h"
#include "src/scenario/channel/slow.h"
#include "src/scenario/channel/spoofed.h"

static orr_status open_list(const orr_channels *c, channel_list *list)
{
    list->t = ORR_TIME_NONE;
    list->channel = calloc(c->max_channels, sizeof *list->channel);
    list->place = calloc(c->max_channels, sizeof *list->place);
    list->seen = calloc(c->max_channels, sizeof *list->seen);
    list->start = calloc(c->max_channels, sizeof *list->start);
    return list->channel != NULL && list->place != NULL && list->seen != NULL && list->start != NULL
               ? ORR_OK
               : ORR_E_MEMORY;
}

static orr_status open_antenna(const orr_channels *c, channel_antenna_work *w)
{
    w->candidates_of = ORR_TIME_NONE;
    w->slow = slow_cells_open(c->n_sats);
    w->candidate = calloc(c->n_sats, sizeof *w->candidate);
    if (c->scintillation != NULL) w->fading = calloc(c->n_sats, sizeof *w->fading);
    if (w->slow == NULL || w->candidate == NULL || (c->scintillation != NULL && w->fading == NULL))
        return ORR_E_MEMORY;
    const orr_status s = open_list(c, &w->begin);
    return s == ORR_OK ? open_list(c, &w->end) : s;
}

static orr_status open_all(const orr_channels *c, orr_channel_work *w)
{
    const size_t n = c->n_sats;
    w->c = c;
    w->satellite = calloc(n, sizeof *w->satellite);
    w->state = calloc(n, sizeof *w->state);
    w->delays = calloc(n, sizeof *w->delays);
    w->todo = calloc(n, sizeof *w->todo);
    w->chosen = calloc(n, sizeof *w->chosen);
    w->also = calloc(n, sizeof *w->also);
    w->direction = calloc(n, sizeof *w->direction);
    w->missing = calloc(n, sizeof *w->missing);
    w->stale = calloc(n, sizeof *w->stale);
    for (int k = 0; k < 4; k++) w->node[k] = slow_nodes_open(n);
    for (int k = 0; k < 2; k++) w->values[k] = calloc(SLOW_BATCH, sizeof *w->values[k]);
    if (w->satellite == NULL || w->state == NULL || w->delays == NULL || w->todo == NULL ||
        w->missing == NULL || w->stale == NULL || w->chosen == NULL || w->also == NULL ||
        w->direction == NULL || w->node[0] == NULL || w->node[1] == NULL || w->node[2] == NULL ||
        w->node[3] == NULL || w->values[0] == NULL || w->values[1] == NULL)
        return ORR_E_MEMORY;
    for (size_t k = 0; k < n; k++) w->delays[k].cell = ORR_TIME_NONE;
    orr_status s = ORR_OK;
    for (size_t k = 0; s == ORR_OK && k < c->n_antennas; k++) s = open_antenna(c, &w->antenna[k]);
    return s == ORR_OK && c->spoofed != NULL ? orr_channel_work_open(&c->spoofed->sky, &w->spoofed, NULL) : s;
}

orr_status orr_channel_work_open(const orr_channels *c, orr_channel_work **out, orr_diag *diag)
{
    *out = calloc(1, sizeof **out);
    const orr_status s = *out != NULL ? open_all(c, *out) : ORR_E_MEMORY;
    if (s == ORR_OK) return ORR_OK;
    orr_channel_work_close(*out);
    *out = NULL;
    return orr_diag_set(diag, s, "out of memory");
}

static void free_list(channel_list *list)
{
    free(list->channel);
    free(list->place);
    free(list->seen);
    free(list->start);
}

void orr_channel_work_close(orr_channel_work *w)
{
    if (w == NULL) return;
    orr_channel_work_close(w->spoofed);
    for (size_t k = 0; k < ORR_MAX_ANTENNAS; k++) {
        channel_antenna_work *a = &w->antenna[k];
        free(a->slow);
        free(a->candidate);
        free(a->fading);
        free_list(&a->begin);
        free_list(&a->end);
    }
    free(w->satellite);
    free(w->state);
    free(w->delays);
    free(w->todo);
    free(w->chosen);
    free(w->direction);
    free(w->also);
    free(w->missing);
    free(w->stale);
    for (int k = 0; k < 4; k++) free(w->node[k]);
    for (int k = 0; k < 2; k++) free(w->values[k]);
    free(w);
}
