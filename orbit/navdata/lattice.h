// SPDX-License-Identifier: GPL-3.0-or-later
// Integer least squares: which point of the lattice that a message can transmit is nearest to a least-squares
// solution. Rounding each parameter on its own is far from it, because an orbit's parameters make up for one
// another. Private to the room.
#ifndef ORR_ORBIT_NAVDATA_LATTICE_H
#define ORR_ORBIT_NAVDATA_LATTICE_H

#include "core/status.h"

#define ORR_LATTICE_MAX 15

// Integers z that minimise |R z - y|^2 for an upper triangular, regular R (n x n, row-major, n <= 15), as a
// QR decomposition gives it. The basis is reduced (Lenstra, Lenstra and Lovasz 1982, delta = 3/4), then
// searched depth first from the rounded solution outward (Schnorr and Euchner 1994). The search ends after
// max_nodes nodes with the best point so far, which is at worst that of rounding in the reduced basis
// (max_nodes = 0 asks for this one). A pure function: no clock decides. ORR_E_NUMERIC for a singular or
// non-finite R.
orr_status orr_lattice_closest(size_t n, const double *R, const double *y, size_t max_nodes, double *z);

#endif
