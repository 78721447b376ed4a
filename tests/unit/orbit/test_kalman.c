// SPDX-License-Identifier: GPL-3.0-or-later
// Filter and smoother against the one batch least squares they must equal: all states of all steps at once,
// with the a-priori, the transitions' noise and the measurements as equations.
#include "testing.h"

#include <gsl/gsl_linalg.h>

#include "core/rng.h"
#include "orbit/smooth/kalman.h"

#define STEPS 6
#define NX ORR_NX_PLAIN // the dense oracle holds the dissertation's nine
#define N (NX * (STEPS + 1))
#define H_S 150.0

// With the prior of satellites that face the Sun.
static void start(double r_m, double v_mps, double f_mps2, orr_gauss *g)
{
    const orr_vec3 r = {2.66e7, 0, 0}, v = {0, 3.87e3, 0};
    orr_kalman_start(r_m, v_mps, f_mps2, orr_ecom_sigma_nmps2(r, v), g);
}

static const orr_noise_factor as_it_is = {.q = 1};

// Partial derivatives near the truth of an orbit: E, h E; B h^2/2, B h; ECOM's about as f0's.
static orr_mat3 random_step(double F[6][ORR_NX], uint64_t stream)
{
    const orr_mat3 axes = orr_mat3_from_rotvec((orr_vec3){0.3, -1.1, 0.7});
    memset(F, 0, 6 * sizeof F[0]);
    for (int i = 0; i < 3; i++) {
        F[i][i] = F[3 + i][3 + i] = 1;
        F[i][3 + i] = H_S;
        for (int j = 0; j < 3; j++) {
            F[i][6 + j] = axes.m[i][j] * H_S * H_S / 2;
            F[3 + i][6 + j] = axes.m[i][j] * H_S;
            F[3 + i][j] = 3e-8 * H_S * orr_rng_normal(5, stream, (uint64_t)(3 * i + j));
        }
        for (int j = 0; j < ORR_ECOM_TERMS; j++) {
            const double a = 1e-9 * orr_rng_normal(6, stream, (uint64_t)(9 * i + j));
            F[i][ORR_PARTIAL_ECOM + j] = a * H_S * H_S / 2;
            F[3 + i][ORR_PARTIAL_ECOM + j] = a * H_S;
        }
    }
    return axes;
}

static orr_mat3 random_transition(orr_transition *t, uint64_t stream, double qf, double qv)
{
    double F[6][ORR_NX];
    const orr_mat3 axes = random_step(F, stream);
    orr_transition_start(t);
    orr_transition_append(t, F, &axes, H_S, qf, qv, false);
    return axes;
}

// Closed form of Q for f0's random walk along one axis: qf (T^5/20, T^4/8, T^3/6; T^3/3, T^2/2; T).
static void process_noise_has_its_closed_form(void **state)
{
    (void)state;
    orr_transition t;
    const orr_mat3 axes = random_transition(&t, 1, 2.0, 0.0);
    double(*Q)[ORR_NW] = t.Q;
    const double T = H_S;
    for (int i = 0; i < 3; i++) {
        ASSERT_NEAR(Q[i][i] / (2 * pow(T, 5) / 20), 1, 1e-14);
        ASSERT_NEAR(Q[i][3 + i] / (2 * pow(T, 4) / 8), 1, 1e-14);
        ASSERT_NEAR(Q[3 + i][3 + i] / (2 * pow(T, 3) / 3), 1, 1e-14);
        ASSERT_NEAR(Q[6 + i][6 + i] / (2 * T), 1, 1e-14);
        for (int j = 0; j < 3; j++) {
            ASSERT_NEAR(Q[i][6 + j], 2 * pow(T, 3) / 6 * axes.m[i][j], 1e-6 * pow(T, 3));
            ASSERT_NEAR(Q[6 + j][3 + i], 2 * T * T / 2 * axes.m[i][j], 1e-9 * T * T);
        }
    }
    random_transition(&t, 1, 0.0, 3.0);
    ASSERT_NEAR(Q[0][0] / (3 * pow(T, 3) / 3), 1, 1e-14);
    ASSERT_NEAR(Q[0][3] / (3 * T * T / 2), 1, 1e-14);
    ASSERT_NEAR(Q[3][3] / (3 * T), 1, 1e-14);
}

