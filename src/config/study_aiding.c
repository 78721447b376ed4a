// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/study_aiding.h"

#include "src/config/rows_private.h"

// Rows of an output's error; T has the member `error`, u is its unit.
#define ERROR_ROWS(T, u)                                                                                     \
    REAL_ROW(T, "bias", error.bias, -1e12, 1e12, u, "0", NULL, "constant"),                                  \
        REAL_ROW(T, "bias_sigma", error.bias_sigma, 0, 1e12, u, "0", NULL,                                   \
                 "standard deviation of a constant that the seed draws"),                                    \
        REAL_ROW(T, "sigma", error.sigma, 0, 1e12, u, "0", NULL,                                             \
                 "standard deviation of a Gauss-Markov process"),                                            \
        REAL_ROW(T, "time", error.time_s, 1e-6, 1e12, "s", "100", NULL, "its correlation time"),             \
        REAL_ROW(T, "white", error.white, 0, 1e12, u, "0", NULL,                                             \
                 "standard deviation of white noise, of a sample")

static const orr_key barometer_rows[] = {
    ERROR_ROWS(orr_aiding_barometer, "m"),
    REAL_ROW(orr_aiding_barometer, "scale", scale_ppm, -1e6, 1e6, "ppm", "0", NULL,
             "of heights: air that is not as warm as the standard's"),
    REAL_ROW(orr_aiding_barometer, "lag", lag_s, 0, 1000, "s", "0", NULL, "of the pressure in its tube"),
};
static const orr_schema barometer_table = ORR_SCHEMA(barometer_rows, orr_aiding_barometer);

static const orr_key magnetometer_rows[] = {
    ERROR_ROWS(orr_aiding_magnetometer, "nT"),
    TEXT_ROW(orr_aiding_magnetometer, "model", model, NULL,
             "of GeographicLib, e.g. wmm2020; without it the dipole of IGRF-13"),
    {.name = "folder",
     .kind = ORR_KEY_FILE,
     .offset = offsetof(orr_aiding_magnetometer, folder),
     .help = "of the model's files; without it GeographicLib's own"},
    REALS_ROW(orr_aiding_magnetometer, "hard_iron", hard_nt, "nT", NULL,
              "field of the body: right, forward, up"),
    REALS_ROW(orr_aiding_magnetometer, "soft_iron", soft_ppm, "ppm", NULL,
              "what the body makes of the Earth's field: one value, three, or all nine, row by row"),
};

static const char *check_lengths(const orr_real_list *l, bool nine, const char *name,
                                 char why[ORR_SCHEMA_WHY])
{
    if (l->n == 0 || l->n == 3 || (nine && (l->n == 1 || l->n == 9))) return NULL;
    snprintf(why, ORR_SCHEMA_WHY,
             nine ? "%zu values; one, three or nine are wanted"
                  : "%zu values; three are wanted: right, forward, up",
             l->n);
    return name;
}

static const char *check_magnetometer(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_aiding_magnetometer *m = map;
    const char *wrong = check_lengths(&m->hard_nt, false, "hard_iron", why);
    return wrong != NULL ? wrong : check_lengths(&m->soft_ppm, true, "soft_iron", why);
}
static const orr_schema magnetometer_table = {.key = magnetometer_rows,
                                              .n = sizeof magnetometer_rows / sizeof magnetometer_rows[0],
                                              .size = sizeof(orr_aiding_magnetometer),
                                              .check = check_magnetometer};

static const orr_key odometer_rows[] = {
    ERROR_ROWS(orr_aiding_odometer, "m/s"),
    REALS_ROW(orr_aiding_odometer, "arm", arm_m, "m", NULL, "of the wheel: right, forward, up"),
    REAL_ROW(orr_aiding_odometer, "scale", scale_ppm, -1e6, 1e6, "ppm", "0", NULL, "of its radius"),
    REAL_ROW(orr_aiding_odometer, "quantum", quantum_m, 0, 1000, "m", "0", NULL, "of its pulses; 0: none"),
};
static const char *check_odometer(const void *map, char why[ORR_SCHEMA_WHY])
{
    return check_lengths(&((const orr_aiding_odometer *)map)->arm_m, false, "arm", why);
}
static const orr_schema odometer_table = {.key = odometer_rows,
                                          .n = sizeof odometer_rows / sizeof odometer_rows[0],
                                          .size = sizeof(orr_aiding_odometer),
                                          .check = check_odometer};

