// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/clock/clock_common.h"

#include <math.h>
#include <stdlib.h>

#include "core/robust.h"

#define STEP_LEAST_S 5e-9
#define STEP_TIMES_USUAL 10.0
#define RECENT_S 3600.0 // a satellite's last node further back tells nothing of an epoch

void orr_clock_common_free(orr_clock_common *c)
{
    free(c->epoch);
    *c = (orr_clock_common){0};
}

static int by_epoch(const void *a, const void *b)
{
    const orr_clock_epoch *x = a, *y = b;
    if (x->t != y->t) return x->t < y->t ? -1 : 1;
    return (int)x->source - (int)y->source;
}

static orr_status collect_epochs(const orr_clock_list *list, size_t n_lists, orr_clock_common *out)
{
    size_t room = 1, n = 0;
    for (size_t i = 0; i < n_lists; i++)
        if (orr_sat_system(list[i].sat) == out->system) room += list[i].n;
    out->epoch = calloc(room, sizeof *out->epoch);
    if (out->epoch == NULL) return ORR_E_MEMORY;
    for (size_t i = 0; i < n_lists; i++)
        for (size_t k = 0; k < list[i].n && orr_sat_system(list[i].sat) == out->system; k++)
            out->epoch[n++] = (orr_clock_epoch){.t = list[i].node[k].t, .source = list[i].node[k].source};
    qsort(out->epoch, n, sizeof *out->epoch, by_epoch);
    for (size_t i = 0; i < n; i++)
        if (out->n == 0 || by_epoch(&out->epoch[out->n - 1], &out->epoch[i]) != 0)
            out->epoch[out->n++] = out->epoch[i];
    return ORR_OK;
}

// The usual rate of one clock: the median over neighbouring nodes, which no step and no outlier moves.
static double usual_rate(const orr_clock_list *l, double *room)
{
    size_t n = 0;
    for (size_t k = 1; k < l->n; k++) {
        const double dt = orr_time_diff_s(l->node[k].t, l->node[k - 1].t);
        if (dt > 0) room[n++] = (l->node[k].clock_s - l->node[k - 1].clock_s) / dt;
    }
    return n > 0 ? orr_upper_median(room, n) : (double)NAN;
}

static double shared_part(double *step, size_t n)
{
    if (n < 2) return 0;
    const double low = orr_order_statistic(step, n, (n - 1) / 2), high = orr_order_statistic(step, n, n / 2);
    if (n > 2) return 0.5 * (low + high);
    if ((low > 0) != (high > 0)) return 0;
    return fabs(low) < fabs(high) ? low : high;
}

static bool is_at(const orr_clock_node *c, const orr_clock_epoch *e)
{
    return c->t == e->t && c->source == e->source;
}

// Where one list has been read up to.
typedef struct place {
    size_t next, epoch; // its first node that was not looked at yet, and the epoch of the one before
} place;

// Steps from epoch to epoch. A satellite without a node at the epoch before tells by its last one, if that is not long
// ago, what is left beyond the steps between: a node that one satellite alone has, where its files meet, must not hide
// what all others do.
static void measure_steps(const orr_clock_list *list, size_t n_lists, const double *rate, place *at,
                          double *step, orr_clock_common *out)
{
    double sum = 0; // of all steps so far
    for (size_t e = 0; e < out->n; e++) {
        orr_clock_epoch *now = &out->epoch[e];
        size_t n = 0;
        for (size_t i = 0; i < n_lists; i++) {
            const orr_clock_list *l = &list[i];
            if (at[i].next >= l->n || isnan(rate[i]) || !is_at(&l->node[at[i].next], now)) continue;
            const orr_clock_node *c = &l->node[at[i].next++];
            const size_t before = at[i].epoch;
            at[i].epoch = e;
            if (c == l->node || orr_time_diff_s(c->t, c[-1].t) > RECENT_S) continue;
            const double between = sum - out->epoch[before].value_s;
            step[n++] = c->clock_s - c[-1].clock_s - rate[i] * orr_time_diff_s(c->t, c[-1].t) - between;
        }
        now->n = n < 2 ? 0 : n;
        now->step_s = shared_part(step, n);
        sum += now->step_s;
        now->value_s = sum; // for the time being
    }
}

// value_s from step_s, 0 at the last epoch.
static void add_up(orr_clock_common *c)
{
    double sum = 0;
    for (size_t e = c->n; e-- > 0;) {
        c->epoch[e].value_s = sum;
        sum -= c->epoch[e].step_s;
    }
}

orr_status orr_clock_common_keep_steps(orr_clock_common *c)
{
    double *room = malloc((c->n + 1) * sizeof *room);
    if (room == NULL) return ORR_E_MEMORY;
    size_t m = 0;
    for (size_t e = 0; e < c->n; e++)
        if (c->epoch[e].n > 1) room[m++] = fabs(c->epoch[e].step_s);
    const double usual = m > 0 ? orr_upper_median(room, m) : 0,
                 least = fmax(STEP_LEAST_S, STEP_TIMES_USUAL * usual);
    // Satellites' usual rates share an error, which a long ramp makes; it stands in the quiet epochs too.
    m = 0;
    for (size_t e = 0; e < c->n; e++)
        if (c->epoch[e].n > 1 && !(fabs(c->epoch[e].step_s) > least)) room[m++] = c->epoch[e].step_s;
    const double quiet = m > 0 ? orr_upper_median(room, m) : 0;
    free(room);
    for (size_t e = 0; e < c->n; e++)
        c->epoch[e].step_s = fabs(c->epoch[e].step_s) > least ? c->epoch[e].step_s - quiet : 0;
    add_up(c);
    return ORR_OK;
}

orr_status orr_clock_common_find(const orr_clock_list *list, size_t n_lists, char system,
                                 orr_clock_common *out)
{
    *out = (orr_clock_common){.system = system};
    orr_status s = collect_epochs(list, n_lists, out);
    size_t longest = n_lists;
    for (size_t i = 0; i < n_lists; i++) longest = list[i].n > longest ? list[i].n : longest;
    double *rate = malloc((n_lists + 1) * sizeof *rate), *room = malloc((longest + 1) * sizeof *room);
    place *at = calloc(n_lists + 1, sizeof *at);
    if (rate == NULL || room == NULL || at == NULL) s = ORR_E_MEMORY;
    if (s == ORR_OK) {
        for (size_t i = 0; i < n_lists; i++)
            rate[i] = orr_sat_system(list[i].sat) == system ? usual_rate(&list[i], room) : (double)NAN;
        measure_steps(list, n_lists, rate, at, room, out);
        add_up(out);
    }
    free(rate);
    free(room);
    free(at);
    if (s != ORR_OK) orr_clock_common_free(out);
    return s;
}

void orr_clock_common_apply(const orr_clock_common *c, double sign, orr_clock_list *list)
{
    for (size_t k = 0, e = 0; k < list->n && e < c->n;) {
        const orr_clock_epoch key = {.t = list->node[k].t, .source = list->node[k].source};
        if (by_epoch(&c->epoch[e], &key) < 0) {
            e++;
        } else {
            if (by_epoch(&c->epoch[e], &key) == 0) list->node[k].clock_s += sign * c->epoch[e].value_s;
            k++;
        }
    }
}
