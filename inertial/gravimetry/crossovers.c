// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/gravimetry/crossovers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/constants.h"
#include "core/linalg.h"

// Angle in (-pi, pi].
static double wrapped(double a) { return a - 2 * ORR_PI * nearbyint(a / (2 * ORR_PI)); }

static double course_at(const orr_survey_series *s, size_t k)
{
    const size_t a = k > 0 ? k - 1 : 0, b = k + 1 < s->n ? k + 1 : k;
    return atan2(s->east_m[b] - s->east_m[a], s->north_m[b] - s->north_m[a]);
}

// --- Lines ---

static orr_status add_line(const orr_survey_series *s, size_t from, size_t to, double least_s,
                           double margin_s, orr_survey_line *line, size_t *n, orr_diag *diag)
{
    const size_t cut = (size_t)(margin_s / s->step_s);
    if ((double)(to - from) * s->step_s < least_s + 2 * margin_s) return ORR_OK;
    if (*n == ORR_SURVEY_MOST_LINES)
        return orr_diag_set(diag, ORR_E_LIMIT, "more than %d lines of a survey", ORR_SURVEY_MOST_LINES);
    from += cut;
    to -= cut;
    line[(*n)++] = (orr_survey_line){
        .from = from,
        .to = to,
        .course_rad = atan2(s->east_m[to - 1] - s->east_m[from], s->north_m[to - 1] - s->north_m[from])};
    return ORR_OK;
}

orr_status orr_survey_lines(const orr_survey_series *s, double turn_radps, double least_s, double margin_s,
                            orr_survey_line *line, size_t *n, orr_diag *diag)
{
    *n = 0;
    const size_t window = (size_t)fmax(1.0, 10.0 / s->step_s);
    size_t from = 0;
    bool on = false;
    orr_status status = ORR_OK;
    for (size_t k = 0; k + window < s->n && status == ORR_OK; k++) {
        const double rate =
            wrapped(course_at(s, k + window) - course_at(s, k)) / ((double)window * s->step_s);
        const bool straight = fabs(rate) < turn_radps;
        if (straight && !on) from = k;
        // The window before this one was straight to its end.
        if (!straight && on) status = add_line(s, from, k - 1 + window, least_s, margin_s, line, n, diag);
        on = straight;
    }
    if (status == ORR_OK && on) status = add_line(s, from, s->n, least_s, margin_s, line, n, diag);
    if (status == ORR_OK && *n == 0)
        return orr_diag_set(diag, ORR_E_NODATA, "no stretch is straight for %g s besides its ends of %g s",
                            least_s, margin_s);
    return status;
}

// --- Crossings ---

// Where the pieces a..a+da and b..b+db cross, as fractions of both; false where they do not.
static bool crossing(const orr_survey_series *s, size_t a, size_t da, size_t b, size_t db, double *u,
                     double *v)
{
    const double ax = s->east_m[a + da] - s->east_m[a], ay = s->north_m[a + da] - s->north_m[a];
    const double bx = s->east_m[b + db] - s->east_m[b], by = s->north_m[b + db] - s->north_m[b];
    const double cx = s->east_m[b] - s->east_m[a], cy = s->north_m[b] - s->north_m[a],
                 det = ax * by - ay * bx;
    if (!(fabs(det) > 0)) return false;
    *u = (cx * by - cy * bx) / det;
    *v = (cx * ay - cy * ax) / det;
    return *u >= 0 && *u < 1 && *v >= 0 && *v < 1;
}

// Of the lines as a whole, then of the samples where they cross; lines bend a little.
static bool find(const orr_survey_series *s, const orr_survey_line *a, const orr_survey_line *b, double *at_a,
                 double *at_b)
{
    const size_t na = a->to - 1 - a->from, nb = b->to - 1 - b->from;
    double u, v;
    if (!crossing(s, a->from, na, b->from, nb, &u, &v)) return false;
    const size_t ia = a->from + (size_t)(u * (double)na), ib = b->from + (size_t)(v * (double)nb);
    const size_t reach = (size_t)(60.0 / s->step_s);
    for (size_t i = ia > a->from + reach ? ia - reach : a->from; i < ia + reach && i + 1 < a->to; i++)
        for (size_t j = ib > b->from + reach ? ib - reach : b->from; j < ib + reach && j + 1 < b->to; j++)
            if (crossing(s, i, 1, j, 1, &u, &v)) {
                *at_a = (double)i + u;
                *at_b = (double)j + v;
                return true;
            }
    return false;
}

