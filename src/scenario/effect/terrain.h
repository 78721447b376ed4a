// SPDX-License-Identifier: GPL-3.0-or-later
// The terrain's horizon around antennas that stand on it: below it nothing is received.
#ifndef ORR_SCENARIO_EFFECT_TERRAIN_H
#define ORR_SCENARIO_EFFECT_TERRAIN_H

#include "ingest/maps/esri_grid.h"
#include "src/scenario/antenna/antenna.h"

enum { ORR_HORIZON_BINS = 3600 }; // azimuths, 0.1 deg apart from North, clockwise

// Elevations of the horizon, geometric: what a straight line to the satellite has to pass.
typedef struct orr_horizon {
    float el_rad[ORR_HORIZON_BINS];
} orr_horizon;

// The horizon of a place.
// Given:
//   grid          heights
//   undulation_m  that is added to them, to have them above the ellipsoid
//   place         geodetic, height above the ellipsoid
//   range_m       farther terrain is left out
//   refraction    whether rays bend
// Returned:
//   out           the horizon; -pi/2 where there is no terrain
//   nearest_m     how far the grid's edge is, or a height that it lacks; range_m where all is there
//   below_m       how far the place is below the terrain; it is lifted by that
// Errors: ORR_E_NODATA (the grid does not cover the place).
// Notes: edges between neighbouring nodes, which are straight lines in space, so that the Earth's curvature is in it; the cells
// around the place itself are left out. A bent ray passes lower: terrain at the distance d appears higher by d/(8 R) (4/3 of the
// Earth's radius), and a satellite by the whole bending, Bennett (1982, J. Navigation 35:255) times 1.13 for radio waves.
orr_status orr_horizon_of(const orr_esri_grid *grid, double undulation_m, orr_geodetic place, double range_m,
                          bool refraction, orr_horizon *out, double *nearest_m, double *below_m,
                          orr_diag *diag);

// Elevation of the horizon at an azimuth of 0 to 2 pi, linear between its own.
double orr_horizon_at(const orr_horizon *h, double az_rad);

typedef struct orr_terrain orr_terrain;
// Prepares obstacles.terrain for the antennas that stand.
// Given:
//   s            scenario
//   antenna, n   its antennas
// Returned:
//   out          NULL without it; free with orr_terrain_close
//   warnings     a file that ends within range, an antenna below the terrain
//   diag         as of the reader and orr_horizon_of; ORR_E_NODATA also where no antenna stands, or one is more than 50 m below
orr_status orr_terrain_open(const orr_scenario *s, const orr_antenna *antenna, size_t n, orr_terrain **out,
                            orr_warnings *warnings, orr_diag *diag);
void orr_terrain_close(orr_terrain *o); // NULL is allowed
// Whether terrain hides what an antenna has at this azimuth (0 to 2 pi) and elevation; o NULL, or an antenna that moves: no.
bool orr_terrain_hides(const orr_terrain *o, size_t antenna, double az_rad, double el_rad);

#endif
