// SPDX-License-Identifier: MIT
// How sums become what is written, compiled for each kind of processor as phasor_private.h is.
#ifndef ORR_GENERATOR_KERNEL_OUTPUT_PRIVATE_H
#define ORR_GENERATOR_KERNEL_OUTPUT_PRIVATE_H

#include "src/generator/kernel/output.h"

#include <math.h>
#include <string.h>

#define BATCH 256
#define TABLE_SIGMA 7000.0 // value of the table at one standard deviation: 4.3 of them fit into 16 bits
#define NEAREST 0x1.8p23f  // added and taken off, it rounds a float below 2^22 to the nearest integer

// A function of the number alone that looks like chance (Steele, Lea and Flood 2014, variant 13 of its mixer).
static inline uint64_t scatter(uint64_t x)
{
    x *= 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

// Adds the noise of samples first .. first + n - 1; a number gives that of two, of which the first is even.
static inline void add_noise(const orr_gen_output *out, int64_t first, size_t n, float *restrict re,
                             float *restrict im)
{
    const float scale = (float)(out->sigma / TABLE_SIGMA);
    const int16_t *value = out->noise->value;
    const uint64_t seed = scatter(out->seed + 1), pair = (uint64_t)first / 2;
    int16_t x[BATCH + 2], y[BATCH + 2]; // from the even sample on
    const size_t odd = (size_t)((uint64_t)first % 2);
    for (size_t k = 0; k < n + odd; k += 2) {
        const uint64_t r = scatter(seed + pair + k / 2);
        x[k] = value[r & 0xffff];
        y[k] = value[r >> 16 & 0xffff];
        x[k + 1] = value[r >> 32 & 0xffff];
        y[k + 1] = value[r >> 48];
    }
    for (size_t k = 0; k < n; k++) re[k] += scale * (float)x[k + odd];
    for (size_t k = 0; k < n; k++) im[k] += scale * (float)y[k + odd];
}

// Numbers in the order of the file, the lowest byte first.
static inline uint16_t little16(uint16_t x)
{
    return __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ? x : __builtin_bswap16(x);
}

static inline uint32_t little32(uint32_t x)
{
    return __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ? x : __builtin_bswap32(x);
}

static inline uint64_t little64(uint64_t x)
{
    return __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ? x : __builtin_bswap64(x);
}

static inline uint32_t bits_of(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, 4);
    return bits;
}

// Brings x between -most and most, and counts what did not lie there.
static inline size_t clip(float *x, size_t n, float most)
{
    int32_t clipped = 0;
    for (size_t k = 0; k < n; k++) {
        const float v = x[k], low = v > most ? most : v, within = low < -most ? -most : low;
        clipped += within != v;
        x[k] = within;
    }
    return (size_t)clipped;
}

// The nearest integer of |x| < 2^22, in the lowest 16 bits.
static inline uint32_t whole(float x) { return bits_of(x + NEAREST); }

// I and Q are the halves of one number, of which compilers make vectors.
static inline void put_i8(const float *restrict re, const float *restrict im, size_t n,
                          uint8_t *restrict bytes)
{
    for (size_t k = 0; k < n; k++) {
        const uint16_t both = little16((uint16_t)((whole(re[k]) & 0xff) | (whole(im[k]) & 0xff) << 8));
        memcpy(bytes + 2 * k, &both, 2);
    }
}

static inline void put_i16(const float *restrict re, const float *restrict im, size_t n,
                           uint8_t *restrict bytes)
{
    for (size_t k = 0; k < n; k++) {
        const uint32_t both = little32((whole(re[k]) & 0xffff) | whole(im[k]) << 16);
        memcpy(bytes + 4 * k, &both, 4);
    }
}

static inline void put_f32(const float *restrict re, const float *restrict im, size_t n,
                           uint8_t *restrict bytes)
{
    for (size_t k = 0; k < n; k++) {
        const uint64_t both = little64(bits_of(re[k]) | (uint64_t)bits_of(im[k]) << 32);
        memcpy(bytes + 8 * k, &both, 8);
    }
}

static inline unsigned two_bits(float x) { return (x < 0 ? 1u : 0u) | (fabsf(x) >= 1 ? 2u : 0u); }

static inline void put_i2(const float *re, const float *im, size_t n, uint8_t *bytes)
{
    for (size_t k = 0; k < n; k++) bytes[k] = (uint8_t)(two_bits(re[k]) | two_bits(im[k]) << 2);
}

// Sums of samples `at` and so on, times the gain.
static inline void scale(const orr_gen_sums *sums, bool im, size_t at, size_t n, float gain,
                         float *restrict x)
{
    const int16_t *restrict last = (im ? sums->im : sums->re) + at;
    if (sums->rest_re == NULL) {
        for (size_t k = 0; k < n; k++) x[k] = gain * (float)last[k];
        return;
    }
    const int32_t *restrict rest = (im ? sums->rest_im : sums->rest_re) + at;
    for (size_t k = 0; k < n; k++) x[k] = gain * (float)(rest[k] + last[k]);
}

// What a format holds; infinite where nothing is clipped.
static inline float most_of(orr_gen_format format)
{
    return format == ORR_GEN_I8 ? 127.0f : format == ORR_GEN_I16 ? 32767.0f : (float)INFINITY;
}

static inline size_t write_all(const orr_gen_output *out, const orr_gen_sums *sums, int64_t first, size_t n,
                               uint8_t *bytes)
{
    size_t clipped = 0;
    const float gain = (float)out->gain, most = most_of(out->format);
    const bool clips = out->sigma > 0 ? most < (float)INFINITY : out->gain * sums->most > (double)most - 1;
    for (size_t at = 0; at < n; at += BATCH) {
        const size_t m = n - at < BATCH ? n - at : BATCH;
        float x[BATCH], y[BATCH];
        scale(sums, false, at, m, gain, x);
        scale(sums, true, at, m, gain, y);
        if (out->sigma > 0) add_noise(out, first + (int64_t)at, m, x, y);
        if (clips) clipped += clip(x, m, most) + clip(y, m, most);
        uint8_t *to = bytes + orr_gen_output_size(out->format, at);
        switch (out->format) {
        case ORR_GEN_I8:
            put_i8(x, y, m, to);
            break;
        case ORR_GEN_I16:
            put_i16(x, y, m, to);
            break;
        case ORR_GEN_I2:
            put_i2(x, y, m, to);
            break;
        default:
            put_f32(x, y, m, to);
            break;
        }
    }
    return clipped;
}

#endif
