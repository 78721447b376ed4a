// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/clock/clock_sources.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "orbit/clock/clock_align.h"

void orr_clock_table_free(orr_clock_table *t)
{
    for (size_t i = 0; i < t->n; i++) free(t->list[i].node);
    free(t->list);
    *t = (orr_clock_table){0};
}

// A run of nodes none of which is further than max_gap_s from the next: its first and last index.
static size_t run_end(const orr_clock_list *l, size_t first, double max_gap_s)
{
    size_t last = first;
    while (last + 1 < l->n && orr_time_diff_s(l->node[last + 1].t, l->node[last].t) <= max_gap_s) last++;
    return last;
}

typedef enum side { OUTSIDE, LEFT_OF_IT, RIGHT_OF_IT, INSIDE } side;

// Where node k of b lies beside the stretch of a from t0 to t1: at an end it stays only where b goes on outward.
static side side_of(const orr_clock_list *b, size_t k, orr_time t0, orr_time t1, double max_gap_s)
{
    const orr_time t = b->node[k].t;
    if (t < t0 || t > t1) return OUTSIDE;
    const bool from_left = k > 0 && orr_time_diff_s(t, b->node[k - 1].t) <= max_gap_s,
               to_right = k + 1 < b->n && orr_time_diff_s(b->node[k + 1].t, t) <= max_gap_s;
    if (t == t0 && from_left) return LEFT_OF_IT;
    if (t == t1 && to_right) return RIGHT_OF_IT;
    return INSIDE;
}

// What b has outside the stretches of a, and a; ascending. A lone node of a is no stretch: b may go on through it.
static orr_status merge(const orr_clock_list *a, const orr_clock_list *b, double max_gap_s,
                        orr_clock_list *out)
{
    *out = (orr_clock_list){.sat = a->n > 0 ? a->sat : b->sat};
    out->node = malloc((a->n + b->n + 1) * sizeof *out->node);
    if (out->node == NULL) return ORR_E_MEMORY;
    size_t k = 0;
    for (size_t first = 0; first < a->n;) {
        const size_t last = run_end(a, first, max_gap_s);
        const orr_time t0 = a->node[first].t, t1 = a->node[last].t;
        for (; k < b->n && b->node[k].t < t0; k++) out->node[out->n++] = b->node[k];
        const bool lone = first == last;
        if (lone && k < b->n && b->node[k].t == t0) {
            first = last + 1;
            continue;
        }
        if (!lone && k < b->n && side_of(b, k, t0, t1, max_gap_s) == LEFT_OF_IT)
            out->node[out->n++] = b->node[k++];
        for (size_t i = first; i <= last; i++) out->node[out->n++] = a->node[i];
        for (; k < b->n && side_of(b, k, t0, t1, max_gap_s) == INSIDE; k++) continue;
        first = last + 1;
    }
    for (; k < b->n; k++) out->node[out->n++] = b->node[k];
    return ORR_OK;
}

// The second of two nodes at one instant is told from the first.
static void number_sides(orr_clock_list *l)
{
    for (size_t i = 0; i < l->n; i++) l->node[i].source = i > 0 && l->node[i - 1].t == l->node[i].t ? 1 : 0;
}

// taken becomes itself and what b has outside its stretches.
static orr_status take(orr_clock_table *taken, const orr_clock_table *b, double max_gap_s)
{
    orr_clock_table out = {.list = calloc(taken->n + b->n + 1, sizeof *out.list)};
    orr_status s = out.list != NULL ? ORR_OK : ORR_E_MEMORY;
    static const orr_clock_list none = {0};
    for (size_t i = 0, k = 0; s == ORR_OK && (i < taken->n || k < b->n);) {
        const bool mine = k >= b->n || (i < taken->n && taken->list[i].sat <= b->list[k].sat);
        const bool theirs = i >= taken->n || (k < b->n && b->list[k].sat <= taken->list[i].sat);
        s = merge(mine ? &taken->list[i] : &none, theirs ? &b->list[k] : &none, max_gap_s, &out.list[out.n]);
        if (s == ORR_OK) number_sides(&out.list[out.n]);
        out.n++;
        i += mine;
        k += theirs;
    }
    if (s != ORR_OK) {
        orr_clock_table_free(&out);
        return s;
    }
    orr_clock_table_free(taken);
    *taken = out;
    return ORR_OK;
}

