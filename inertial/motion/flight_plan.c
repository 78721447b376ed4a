// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/motion/flight_plan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/rng.h"
#include "inertial/motion/flight_path.h"

#define G_MPS2 9.80665
#define HARMONICS 48
#define MARGIN 8 // knots sampled beyond both ends, so that the spline is as good there as inside
#define MAX_KNOTS 5000000.0
#define N_COLUMNS 12
#define SLOW_MPS 0.05 // a body slower than this has the course of its path, not of its velocity

// Adds `harmonics` of a spectrum to x[n], sampled every step_s. A velocity spectrum is integrated once to a
// displacement.
static void add_spectrum(const orr_spectrum *s, uint64_t seed, uint64_t stream, bool integrate,
                         double begin_s, double step_s, size_t n, double *x)
{
    if (!(s->rms > 0.0)) return;
    double f[HARMONICS], a[HARMONICS], power = 0.0, ratio = pow(s->high_hz / s->low_hz, 1.0 / HARMONICS);
    double edge = s->low_hz;
    for (int k = 0; k < HARMONICS; k++) {
        double next = edge * ratio;
        f[k] = edge + (next - edge) * orr_rng_uniform(seed, stream, (uint64_t)(2 * k));
        a[k] = sqrt(pow(f[k], s->slope) * (next - edge));
        power += 0.5 * a[k] * a[k];
        edge = next;
    }
    double scale = s->rms / sqrt(power);
    for (int k = 0; k < HARMONICS; k++) {
        double w = 2.0 * ORR_PI * f[k],
               phase = 2.0 * ORR_PI * orr_rng_uniform(seed, stream, (uint64_t)(2 * k + 1));
        double amplitude = scale * a[k] / (integrate ? w : 1.0);
        double cs = cos(w * step_s), sn = sin(w * step_s), c = 0.0, d = 0.0;
        for (size_t i = 0; i < n; i++) {
            if (i % 256 == 0) { // turning a phasor on is quick; its rounding is taken out now and then
                double at = w * (begin_s + step_s * (double)i) + phase;
                c = amplitude * cos(at);
                d = amplitude * sin(at);
            }
            x[i] += d;
            double t = c * cs - d * sn;
            d = d * cs + c * sn;
            c = t;
        }
    }
}

// Mean over `width` (odd) neighbours of each inner sample; the outer half-widths lose their meaning.
static void box(double *x, double *spare, size_t n, size_t width)
{
    size_t half = width / 2;
    if (n < width) return;
    memcpy(spare, x, n * sizeof *x);
    for (size_t i = half; i + half < n; i++) {
        // A fresh sum at intervals keeps the running one from gathering rounding.
        if ((i - half) % 64 == 0) {
            double sum = 0.0;
            for (size_t k = i - half; k <= i + half; k++) sum += spare[k];
            x[i] = sum / (double)width;
        } else {
            x[i] = x[i - 1] + (spare[i + half] - spare[i - half - 1]) / (double)width;
        }
    }
}

static orr_status check_spectrum(const orr_spectrum *s, const char *what, double knot_step_s, orr_diag *diag)
{
    if (s->rms == 0.0) return ORR_OK;
    if (!(s->rms > 0.0) || !(s->low_hz > 0.0) || !(s->high_hz > s->low_hz) || !isfinite(s->slope))
        return orr_diag_set(diag, ORR_E_ARG,
                            "%s needs a positive r.m.s. and a band from a low to a higher frequency", what);
    if (s->high_hz * knot_step_s > 0.25)
        return orr_diag_set(diag, ORR_E_ARG,
                            "%s goes up to %g Hz; knots every %g s follow %g Hz: take shorter knot steps",
                            what, s->high_hz, knot_step_s, 0.25 / knot_step_s);
    return ORR_OK;
}

typedef struct samples {
    size_t n;
    double *t, *e, *north, *u, *wind_e, *wind_n, *wind_u, *heading, *pitch, *roll, *air, *spare;
    orr_vec3 *r;
    orr_quat *q;
    double *block;
} samples;

static bool samples_allocate(samples *s, size_t n)
{
    memset(s, 0, sizeof *s);
    s->n = n;
    s->block = calloc(n * N_COLUMNS, sizeof *s->block);
    s->r = malloc(n * sizeof *s->r);
    s->q = malloc(n * sizeof *s->q);
    if (s->block == NULL || s->r == NULL || s->q == NULL) return false;
    double **column[N_COLUMNS] = {&s->t,      &s->e,       &s->north, &s->u,    &s->wind_e, &s->wind_n,
                                  &s->wind_u, &s->heading, &s->pitch, &s->roll, &s->air,    &s->spare};
    for (size_t k = 0; k < N_COLUMNS; k++) *column[k] = s->block + k * n;
    return true;
}

