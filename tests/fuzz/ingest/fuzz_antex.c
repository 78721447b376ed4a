// SPDX-License-Identifier: GPL-3.0-or-later
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "ingest/tables/antex.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    orr_antex x;
    orr_warnings w = {0};
    orr_diag diag = {0};
    orr_read_limits limits = {1 << 20, 5000, 200000, NULL};
    orr_status s = orr_antex_parse("fuzz", (const char *)data, n, &limits, &x, &w, &diag);
    if (s == ORR_OK) {
        for (size_t i = 0; i < x.n_antennas; i++) {
            const orr_antex_antenna *a = &x.antenna[i];
            for (size_t k = 0; k < a->n_frequencies; k++)
                for (double z = -10; z < 100; z += 37)
                    if (!isfinite(orr_antex_variation_m(a, &a->frequency[k], 7.3 * z, z))) abort();
            (void)orr_antex_find_sat(&x, a->sat, 0);
            (void)orr_antex_find_receiver(&x, a->type, NULL);
        }
        orr_antex_free(&x);
    } else if (diag.text[0] == '\0') {
        abort(); // a refusal always says why
    }
    orr_warnings_free(&w);
    return 0;
}
