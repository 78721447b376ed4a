// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/clock/clock_judge.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/robust.h"
#include "orbit/clock/clock_common.h"

#define LEAST_S 30e-9
#define TIMES_USUAL 30.0
#define LONE_PART                                                                                            \
    (1.0 /                                                                                                   \
     3.0) // of a node's miss that may be left in its neighbours'; a corner leaves 2/3, a step 1/3 and 2/3

static orr_status add(orr_clock_events *events, orr_clock_event e)
{
    if (!ORR_ARRAY_GROW(events->item, events->n)) return ORR_E_MEMORY;
    events->item[events->n++] = e;
    return ORR_OK;
}

static bool are_neighbours(const orr_clock_node *a, const orr_clock_node *b, double max_gap_s)
{
    const double dt = orr_time_diff_s(b->t, a->t);
    return dt > 0 && dt <= max_gap_s;
}

// How far b is off the line from a to c.
static double off_line(const orr_clock_node *a, const orr_clock_node *b, const orr_clock_node *c)
{
    const double part = orr_time_diff_s(b->t, a->t) / orr_time_diff_s(c->t, a->t);
    return b->clock_s - (a->clock_s + part * (c->clock_s - a->clock_s));
}

// off[i] of every node with two neighbours, NAN elsewhere.
static void measure(const orr_clock_list *l, double max_gap_s, double *off)
{
    for (size_t i = 0; i < l->n; i++) {
        const orr_clock_node *c = &l->node[i];
        off[i] = (double)NAN;
        if (i > 0 && i + 1 < l->n && are_neighbours(c - 1, c, max_gap_s) &&
            are_neighbours(c, c + 1, max_gap_s))
            off[i] = off_line(c - 1, c, c + 1);
    }
}

static double limit_of(const double *off, size_t n, double *room)
{
    size_t m = 0;
    for (size_t i = 0; i < n; i++)
        if (isfinite(off[i])) room[m++] = fabs(off[i]);
    if (m == 0) return LEAST_S;
    return fmax(LEAST_S, TIMES_USUAL * orr_upper_median(room, m));
}

// Whether all is well once node i is left out: each neighbour lies on the line of what is left around it. A
// stretch so short that neither can be asked tells nothing.
static bool alone_is_wrong(const orr_clock_list *l, size_t i, double max_gap_s, double bound)
{
    const orr_clock_node *c = &l->node[i];
    int asked = 0;
    if (i >= 2 && are_neighbours(c - 2, c - 1, max_gap_s)) {
        if (!(fabs(off_line(c - 2, c - 1, c + 1)) <= bound)) return false;
        asked++;
    }
    if (i + 2 < l->n && are_neighbours(c + 1, c + 2, max_gap_s)) {
        if (!(fabs(off_line(c - 1, c + 1, c + 2)) <= bound)) return false;
        asked++;
    }
    return asked > 0;
}

static orr_status drop_lone_values(orr_clock_list *l, const double *off, double max_gap_s, double limit,
                                   bool *wrong, size_t *dropped, orr_clock_events *events)
{
    size_t n = 0;
    orr_status s = ORR_OK;
    for (size_t i = 0; i < l->n; i++)
        wrong[i] =
            fabs(off[i]) > limit && alone_is_wrong(l, i, max_gap_s, fmin(limit, LONE_PART * fabs(off[i])));
    for (size_t i = 0; i < l->n; i++) {
        if (!wrong[i]) {
            l->node[n++] = l->node[i];
            continue;
        }
        const orr_time t = l->node[i].t;
        if (s == ORR_OK) s = add(events, (orr_clock_event){ORR_CLOCK_EVENT_WRONG, l->sat, t, t, off[i], ""});
        ++*dropped;
    }
    l->n = n;
    return s;
}

// A jump of J between two nodes puts the first off by -J/2 and the second by J/2; a change of rate puts only
// one node off.
static bool jumps_inside(double off_first, double off_second, double limit)
{
    return fabs(off_first) > limit && fabs(off_second) > limit && (off_first > 0) != (off_second > 0);
}

