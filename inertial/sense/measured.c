// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/sense/measured.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/rng.h"
#include "inertial/sense/measured_private.h"

// Streams of random numbers: eight a channel (gyro x, y, z, accelerometer x, y, z), and one of the sampling.
enum { STREAM_NOISE = 0, STREAM_ONCE = 3, STREAMS = 8, STREAM_SAMPLING = 6 * STREAMS, FIRST_STREAM = 1000 };
enum { ONCE_BIAS, ONCE_SCALE, ONCE_CROSS };

#define RECTIFICATION_S 1.0 // time over which the mean square of vibration is taken

// What a step is measured in: the same for all sensors of a triad.
typedef struct conditions {
    double rate[3], force[3]; // the triad's own quantity, and the specific force
    double shake[3];          // mean square of the force about its mean, by axis
    const orr_thermal_state *thermal;
} conditions;

// One sensor, as it goes from step to step.
typedef struct channel {
    const orr_triad_errors *e;
    int axis;
    double bias, scale, cross[3]; // with what the seed drew
    double residue;
    orr_bandwidth bandwidth;
    orr_sensor_noise noise;
} channel;

static uint64_t stream_of(int axis, bool accel, int term)
{
    return (uint64_t)(FIRST_STREAM + STREAMS * (axis + (accel ? 3 : 0)) + term);
}

static channel channel_of(const orr_triad_errors *e, int axis, bool accel, uint64_t seed, double dt)
{
    channel c = {.e = e, .axis = axis};
    const uint64_t once = stream_of(axis, accel, STREAM_ONCE);
    c.bias = e->bias[axis] + e->bias_sigma * orr_rng_normal(seed, once, ONCE_BIAS);
    c.scale = e->scale[axis] + e->scale_sigma * orr_rng_normal(seed, once, ONCE_SCALE);
    for (int k = 0; k < 3; k++)
        c.cross[k] = k == axis ? 1.0
                               : e->cross[axis][k] +
                                     e->cross_sigma * orr_rng_normal(seed, once, (uint64_t)(ONCE_CROSS + k));
    c.bandwidth = orr_bandwidth_begin(e, dt);
    c.noise = orr_sensor_noise_begin(e, axis, dt, seed, stream_of(axis, accel, STREAM_NOISE));
    return c;
}

// What the sensor would give for these conditions if they lasted.
static double steady(const channel *c, const conditions *q, bool gyro)
{
    const orr_triad_errors *e = c->e;
    const int i = c->axis;
    const double warm = q->thermal->celsius - q->thermal->profile->reference_c, *force = q->force;
    const double x = c->cross[0] * q->rate[0] + c->cross[1] * q->rate[1] + c->cross[2] * q->rate[2];
    double y = x * (1.0 + c->scale + e->scale_by_temperature[i] * warm) + e->asymmetry[i] * fabs(x) +
               e->quadratic[i] * x * x + e->cubic[i] * x * x * x + c->bias;
    y += (e->by_temperature[i] + e->by_temperature_squared[i] * warm) * warm +
         e->by_temperature_rate[i] * q->thermal->rate_cps + e->rectification[i] * q->shake[i];
    if (gyro)
        y += e->by_force[i][0] * force[0] + e->by_force[i][1] * force[1] + e->by_force[i][2] * force[2] +
             e->by_force_squared[i] * force[i] * force[i];
    return y;
}

// The mean square of the force about its mean, both fading with RECTIFICATION_S.
typedef struct shaking {
    bool begun;
    double mean[3], square[3], forget;
} shaking;

static void shake(shaking *s, const double force[3])
{
    for (int i = 0; i < 3; i++) {
        if (!s->begun) s->mean[i] = force[i];
        const double d = force[i] - s->mean[i];
        s->mean[i] += s->forget * d;
        s->square[i] += s->forget * (d * d - s->square[i]);
    }
    s->begun = true;
}

static void components(orr_vec3 v, double out[3])
{
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}

// Everything but noises, limits and quantisation.
static void respond(const orr_imu_errors *errors, channel c[6], orr_imu *imu)
{
    const double dt = 1.0 / imu->rate_hz, fast = errors->vibration_mps2 * errors->vibration_mps2;
    const bool arms = orr_size_effect_any(&errors->accel);
    orr_thermal_state thermal = orr_thermal_begin(&errors->temperature);
    shaking shaken = {.forget = -expm1(-dt / RECTIFICATION_S)};
    for (size_t j = 0; j < imu->n; j++) {
        conditions gyro = {.thermal = &thermal}, accel = {.thermal = &thermal};
        double add[3] = {0, 0, 0}, out[6];
        if (arms) orr_size_effect(&errors->accel, imu, j, add);
        components(orr_vec3_scale(imu->rate_hz, imu->dtheta_rad[j]), gyro.rate);
        components(orr_vec3_scale(imu->rate_hz, imu->dv_mps[j]), gyro.force);
        orr_thermal_advance(&thermal, dt);
        shake(&shaken, gyro.force);
        for (int i = 0; i < 3; i++) {
            gyro.shake[i] = accel.shake[i] = shaken.square[i] + fast;
            accel.rate[i] = gyro.force[i] + add[i] * imu->rate_hz;
            accel.force[i] = gyro.force[i];
        }
        for (int k = 0; k < 6; k++)
            out[k] =
                orr_bandwidth_step(&c[k].bandwidth, steady(&c[k], k < 3 ? &gyro : &accel, k < 3) * dt, dt);
        imu->measured_dtheta_rad[j] = orr_vec3_make(out[0], out[1], out[2]);
        imu->measured_dv_mps[j] = orr_vec3_make(out[3], out[4], out[5]);
    }
}

