// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/dynamics/epoch_time.h"

#include <math.h>
#include <stdlib.h>

#include "core/array.h"
#include "core/linalg.h"
#include "core/robust.h"

#define LEAST_SATELLITES 8
#define LEAST_DIFFERENCES 12
#define LONGEST_STEP_NS (3600 * ORR_NS_PER_S)
#define TELLING 2.5        // squares over what chance makes of them
#define BEFORE_S 0.25e-6   // sigma of an epoch's time before anything is known
#define LEAST_SIGMA_S 1e-9 // of a second difference
#define OF_SQUARES 0.4549  // the median of a normal square
#define MEDIAN_LOSS 1.2533 // sigma of a median over that of a mean

enum { ORDER = 2 };
static const double binomial[ORDER + 1] = {1, -2, 1};

static int order(uint16_t source_a, orr_time a, uint16_t source_b, orr_time b)
{
    return source_a != source_b ? (source_a > source_b) - (source_a < source_b) : (a > b) - (a < b);
}
static int by_satellite(const void *a, const void *b)
{
    const orr_time_reading *x = a, *y = b;
    if (x->source == y->source && x->sat != y->sat) return x->sat < y->sat ? -1 : 1;
    return order(x->source, x->t, y->source, y->t);
}
static int by_reading(const void *a, const void *b)
{
    const orr_time_reading *x = a, *y = b;
    return order(x->source, x->t, y->source, y->t);
}
static int by_time(const void *a, const void *b)
{
    const orr_epoch_time *x = a, *y = b;
    return order(x->source, x->t, y->source, y->t);
}

// One file: its epochs, and what all satellites tell of the difference that begins at each.
typedef struct work {
    size_t n, told;
    orr_time *t;
    double *difference_s, *sigma_s; // of epoch i to i + ORDER; sigma 0: not told
    double *room;
} work;

// The second differences of a satellite's readings r[0..n) at neighbouring epochs, in the place of the readings; how many.
static size_t take_differences(orr_time_reading *r, size_t n)
{
    size_t m = 0;
    for (size_t i = 0; i + ORDER < n; i++) {
        const int64_t step = r[i + 1].t - r[i].t;
        bool even = step > 0 && step <= LONGEST_STEP_NS;
        double sum = 0;
        for (size_t k = 0; k <= ORDER; k++) {
            even = even && r[i + k].t - r[i].t == (int64_t)k * step;
            sum += binomial[k] * r[i + k].late_s;
        }
        if (!even) continue;
        r[m] = r[i];
        r[m++].late_s = sum;
    }
    return m;
}

// Median and its sigma by the scatter.
static void tell(work *w, size_t at, const orr_time_reading *r, size_t n)
{
    for (size_t i = 0; i < n; i++) w->room[i] = r[i].late_s;
    const double middle = orr_median(w->room, n);
    for (size_t i = 0; i < n; i++) w->room[i] = fabs(r[i].late_s - middle);
    w->difference_s[at] = middle;
    w->sigma_s[at] =
        fmax(LEAST_SIGMA_S, MEDIAN_LOSS * ORR_SIGMA_PER_MAD * orr_median(w->room, n) / sqrt((double)n));
    w->told++;
}

// Whether the differences are more than chance.
static bool off(work *w)
{
    size_t n = 0;
    if (w->told < LEAST_DIFFERENCES) return false;
    for (size_t i = 0; i < w->n; i++)
        if (w->sigma_s[i] > 0) w->room[n++] = pow(w->difference_s[i] / w->sigma_s[i], 2);
    return orr_median(w->room, n) / OF_SQUARES > TELLING;
}

// The times that have these differences. room: [n][ORDER + 2].
static orr_status solve(work *w, double *late_s)
{
    double *band = w->room;
    for (size_t i = 0; i < w->n; i++) {
        late_s[i] = 0;
        for (size_t d = 0; d <= ORDER; d++)
            band[i * (ORDER + 1) + d] = d == 0 ? 1 / (BEFORE_S * BEFORE_S) : 0;
    }
    for (size_t i = 0; i + ORDER < w->n; i++) {
        if (!(w->sigma_s[i] > 0)) continue;
        const double weight = 1 / (w->sigma_s[i] * w->sigma_s[i]);
        for (size_t k = 0; k <= ORDER; k++) {
            late_s[i + k] += weight * binomial[k] * w->difference_s[i];
            for (size_t m = 0; m <= k; m++)
                band[(i + m) * (ORDER + 1) + k - m] += weight * binomial[k] * binomial[m];
        }
    }
    return orr_band_solve(band, w->n, ORDER, late_s, 1);
}

