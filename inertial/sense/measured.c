// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/sense/measured.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/rng.h"

// Streams of random numbers: one a channel (gyro x, y, z, accelerometer x, y, z) and term.
enum {
    STREAM_WHITE,
    STREAM_WALK,
    STREAM_WITHIN,
    STREAM_ONCE,
    STREAM_PROCESS,
    STREAMS = STREAM_PROCESS + ORR_ERRORS_MAX_PROCESSES
};
enum { ONCE_BIAS, ONCE_SCALE, ONCE_CROSS };

// One sensor, as it goes from step to step.
typedef struct channel {
    const orr_triad_errors *e;
    int axis;
    uint64_t seed, stream;
    double bias, scale, cross[3]; // with what the seed drew
    double walk, residue;
    double process[ORR_ERRORS_MAX_PROCESSES];
} channel;

static double normal(const channel *c, int term, uint64_t k)
{
    return orr_rng_normal(c->seed, c->stream + (uint64_t)term, k);
}

static channel channel_of(const orr_triad_errors *e, int axis, bool accel, uint64_t seed)
{
    channel c = {
        .e = e, .axis = axis, .seed = seed, .stream = 1000u + (uint64_t)(STREAMS * (axis + (accel ? 3 : 0)))};
    c.bias = e->bias[axis] + e->bias_sigma * normal(&c, STREAM_ONCE, ONCE_BIAS);
    c.scale = e->scale[axis] + e->scale_sigma * normal(&c, STREAM_ONCE, ONCE_SCALE);
    for (int k = 0; k < 3; k++)
        c.cross[k] = k == axis ? 1.0
                               : e->cross[axis][k] +
                                     e->cross_sigma * normal(&c, STREAM_ONCE, (uint64_t)(ONCE_CROSS + k));
    for (size_t p = 0; p < e->n_processes; p++)
        c.process[p] = e->process[p].sigma * normal(&c, STREAM_PROCESS + (int)p, 0);
    return c;
}

// What the sensor would give for steady rates, without what varies in time.
static double steady(const channel *c, const double rate[3], const double force[3], bool gyro)
{
    const orr_triad_errors *e = c->e;
    int i = c->axis;
    double x = c->cross[0] * rate[0] + c->cross[1] * rate[1] + c->cross[2] * rate[2];
    double y = x * (1.0 + c->scale) + e->asymmetry[i] * fabs(x) + e->quadratic[i] * x * x +
               e->cubic[i] * x * x * x + c->bias;
    if (gyro)
        y += e->by_force[i][0] * force[0] + e->by_force[i][1] * force[1] + e->by_force[i][2] * force[2] +
             e->by_force_squared[i] * force[i] * force[i];
    return y;
}

// Integral over step j of what varies in time.
static double varying(channel *c, size_t j, double dt)
{
    const orr_triad_errors *e = c->e;
    double sum = e->ramp[c->axis] * ((double)j + 0.5) * dt * dt;
    if (e->white > 0.0) sum += e->white * sqrt(dt) * normal(c, STREAM_WHITE, j);
    if (e->walk > 0.0) {
        // The walk's end, and its integral about the chord: variance dt^3 / 12.
        double step = e->walk * sqrt(dt) * normal(c, STREAM_WALK, j);
        sum += (c->walk + 0.5 * step) * dt + e->walk * dt * sqrt(dt / 12.0) * normal(c, STREAM_WITHIN, j);
        c->walk += step;
    }
    for (size_t p = 0; p < e->n_processes; p++) {
        double phi = exp(-dt / e->process[p].correlation_s);
        double next = phi * c->process[p] + e->process[p].sigma * sqrt(1.0 - phi * phi) *
                                                normal(c, STREAM_PROCESS + (int)p, (uint64_t)j + 1);
        sum += 0.5 * dt * (c->process[p] + next);
        c->process[p] = next;
    }
    return sum;
}

static double measure(channel *c, const double rate[3], const double force[3], bool gyro, size_t j, double dt,
                      bool *cut)
{
    double x = steady(c, rate, force, gyro) * dt + varying(c, j, dt), most = c->e->limit * dt;
    if (c->e->limit > 0.0 && fabs(x) > most) {
        x = x > 0.0 ? most : -most;
        *cut = true;
    }
    if (c->e->quantum > 0.0) {
        double whole = c->e->quantum * nearbyint((x + c->residue) / c->e->quantum);
        c->residue += x - whole;
        x = whole;
    }
    return x;
}

static orr_status check(const orr_triad_errors *e, const char *what, orr_diag *diag)
{
    if (!(e->bias_sigma >= 0.0 && e->white >= 0.0 && e->walk >= 0.0 && e->scale_sigma >= 0.0 &&
          e->cross_sigma >= 0.0 && e->limit >= 0.0 && e->quantum >= 0.0))
        return orr_diag_set(diag, ORR_E_ARG, "a standard deviation, a noise or a limit of the %s is negative",
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

orr_status orr_imu_add_errors(const orr_imu_errors *errors, orr_imu *imu, orr_errors_report *report,
                              orr_diag *diag)
{
    orr_status s = check(&errors->gyro, "gyros", diag);
    if (s == ORR_OK) s = check(&errors->accel, "accelerometers", diag);
    if (s != ORR_OK) return s;
    if (imu->measured_dtheta_rad == NULL)
        imu->measured_dtheta_rad = malloc(imu->n * sizeof *imu->measured_dtheta_rad);
    if (imu->measured_dv_mps == NULL) imu->measured_dv_mps = malloc(imu->n * sizeof *imu->measured_dv_mps);
    if (imu->measured_dtheta_rad == NULL || imu->measured_dv_mps == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu inertial samples", imu->n);
    channel c[6];
    for (int k = 0; k < 6; k++)
        c[k] = channel_of(k < 3 ? &errors->gyro : &errors->accel, k % 3, k >= 3, errors->seed);
    const double dt = 1.0 / imu->rate_hz;
    orr_errors_report cut = {{0, 0}};
    for (size_t j = 0; j < imu->n; j++) {
        const orr_vec3 th = imu->dtheta_rad[j], dv = imu->dv_mps[j];
        const double rate[3] = {th.x / dt, th.y / dt, th.z / dt},
                     force[3] = {dv.x / dt, dv.y / dt, dv.z / dt};
        double out[6];
        bool at_limit[2] = {false, false};
        for (int k = 0; k < 6; k++)
            out[k] = measure(&c[k], k < 3 ? rate : force, force, k < 3, j, dt, &at_limit[k / 3]);
        imu->measured_dtheta_rad[j] = orr_vec3_make(out[0], out[1], out[2]);
        imu->measured_dv_mps[j] = orr_vec3_make(out[3], out[4], out[5]);
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
