// SPDX-License-Identifier: GPL-3.0-or-later
// The oscillators and the mixer against exact evaluation of the cubics, the hundred vectors, and each other.
#include "testing.h"

#include "src/generator/codes/codes.h"
#include "src/generator/kernel/kernel.h"
#include "src/generator/kernel/periods.h"

#define TAU 6.283185307179586477
#define C 299792458.0L

// --- The vectors: words to the bit, phases within what a chord may err ---

static int64_t field_i(char **at)
{
    const int64_t v = (int64_t)strtoll(*at, at, 10);
    if (**at == ',') (*at)++;
    return v;
}

static uint64_t field_u(char **at)
{
    const uint64_t v = strtoull(*at, at, 16);
    if (**at == ',') (*at)++;
    return v;
}

static double field_d(char **at)
{
    const double v = strtod(*at, at);
    if (**at == ',') (*at)++;
    return v;
}

static double apart(double a, double b) // of cycles
{
    return fabs(remainder(a - b, 1.0));
}

static void vectors(void **state)
{
    (void)state;
    FILE *f = fopen(ORR_SOURCE_DIR "/src/generator/kernel/vectors.csv", "r");
    assert_non_null(f);
    char line[2048];
    int n = 0;
    double worst_cycle = 0, worst_chip = 0;
    while (fgets(line, sizeof line, f) != NULL) {
        if (line[0] == '#' || line[0] == 'b') continue;
        char *at = line;
        orr_gen_cubics c = {0};
        orr_gen_tuning t = {0};
        orr_gen_oscillator o;
        c.block_ns = field_i(&at);
        for (int k = 0; k < 4; k++) c.code_m[k] = field_d(&at);
        for (int k = 0; k < 4; k++) c.carrier_cycles[k] = field_d(&at);
        c.transmit_ns = field_i(&at);
        c.transmit_rest_ns = field_d(&at);
        t.rate_hz = (uint32_t)field_i(&at);
        t.offset_hz = field_i(&at);
        t.chips_per_s = (uint32_t)field_i(&at);
        const int64_t first = field_i(&at);
        const uint32_t count = (uint32_t)field_i(&at);
        orr_gen_oscillators(&c, &t, first, count, &o);
        assert_true(o.carrier == field_u(&at));
        assert_true(o.carrier_step == field_u(&at));
        assert_true(o.code_s == field_i(&at));
        assert_true(o.code == field_u(&at));
        assert_true(o.code_step == field_u(&at));
        const uint64_t k = (uint64_t)field_i(&at);
        const uint64_t carrier = o.carrier + k * o.carrier_step, code = o.code + k * o.code_step;
        assert_true(carrier == field_u(&at));
        assert_true(code == field_u(&at));
        const double cycle = apart((double)carrier * 0x1p-64, field_d(&at));
        const double chip = fabs(ldexp((double)code, -ORR_GEN_CODE_BITS) - field_d(&at));
        if (cycle > worst_cycle) worst_cycle = cycle;
        if (chip > worst_chip) worst_chip = chip;
        n++;
    }
    fclose(f);
    assert_int_equal(n, 100);
    print_message("100 vectors: carrier %.2g cycle, code %.2g sub-chip from exact\n", worst_cycle,
                  worst_chip);
    // A chord over 4096 samples of 4 Msps and 25 m/s2 + 10 m/s2 of jerk's growth errs by 5e-5 cycle of L1.
    ASSERT_NEAR(worst_cycle, 0, 6e-5);
    ASSERT_NEAR(worst_chip, 0, 1e-6);
}

// --- A channel played over many pieces, against the cubic at every sample ---

typedef struct played {
    orr_gen_cubics cubics;
    orr_gen_tuning tuning;
    const int8_t *chips; // a period and more
    uint64_t period;     // sub-chips
    orr_gen_chips kind;
    double amplitude;
} played;

static orr_gen_period same_period(void *user, int64_t number, size_t from, size_t to)
{
    const played *p = user;
    (void)number;
    assert_true(from < to && to <= p->period);
    return (orr_gen_period){p->chips, 1};
}

