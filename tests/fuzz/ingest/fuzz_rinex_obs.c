// SPDX-License-Identifier: GPL-3.0-or-later
// The observation reader, plain and Hatanaka (and whatever compression the bytes claim).
#include <stdint.h>
#include <stdlib.h>

#include "ingest/rinex/rinex_obs.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    orr_rinex_obs *r = NULL;
    orr_warnings w = {0};
    orr_diag diag = {0};
    orr_rinex_obs_limits limits = {1 << 20, 10000, 1000, 999, NULL};
    if (orr_rinex_obs_open_memory("fuzz", (const char *)data, n, &limits, &w, &r, &diag) == ORR_OK) {
        const orr_rinex_obs_epoch *e = NULL;
        while (orr_rinex_obs_next(r, &e, &diag) == ORR_OK && e != NULL) {
            const orr_rinex_obs_header *h = orr_rinex_obs_header_of(r);
            for (size_t i = 0; i < e->n_sats; i++) {
                int s = orr_sat_system_index(e->sat[i]);
                if (s < 0 || h->codes[s].n == 0 || h->codes[s].n > e->stride) abort();
                volatile double last = e->value[i * e->stride + h->codes[s].n - 1]; // must be ours to read
                (void)last;
            }
        }
        orr_rinex_obs_close(r);
    }
    orr_warnings_free(&w);
    return 0;
}
