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

void orr_reed_solomon(const uint8_t *information, size_t n, uint8_t *parity, size_t most)
{
    uint8_t generator[64] = {1}; // of degree `most`, lowest coefficient first
    uint8_t root = 1;
    for (size_t k = 0; k < most; k++) {
        root = times(root, 2);
        for (size_t j = k + 1; j > 0; j--)
            generator[j] = (uint8_t)(generator[j - 1] ^ times(root, generator[j]));
        generator[0] = times(root, generator[0]);
    }
    memset(parity, 0, most);
    for (size_t k = n; k-- > 0;) { // division of the information by the generator, highest coefficient first
        const uint8_t factor = information[k] ^ parity[most - 1];
        for (size_t j = most - 1; j > 0; j--) parity[j] = parity[j - 1] ^ times(factor, generator[j]);
        parity[0] = times(factor, generator[0]);
    }
}
