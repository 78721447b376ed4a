// SPDX-License-Identifier: GPL-3.0-or-later
// A flight draped over terrain: heights and pitch of another trajectory follow waves over the ground.
#ifndef ORR_INERTIAL_MOTION_DRAPE_H
#define ORR_INERTIAL_MOTION_DRAPE_H

#include "inertial/motion/trajectory.h"

#define ORR_DRAPE_MAX_WAVES 16

// Height amplitude sin(2 pi s / wavelength + phase), s metres along the azimuth from the origin.
typedef struct orr_drape_wave {
    double amplitude_m, wavelength_m, azimuth_rad, phase_rad;
} orr_drape_wave;

// Heights are raised by the sum of the waves over each place, and the nose by the angle of the climb that this makes.
//   Given:    in            the flight, which need not outlive it
//             origin        where distances count from
//             wave, n       the waves, 1 to ORR_DRAPE_MAX_WAVES
//             step_s        of the quintic spline that is laid through the result
//   Returned: out           the draped flight; free with orr_trajectory_free
//             vertical_mps2 [2] least and greatest vertical acceleration; NULL: not wanted
//   Notes:    ORR_E_ARG, those of orr_trajectory_resample.
orr_status orr_trajectory_drape(const orr_trajectory *in, orr_geodetic origin, const orr_drape_wave *wave,
                                size_t n, double step_s, orr_trajectory *out, double *vertical_mps2,
                                orr_diag *diag);

#endif
