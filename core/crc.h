// SPDX-License-Identifier: GPL-3.0-or-later
// CRC-24Q, the parity of modern navigation messages and RTCM. (CRC-32 of files is zlib's; the wire's is
// proto's own.)
#ifndef ORR_CORE_CRC_H
#define ORR_CORE_CRC_H

#include <stddef.h>
#include <stdint.h>

uint32_t orr_crc24q(uint32_t crc, const uint8_t *data, size_t n); // start with 0

#endif
