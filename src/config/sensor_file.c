// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/sensor_file.h"

#include <string.h>

#include "src/config/rows_private.h"

// Keys of both triads, with the units of either.
#define REAL(n, m, u, h) REAL_ROW(orr_error_triad, n, m, 0, 1e12, u, "0", NULL, h)
#define REALS(n, m, u, h) REALS_ROW(orr_error_triad, n, m, u, NULL, h)

static const orr_condition of_bandwidth[] = {{.key = "bandwidth"}, {0}};

static const orr_key gyro_process_rows[] = {
    NEEDED_REAL_ROW(orr_error_process, "sigma", sigma, 0, 1e12, "deg/h", NULL, "standard deviation"),
    NEEDED_REAL_ROW(orr_error_process, "time", time_s, 1e-6, 1e12, "s", NULL, "correlation time"),
};
static const orr_schema gyro_process_table = ORR_SCHEMA(gyro_process_rows, orr_error_process);

// Coefficients of temperature: `r` and `s` are the units of bias and scale.
#define TEMPERATURE_ROWS(r)                                                                                  \
    REALS_ROW(orr_error_temperature, "bias", bias, r "/K", NULL, "bias off the reference temperature"),      \
        REALS_ROW(orr_error_temperature, "bias2", bias2, r "/K2", NULL, "of the square of that"),            \
        REALS_ROW(orr_error_temperature, "rate", rate, r "/(K/min)", NULL,                                   \
                  "bias while temperature changes"),                                                         \
        REALS_ROW(orr_error_temperature, "scale", scale, "ppm/K", NULL, "scale factor error")
static const orr_key gyro_temperature_rows[] = {TEMPERATURE_ROWS("deg/h")};
static const orr_schema gyro_temperature_table = ORR_SCHEMA(gyro_temperature_rows, orr_error_temperature);
static const orr_key accel_temperature_rows[] = {TEMPERATURE_ROWS("ug")};
static const orr_schema accel_temperature_table = ORR_SCHEMA(accel_temperature_rows, orr_error_temperature);

static const orr_key gyro_rows[] = {
    REALS("bias", bias, "deg/h", "constant"),
    REAL("bias_sigma", bias_sigma, "deg/h", "standard deviation of a constant that the seed draws"),
    MAPS_ROW(orr_error_triad, "instability", instability, &gyro_process_table,
             ORR_SENSOR_ERRORS_MAX_PROCESSES, NULL, "Gauss-Markov processes of the bias"),
    REALS("white", white, "deg/sqrt(h)", "angle random walk N"),
    REALS("walk", walk, "deg/h/sqrt(h)", "rate random walk K"),
    REALS("ramp", ramp, "deg/h/h", "rate ramp R"),
    REALS("scale", scale, "ppm", "scale factor error"),
    REAL("scale_sigma", scale_sigma, "ppm", "standard deviation of one that the seed draws"),
    REALS("asymmetry", asymmetry, "ppm", "half the difference of the scale factors above and below zero"),
    REALS("quadratic", quadratic, "ppm/(deg/s)", "of the rate's square"),
    REALS("cubic", cubic, "ppm/(deg/s)2", "of its cube"),
    REALS("misalignment", misalignment, "arcsec",
          "what axis x sees of y, x of z, y of x, y of z, z of x, z of y; one value for all"),
    REAL("misalignment_sigma", misalignment_sigma, "arcsec", "standard deviation of six that the seed draws"),
    REALS("g_sensitivity", by_force, "deg/h/g",
          "along the own axis, one value or three; or all nine, row by row"),
    REALS("g2_sensitivity", by_force_squared, "deg/h/g2", "of the square of the force along the own axis"),
    REALS("rectification", rectification, "deg/h/g2", "bias per mean square of vibration along the own axis"),
    MAP_ROW(orr_error_triad, "temperature", temperature, &gyro_temperature_table, NULL,
            "coefficients of temperature"),
    REAL("bandwidth", bandwidth_hz, "Hz",
         "of a second-order response, where it is down by 3 dB; 0: no limit"),
    REAL_ROW(orr_error_triad, "damping", damping, 0.05, 20, "1", "0.7071067811865476", of_bandwidth,
             "of that response"),
    REAL("limit", limit, "deg/s", "greatest rate that comes out; 0: none"),
    REAL("quantum", quantum, "arcsec", "of the increments, what is left over carried on; 0: none"),
};

