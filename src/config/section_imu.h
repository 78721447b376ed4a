// SPDX-License-Identifier: GPL-3.0-or-later
// Section `imu`: how the inertial readings are made.
#ifndef ORR_CONFIG_SECTION_IMU_H
#define ORR_CONFIG_SECTION_IMU_H

#include "src/config/schema.h"

#define ORR_IMU_APPROACHES(X)                                                                                \
    X(ORR_IMU_MATCHED, "1", "readings matched to a one-step navigator")                                      \
    X(ORR_IMU_PHYSICAL, "2", "integrals of the true rate and force, as physical sensors give them")
#define ORR_IMU_FRAMES(X)                                                                                    \
    X(ORR_IMU_INERTIAL, "inertial", "inertial axes")                                                         \
    X(ORR_IMU_GEOGRAPHIC, "geographic", "East, North, Up")                                                   \
    X(ORR_IMU_BODY, "body", "body axes")
#define ORR_IMU_PROJECTIONS(X)                                                                               \
    X(ORR_IMU_MID, "mid", "matrices of the middle of the step")                                              \
    X(ORR_IMU_START, "start", "matrices of the step's begin")
#define ORR_IMU_LOOPS(X)                                                                                     \
    X(ORR_IMU_CLOSED, "closed", "the generator carries the navigator's state")                               \
    X(ORR_IMU_OPEN, "open", "the generator carries the true state")
#define ORR_IMU_QUADRATURES(X)                                                                               \
    X(ORR_IMU_GAUSS, "gauss", "Gauss-Legendre nodes")                                                        \
    X(ORR_IMU_RIEMANN, "riemann", "rectangles")

#define ORR_IMU_SERVED(X)                                                                                    \
    X(ORR_IMU_SERVE_MEASURED, "measured", "what the sensors measure, with their errors")                     \
    X(ORR_IMU_SERVE_IDEAL, "ideal", "without errors")

typedef enum orr_imu_served_word { ORR_IMU_SERVED(ORR_CHOICE_VALUE) } orr_imu_served_word;
typedef enum orr_imu_approach_word { ORR_IMU_APPROACHES(ORR_CHOICE_VALUE) } orr_imu_approach_word;
typedef enum orr_imu_frame_word { ORR_IMU_FRAMES(ORR_CHOICE_VALUE) } orr_imu_frame_word;
typedef enum orr_imu_projection_word { ORR_IMU_PROJECTIONS(ORR_CHOICE_VALUE) } orr_imu_projection_word;
typedef enum orr_imu_loop_word { ORR_IMU_LOOPS(ORR_CHOICE_VALUE) } orr_imu_loop_word;
typedef enum orr_imu_quadrature_word { ORR_IMU_QUADRATURES(ORR_CHOICE_VALUE) } orr_imu_quadrature_word;

typedef struct orr_scenario_imu {
    double rate_hz;
    int approach, frame, projection, loop, quadrature; // the enums above
    int64_t order;                                     // 0: as many as the rate asks for
    char *errors;                                      // file of the sensors' errors; NULL: none
    int served;                                        // orr_imu_served_word; of use with errors
} orr_scenario_imu;

extern const orr_schema orr_section_imu;

#endif