// Between nodes i and i + 1. At the ends of a stretch the outer node is off nothing; what puts the inner one
// off, and is no jump on its other side, may have happened there, and nothing is interpolated.
static bool jumps_after(const double *off, size_t i, size_t n, double limit)
{
    if (isnan(off[i]) && isnan(off[i + 1])) return false;
    if (isnan(off[i]))
        return fabs(off[i + 1]) > limit && !(i + 2 < n && jumps_inside(off[i + 1], off[i + 2], limit));
    if (isnan(off[i + 1])) return fabs(off[i]) > limit && !(i > 0 && jumps_inside(off[i - 1], off[i], limit));
    return jumps_inside(off[i], off[i + 1], limit);
}

static orr_status mark_jumps(orr_clock_list *l, const double *off, double max_gap_s, double limit,
                             orr_clock_events *events)
{
    orr_status s = ORR_OK;
    for (size_t i = 0; i + 1 < l->n && s == ORR_OK; i++) {
        orr_clock_node *a = &l->node[i], *b = a + 1;
        if (!are_neighbours(a, b, max_gap_s) || !jumps_after(off, i, l->n, limit)) continue;
        if ((b->flags & ORR_EPH_CLOCK_EVENT) != 0) continue; // the file says so itself
        b->flags |= ORR_EPH_CLOCK_EVENT;
        const double jump = isnan(off[i])       ? 2 * off[i + 1]
                            : isnan(off[i + 1]) ? -2 * off[i]
                                                : off[i + 1] - off[i];
        s = add(events, (orr_clock_event){ORR_CLOCK_EVENT_JUMP, l->sat, a->t, b->t, jump, ""});
    }
    return s;
}

static orr_status tell_flags(const orr_clock_list *l, orr_clock_events *events)
{
    orr_status s = ORR_OK;
    for (size_t i = 0; i < l->n && s == ORR_OK; i++)
        if ((l->node[i].flags & ORR_EPH_CLOCK_EVENT) != 0)
            s = add(events, (orr_clock_event){ORR_CLOCK_EVENT_FLAG, l->sat, l->node[i > 0 ? i - 1 : i].t,
                                              l->node[i].t, 0, ""});
    return s;
}

static orr_status judge_alone(orr_clock_list *l, double max_gap_s, orr_clock_events *events)
{
    double *off = malloc(l->n * sizeof *off), *room = malloc(l->n * sizeof *room);
    bool *wrong = malloc(l->n * sizeof *wrong);
    orr_status s = off != NULL && room != NULL && wrong != NULL ? ORR_OK : ORR_E_MEMORY;
    if (s == ORR_OK) {
        measure(l, max_gap_s, off);
        const double limit = limit_of(off, l->n, room);
        size_t dropped = 0;
        s = drop_lone_values(l, off, max_gap_s, limit, wrong, &dropped, events);
        if (dropped > 0) measure(l, max_gap_s, off);
        if (s == ORR_OK) s = mark_jumps(l, off, max_gap_s, limit, events);
    }
    free(off);
    free(room);
    free(wrong);
    return s;
}

// Judged on a copy without the common part, so that values which stay remain the file's to the last bit.
static orr_status judge_satellite(const orr_clock_common *common, double max_gap_s, orr_clock_list *l,
                                  orr_clock_events *events)
{
    if (l->n < 3) return ORR_OK;
    orr_clock_list alone = {.sat = l->sat, .n = l->n, .node = malloc(l->n * sizeof *alone.node)};
    if (alone.node == NULL) return ORR_E_MEMORY;
    memcpy(alone.node, l->node, l->n * sizeof *alone.node);
    orr_clock_common_apply(common, -1, &alone);
    const orr_status s = judge_alone(&alone, max_gap_s, events);
    size_t n = 0;
    for (size_t i = 0; i < l->n && n < alone.n; i++) {
        if (l->node[i].t != alone.node[n].t || l->node[i].source != alone.node[n].source) continue;
        l->node[n] = l->node[i];
        l->node[n].flags = alone.node[n].flags;
        n++;
    }
    l->n = n;
    free(alone.node);
    return s;
}