static const orr_key antennas_rows[] = {
    ERROR_ROWS(orr_aiding_antennas, "deg"),
    REALS_ROW(orr_aiding_antennas, "baseline", baseline_m, "m", NULL,
              "from the first antenna to the second: right, forward, up; 0, 1, 0 without it"),
    REAL_ROW(orr_aiding_antennas, "across", across_m, 0, 1000, "m", "0.005", NULL,
             "standard deviation of their relative position, horizontal, each axis"),
    REAL_ROW(orr_aiding_antennas, "up", up_m, 0, 1000, "m", "0.01", NULL, "vertical"),
};
static const char *check_antennas(const void *map, char why[ORR_SCHEMA_WHY])
{
    return check_lengths(&((const orr_aiding_antennas *)map)->baseline_m, false, "baseline", why);
}
static const orr_schema antennas_table = {.key = antennas_rows,
                                          .n = sizeof antennas_rows / sizeof antennas_rows[0],
                                          .size = sizeof(orr_aiding_antennas),
                                          .check = check_antennas};

static const orr_key receiver_rows[] = {
    FILE_ROW(orr_aiding_receiver, "orbit", orbit, NULL,
             "product of orbits; without it a nominal constellation (Walker 24/3/1)"),
    REALS_ROW(orr_aiding_receiver, "arm", arm_m, "m", NULL, "of the antenna: right, forward, up"),
    REAL_ROW(orr_aiding_receiver, "mask", mask_deg, -5, 80, "deg", "10", NULL, "least elevation"),
    REAL_ROW(orr_aiding_receiver, "range", range_m, 0, 1e6, "m", "1", NULL,
             "standard deviation of a range in the zenith, white; elsewhere over the sine of the elevation"),
    REAL_ROW(orr_aiding_receiver, "rate", rate_mps, 0, 1e6, "m/s", "0.05", NULL, "the same of a range rate"),
    REAL_ROW(orr_aiding_receiver, "sigma", sigma_m, 0, 1e6, "m", "0", NULL,
             "standard deviation of a Gauss-Markov process of each range in the zenith"),
    REAL_ROW(orr_aiding_receiver, "time", time_s, 1e-6, 1e12, "s", "100", NULL, "its correlation time"),
};
static const char *check_receiver(const void *map, char why[ORR_SCHEMA_WHY])
{
    return check_lengths(&((const orr_aiding_receiver *)map)->arm_m, false, "arm", why);
}
static const orr_schema receiver_table = {.key = receiver_rows,
                                          .n = sizeof receiver_rows / sizeof receiver_rows[0],
                                          .size = sizeof(orr_aiding_receiver),
                                          .check = check_receiver};

#define SENSOR_ROW(n, m, h)                                                                                  \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_MAP, .offset = offsetof(orr_study_aiding, m),                             \
        .given = offsetof(orr_study_aiding, has_##m), .map = &m##_table, .help = h                           \
    }

static const orr_key rows[] = {
    ORR_STUDY_HEAD(orr_study_aiding),
    {.name = "scenario",
     .kind = ORR_KEY_FILE,
     .required = true,
     .offset = offsetof(orr_study_aiding, scenario),
     .help = "whose trajectory it is"},
    INT_ROW(orr_study_aiding, "unit", unit, 0, 15, "0", NULL,
            "where the sensors are: a unit of the scenario"),
    {.name = "duration",
     .kind = ORR_KEY_DURATION,
     .offset = offsetof(orr_study_aiding, duration_ns),
     .help = "instead of the scenario's"},
    REAL_ROW(orr_study_aiding, "rate", rate_hz, 1e-4, 10000, "Hz", "1", NULL, "of the samples"),
    SENSOR_ROW("barometer", barometer, "height by pressure"),
    SENSOR_ROW("magnetometer", magnetometer, "field in body axes"),
    SENSOR_ROW("odometer", odometer, "speed and way forward"),
    SENSOR_ROW("antennas", antennas, "heading by two antennas"),
    SENSOR_ROW("receiver", receiver, "position and velocity of a satellite receiver"),
};

static const char *check(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_study_aiding *a = map;
    if (a->has_barometer || a->has_magnetometer || a->has_odometer || a->has_antennas || a->has_receiver)
        return NULL;
    snprintf(why, ORR_SCHEMA_WHY,
             "none of barometer, magnetometer, odometer, antennas and receiver is there");
    return "";
}

const orr_schema orr_study_aiding_schema = {.key = rows,
                                            .n = sizeof rows / sizeof rows[0],
                                            .size = sizeof(orr_study_aiding),
                                            .check = check,
                                            .hint = "'orrery aiding --help-study' lists all"};
