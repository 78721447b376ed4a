// SPDX-License-Identifier: GPL-3.0-or-later
#include "glonass_decoder.h"

#include <math.h>

// Bit 1..85 as the ICD numbers them; 85 is the first of data[0].
uint32_t glo_bit(const orr_glonass_string *s, int number)
{
    int k = 85 - number;
    return s->data[k / 8] >> (7 - k % 8) & 1u;
}

uint32_t glo_get(const orr_glonass_string *s, int low, int high)
{
    uint32_t v = 0;
    for (int k = high; k >= low; k--) v = v << 1 | glo_bit(s, k);
    return v;
}

double glo_signed(const orr_glonass_string *s, int low, int high)
{
    double size = glo_get(s, low, high - 1);
    return glo_bit(s, high) ? -size : size;
}

// Table 4.13: which bits the checksums C1 to C7 add, beside check bit 1 to 7; C sigma adds all.
bool glo_sums_are_zero(const orr_glonass_string *s)
{
    static const uint8_t member[7][42] = {
        {9,  10, 12, 13, 15, 17, 19, 20, 22, 24, 26, 28, 30, 32, 34, 35, 37, 39, 41, 43, 45,
         47, 49, 51, 53, 55, 57, 59, 61, 63, 65, 66, 68, 70, 72, 74, 76, 78, 80, 82, 84},
        {9,  11, 12, 14, 15, 18, 19, 21, 22, 25, 26, 29, 30, 33, 34, 36, 37, 40, 41, 44, 45,
         48, 49, 52, 53, 56, 57, 60, 61, 64, 65, 67, 68, 71, 72, 75, 76, 79, 80, 83, 84},
        {10, 11, 12, 16, 17, 18, 19, 23, 24, 25, 26, 31, 32, 33, 34, 38, 39, 40, 41, 46,
         47, 48, 49, 54, 55, 56, 57, 62, 63, 64, 65, 69, 70, 71, 72, 77, 78, 79, 80, 85},
        {13, 14, 15, 16, 17, 18, 19, 27, 28, 29, 30, 31, 32, 33, 34, 42, 43, 44, 45, 46,
         47, 48, 49, 58, 59, 60, 61, 62, 63, 64, 65, 73, 74, 75, 76, 77, 78, 79, 80},
        {20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 50, 51, 52,
         53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 81, 82, 83, 84, 85},
        {35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50,
         51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65},
        {66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83, 84, 85},
    };
    uint32_t all = 0, any = 0;
    for (int k = 1; k <= 85; k++) all ^= glo_bit(s, k);
    for (int c = 0; c < 7; c++) {
        uint32_t sum = glo_bit(s, c + 1);
        for (int k = 0; k < 42 && member[c][k] != 0; k++) sum ^= glo_bit(s, member[c][k]);
        any |= sum;
    }
    return all == 0 && any == 0;
}

orr_glonass_almanac glo_almanac(const orr_glonass_string *s, const orr_glonass_string *q)
{
    int h = (int)glo_get(q, 10, 14);
    return (orr_glonass_almanac){.number = (int)glo_get(s, 73, 77),
                                 .operational = glo_get(s, 80, 80),
                                 .type = (int)glo_get(s, 78, 79),
                                 .channel = h > 24 ? h - 32 : h,
                                 .tau_s = ldexp(glo_signed(s, 63, 72), -18),
                                 .lambda_rad = ORR_PI * ldexp(glo_signed(s, 42, 62), -20),
                                 .t_lambda_s = glo_get(q, 44, 64) / 32.0,
                                 .delta_i_rad = ORR_PI * ldexp(glo_signed(s, 24, 41), -20),
                                 .delta_t_s = glo_signed(q, 22, 43) / 512.0,
                                 .delta_t_rate = ldexp(glo_signed(q, 15, 21), -14),
                                 .e = ldexp(glo_get(s, 9, 23), -20),
                                 .omega_rad = ORR_PI * ldexp(glo_signed(q, 65, 80), -15)};
}
