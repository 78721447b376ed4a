// SPDX-License-Identifier: GPL-3.0-or-later
// Points of equal steps in latitude and longitude, as files of the troposphere list them: row by row, longitudes fastest.
#ifndef ORR_INGEST_TROPOSPHERE_LATTICE_H
#define ORR_INGEST_TROPOSPHERE_LATTICE_H

#include <stdbool.h>
#include <stddef.h>

typedef struct orr_lattice {
    size_t n_lat, n_lon;
    double lat_deg, lat_step_deg, lon_deg, lon_step_deg; // of the first point, and to its neighbours
    bool around;                                         // the last longitude is followed by the first
} orr_lattice;

typedef struct orr_lattice_point {
    double lat_deg, lon_deg;
} orr_lattice_point;

// Finds the lattice whose points are listed.
// Given:
//   point     [n] points
// Returned:
//   out       the lattice
//   bad       place in the list of the first point that is on none
//   (value)   false: they are none of at least 2 x 2 points
bool orr_lattice_learn(const orr_lattice_point *point, size_t n, orr_lattice *out, size_t *bad);

// The points around a place, for values that are linear between them along both axes.
typedef struct orr_lattice_cell {
    size_t at[4]; // places in the list
    double weight[4];
} orr_lattice_cell;

// The cell of a place.
//   Given:    l          the lattice
//             lat_deg, lon_deg
//   Returned: out        its points
//             (value)    false: the lattice does not cover the place. Beyond an edge that is half a step from a pole, or less,
//                        the edge's values hold
bool orr_lattice_find(const orr_lattice *l, double lat_deg, double lon_deg, orr_lattice_cell *out);

#endif
