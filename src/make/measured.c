// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/measured.h"

#include <math.h>
#include <string.h>

#define G_MPS2 9.80665
#define HOUR_S 3600.0
#define PPM 1e-6

static const double DEG = ORR_RAD_PER_DEG, ARCSEC = ORR_RAD_PER_DEG / 3600.0;

// One value for all axes, or a value each.
static void fill(double to[3], const orr_real_list *from, double unit)
{
    for (size_t k = 0; k < 3; k++) to[k] = from->n == 0 ? 0.0 : from->item[from->n == 1 ? 0 : k] * unit;
}

// What gyros and accelerometers have in common; `rate` is the unit of biases, `noise` that of the white noise.
static orr_triad_errors triad(const orr_error_triad *t, double rate, double noise)
{
    orr_triad_errors e;
    memset(&e, 0, sizeof e);
    fill(e.bias, &t->bias, rate);
    fill(e.ramp, &t->ramp, rate / HOUR_S);
    fill(e.scale, &t->scale, PPM);
    fill(e.asymmetry, &t->asymmetry, PPM);
    e.bias_sigma = t->bias_sigma * rate;
    fill(e.white, &t->white, noise);
    fill(e.walk, &t->walk, rate / sqrt(HOUR_S));
    fill(e.rectification, &t->rectification, rate / (G_MPS2 * G_MPS2));
    fill(e.by_temperature, &t->temperature.bias, rate);
    fill(e.by_temperature_squared, &t->temperature.bias2, rate);
    fill(e.by_temperature_rate, &t->temperature.rate, rate * 60.0);
    fill(e.scale_by_temperature, &t->temperature.scale, PPM);
    e.bandwidth_hz = t->bandwidth_hz;
    e.damping = t->damping;
    e.scale_sigma = t->scale_sigma * PPM;
    e.cross_sigma = t->misalignment_sigma * ARCSEC;
    static const int of[6][2] = {{0, 1}, {0, 2}, {1, 0}, {1, 2}, {2, 0}, {2, 1}};
    for (size_t k = 0; k < 6 && t->misalignment.n > 0; k++)
        e.cross[of[k][0]][of[k][1]] = t->misalignment.item[t->misalignment.n == 1 ? 0 : k] * ARCSEC;
    e.n_processes = t->instability.n;
    for (size_t k = 0; k < e.n_processes; k++)
        e.process[k] = (orr_gauss_markov){t->instability.item[k].sigma * rate, t->instability.item[k].time_s};
    return e;
}

orr_imu_errors orr_errors_of(const orr_sensor_errors *file)
{
    const orr_error_triad *g = &file->gyro, *a = &file->accelerometer;
    const double per_hour = DEG / HOUR_S, ug = 1e-6 * G_MPS2;
    orr_imu_errors e = {.gyro = triad(g, per_hour, DEG / sqrt(HOUR_S)),
                        .accel = triad(a, ug, ug),
                        .seed = (uint64_t)file->seed,
                        .temperature = {.n = file->temperature.times_s.n,
                                        .t_s = file->temperature.times_s.item,
                                        .celsius = file->temperature.values_c.item,
                                        .reference_c = file->temperature.reference_c,
                                        .lag_s = file->temperature.lag_s},
                        .vibration_mps2 = file->vibration_g * G_MPS2,
                        .delay_s = file->delay_ms * 1e-3,
                        .jitter_s = file->jitter_us * 1e-6};
    fill(e.gyro.quadratic, &g->quadratic, PPM / DEG);
    fill(e.gyro.cubic, &g->cubic, PPM / (DEG * DEG));
    fill(e.gyro.by_force_squared, &g->by_force_squared, per_hour / (G_MPS2 * G_MPS2));
    for (size_t i = 0; i < 3 && g->by_force.n > 0; i++)
        for (size_t k = 0; k < 3; k++)
            if (g->by_force.n == 9 || i == k)
                e.gyro.by_force[i][k] = g->by_force.item[g->by_force.n == 9   ? 3 * i + k
                                                         : g->by_force.n == 3 ? i
                                                                              : 0] *
                                        per_hour / G_MPS2;
    e.gyro.limit = g->limit * DEG;
    e.gyro.quantum = g->quantum * ARCSEC;
    fill(e.accel.quadratic, &a->quadratic, ug / (G_MPS2 * G_MPS2));
    fill(e.accel.cubic, &a->cubic, ug / (G_MPS2 * G_MPS2 * G_MPS2));
    for (size_t k = 0; k < a->arms.n; k++) e.accel.arm_m[k / 3][k % 3] = a->arms.item[k] * 1e-3;
    e.accel.limit = a->limit * G_MPS2;
    e.accel.quantum = a->quantum * 1e-6;
    return e;
}

orr_status orr_errors_open(orr_inputs *inputs, const char *path, orr_sensor_errors *file, orr_imu_errors *out,
                           orr_diag *diag)
{
    orr_bytes raw;
    memset(file, 0, sizeof *file);
    orr_status s = orr_inputs_read_raw(inputs, path, 0, &raw, diag);
    if (s == ORR_OK) s = orr_sensor_errors_parse(path, raw.text, raw.n, file, diag);
    if (s == ORR_OK) *out = orr_errors_of(file);
    orr_bytes_free(&raw);
    return s;
}