// The same in another system is the same event.
static orr_status add_reference(orr_clock_events *events, orr_clock_event e)
{
    for (size_t i = 0; i < events->n; i++) {
        orr_clock_event *old = &events->item[i];
        if (old->kind != e.kind || old->t0 != e.t0 || old->t1 != e.t1) continue;
        if (fabs(old->value_s - e.value_s) > 0.1 * fabs(e.value_s)) continue;
        old->systems[strlen(old->systems)] = e.systems[0]; // room for one of each system, and zeroed behind
        return ORR_OK;
    }
    return add(events, e);
}

// Steps that follow each other with one sign are one ramp; an epoch that nobody tells of does not end it.
static orr_status tell_reference(const orr_clock_common *c, orr_clock_events *events)
{
    orr_status s = ORR_OK;
    for (size_t e = 1; e < c->n && s == ORR_OK;) {
        if (c->epoch[e].step_s == 0) {
            e++;
            continue;
        }
        const size_t first = e;
        size_t last = e;
        double sum = 0;
        for (; e < c->n; e++) {
            const double step_s = c->epoch[e].step_s;
            if (step_s == 0 && c->epoch[e].n == 0) continue;
            if (step_s == 0 || (step_s > 0) != (c->epoch[first].step_s > 0)) break;
            sum += step_s;
            last = e;
        }
        e = last + 1;
        const orr_clock_event event = {ORR_CLOCK_EVENT_REFERENCE, ORR_SAT_NONE, c->epoch[first - 1].t,
                                       c->epoch[last].t,          sum,          {c->system}};
        s = add_reference(events, event);
    }
    return s;
}

static void take_away(const orr_clock_common *c, orr_clock_table *clocks)
{
    for (size_t i = 0; i < clocks->n; i++)
        if (orr_sat_system(clocks->list[i].sat) == c->system) orr_clock_common_apply(c, -1, &clocks->list[i]);
}

static orr_status judge_system(char system, double max_gap_s, bool detect, bool remove_reference,
                               orr_clock_table *clocks, orr_clock_events *events)
{
    orr_clock_common common, steps;
    orr_status s = orr_clock_common_find(clocks->list, clocks->n, system, &common);
    if (s != ORR_OK) return s;
    steps = common;
    steps.epoch = malloc((common.n + 1) * sizeof *steps.epoch);
    if (steps.epoch == NULL) s = ORR_E_MEMORY;
    if (s == ORR_OK && common.n > 0) memcpy(steps.epoch, common.epoch, common.n * sizeof *steps.epoch);
    for (size_t i = 0; i < clocks->n && s == ORR_OK && detect; i++)
        if (orr_sat_system(clocks->list[i].sat) == system)
            s = judge_satellite(&common, max_gap_s, &clocks->list[i], events);
    if (s == ORR_OK) s = orr_clock_common_keep_steps(&steps);
    if (s == ORR_OK) s = tell_reference(&steps, events);
    if (s == ORR_OK && remove_reference) take_away(&steps, clocks);
    orr_clock_common_free(&common);
    orr_clock_common_free(&steps);
    return s;
}

static int by_begin(const void *a, const void *b)
{
    const orr_clock_event *x = a, *y = b;
    if (x->t0 != y->t0) return x->t0 < y->t0 ? -1 : 1;
    return (int)x->sat - (int)y->sat;
}

orr_status orr_clock_judge(double max_gap_s, bool detect, bool remove_reference, orr_clock_table *clocks,
                           orr_clock_events *events)
{
    *events = (orr_clock_events){0};
    orr_status s = ORR_OK;
    for (size_t i = 0; i < clocks->n && s == ORR_OK; i++) s = tell_flags(&clocks->list[i], events);
    for (const char *system = ORR_SYSTEMS; *system != '\0' && s == ORR_OK && (detect || remove_reference);
         system++)
        s = judge_system(*system, max_gap_s, detect, remove_reference, clocks, events);
    if (s == ORR_OK && events->n > 1) qsort(events->item, events->n, sizeof *events->item, by_begin);
    return s;
}
