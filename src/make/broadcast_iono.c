// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/broadcast_iono.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/constants.h"
#include "core/linalg.h"
#include "iono/broadcast/bdgim.h"
#include "iono/broadcast/klobuchar.h"

#define ITERATIONS 12
enum { LATITUDES = 11, LONGITUDES = 12, HOURS = 12, PLACES = LATITUDES * LONGITUDES * HOURS, MOST = 9 };
#define TOP_M 20.2e6 // of NeQuick-G's vertical rays

// Vertical content at a place and an instant.
typedef struct sample {
    orr_time t;
    double lat_rad, lon_rad, tecu, weight;
} sample;

typedef struct problem {
    size_t n;
    sample at[PLACES];
    const orr_nequick *nequick;
    const orr_leap_table *leap;
} problem;

// A model: its content by its coefficients, in LSBs of the message.
typedef struct model {
    size_t n;
    double lsb[MOST], least[MOST], most[MOST], start[MOST]; // in LSBs but lsb
    double step[MOST];
    double (*tecu)(const problem *p, const sample *s, const double *coefficient);
} model;

static double tecu_of(double delay_m, double hz) { return delay_m * hz * hz / 40.3e16; }

static double gps_tecu(const problem *p, const sample *s, const double *c)
{
    orr_klobuchar k;
    (void)p;
    memcpy(k.alpha, c, sizeof k.alpha);
    memcpy(k.beta, c + 4, sizeof k.beta);
    return tecu_of(orr_klobuchar_vertical_m(&k, s->t, s->lat_rad, s->lon_rad), ORR_L1_HZ);
}

static double beidou_tecu(const problem *p, const sample *s, const double *c)
{
    orr_klobuchar k;
    (void)p;
    memcpy(k.alpha, c, sizeof k.alpha);
    memcpy(k.beta, c + 4, sizeof k.beta);
    return tecu_of(orr_klobuchar_beidou_vertical_m(&k, s->t, s->lat_rad, s->lon_rad), 1561.098e6);
}

static double bdgim_tecu(const problem *p, const sample *s, const double *c)
{
    (void)p;
    return orr_bdgim_vertical_tecu(c, s->t, s->lat_rad, s->lon_rad);
}

static double nequick_tecu(const problem *p, const sample *s, const double *c)
{
    const orr_geodetic low = {s->lat_rad, s->lon_rad, 0}, high = {s->lat_rad, s->lon_rad, TOP_M};
    return orr_nequick_slant_tecu(p->nequick, c, s->t, p->leap, low, high);
}

#define KLOBUCHAR(function)                                                                                  \
    {                                                                                                        \
        8, {0x1p-30, 0x1p-27, 0x1p-24, 0x1p-24, 0x1p11, 0x1p14, 0x1p16, 0x1p16},                             \
            {-128, -128, -128, -128, -128, -128, -128, -128}, {127, 127, 127, 127, 127, 127, 127, 127},      \
            {20, 0, -1, 0, 55, 0, -1, 0}, {1, 1, 1, 1, 1, 1, 1, 1}, function                                 \
    }
static const model gps = KLOBUCHAR(gps_tecu), beidou = KLOBUCHAR(beidou_tecu);
static const model bdgim = {9,
                            {0.125, 0.125, 0.125, 0.125, -0.125, 0.125, 0.125, 0.125, 0.125},
                            {0, -128, 0, 0, 0, -128, -128, -128, -128},
                            {1023, 127, 255, 255, 255, 127, 127, 127, 127},
                            {160, 0, 40, 40, 40, 0, 0, 0, 0},
                            {1, 1, 1, 1, 1, 1, 1, 1, 1},
                            bdgim_tecu};
static const model nequick = {
    3,           {0x1p-2, 0x1p-8, 0x1p-15}, {1, -1024, -8192}, {2047, 1023, 8191}, {400, 0, 0}, {4, 16, 64},
    nequick_tecu};

static double value_of(const model *m, const problem *p, const sample *s, const double *lsbs)
{
    double c[MOST];
    for (size_t j = 0; j < m->n; j++) c[j] = lsbs[j] * m->lsb[j];
    return m->tecu(p, s, c);
}

static double cost_of(const model *m, const problem *p, size_t stride, const double *x)
{
    double sum = 0;
    for (size_t i = 0; i < p->n; i += stride) {
        const double d = value_of(m, p, &p->at[i], x) - p->at[i].tecu;
        sum += p->at[i].weight * p->at[i].weight * d * d;
    }
    return sum;
}

