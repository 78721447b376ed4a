// SPDX-License-Identifier: MIT
// The frame's checksum: CRC-32 of ISO 3309 / IEEE 802.3 / zlib (polynomial 0x04C11DB7 reflected, all ones in
// and out; "123456789" gives 0xCBF43926).
#ifndef ORR_PROTO_CRC32_H
#define ORR_PROTO_CRC32_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// Continues a checksum; start with 0. Define ORR_CRC32_SMALL at compile time for one table of 1 KiB instead
// of sixteen.
uint32_t orr_crc32(uint32_t crc, const uint8_t *data, size_t n);

#ifdef __cplusplus
}
#endif

#endif
