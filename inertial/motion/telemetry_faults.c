// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/motion/telemetry_faults.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/robust.h"
#include "inertial/motion/uniform_spline.h"

static double distance(const telemetry_series *s, size_t a, size_t b)
{
    double sum = 0.0;
    for (int c = 0; c < s->dim; c++) {
        double d = s->value[a * (size_t)s->dim + (size_t)c] - s->value[b * (size_t)s->dim + (size_t)c];
        sum += d * d;
    }
    return sqrt(sum);
}

// Good rows again from `fault`.
static void collect(telemetry_series *s)
{
    size_t n = 0;
    for (size_t k = 0; k < s->n_good; k++)
        if (s->fault[s->order[k]] == ORR_FAULTS) s->order[n++] = s->order[k];
    s->n_good = n;
}

orr_status telemetry_mark_clock(telemetry_series *s, orr_diag *diag)
{
    // Longest strictly ascending subsequence by patience sorting: tail[k] ends the best one of length k + 1.
    size_t *tail = malloc((s->n + 1) * sizeof *tail), *before = malloc((s->n + 1) * sizeof *before),
           length = 0;
    double *step = malloc((s->n + 1) * sizeof *step);
    if (tail == NULL || before == NULL || step == NULL) {
        free(tail);
        free(before);
        free(step);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu rows of telemetry", s->n);
    }
    for (size_t i = 0; i < s->n; i++) {
        if (s->fault[i] != ORR_FAULTS) continue;
        size_t lo = 0, hi = length;
        while (lo < hi) {
            size_t mid = (lo + hi) / 2;
            if (s->t_s[tail[mid]] < s->t_s[i])
                lo = mid + 1;
            else
                hi = mid;
        }
        // The first of equal times stays; a later row may replace a later time only.
        if (lo < length && s->t_s[tail[lo]] == s->t_s[i]) {
            s->fault[i] = distance(s, i, tail[lo]) == 0.0 ? ORR_FAULT_REPEATED : ORR_FAULT_CLOCK;
            continue;
        }
        before[i] = lo > 0 ? tail[lo - 1] : i;
        tail[lo] = i;
        if (lo == length) length++;
    }
    for (size_t i = 0; i < s->n; i++)
        if (s->fault[i] == ORR_FAULTS) s->fault[i] = ORR_FAULT_CLOCK;
    s->n_good = length;
    if (length > 0) {
        size_t i = tail[length - 1];
        for (size_t k = length; k-- > 0; i = before[i]) {
            s->order[k] = i;
            s->fault[i] = ORR_FAULTS;
        }
        for (size_t k = 0; k + 1 < length; k++) step[k] = s->t_s[s->order[k + 1]] - s->t_s[s->order[k]];
        s->interval_s = length > 1 ? orr_upper_median(step, length - 1) : 0.0;
    }
    free(tail);
    free(before);
    free(step);
    return ORR_OK;
}

void telemetry_mark_frozen(telemetry_series *s)
{
    for (size_t k = 0; k + 1 < s->n_good;) {
        size_t e = k;
        while (e + 1 < s->n_good && distance(s, s->order[k], s->order[e + 1]) == 0.0) e++;
        double stood_s = s->t_s[s->order[e]] - s->t_s[s->order[k]];
        if (e >= k + 3 && stood_s >= 1.0 && e + 1 < s->n_good) {
            // A body at rest starts slowly; one whose record stood still leaps by the way of all that time at
            // once, and the speed of that leap over the whole time is the speed it goes on with.
            double leap = distance(s, s->order[e + 1], s->order[k]);
            double step_s = s->t_s[s->order[e + 1]] - s->t_s[s->order[e]];
            size_t after = e + 1;
            while (after + 1 < s->n_good && s->t_s[s->order[after]] - s->t_s[s->order[e + 1]] < stood_s)
                after++;
            double went_s = s->t_s[s->order[after]] - s->t_s[s->order[e + 1]];
            double speed = went_s > 0.0 ? distance(s, s->order[after], s->order[e + 1]) / went_s : 0.0;
            double floor = s->attitude ? 0.05 : 5.0;
            if (leap > floor && leap / step_s > 3.0 * speed)
                for (size_t i = k + 1; i <= e; i++) s->fault[s->order[i]] = ORR_FAULT_FROZEN;
        }
        k = e + 1;
    }
    collect(s);
}