// Adds w e'e-like terms: rows of A (m x N), weight W = cov^-1 (m x m), right side y.
static void add_equations(gsl_matrix *normal, gsl_vector *right, const double *A, const double *y,
                          const gsl_matrix *W, size_t m)
{
    for (size_t p = 0; p < N; p++)
        for (size_t i = 0; i < m; i++) {
            if (A[i * N + p] == 0) continue;
            for (size_t j = 0; j < m; j++) {
                double w = A[i * N + p] * gsl_matrix_get(W, i, j);
                *gsl_vector_ptr(right, p) += w * y[j];
                for (size_t q = 0; q < N; q++)
                    if (A[j * N + q] != 0) *gsl_matrix_ptr(normal, p, q) += w * A[j * N + q];
            }
        }
}

static gsl_matrix *inverse_of(const double *P, size_t n)
{
    gsl_matrix *m = gsl_matrix_alloc(n, n);
    for (size_t i = 0; i < n * n; i++) m->data[i] = P[i];
    gsl_linalg_cholesky_decomp1(m);
    gsl_linalg_cholesky_invert(m);
    return m;
}

static void smoother_is_the_batch_least_squares(void **state)
{
    (void)state;
    const double sigma = 0.025, qf = 1e-14, qv = 1e-9; // well conditioned for the dense oracle
    orr_transition t[STEPS];
    orr_gauss pred[STEPS + 1], filt[STEPS + 1], smooth[STEPS + 1];
    orr_vec3 z[STEPS + 1];
    double shift[STEPS + 1][ORR_NX] = {{0}}, u[ORR_NX];
    start(1.0, 1e-2, 1e-5, &pred[0]);
    double P0[NX][NX];
    for (int i = 0; i < NX; i++) memcpy(P0[i], pred[0].P[i], sizeof P0[i]);
    for (int k = 0; k <= STEPS; k++) {
        z[k] = (orr_vec3){0.1 * orr_rng_normal(1, 0, (uint64_t)k), 0.1 * orr_rng_normal(1, 1, (uint64_t)k),
                          0.1 * orr_rng_normal(1, 2, (uint64_t)k)};
        if (k > 0) {
            random_transition(&t[k - 1], (uint64_t)k, qf, qv);
            for (int i = 0; i < 6; i++)
                shift[k][i] = (i < 3 ? 1.0 : 1e-3) * orr_rng_normal(2, (uint64_t)k, (uint64_t)i);
            orr_kalman_predict(&filt[k - 1], &t[k - 1], NX, as_it_is, shift[k], &pred[k]);
        }
        filt[k] = pred[k];
        if (k != 2) orr_kalman_update(&filt[k], NX, z[k], sigma); // one instant without a node
    }
    smooth[STEPS] = filt[STEPS];
    for (int k = STEPS - 1; k >= 0; k--)
        assert_int_equal(orr_kalman_smooth(&filt[k], &t[k], NX, &pred[k + 1], &smooth[k + 1], &smooth[k], u),
                         ORR_OK);

    gsl_matrix *normal = gsl_matrix_calloc(N, N);
    gsl_vector *right = gsl_vector_calloc(N);
    double *A = calloc(NX * N, sizeof *A), y[NX];
    for (size_t i = 0; i < NX; i++) A[i * N + i] = 1, y[i] = 0;
    gsl_matrix *W = inverse_of(&P0[0][0], NX);
    add_equations(normal, right, A, y, W, NX);
    gsl_matrix_free(W);
    for (int k = 0; k <= STEPS; k++) {
        if (k > 0) { // x(k) - F x(k-1) - shift = w
            memset(A, 0, NX * N * sizeof *A);
            for (size_t i = 0; i < NX; i++) {
                A[i * N + (size_t)k * NX + i] = 1;
                for (size_t j = 0; j < NX; j++)
                    A[i * N + (size_t)(k - 1) * NX + j] = i < 6 ? -t[k - 1].F[i][j] : (i == j ? -1 : 0);
                y[i] = i < 6 ? shift[k][i] : 0;
            }
            W = inverse_of(&t[k - 1].Q[0][0], NX);
            add_equations(normal, right, A, y, W, NX);
            gsl_matrix_free(W);
        }
        if (k == 2) continue;
        memset(A, 0, NX * N * sizeof *A);
        double R[9] = {sigma * sigma, 0, 0, 0, sigma * sigma, 0, 0, 0, sigma * sigma};
        for (size_t i = 0; i < 3; i++) A[i * N + (size_t)k * NX + i] = 1;
        y[0] = z[k].x, y[1] = z[k].y, y[2] = z[k].z;
        W = inverse_of(R, 3);
        add_equations(normal, right, A, y, W, 3);
        gsl_matrix_free(W);
    }
    // Solve in scaled unknowns: metres, mm/s, nm/s^2-like sizes differ by 1e8.
    gsl_vector *scale = gsl_vector_alloc(N), *x = gsl_vector_alloc(N);
    gsl_matrix *copy = gsl_matrix_alloc(N, N);
    gsl_matrix_memcpy(copy, normal);
    gsl_linalg_cholesky_decomp2(copy, scale);
    gsl_linalg_cholesky_solve2(copy, scale, right, x);
    for (int k = 0; k <= STEPS; k++)
        for (int i = 0; i < NX; i++) {
            double sigma_x = sqrt(smooth[k].P[i][i]);
            ASSERT_NEAR(smooth[k].x[i], gsl_vector_get(x, (size_t)(k * NX + i)),
                        1e-5 * sigma_x); // the dense solution's rounding
        }
    // Covariances: diagonal of the inverse normal matrix.
    for (size_t i = 0; i < N; i++)
        for (size_t j = 0; j < N; j++)
            gsl_matrix_set(copy, i, j,
                           gsl_matrix_get(normal, i, j) * gsl_vector_get(scale, i) *
                               gsl_vector_get(scale, j));
    gsl_linalg_cholesky_decomp1(copy);
    gsl_linalg_cholesky_invert(copy);
    for (int k = 0; k <= STEPS; k++)
        for (int i = 0; i < NX; i++) {
            size_t p = (size_t)(k * NX + i);
            double variance =
                gsl_matrix_get(copy, p, p) * gsl_vector_get(scale, p) * gsl_vector_get(scale, p);
            ASSERT_NEAR(smooth[k].P[i][i] / variance, 1, 1e-4);
        }
    free(A);
    gsl_matrix_free(normal);
    gsl_matrix_free(copy);
    gsl_vector_free(right);
    gsl_vector_free(scale);
    gsl_vector_free(x);
}

