// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/segmentation.h"

#include <stdlib.h>
#include <string.h>

#include "core/robust.h"

// An innovation is a failure when it exceeds THRESHOLD times what this satellite's innovations usually are
// relative to their formal size, and FLOOR_M in metres: a centimetre model error in an eclipse is no outlier,
// a metre is.
#define THRESHOLD 12.0
#define FLOOR_M 0.50
// More than this many sigma everywhere (a metre by default) is no noise about an orbit.
#define MAX_SCALE 40.0
#define YOUNG 4       // nodes that a fresh state needs before its predictions are trusted
#define MAX_SKIPPED 3 // outliers in a row; more in a row is a manoeuvre
#define CONFIRM 2     // good nodes that confirm that the skipped ones were outliers
// Nodes of a segment that was split off: three determine an orbit, the fourth confirms it.
#define MIN_SPLIT 4
// A day's orbit that goes on elsewhere than the last one ended is no manoeuvre: continuity is preferred, and
// the filter is given some nodes to go over from one to the other. What is further apart than this is not the
// same orbit.
#define JUMP_M 5.0
#define SETTLE 8

typedef struct group { // the usable nodes of one instant
    size_t instant;
    bool manoeuvre; // flagged
    bool joint;     // another file begins
    bool settling;  // soon after a joint where the files go on elsewhere
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

#define UNTESTED HUGE_VAL

static void start_at(const work *w, size_t instant)
{
    orr_instant *at = &w->t->at[instant];
    const orr_filter_noise *n = &w->c->noise;
    orr_kalman_start(&at->predicted, n->start_r_m, n->start_v_mps, n->f0_sigma_mps2);
    at->filtered = at->predicted;
}

// What is new where a window of the reference or a file begins.
static void renew(orr_instant *at)
{
    for (int i = 0; i < ORR_ECOM_TERMS && at->renew; i++)
        at->predicted.P[ORR_PARTIAL_ECOM + i][ORR_PARTIAL_ECOM + i] +=
            orr_ecom_sigma_nmps2[i] * orr_ecom_sigma_nmps2[i];
    for (int i = 0; i < 3 && at->step; i++) {
        at->predicted.P[i][i] += ORR_FILE_STEP_R_M * ORR_FILE_STEP_R_M;
        at->predicted.P[3 + i][3 + i] += ORR_FILE_STEP_V_MPS * ORR_FILE_STEP_V_MPS;
    }
}

static void predict_to(const work *w, size_t from, size_t to)
{
    const orr_filter_noise *n = &w->c->noise;
    for (size_t k = from; k < to; k++) {
        orr_instant *a = &w->t->at[k], *b = &w->t->at[k + 1];
        orr_kalman_predict(&a->filtered, &a->next, n->nx, n->factor, b->shift, &b->predicted);
        if (n->nx == ORR_NX) renew(b);
        b->filtered = b->predicted;
    }
}

// Takes in the nodes of an instant; those that fail the test are rejected, and where nothing else is there
// the state stays as predicted. Innovations up to floor_m pass untested (UNTESTED: all do). Returns whether
// any node was taken. d2 collects normalised squares.
static bool take_nodes(const work *w, size_t instant, double floor_m, double *d2_sum, size_t *d2_count)
{
    const bool test = isfinite(floor_m) && w->scale2 > 0;
    orr_instant *at = &w->t->at[instant];
    bool taken = false;
    at->d2 = at->log_det = 0;
    at->count = 0;
    for (size_t i = at->first; i < at->first + at->n; i++) {
        const orr_node *node = &w->list[i];
        if (node->superseded || w->verdict[i].rejected) continue;
        orr_vec3 z = orr_track_measured(w->c, at, node);
        double length = 0, log_det = 0,
               d2 = orr_kalman_innovation2(&at->filtered, z, node->sigma_m, &length, &log_det);
        if (test && length > floor_m && d2 > THRESHOLD * THRESHOLD * w->scale2) {
            w->verdict[i].rejected = true;
            continue;
        }
        if (d2_sum != NULL && !node->bridge) {
            *d2_sum += d2;
            ++*d2_count;
        }
        if (!node->bridge) {
            at->d2 += 3 * d2;
            at->log_det += log_det;
            at->count++;
        }
        orr_kalman_update(&at->filtered, w->c->noise.nx, z, node->sigma_m);
        taken = true;
    }
    return taken;
}

static void withdraw_verdicts(const work *w, size_t g_from, size_t g_to)
{
    for (size_t g = g_from; g < g_to; g++) {
        const orr_instant *at = &w->t->at[w->g[g].instant];
        for (size_t i = at->first; i < at->first + at->n; i++) w->verdict[i] = (orr_verdict){0};
    }
}

static void reject_group(const work *w, size_t g, bool rejected)
{
    const orr_instant *at = &w->t->at[w->g[g].instant];
    for (size_t i = at->first; i < at->first + at->n; i++)
        if (!w->list[i].superseded) w->verdict[i] = (orr_verdict){.rejected = rejected};
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
    take_nodes(w, w->g[a].instant, UNTESTED, NULL, NULL);
    bool all = true;
    for (size_t g = a + 1; g < b && all; g++) {
        predict_to(w, w->g[g - 1].instant, w->g[g].instant);
        if (group_rejected(w, g)) continue;
        all = take_nodes(w, w->g[g].instant, FLOOR_M, NULL, NULL);
        if (!all) reject_group(w, g, false);
    }
    return all;
}

// A failure soon after a start may be the fault of the start: looks for one or two of the young groups
// without which the window agrees with one orbit, and rejects them.
static bool reject_young(const work *w, size_t a, size_t first_bad)
{
    size_t end = first_bad + YOUNG < w->n ? first_bad + YOUNG : w->n;
    if (end - a < YOUNG + 2) return false;                  // too few to tell
    for (size_t apart = 0; apart <= first_bad - a; apart++) // one alone first, then pairs
        for (size_t i = a; i + apart <= first_bad; i++) {
            size_t j = i + apart;
            if (apart > 0 && end - a < YOUNG + 3) continue;
            if (group_rejected(w, i) || group_rejected(w, j)) continue; // already rejected
            reject_group(w, i, true);
            reject_group(w, j, true);
            if (consistent(w, a, end)) return true;
            reject_group(w, i, false);
            reject_group(w, j, false);
        }
    return false;
}

// What was taken in after a gap, where a prediction is worth little, may be what makes the nodes after it
// look bad: looks for one of the last groups without which those before and after agree with one orbit, and
// rejects it.
static bool reject_last(const work *w, size_t a, size_t first_bad)
{
    const size_t end = first_bad + YOUNG < w->n ? first_bad + YOUNG : w->n;
    if (end < first_bad + CONFIRM) return false; // too few to tell
    for (size_t g = first_bad - 1; g > a + YOUNG && first_bad - g <= MAX_SKIPPED; g--) {
        if (group_rejected(w, g)) continue;
        reject_group(w, g, true);
        if (consistent(w, g - YOUNG - 1, end)) return true;
        reject_group(w, g, false);
    }
    return false;
}

// The joint of files, if there is one in the arc from group a on, that a failure came soon after; else a.
static size_t joint_before(const work *w, size_t a, size_t first_bad)
{
    for (size_t g = first_bad; g > a && first_bad - g <= MAX_SKIPPED; g--)
        if (w->g[g].joint) return g;
    return a;
}

// Lets the first nodes of a file be anywhere within JUMP_M of what the one before predicts, or no longer.
static void settle(const work *w, size_t joint, bool settling)
{
    for (size_t g = joint; g < w->n && g < joint + SETTLE; g++) w->g[g].settling = settling;
}

// How far apart two files' orbits are, as the filter sees it while it goes over; kept with the joint's first
// node.
static void measure_jump(const work *w, size_t g)
{
    const orr_instant *at = &w->t->at[w->g[g].instant];
    size_t joint = g, i = at->first;
    double length = 0;
    while (i + 1 < at->first + at->n && w->list[i].superseded) i++;
    orr_kalman_innovation2(&at->filtered, orr_track_measured(w->c, at, &w->list[i]), w->list[i].sigma_m,
                           &length, NULL);
    while (!w->g[joint].joint) joint--;
    orr_verdict *v = &w->verdict[w->t->at[w->g[joint].instant].first];
    v->jump_m = fmax(v->jump_m, length);
}

// Runs one arc from group a; returns the group at which the next one begins (w->n at the end). *last is the
// last group of the arc.
static size_t run_arc(const work *w, size_t a, size_t *last)
{
    size_t failed_before = a; // where it went wrong before a joint was allowed for
restart:
    while (a + 1 < w->n && group_rejected(w, a)) a++;
    start_at(w, w->g[a].instant);
    take_nodes(w, w->g[a].instant, UNTESTED, NULL, NULL);
    size_t good = 1, first_bad = 0, skipped = 0, good_after = 0;
    for (size_t g = a + 1; g < w->n; g++) {
        if (w->g[g].manoeuvre) {
            *last = g - 1;
            return g;
        }
        predict_to(w, w->g[g - 1].instant, w->g[g].instant);
        if (group_rejected(w, g)) continue; // already rejected
        if (w->g[g].settling) measure_jump(w, g);
        if (take_nodes(w, w->g[g].instant, w->g[g].settling ? JUMP_M : FLOOR_M, NULL, NULL)) {
            good++;
            if (skipped > 0 && ++good_after >= CONFIRM) skipped = 0;
            continue;
        }
        if (skipped == 0) first_bad = g;
        skipped++;
        good_after = 0;
        bool at_end = g + 1 == w->n;
        if (skipped <= MAX_SKIPPED && !(at_end && skipped >= 2)) continue;
        withdraw_verdicts(w, first_bad, w->n);
        if (good <= YOUNG && reject_young(w, a, first_bad)) goto restart;
        size_t joint = joint_before(w, a, first_bad);
        if (joint == a && reject_last(w, a, first_bad)) goto restart;
        if (joint > a) {
            bool in_vain = w->g[joint].settling;
            settle(w, joint, !in_vain);
            if (!in_vain) {
                failed_before = first_bad;
                goto restart;
            }
            first_bad = failed_before; // the files are further apart, or there is more than a joint
            withdraw_verdicts(w, joint, w->n);
        }
        *last = first_bad - 1;
        return first_bad;
    }
    *last = w->n - 1;
    return w->n;
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
        take_nodes(w, w->g[g].instant, UNTESTED, &sum, &count);
        if (g >= YOUNG && count > 0) room[n++] = sum / (double)count;
    }
    if (n < 3) return 1.0;
    double scale2 = orr_upper_median(room, n) / 0.789;
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
    uint16_t file = 0;
    for (size_t k = 0; k < t->n; k++) {
        bool usable = false, flagged = false;
        uint16_t source = file;
        for (size_t i = t->at[k].first; i < t->at[k].first + t->at[k].n; i++) {
            if (list[i].superseded) continue;
            usable = true;
            flagged = flagged || list[i].manoeuvre;
            if (!list[i].bridge) source = list[i].source;
        }
        if (!usable) continue;
        w.g[w.n] = (group){.instant = k, .manoeuvre = flagged, .joint = w.n > 0 && source != file};
        w.n++;
        file = source;
    }
    status = ORR_E_NODATA;
    if (w.n == 0) goto done;
    double scale2 = robust_scale2(&w, room);
    w.scale2 = c->options->detect ? scale2 : 0;
    for (size_t a = 0; a < w.n;) {
        size_t last = a, next = run_arc(&w, a, &last), first = a;
        while (first < last && group_rejected(&w, first)) first++;
        while (last > first && group_rejected(&w, last)) last--;
        // What a flag set apart needs no confirmation.
        bool split = (a > 0 && !w.g[a].manoeuvre) || (next < w.n && !w.g[next].manoeuvre);
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

void orr_filter_range(const orr_track_context *c, const orr_node *list, const orr_verdict *verdict,
                      orr_track *t, size_t first, size_t last)
{
    work w = {.c = c,
              .list = list,
              .t = t,
              .verdict = (orr_verdict *)verdict}; // without a scale nothing is tested or written
    start_at(&w, first);
    for (size_t k = first; k <= last; k++) {
        if (k > first) predict_to(&w, k - 1, k);
        t->at[k].count = 0;
        if (t->at[k].n > 0) take_nodes(&w, k, UNTESTED, NULL, NULL);
    }
}

orr_status orr_smooth_range(const orr_track_context *c, orr_track *t, size_t first, size_t last)
{
    t->at[last].smoothed = t->at[last].filtered;
    for (size_t k = last; k-- > first;) {
        orr_instant *a = &t->at[k], *b = &t->at[k + 1];
        orr_status s = orr_kalman_smooth(&a->filtered, &a->next, c->noise.nx, &b->predicted, &b->smoothed,
                                         &a->smoothed, b->u);
        if (s != ORR_OK) return s;
    }
    return ORR_OK;
}
