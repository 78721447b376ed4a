// SPDX-License-Identifier: GPL-3.0-or-later
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "ingest/rinex/clk.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    orr_clk x;
    orr_warnings w = {0};
    orr_diag diag = {0};
    orr_read_limits limits = {1 << 20, 5000, 200000, NULL};
    orr_status s = orr_clk_parse("fuzz", (const char *)data, n, &limits, &x, &w, &diag);
    if (s == ORR_OK) {
        for (size_t i = 0; i < x.n_sats; i++) {
            if (orr_clk_find(&x, x.sat[i].sat) == NULL) abort();
            for (size_t k = 1; k < x.sat[i].n; k++)
                if (x.sat[i].record[k].t <= x.sat[i].record[k - 1].t) abort();
        }
        orr_clk_free(&x);
    } else if (diag.text[0] == '\0') {
        abort(); // a refusal always says why
    }
    orr_warnings_free(&w);
    return 0;
}