static double value_at(const double *x, double at)
{
    const size_t k = (size_t)at;
    return x[k] + (at - (double)k) * (x[k + 1] - x[k]);
}

// Lines that hang together through crossings: its number of groups.
static size_t groups(const orr_crossover *c, size_t m, size_t n)
{
    size_t of[ORR_SURVEY_MOST_LINES], count = 0;
    for (size_t i = 0; i < n; i++) of[i] = i;
    for (size_t k = 0; k < m; k++)
        for (size_t i = 0, from = of[c[k].b], to = of[c[k].a]; i < n; i++)
            if (of[i] == from) of[i] = to;
    for (size_t i = 0; i < n; i++) {
        bool crossed = false;
        for (size_t k = 0; k < m; k++) crossed = crossed || c[k].a == i || c[k].b == i;
        count += of[i] == i || !crossed;
    }
    return count;
}

// Constants of lines by least squares; the mean of all is held at 0, which levels each group by itself too.
static orr_status level(orr_survey_line *line, size_t n, orr_crossover *c, size_t m, orr_diag *diag)
{
    double *N = calloc(n * n + n, sizeof *N);
    if (N == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu lines", n);
    double *x = N + n * n;
    for (size_t k = 0; k < m; k++) {
        N[c[k].a * n + c[k].a] += 1;
        N[c[k].b * n + c[k].b] += 1;
        N[c[k].a * n + c[k].b] -= 1;
        N[c[k].b * n + c[k].a] -= 1;
        x[c[k].a] += c[k].difference_mgal;
        x[c[k].b] -= c[k].difference_mgal;
    }
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) N[i * n + j] += i == j ? 1.0 / (double)n + 1e-9 : 1.0 / (double)n;
    const bool fine = orr_cholesky_factor(N, n, 1e-15) == ORR_OK && orr_cholesky_solve(N, n, x) == ORR_OK;
    for (size_t i = 0; fine && i < n; i++) line[i].level_mgal = x[i];
    free(N);
    return fine ? ORR_OK : orr_diag_set(diag, ORR_E_NUMERIC, "the lines cannot be levelled");
}

orr_status orr_crossovers(const orr_survey_series *s, orr_survey_line *line, size_t n, orr_crossover **out,
                          orr_crossover_report *report, orr_diag *diag)
{
    orr_crossover *c = NULL;
    *out = NULL;
    memset(report, 0, sizeof *report);
    for (size_t i = 0; i < n; i++)
        for (size_t j = i + 1; j < n; j++) {
            const double across = fabs(sin(line[i].course_rad - line[j].course_rad));
            orr_crossover one = {.a = i, .b = j};
            if (across < 0.5 || !find(s, &line[i], &line[j], &one.at_a, &one.at_b)) continue;
            one.difference_mgal = value_at(s->mgal, one.at_a) - value_at(s->mgal, one.at_b);
            if (!ORR_ARRAY_GROW(c, report->n)) {
                free(c);
                return orr_diag_set(diag, ORR_E_MEMORY, "no memory for crossovers");
            }
            c[report->n++] = one;
        }
    if (report->n == 0) return orr_diag_set(diag, ORR_E_NODATA, "none of the %zu lines cross", n);
    const orr_status status = level(line, n, c, report->n, diag);
    if (status != ORR_OK) {
        free(c);
        return status;
    }
    double sum = 0, after = 0;
    for (size_t k = 0; k < report->n; k++) {
        c[k].levelled_mgal = c[k].difference_mgal - line[c[k].a].level_mgal + line[c[k].b].level_mgal;
        report->mean_mgal += c[k].difference_mgal / (double)report->n;
        sum += c[k].difference_mgal * c[k].difference_mgal;
        after += c[k].levelled_mgal * c[k].levelled_mgal;
    }
    const size_t taken = n - groups(c, report->n, n);
    report->rms_mgal = sqrt(sum / (double)report->n);
    report->levelled_rms_mgal = report->n > taken ? sqrt(after / (double)(report->n - taken)) : 0.0;
    *out = c;
    return ORR_OK;
}
