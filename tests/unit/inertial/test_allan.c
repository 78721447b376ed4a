// SPDX-License-Identifier: GPL-3.0-or-later
// Allan and Hadamard deviations against published values, closed forms of single noises, and coefficients returned.
#include "testing.h"

#include "core/rng.h"
#include "core/vec.h"
#include "inertial/sense/allan.h"

// The 1000 frequencies of NIST SP 1065, section 12.4, and the deviations of its tables 31 and 32.
static void published_values(void **state)
{
    (void)state;
    double rate[1000];
    int64_t n = 1234567890;
    for (int k = 0; k < 1000; k++) {
        rate[k] = (double)n / 2147483647.0;
        n = 16807 * n % 2147483647;
    }
    orr_allan a;
    orr_diag diag = {0};
    ASSERT_OK(orr_allan_deviation(rate, 1000, 1.0, &a, &diag), diag);
    static const struct {
        double tau, allan, hadamard;
    } c[] = {
        {1, 2.922319e-01, 2.943883e-01}, {10, 9.159953e-02, 9.581083e-02}, {100, 3.241343e-02, 3.237638e-02}};
    for (int i = 0; i < 3; i++)
        for (size_t k = 0; k < a.n; k++)
            if (a.point[k].tau_s == c[i].tau) {
                ASSERT_NEAR(a.point[k].deviation / c[i].allan, 1, 1e-6);
                ASSERT_NEAR(a.point[k].hadamard / c[i].hadamard, 1, 1e-6);
                assert_true(a.point[k].low < a.point[k].deviation && a.point[k].deviation < a.point[k].high);
            }
    ASSERT_NEAR(a.duration_s, 1000, 0);
    assert_int_equal(orr_allan_deviation(rate, 8, 1.0, &a, &diag), ORR_E_ARG);
    assert_int_equal(orr_allan_deviation(rate, 100, 0.0, &a, &diag), ORR_E_ARG);
}

// A steady drift is R tau / sqrt 2 of Allan and nothing of Hadamard.
static void a_drift(void **state)
{
    (void)state;
    double rate[1000];
    for (int k = 0; k < 1000; k++) rate[k] = 0.1 * (1e-3 * 0.1 * (k + 0.5) + 5.0); // increments of 0.1 s
    orr_allan a;
    orr_diag diag = {0};
    ASSERT_OK(orr_allan_deviation(rate, 1000, 0.1, &a, &diag), diag);
    for (size_t k = 0; k < a.n; k++) {
        ASSERT_NEAR(a.point[k].deviation / (1e-3 * a.point[k].tau_s / sqrt(2.0)), 1, 1e-6);
        ASSERT_NEAR(a.point[k].hadamard, 0, 1e-10);
    }
}

// Made increments of noises, by their exact sums over a sample.
typedef struct noises {
    double q, n, k, r, sigma, T;
} noises;

static void make(const noises *c, uint64_t seed, size_t n, double dt, double *out)
{
    double walk = 0, residue = 0, gm = c->sigma * orr_rng_normal(seed, 5, 0),
           phi = c->T > 0 ? exp(-dt / c->T) : 0;
    for (size_t i = 0; i < n; i++) {
        out[i] = c->r * dt * dt * ((double)i + 0.5);
        if (c->n > 0) out[i] += c->n * sqrt(dt) * orr_rng_normal(seed, 0, i);
        if (c->q > 0) {
            double next = c->q * orr_rng_normal(seed, 2, i);
            out[i] += next - residue;
            residue = next;
        }
        if (c->k > 0) {
            double step = c->k * sqrt(dt) * orr_rng_normal(seed, 1, i);
            out[i] += (walk + 0.5 * step) * dt + c->k * dt * sqrt(dt / 12.0) * orr_rng_normal(seed, 3, i);
            walk += step;
        }
        if (c->T > 0) {
            double then = phi * gm + c->sigma * sqrt(1 - phi * phi) * orr_rng_normal(seed, 4, i);
            out[i] += 0.5 * dt * (gm + then);
            gm = then;
        }
    }
}

