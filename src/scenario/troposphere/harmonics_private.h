// SPDX-License-Identifier: GPL-3.0-or-later
// Spherical harmonics of a place, without normalisation: what the mapping functions of TU Wien are made of.
#ifndef ORR_SCENARIO_TROPOSPHERE_HARMONICS_PRIVATE_H
#define ORR_SCENARIO_TROPOSPHERE_HARMONICS_PRIVATE_H

enum { ORR_HARMONICS_MOST = 12 };
#define ORR_HARMONICS_TERMS(degree) (((degree) + 1) * ((degree) + 2) / 2)

// P_nm(sin lat) cos(m lon) and P_nm(sin lat) sin(m lon).
// Given:
//   degree    at most ORR_HARMONICS_MOST
//   lat_rad, lon_rad
// Returned:
//   c, s      [ORR_HARMONICS_TERMS(degree)] by degree, and within it by order
void orr_place_harmonics(int degree, double lat_rad, double lon_rad, double *c, double *s);

#endif