// Over many draws the normalised squared innovation of a true model averages one.
static void innovations_of_a_true_model_average_one(void **state)
{
    (void)state;
    double sum = 0;
    const int draws = 4000;
    for (int n = 0; n < draws; n++) {
        orr_gauss g;
        start(2.0, 1.0, 1.0, &g);
        orr_vec3 z = {0};
        double *c[3] = {&z.x, &z.y, &z.z};
        for (int i = 0; i < 3; i++)
            *c[i] = 2.0 * orr_rng_normal(9, (uint64_t)i, (uint64_t)n) +
                    1.5 * orr_rng_normal(9, (uint64_t)(3 + i), (uint64_t)n);
        double length = 0;
        sum += orr_kalman_innovation2(&g, z, 1.5, &length, NULL);
        ASSERT_NEAR(length, orr_vec3_norm(z), 1e-12);
    }
    ASSERT_NEAR(sum / draws, 1, 4 * sqrt(2.0 / 3 / draws)); // four sigma of the mean of chi^2(3)/3
}

static void indefinite_covariance_is_refused(void **state)
{
    (void)state;
    orr_gauss a, bad;
    orr_transition t;
    double u[ORR_NX];
    random_transition(&t, 3, 0, 0);
    start(1, 1, 1, &a);
    bad = a;
    bad.P[4][4] = -1;
    orr_gauss out;
    assert_int_equal(orr_kalman_smooth(&a, &t, NX, &bad, &a, &out, u), ORR_E_NUMERIC);
}

