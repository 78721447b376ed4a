// SPDX-License-Identifier: GPL-3.0-or-later
// Modes of the error equations at rest: eigenvalues of their matrix, and the periods that navigation is known by.
#ifndef ORR_INERTIAL_STUDY_ERROR_MODES_H
#define ORR_INERTIAL_STUDY_ERROR_MODES_H

#include "inertial/study/error_equations.h"

#define ORR_ERROR_STATES 9

typedef struct orr_error_modes {
    size_t n;                                              // 9, or 7 with a held vertical channel
    double real[ORR_ERROR_STATES], imag[ORR_ERROR_STATES]; // 1/s, by descending imaginary part
    double schuler_s;                                      // period of the mean of the two fast pairs
    double foucault_s; // of half their difference: how the plane of the swing turns; NAN at the equator
    double earth_s;    // of the slow pair: a sidereal day
    double growth_s;   // time in which a free vertical channel grows by e; NAN where it is held
} orr_error_modes;

// Modes of a point at rest.
//   Given:    p               of a body at rest
//             hold_vertical   height and vertical velocity are the true ones
//   Returned: out             eigenvalues and periods
//   Notes:    ORR_E_NUMERIC where no eigenvalues are found or no three pairs of them swing.
orr_status orr_error_modes_at(const orr_error_point *p, bool hold_vertical, orr_error_modes *out,
                              orr_diag *diag);

#endif
