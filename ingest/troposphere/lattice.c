// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/troposphere/lattice.h"

#include <math.h>

static const double EXACT_DEG = 1e-6;

static bool is_on(const orr_lattice *l, size_t k, orr_lattice_point p)
{
    const double lat = l->lat_deg + (double)(k / l->n_lon) * l->lat_step_deg,
                 lon = l->lon_deg + (double)(k % l->n_lon) * l->lon_step_deg;
    // Longitudes may go on from 180 as from -180.
    return fabs(p.lat_deg - lat) < EXACT_DEG && fabs(remainder(p.lon_deg - lon, 360)) < EXACT_DEG;
}

bool orr_lattice_learn(const orr_lattice_point *point, size_t n, orr_lattice *out, size_t *bad)
{
    *out = (orr_lattice){.n_lat = 0};
    *bad = 0;
    size_t wide = 0; // points of the first row
    while (wide < n && fabs(point[wide].lat_deg - point[0].lat_deg) < EXACT_DEG) wide++;
    *bad = wide;
    if (wide < 2 || wide == n) return false;
    orr_lattice l = {.n_lat = n / wide,
                     .n_lon = wide,
                     .lat_deg = point[0].lat_deg,
                     .lat_step_deg = point[wide].lat_deg - point[0].lat_deg,
                     .lon_deg = point[0].lon_deg,
                     .lon_step_deg = remainder(point[1].lon_deg - point[0].lon_deg, 360)};
    *bad = 1;
    if (!(fabs(l.lon_step_deg) > EXACT_DEG)) return false;
    for (size_t k = 0; k < n; k++)
        if (!is_on(&l, k, point[k])) {
            *bad = k;
            return false;
        }
    *bad = n - 1; // the last row is cut
    if (n % wide != 0) return false;
    const double turn = (double)wide * fabs(l.lon_step_deg);
    l.around = fabs(turn - 360) < EXACT_DEG;
    *out = l;
    *bad = n;
    return true;
}

// Place along an axis in steps from the first of n points; false outside.
static bool along(double steps, size_t n, bool held, size_t *at, double *beyond)
{
    const double last = (double)(n - 1);
    if (!(steps >= -EXACT_DEG && steps <= last + EXACT_DEG) && !(held && isfinite(steps))) return false;
    const double x = fmin(fmax(steps, 0), last);
    *at = (size_t)fmin(floor(x), last - 1);
    *beyond = x - (double)*at;
    return true;
}

bool orr_lattice_find(const orr_lattice *l, double lat_deg, double lon_deg, orr_lattice_cell *out)
{
    size_t row, column, next;
    double y, x;
    const double up = (lat_deg - l->lat_deg) / l->lat_step_deg,
                 last_deg = l->lat_deg + (double)(l->n_lat - 1) * l->lat_step_deg;
    const double edge_deg = up < 0 ? l->lat_deg : last_deg;
    const bool pole = 90 - fabs(edge_deg) <= fabs(l->lat_step_deg) / 2 + EXACT_DEG && fabs(lat_deg) <= 90;
    if (!along(up, l->n_lat, pole, &row, &y)) return false;
    const double aside = (lon_deg - l->lon_deg) / l->lon_step_deg, turn = 360 / fabs(l->lon_step_deg);
    double steps = aside - floor(aside / turn) * turn; // from 0 to a turn
    if (l->around) {
        column = (size_t)floor(fmin(steps, turn - EXACT_DEG)) % l->n_lon;
        next = (column + 1) % l->n_lon;
        x = fmin(steps, turn) - (double)column;
    } else {
        if (turn - steps < EXACT_DEG) steps = 0;
        if (!along(steps, l->n_lon, false, &column, &x)) return false;
        next = column + 1;
    }
    const size_t a = row * l->n_lon, b = a + l->n_lon;
    *out = (orr_lattice_cell){.at = {a + column, a + next, b + column, b + next},
                              .weight = {(1 - y) * (1 - x), (1 - y) * x, y * (1 - x), y * x}};
    return true;
}
