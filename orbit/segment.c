// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/segment.h"

#include <stdlib.h>
#include <string.h>

// An innovation is a failure when it exceeds THRESHOLD times what this satellite's innovations usually are
// relative to their formal size, and FLOOR_M in metres: a centimetre model error in an eclipse is no outlier,
// a metre is.
#define THRESHOLD 12.0
#define FLOOR_M 0.50
#define MAX_SCALE                                                                                            \
    40.0 // what is worse than this many sigma everywhere (a metre by default) is not noise about an orbit
#define YOUNG 4       // nodes that a fresh state needs before its predictions are trusted
#define MAX_SKIPPED 3 // outliers in a row; more in a row is a manoeuvre
#define CONFIRM 2     // good nodes that confirm that the skipped ones were outliers
#define MIN_SPLIT                                                                                            \
    4 // nodes of an arc that was split off: three make an orbit, the fourth confirms that it is one
#define START_R_M 1e3
#define START_V_MPS 1e2

typedef struct group { // the usable nodes of one instant
    size_t instant;
    bool manoeuvre; // flagged
} group;

typedef struct work {
    const orr_track_context *c;
    const orr_node *list;
    orr_track *t;
    orr_verdict *verdict;
    group *g;
    size_t n;
    double scale2; // robust scale squared; 0 while it is not known: no tests
} work;

void orr_segmentation_free(orr_segmentation *s)
{
    free(s->arc);
    free(s->verdict);
    *s = (orr_segmentation){0};
}

static void start_at(const work *w, size_t instant)
{
    orr_instant *at = &w->t->at[instant];
    orr_kalman_start(&at->predicted, START_R_M, START_V_MPS, w->c->options->f0_sigma_mps2);
    at->filtered = at->predicted;
}

static void predict_to(const work *w, size_t from, size_t to)
{
    const orr_smoother_options *o = w->c->options;
    for (size_t k = from; k < to; k++) {
        orr_instant *a = &w->t->at[k], *b = &w->t->at[k + 1];
        orr_kalman_predict(&a->filtered, &a->next, a->noise * o->qf_m2ps5, o->qv_m2ps3, b->shift,
                           &b->predicted);
        b->filtered = b->predicted;
    }
}

// Takes in the nodes of an instant; with `test`, nodes that fail are rejected unless nothing but them is
// there, in which case the state stays as predicted. Returns whether any node was taken. d2 collects
// normalised squares.
static bool take_nodes(const work *w, size_t instant, bool test, double *d2_sum, size_t *d2_count)
{
    orr_instant *at = &w->t->at[instant];
    bool taken = false;
    for (size_t i = at->first; i < at->first + at->n; i++) {
        const orr_node *node = &w->list[i];
        if (node->superseded || w->verdict[i].rejected) continue;
        orr_vec3 z = orr_track_measured(w->c, at, node);
        double length = 0, d2 = orr_kalman_innovation2(&at->filtered, z, node->sigma_m, &length);
        if (test && w->scale2 > 0 && length > FLOOR_M && d2 > THRESHOLD * THRESHOLD * w->scale2) {
            w->verdict[i].rejected = true;
            w->verdict[i].innovation_m = length;
            continue;
        }
        if (d2_sum != NULL && !node->bridge) {
            *d2_sum += d2;
            ++*d2_count;
        }
        orr_kalman_update(&at->filtered, z, node->sigma_m);
        taken = true;
    }
    return taken;
}

static void forgive(const work *w, size_t g_from, size_t g_to)
{
    for (size_t g = g_from; g < g_to; g++) {
        const orr_instant *at = &w->t->at[w->g[g].instant];
        for (size_t i = at->first; i < at->first + at->n; i++) w->verdict[i] = (orr_verdict){0};
    }
}

static void reject_group(const work *w, size_t g, bool rejected, double innovation_m)
{
    const orr_instant *at = &w->t->at[w->g[g].instant];
    for (size_t i = at->first; i < at->first + at->n; i++)
        if (!w->list[i].superseded) w->verdict[i] = (orr_verdict){rejected, rejected ? innovation_m : 0};
}

static bool group_rejected(const work *w, size_t g)
{
    const orr_instant *at = &w->t->at[w->g[g].instant];
    for (size_t i = at->first; i < at->first + at->n; i++)
        if (!w->list[i].superseded && !w->verdict[i].rejected) return false;
    return true;
}

// Whether groups [a, b) agree with one orbit when those already rejected are left out.
static bool consistent(const work *w, size_t a, size_t b)
{
    while (a < b && group_rejected(w, a)) a++;
    if (a == b) return false;
    start_at(w, w->g[a].instant);
    take_nodes(w, w->g[a].instant, false, NULL, NULL);
    bool all = true;
    for (size_t g = a + 1; g < b && all; g++) {
        predict_to(w, w->g[g - 1].instant, w->g[g].instant);
        if (group_rejected(w, g)) continue;
        all = take_nodes(w, w->g[g].instant, true, NULL, NULL);
        if (!all) reject_group(w, g, false, 0);
    }
    return all;
}

// A failure soon after a start may be the fault of the start: looks for one or two of the young groups
// without which the window agrees with one orbit, and rejects them.
static bool blame_young(const work *w, size_t a, size_t first_bad)
{
    size_t end = first_bad + YOUNG < w->n ? first_bad + YOUNG : w->n;
    if (end - a < YOUNG + 2) return false;                  // too few to tell
    for (size_t apart = 0; apart <= first_bad - a; apart++) // one alone first, then pairs
        for (size_t i = a; i + apart <= first_bad; i++) {
            size_t j = i + apart;
            if (apart > 0 && end - a < YOUNG + 3) continue;
            if (group_rejected(w, i) || group_rejected(w, j)) continue; // blamed before
            reject_group(w, i, true, 0);
            reject_group(w, j, true, 0);
            if (consistent(w, a, end)) return true;
            reject_group(w, i, false, 0);
            reject_group(w, j, false, 0);
        }
    return false;
}

