// SPDX-License-Identifier: GPL-3.0-or-later
// Ideal gyros and accelerometers (the source's newtonometers) on a trajectory: what perfect instruments would give,
// instantaneous and as increments (Bogdanov 2015, section 2).
#ifndef ORR_INERTIAL_SENSE_SENSORS_H
#define ORR_INERTIAL_SENSE_SENSORS_H

#include "inertial/readings/imu.h"

#define ORR_IMU_MAX_ORDER 5 // Gauss-Legendre nodes
#define ORR_IMU_MAX_RECTANGLES 1000

// What the sensors read at an instant.
//   Given:    tr            trajectory, evaluated at
//             t_s           seconds after its t0
//             g             gravity; NULL: normal gravity
//   Returned: gyro_radps    absolute angular rate, body axes, rad/s
//             accel_mps2    specific force, body axes, m/s^2
//   Reference: Bogdanov 2015, eq. (15).
void orr_sensors_instant(const orr_trajectory *tr, const orr_gravity *g, double t_s, orr_vec3 *gyro_radps,
                         orr_vec3 *accel_mps2);

// Integrals of both over an interval, in pieces, for who must not be away for long: an interval of an hour has
// thousands. A piece is what lies between two knots, or a rectangle; the parts add up in the same order, to the same bits.
typedef struct orr_sensors_sum {
    double from_s, to_s, at_s, knot;
    long rectangle;
    orr_vec3 dtheta_rad,
        dv_mps; // so far, body axes: integral of the rate, rad, and of the specific force, m/s
} orr_sensors_sum;
// A sum over [from_s, to_s], s after the trajectory's t0, to which nothing has been added.
orr_sensors_sum orr_sensors_sum_begin(const orr_trajectory *tr, double from_s, double to_s);
// Adds pieces to a sum.
//   Given:    tr, g              trajectory and gravity
//             quadrature         Gauss-Legendre between the trajectory's knots (the interval is cut at each knot
//                                inside it), or the source's sum over rectangles, each of the value in its middle
//             order              nodes, 1 to ORR_IMU_MAX_ORDER, or rectangles of the whole interval
//                                (both the same in each call)
//             s                  the sum so far
//             pieces             how many at most
//   Returned: s                  the sum with these pieces; true if none is left to add
//   Reference: Bogdanov 2015, eq. (3), (4), (15).
bool orr_sensors_sum_add(const orr_trajectory *tr, const orr_gravity *g, orr_quadrature quadrature, int order,
                         orr_sensors_sum *s, long pieces);

typedef struct orr_imu_request {
    double begin_s, duration_s, rate_hz;
    orr_imu_mode mode;
    bool instantaneous; // instantaneous readings too
    const orr_gravity *gravity;
} orr_imu_request;

// A whole run with its truth. duration_s is cut down to a whole number of samples.
// Errors: ORR_E_ARG (rate, order, mode), ORR_E_RANGE (outside the trajectory), ORR_E_LIMIT, ORR_E_MEMORY;
// approach 1 in the geographic frame refuses places within 1 km of a pole (ORR_E_UNSUPPORTED).
orr_status orr_imu_generate(const orr_trajectory *tr, const orr_imu_request *request, orr_imu *out,
                            orr_diag *diag);

#endif
