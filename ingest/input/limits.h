// SPDX-License-Identifier: GPL-3.0-or-later
// What the smaller readers (IONEX, ION, ERP, CLK, ANTEX, biases, SINEX) refuse to pass, whatever a file says
// of itself.
#ifndef ORR_INGEST_INPUT_LIMITS_H
#define ORR_INGEST_INPUT_LIMITS_H

#include <stddef.h>

#include "core/leap.h"

typedef struct orr_read_limits {
    size_t max_bytes; // after decompression
    // Epochs of maps, clock records, biases, coordinates, antennas: what the reader counts
    size_t max_records;
    size_t max_values;          // numbers kept in grids (IONEX maps, ANTEX patterns, ION coefficients)
    const orr_leap_table *leap; // that UTC and GLONASS labels are converted by; NULL: built-in
} orr_read_limits;

// 2 GiB, 20 million, 100 million. A NULL `limits` means these everywhere.
orr_read_limits orr_read_default_limits(void);

#endif
