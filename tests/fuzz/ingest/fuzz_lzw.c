// SPDX-License-Identifier: GPL-3.0-or-later
// The .Z decoder alone: the first byte chooses the settings, so that every input gets past the header.
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "ingest/input/input.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    if (n < 1) return 0;
    uint8_t *z = malloc(n + 2);
    if (z == NULL) return 0;
    z[0] = 0x1f;
    z[1] = 0x9d;
    z[2] = (uint8_t)((data[0] & 0x80) | (9 + data[0] % 8));
    memcpy(z + 3, data + 1, n - 1);
    orr_input_limits limits = {
        .max_bytes = 1 << 24, .max_line = 1 << 16, .max_ratio = 1000, .ratio_grace = 1 << 22};
    orr_bytes text;
    orr_diag diag = {0};
    if (orr_input_read_bytes("fuzz", z, n + 2, &limits, &text, &diag) == ORR_OK) orr_bytes_free(&text);
    free(z);
    return 0;
}
