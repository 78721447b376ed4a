// SPDX-License-Identifier: GPL-3.0-or-later
// The report that the kinds' functions fill in.
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/nan.h"
#include "ingest/inspect/inspect.h"

void orr_inspection_init(orr_inspection *r)
{
    *r = (orr_inspection){.from = ORR_TIME_NONE,
                          .to = ORR_TIME_NONE,
                          .interval_s = ORR_NAN,
                          .satellites = ORR_INSPECT_NONE,
                          .epochs = ORR_INSPECT_NONE,
                          .records = ORR_INSPECT_NONE,
                          .gaps = ORR_INSPECT_NONE};
}

void orr_inspection_free(orr_inspection *r)
{
    free(r->fact);
    orr_warnings_free(&r->warnings);
    orr_inspection_init(r);
}

void orr_inspect_fact_add(orr_inspection *r, const char *label, const char *fmt, ...)
{
    if (!ORR_ARRAY_GROW(r->fact, r->n_facts)) {
        r->incomplete = true;
        return;
    }
    orr_inspect_fact *f = &r->fact[r->n_facts++];
    snprintf(f->label, sizeof f->label, "%s", label);
    va_list ap;
    va_start(ap, fmt);
    vsnprintf(f->text, sizeof f->text, fmt, ap);
    va_end(ap);
}

void orr_inspect_system_add(orr_inspection *r, char system)
{
    if (system == '\0' || strchr(ORR_SYSTEMS, system) == NULL || strchr(r->systems, system) != NULL) return;
    size_t n = 0;
    char kept[sizeof r->systems];
    for (const char *s = ORR_SYSTEMS; *s != '\0'; s++)
        if (*s == system || strchr(r->systems, *s) != NULL) kept[n++] = *s;
    kept[n] = '\0';
    memcpy(r->systems, kept, n + 1);
}

void orr_inspect_sat_add(orr_inspection *r, orr_sat sat)
{
    if (sat == ORR_SAT_NONE || orr_sat_set_has(&r->seen, sat)) return;
    orr_sat_set_add(&r->seen, sat);
    r->satellites = r->satellites < 0 ? 1 : r->satellites + 1;
    orr_inspect_system_add(r, orr_sat_system(sat));
}

// The most frequent step; the shorter of two that are as frequent.
static int64_t usual_step(const orr_time *t, size_t n)
{
    enum { KINDS = 64 };
    int64_t step[KINDS];
    size_t count[KINDS], n_kinds = 0;
    for (size_t i = 1; i < n; i++) {
        int64_t d = t[i] - t[i - 1];
        size_t k = 0;
        while (k < n_kinds && step[k] != d) k++;
        if (k == n_kinds) {
            if (n_kinds == KINDS) continue;
            step[n_kinds] = d;
            count[n_kinds++] = 0;
        }
        count[k]++;
    }
    size_t best = 0;
    for (size_t k = 1; k < n_kinds; k++)
        if (count[k] > count[best] || (count[k] == count[best] && step[k] < step[best])) best = k;
    return n_kinds > 0 ? step[best] : 0;
}

void orr_inspect_epochs(orr_inspection *r, const orr_time *t, size_t n)
{
    r->epochs = (int64_t)n;
    r->gaps = 0;
    if (n == 0) return;
    r->from = t[0];
    r->to = t[n - 1];
    if (isnan(r->interval_s) && n > 1) r->interval_s = (double)usual_step(t, n) / (double)ORR_NS_PER_S;
    for (size_t i = 1; i < n; i++)
        if (orr_time_diff_s(t[i], t[i - 1]) > 1.5 * r->interval_s) r->gaps++;
}

orr_status orr_inspect_text(const orr_inspection *r, const char *path, orr_bytes *text, orr_diag *diag)
{
    return r->raw != NULL ? orr_input_read_bytes(path, r->raw->text, r->raw->n, NULL, text, diag)
                          : orr_input_read_all(path, NULL, text, diag);
}