// Epochs of a file, whose readings r[0..n) are ascending by satellite and time.
static orr_status of_file(orr_time_reading *r, size_t n, work *w, double *late_s, orr_epoch_times *out)
{
    size_t m = 0;
    w->n = w->told = 0;
    for (size_t i = 0; i < n; i++) w->t[w->n++] = r[i].t;
    qsort(w->t, w->n, sizeof *w->t, orr_time_order);
    for (size_t i = 0; i < w->n; i++)
        if (i == 0 || w->t[i] != w->t[m - 1]) w->t[m++] = w->t[i];
    w->n = m;
    m = 0;
    for (size_t i = 0, j; i < n; i = j) {
        for (j = i + 1; j < n && r[j].sat == r[i].sat; j++) continue;
        const size_t found = take_differences(&r[i], j - i);
        for (size_t k = 0; k < found; k++) r[m++] = r[i + k];
    }
    qsort(r, m, sizeof *r, by_reading);
    for (size_t i = 0; i < w->n; i++) w->sigma_s[i] = 0;
    for (size_t i = 0, j; i < m; i = j) {
        for (j = i + 1; j < m && r[j].t == r[i].t; j++) continue;
        const orr_time *at = bsearch(&r[i].t, w->t, w->n, sizeof *w->t, orr_time_order);
        if (at != NULL && j - i >= LEAST_SATELLITES) tell(w, (size_t)(at - w->t), &r[i], j - i);
    }
    if (!off(w)) return ORR_OK;
    orr_status s = solve(w, late_s);
    for (size_t i = 0; i < w->n && s == ORR_OK; i++) {
        if (!ORR_ARRAY_GROW(out->item, out->n)) return ORR_E_MEMORY;
        out->item[out->n++] = (orr_epoch_time){w->t[i], r[0].source, late_s[i]};
    }
    return s;
}

orr_status orr_epoch_times_find(orr_time_reading *reading, size_t n, orr_epoch_times *out)
{
    *out = (orr_epoch_times){0};
    if (n == 0) return ORR_OK;
    qsort(reading, n, sizeof *reading, by_satellite);
    work w = {.t = malloc(n * sizeof *w.t),
              .difference_s = malloc(n * sizeof *w.difference_s),
              .sigma_s = malloc(n * sizeof *w.sigma_s),
              .room = malloc((ORDER + 2) * n * sizeof *w.room)};
    double *late_s = malloc(n * sizeof *late_s);
    orr_status s =
        w.t != NULL && w.difference_s != NULL && w.sigma_s != NULL && w.room != NULL && late_s != NULL
            ? ORR_OK
            : ORR_E_MEMORY;
    for (size_t i = 0, j; i < n && s == ORR_OK; i = j) {
        for (j = i + 1; j < n && reading[j].source == reading[i].source; j++) continue;
        s = of_file(&reading[i], j - i, &w, late_s, out);
    }
    free(w.t);
    free(w.difference_s);
    free(w.sigma_s);
    free(w.room);
    free(late_s);
    if (s != ORR_OK) orr_epoch_times_free(out);
    return s;
}

double orr_epoch_late_s(const orr_epoch_times *times, uint16_t source, orr_time t)
{
    const orr_epoch_time key = {t, source, 0};
    const orr_epoch_time *at =
        times->n > 0 ? bsearch(&key, times->item, times->n, sizeof key, by_time) : NULL;
    return at != NULL ? at->late_s : 0;
}

orr_epoch_spread orr_epoch_times_spread(const orr_epoch_times *times, uint16_t source)
{
    orr_epoch_spread f = {0};
    for (size_t i = 0; i < times->n; i++) {
        const double late_s = times->item[i].late_s;
        if (times->item[i].source != source) continue;
        f.epochs++;
        f.rms_s += late_s * late_s;
        f.most_s = fmax(f.most_s, fabs(late_s));
    }
    if (f.epochs > 0) f.rms_s = sqrt(f.rms_s / (double)f.epochs);
    return f;
}

void orr_epoch_times_free(orr_epoch_times *times)
{
    free(times->item);
    *times = (orr_epoch_times){0};
}