static void samples_free(samples *s)
{
    free(s->block);
    free(s->r);
    free(s->q);
}

// An oscillation of an angle, as far as the body is in the air.
//   Given:    o              its spectrum
//             seed, stream   of the random numbers
//             begin_s        time of the first sample
//             step_s         time between samples
//             path           whether any of it is on the ground
//             s              where (air)
//   Returned: x              [s->n] the angle with the oscillation
static void add_in_air(const orr_spectrum *o, uint64_t seed, uint64_t stream, double begin_s, double step_s,
                       const orr_flight_path *path, samples *s, double *x)
{
    if (!path->has_ground) {
        add_spectrum(o, seed, stream, false, begin_s, step_s, s->n, x);
        return;
    }
    memset(s->spare, 0, s->n * sizeof *s->spare);
    add_spectrum(o, seed, stream, false, begin_s, step_s, s->n, s->spare);
    for (size_t i = 0; i < s->n; i++) x[i] += s->air[i] * s->spare[i];
}

// Smoothed path, then attitude from it: heading along the course, pitch by the climb, roll of a coordinated
// turn. On the ground (air is 0, smoothed as the path is) a body neither banks nor sways.
static void fly(const orr_flight_path *path, const orr_flight_plan *plan, double step_s, double first_s,
                size_t width, samples *s)
{
    size_t hint = 0;
    for (size_t i = 0; i < s->n; i++) {
        s->t[i] = first_s + step_s * (double)i;
        orr_vec3 p = orr_flight_path_at(path, s->t[i], &hint);
        s->e[i] = p.x;
        s->north[i] = p.y;
        s->u[i] = p.z;
        s->air[i] = path->piece[hint].airborne ? 1.0 : 0.0;
    }
    for (int k = 0; k < 4; k++) {
        box(s->e, s->spare, s->n, width);
        box(s->north, s->spare, s->n, width);
        box(s->u, s->spare, s->n, width);
        if (path->has_ground) box(s->air, s->spare, s->n, width);
    }
    hint = 0;
    for (size_t i = 1; i + 1 < s->n; i++) {
        double ve = (s->e[i + 1] - s->e[i - 1]) / (2.0 * step_s),
               vn = (s->north[i + 1] - s->north[i - 1]) / (2.0 * step_s);
        double ae = (s->e[i + 1] - 2.0 * s->e[i] + s->e[i - 1]) / (step_s * step_s);
        double an = (s->north[i + 1] - 2.0 * s->north[i] + s->north[i - 1]) / (step_s * step_s);
        double vu = (s->u[i + 1] - s->u[i - 1]) / (2.0 * step_s), v2 = ve * ve + vn * vn, v = sqrt(v2);
        if (s->air[i] < 1e-9) s->air[i] = 0.0; // what running sums leave
        if (v > SLOW_MPS) {
            s->heading[i] = atan2(ve, vn);
            s->pitch[i] = s->air[i] * plan->pitch_rad + atan2(vu, v);
            s->roll[i] = s->air[i] *
                         atan((ae * vn - an * ve) / (v * G_MPS2)); // v times the rate of the course, over g
        } else {
            (void)orr_flight_path_at(path, s->t[i], &hint);
            s->heading[i] = orr_flight_path_course(path, s->t[i], hint);
            s->pitch[i] = s->air[i] * plan->pitch_rad;
            s->roll[i] = 0.0;
        }
    }
    s->heading[0] = s->heading[1];
    s->heading[s->n - 1] = s->heading[s->n - 2];
    s->air[0] = s->air[1];
    s->air[s->n - 1] = s->air[s->n - 2];
    s->pitch[0] = s->pitch[s->n - 1] = plan->pitch_rad;
    double tau = step_s;
    add_spectrum(&plan->wind_mps, plan->seed, 0, true, first_s, tau, s->n, s->wind_e);
    add_spectrum(&plan->wind_mps, plan->seed, 1, true, first_s, tau, s->n, s->wind_n);
    add_spectrum(&plan->wind_mps, plan->seed, 2, true, first_s, tau, s->n, s->wind_u);
    add_in_air(&plan->heading_rad, plan->seed, 3, first_s, tau, path, s, s->heading);
    add_in_air(&plan->pitch_osc_rad, plan->seed, 4, first_s, tau, path, s, s->pitch);
    add_in_air(&plan->roll_rad, plan->seed, 5, first_s, tau, path, s, s->roll);
    for (size_t i = 0; i < s->n; i++) {
        double air = path->has_ground ? s->air[i] : 1.0;
        orr_vec3 at = {s->e[i] + air * s->wind_e[i], s->north[i] + air * s->wind_n[i],
                       s->u[i] + air * s->wind_u[i]};
        s->r[i] = orr_local_map_to_ecef(&path->map, at);
        // The map's own axes carry the attitude, not true North: they turn smoothly even across a pole. True
        // heading is then the map course plus the meridians' convergence, as it is for a real straight line.
        double x = at.x / path->map.east_m, y = at.y / path->map.north_m, d = hypot(x, y);
        orr_mat3 T = orr_mat3_from_rotvec(d > 0.0 ? orr_vec3_make(-y, x, 0.0) : orr_vec3_make(0, 0, 0));
        orr_mat3 L = orr_body_from_enu((orr_angles){s->heading[i], s->pitch[i], s->roll[i]});
        orr_mat3 TA = orr_mat3_mul(&T, &path->map.A0), B = orr_mat3_mul(&L, &TA);
        s->q[i] = orr_quat_from_mat3(&B);
    }
}

