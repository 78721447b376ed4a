// SPDX-License-Identifier: GPL-3.0-or-later
// Navigation files of several days or stations as one.
#include <stdlib.h>
#include <string.h>

#include "ingest/rinex/rinex_nav.h"

static int by_use(const void *a, const void *b)
{
    const orr_nav_eph *x = a, *y = b;
    if (x->sat != y->sat) return x->sat < y->sat ? -1 : 1;
    if (x->toe != y->toe) return x->toe < y->toe ? -1 : 1;
    if (x->toc != y->toc) return x->toc < y->toc ? -1 : 1;
    if (x->transmission != y->transmission) return x->transmission < y->transmission ? -1 : 1;
    return (int)x->message - (int)y->message;
}

orr_status orr_nav_merge(const orr_nav *in, size_t n, orr_nav *out, orr_diag *diag)
{
    size_t total = 0, n_iono = 0;
    for (size_t i = 0; i < n; i++) total += in[i].n_eph, n_iono += in[i].n_iono;
    *out = (orr_nav){.version = n > 0 ? in[0].version : 0, .system = 'M'};
    out->eph = malloc((total + 1) * sizeof *out->eph);
    out->iono = malloc((n_iono + 1) * sizeof *out->iono);
    if (out->eph == NULL || out->iono == NULL) {
        orr_nav_free(out);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu ephemerides", total);
    }
    for (size_t i = 0; i < n; i++) {
        if (in[i].n_iono > 0) memcpy(out->iono + out->n_iono, in[i].iono, in[i].n_iono * sizeof *out->iono);
        out->n_iono += in[i].n_iono;
        if (in[i].n_eph > 0) memcpy(out->eph + out->n_eph, in[i].eph, in[i].n_eph * sizeof *out->eph);
        out->n_eph += in[i].n_eph;
    }
    qsort(out->eph, out->n_eph, sizeof *out->eph, by_use);
    size_t kept = 0; // what two stations recorded is one record
    for (size_t i = 0; i < out->n_eph; i++)
        if (kept == 0 || by_use(&out->eph[kept - 1], &out->eph[i]) != 0) out->eph[kept++] = out->eph[i];
    out->n_eph = kept;
    return ORR_OK;
}
