// SPDX-License-Identifier: GPL-3.0-or-later
// The Earth's rotation that orbits were made with, as a product keeps it: whoever turns the product's frame
// takes the same.
#ifndef ORR_ORBIT_DYNAMICS_EARTH_ROTATION_H
#define ORR_ORBIT_DYNAMICS_EARTH_ROTATION_H

#include "core/astro.h"
#include "core/status.h"

typedef enum orr_rotation_source {
    ORR_ROTATION_SECULAR = 0, // IERS' secular pole, UT1 by the leap seconds
    ORR_ROTATION_GIVEN = 1,   // a file of Earth rotation parameters
    ORR_ROTATION_ESTIMATED =
        2, // the orbits themselves; UT1, whose rate alone they tell, starts from the leap
           // seconds
} orr_rotation_source;

typedef struct orr_earth_rotation {
    orr_rotation_source source;
    // Every three hours, zonal tides in UT1 included, the ocean's daily ones not; n 0: none is kept (what NULL
    // means to orr_eop_at).
    orr_eop_series series;
    double pole_sigma_rad, lod_sigma_s; // formal, in the middle of the span; 0 unless estimated
} orr_earth_rotation;

// What is known without measurements, IERS' secular pole and UT1 by a run's leap seconds, every three hours: for who reads
// the product by another table. ORR_E_MEMORY.
//   Given:    from, to  the span
//             leap      the run's table; NULL: built-in
//   Returned: out       to be freed with orr_earth_rotation_free; without a series where the built-in table tells the same UT1
orr_status orr_earth_rotation_secular(orr_time from, orr_time to, const orr_leap_table *leap,
                                      orr_earth_rotation *out);
// A copy of a series. ORR_E_MEMORY.
orr_status orr_eop_series_copy(const orr_eop_series *from, orr_eop_series *to);
// Frees the series; it is empty then.
void orr_earth_rotation_free(orr_earth_rotation *r);

// In words: "secular pole", "given", "estimated".
const char *orr_rotation_source_name(orr_rotation_source source);

#endif