static const orr_key accel_process_rows[] = {
    NEEDED_REAL_ROW(orr_error_process, "sigma", sigma, 0, 1e12, "ug", NULL, "standard deviation"),
    NEEDED_REAL_ROW(orr_error_process, "time", time_s, 1e-6, 1e12, "s", NULL, "correlation time"),
};
static const orr_schema accel_process_table = ORR_SCHEMA(accel_process_rows, orr_error_process);

static const orr_key accel_rows[] = {
    REALS("bias", bias, "ug", "constant"),
    REAL("bias_sigma", bias_sigma, "ug", "standard deviation of a constant that the seed draws"),
    MAPS_ROW(orr_error_triad, "instability", instability, &accel_process_table,
             ORR_SENSOR_ERRORS_MAX_PROCESSES, NULL, "Gauss-Markov processes of the bias"),
    REALS("white", white, "ug/sqrt(Hz)", "velocity random walk N"),
    REALS("walk", walk, "ug/sqrt(h)", "random walk K of the bias"),
    REALS("ramp", ramp, "ug/h", "ramp R"),
    REALS("scale", scale, "ppm", "scale factor error"),
    REAL("scale_sigma", scale_sigma, "ppm", "standard deviation of one that the seed draws"),
    REALS("asymmetry", asymmetry, "ppm", "half the difference of the scale factors above and below zero"),
    REALS("quadratic", quadratic, "ug/g2", "of the force's square"),
    REALS("cubic", cubic, "ug/g3", "of its cube"),
    REALS("misalignment", misalignment, "arcsec",
          "what axis x sees of y, x of z, y of x, y of z, z of x, z of y; one value for all"),
    REAL("misalignment_sigma", misalignment_sigma, "arcsec", "standard deviation of six that the seed draws"),
    REALS("rectification", rectification, "ug/g2", "bias per mean square of vibration along the own axis"),
    MAP_ROW(orr_error_triad, "temperature", temperature, &accel_temperature_table, NULL,
            "coefficients of temperature"),
    REALS("arms", arms, "mm",
          "places of the three in the unit (right, forward, up): x y z of that of axis x, of y, of z"),
    REAL("bandwidth", bandwidth_hz, "Hz",
         "of a second-order response, where it is down by 3 dB; 0: no limit"),
    REAL_ROW(orr_error_triad, "damping", damping, 0.05, 20, "1", "0.7071067811865476", of_bandwidth,
             "of that response"),
    REAL("limit", limit, "g", "greatest force that comes out; 0: none"),
    REAL("quantum", quantum, "um/s", "of the increments, what is left over carried on; 0: none"),
};

static const char *check_triad(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_error_triad *t = map;
    const struct {
        const char *name;
        size_t n, other;
    } list[] = {{"bias", t->bias.n, 3},
                {"white", t->white.n, 3},
                {"walk", t->walk.n, 3},
                {"rectification", t->rectification.n, 3},
                {"ramp", t->ramp.n, 3},
                {"scale", t->scale.n, 3},
                {"asymmetry", t->asymmetry.n, 3},
                {"quadratic", t->quadratic.n, 3},
                {"cubic", t->cubic.n, 3},
                {"misalignment", t->misalignment.n, 6},
                {"g2_sensitivity", t->by_force_squared.n, 3}};
    for (size_t k = 0; k < sizeof list / sizeof list[0]; k++)
        if (list[k].n > 1 && list[k].n != list[k].other) {
            snprintf(why, ORR_SCHEMA_WHY, "%zu values; one for all, or %zu", list[k].n, list[k].other);
            return list[k].name;
        }
    const orr_real_list *const noises[] = {&t->white, &t->walk};
    for (size_t k = 0; k < 2; k++)
        for (size_t i = 0; i < noises[k]->n; i++)
            if (noises[k]->item[i] < 0.0) {
                snprintf(why, ORR_SCHEMA_WHY, "%g; a noise cannot be negative", noises[k]->item[i]);
                return k == 0 ? "white" : "walk";
            }
    const orr_real_list *const warm[] = {&t->temperature.bias, &t->temperature.bias2, &t->temperature.rate,
                                         &t->temperature.scale};
    for (size_t k = 0; k < sizeof warm / sizeof warm[0]; k++)
        if (warm[k]->n > 1 && warm[k]->n != 3) {
            snprintf(why, ORR_SCHEMA_WHY, "%zu values of a coefficient; one for all axes, or three",
                     warm[k]->n);
            return "temperature";
        }
    if (t->arms.n != 0 && t->arms.n != 9) {
        snprintf(why, ORR_SCHEMA_WHY, "%zu values; nine are wanted, three an accelerometer", t->arms.n);
        return "arms";
    }
    if (t->by_force.n <= 1 || t->by_force.n == 3 || t->by_force.n == 9) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "%zu values; one for all axes, three or nine", t->by_force.n);
    return "g_sensitivity";
}

