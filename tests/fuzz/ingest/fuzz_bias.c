// SPDX-License-Identifier: GPL-3.0-or-later
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "ingest/tables/bias.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    orr_bias_set x;
    orr_warnings w = {0};
    orr_diag diag = {0};
    orr_read_limits limits = {1 << 20, 5000, 200000, NULL};
    orr_status s = orr_bias_parse("fuzz", (const char *)data, n, &limits, &x, &w, &diag);
    if (s == ORR_OK) {
        if (x.n == 0) abort();
        for (size_t i = 0; i < x.n && i < 8; i++) {
            double v;
            const orr_bias *b = &x.bias[i];
            if (b->obs1[0] == '\0' || (b->sat == ORR_SAT_NONE && b->station[0] == '\0')) abort();
            (void)orr_bias_osb(&x, b->sat, b->obs1, b->from, &v);
            (void)orr_bias_dsb(&x, b->sat, b->obs1, b->obs2, b->from, &v);
        }
        orr_bias_free(&x);
    } else if (diag.text[0] == '\0') {
        abort(); // a refusal always says why
    }
    orr_warnings_free(&w);
    return 0;
}
