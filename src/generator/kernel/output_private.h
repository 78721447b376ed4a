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
    float x[BATCH + 2], y[BATCH + 2]; // from the even sample on
    const size_t odd = (size_t)((uint64_t)first % 2);
    for (size_t k = 0; k < n + odd; k += 2) {
        const uint64_t r = scatter(seed + pair + k / 2);
        x[k] = (float)value[r & 0xffff];
        y[k] = (float)value[r >> 16 & 0xffff];
        x[k + 1] = (float)value[r >> 32 & 0xffff];
        y[k + 1] = (float)value[r >> 48];
    }
    for (size_t k = 0; k < n; k++) re[k] += scale * x[k + odd];
    for (size_t k = 0; k < n; k++) im[k] += scale * y[k + odd];
}

// Rounds what lies between -most and most, and counts what does not.
static inline size_t clip(float *x, size_t n, float most)
{
    int32_t clipped = 0;
    for (size_t k = 0; k < n; k++) {
        const float v = x[k], low = v > most ? most : v, within = low < -most ? -most : low;
        clipped += within != v;
        x[k] = (within + NEAREST) - NEAREST;
    }
    return (size_t)clipped;
}

static inline void put_i8(const float *restrict re, const float *restrict im, size_t n, uint8_t *bytes)
{
    int8_t out[2 * BATCH];
    for (size_t k = 0; k < n; k++) {
        out[2 * k] = (int8_t)(int32_t)re[k];
        out[2 * k + 1] = (int8_t)(int32_t)im[k];
    }
    memcpy(bytes, out, 2 * n);
}

static inline bool little_endian(void)
{
    const uint16_t one = 1;
    uint8_t low;
    memcpy(&low, &one, 1);
    return low == 1;
}

// Puts numbers of `size` bytes in the order of the file.
static inline void put_little(const void *numbers, size_t count, size_t size, uint8_t *bytes)
{
    if (little_endian()) {
        memcpy(bytes, numbers, count * size);
        return;
    }
    const uint8_t *from = numbers;
    for (size_t k = 0; k < count; k++)
        for (size_t j = 0; j < size; j++) bytes[k * size + j] = from[k * size + size - 1 - j];
}

static inline void put_i16(const float *restrict re, const float *restrict im, size_t n, uint8_t *bytes)
{
    int16_t out[2 * BATCH];
    for (size_t k = 0; k < n; k++) {
        out[2 * k] = (int16_t)(int32_t)re[k];
        out[2 * k + 1] = (int16_t)(int32_t)im[k];
    }
    put_little(out, 2 * n, sizeof out[0], bytes);
}

static inline void put_f32(const float *restrict re, const float *restrict im, size_t n, uint8_t *bytes)
{
    float out[2 * BATCH];
    for (size_t k = 0; k < n; k++) {
        out[2 * k] = re[k];
        out[2 * k + 1] = im[k];
    }
    put_little(out, 2 * n, sizeof out[0], bytes);
}

static inline unsigned two_bits(float x) { return (x < 0 ? 1u : 0u) | (fabsf(x) >= 1 ? 2u : 0u); }

static inline void put_i2(const float *re, const float *im, size_t n, uint8_t *bytes)
{
    for (size_t k = 0; k < n; k++) bytes[k] = (uint8_t)(two_bits(re[k]) | two_bits(im[k]) << 2);
}

static inline size_t write_all(const orr_gen_output *out, const int32_t *re, const int32_t *im, int64_t first,
                               size_t n, uint8_t *bytes)
{
    size_t clipped = 0;
    const float gain = (float)out->gain;
    for (size_t at = 0; at < n; at += BATCH) {
        const size_t m = n - at < BATCH ? n - at : BATCH;
        float x[BATCH], y[BATCH];
        for (size_t k = 0; k < m; k++) x[k] = gain * (float)re[at + k];
        for (size_t k = 0; k < m; k++) y[k] = gain * (float)im[at + k];
        if (out->sigma > 0) add_noise(out, first + (int64_t)at, m, x, y);
        const float most = out->format == ORR_GEN_I8 ? 127 : 32767;
        if (out->format == ORR_GEN_I8 || out->format == ORR_GEN_I16)
            clipped += clip(x, m, most) + clip(y, m, most);
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
