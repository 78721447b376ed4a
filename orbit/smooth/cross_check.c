// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/cross_check.h"

#include <stdlib.h>

#include "core/robust.h"

#define FLOOR_M 0.50    // as of innovations
#define THRESHOLD 100.0 // times what is usual; at an hour's nodes, the last one of a good day reaches 40
// An outlier raises the usual scale of its neighbours, up to twenty times in a day of hourly nodes.
#define SUSPICIOUS 5.0
#define LEAST_NODES 8 // of an arc, to know what is usual
#define MOST_ROUNDS 12

typedef struct work {
    const orr_track_context *c;
    const orr_node *list;
    orr_verdict *verdict;
    orr_track *t;
    size_t first, last; // instants looked at
    double *room;       // as many as the track has instants and nodes
} work;

// A node against the orbit without it: its distance, and that in units of its formal size.
typedef struct distance {
    double length_m, normal;
} distance;

// e = measured minus smoothed, P the smoothed covariance, R = sigma^2 E. Of a node that was not used the
// covariance of e is R + P. Of one that was, R - P; without it e would be R (R - P)^-1 e, of covariance R (R
// - P)^-1 R, so that e' (R - P)^-1 e is its normalised square as well.
static distance distance_of(const work *w, const orr_instant *at, size_t i)
{
    const orr_gauss *g = &at->smoothed;
    const bool used = !w->verdict[i].rejected;
    const double r = w->list[i].sigma_m * w->list[i].sigma_m;
    orr_mat3 s;
    for (int j = 0; j < 3; j++)
        for (int k = 0; k < 3; k++) s.m[j][k] = (j == k ? r : 0) + (used ? -g->P[j][k] : g->P[j][k]);
    const orr_vec3 x = orr_vec3_make(g->x[0], g->x[1], g->x[2]);
    const orr_vec3 e = orr_vec3_sub(orr_track_measured(w->c, at, &w->list[i]), x);
    const orr_mat3 weight = orr_mat3_inverse(&s);
    const orr_vec3 u = orr_mat3_apply(&weight, e);
    return (distance){used ? r * orr_vec3_norm(u) : orr_vec3_norm(e), sqrt(fmax(orr_vec3_dot(e, u), 0) / 3)};
}

static bool counts(const work *w, size_t i) { return !w->list[i].superseded && !w->list[i].bridge; }

// What is usual (the median of the used nodes), and the used node that is furthest from that; SIZE_MAX if
// none is far.
static double usual(const work *w, size_t *worst, distance *of_worst)
{
    size_t n = 0;
    *worst = SIZE_MAX;
    *of_worst = (distance){0};
    for (size_t k = w->first; k <= w->last; k++) {
        const orr_instant *at = &w->t->at[k];
        for (size_t i = at->first; i < at->first + at->n; i++) {
            if (!counts(w, i) || w->verdict[i].rejected) continue;
            const distance d = distance_of(w, at, i);
            w->room[n++] = d.normal;
            if (!(d.length_m > FLOOR_M) || !(d.normal > of_worst->normal)) continue;
            *worst = i;
            *of_worst = d;
        }
    }
    if (n < LEAST_NODES) return HUGE_VAL;
    return orr_upper_median(w->room, n);
}

static orr_status again(const work *w)
{
    orr_filter_range(w->c, w->list, w->verdict, w->t, w->first, w->last);
    return orr_smooth_range(w->c, w->t, w->first, w->last);
}

// The worst of the used nodes goes, if it is one that the others disagree with. What is usual is taken
// without it.
static orr_status drop_worst(const work *w, bool *dropped)
{
    size_t worst, next;
    distance d, unused;
    *dropped = false;
    const double before = usual(w, &worst, &d);
    if (worst == SIZE_MAX || !(d.normal > SUSPICIOUS * before)) return ORR_OK;
    w->verdict[worst].rejected = true;
    orr_status s = again(w);
    if (s != ORR_OK) return s;
    *dropped = d.normal > THRESHOLD * usual(w, &next, &unused);
    if (*dropped) return ORR_OK;
    w->verdict[worst].rejected = false;
    return again(w);
}

// Rejected nodes that are near the orbit of the others are used again.
static orr_status take_back(const work *w, bool *taken)
{
    size_t worst;
    distance of_worst;
    const double scale = usual(w, &worst, &of_worst);
    *taken = false;
    for (size_t k = w->first; k <= w->last; k++) {
        const orr_instant *at = &w->t->at[k];
        for (size_t i = at->first; i < at->first + at->n; i++) {
            if (!counts(w, i) || !w->verdict[i].rejected) continue;
            const distance d = distance_of(w, at, i);
            if (d.length_m > FLOOR_M || d.normal > THRESHOLD / 2 * scale) continue;
            w->verdict[i].rejected = false;
            *taken = true;
        }
    }
    return *taken ? again(w) : ORR_OK;
}

static bool goes_over(const work *w)
{
    for (size_t k = w->first; k <= w->last; k++)
        for (size_t i = w->t->at[k].first; i < w->t->at[k].first + w->t->at[k].n; i++)
            if (w->verdict[i].jump_m > 0) return true;
    return false;
}

static bool has_used(const work *w, size_t k)
{
    const orr_instant *at = &w->t->at[k];
    for (size_t i = at->first; i < at->first + at->n; i++)
        if (!w->list[i].superseded && !w->verdict[i].rejected) return true;
    return false;
}

orr_status orr_cross_check_arc(const orr_track_context *c, const orr_node *list, orr_verdict *verdict,
                               orr_track *t, size_t lowest, size_t highest, orr_arc_range *arc)
{
    size_t n_nodes = 0, rejected = 0, worst;
    distance of_worst;
    work w = {c, list, verdict, t, arc->first, arc->last, NULL};
    for (size_t k = lowest; k <= highest; k++)
        for (size_t i = t->at[k].first; i < t->at[k].first + t->at[k].n; i++, n_nodes++) {
            if (k < arc->first || k > arc->last) verdict[i].rejected = true; // no arc has it
            rejected += counts(&w, i) && verdict[i].rejected;
        }
    if (goes_over(&w)) return ORR_OK;
    w.room = malloc((n_nodes + 1) * sizeof *w.room);
    if (w.room == NULL) return ORR_E_MEMORY;
    orr_status s = ORR_OK;
    const double scale = usual(&w, &worst, &of_worst);
    if (!isfinite(scale) || (rejected == 0 && !(of_worst.normal > SUSPICIOUS * scale)))
        goto done; // all is well
    w.first = lowest;
    w.last = highest;
    s = again(&w);
    for (int round = 0; round < MOST_ROUNDS && s == ORR_OK; round++) {
        bool dropped = false, taken = false;
        s = drop_worst(&w, &dropped);
        if (s == ORR_OK && (dropped || round == 0)) s = take_back(&w, &taken);
        if (!dropped && !taken) break;
    }
    while (w.first < w.last && !has_used(&w, w.first)) w.first++;
    while (w.last > w.first && !has_used(&w, w.last)) w.last--;
    *arc = (orr_arc_range){w.first, w.last};
    if (s == ORR_OK) s = again(&w);
done:
    free(w.room);
    return s;
}
