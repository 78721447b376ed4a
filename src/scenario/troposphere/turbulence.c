// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/troposphere/turbulence.h"

#include <math.h>
#include <stdlib.h>

#include "core/constants.h"
#include "core/rng.h"

enum { RINGS = 24, EACH = 2, WAVES = RINGS * EACH };
static const double SHORTEST_M = 100, LONGEST_M = 300e3;

struct orr_turbulence {
    orr_vec3 origin_m;
    orr_mat3 enu;
    double height_m; // where rays meet the field
    // Of each wave: cycles a metre to the East and North, cycles a second, cycles at the origin of time, amplitude.
    double east[WAVES], north[WAVES], rate_hz[WAVES], phase[WAVES], amplitude_m[WAVES];
};

// The layer's spectrum of zenith delay per wave number of any direction, m^3: 2 pi k times the integral over the vertical wave
// number q of 0.033 C^2 (k^2 + q^2)^(-11/6) (Tatarskii 1971) and the layer's window, h^2 sinc^2(q h / 2).
static double spectrum_m3(const orr_scenario_turbulence *s, double k)
{
    const double h = s->height_m, c2 = s->strength * s->strength;
    enum { STEPS = 400 }; // of q, evenly by its logarithm; below the first all is constant
    const double low = 1e-3 * fmin(k, 1 / h), ratio = pow(30 * fmax(k, 2 / h) / low, 1.0 / STEPS);
    double sum = low * pow(k * k, -11.0 / 6), q = low;
    for (int i = 0; i < STEPS; i++, q *= ratio) {
        const double middle = q * sqrt(ratio), x = middle * h / 2, window = sin(x) / x;
        sum += pow(k * k + middle * middle, -11.0 / 6) * window * window * q * (ratio - 1);
    }
    return 2 * ORR_PI * k * 0.033 * c2 * h * h * 2 * sum;
}

double orr_turbulence_structure_m2(const orr_scenario_turbulence *s, double distance_m)
{
    // Twice the integral of C^2 ((d^2 + z^2)^(1/3) - z^(2/3)) (h - z) over the difference z of two heights.
    enum { STEPS = 4000 };
    const double h = s->height_m, step = h / STEPS;
    double sum = 0;
    for (int i = 0; i < STEPS; i++) {
        const double z = (i + 0.5) * step;
        sum += (cbrt(distance_m * distance_m + z * z) - cbrt(z * z)) * (h - z);
    }
    return 2 * s->strength * s->strength * sum * step;
}