// Runs one arc from group a; returns the group at which the next one begins (w->n at the end). *last is the
// last group of the arc.
static size_t run_arc(const work *w, size_t a, size_t *last)
{
restart:
    while (a + 1 < w->n && group_rejected(w, a)) a++;
    start_at(w, w->g[a].instant);
    take_nodes(w, w->g[a].instant, false, NULL, NULL);
    size_t good = 1, first_bad = 0, skipped = 0, good_after = 0;
    for (size_t g = a + 1; g < w->n; g++) {
        if (w->g[g].manoeuvre) {
            *last = g - 1;
            return g;
        }
        predict_to(w, w->g[g - 1].instant, w->g[g].instant);
        if (group_rejected(w, g)) continue; // blamed before
        if (take_nodes(w, w->g[g].instant, true, NULL, NULL)) {
            good++;
            if (skipped > 0 && ++good_after >= CONFIRM) skipped = 0;
            continue;
        }
        if (skipped == 0) first_bad = g;
        skipped++;
        good_after = 0;
        bool at_end = g + 1 == w->n;
        if (skipped <= MAX_SKIPPED && !(at_end && skipped >= 2)) continue;
        forgive(w, first_bad, w->n);
        if (good <= YOUNG && blame_young(w, a, first_bad)) goto restart;
        *last = first_bad - 1;
        return first_bad;
    }
    *last = w->n - 1;
    return w->n;
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// Median of the normalised squares over a run without tests; 0.789 is the median of chi^2(3)/3.
static double robust_scale2(const work *w, double *room)
{
    size_t n = 0;
    start_at(w, w->g[0].instant);
    for (size_t g = 0; g < w->n; g++) {
        if (g > 0) predict_to(w, w->g[g - 1].instant, w->g[g].instant);
        double sum = 0;
        size_t count = 0;
        take_nodes(w, w->g[g].instant, false, &sum, &count);
        if (g >= YOUNG && count > 0) room[n++] = sum / (double)count;
    }
    if (n < 3) return 1.0;
    qsort(room, n, sizeof *room, by_value);
    double scale2 = room[n / 2] / 0.789;
    return scale2 < MAX_SCALE * MAX_SCALE ? scale2 : MAX_SCALE * MAX_SCALE;
}

orr_status orr_segment_track(const orr_track_context *c, const orr_node *list, size_t n, orr_track *t,
                             orr_segmentation *out)
{
    *out = (orr_segmentation){0};
    work w = {.c = c, .list = list, .t = t};
    w.g = malloc((t->n + 1) * sizeof *w.g);
    out->verdict = calloc(n + 1, sizeof *out->verdict);
    out->arc = malloc((n + 1) * sizeof *out->arc);
    double *room = malloc((t->n + 1) * sizeof *room);
    orr_status status = ORR_E_MEMORY;
    if (w.g == NULL || out->verdict == NULL || out->arc == NULL || room == NULL) goto done;
    w.verdict = out->verdict;
    for (size_t k = 0; k < t->n; k++) {
        bool usable = false, flagged = false;
        for (size_t i = t->at[k].first; i < t->at[k].first + t->at[k].n; i++) {
            usable = usable || !list[i].superseded;
            flagged = flagged || (!list[i].superseded && list[i].manoeuvre);
        }
        if (usable) w.g[w.n++] = (group){k, flagged};
    }
    status = ORR_E_NODATA;
    if (w.n == 0) goto done;
    double scale2 = robust_scale2(&w, room);
    w.scale2 = c->options->detect ? scale2 : 0;
    for (size_t a = 0; a < w.n;) {
        size_t last = a, next = run_arc(&w, a, &last), first = a;
        while (first < last && group_rejected(&w, first)) first++;
        while (last > first && group_rejected(&w, last)) last--;
        bool split = a > 0 || next < w.n;
        size_t good = 0;
        for (size_t g = first; g <= last; g++) good += !group_rejected(&w, g);
        if (good >= (split ? MIN_SPLIT : 2))
            out->arc[out->n_arcs++] = (orr_arc_range){w.g[first].instant, w.g[last].instant};
        a = next;
    }
    status = ORR_OK;
done:
    free(w.g);
    free(room);
    if (status != ORR_OK) orr_segmentation_free(out);
    return status;
}

void orr_filter_track(const orr_track_context *c, const orr_node *list, const orr_verdict *verdict,
                      orr_track *t)
{
    work w = {.c = c,
              .list = list,
              .t = t,
              .verdict = (orr_verdict *)verdict}; // without a scale nothing is tested or written
    start_at(&w, 0);
    for (size_t k = 0; k < t->n; k++) {
        if (k > 0) predict_to(&w, k - 1, k);
        if (t->at[k].n > 0) take_nodes(&w, k, false, NULL, NULL);
    }
}

orr_status orr_smooth_range(orr_track *t, size_t first, size_t last)
{
    t->at[last].smoothed = t->at[last].filtered;
    for (size_t k = last; k-- > first;) {
        orr_instant *a = &t->at[k], *b = &t->at[k + 1];
        orr_status s = orr_kalman_smooth(&a->filtered, &a->next, &b->predicted, &b->smoothed, &a->smoothed);
        if (s != ORR_OK) return s;
    }
    return ORR_OK;
}
