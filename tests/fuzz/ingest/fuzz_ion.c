// SPDX-License-Identifier: GPL-3.0-or-later
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "ingest/maps/ion.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    orr_ion x;
    orr_warnings w = {0};
    orr_diag diag = {0};
    orr_read_limits limits = {1 << 20, 5000, 200000, NULL};
    orr_status s = orr_ion_parse("fuzz", (const char *)data, n, &limits, &x, &w, &diag);
    if (s == ORR_OK) {
        if (x.n_models == 0) abort();
        for (size_t i = 0; i < x.n_models; i++) {
            const orr_ion_model *m = &x.model[i];
            if (m->n_coefficients == 0 || m->from == ORR_TIME_NONE) abort();
            for (size_t k = 0; k < m->n_coefficients; k++)
                if (!isfinite(m->coefficient[k].tecu) || m->coefficient[k].degree > m->max_degree) abort();
        }
        orr_ion_free(&x);
    } else if (diag.text[0] == '\0') {
        abort(); // a refusal always says why
    }
    orr_warnings_free(&w);
    return 0;
}
