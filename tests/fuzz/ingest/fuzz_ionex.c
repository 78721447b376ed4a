// SPDX-License-Identifier: GPL-3.0-or-later
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "ingest/maps/ionex.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    orr_ionex x;
    orr_warnings w = {0};
    orr_diag diag = {0};
    orr_read_limits limits = {1 << 20, 5000, 200000, NULL};
    orr_status s = orr_ionex_parse("fuzz", (const char *)data, n, &limits, &x, &w, &diag);
    if (s == ORR_OK) {
        if (x.n_epochs == 0 || x.n_heights == 0 || x.n_lats == 0 || x.n_lons == 0) abort();
        for (size_t i = 1; i < x.n_epochs; i++)
            if (x.epoch[i] <= x.epoch[i - 1]) abort();
        size_t last = orr_ionex_index(&x, x.n_epochs - 1, x.n_heights - 1, x.n_lats - 1, x.n_lons - 1);
        double sum = 0; // touches the ends of every array
        if (x.tec_tecu != NULL) sum += x.tec_tecu[0] + x.tec_tecu[last];
        if (x.rms_tecu != NULL) sum += x.rms_tecu[0] + x.rms_tecu[last];
        if (x.hgt_m != NULL) sum += x.hgt_m[0] + x.hgt_m[last];
        if (isinf(sum)) abort();
        orr_ionex_free(&x);
    } else if (diag.text[0] == '\0') {
        abort(); // a refusal always says why
    }
    orr_warnings_free(&w);
    return 0;
}