orr_status orr_turbulence_open(const orr_scenario_turbulence *s, orr_vec3 r_m, const orr_mat3 *enu,
                               orr_turbulence **out, orr_diag *diag)
{
    orr_turbulence *f = calloc(1, sizeof *f);
    *out = f;
    if (f == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    f->origin_m = r_m;
    f->enu = *enu;
    f->height_m = s->height_m / 2;
    const uint64_t seed = (uint64_t)s->seed;
    const double ratio = pow(LONGEST_M / SHORTEST_M, 1.0 / RINGS), golden = ORR_PI * (3 - sqrt(5));
    const double first = 2 * ORR_PI * orr_rng_uniform(seed, 1, 0), to = s->azimuth_deg * ORR_RAD_PER_DEG;
    for (int i = 0; i < WAVES; i++) {
        // A wave stands for a share of its ring of wave lengths; directions fill the circle evenly, whatever ring comes first.
        const double low = 2 * ORR_PI / LONGEST_M * pow(ratio, (double)(i / EACH)), high = low * ratio;
        const double k = low * pow(ratio, orr_rng_uniform(seed, 2, (uint64_t)i));
        const double heading = first + golden * i;
        double power = 0;
        enum { PARTS = 4 };
        for (int j = 0; j < PARTS; j++) power += spectrum_m3(s, low + (j + 0.5) * (high - low) / PARTS);
        power *= (high - low) / PARTS / EACH; // half the square of the amplitude
        f->amplitude_m[i] = sqrt(2 * power);
        f->east[i] = k / (2 * ORR_PI) * sin(heading);
        f->north[i] = k / (2 * ORR_PI) * cos(heading);
        f->rate_hz[i] = -s->speed_mps * (f->east[i] * sin(to) + f->north[i] * cos(to));
        f->phase[i] = orr_rng_uniform(seed, 3, (uint64_t)i);
    }
    return ORR_OK;
}

void orr_turbulence_close(orr_turbulence *f) { free(f); }

// Where a ray meets the field, to the East and North of its origin, how that moves, and the slant over the zenith delay, which is less
// the less of the layer is above the antenna: by that share to the power of 3/2, between what fine and coarse structure have.
typedef struct meeting {
    double east_m, north_m, east_mps, north_mps, slant, slant_ps;
} meeting;

static meeting meet(const orr_turbulence *f, const orr_turbulence_ray *ray)
{
    const orr_vec3 at = orr_mat3_apply(&f->enu, orr_vec3_sub(ray->r_m, f->origin_m)),
                   v = orr_mat3_apply(&f->enu, ray->v_mps), u = ray->u, du = ray->u_rate_ps;
    const double s = sqrt(u.z * u.z + 0.03 * 0.03), ds = u.z * du.z / s, h = f->height_m / s;
    // Above the origin, on a round Earth.
    const double up_m = at.z + (at.x * at.x + at.y * at.y) / (2 * ORR_EARTH_MEAN_RADIUS_M),
                 up_mps = v.z + (at.x * v.x + at.y * v.y) / ORR_EARTH_MEAN_RADIUS_M;
    const double above = fmax(1 - up_m / (2 * f->height_m), 0), root = sqrt(above);
    const double share = above * root, share_ps = -1.5 * root * up_mps / (2 * f->height_m);
    return (meeting){.east_m = at.x + h * u.x,
                     .north_m = at.y + h * u.y,
                     .east_mps = v.x + h * (du.x - u.x * ds / s),
                     .north_mps = v.y + h * (du.y - u.y * ds / s),
                     .slant = share / s,
                     .slant_ps = share_ps / s - share * ds / (s * s)};
}

// Cosine and sine of x turns, to 1e-7, in a form that compilers make vectors of: by half the angle.
static inline void turned(double x, double *cosine, double *sine)
{
    const double whole = (x + 6755399441055744.0) - 6755399441055744.0; // to the nearest: 1.5 2^52
    const double y = ORR_PI * (x - whole), z = y * y;
    const double s =
        y * (1 + z * (-1.0 / 6 +
                      z * (1.0 / 120 + z * (-1.0 / 5040 + z * (1.0 / 362880 + z * (-1.0 / 39916800))))));
    const double c =
        1 + z * (-0.5 + z * (1.0 / 24 + z * (-1.0 / 720 + z * (1.0 / 40320 + z * (-1.0 / 3628800 +
                                                                                  z * (1.0 / 479001600))))));
    *cosine = c * c - s * s;
    *sine = 2 * s * c;
}

double orr_turbulence_slant_m(const orr_turbulence *f, const orr_turbulence_ray *ray, orr_time t,
                              double *rate_mps)
{
    const meeting m = meet(f, ray);
    const double t_s = (double)t / 1e9;
    double zenith[2] = {0, 0}, turning[2] = {0, 0};
    for (int i = 0; i < WAVES; i += 2)
        for (int j = 0; j < 2; j++) {
            const int w = i + j;
            double c, s;
            turned(f->east[w] * m.east_m + f->north[w] * m.north_m + f->rate_hz[w] * t_s + f->phase[w], &c,
                   &s);
            zenith[j] += f->amplitude_m[w] * c;
            turning[j] +=
                f->amplitude_m[w] * s * (f->east[w] * m.east_mps + f->north[w] * m.north_mps + f->rate_hz[w]);
        }
    const double value = zenith[0] + zenith[1], rate = -2 * ORR_PI * (turning[0] + turning[1]);
    *rate_mps = m.slant * rate + m.slant_ps * value;
    return m.slant * value;
}

int64_t orr_turbulence_block_ns(const orr_turbulence *f, double error_m)
{
    if (f == NULL) return INT64_MAX;
    // A ray near the horizon sweeps the field as the satellite moves by 2e-4 rad/s: its meeting by up to 300 times that and the height.
    const double sweep_mps = 300 * 2e-4 * f->height_m;
    double fourth = 0; // derivative, m/s^4
    for (int i = 0; i < WAVES; i++) {
        const double w = 2 * ORR_PI * (fabs(f->rate_hz[i]) + sweep_mps * hypot(f->east[i], f->north[i]));
        fourth += 30 * f->amplitude_m[i] * w * w * w * w;
    }
    return (int64_t)(1e9 * pow(384 * error_m / fmax(fourth, 1e-12), 0.25));
}
