// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/sense/allan.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/linalg.h"
#include "core/nan.h"
#include "core/vec.h"

#define PER_DECADE 10
#define FITTED_SHARE 200.0 // of the run is the longest time that is fitted
#define PARTS 10
#define LEAST_SAMPLES 4000
#define CONFIDENCE 0.95
#define WORTH 30.0 // a term has to take so much off the weighted sum of squares

const char *orr_allan_noise_name(orr_allan_noise k)
{
    static const char *const name[] = {"quantisation", "white noise", "bias instability", "rate random walk",
                                       "rate ramp"};
    return name[k];
}

// Sums of increments: x[0] = 0, x[k] = what the rate has integrated to after k samples, less its mean (which no second
// difference sees) so that the sums keep their digits.
static double *integrate(const double *increment, size_t n)
{
    double *x = malloc((n + 1) * sizeof *x), mean = 0.0;
    if (x == NULL) return NULL;
    for (size_t k = 0; k < n; k++) mean += (increment[k] - mean) / (double)(k + 1);
    x[0] = 0.0;
    for (size_t k = 0; k < n; k++) x[k + 1] = x[k] + (increment[k] - mean);
    return x;
}

// x[n + 1]: sums; m samples an average.
static double allan_variance(const double *x, size_t n, size_t m, double dt_s)
{
    double sum = 0.0, tau = (double)m * dt_s;
    size_t terms = n + 1 - 2 * m;
    for (size_t k = 0; k < terms; k++) {
        double d = x[k + 2 * m] - 2.0 * x[k + m] + x[k];
        sum += d * d;
    }
    return sum / (2.0 * tau * tau * (double)terms);
}

static double hadamard_variance(const double *x, size_t n, size_t m, double dt_s)
{
    double sum = 0.0, tau = (double)m * dt_s;
    size_t terms = n + 1 - 3 * m;
    for (size_t k = 0; k < terms; k++) {
        double d = x[k + 3 * m] - 3.0 * x[k + 2 * m] + 3.0 * x[k + m] - x[k];
        sum += d * d;
    }
    return sum / (6.0 * tau * tau * (double)terms);
}

// Degrees of freedom of the overlapping Allan variance of points sums at m, for the noise that a slope of the
// deviation shows (Howe, Allan and Barnes 1981).
static double degrees_of_freedom(double slope, double points, double m)
{
    double N = points, f;
    // A slope so steep over the few averages of long times is luck, not quantisation.
    if (slope < -0.75 && 50.0 * m < N) // white phase: quantisation
        f = (N + 1.0) * (N - 2.0 * m) / (2.0 * (N - m));
    else if (slope < -0.25) // white
        f = (3.0 * (N - 1.0) / (2.0 * m) - 2.0 * (N - 2.0) / N) * 4.0 * m * m / (4.0 * m * m + 5.0);
    else if (slope < 0.25) // flicker
        f = m < 1.5 ? 2.0 * (N - 2.0) * (N - 2.0) / (2.3 * N - 4.9) : 5.0 * N * N / (4.0 * m * (N + 3.0 * m));
    else // random walk of the rate, and steeper
        f = (N - 2.0) / m * ((N - 1.0) * (N - 1.0) - 3.0 * m * (N - 1.0) + 4.0 * m * m) /
            ((N - 3.0) * (N - 3.0));
    return fmax(f, 1.0);
}

// Chi-square that is not passed with probability p, over its degrees of freedom; Wilson and Hilferty's where they are
// many, and GSL's iteration may fail.
static double chi_square_share(double p, double freedom)
{
    if (freedom < 300.0) return gsl_cdf_chisq_Pinv(p, freedom) / freedom;
    double q = 2.0 / (9.0 * freedom);
    return pow(1.0 - q + gsl_cdf_ugaussian_Pinv(p) * sqrt(q), 3.0);
}

// Numbers of samples, ten a decade, each once; how many.
static size_t choose_lengths(size_t longest, size_t m[ORR_ALLAN_MAX_POINTS])
{
    size_t n = 0;
    for (int k = 0; n < ORR_ALLAN_MAX_POINTS; k++) {
        double wanted = nearbyint(pow(10.0, (double)k / PER_DECADE));
        if (wanted > (double)longest) break;
        if (n == 0 || (size_t)wanted > m[n - 1]) m[n++] = (size_t)wanted;
    }
    return n;
}