// One piece, as a program would.
static void play(played *p, const orr_gen_kernel *kernel, int64_t first, uint32_t n, int16_t *re, int16_t *im)
{
    orr_gen_oscillator o;
    orr_gen_carrier c;
    orr_gen_oscillators(&p->cubics, &p->tuning, first, n, &o);
    const size_t groups = n / ORR_GEN_GROUP;
    kernel->carrier(o.carrier, o.carrier_step, p->amplitude, groups, &c);
    const uint64_t period = p->period << ORR_GEN_CODE_BITS;
    const orr_gen_code_at code = {0, p->period, o.code % period, o.code_step, p->kind, same_period, p};
    orr_gen_periods_mix(kernel->mix, &c, &code, groups, re, im);
}

static played channel(double acceleration, uint32_t rate, int64_t offset, uint32_t chips_per_s,
                      double carrier_hz)
{
    played p = {.tuning = {rate, offset, chips_per_s}, .amplitude = 2000};
    p.cubics.block_ns = 1390910400000000000;
    const double code[4] = {2.2345678901e7, -412.345, acceleration / 2, acceleration / 3};
    for (int k = 0; k < 4; k++)
        p.cubics.code_m[k] = code[k], p.cubics.carrier_cycles[k] = code[k] * carrier_hz / (double)C;
    p.cubics.carrier_cycles[0] = 0.7654321;
    p.cubics.transmit_ns = p.cubics.block_ns - 74536789;
    p.cubics.transmit_rest_ns = 0.123;
    return p;
}

typedef struct exact {
    long double cycles, chips; // sub-chips since the second of the transmit time at the block's begin
} exact;

static exact at_sample(const played *p, int64_t sample)
{
    const int64_t s = p->cubics.block_ns / 1000000000; // whole seconds: blocks of these tests begin there
    const long double t = (long double)(sample - s * p->tuning.rate_hz) / (long double)p->tuning.rate_hz;
    long double c[4], m[4];
    for (int k = 0; k < 4; k++)
        c[k] = (long double)p->cubics.carrier_cycles[k], m[k] = (long double)p->cubics.code_m[k];
    const long double phase =
        (long double)p->tuning.offset_hz * t - (c[0] + t * (c[1] + t * (c[2] + t * c[3])));
    const long double begin =
        ((long double)(p->cubics.transmit_ns % 1000000000) + (long double)p->cubics.transmit_rest_ns) / 1e9L;
    const long double sent = begin + t - t * (m[1] + t * (m[2] + t * m[3])) / C;
    return (exact){phase, sent * (long double)p->tuning.chips_per_s};
}

// Carrier: without code, phase of each sample and of correlations of 1 ms.
static void carrier_against_exact(void **state)
{
    (void)state;
    static const struct {
        uint32_t rate;
        int64_t offset;
        double acceleration;
    } row[] = {{2600000, 0, 0.2}, {5000000, 420000, 3}, {10000000, -3937500, 25}, {25000000, 1000000, 25}};
    int8_t ones[4096];
    memset(ones, 1, sizeof ones);
    for (size_t i = 0; i < 4; i++) {
        played p = channel(row[i].acceleration, row[i].rate, row[i].offset, 1023000, 1575.42e6);
        p.chips = ones, p.period = 1023;
        const int64_t begin = p.cubics.block_ns / 1000000000 * row[i].rate;
        const uint32_t ms = row[i].rate / 1000;
        double worst = 0, square = 0, correlation = 0;
        long n = 0;
        double sum_re = 0, sum_im = 0;
        for (uint32_t piece = 0; piece < 60; piece++) {
            int16_t re[ORR_GEN_PIECE] = {0}, im[ORR_GEN_PIECE] = {0};
            play(&p, orr_gen_kernel_best(), begin + piece * (int64_t)ORR_GEN_PIECE, ORR_GEN_PIECE, re, im);
            for (uint32_t k = 0; k < ORR_GEN_PIECE; k++, n++) {
                const long double cycles = at_sample(&p, begin + n).cycles;
                const double angle = TAU * (double)remainderl(cycles, 1.0L);
                const double c = cos(angle), s = sin(angle);
                const double a = re[k] * c + im[k] * s, b = im[k] * c - re[k] * s;
                const double error = atan2(b, a) / TAU;
                if (fabs(error) > worst) worst = fabs(error);
                square += error * error;
                sum_re += a, sum_im += b;
                if ((n + 1) % ms == 0) {
                    const double e = fabs(atan2(sum_im, sum_re) / TAU);
                    if (e > correlation) correlation = e;
                    sum_re = sum_im = 0;
                }
            }
        }
        print_message("carrier at %g Msps, %g m/s2: %.2g cycle RMS, %.2g a sample, %.2g in 1 ms\n",
                      row[i].rate / 1e6, row[i].acceleration, sqrt(square / (double)n), worst, correlation);
        ASSERT_NEAR(worst, 0, 2e-4);
        ASSERT_NEAR(correlation, 0, 2e-5);
    }
}

