// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/study/vibration_broadband.h"

#include <stdlib.h>

#include "core/rng.h"
#include "inertial/study/attitude_method_private.h"

orr_status orr_vibration_psd_check(const orr_vibration_psd *p, orr_diag *diag)
{
    if (p->n < 2)
        return orr_diag_set(diag, ORR_E_ARG, "a spectrum has two frequencies at least, not %zu", p->n);
    for (size_t k = 0; k < p->n; k++) {
        if (!(p->frequency_hz[k] > (k > 0 ? p->frequency_hz[k - 1] : 0.0)))
            return orr_diag_set(diag, ORR_E_ARG,
                                "frequencies of a spectrum are positive and ascend; number %zu is %g Hz",
                                k + 1, p->frequency_hz[k]);
        if (!(p->rate[k] >= 0) || !isfinite(p->rate[k]))
            return orr_diag_set(diag, ORR_E_ARG, "the density at %g Hz is %g; none is negative",
                                p->frequency_hz[k], p->rate[k]);
    }
    if (!(fabs(p->coherence) <= 1))
        return orr_diag_set(diag, ORR_E_ARG, "a coherence of %g; it is within -1 and 1", p->coherence);
    return ORR_OK;
}

double orr_vibration_psd_at(const orr_vibration_psd *p, double frequency_hz)
{
    if (!(frequency_hz >= p->frequency_hz[0]) || !(frequency_hz <= p->frequency_hz[p->n - 1])) return 0.0;
    size_t k = 0;
    while (k + 2 < p->n && frequency_hz > p->frequency_hz[k + 1]) k++;
    const double x =
        log(frequency_hz / p->frequency_hz[k]) / log(p->frequency_hz[k + 1] / p->frequency_hz[k]);
    const double a = p->rate[k], b = p->rate[k + 1];
    return a > 0 && b > 0 ? a * pow(b / a, x) : a + x * (b - a);
}

// Integral of S(f) / (2 pi f), with a method's response or 1. Each vibration's drift is -w beta^2 / 2 (31), and the mean
// square of the angle of one axis, beta^2 / 2, is S df / w^2.
static double integrate(const orr_vibration_psd *p, const orr_attitude_method *m, double readings_hz)
{
    double sum = 0;
    for (size_t k = 0; k + 1 < p->n; k++) {
        const double from = p->frequency_hz[k], to = p->frequency_hz[k + 1];
        // Simpson's rule, finer than the response's waves (f_m over the length of a group) and than the density's decades.
        double step = 0.1 * from;
        if (m != NULL) step = fmin(step, readings_hz / (64.0 * m->samples));
        size_t cells = (size_t)fmin(ceil((to - from) / step), 4e6);
        if (cells < 4) cells = 4;
        const double h = (to - from) / (double)cells;
        for (size_t i = 0; i < cells; i++)
            for (int j = 0; j < 3; j++) {
                const double f = from + ((double)i + 0.5 * j) * h;
                const double value = orr_vibration_psd_at(p, fmin(f, to)) / (2 * ORR_PI * f);
                const double response = m != NULL ? orr_attitude_method_response(m, f / readings_hz) : 1.0;
                sum += (j == 1 ? 4.0 : 1.0) * h / 6.0 * value * response;
            }
    }
    return p->coherence * sum;
}

double orr_vibration_psd_drift(const orr_vibration_psd *p) { return integrate(p, NULL, 0.0); }
double orr_vibration_psd_error(const orr_vibration_psd *p, const orr_attitude_method *m, double readings_hz)
{
    return integrate(p, m, readings_hz);
}

// --- A made vibration ---

typedef struct tone {
    double w, beta, phase_1, phase_2; // phase_2 of what of axis 2 does not follow axis 1
} tone;

typedef struct spectrum {
    size_t n;
    tone *tone;
    double follows, own; // amplitudes of axis 2: with axis 1, and alone
} spectrum;

