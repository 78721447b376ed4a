// SPDX-License-Identifier: GPL-3.0-or-later
// CRC-24Q, the parity of CNAV and of RTCM 3 messages. (The CRC-32 of gzip files is zlib's; that of the wire
// is proto's own.)
#ifndef ORR_CORE_CRC_H
#define ORR_CORE_CRC_H

#include <stddef.h>
#include <stdint.h>

// The CRC of n more bytes behind those that gave `crc`; 0 at the start. 24 bits.
uint32_t orr_crc24q(uint32_t crc, const uint8_t *data, size_t n);

#endif
