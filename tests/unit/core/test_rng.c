// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include "core/rng.h"

// Known answers of Philox 2x64-10 (Random123's kat_vectors): counter, key, result.
static void known_answers(void **state)
{
    (void)state;
    assert_true(orr_rng_u64(0, 0, 0) == UINT64_C(0xca00a0459843d731));
    assert_true(orr_rng_u64(UINT64_MAX, UINT64_MAX, UINT64_MAX) == UINT64_C(0x65b021d60cd8310f));
    assert_true(orr_rng_u64(UINT64_C(0xa4093822299f31d0), UINT64_C(0x13198a2e03707344),
                            UINT64_C(0x243f6a8885a308d3)) == UINT64_C(0x0a5e742c2997341c));
}

enum { N = 1000000 };

static void uniform_numbers_are_uniform(void **state)
{
    (void)state;
    enum { BINS = 100 };
    int bin[BINS] = {0};
    double lag = 0, previous = 0.5;
    for (uint64_t k = 0; k < N; k++) {
        double u = orr_rng_uniform(11, 3, k);
        assert_true(u >= 0 && u < 1);
        bin[(int)(u * BINS)]++;
        lag += (u - 0.5) * (previous - 0.5);
        previous = u;
    }
    double chi2 = 0;
    for (int i = 0; i < BINS; i++) chi2 += pow(bin[i] - N / (double)BINS, 2) / (N / (double)BINS);
    assert_true(chi2 > 45 && chi2 < 175); // 99 degrees of freedom, 1e-5 each side; the seed is fixed
    ASSERT_NEAR(lag / N * 12, 0, 4.5 / sqrt((double)N)); // correlation of neighbours
}

// Moments and tails of what `draw` gives, N of them.
static void expect_normal(double (*draw)(uint64_t k))
{
    double m[5] = {0};
    int beyond[5] = {0};
    for (uint64_t k = 0; k < N; k++) {
        double z = draw(k), p = 1;
        for (int i = 1; i <= 4; i++) m[i] += (p *= z);
        for (int i = 1; i <= 4; i++) beyond[i] += fabs(z) > i ? 1 : 0;
    }
    // moments 0, 1, 0, 3 with standard errors 1, sqrt 2, sqrt 15, sqrt 96 over sqrt N; 4.5 of them allowed
    const double expected[] = {0, 0, 1, 0, 3}, error[] = {0, 1, 1.4142, 3.873, 9.798};
    for (int i = 1; i <= 4; i++) ASSERT_NEAR(m[i] / N, expected[i], 4.5 * error[i] / sqrt((double)N));
    for (int i = 1; i <= 4; i++) {
        double p = erfc(i / sqrt(2.0));
        ASSERT_NEAR(beyond[i] / (double)N, p, 4.5 * sqrt(p * (1 - p) / N));
    }
}

// Known answers of Philox 4x32-10 (Random123's kat_vectors): counter and key of zeros, and of ones.
static void philox_of_32_bits_has_its_known_answers(void **state)
{
    (void)state;
    uint32_t r[4];
    orr_rng_u32(0, 0, 0, r);
    assert_true(r[0] == 0x6627e8d5 && r[1] == 0xe169c58d && r[2] == 0xbc57ac4c && r[3] == 0x9b00dbd8);
    orr_rng_u32(UINT64_MAX, UINT64_MAX, UINT64_MAX, r);
    assert_true(r[0] == 0x408f276d && r[1] == 0x41c83b0e && r[2] == 0xa20bc7c6 && r[3] == 0x6d5451fd);
}

static double one(uint64_t k) { return orr_rng_normal(12, 5, k); }
static double of_a_block(uint64_t k)
{
    double block[ORR_RNG_BLOCK];
    orr_rng_normals(12, 5, k / ORR_RNG_BLOCK, block);
    return block[k % ORR_RNG_BLOCK];
}

static void normal_numbers_are_normal(void **state)
{
    (void)state;
    expect_normal(one);
    expect_normal(of_a_block);
    // Within a block: each against each, and their squares (a radius serves two).
    double cross[ORR_RNG_BLOCK][ORR_RNG_BLOCK] = {{0}}, squares[ORR_RNG_BLOCK][ORR_RNG_BLOCK] = {{0}};
    const int blocks = 20000;
    for (int k = 0; k < blocks; k++) {
        double z[ORR_RNG_BLOCK];
        orr_rng_normals(3, 4, (uint64_t)k, z);
        for (int i = 0; i < ORR_RNG_BLOCK; i++)
            for (int j = 0; j < i; j++) {
                cross[i][j] += z[i] * z[j] / blocks;
                squares[i][j] += (z[i] * z[i] - 1) * (z[j] * z[j] - 1) / 2 / blocks;
            }
    }
    for (int i = 0; i < ORR_RNG_BLOCK; i++)
        for (int j = 0; j < i; j++) {
            ASSERT_NEAR(cross[i][j], 0, 4.5 / sqrt((double)blocks));
            ASSERT_NEAR(squares[i][j], 0, 6.0 / sqrt((double)blocks));
        }
}

static void streams_seeds_and_counters_are_unrelated(void **state)
{
    (void)state;
    double by_stream = 0, by_seed = 0, mean_of_streams = 0;
    const uint64_t n = 100000;
    for (uint64_t k = 0; k < n; k++) {
        double a = orr_rng_normal(1, 1, k);
        by_stream += a * orr_rng_normal(1, 2, k);
        by_seed += a * orr_rng_normal(2, 1, k);
        mean_of_streams += orr_rng_normal(9, k, 0); // across streams at one counter
    }
    const double error = 4.5 / sqrt((double)n);
    ASSERT_NEAR(by_stream / (double)n, 0, error);
    ASSERT_NEAR(by_seed / (double)n, 0, error);
    ASSERT_NEAR(mean_of_streams / (double)n, 0, error);
    // a pure function: asked again, and in another order
    assert_true(orr_rng_u64(1, 2, 3) == orr_rng_u64(1, 2, 3));
    assert_true(orr_rng_u64(1, 2, 3) != orr_rng_u64(1, 3, 2));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_answers),
        cmocka_unit_test(uniform_numbers_are_uniform),
        cmocka_unit_test(philox_of_32_bits_has_its_known_answers),
        cmocka_unit_test(normal_numbers_are_normal),
        cmocka_unit_test(streams_seeds_and_counters_are_unrelated),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
