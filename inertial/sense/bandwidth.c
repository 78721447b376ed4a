// SPDX-License-Identifier: GPL-3.0-or-later
// A sensor's response of second order: y'' + 2 d w y' + w^2 y = w^2 x. Its steps are exact for an input that is steady over each
// step; the mean over a step of what comes out is what the sensor gives.
#include <math.h>
#include <string.h>

#include "inertial/sense/measured_private.h"

enum { N = 4 }; // integral of y, y, y', x

static void multiply(double out[N][N], double a[N][N], double b[N][N])
{
    double c[N][N];
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            c[i][j] = 0.0;
            for (int k = 0; k < N; k++) c[i][j] += a[i][k] * b[k][j];
        }
    memcpy(out, c, sizeof c);
}

// exp(a) by its series, after halvings that make it small.
static void exponential(double a[N][N], double out[N][N])
{
    double size = 0.0, term[N][N] = {{0}};
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) size = fmax(size, fabs(a[i][j]));
    int halvings = 0;
    for (; size > 0.1 && halvings < 60; halvings++) size *= 0.5;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            a[i][j] = ldexp(a[i][j], -halvings);
            term[i][j] = out[i][j] = i == j ? 1.0 : 0.0;
        }
    for (int k = 1; k < 14; k++) {
        multiply(term, term, a);
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) out[i][j] += term[i][j] /= (double)k;
    }
    for (int k = 0; k < halvings; k++) multiply(out, out, out);
}

orr_bandwidth orr_bandwidth_begin(const orr_triad_errors *e, double dt_s)
{
    orr_bandwidth b = {.on = e->bandwidth_hz > 0.0};
    if (!b.on) return b;
    const double d = e->damping > 0.0 ? e->damping : sqrt(0.5), m = 1.0 - 2.0 * d * d;
    // |H| = sqrt(1/2) at bandwidth_hz.
    const double w = 2.0 * ORR_PI * e->bandwidth_hz / sqrt(m + sqrt(m * m + 1.0)), h = w * dt_s;
    // Time in units of the step.
    double a[N][N] = {{0, 1, 0, 0}, {0, 0, 1, 0}, {0, -h * h, -2.0 * d * h, h * h}, {0, 0, 0, 0}}, all[N][N];
    exponential(a, all);
    memcpy(b.step, all, sizeof b.step);
    return b;
}

double orr_bandwidth_step(orr_bandwidth *b, double increment, double dt_s)
{
    if (!b->on) return increment;
    const double x = increment / dt_s;
    if (!b->begun) { // settled
        b->value = x;
        b->begun = true;
    }
    const double s[N] = {0.0, b->value, b->slope, x};
    double next[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++)
        for (int k = 1; k < N; k++) next[i] += b->step[i][k] * s[k];
    b->value = next[1];
    b->slope = next[2];
    return next[0] * dt_s;
}