orr_status orr_trajectory_flight_plan(orr_time t0, const orr_flight_plan *plan, orr_trajectory *out,
                                      orr_flight_summary *summary, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    double step = plan->knot_step_s;
    if (!(step >= 0.001 && step <= 10.0))
        return orr_diag_set(diag, ORR_E_ARG, "knots every %g s; 0.001 to 10 s are possible", step);
    if (!(plan->smoothing_s >= 0.0 && plan->smoothing_s <= 60.0) || !(plan->lead_m >= 0.0) ||
        !(plan->duration_s >= 0.0))
        return orr_diag_set(diag, ORR_E_ARG, "smoothing must be 0 to 60 s, lead and duration not negative");
    orr_status status = check_spectrum(&plan->wind_mps, "turbulence", step, diag);
    if (status == ORR_OK)
        status = check_spectrum(&plan->heading_rad, "the heading's oscillation", step, diag);
    if (status == ORR_OK)
        status = check_spectrum(&plan->pitch_osc_rad, "the pitch's oscillation", step, diag);
    if (status == ORR_OK) status = check_spectrum(&plan->roll_rad, "the roll's oscillation", step, diag);
    if (status != ORR_OK) return status;
    orr_flight_path path;
    status = orr_flight_path_make(plan, &path, diag);
    if (status != ORR_OK) return status;

    double duration = plan->duration_s > 0.0 ? plan->duration_s : path.duration_s;
    path.level_off = duration > path.duration_s;
    // Four boxes of w steps have the variance 4 (w^2 - 1) / 12 steps^2; their ends reach 2 w steps.
    double w = sqrt(3.0 * (plan->smoothing_s / step) * (plan->smoothing_s / step) + 1.0);
    size_t width = 2 * (size_t)floor(0.5 * w) + 1, margin = MARGIN + 2 * width;
    if (duration / step > MAX_KNOTS) {
        status = orr_diag_set(diag, ORR_E_LIMIT,
                              "a flight of %.0f s with knots every %g s passes the limit of %.0f knots",
                              duration, step, MAX_KNOTS);
        orr_flight_path_free(&path);
        return status;
    }
    size_t inner = (size_t)ceil(duration / step - 1e-9) + 1;
    samples s;
    if (!samples_allocate(&s, inner + 2 * margin)) {
        status = orr_diag_set(diag, ORR_E_MEMORY, "no memory for a flight of %.0f s", duration);
    } else {
        fly(&path, plan, step, -step * (double)margin, width, &s);
        size_t from = margin - MARGIN, n = inner + 2 * MARGIN;
        orr_spline_plan spline = {.degree = 5, .knot_step_s = step, .roughness = 1e-8};
        orr_spline_samples in = {.n_r = n,
                                 .r_t_s = s.t + from,
                                 .r_m = s.r + from,
                                 .n_q = n,
                                 .q_t_s = s.t + from,
                                 .q_be = s.q + from};
        status = orr_trajectory_from_samples(t0, 0.0, duration, &in, spline, spline, out, NULL, diag);
    }
    samples_free(&s);
    if (status == ORR_OK && summary != NULL)
        *summary = (orr_flight_summary){.duration_s = path.duration_s,
                                        .length_m = path.length_m,
                                        .turn_radius_m = path.radius_m,
                                        .lines = path.lines};
    orr_flight_path_free(&path);
    return status;
}
