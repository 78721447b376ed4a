// SPDX-License-Identifier: GPL-3.0-or-later
// Flights that several tests of the inertial room share.
#ifndef ORR_TESTS_INERTIAL_FLIGHTS_H
#define ORR_TESTS_INERTIAL_FLIGHTS_H

#include "inertial/motion/flight_plan.h"

// Six survey lines of 30 km with turbulence and attitude oscillation; about 54 minutes.
static inline orr_flight_plan test_survey(double lat_deg, double lon_deg)
{
    orr_flight_plan p = orr_flight_plan_default();
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

#endif
