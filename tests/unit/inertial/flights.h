// SPDX-License-Identifier: GPL-3.0-or-later
// Flights that several tests of the inertial room share.
#ifndef ORR_TESTS_INERTIAL_FLIGHTS_H
#define ORR_TESTS_INERTIAL_FLIGHTS_H

#include <limits.h>

#include "inertial/motion/flight_plan.h"
#include "inertial/sense/sensors.h"

// Values of the scenario's keys where a plan says nothing.
static inline orr_flight_plan test_flight_plan(void)
{
    return (orr_flight_plan){.speed_mps = 60.0,
                             .bank_rad = 20.0 * ORR_RAD_PER_DEG,
                             .climb_limit_mps = 5.0,
                             .acceleration_mps2 = 2.0,
                             .lead_m = 1000.0,
                             .smoothing_s = 2.5,
                             .seed = 1,
                             .knot_step_s = 0.2};
}

// Six survey lines of 30 km with turbulence and attitude oscillation; about 54 minutes.
static inline orr_flight_plan test_survey(double lat_deg, double lon_deg)
{
    orr_flight_plan p = test_flight_plan();
    p.survey = (orr_survey){.start = {lat_deg * ORR_RAD_PER_DEG, lon_deg * ORR_RAD_PER_DEG, 1500.0},
                            .length_m = 30e3,
                            .spacing_m = 2e3,
                            .lines = 6};
    p.speed_mps = 70.0;
    p.pitch_rad = 0.03;
    p.knot_step_s = 0.5;
    p.wind_mps = (orr_spectrum){0.5, 0.02, 0.25, -5.0 / 3.0};
    p.heading_rad = p.pitch_osc_rad = p.roll_rad = (orr_spectrum){0.01, 0.03, 0.25, -1.0};
    return p;
}

// Integrals of rate and specific force over [from_s, to_s], at one go.
static inline void test_increment(const orr_trajectory *tr, const orr_gravity *g, orr_quadrature quadrature,
                                  int order, double from_s, double to_s, orr_vec3 *dtheta_rad,
                                  orr_vec3 *dv_mps)
{
    orr_sensors_sum sum = orr_sensors_sum_begin(tr, from_s, to_s);
    orr_sensors_sum_add(tr, g, quadrature, order, &sum, LONG_MAX);
    *dtheta_rad = sum.dtheta_rad;
    *dv_mps = sum.dv_mps;
}

#endif
