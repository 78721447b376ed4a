// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/clock/clock_align.h"

#include <math.h>
#include <stdlib.h>

#include "core/robust.h"

#define SAME_S 1e-11 // below: two files of one solution, apart by their rounding

typedef struct difference {
    orr_time t;
    double s; // `to` less the clocks
} difference;

static int by_time(const void *a, const void *b)
{
    const difference *x = a, *y = b;
    if (x->t != y->t) return x->t < y->t ? -1 : 1;
    return (x->s > y->s) - (x->s < y->s);
}

static const orr_clock_list *find(const orr_clock_table *t, orr_sat sat)
{
    for (size_t i = 0; i < t->n; i++)
        if (t->list[i].sat == sat) return &t->list[i];
    return NULL;
}

static bool has_instant(const orr_clock_list *l, size_t k, orr_time t)
{
    return k < l->n && l->node[k].t == t;
}

// All differences at shared instants of one system (0: of all), ascending in time. Two nodes at one instant are left
// out: which one is meant is not known.
static size_t collect(const orr_clock_table *to, const orr_clock_table *clocks, char system, difference *out)
{
    size_t n = 0;
    for (size_t i = 0; i < clocks->n; i++) {
        const orr_clock_list *b = &clocks->list[i], *a = find(to, b->sat);
        if (a == NULL || (system != 0 && orr_sat_system(b->sat) != system)) continue;
        for (size_t j = 0, k = 0; j < a->n && k < b->n;) {
            if (a->node[j].t < b->node[k].t) {
                j++;
            } else if (a->node[j].t > b->node[k].t) {
                k++;
            } else {
                const bool twice = has_instant(a, j + 1, a->node[j].t) ||
                                   has_instant(b, k + 1, b->node[k].t) ||
                                   (j > 0 && a->node[j - 1].t == a->node[j].t);
                if (!twice) out[n++] = (difference){b->node[k].t, a->node[j].clock_s - b->node[k].clock_s};
                j++;
                k++;
            }
        }
    }
    if (n > 0) qsort(out, n, sizeof *out, by_time);
    return n;
}

// d becomes a median an epoch; returns how many epochs, and what single satellites are off it.
static size_t medians(difference *d, size_t n, double *rms_off_s)
{
    size_t epochs = 0;
    double sum2 = 0;
    for (size_t i = 0; i < n;) {
        size_t j = i + 1;
        while (j < n && d[j].t == d[i].t) j++;
        const double median = 0.5 * (d[i + (j - i - 1) / 2].s + d[i + (j - i) / 2].s); // they are sorted
        for (size_t k = i; k < j; k++) sum2 += (d[k].s - median) * (d[k].s - median);
        d[epochs++] = (difference){d[i].t, median};
        i = j;
    }
    *rms_off_s = n > 0 ? sqrt(sum2 / (double)n) : 0;
    return epochs;
}

static double shift_at(const difference *d, size_t n, size_t *k, orr_time t)
{
    while (*k + 1 < n && d[*k + 1].t <= t) ++*k;
    if (t <= d[*k].t || *k + 1 >= n) return d[*k].s;
    const double part = orr_time_diff_s(t, d[*k].t) / orr_time_diff_s(d[*k + 1].t, d[*k].t);
    return d[*k].s + part * (d[*k + 1].s - d[*k].s);
}

static void shift(orr_clock_table *clocks, char system, const difference *d, size_t n)
{
    for (size_t i = 0; i < clocks->n; i++) {
        orr_clock_list *l = &clocks->list[i];
        if (orr_sat_system(l->sat) != system) continue;
        for (size_t j = 0, k = 0; j < l->n; j++) l->node[j].clock_s += shift_at(d, n, &k, l->node[j].t);
    }
}

static double rms(const difference *d, size_t n, double *mean)
{
    double sum = 0, sum2 = 0;
    for (size_t i = 0; i < n; i++) {
        sum += d[i].s;
        sum2 += d[i].s * d[i].s;
    }
    *mean = sum / (double)n;
    return sqrt(sum2 / (double)n);
}

static size_t count_nodes(const orr_clock_table *clocks, char system)
{
    size_t n = 0;
    for (size_t i = 0; i < clocks->n; i++)
        if (system == 0 || orr_sat_system(clocks->list[i].sat) == system) n += clocks->list[i].n;
    return n;
}

static void tell(const char *name, char system, const difference *d, size_t n, double mean_s, double off_s,
                 orr_warnings *warnings)
{
    double low = d[0].s, high = d[0].s;
    for (size_t i = 1; i < n; i++) {
        low = fmin(low, d[i].s);
        high = fmax(high, d[i].s);
    }
    orr_warnings_add(
        warnings, name, 0, 0,
        "clocks of %s are referred otherwise than those of the other files: shifted by %.3f ns on average "
        "(%.3f to %.3f over %zu epochs), the median over satellites; single satellites then differ by "
        "%.3f ns RMS",
        orr_system_name(system), 1e9 * mean_s, 1e9 * low, 1e9 * high, n, 1e9 * off_s);
}

orr_status orr_clock_align(const char *name, const orr_clock_table *to, orr_clock_table *clocks,
                           orr_warnings *warnings)
{
    difference *d = malloc((count_nodes(clocks, 0) + 1) * sizeof *d);
    difference *all = malloc((count_nodes(clocks, 0) + 1) * sizeof *all);
    if (d == NULL || all == NULL) {
        free(d);
        free(all);
        return ORR_E_MEMORY;
    }
    double off_all, mean;
    const size_t n_all = medians(all, collect(to, clocks, 0, all), &off_all);
    for (const char *system = ORR_SYSTEMS; *system != '\0' && n_all >= 2; system++) {
        if (count_nodes(clocks, *system) == 0) continue;
        double off;
        const size_t n = medians(d, collect(to, clocks, *system, d), &off);
        const difference *by = n > 0 ? d : all;
        const size_t epochs = n > 0 ? n : n_all;
        const double size = rms(by, epochs, &mean);
        if (epochs < 2 || !(size > SAME_S)) continue;
        shift(clocks, *system, by, epochs);
        if (n > 0) tell(name, *system, d, n, mean, off, warnings);
    }
    free(d);
    free(all);
    return ORR_OK;
}