// Tones in bands of equal ratio that are no wider than df_hz; each has the power of its band.
static orr_status make_tones(const orr_vibration_psd *p, double df_hz, uint64_t seed, spectrum *out,
                             orr_diag *diag)
{
    const double low = p->frequency_hz[0], high = p->frequency_hz[p->n - 1];
    const size_t n = (size_t)fmin(fmax(ceil((high - low) / df_hz), 64.0), 2000.0);
    *out = (spectrum){.n = n, .follows = p->coherence, .own = sqrt(1 - p->coherence * p->coherence)};
    out->tone = malloc(n * sizeof *out->tone);
    if (out->tone == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu tones", n);
    const double df = (high - low) / (double)n;
    for (size_t k = 0; k < n; k++) {
        // The tone stands anywhere in its band, so that no tone of one run is a multiple of another.
        const double from = low + (double)k * df, f = from + df * orr_rng_uniform(seed, 3, k);
        double power = 0;
        for (int i = 0; i < 8; i++) {
            const double at = from + ((double)i + 0.5) / 8 * df;
            power += orr_vibration_psd_at(p, at) / at * df / 8;
        }
        // The band's drift is kept: beta^2 w / 2 = integral of S / (2 pi f).
        const double w = 2 * ORR_PI * f;
        out->tone[k] = (tone){w, sqrt(power / ORR_PI / w), 2 * ORR_PI * orr_rng_uniform(seed, 1, k),
                              2 * ORR_PI * orr_rng_uniform(seed, 2, k)};
    }
    return ORR_OK;
}

// The rotation vector (x, y, 0) of the body from its axes at rest, and its change.
static void angles_at(const spectrum *s, double t, orr_vec3 *angle, orr_vec3 *change)
{
    *angle = *change = (orr_vec3){0, 0, 0};
    for (size_t k = 0; k < s->n; k++) {
        const tone *q = &s->tone[k];
        const double a = q->w * t + q->phase_1, c = cos(a), d = sin(a);
        angle->x += q->beta * c;
        change->x -= q->beta * q->w * d;
        angle->y += q->beta * s->follows * d;
        change->y += q->beta * s->follows * q->w * c;
        if (s->own > 0) {
            const double b = q->w * t + q->phase_2;
            angle->y += q->beta * s->own * sin(b);
            change->y += q->beta * s->own * q->w * cos(b);
        }
    }
}

// Of a rotation vector g that changes by g': w = g' - (1 - cos|g|)/|g|^2 g x g' + (|g| - sin|g|)/|g|^3 g x (g x g').
static orr_vec3 rate_of(orr_vec3 g, orr_vec3 change)
{
    const double n2 = orr_vec3_dot(g, g), n = sqrt(n2);
    const double a = n2 < 1e-4 ? 0.5 - n2 / 24 + n2 * n2 / 720 : (1 - cos(n)) / n2;
    const double b = n2 < 1e-4 ? 1.0 / 6 - n2 / 120 + n2 * n2 / 5040 : (n - sin(n)) / (n2 * n);
    const orr_vec3 once = orr_vec3_cross(g, change);
    return orr_vec3_axpy(b, orr_vec3_cross(g, once), orr_vec3_axpy(-a, once, change));
}

// Gauss-Legendre, 5 nodes on (0, 1).
static const double node[5] = {0.04691007703066800, 0.23076534494715845, 0.5, 0.76923465505284155,
                               0.95308992296933200};
static const double weight[5] = {0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                 0.23931433524968324, 0.11846344252809454};

static orr_xvec increment(const spectrum *s, double from, double to, int parts)
{
    orr_vec3 sum = {0, 0, 0};
    const double h = (to - from) / parts;
    for (int k = 0; k < parts; k++)
        for (int i = 0; i < 5; i++) {
            orr_vec3 g, change;
            angles_at(s, from + ((double)k + node[i]) * h, &g, &change);
            sum = orr_vec3_axpy(weight[i] * h, rate_of(g, change), sum);
        }
    return (orr_xvec){(long double)sum.x, (long double)sum.y, (long double)sum.z};
}

static orr_xquat attitude_at(const spectrum *s, double t)
{
    orr_vec3 g, change;
    angles_at(s, t, &g, &change);
    return orr_xquat_from_rotvec((orr_xvec){(long double)g.x, (long double)g.y, 0});
}

enum { MOST_METHODS = 32 };

orr_status orr_vibration_psd_run(const orr_vibration_psd *p, const orr_attitude_method *m, size_t n_methods,
                                 double readings_hz, double duration_s, uint64_t seed, double *drift_radps,
                                 orr_diag *diag)
{
    orr_status status = orr_vibration_psd_check(p, diag);
    if (status != ORR_OK) return status;
    const double steps = floor(duration_s * readings_hz * (1 + 1e-12));
    if (!(readings_hz > 0) || !(steps >= ORR_METHOD_MAX_SAMPLES) || !(steps < 1e7) ||
        n_methods > MOST_METHODS)
        return orr_diag_set(diag, ORR_E_ARG,
                            "%g s at %g Hz are not 8 to ten million readings of at most %d methods",
                            duration_s, readings_hz, (int)MOST_METHODS);
    spectrum s;
    status = make_tones(p, 2.0 / duration_s, seed, &s, diag);
    orr_method_plan *plan = calloc(n_methods + 1, sizeof *plan);
    if (status == ORR_OK && plan == NULL) status = orr_diag_set(diag, ORR_E_MEMORY, "no memory for methods");
    if (status != ORR_OK) {
        free(plan);
        return status;
    }
    // Two nodes and a half a period of the fastest tone, at least.
    const int parts = (int)fmax(ceil(p->frequency_hz[p->n - 1] / readings_hz * 1.5), 1.0);
    orr_xvec d[MOST_METHODS][ORR_METHOD_MAX_SAMPLES];
    orr_xquat q[MOST_METHODS];
    for (size_t k = 0; k < n_methods; k++) {
        orr_method_prepare(&m[k], &plan[k]);
        q[k] = attitude_at(&s, 0.0);
        drift_radps[k] = 0;
    }
    for (size_t j = 0; j < (size_t)steps; j++) {
        const orr_xvec now = increment(&s, (double)j / readings_hz, (double)(j + 1) / readings_hz, parts);
        for (size_t k = 0; k < n_methods; k++) {
            const size_t samples = (size_t)m[k].samples, at = j % samples;
            d[k][at] = now;
            if (at + 1 < samples) continue;
            orr_method_step(&plan[k], d[k], NULL, &q[k], NULL);
            if (j + samples < (size_t)steps) continue; // another whole group follows
            const double t = (double)(j + 1) / readings_hz;
            const orr_xquat e = orr_xquat_mul(q[k], orr_xquat_conj(attitude_at(&s, t)));
            drift_radps[k] = (double)(-2 * e.z) / t;
        }
    }
    free(plan);
    free(s.tone);
    return ORR_OK;
}
