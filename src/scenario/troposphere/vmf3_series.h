// SPDX-License-Identifier: GPL-3.0-or-later
// VMF3's files as functions of time and place.
#ifndef ORR_SCENARIO_TROPOSPHERE_VMF3_SERIES_H
#define ORR_SCENARIO_TROPOSPHERE_VMF3_SERIES_H

#include "core/earth.h"
#include "ingest/troposphere/vmf3.h"
#include "src/scenario/source/source.h"

typedef struct orr_vmf3_series orr_vmf3_series;

// Reads grids, each of one instant, or files of stations; not both.
// Given:
//   file, n    paths of the files
//   heights    path of the heights of the grid's points; NULL with stations
//   leap       leap seconds; NULL: built-in
// Returned:
//   out        the series; close with orr_vmf3_series_close. NULL on failure
//   diag       as of the readers; ORR_E_KIND (another kind of file, or both), ORR_E_ARG (grids without heights and the other way
//              round), ORR_E_FORMAT (grids unlike each other, two of one instant), ORR_E_NODATA (one instant alone)
orr_status orr_vmf3_series_open(const char *const *file, size_t n, const char *heights,
                                const orr_leap_table *leap, orr_vmf3_series **out, orr_diag *diag);
// NULL is allowed.
void orr_vmf3_series_close(orr_vmf3_series *v);
// Whether it is of stations.
bool orr_vmf3_series_of_stations(const orr_vmf3_series *v);
// Whether all of it has gradients.
bool orr_vmf3_series_has_gradients(const orr_vmf3_series *v);
// From its first instant to its last; of stations, of all of them together.
orr_span orr_vmf3_series_span(const orr_vmf3_series *v);

// The place of a station among them; false: it is not there, and `listed` has the first that are.
//   Given:    v, name    whatever the case
//             n          size of listed
//   Returned: station    its place
//             listed     names
bool orr_vmf3_series_find(const orr_vmf3_series *v, const char *name, size_t *station, char *listed,
                          size_t n);

// Values at a place and an instant.
// Given:
//   v         the series
//   station   of stations, which; else it does not matter
//   place     of grids; delays are for its height above the ellipsoid
//   t         within the span
// Returned:
//   out       linear in time between instants; of grids then linear along both axes, delays of each point lifted to the place's
//             height first: the hydrostatic one by its pressure, the wet one falling by e every 2 km. Coefficients of grids are for sea
//             level
//   (value)   false: place or time are not covered
// Reference: Kouba 2008, J. Geod. 82:193; TU Wien's vmf3_grid
bool orr_vmf3_series_at(const orr_vmf3_series *v, size_t station, orr_geodetic place, orr_time t,
                        orr_vmf3_values *out);

#endif