orr_status orr_allan_deviation(const double *increment, size_t n, double dt_s, orr_allan *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    if (n < 9 || !(dt_s > 0.0))
        return orr_diag_set(diag, ORR_E_ARG,
                            "an Allan deviation needs nine samples at least, of a positive length");
    double *x = integrate(increment, n);
    if (x == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu samples", n);
    size_t m[ORR_ALLAN_MAX_POINTS];
    out->n = choose_lengths(n / 3, m);
    out->duration_s = (double)n * dt_s;
    for (size_t k = 0; k < out->n; k++) {
        double hadamard = n + 1 > 3 * m[k] ? sqrt(hadamard_variance(x, n, m[k], dt_s)) : ORR_NAN;
        out->point[k] = (orr_allan_point){.tau_s = (double)m[k] * dt_s,
                                          .deviation = sqrt(allan_variance(x, n, m[k], dt_s)),
                                          .hadamard = hadamard};
    }
    free(x);
    for (size_t k = 0; k < out->n; k++) {
        orr_allan_point *p = &out->point[k];
        // The slope over three points a side, so that a noisy point does not choose the noise.
        size_t a = k > 3 ? k - 3 : 0, b = k + 3 < out->n ? k + 3 : out->n - 1;
        double slope = b > a && out->point[a].deviation > 0.0 && out->point[b].deviation > 0.0
                           ? log(out->point[b].deviation / out->point[a].deviation) /
                                 log(out->point[b].tau_s / out->point[a].tau_s)
                           : -0.5;
        p->freedom = degrees_of_freedom(slope, (double)n + 1.0, (double)m[k]);
        p->low = p->deviation * sqrt(1.0 / chi_square_share(0.5 + 0.5 * CONFIDENCE, p->freedom));
        p->high = p->deviation * sqrt(1.0 / chi_square_share(0.5 - 0.5 * CONFIDENCE, p->freedom));
    }
    return ORR_OK;
}

// --- Coefficients ---

// Allan variance of noise k of coefficient 1; T: of a Gauss-Markov process in place of the floor, 0: the floor.
static double unit_variance(int k, double tau, double T)
{
    switch (k) {
    case ORR_ALLAN_QUANTISATION:
        return 3.0 / (tau * tau);
    case ORR_ALLAN_WHITE:
        return 1.0 / tau;
    case ORR_ALLAN_RATE_WALK:
        return tau / 3.0;
    case ORR_ALLAN_RAMP:
        return 0.5 * tau * tau;
    default:
        break;
    }
    if (!(T > 0.0)) return 2.0 * log(2.0) / ORR_PI;
    double u = tau / T;
    // 2 sigma^2 T / tau (1 - T / (2 tau) (3 - 4 e^-u + e^-2u)); the series where its terms cancel.
    if (u < 1e-3) return 2.0 * u / 3.0 - 0.5 * u * u;
    return 2.0 / u * (1.0 - (3.0 - 4.0 * exp(-u) + exp(-2.0 * u)) / (2.0 * u));
}

typedef struct curve {
    size_t n;
    double tau[ORR_ALLAN_MAX_POINTS], variance[ORR_ALLAN_MAX_POINTS], freedom[ORR_ALLAN_MAX_POINTS],
        weight[ORR_ALLAN_MAX_POINTS];
} curve;

// Squares of the coefficients that are `used`, by least squares weighted with the relative errors of the points.
// Returns the weighted sum of squares that is left, HUGE_VAL where they are not determined.
static double solve(const curve *c, const bool used[ORR_ALLAN_NOISES], double T,
                    double square[ORR_ALLAN_NOISES])
{
    double A[ORR_ALLAN_NOISES * ORR_ALLAN_NOISES], y[ORR_ALLAN_NOISES], scale[ORR_ALLAN_NOISES];
    int index[ORR_ALLAN_NOISES], n = 0;
    for (int k = 0; k < ORR_ALLAN_NOISES; k++) {
        square[k] = 0.0;
        if (used[k]) index[n++] = k;
    }
    if (n == 0) return HUGE_VAL;
    for (int a = 0; a < n; a++) { // columns of one length
        double sum = 0.0;
        for (size_t i = 0; i < c->n; i++) {
            double f = unit_variance(index[a], c->tau[i], T);
            sum += c->weight[i] * f * f;
        }
        scale[a] = 1.0 / sqrt(sum);
    }
    for (int a = 0; a < n; a++) {
        y[a] = 0.0;
        for (int b = 0; b < n; b++) A[a * n + b] = 0.0;
        for (size_t i = 0; i < c->n; i++) {
            double f = scale[a] * unit_variance(index[a], c->tau[i], T);
            y[a] += c->weight[i] * f * c->variance[i];
            for (int b = 0; b < n; b++)
                A[a * n + b] += c->weight[i] * f * scale[b] * unit_variance(index[b], c->tau[i], T);
        }
    }
    if (orr_cholesky_factor(A, (size_t)n, 1e-14) != ORR_OK || orr_cholesky_solve(A, (size_t)n, y) != ORR_OK)
        return HUGE_VAL;
    double left = 0.0;
    for (int a = 0; a < n; a++) square[index[a]] = scale[a] * y[a];
    for (size_t i = 0; i < c->n; i++) {
        double model = 0.0;
        for (int k = 0; k < ORR_ALLAN_NOISES; k++) model += square[k] * unit_variance(k, c->tau[i], T);
        left += c->weight[i] * (c->variance[i] - model) * (c->variance[i] - model);
    }
    return left;
}

// The same with no negative squares, and with no terms that the curve does not ask for: kept by chance they would
// take from the others. The worst goes first.
static double solve_positive(const curve *c, double T, bool used[ORR_ALLAN_NOISES],
                             double square[ORR_ALLAN_NOISES])
{
    double left = solve(c, used, T, square);
    for (;;) {
        int worst = -1;
        double most = 0.0; // of a negative term where it is largest
        for (int k = 0; k < ORR_ALLAN_NOISES; k++)
            for (size_t i = 0; i < c->n && square[k] < 0.0; i++) {
                double share = square[k] * unit_variance(k, c->tau[i], T) / c->variance[i];
                if (share < most) {
                    most = share;
                    worst = k;
                }
            }
        double least = WORTH; // what a positive term takes off the sum of squares
        for (int k = 0; worst < 0 && k < ORR_ALLAN_NOISES; k++) {
            if (!used[k]) continue;
            bool others[ORR_ALLAN_NOISES];
            double rest[ORR_ALLAN_NOISES];
            memcpy(others, used, sizeof others);
            others[k] = false;
            double more = solve(c, others, T, rest) - left;
            if (more < least) {
                least = more;
                worst = k;
            }
        }
        if (worst < 0) return left;
        used[worst] = false;
        left = solve(c, used, T, square);
        if (!(left < HUGE_VAL)) return left;
    }
}

// Weights by the fitted curve: by the measured one, points that came out low would count for more.
static void reweigh(curve *c, double T, const double square[ORR_ALLAN_NOISES])
{
    for (size_t i = 0; i < c->n; i++) {
        double model = 0.0;
        for (int k = 0; k < ORR_ALLAN_NOISES; k++) model += square[k] * unit_variance(k, c->tau[i], T);
        if (model > 0.0) c->weight[i] = c->freedom[i] / (2.0 * model * model);
    }
}

static curve curve_of(const double *x, size_t n, double dt_s, const size_t *m, size_t n_m)
{
    curve c = {.n = n_m};
    for (size_t i = 0; i < n_m; i++) {
        c.tau[i] = (double)m[i] * dt_s;
        c.variance[i] = allan_variance(x, n, m[i], dt_s);
        // Relative errors of white noise's variance; the exact ones differ by factors that hardly matter.
        c.freedom[i] = degrees_of_freedom(-0.5, (double)n + 1.0, (double)m[i]);
        c.weight[i] = c.variance[i] > 0.0 ? c.freedom[i] / (2.0 * c.variance[i] * c.variance[i]) : 0.0;
    }
    return c;
}

// Correlation time of the Gauss-Markov process that describes the curve best, 0 where a floor does.
static double correlation_time(const curve *c, double shortest_s, double longest_s)
{
    bool used[ORR_ALLAN_NOISES] = {true, true, true, true, true};
    double square[ORR_ALLAN_NOISES], best = solve_positive(c, 0.0, used, square), T = 0.0;
    for (double t = shortest_s; t <= longest_s; t *= 1.05) {
        bool all[ORR_ALLAN_NOISES] = {true, true, true, true, true};
        double left = solve_positive(c, t, all, square);
        // It has a parameter more, and has to be worth it.
        if (square[ORR_ALLAN_INSTABILITY] > 0.0 && left < best - (T > 0.0 ? 0.0 : WORTH)) {
            best = left;
            T = t;
        }
    }
    return T;
}

orr_status orr_allan_coefficients(const double *increment, size_t n, double dt_s, orr_allan_fit *out,
                                  orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    if (!(dt_s > 0.0)) return orr_diag_set(diag, ORR_E_ARG, "samples of %g s have no length", dt_s);
    if (n < LEAST_SAMPLES)
        return orr_diag_set(
            diag, ORR_E_NODATA,
            "%zu samples are too few to tell noises apart: times up to a 200th of the run are fitted, and "
            "%d samples are needed",
            n, LEAST_SAMPLES);
    double *x = integrate(increment, n);
    if (x == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu samples", n);
    size_t m[ORR_ALLAN_MAX_POINTS], n_m = choose_lengths((size_t)((double)n / FITTED_SHARE), m);
    curve all = curve_of(x, n, dt_s, m, n_m);
    out->longest_tau_s = all.tau[n_m - 1];
    double T = 0.0;
    bool used[ORR_ALLAN_NOISES] = {true, true, true, true, true};
    double square[ORR_ALLAN_NOISES] = {0}, spread[ORR_ALLAN_NOISES] = {0}, mean[ORR_ALLAN_NOISES] = {0};
    bool flat = true; // readings without any noise
    for (size_t i = 0; i < n_m; i++) flat = flat && !(all.variance[i] > 0.0);
    if (flat) {
        free(x);
        return ORR_OK;
    }
    for (int pass = 0; pass < 3; pass++) {
        for (int k = 0; k < ORR_ALLAN_NOISES; k++) used[k] = true;
        T = correlation_time(&all, 3.0 * dt_s, 3.0 * out->longest_tau_s);
        solve_positive(&all, T, used, square);
        reweigh(&all, T, square);
    }
    // The same terms in each of ten parts: their scatter is what a part's estimate varies by.
    double part[PARTS][ORR_ALLAN_NOISES], times[PARTS];
    size_t length = n / PARTS;
    for (int p = 0; p < PARTS; p++) {
        curve c = curve_of(x + (size_t)p * length, length, dt_s, m, n_m);
        memcpy(c.weight, all.weight, sizeof c.weight); // those of a part follow its own luck
        // Its own correlation time: what that is uncertain by belongs to the others' intervals.
        times[p] = T > 0.0 ? correlation_time(&c, T / 4.0, 4.0 * T) : 0.0;
        if (!(times[p] > 0.0)) times[p] = T;
        solve(&c, used, times[p], part[p]);
        for (int k = 0; k < ORR_ALLAN_NOISES; k++) mean[k] += part[p][k] / PARTS;
    }
    for (int p = 0; p < PARTS; p++)
        for (int k = 0; k < ORR_ALLAN_NOISES; k++)
            spread[k] += (part[p][k] - mean[k]) * (part[p][k] - mean[k]) / (PARTS - 1);
    double t95 = gsl_cdf_tdist_Pinv(0.5 + 0.5 * CONFIDENCE, PARTS - 1);
    for (int k = 0; k < ORR_ALLAN_NOISES; k++) {
        double sigma = sqrt(spread[k] / PARTS);
        orr_allan_coefficient *q = &out->noise[k];
        q->seen = used[k] && square[k] > 2.0 * sigma;
        q->value = sqrt(fmax(square[k], 0.0));
        q->low = sqrt(fmax(square[k] - t95 * sigma, 0.0));
        q->high = sqrt(fmax(square[k] + t95 * sigma, 0.0));
    }
    if (T > 0.0 && out->noise[ORR_ALLAN_INSTABILITY].seen) {
        out->gauss_markov = true;
        out->sigma = out->noise[ORR_ALLAN_INSTABILITY].value;
        out->correlation_s = T;
        double logs = 0.0, squares = 0.0; // of what times are to their own
        for (int p = 0; p < PARTS; p++) logs += log(times[p] / T) / PARTS;
        for (int p = 0; p < PARTS; p++) squares += pow(log(times[p] / T) - logs, 2.0) / (PARTS - 1);
        out->correlation_low_s = T * exp(-t95 * sqrt(squares / PARTS));
        out->correlation_high_s = T * exp(t95 * sqrt(squares / PARTS));
        out->noise[ORR_ALLAN_INSTABILITY].seen = false;
    }
    free(x);
    return ORR_OK;
}
