// SPDX-License-Identifier: GPL-3.0-or-later
// The least value of a function of a few unknowns whose derivatives are not known, by the simplex method of Nelder and
// Mead (GSL below it).
#ifndef ORR_CORE_MINIMISE_H
#define ORR_CORE_MINIMISE_H

#include "core/status.h"

#define ORR_MINIMISE_MOST 16 // unknowns

// The function: a finite number, or infinity where it has no value.
typedef double (*orr_function_of_many)(const double *x, void *user);

// Finds a minimum near a starting point.
// Given:
//   f, user    the function and its argument
//   n          unknowns, 1 to ORR_MINIMISE_MOST
//   x          [n] where to start
//   step       [n] size of the first simplex along each unknown, not 0
//   tolerance  stop when the simplex is smaller than this (mean distance of its corners from their centre)
//   most       stop after so many rounds
// Returned:
//   x          [n] the best point that was met
//   value      of the function there; may be NULL
// Errors: ORR_E_ARG (n), ORR_E_MEMORY. That `most` was reached is none.
orr_status orr_minimise(orr_function_of_many f, void *user, size_t n, double *x, const double *step,
                        double tolerance, int most, double *value);

#endif
