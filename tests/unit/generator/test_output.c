// SPDX-License-Identifier: GPL-3.0-or-later
// What is written: noise of the right size and shape that depends on nothing but seed and number, rounding, clipping, packing.
#include "testing.h"

#include "src/generator/kernel/output.h"

#define N 200000
static int32_t re[N], im[N];
static uint8_t bytes[8 * N], other[8 * N];
static orr_gen_noise table;

// Sums of one group of channels before a last one of silence.
static size_t write_sums(const orr_gen_output *out, const int32_t *a, const int32_t *b, int64_t first,
                         size_t n, uint8_t *to)
{
    static const int16_t silence[N];
    return orr_gen_output_write(out, &(orr_gen_sums){silence, silence, a, b, 1e9}, first, n, to);
}

static int setup(void **state)
{
    (void)state;
    orr_gen_noise_init(&table);
    return 0;
}

static float f32(const uint8_t *b)
{
    const uint32_t w = (uint32_t)b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
    float x;
    memcpy(&x, &w, 4);
    return x;
}

// Moments and tails of the normal distribution, and no correlation between I and Q or neighbours: 200,000 samples.
static void noise_is_normal(void **state)
{
    (void)state;
    const orr_gen_output out = {.format = ORR_GEN_F32, .gain = 1, .sigma = 3, .noise = &table, .seed = 5};
    memset(re, 0, sizeof re);
    memset(im, 0, sizeof im);
    write_sums(&out, re, im, 123456789012345, N, bytes);
    double m[5] = {0}, cross = 0, lag = 0, last = 0;
    size_t beyond[4] = {0};
    for (size_t k = 0; k < N; k++) {
        const double x = (double)f32(bytes + 8 * k) / 3, y = (double)f32(bytes + 8 * k + 4) / 3;
        for (int p = 1; p <= 4; p++) m[p] += pow(x, p) / N;
        cross += x * y / N, lag += x * last / N, last = x;
        for (size_t s = 1; s < 4; s++) beyond[s] += fabs(x) > (double)s;
    }
    const double e = 1 / sqrt((double)N); // standard deviation of a mean
    ASSERT_NEAR(m[1], 0, 4 * e);
    ASSERT_NEAR(m[2], 1, 4 * sqrt(2) * e);
    ASSERT_NEAR(m[3], 0, 4 * sqrt(15) * e);
    ASSERT_NEAR(m[4], 3, 4 * sqrt(96) * e);
    ASSERT_NEAR(cross, 0, 4 * e);
    ASSERT_NEAR(lag, 0, 4 * e);
    const double tail[4] = {0, 0.317310508, 0.045500264, 0.002699796};
    for (size_t s = 1; s < 4; s++) ASSERT_NEAR((double)beyond[s] / N, tail[s], 4 * sqrt(tail[s]) * e);
}

// The noise of a sample is the same wherever a call begins, and another with another seed.
static void noise_by_number(void **state)
{
    (void)state;
    orr_gen_output out = {.format = ORR_GEN_I16, .gain = 0.25, .sigma = 500, .noise = &table, .seed = 1};
    for (size_t k = 0; k < 3000; k++) re[k] = (int32_t)k, im[k] = -(int32_t)k;
    write_sums(&out, re, im, 1000, 3000, bytes);
    for (size_t from = 0; from < 3000;) {
        const size_t n = from % 7 + 1 + from / 3, m = from + n < 3000 ? n : 3000 - from;
        write_sums(&out, re + from, im + from, 1000 + (int64_t)from, m, other + 4 * from);
        from += m;
    }
    assert_memory_equal(bytes, other, 12000);
    out.seed = 2;
    write_sums(&out, re, im, 1000, 3000, other);
    size_t same = 0;
    for (size_t k = 0; k < 6000; k++) same += memcmp(bytes + 2 * k, other + 2 * k, 2) == 0;
    assert_true(same < 30);
}

static void rounding_and_clipping(void **state)
{
    (void)state;
    orr_gen_output out = {.format = ORR_GEN_I8, .gain = 0.1};
    const int32_t a[6] = {14, 16, -14, -16, 1269, 1280}, b[6] = {0, 0, 0, -1268, -1290, 40000};
    assert_int_equal(write_sums(&out, a, b, 0, 6, bytes), 3); // 128, -129 and 4000 are beyond 127
    const int8_t want[12] = {1, 0, 2, 0, -1, 0, -2, -127, 127, -127, 127, 127};
    assert_memory_equal(bytes, want, 12);
    out.format = ORR_GEN_I16;
    assert_int_equal(write_sums(&out, a, b, 0, 6, bytes), 0);
    assert_int_equal(bytes[22] | bytes[23] << 8, 4000);
    assert_int_equal((int16_t)(bytes[18] | bytes[19] << 8), -129);
    out.gain = 1;
    assert_int_equal(write_sums(&out, a, b, 0, 6, bytes), 1);
    assert_int_equal(bytes[22] | bytes[23] << 8, 32767);
}

// The last group alone, and behind others; what cannot be clipped is not looked at, and is the same.
static void groups(void **state)
{
    (void)state;
    enum { HALF = 1000 };
    static int16_t a[N], b[N];
    for (size_t k = 0; k < HALF; k++) {
        a[k] = (int16_t)(k * 31), b[k] = (int16_t)(-7 * (int)k);
        re[k] = 5 * a[k], im[k] = -3 * b[k];
    }
    const orr_gen_output out = {.format = ORR_GEN_I16, .gain = 0.0987};
    orr_gen_output_write(&out, &(orr_gen_sums){a, b, re, im, 6 * 31000}, 0, HALF, bytes);
    for (size_t k = 0; k < HALF; k++) re[k] = 6 * a[k], im[k] = -2 * b[k];
    write_sums(&out, re, im, 0, HALF, other);
    assert_memory_equal(bytes, other, 4 * HALF);
    orr_gen_output_write(&out, &(orr_gen_sums){a, b, NULL, NULL, 31000}, 0, HALF, bytes);
    for (size_t k = 0; k < HALF; k++) re[k] = a[k], im[k] = b[k];
    write_sums(&out, re, im, 0, HALF, other);
    assert_memory_equal(bytes, other, 4 * HALF);
}

// Two bits: the sign, and whether the magnitude is one or more.
static void packing(void **state)
{
    (void)state;
    const orr_gen_output out = {.format = ORR_GEN_I2, .gain = 0.01};
    const int32_t a[3] = {50, -150, 100}, b[3] = {-99, 200, -3};
    assert_int_equal(orr_gen_output_size(ORR_GEN_I2, 3), 3);
    write_sums(&out, a, b, 0, 3, bytes);
    assert_int_equal(bytes[0], 0x0 | 0x1 << 2);
    assert_int_equal(bytes[1], 0x3 | 0x2 << 2);
    assert_int_equal(bytes[2], 0x2 | 0x1 << 2);
    assert_int_equal(orr_gen_output_pack(bytes, 3), 2);
    assert_int_equal(bytes[0], 0x4 | 0xb << 4);
    assert_int_equal(bytes[1], 0x6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(noise_is_normal), cmocka_unit_test(noise_by_number),
                                       cmocka_unit_test(rounding_and_clipping), cmocka_unit_test(groups),
                                       cmocka_unit_test(packing)};
    return cmocka_run_group_tests(tests, setup, NULL);
}