// Code: which sub-chip each sample has, with the carrier at rest; how far from an edge wrong ones are, and on which side.
static void code_against_exact(void **state)
{
    (void)state;
    static const struct {
        uint32_t rate, chips_per_s;
        unsigned factor; // sub-chips of one of 1.023 MHz
        double bar;
    } row[] = {{2600000, 1023000, 1, 1e-4},     {5000000, 1023000, 1, 1e-4},
               {10000000, 511000, 1, 1e-4},     {5000000, 2046000, 1, 1e-4},
               {25000000, 10230000, 1, 1e-4},   {4000000, 2046000, 2, 1.3e-4},
               {12500000, 10230000, 1, 1.3e-4}, {25000000, 12276000, 12, 1.3e-4}};
    static int8_t chips[20460 + 64];
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        played p = channel(25, row[i].rate, 0, row[i].chips_per_s, 0);
        p.cubics.carrier_cycles[0] = 0;
        p.period = row[i].chips_per_s / 1000;
        p.chips = chips, p.kind = ORR_GEN_LEVELS, p.amplitude = 8191;
        for (size_t k = 0; k < p.period + 32; k++)
            chips[k] = (int8_t)(1 + (k % p.period) % 64); // a sub-chip is told by its level
        const int64_t begin = p.cubics.block_ns / 1000000000 * row[i].rate;
        double worst = 0;
        long n = 0, early = 0, late = 0;
        for (uint32_t piece = 0; piece < 150; piece++) {
            int16_t re[ORR_GEN_PIECE] = {0}, im[ORR_GEN_PIECE] = {0};
            play(&p, orr_gen_kernel_best(), begin + piece * (int64_t)ORR_GEN_PIECE, ORR_GEN_PIECE, re, im);
            for (uint32_t k = 0; k < ORR_GEN_PIECE; k++, n++) {
                const long double x = at_sample(&p, begin + n).chips;
                const long whole = (long)floorl(x);
                const int level = (re[k] + 32) / 64, wanted = (int)(whole % (long)p.period % 64 + 1);
                if (level == wanted) continue;
                const double part = (double)(x - whole), edge = part > 0.5 ? 1 - part : part;
                if (edge > worst) worst = edge;
                if (part > 0.5)
                    early++;
                else
                    late++;
            }
        }
        const double bias = (double)(early - late) / (double)n;
        print_message("code at %g Msps, %g Mchip/s: wrong within %.2g chip of an edge, bias %.1e chip, of "
                      "%ld samples %ld wrong\n",
                      row[i].rate / 1e6, row[i].chips_per_s / 1e6, worst, bias, n, early + late);
        ASSERT_NEAR(worst, 0, row[i].bar);
        // Wrong samples come at random: three standard deviations of their number beside the bar.
        ASSERT_NEAR(bias, 0, 1e-5 + 3 * sqrt((double)(early + late)) / (double)n);
    }
}

// The least code word from 0 on with which sample i of a group has sub-chip `chip`, which is within one of its own.
static uint64_t edge_of(const orr_gen_carrier *c, const int8_t *chips, uint64_t step, unsigned i,
                        uint64_t chip)
{
    uint64_t low = 0, high = (uint64_t)1 << ORR_GEN_CODE_BITS; // it has it with `high`
    while (low < high) {
        const uint64_t code = low + (high - low) / 2;
        int16_t re[ORR_GEN_GROUP] = {0}, im[ORR_GEN_GROUP] = {0};
        const orr_gen_run run = {c, 0, 1, 1, chips, code, step, ORR_GEN_LEVELS};
        orr_gen_mix_plain(&run, re, im);
        if ((uint64_t)(re[i] + 32) / 64 > chip)
            high = code;
        else
            low = code + 1;
    }
    return low;
}