// Levenberg's damped steps with differences for derivatives; then the nearest whole LSBs.
static orr_status fit(const model *m, const problem *p, size_t stride, double *coefficient)
{
    const size_t most_rows = p->n / stride + 1 + MOST;
    double *A = malloc(most_rows * m->n * sizeof *A), *b = malloc(most_rows * sizeof *b), x[MOST],
           damping = 1e-2;
    orr_status s = A != NULL && b != NULL ? ORR_OK : ORR_E_MEMORY;
    memcpy(x, m->start, sizeof x);
    double cost = s == ORR_OK ? cost_of(m, p, stride, x) : 0;
    for (int it = 0; it < ITERATIONS && s == ORR_OK; it++) {
        size_t rows = 0;
        double tau[MOST], dx[MOST], next[MOST];
        for (size_t i = 0; i < p->n; i += stride, rows++) {
            const sample *at = &p->at[i];
            const double here = value_of(m, p, at, x);
            for (size_t j = 0; j < m->n; j++) {
                double moved[MOST];
                memcpy(moved, x, sizeof moved);
                moved[j] += m->step[j];
                A[rows * m->n + j] = at->weight * (value_of(m, p, at, moved) - here) / m->step[j];
            }
            b[rows] = at->weight * (at->tecu - here);
        }
        for (size_t j = 0; j < m->n;
             j++, rows++) { // a move of a hundred steps costs as much as the damping says
            memset(&A[rows * m->n], 0, m->n * sizeof *A);
            A[rows * m->n + j] = sqrt(damping * (double)p->n) / (100 * m->step[j]);
            b[rows] = 0;
        }
        s = orr_least_squares(A, rows, m->n, b, tau, dx);
        for (size_t j = 0; j < m->n && s == ORR_OK; j++)
            next[j] = fmax(m->least[j], fmin(m->most[j], x[j] + dx[j]));
        const double better = s == ORR_OK ? cost_of(m, p, stride, next) : HUGE_VAL;
        if (better < cost) {
            memcpy(x, next, sizeof x);
            cost = better;
            damping /= 5;
        } else
            damping *= 20;
    }
    free(A);
    free(b);
    for (size_t j = 0; j < m->n; j++) coefficient[j] = round(x[j]) * m->lsb[j] + 0.0;
    return s;
}

static void gather(const orr_tec_field *f, orr_time from, orr_time to, problem *p)
{
    orr_tec_instant *at = malloc(sizeof *at);
    const orr_time begin = from + (to - from) / 2 - 12 * 3600 * ORR_NS_PER_S;
    p->n = 0;
    for (int h = 0; at != NULL && h < HOURS; h++) {
        const orr_time t = begin + (2 * h + 1) * 3600 * ORR_NS_PER_S;
        if (orr_tec_field_at(f, t, at, NULL) != ORR_OK) continue;
        for (int i = 0; i < LATITUDES; i++)
            for (int j = 0; j < LONGITUDES; j++) {
                const double lat = (-75 + 15 * i) * ORR_RAD_PER_DEG, lon = (-180 + 30 * j) * ORR_RAD_PER_DEG;
                orr_tec_value v;
                if (orr_tec_vertical(at, orr_vec3_make(cos(lat) * cos(lon), cos(lat) * sin(lon), sin(lat)),
                                     &v, NULL) != ORR_OK)
                    continue;
                p->at[p->n++] = (sample){t, lat, lon, v.vtec_tecu, sqrt(cos(lat))};
            }
    }
    free(at);
}

static orr_nav_iono record(uint8_t kind, char system)
{
    orr_nav_iono r = {
        .kind = kind, .system = system, .time_mark = ' ', .t = ORR_TIME_NONE, .iod = ORR_NAV_NO_IOD};
    return r;
}

orr_status orr_broadcast_iono_fit(const orr_tec_field *field, orr_time from, orr_time to,
                                  const orr_nequick *tables, const orr_leap_table *leap,
                                  orr_nav_iono out[ORR_BROADCAST_IONO_MODELS], size_t *n, orr_diag *diag)
{
    problem *p = malloc(sizeof *p);
    *n = 0;
    if (p == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    p->nequick = tables, p->leap = leap;
    gather(field, from, to, p);
    orr_status s = p->n >= 100 ? ORR_OK : ORR_E_NODATA;
    out[0] = record(ORR_NAV_KLOBUCHAR, 'G');
    out[1] = record(ORR_NAV_KLOBUCHAR, 'C');
    out[2] = record(ORR_NAV_BDGIM, 'C');
    out[3] = record(ORR_NAV_NEQUICK_G, 'E');
    if (s == ORR_OK) s = fit(&gps, p, 1, out[0].coefficient);
    if (s == ORR_OK) s = fit(&beidou, p, 1, out[1].coefficient);
    if (s == ORR_OK) s = fit(&bdgim, p, 1, out[2].coefficient);
    if (s == ORR_OK && tables != NULL) s = fit(&nequick, p, 11, out[3].coefficient);
    free(p);
    if (s == ORR_E_NODATA)
        return orr_diag_set(diag, s, "the ionosphere covers nothing of the orbits' middle day");
    if (s != ORR_OK) return orr_diag_set(diag, s, "the ionosphere cannot be fitted by broadcast models");
    *n = tables != NULL ? 4 : 3;
    return ORR_OK;
}
