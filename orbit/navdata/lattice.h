// SPDX-License-Identifier: GPL-3.0-or-later
// Integer least squares: which point of the lattice that a message can transmit is nearest to a least-squares
// solution. Rounding each parameter on its own is far from it, because an orbit's parameters make up for one
// another. Private to the room.
#ifndef ORR_ORBIT_NAVDATA_LATTICE_H
#define ORR_ORBIT_NAVDATA_LATTICE_H

#include "core/status.h"

#define ORR_LATTICE_MAX 17

// Finds the integers z that minimise |R z - y|^2.
// Given:
//   n          dimension, at most ORR_LATTICE_MAX
//   R          upper triangular and regular, n x n, row-major, as a QR decomposition gives it
//   y          [n]
//   max_nodes  the search ends after so many nodes with the best point so far; 0: rounding in the reduced basis
// Returned:
//   z          [n] integers
// Errors: ORR_E_NUMERIC for a singular or non-finite R.
// Notes: the basis is reduced with delta = 3/4, then searched depth first from the rounded solution outward. The result
// is at worst that of rounding in the reduced basis. The same input always gives the same output.
// Reference: Lenstra, Lenstra and Lovasz 1982; Schnorr and Euchner 1994.
orr_status orr_lattice_closest(size_t n, const double *R, const double *y, size_t max_nodes, double *z);

#endif
