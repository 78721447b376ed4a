// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdint.h>
#include <stdlib.h>

#include "ingest/rinex/rinex_nav.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    orr_nav nav;
    orr_warnings w = {0};
    orr_diag diag = {0};
    orr_nav_limits limits = {1 << 20, 10000, 1000, NULL};
    if (orr_nav_parse("fuzz", (const char *)data, n, &limits, &nav, &w, &diag) == ORR_OK) {
        for (size_t i = 0; i < nav.n_eph; i++) {
            size_t first = 0, count = 0;
            orr_nav_of_sat(&nav, nav.eph[i].sat, &first, &count);
            if (count == 0 || nav.eph[i].toe == ORR_TIME_NONE) abort(); // what was read must be found
            (void)orr_nav_eph_usable(&nav.eph[i]);
        }
        orr_nav_free(&nav);
    }
    orr_warnings_free(&w);
    return 0;
}