// Where the edges of eight samples are, for steps of many sizes: that what steps are rounded by is not early or late in the mean,
// for any rate. (In samples of a pass the mean is hidden by how few of them are next to an edge.)
static void edges_are_neither_early_nor_late(void **state)
{
    (void)state;
    int8_t chips[ORR_GEN_CHIPS_BEYOND];
    for (int k = 0; k < ORR_GEN_CHIPS_BEYOND; k++) chips[k] = (int8_t)(1 + k);
    orr_gen_carrier c;
    orr_gen_carrier_plain(0, 0, 8191, 1, &c);
    const double unit = ldexp(1, ORR_GEN_CODE_BITS);
    double most_mean = 0, most_edge = 0;
    for (unsigned n = 0; n < 1000; n++) {
        const uint64_t step =
            (uint64_t)(unit * ORR_GEN_CHIPS_IN_SAMPLE * fmod(0.6180339887498949 * (n + 1), 1));
        double mean = 0;
        for (unsigned i = 0; i < 8; i++) {
            const uint64_t next = (i * step >> ORR_GEN_CODE_BITS) + 1;
            const uint64_t edge = edge_of(&c, chips, step, i, next);
            const double early = ((double)next * unit - (double)(edge + i * step)) / unit;
            if (fabs(early) > most_edge) most_edge = fabs(early);
            mean += early / 8;
        }
        if (fabs(mean) > most_mean) most_mean = fabs(mean);
    }
    print_message("edges of 1000 rates: %.2g sub-chip in the mean of eight samples at most, %.2g of one\n",
                  most_mean, most_edge);
    ASSERT_NEAR(most_mean, 0, ldexp(1, -17)); // half of 1/8192 of one sample in eight
    ASSERT_NEAR(most_edge, 0, 1e-4);
}

// Chips of every level at a phasor of known size: what is added is amplitude * level / 128, and amplitude * chip.
static void levels(void **state)
{
    (void)state;
    static int8_t chips[96];
    for (int level = -127; level <= 127; level++) {
        memset(chips, level, sizeof chips);
        orr_gen_carrier c;
        orr_gen_carrier_plain(0, 0, 6400, 2, &c);
        int16_t re[64] = {0}, im[64] = {0};
        const orr_gen_run run = {&c, 0, 2, 1, chips, 0, (uint64_t)1 << 38, ORR_GEN_LEVELS};
        orr_gen_mix_plain(&run, re, im);
        for (int k = 0; k < 64; k++) {
            ASSERT_NEAR(re[k], level * 50, 1);
            assert_int_equal(im[k], 0);
        }
    }
}

// Two periods with signs of their own: what each sample has at and about the border, for borders at every place of a group.
static orr_gen_period signed_period(void *user, int64_t number, size_t from, size_t to)
{
    (void)from, (void)to;
    return (orr_gen_period){user, number % 3 == 0 ? 1 : -1};
}

static void borders(void **state)
{
    (void)state;
    enum { CHIPS = 100, GROUPS = 12 };
    int8_t chips[CHIPS + ORR_GEN_CHIPS_BEYOND];
    for (int k = 0; k < CHIPS + ORR_GEN_CHIPS_BEYOND; k++) chips[k] = (int8_t)(1 + k % CHIPS);
    const uint64_t step = (uint64_t)1 << (ORR_GEN_CODE_BITS - 1); // half a chip a sample
    for (size_t begin = 0; begin < CHIPS; begin++)
        for (size_t kernel = 0; orr_gen_kernel_at(kernel) != NULL; kernel++) {
            const orr_gen_kernel *k = orr_gen_kernel_at(kernel);
            orr_gen_carrier c;
            int16_t re[GROUPS * ORR_GEN_GROUP] = {0}, im[GROUPS * ORR_GEN_GROUP] = {0};
            k->carrier(0, 0, 6400, GROUPS, &c);
            const orr_gen_code_at code = {
                7, CHIPS, (uint64_t)begin << ORR_GEN_CODE_BITS, step, ORR_GEN_LEVELS, signed_period, chips};
            orr_gen_periods_mix(k->mix, &c, &code, GROUPS, re, im);
            for (size_t n = 0; n < GROUPS * ORR_GEN_GROUP; n++) {
                const size_t chip = begin + n / 2;
                const int sign = (7 + chip / CHIPS) % 3 == 0 ? 1 : -1;
                ASSERT_NEAR(re[n], sign * 50 * (int)(1 + chip % CHIPS), 1);
            }
        }
}