// Noise, limit and quantisation of one increment.
static double read_out(channel *c, double x, size_t j, double dt, bool *cut)
{
    const double most = c->e->limit * dt, quantum = c->e->quantum;
    x += orr_sensor_noise_step(&c->noise, j);
    if (most > 0.0 && fabs(x) > most) {
        x = x > 0.0 ? most : -most;
        *cut = true;
    }
    if (quantum > 0.0) {
        const double whole = quantum * nearbyint((x + c->residue) / quantum);
        c->residue += x - whole;
        x = whole;
    }
    return x;
}

static orr_status check_triad(const orr_triad_errors *e, const char *what, orr_diag *diag)
{
    bool fine = e->bias_sigma >= 0.0 && e->scale_sigma >= 0.0 && e->cross_sigma >= 0.0 && e->limit >= 0.0 &&
                e->quantum >= 0.0 && e->bandwidth_hz >= 0.0 && e->damping >= 0.0;
    for (int i = 0; i < 3; i++) fine = fine && e->white[i] >= 0.0 && e->walk[i] >= 0.0;
    if (!fine)
        return orr_diag_set(diag, ORR_E_ARG,
                            "a standard deviation, a noise, a bandwidth or a limit of the %s is negative",
                            what);
    if (e->n_processes > ORR_ERRORS_MAX_PROCESSES)
        return orr_diag_set(diag, ORR_E_ARG, "%zu Gauss-Markov processes of the %s; %d are possible",
                            e->n_processes, what, ORR_ERRORS_MAX_PROCESSES);
    for (size_t p = 0; p < e->n_processes; p++)
        if (!(e->process[p].correlation_s > 0.0) || !(e->process[p].sigma >= 0.0))
            return orr_diag_set(diag, ORR_E_ARG,
                                "Gauss-Markov process %zu of the %s needs a correlation time above 0 and a "
                                "standard deviation "
                                "that is not negative",
                                p + 1, what);
    return ORR_OK;
}

static orr_status check(const orr_imu_errors *e, const orr_imu *imu, orr_diag *diag)
{
    const double duration_s = (double)imu->n / imu->rate_hz;
    orr_status s = check_triad(&e->gyro, "gyros", diag);
    if (s == ORR_OK) s = check_triad(&e->accel, "accelerometers", diag);
    if (s == ORR_OK) s = orr_temperature_check(&e->temperature, duration_s, diag);
    if (s != ORR_OK) return s;
    if (!(e->vibration_mps2 >= 0.0))
        return orr_diag_set(diag, ORR_E_ARG, "a vibration of %g m/s^2 r.m.s.; it cannot be negative",
                            e->vibration_mps2);
    if (!(e->delay_s >= 0.0 && e->jitter_s >= 0.0 && e->delay_s + 8.0 * e->jitter_s < duration_s))
        return orr_diag_set(
            diag, ORR_E_ARG,
            "a sampling delay of %g s and a jitter of %g s; they cannot be negative, nor as long as the run",
            e->delay_s, e->jitter_s);
    return ORR_OK;
}

static orr_status make_room(orr_imu *imu, orr_diag *diag)
{
    if (imu->measured_dtheta_rad == NULL)
        imu->measured_dtheta_rad = malloc(imu->n * sizeof *imu->measured_dtheta_rad);
    if (imu->measured_dv_mps == NULL) imu->measured_dv_mps = malloc(imu->n * sizeof *imu->measured_dv_mps);
    if (imu->measured_dtheta_rad == NULL || imu->measured_dv_mps == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu inertial samples", imu->n);
    return ORR_OK;
}

orr_status orr_imu_add_errors(const orr_imu_errors *errors, orr_imu *imu, orr_errors_report *report,
                              orr_diag *diag)
{
    orr_status s = check(errors, imu, diag);
    if (s == ORR_OK) s = make_room(imu, diag);
    if (s != ORR_OK) return s;
    const double dt = 1.0 / imu->rate_hz;
    channel c[6];
    for (int k = 0; k < 6; k++)
        c[k] = channel_of(k < 3 ? &errors->gyro : &errors->accel, k % 3, k >= 3, errors->seed, dt);
    respond(errors, c, imu);
    s = orr_sampling_shift(errors, FIRST_STREAM + STREAM_SAMPLING, imu, diag);
    if (s != ORR_OK) return s;
    orr_errors_report cut = {{0, 0}};
    for (size_t j = 0; j < imu->n; j++) {
        double v[6];
        bool at_limit[2] = {false, false};
        components(imu->measured_dtheta_rad[j], v);
        components(imu->measured_dv_mps[j], v + 3);
        for (int k = 0; k < 6; k++) v[k] = read_out(&c[k], v[k], j, dt, &at_limit[k / 3]);
        imu->measured_dtheta_rad[j] = orr_vec3_make(v[0], v[1], v[2]);
        imu->measured_dv_mps[j] = orr_vec3_make(v[3], v[4], v[5]);
        for (int t = 0; t < 2; t++) cut.saturated[t] += at_limit[t];
    }
    if (report != NULL) *report = cut;
    for (int t = 0; t < 2; t++)
        if (cut.saturated[t] == imu->n)
            return orr_diag_set(
                diag, ORR_E_ARG, "the %s are at their limit of %g %s throughout: they measure nothing",
                t == 0 ? "gyros" : "accelerometers", t == 0 ? errors->gyro.limit : errors->accel.limit,
                t == 0 ? "rad/s" : "m/s^2");
    return ORR_OK;
}
