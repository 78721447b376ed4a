// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/crc.h"

#define POLYNOMIAL UINT32_C(0x1864CFB) // IS-GPS-200N, 30.3.5.1

uint32_t orr_crc24q(uint32_t crc, const uint8_t *data, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        crc ^= (uint32_t)data[i] << 16;
        for (int bit = 0; bit < 8; bit++) {
            crc <<= 1;
            if ((crc & UINT32_C(0x1000000)) != 0) crc ^= POLYNOMIAL;
        }
    }
    return crc & UINT32_C(0xFFFFFF);
}