// The nodes of a source that were observed, or those that were predicted, aligned to what is taken.
static orr_status pick(const orr_clock_source *s, bool predicted, const orr_clock_table *taken, bool tell,
                       orr_clock_table *out, orr_warnings *warnings)
{
    *out = (orr_clock_table){.list = calloc(s->table.n + 1, sizeof *out->list)};
    if (out->list == NULL) return ORR_E_MEMORY;
    for (size_t i = 0; i < s->table.n; i++) {
        const orr_clock_list *l = &s->table.list[i];
        orr_clock_list *o = &out->list[out->n++];
        o->sat = l->sat;
        o->node = malloc((l->n + 1) * sizeof *o->node);
        if (o->node == NULL) return ORR_E_MEMORY;
        o->n = l->n;
        if (l->n > 0) memcpy(o->node, l->node, l->n * sizeof *o->node);
    }
    const orr_status status = orr_clock_align(s->name, taken, out, tell ? warnings : NULL);
    for (size_t i = 0; i < out->n; i++) {
        orr_clock_list *l = &out->list[i];
        size_t n = 0;
        for (size_t k = 0; k < l->n; k++)
            if (((l->node[k].flags & ORR_EPH_PREDICTED) != 0) == predicted) l->node[n++] = l->node[k];
        l->n = n;
    }
    return status;
}

static int by_name_and_step(const orr_clock_source *a, const orr_clock_source *b)
{
    if (a->step_s != b->step_s) return a->step_s < b->step_s ? -1 : 1;
    return strcmp(a->name, b->name);
}

typedef struct place {
    const orr_clock_source *source;
} place;

static int observed_first(const void *x, const void *y)
{
    const orr_clock_source *a = ((const place *)x)->source, *b = ((const place *)y)->source;
    if (a->first != b->first) return a->first > b->first ? -1 : 1;
    if (a->observed != b->observed) return a->observed > b->observed ? -1 : 1;
    return by_name_and_step(a, b);
}

static int predicted_first(const void *x, const void *y)
{
    const orr_clock_source *a = ((const place *)x)->source, *b = ((const place *)y)->source;
    if (a->observed != b->observed) return a->observed > b->observed ? -1 : 1;
    if (a->first != b->first) return a->first > b->first ? -1 : 1;
    return by_name_and_step(a, b);
}

orr_status orr_clock_sources_join(const orr_clock_source *source, size_t n, double max_gap_s,
                                  orr_clock_table *out, orr_warnings *warnings)
{
    *out = (orr_clock_table){0};
    place *order = malloc((n + 1) * sizeof *order);
    if (order == NULL) return ORR_E_MEMORY;
    for (size_t i = 0; i < n; i++) order[i] = (place){&source[i]};
    orr_status s = ORR_OK;
    for (int predicted = 0; predicted < 2; predicted++) {
        qsort(order, n, sizeof *order, predicted ? predicted_first : observed_first);
        for (size_t i = 0; i < n && s == ORR_OK; i++) {
            orr_clock_table part;
            s = pick(order[i].source, predicted, out, !predicted, &part, warnings);
            if (s == ORR_OK) s = take(out, &part, max_gap_s);
            orr_clock_table_free(&part);
        }
    }
    free(order);
    if (s != ORR_OK) orr_clock_table_free(out);
    return s;
}

orr_status orr_clock_table_replace(const char *name, double max_gap_s, orr_clock_table *better,
                                   orr_clock_table *base, orr_warnings *warnings)
{
    orr_status s = orr_clock_align(name, base, better, warnings);
    orr_clock_table both = {0};
    if (s == ORR_OK) s = take(&both, better, max_gap_s);
    if (s == ORR_OK) s = take(&both, base, max_gap_s);
    if (s != ORR_OK) {
        orr_clock_table_free(&both);
        return s;
    }
    orr_clock_table_free(base);
    *base = both;
    return ORR_OK;
}
