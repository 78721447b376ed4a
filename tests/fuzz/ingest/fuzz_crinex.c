// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdint.h>
#include <stdlib.h>

#include "ingest/rinex/crinex.h"

static bool swallow(void *user, const char *line, size_t n)
{
    size_t *total = user;
    *total += n;
    if (n > 0 && line[n - 1] == ' ') abort(); // lines come without trailing blanks
    return true;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    orr_input *in = NULL;
    orr_warnings w = {0};
    orr_diag diag = {0};
    orr_input_limits limits = orr_input_default_limits();
    limits.max_bytes = 1 << 20;
    size_t total = 0;
    if (orr_input_open_bytes("fuzz", data, n, &limits, &in, &diag) == ORR_OK) {
        orr_crinex_expand(in, swallow, &total, &w, &diag);
        orr_input_close(in);
    }
    orr_warnings_free(&w);
    return 0;
}
