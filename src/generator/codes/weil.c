// SPDX-License-Identifier: MIT
// Codes that are sums of two Legendre sequences, one shifted: B1C and the secondary codes of its pilot and of B2a's.
#include <string.h>

#include "src/generator/codes/assignments_private.h"
#include "src/generator/codes/codes_private.h"

#define LEGENDRE_LARGEST 10243

// L(0) = 0, L(k) = 1 where k is a square modulo n (BDS-SIS-ICD-B1C-1.0 5.2.1), as chips.
static void legendre(size_t n, int8_t *l)
{
    memset(l, 1, n);
    for (size_t k = 1; k < n; k++) l[k * k % n] = -1;
}

// W(k) = L(k) + L(k + w), from point p (counted from 1) on: eq. (5-2), (5-3).
static void weil_chips(size_t n, weil a, size_t count, int8_t *chips)
{
    int8_t l[LEGENDRE_LARGEST];
    legendre(n, l);
    for (size_t i = 0; i < count; i++) {
        const size_t k = (i + a.p - 1) % n;
        chips[i] = (int8_t)(l[k] * l[(k + a.w) % n]);
    }
}

bool orr_gen_weil_fill(orr_gen_code code, unsigned prn, int8_t *chips)
{
    if (prn < 1 || prn > 63) return false;
    weil_chips(10243, (code == ORR_GEN_B1C_DATA ? b1c_data : b1c_pilot)[prn - 1], 10230, chips);
    return true;
}

size_t orr_gen_weil_secondary(orr_gen_code code, unsigned prn, int8_t *chips)
{
    if (prn < 1 || prn > 63) return 0;
    const bool b1c = code == ORR_GEN_B1C_PILOT;
    const size_t n = b1c ? 1800 : 100;
    weil_chips(b1c ? 3607 : 1021, (b1c ? b1c_secondary : b2a_secondary)[prn - 1], n, chips);
    return n;
}
