// SPDX-License-Identifier: GPL-3.0-or-later
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "ingest/tables/erp.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    orr_erp x;
    orr_warnings w = {0};
    orr_diag diag = {0};
    orr_read_limits limits = {1 << 20, 5000, 200000, NULL};
    orr_status s = orr_erp_parse("fuzz", (const char *)data, n, NULL, &limits, &x, &w, &diag);
    if (s == ORR_OK) {
        orr_eop_series both = {0};
        orr_erp pair[2] = {x, x};
        if (x.series.n == 0 || orr_erp_merge(pair, 2, &both, &diag) != ORR_OK || both.n != x.series.n)
            abort();
        for (size_t i = 0; i < x.series.n; i++) {
            if (i > 0 && x.series.mjd_utc[i] <= x.series.mjd_utc[i - 1]) abort();
            if (!(fabs(x.series.value[i].ut1_utc_s) <= 1.0)) abort();
        }
        orr_erp_series_free(&both);
        orr_erp_free(&x);
    } else if (diag.text[0] == '\0') {
        abort(); // a refusal always says why
    }
    orr_warnings_free(&w);
    return 0;
}
