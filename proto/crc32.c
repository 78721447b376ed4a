// SPDX-License-Identifier: MIT
#include "proto/crc32.h"

#include "proto/gen/crc32_table.h"
#include "proto/wire.h"

#ifndef ORR_CRC32_SMALL
// Four bytes of the state or of the data, each through the table of its distance from the end of the block.
static uint32_t fold(uint32_t word, int table)
{
    return orr_crc32_table[table + 3][word & 0xff] ^ orr_crc32_table[table + 2][(word >> 8) & 0xff] ^
           orr_crc32_table[table + 1][(word >> 16) & 0xff] ^ orr_crc32_table[table][word >> 24];
}
#endif

uint32_t orr_crc32(uint32_t crc, const uint8_t *data, size_t n)
{
    crc = ~crc;
#ifndef ORR_CRC32_SMALL
    // Sixteen bytes a step, independent look-ups: some five times the speed of byte by byte.
    for (; n >= 16; n -= 16, data += 16)
        crc = fold(crc ^ orr_wire_load_u32(data), 12) ^ fold(orr_wire_load_u32(data + 4), 8) ^
              fold(orr_wire_load_u32(data + 8), 4) ^ fold(orr_wire_load_u32(data + 12), 0);
#endif
    for (; n > 0; n--, data++) crc = orr_crc32_table[0][(crc ^ *data) & 0xff] ^ (crc >> 8);
    return ~crc;
}
