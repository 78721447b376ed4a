// SPDX-License-Identifier: GPL-3.0-or-later
// NeQuick-G: the electron density that Galileo's three broadcast coefficients stand for, and its integral along a ray
// (European Union 2016, "European GNSS (Galileo) Open Service: Ionospheric Correction Algorithm for Galileo Single
// Frequency Users", issue 1.2; equation numbers in the source are its). The model lives on tables of the ITU-R (CCIR) and a
// grid of the modified dip latitude, which are read from a folder.
#ifndef ORR_IONO_BROADCAST_NEQUICK_H
#define ORR_IONO_BROADCAST_NEQUICK_H

#include "core/earth.h"
#include "core/status.h"
#include "core/time.h"

// The tables; about 300 kB, read only after loading.
typedef struct orr_nequick orr_nequick;

// Reads ccir11 to ccir22 (a month each, January first: foF2, then M(3000)F2, each at low and high solar activity) and the
// modip grid (39 rows from -95 to 95 degrees by 5, 39 columns from -190 to 190 by 10) of a folder: the files ccirNN.asc and
// modip.asc, plain or with .gz. Free with orr_nequick_free. Errors: those of orr_input_read_all, ORR_E_FORMAT (file and
// line) where a number is none or there are not as many as there should be, ORR_E_MEMORY.
orr_status orr_nequick_load(const char *folder, orr_nequick **out, orr_diag *diag);
// NULL is allowed.
void orr_nequick_free(orr_nequick *n);
// How many numbers the tables are.
#define ORR_NEQUICK_NUMBERS ((size_t)35817)
// The tables as numbers in an order of their own, [ORR_NEQUICK_NUMBERS], for a product to keep; borrowed.
const double *orr_nequick_numbers(const orr_nequick *n);
// The way back from as many numbers. ORR_E_FORMAT where one is none, ORR_E_MEMORY. Free with orr_nequick_free.
orr_status orr_nequick_of_numbers(const double *number, orr_nequick **out, orr_diag *diag);

// The electron content between two points.
//   Given:    n            the tables
//             ai           the broadcast coefficients a_i0 to a_i2: sfu, sfu/degree, sfu/degree^2; all three 0 stand for
//                          63.7 sfu
//             t            the instant (its month and hour of UTC, by `leap`; NULL: built-in)
//             site, sat    the ray's lower and upper end, geodetic (height of the lower end -1 to 1000 km)
//   Returned: (value)      TECU; NAN where the upper end is not above the lower
//   Notes:    within 0.05 TECU of the description's own values (Annex E).
double orr_nequick_slant_tecu(const orr_nequick *n, const double ai[3], orr_time t,
                              const orr_leap_table *leap, orr_geodetic site, orr_geodetic sat);
// The same between any two points, as from a receiver in space down to the Earth's limb and up again.
//   Given:    n, ai, t, leap  as above
//             site            the receiver, whose modip goes with ai, geodetic
//             sat             the other end
//   Returned: (value)         TECU; NAN where the line passes below the model's sphere
double orr_nequick_path_tecu(const orr_nequick *n, const double ai[3], orr_time t, const orr_leap_table *leap,
                             orr_geodetic site, orr_geodetic sat);
// The end of a ray at a height above the model's sphere, for orr_nequick_slant_tecu.
orr_geodetic orr_nequick_upper_end(orr_geodetic site, double az_rad, double el_rad, double height_m);

#endif