// A transition of three steps is the three transitions one after the other, in mean and covariance.
static void steps_make_one_transition(void **state)
{
    (void)state;
    orr_transition whole, part;
    orr_gauss a, b;
    const double none[ORR_NX] = {0};
    start(3.0, 1e-2, 1e-6, &a);
    for (int i = 0; i < ORR_NX; i++) a.x[i] = sqrt(a.P[i][i]) * orr_rng_normal(11, 0, (uint64_t)i);
    b = a;
    orr_transition_start(&whole);
    const orr_noise_factor factor = {.q = 0.7, .shadow = 29};
    for (uint64_t k = 0; k < 3; k++) {
        double F[6][ORR_NX];
        const orr_mat3 axes = random_step(F, 20 + k);
        orr_transition_append(&whole, F, &axes, H_S, 1e-16, 0, k == 1);
        orr_transition_start(&part);
        orr_transition_append(&part, F, &axes, H_S, 1e-16, 0, k == 1);
        orr_kalman_predict(&b, &part, ORR_NX, factor, none, &b);
    }
    orr_kalman_predict(&a, &whole, ORR_NX, factor, none, &a);
    for (int i = 0; i < ORR_NX; i++) {
        ASSERT_NEAR(a.x[i], b.x[i], 1e-12 * sqrt(a.P[i][i]));
        for (int j = 0; j < ORR_NX; j++)
            ASSERT_NEAR(a.P[i][j], b.P[i][j], 1e-12 * sqrt(a.P[i][i] * a.P[j][j]));
    }
}

// ECOM's coefficients are constants: smoothed, they and their covariance are the same at all instants.
static void constants_are_smoothed_to_one_value(void **state)
{
    (void)state;
    orr_transition t[STEPS];
    orr_gauss pred[STEPS + 1], filt[STEPS + 1], smooth[STEPS + 1];
    const double none[ORR_NX] = {0};
    double u[ORR_NX];
    start(1.0, 1e-2, 1e-8, &pred[0]);
    for (int k = 0; k <= STEPS; k++) {
        if (k > 0) {
            random_transition(&t[k - 1], (uint64_t)k, 1e-20, 0);
            orr_kalman_predict(&filt[k - 1], &t[k - 1], ORR_NX, as_it_is, none, &pred[k]);
        }
        filt[k] = pred[k];
        orr_kalman_update(&filt[k], ORR_NX, (orr_vec3){0.01 * k, -0.02, 0.03 * (k % 2)}, 1e-3);
    }
    smooth[STEPS] = filt[STEPS];
    for (int k = STEPS - 1; k >= 0; k--)
        assert_int_equal(
            orr_kalman_smooth(&filt[k], &t[k], ORR_NX, &pred[k + 1], &smooth[k + 1], &smooth[k], u), ORR_OK);
    for (int i = ORR_PARTIAL_ECOM; i < ORR_NX; i++) {
        ASSERT_NEAR(smooth[0].x[i], filt[STEPS].x[i], 1e-6 * sqrt(filt[STEPS].P[i][i]));
        ASSERT_NEAR(smooth[0].P[i][i] / filt[STEPS].P[i][i], 1, 1e-6);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_make_one_transition),
        cmocka_unit_test(constants_are_smoothed_to_one_value),
        cmocka_unit_test(process_noise_has_its_closed_form),
        cmocka_unit_test(smoother_is_the_batch_least_squares),
        cmocka_unit_test(innovations_of_a_true_model_average_one),
        cmocka_unit_test(indefinite_covariance_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
