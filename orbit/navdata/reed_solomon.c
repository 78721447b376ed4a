// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/reed_solomon.h"

#include <string.h>

static uint8_t times(uint8_t a, uint8_t b)
{
    unsigned product = 0, x = a;
    for (; b != 0; b >>= 1) {
        if (b & 1u) product ^= x;
        x <<= 1;
        if (x & 0x100u) x ^= 0x11du;
    }
    return (uint8_t)product;
}

void orr_reed_solomon(const uint8_t *information, size_t n, uint8_t parity[ORR_REED_SOLOMON_PARITY])
{
    // (x - alpha)(x - alpha^2) ... (x - alpha^60), lowest coefficient first; that of x^60 is 1.
    static const uint8_t generator[ORR_REED_SOLOMON_PARITY] = {
        193, 91,  190, 154, 101, 58,  231, 197, 152, 88,  73,  62,  169, 88,  188, 23, 36,  202, 63, 20,
        102, 230, 131, 141, 214, 45,  101, 94,  62,  65,  66,  46,  131, 42,  187, 9,  122, 3,   19, 118,
        6,   154, 14,  193, 79,  251, 124, 18,  186, 244, 166, 235, 167, 108, 41,  19, 76,  48,  42, 208};
    const size_t most = ORR_REED_SOLOMON_PARITY;
    memset(parity, 0, most);
    for (size_t k = n; k-- > 0;) { // division of the information by the generator, highest coefficient first
        const uint8_t factor = information[k] ^ parity[most - 1];
        for (size_t j = most - 1; j > 0; j--) parity[j] = parity[j - 1] ^ times(factor, generator[j]);
        parity[0] = times(factor, generator[0]);
    }
}