// The mean of 20 seeds comes back to 5 %, and the 95 % intervals hold in at least 17 of them.
static void coefficients_come_back(void **state)
{
    (void)state;
    enum { N = 200000 };
    double *x = malloc(N * sizeof *x);
    assert_non_null(x);
    const double dt = 0.1;
    static const noises c[] = {
        {.q = 3e-5, .n = 1e-4}, {.n = 1e-4, .k = 2e-5}, {.n = 1e-4, .sigma = 5e-5, .T = 10}, {.n = 1e-4}};
    for (size_t i = 0; i < sizeof c / sizeof c[0]; i++) {
        const double wanted[4] = {c[i].q, c[i].n, c[i].k, c[i].sigma};
        double mean[4] = {0};
        int held[4] = {0}, false_terms = 0;
        for (uint64_t seed = 1; seed <= 20; seed++) {
            make(&c[i], 100 * (i + 1) + seed, N, dt, x);
            orr_allan_fit f;
            orr_diag diag = {0};
            ASSERT_OK(orr_allan_coefficients(x, N, dt, &f, &diag), diag);
            ASSERT_NEAR(f.longest_tau_s, 100, 10); // a 200th of 20000 s
            const orr_allan_coefficient *q[4] = {&f.noise[ORR_ALLAN_QUANTISATION], &f.noise[ORR_ALLAN_WHITE],
                                                 &f.noise[ORR_ALLAN_RATE_WALK],
                                                 &f.noise[ORR_ALLAN_INSTABILITY]};
            for (int k = 0; k < 4; k++) {
                mean[k] += q[k]->value / 20;
                held[k] += q[k]->low <= wanted[k] && wanted[k] <= q[k]->high;
                if (wanted[k] == 0.0) false_terms += q[k]->seen;
            }
            if (c[i].sigma > 0) assert_true(f.gauss_markov);
        }
        for (int k = 0; k < 4; k++) {
            if (wanted[k] == 0.0) continue;
            print_message("case %zu, noise %d: mean %.4f of what was put in, interval holds in %d\n", i, k,
                          mean[k] / wanted[k], held[k]);
            ASSERT_NEAR(mean[k] / wanted[k], 1, 0.05);
            assert_true(held[k] >= 17);
        }
        print_message("case %zu: %d terms seen that are not there\n", i, false_terms);
    }
    free(x);
}

// Flicker as the sum of Gauss-Markov processes, four a decade of correlation times: S(f) = B^2 / (2 pi f) with
// B^2 = pi sigma^2 / ln(10^(1/4)). A floor of 0.664 B, and no hump.
static void flicker_is_a_floor(void **state)
{
    (void)state;
    enum { N = 200000, PROCESSES = 21 };
    double *x = calloc(N, sizeof *x);
    assert_non_null(x);
    const double dt = 0.1, sigma = 1e-5, B = sqrt(ORR_PI / (0.25 * log(10.0))) * sigma;
    double mean = 0;
    int floors = 0;
    for (uint64_t seed = 1; seed <= 4; seed++) {
        memset(x, 0, N * sizeof *x);
        for (int p = 0; p < PROCESSES; p++) {
            double T = 0.03 * pow(10.0, 0.25 * p), phi = exp(-dt / T),
                   b = sigma * orr_rng_normal(seed, 7, (uint64_t)p);
            for (size_t i = 0; i < N; i++) {
                double next =
                    phi * b + sigma * sqrt(1 - phi * phi) * orr_rng_normal(seed, 100 + (uint64_t)p, i);
                x[i] += 0.5 * dt * (b + next);
                b = next;
            }
        }
        for (size_t i = 0; i < N; i++) x[i] += 2e-5 * sqrt(dt) * orr_rng_normal(seed, 6, i);
        orr_allan_fit f;
        orr_diag diag = {0};
        ASSERT_OK(orr_allan_coefficients(x, N, dt, &f, &diag), diag);
        mean += f.noise[ORR_ALLAN_INSTABILITY].value / B / 4;
        floors += !f.gauss_markov && f.noise[ORR_ALLAN_INSTABILITY].seen;
    }
    print_message("flicker: %.3f of B, a floor in %d of 4\n", mean, floors);
    ASSERT_NEAR(mean, 1, 0.1);
    assert_true(floors >= 3);
    free(x);
}

// Too short a run, a length of nothing, and readings without noise.
static void what_has_no_coefficients(void **state)
{
    (void)state;
    double *x = calloc(5000, sizeof *x);
    orr_allan_fit f;
    orr_diag diag = {0};
    assert_int_equal(orr_allan_coefficients(x, 3999, 0.1, &f, &diag), ORR_E_NODATA);
    assert_int_equal(orr_allan_coefficients(x, 5000, 0.0, &f, &diag), ORR_E_ARG);
    ASSERT_OK(orr_allan_coefficients(x, 5000, 0.1, &f, &diag), diag);
    for (int k = 0; k < ORR_ALLAN_NOISES; k++) assert_false(f.noise[k].seen);
    free(x);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(published_values),         cmocka_unit_test(a_drift),
        cmocka_unit_test(coefficients_come_back),   cmocka_unit_test(flicker_is_a_floor),
        cmocka_unit_test(what_has_no_coefficients),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
