// SPDX-License-Identifier: GPL-3.0-or-later
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "ingest/tables/sinex.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    orr_sinex x;
    orr_warnings w = {0};
    orr_diag diag = {0};
    orr_read_limits limits = {1 << 20, 5000, 200000, NULL};
    orr_status s = orr_sinex_parse("fuzz", (const char *)data, n, &limits, &x, &w, &diag);
    if (s == ORR_OK) {
        for (size_t i = 0; i < x.n_estimates && i < 8; i++) {
            double p[3];
            const orr_sinex_estimate *e = &x.estimate[i];
            (void)orr_sinex_position(&x, e->code, e->epoch, p);
            if (!isfinite(e->pos_m[0] + e->pos_m[1] + e->pos_m[2])) abort();
            (void)orr_sinex_find_eccentricity(&x, e->code, e->epoch);
        }
        orr_sinex_free(&x);
    } else if (diag.text[0] == '\0') {
        abort(); // a refusal always says why
    }
    orr_warnings_free(&w);
    return 0;
}
