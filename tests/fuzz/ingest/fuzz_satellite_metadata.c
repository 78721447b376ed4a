// SPDX-License-Identifier: GPL-3.0-or-later
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "ingest/tables/satellite_metadata.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    orr_satellite_metadata m;
    orr_warnings w = {0};
    orr_diag diag = {0};
    orr_read_limits limits = {1 << 20, 5000, 200000, NULL};
    orr_status s = orr_satellite_metadata_parse("fuzz", (const char *)data, n, &limits, &m, &w, &diag);
    if (s == ORR_OK) {
        for (size_t i = 0; i < m.n; i++) {
            const orr_metadata_line *x = &m.line[i];
            if (strlen(x->svn) != 4 || !isfinite(x->value) || memchr(x->block, '\0', sizeof x->block) == NULL)
                abort();
            const char *svn = orr_satellite_metadata_svn(&m, x->sat, x->from);
            if (svn != NULL) (void)orr_satellite_metadata_at(&m, ORR_METADATA_POWER, svn, x->from);
        }
        orr_satellite_metadata_free(&m);
    } else if (diag.text[0] == '\0') {
        abort(); // a refusal always says why
    }
    orr_warnings_free(&w);
    return 0;
}