static const orr_schema gyro_table = {.key = gyro_rows,
                                      .n = sizeof gyro_rows / sizeof gyro_rows[0],
                                      .size = sizeof(orr_error_triad),
                                      .check = check_triad};
static const orr_schema accel_table = {.key = accel_rows,
                                       .n = sizeof accel_rows / sizeof accel_rows[0],
                                       .size = sizeof(orr_error_triad),
                                       .check = check_triad};

static const orr_key profile_rows[] = {
    REALS_ROW(orr_error_profile, "times", times_s, "s", NULL,
              "after the begin of the readings, ascending, over all of them"),
    REALS_ROW(orr_error_profile, "values", values_c, "degC", NULL,
              "temperature about the unit, linear between"),
    REAL_ROW(orr_error_profile, "reference", reference_c, -273.15, 1000, "degC", "20", NULL,
             "temperature at which coefficients have no effect"),
    REAL_ROW(orr_error_profile, "lag", lag_s, 0, 1e6, "s", "0", NULL,
             "time constant by which the sensors follow"),
};

static const char *check_profile(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_error_profile *p = map;
    if (p->times_s.n == p->values_c.n) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "%zu times and %zu values; there have to be as many of each", p->times_s.n,
             p->values_c.n);
    return "";
}
static const orr_schema profile_table = {.key = profile_rows,
                                         .n = sizeof profile_rows / sizeof profile_rows[0],
                                         .size = sizeof(orr_error_profile),
                                         .check = check_profile};

static const orr_key rows[] = {
    TEXT_ROW(orr_sensor_errors, "title", title, NULL, "which sensors these are"),
    TEXT_ROW(orr_sensor_errors, "source", source, NULL, "where the numbers are from"),
    INT_ROW(orr_sensor_errors, "seed", seed, 0, 9e15, "1", NULL, "of everything random"),
    MAP_ROW(orr_sensor_errors, "temperature", temperature, &profile_table, NULL,
            "temperature over the run; without it all is at the reference"),
    REAL_ROW(orr_sensor_errors, "vibration", vibration_g, 0, 1000, "g", "0", NULL,
             "r.m.s. of the vibration along each axis that is too fast for the readings; rectification makes "
             "a bias of it"),
    REAL_ROW(orr_sensor_errors, "delay", delay_ms, 0, 1e6, "ms", "0", NULL,
             "readings belong to steps so much earlier"),
    REAL_ROW(orr_sensor_errors, "jitter", jitter_us, 0, 1e9, "us", "0", NULL,
             "standard deviation of the instants of sampling"),
    MAP_ROW(orr_sensor_errors, "gyro", gyro, &gyro_table, NULL, "errors of the gyros"),
    MAP_ROW(orr_sensor_errors, "accelerometer", accelerometer, &accel_table, NULL,
            "errors of the accelerometers"),
};
static const orr_schema schema = {.key = rows,
                                  .n = sizeof rows / sizeof rows[0],
                                  .size = sizeof(orr_sensor_errors),
                                  .hint = "docs/inertial.md, section Sensor errors, lists all"};

orr_status orr_sensor_errors_parse(const char *name, const char *text, size_t n, orr_sensor_errors *out,
                                   orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_yaml y;
    orr_status s = orr_yaml_parse(name, text, n, &y, diag);
    if (s != ORR_OK) return s;
    s = orr_schema_read(&schema, &y, NULL, NULL, out, diag);
    orr_yaml_free(&y);
    return s;
}

void orr_sensor_errors_free(orr_sensor_errors *e) { orr_schema_free(&schema, e); }
