// SPDX-License-Identifier: GPL-3.0-or-later
// Navigation files of several days or stations as one.
#include <stdlib.h>
#include <string.h>

#include "ingest/rinex/rinex_nav_private.h"

static int by_use(const void *a, const void *b)
{
    const orr_nav_eph *x = a, *y = b;
    if (x->sat != y->sat) return x->sat < y->sat ? -1 : 1;
    if (x->toe != y->toe) return x->toe < y->toe ? -1 : 1;
    if (x->toc != y->toc) return x->toc < y->toc ? -1 : 1;
    if (x->transmission != y->transmission) return x->transmission < y->transmission ? -1 : 1;
    return (int)x->message - (int)y->message;
}

// The files' order among those, whatever the sorting routine does.
static int by_use_and_place(const void *a, const void *b)
{
    const orr_nav_eph *x = a, *y = b;
    int c = by_use(a, b);
    return c != 0 ? c : (x->order > y->order) - (x->order < y->order);
}

orr_status orr_nav_merge(const orr_nav *in, size_t n, orr_nav *out, orr_warnings *warnings, orr_diag *diag)
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
    for (size_t i = 0; i < out->n_eph; i++) out->eph[i].order = (uint32_t)i;
    qsort(out->eph, out->n_eph, sizeof *out->eph, by_use_and_place);
    size_t kept = 0; // what two stations recorded is one record
    for (size_t i = 0; i < out->n_eph; i++) {
        bool again = false;
        for (size_t k = kept; k > 0 && !again && by_use(&out->eph[k - 1], &out->eph[i]) == 0; k--)
            again = orr_nav_same_orbit(&out->eph[k - 1], &out->eph[i]) &&
                    orr_nav_same_rest(&out->eph[k - 1], &out->eph[i]);
        if (!again) out->eph[kept++] = out->eph[i];
    }
    out->n_eph = kept;
    orr_nav_tell_conflicts(out->eph, kept, NULL, warnings);
    return ORR_OK;
}