// Spurious-free dynamic range of the carrier alone: the largest line beside it, by a discrete Fourier transform under a window of
// four terms (Blackman and Harris, side lobes at -92 dB).
#define FFT 65536
static void transform(double *re, double *im)
{
    for (size_t i = 1, j = 0; i < FFT; i++) {
        size_t bit = FFT >> 1;
        for (; j & bit; bit >>= 1) j ^= bit;
        j ^= bit;
        if (i >= j) continue;
        double t = re[i];
        re[i] = re[j], re[j] = t;
        t = im[i], im[i] = im[j], im[j] = t;
    }
    for (size_t n = 2; n <= FFT; n *= 2)
        for (size_t k = 0; k < n / 2; k++) {
            const double c = cos(TAU * (double)k / (double)n), s = -sin(TAU * (double)k / (double)n);
            for (size_t at = k; at < FFT; at += n) {
                const size_t o = at + n / 2;
                const double x = re[o] * c - im[o] * s, y = re[o] * s + im[o] * c;
                re[o] = re[at] - x, im[o] = im[at] - y;
                re[at] += x, im[at] += y;
            }
        }
}

static void spectrum(void **state)
{
    (void)state;
    static double re[FFT], im[FFT];
    int8_t ones[4096];
    memset(ones, 1, sizeof ones);
    for (int i = 0; i < 3; i++) {
        played p = channel(0, 5000000, i * 777777, 1023000, 1575.42e6);
        p.cubics.carrier_cycles[2] = p.cubics.carrier_cycles[3] = 0;
        p.chips = ones, p.period = 1023, p.amplitude = 1000;
        const int64_t begin = p.cubics.block_ns / 1000000000 * 5000000;
        for (size_t piece = 0; piece < FFT / ORR_GEN_PIECE; piece++) {
            int16_t a[ORR_GEN_PIECE] = {0}, b[ORR_GEN_PIECE] = {0};
            play(&p, orr_gen_kernel_best(), begin + (int64_t)(piece * ORR_GEN_PIECE), ORR_GEN_PIECE, a, b);
            for (size_t k = 0; k < ORR_GEN_PIECE; k++) {
                const double x = TAU * (double)(piece * ORR_GEN_PIECE + k) / FFT;
                const double w = 0.35875 - 0.48829 * cos(x) + 0.14128 * cos(2 * x) - 0.01168 * cos(3 * x);
                re[piece * ORR_GEN_PIECE + k] = w * a[k], im[piece * ORR_GEN_PIECE + k] = w * b[k];
            }
        }
        transform(re, im);
        size_t peak = 0;
        for (size_t k = 0; k < FFT; k++) {
            re[k] = re[k] * re[k] + im[k] * im[k];
            if (re[k] > re[peak]) peak = k;
        }
        double spur = 0;
        for (size_t k = 0; k < FFT; k++) {
            const size_t away = (k + FFT - peak) % FFT;
            if (away > 6 && away < FFT - 6 && re[k] > spur) spur = re[k];
        }
        const double sfdr = 10 * log10(re[peak] / spur);
        print_message("carrier of amplitude 1000 at %.6g Hz: spurious-free range %.1f dB\n",
                      (double)peak * 5e6 / FFT, sfdr);
        assert_true(sfdr >= 70);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vectors),
        cmocka_unit_test(carrier_against_exact),
        cmocka_unit_test(code_against_exact),
        cmocka_unit_test(edges_are_neither_early_nor_late),
        cmocka_unit_test(levels),
        cmocka_unit_test(borders),
        cmocka_unit_test(spectrum),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
