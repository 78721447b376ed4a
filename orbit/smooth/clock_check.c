// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/clock_check.h"

#include <stdlib.h>

#include "core/robust.h"
#include "orbit/smooth/solution.h"

#define LEAST_S 30e-9
#define TIMES_USUAL 30.0

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
static void measure(const orr_node_list *l, double max_gap_s, double *off)
{
    for (size_t i = 0; i < l->n_clocks; i++) {
        const orr_clock_node *c = &l->clock[i];
        off[i] = (double)NAN;
        if (i > 0 && i + 1 < l->n_clocks && are_neighbours(c - 1, c, max_gap_s) &&
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
static bool alone_is_wrong(const orr_node_list *l, size_t i, double max_gap_s, double limit)
{
    const orr_clock_node *c = &l->clock[i];
    int asked = 0;
    if (i >= 2 && are_neighbours(c - 2, c - 1, max_gap_s)) {
        if (!(fabs(off_line(c - 2, c - 1, c + 1)) <= limit)) return false;
        asked++;
    }
    if (i + 2 < l->n_clocks && are_neighbours(c + 1, c + 2, max_gap_s)) {
        if (!(fabs(off_line(c - 1, c + 1, c + 2)) <= limit)) return false;
        asked++;
    }
    return asked > 0;
}

static size_t drop_lone_values(orr_node_list *l, const double *off, double max_gap_s, double limit,
                               bool *wrong, orr_warnings *warnings)
{
    size_t n = 0, dropped = 0;
    for (size_t i = 0; i < l->n_clocks; i++)
        wrong[i] = fabs(off[i]) > limit && alone_is_wrong(l, i, max_gap_s, limit);
    for (size_t i = 0; i < l->n_clocks; i++) {
        if (!wrong[i]) {
            l->clock[n++] = l->clock[i];
            continue;
        }
        char sat[ORR_SAT_TEXT], when[ORR_TIME_TEXT];
        orr_warnings_add(warnings, NULL, 0, 0,
                         "%s: the clock of %s is off the line of its neighbours by %.3g us and is left out",
                         orr_sat_text(l->sat, sat), orr_time_text(l->clock[i].t, when), off[i] * 1e6);
        dropped++;
    }
    l->n_clocks = n;
    return dropped;
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

static void mark_jumps(orr_node_list *l, const double *off, double max_gap_s, double limit,
                       orr_warnings *warnings)
{
    for (size_t i = 0; i + 1 < l->n_clocks; i++) {
        orr_clock_node *a = &l->clock[i], *b = a + 1;
        if (!are_neighbours(a, b, max_gap_s) || !jumps_after(off, i, l->n_clocks, limit)) continue;
        if ((b->flags & ORR_EPH_CLOCK_EVENT) != 0) continue; // the file says so itself
        b->flags |= ORR_EPH_CLOCK_EVENT;
        char sat[ORR_SAT_TEXT], from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
        const double jump = isnan(off[i])       ? 2 * off[i + 1]
                            : isnan(off[i + 1]) ? -2 * off[i]
                                                : off[i + 1] - off[i];
        orr_warnings_add(warnings, NULL, 0, 0,
                         "%s: the clock jumps by about %.3g us between %s and %s; there is none between them",
                         orr_sat_text(l->sat, sat), jump * 1e6, orr_time_text(a->t, from),
                         orr_time_text(b->t, to));
    }
}

orr_status orr_clock_check(orr_node_list *l, double max_gap_s, orr_warnings *warnings)
{
    if (l->n_clocks < 3) return ORR_OK;
    double *off = malloc(l->n_clocks * sizeof *off), *room = malloc(l->n_clocks * sizeof *room);
    bool *wrong = malloc(l->n_clocks * sizeof *wrong);
    orr_status s = off != NULL && room != NULL && wrong != NULL ? ORR_OK : ORR_E_MEMORY;
    if (s == ORR_OK) {
        measure(l, max_gap_s, off);
        const double limit = limit_of(off, l->n_clocks, room);
        if (drop_lone_values(l, off, max_gap_s, limit, wrong, warnings) > 0) measure(l, max_gap_s, off);
        mark_jumps(l, off, max_gap_s, limit, warnings);
    }
    free(off);
    free(room);
    free(wrong);
    return s;
}
