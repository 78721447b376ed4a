// SPDX-License-Identifier: GPL-3.0-or-later
// What is read keeps the reader's promises, and what can be written again reads the same.
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "ingest/sp3/sp3.h"

static int same(double a, double b) { return a == b || (isnan(a) && isnan(b)); }

// All but the deviations, which are written as the nearest power.
static int same_record(const orr_sp3_record *a, const orr_sp3_record *b)
{
    int ok = a->flags == b->flags && same(a->clock_rate_sps, b->clock_rate_sps);
    // A clock of nothing beside a position that is missing reads as missing.
    ok = ok && (same(a->clock_s, b->clock_s) || isnan(a->pos_m[0]));
    for (int i = 0; i < 3; i++)
        ok = ok && same(a->pos_m[i], b->pos_m[i]) && same(a->vel_mps[i], b->vel_mps[i]);
    return ok;
}

// Numbers finer than the columns were read from odd places and cannot come back; whole last decimals must.
static int on_grid(const orr_sp3 *s)
{
    for (size_t i = 0; i < s->n_sats * s->n_epochs; i++) {
        const orr_sp3_record *r = &s->record[i];
        for (int k = 0; k < 3; k++) {
            if (!isnan(r->pos_m[k]) && rint(r->pos_m[k] / 1e-3) / 1e3 != r->pos_m[k]) return 0;
            if (!isnan(r->vel_mps[k]) && rint(r->vel_mps[k] / 1e-7) / 1e7 != r->vel_mps[k]) return 0;
        }
        if (!isnan(r->clock_s) && rint(r->clock_s / 1e-12) / 1e12 != r->clock_s) return 0;
        if (!isnan(r->clock_rate_sps) && rint(r->clock_rate_sps / 1e-16) / 1e16 != r->clock_rate_sps)
            return 0;
    }
    return 1;
}

static void write_and_read(const orr_sp3 *a, const orr_sp3_limits *limits)
{
    char *text = NULL;
    size_t n = 0;
    orr_diag diag = {0};
    FILE *f = open_memstream(&text, &n);
    if (f == NULL) abort();
    orr_status st = orr_sp3_print(a, f, &diag);
    fclose(f);
    if (st != ORR_OK && st != ORR_E_ARG) abort();
    orr_sp3 b;
    if (st == ORR_OK && on_grid(a)) {
        st = orr_sp3_parse("again", text, n, limits, &b, NULL, &diag);
        if (st == ORR_E_LIMIT) { // comments are filled up to four
            free(text);
            return;
        }
        if (st != ORR_OK || b.n_sats != a->n_sats || b.n_epochs != a->n_epochs || b.scale != a->scale)
            abort();
        for (size_t e = 0; e < a->n_epochs; e++)
            if (a->epoch[e] != b.epoch[e]) abort();
        for (size_t s = 0; s < a->n_sats; s++)
            if (a->sat[s] != b.sat[s] || a->accuracy_exp[s] != b.accuracy_exp[s]) abort();
        for (size_t i = 0; i < a->n_sats * a->n_epochs; i++)
            if (!same_record(&a->record[i], &b.record[i])) abort();
        orr_sp3_free(&b);
    }
    free(text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    orr_sp3 sp3;
    orr_warnings w = {0};
    orr_diag diag = {0};
    orr_sp3_limits limits = {1 << 20, 200, 5000, 100, NULL};
    orr_status st = orr_sp3_parse("fuzz", (const char *)data, n, &limits, &sp3, &w, &diag);
    if (st == ORR_OK) {
        if (sp3.n_sats == 0 || sp3.n_epochs == 0) abort();
        for (size_t e = 1; e < sp3.n_epochs; e++)
            if (sp3.epoch[e] <= sp3.epoch[e - 1]) abort();
        for (size_t i = 0; i < sp3.n_sats * sp3.n_epochs; i++)
            if (sp3.record[i].flags > 15 || isinf(sp3.record[i].pos_m[0]) || sp3.record[i].clock_s >= 1)
                abort();
        write_and_read(&sp3, &limits);
        orr_sp3_free(&sp3);
    } else if (diag.text[0] == '\0' || st == ORR_E_MEMORY) {
        abort();
    }
    orr_warnings_free(&w);
    return 0;
}