static orr_status add_gap(orr_fit_report *r, bool attitude, double from_s, double to_s, orr_diag *diag)
{
    if (!ORR_ARRAY_GROW(r->gap, r->n_gaps))
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the gaps of a log");
    r->gap[r->n_gaps++] = (orr_telemetry_gap){attitude, from_s, to_s};
    return ORR_OK;
}

orr_status telemetry_part(telemetry_series *s, double max_gap_s, orr_fit_report *report, orr_diag *diag)
{
    size_t best_from = 0, best_to = 0, from = 0;
    for (size_t k = 0; k < s->n_good; k++) {
        double here = s->t_s[s->order[k]], next = k + 1 < s->n_good ? s->t_s[s->order[k + 1]] : HUGE_VAL;
        if (k + 1 < s->n_good && next - here > 3.0 * s->interval_s) {
            orr_status status = add_gap(report, s->attitude, here, next, diag);
            if (status != ORR_OK) return status;
        }
        if (!(next - here <= max_gap_s)) {
            if (here - s->t_s[s->order[from]] > s->t_s[s->order[best_to]] - s->t_s[s->order[best_from]]) {
                best_from = from;
                best_to = k;
            }
            from = k + 1;
        }
    }
    for (size_t k = 0; k < s->n_good; k++)
        if (k < best_from || k > best_to) s->fault[s->order[k]] = ORR_FAULT_OUTSIDE;
    collect(s);
    return ORR_OK;
}

orr_status telemetry_mark_jumps(telemetry_series *s, double floor, orr_diag *diag)
{
    size_t n = s->n_good, d = (size_t)s->dim;
    if (n < 8) return ORR_OK;
    // The curve has several samples a knot, so that one bad row cannot bend it to itself; fewer of a slow
    // log, whose curve could not follow the turns of a flight otherwise. Rows that a bad neighbour had
    // condemned return when the next curve passes through them.
    double step_s = (s->interval_s < 0.5 ? 4.0 : 2.0) * s->interval_s, first_s = s->t_s[s->order[0]],
           span_s = s->t_s[s->order[n - 1]] - first_s;
    double *t = malloc(n * sizeof *t), *v = malloc(n * d * sizeof *v), *w = malloc(n * sizeof *w),
           *e = malloc(n * sizeof *e), *sorted = malloc(n * sizeof *sorted);
    orr_status status = ORR_OK;
    if (t == NULL || v == NULL || w == NULL || e == NULL || sorted == NULL)
        status = orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu rows of telemetry", n);
    for (size_t k = 0; status == ORR_OK && k < n; k++) {
        t[k] = s->t_s[s->order[k]] - first_s;
        memcpy(v + k * d, s->value + s->order[k] * d, d * sizeof *v);
        w[k] = 1.0;
    }
    for (int pass = 0; status == ORR_OK && pass < 8; pass++) {
        orr_uspline curve;
        size_t intervals = (size_t)ceil(span_s / step_s) + 1;
        status = orr_uspline_fit(3, s->dim, 0.0, step_s, intervals, n, t, v, w, 1e-6, &curve, diag);
        if (status != ORR_OK) break;
        size_t inside = 0, changed = 0;
        for (size_t k = 0; k < n; k++) {
            double p[ORR_USPLINE_MAX_DIM], sum = 0.0;
            orr_uspline_eval(&curve, t[k], p, NULL, NULL);
            for (size_t c = 0; c < d; c++) sum += (p[c] - v[k * d + c]) * (p[c] - v[k * d + c]);
            e[k] = sqrt(sum);
            if (w[k] > 0.0) sorted[inside++] = e[k];
        }
        orr_uspline_free(&curve);
        double limit =
            fmax(floor, inside > 0 ? 8.0 * ORR_SIGMA_PER_MAD * orr_upper_median(sorted, inside) : 0.0);
        // Early passes take the worst alone: they bend the curve that the others are judged by.
        double worst = 0.0;
        for (size_t k = 0; k < n; k++)
            if (w[k] > 0.0) worst = fmax(worst, e[k]);
        double cut = pass < 5 ? fmax(limit, 0.4 * worst) : limit;
        for (size_t k = 0; k < n; k++) {
            double now = e[k] > (w[k] > 0.0 ? cut : limit) ? 0.0 : 1.0;
            if (now != w[k]) changed++;
            w[k] = now;
        }
        if (changed == 0) break;
    }
    for (size_t k = 0; status == ORR_OK && k < n; k++)
        if (w[k] == 0.0) s->fault[s->order[k]] = ORR_FAULT_JUMP;
    free(t);
    free(v);
    free(w);
    free(e);
    free(sorted);
    collect(s);
    return status;
}
