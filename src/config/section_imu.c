// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_imu.h"

#include "src/config/rows_private.h"

static const orr_condition of_1[] = {{.key = "approach", .words = "1"}, {0}};
static const orr_condition of_2[] = {{.key = "approach", .words = "2"}, {0}};

static const orr_condition of_errors[] = {{.key = "errors"}, {0}};

static const orr_choice served[] = {ORR_IMU_SERVED(ORR_CHOICE_WORD){0}};
static const orr_choice approaches[] = {ORR_IMU_APPROACHES(ORR_CHOICE_WORD){0}};
static const orr_choice frames[] = {ORR_IMU_FRAMES(ORR_CHOICE_WORD){0}};
static const orr_choice projections[] = {ORR_IMU_PROJECTIONS(ORR_CHOICE_WORD){0}};
static const orr_choice loops[] = {ORR_IMU_LOOPS(ORR_CHOICE_WORD){0}};
static const orr_choice quadratures[] = {ORR_IMU_QUADRATURES(ORR_CHOICE_WORD){0}};

static const orr_key rows[] = {
    REAL_ROW(orr_scenario_imu, "rate", rate_hz, 0.01, 100000, "Hz", "100", NULL,
             "rate of the inertial readings"),
    CHOICE_ROW(orr_scenario_imu, "approach", approach, approaches, "2", NULL, "how readings are made"),
    CHOICE_ROW(orr_scenario_imu, "frame", frame, frames, "inertial", of_1, "axes of the navigator"),
    CHOICE_ROW(orr_scenario_imu, "projection", projection, projections, "mid", of_1,
               "instant whose matrices the step projects with"),
    CHOICE_ROW(orr_scenario_imu, "loop", loop, loops, "closed", of_1, "state that the readings start from"),
    CHOICE_ROW(orr_scenario_imu, "quadrature", quadrature, quadratures, "gauss", of_2,
               "how rate and force are integrated over a step"),
    INT_ROW(orr_scenario_imu, "order", order, 0, 1000, "0", of_2,
            "nodes (1 to 5) or rectangles a step; 0: as many as the rate asks for"),
    FILE_ROW(orr_scenario_imu, "errors", errors, of_2,
             "errors of the sensors (samples/sensors); unit k draws with the file's seed + k"),
    CHOICE_ROW(orr_scenario_imu, "served", served, served, "measured", of_errors,
               "what the service answers; files of readings have both"),
};

static const char *check(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_imu *i = map;
    if (i->quadrature != ORR_IMU_GAUSS || i->order <= 5) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "%lld nodes; quadrature gauss has 1 to 5", (long long)i->order);
    return "order";
}

const orr_schema orr_section_imu = {
    .key = rows, .n = sizeof rows / sizeof rows[0], .size = sizeof(orr_scenario_imu), .check = check};
