// SPDX-License-Identifier: GPL-3.0-or-later
// Clocks of a log: seconds that start again at 0, and a clock of the log's own beside GPS time.
#include <math.h>
#include <stdlib.h>

#include "core/array.h"
#include "core/robust.h"
#include "ingest/telemetry/telemetry_private.h"

#define TURN_S 3600.0     // a clock starts again between its last and its first hour, else it was set back
#define LEAST_SPAN_S 60.0 // of ties that determine a drift
#define BLOCKS 24

double telemetry_clock_run(telemetry_clock *c, double t_s, bool *again)
{
    *again = false;
    if (c->begun) {
        for (int k = 0; k < 2 && !*again; k++) {
            double period = k == 0 ? TELEMETRY_DAY_S : TELEMETRY_WEEK_S;
            // A leap second may be counted at the end.
            if (!(c->last_s >= period - TURN_S && c->last_s <= period + 1.0 && t_s >= 0.0 && t_s < TURN_S))
                continue;
            *again = true;
            c->added_s += period;
            c->period_s = period;
        }
    }
    c->begun = true;
    c->last_s = t_s;
    return t_s + c->added_s;
}

orr_status telemetry_ties_add(telemetry_ties *t, double host_s, double gps_s, orr_diag *diag)
{
    if (!ORR_ARRAY_GROW(t->host_s, t->n) || !ORR_ARRAY_GROW(t->gps_s, t->n))
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the clocks of %zu rows", t->n);
    t->host_s[t->n] = host_s;
    t->gps_s[t->n++] = gps_s;
    return ORR_OK;
}

void telemetry_ties_free(telemetry_ties *t)
{
    free(t->host_s);
    free(t->gps_s);
    *t = (telemetry_ties){0};
}

double orr_clock_tied_s(const orr_clock_tie *tie, double host_s)
{
    return host_s + tie->offset_s + tie->drift * (host_s - tie->origin_s);
}

// Median slope between medians of blocks (Theil and Sen): neither rows that came late nor a clock that was set
// in a small part of the log bend it. y[n] is used up.
static double block_slope(const double *x, double *y, size_t n)
{
    double bx[BLOCKS], by[BLOCKS], slope[BLOCKS * BLOCKS / 2];
    size_t m = 0;
    for (size_t b = 0; b < BLOCKS; b++) {
        size_t from = b * n / BLOCKS, to = (b + 1) * n / BLOCKS;
        bx[b] = 0.5 * (x[from] + x[to - 1]);
        by[b] = orr_median(y + from, to - from);
        for (size_t a = 0; a < b; a++)
            if (fabs(bx[b] - bx[a]) > 1.0) slope[m++] = (by[b] - by[a]) / (bx[b] - bx[a]);
    }
    return m > 0 ? orr_median(slope, m) : 0.0;
}

// Median of the absolute values of r[n] - middle, as a standard deviation. r is used up.
static double spread(double *r, size_t n, double middle)
{
    for (size_t k = 0; k < n; k++) r[k] = fabs(r[k] - middle);
    return ORR_SIGMA_PER_MAD * orr_median(r, n);
}

orr_status telemetry_tie(const telemetry_ties *t, orr_clock_tie *out, double *offset_s, orr_diag *diag)
{
    size_t n = t->n;
    double *y = malloc(n * sizeof *y), *r = malloc(n * sizeof *r);
    if (y == NULL || r == NULL) {
        free(y);
        free(r);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the clocks of %zu rows", n);
    }
    double low = t->host_s[0], high = low;
    for (size_t k = 0; k < n; k++) {
        y[k] = t->gps_s[k] - t->host_s[k];
        low = fmin(low, t->host_s[k]);
        high = fmax(high, t->host_s[k]);
        r[k] = t->host_s[k];
    }
    double origin = orr_median(r, n), drift = 0.0;
    bool drifts = n >= 2 * BLOCKS && high - low >= LEAST_SPAN_S;
    if (drifts) {
        for (size_t k = 0; k < n; k++) r[k] = y[k];
        drift = block_slope(t->host_s, r, n);
    }
    double offset = 0.0, sigma = 0.0;
    for (int pass = 0;; pass++) {
        for (size_t k = 0; k < n; k++) r[k] = y[k] - drift * (t->host_s[k] - origin);
        offset = orr_median(r, n);
        sigma = spread(r, n, offset);
        if (!drifts || pass == 4) break;
        // Least squares over what lies within three sigmas.
        double sx = 0, sy = 0, sxx = 0, sxy = 0, used = 0;
        for (size_t k = 0; k < n; k++) {
            double x = t->host_s[k] - origin, e = y[k] - offset;
            if (fabs(e - drift * x) > 3.0 * sigma + 1e-9) continue;
            used += 1.0;
            sx += x;
            sy += e;
            sxx += x * x;
            sxy += x * e;
        }
        double d = used * sxx - sx * sx;
        if (!(d > 0.0)) break;
        drift = (used * sxy - sx * sy) / d;
    }
    *out = (orr_clock_tie){.n = n, .origin_s = origin, .drift = drift, .scatter_s = sigma};
    *offset_s = offset;
    free(y);
    free(r);
    return ORR_OK;
}
