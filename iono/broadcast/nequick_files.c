// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of NeQuick-G from a folder of text files: numbers divided by blanks, in their order.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "ingest/input/input.h"
#include "iono/broadcast/nequick_private.h"

// n numbers and no more; each to its place in to[].
static orr_status numbers_of(const char *path, double *to, size_t n, orr_diag *diag)
{
    orr_bytes text;
    orr_status s = orr_input_read_all(path, NULL, &text, diag);
    if (s != ORR_OK) return s;
    orr_cursor c;
    orr_cursor_init(&c, path, text.text, text.n);
    orr_view line, word;
    size_t got = 0;
    while (s == ORR_OK && orr_cursor_next(&c, &line))
        while (s == ORR_OK && orr_view_word(&line, &word)) {
            double v;
            if (got == n || orr_view_real(word, &v) != ORR_FIELD_OK)
                s = orr_cursor_error(&c, diag, ORR_E_FORMAT, 0,
                                     got == n ? "more than the %zu numbers of a table of NeQuick-G"
                                              : "not a number of the %zu of a table of NeQuick-G",
                                     n);
            else
                to[got++] = v;
        }
    if (s == ORR_OK) s = orr_cursor_status(&c, diag);
    if (s == ORR_OK && got < n)
        s = orr_cursor_error(&c, diag, ORR_E_FORMAT, 0, "%zu of the %zu numbers of a table of NeQuick-G", got,
                             n);
    orr_bytes_free(&text);
    return s;
}

static orr_status table(const char *folder, const char *name, double *to, size_t n, orr_diag *diag)
{
    char path[4096];
    int length = snprintf(path, sizeof path, "%s/%s.asc", folder, name);
    if (length < 0 || (size_t)length + 4 > sizeof path)
        return orr_diag_set(diag, ORR_E_ARG, "the name of the folder of NeQuick-G is too long");
    if (access(path, R_OK) != 0) snprintf(path + length, 4, ".gz");
    return numbers_of(path, to, n, diag);
}

orr_status orr_nequick_load(const char *folder, orr_nequick **out, orr_diag *diag)
{
    *out = NULL;
    orr_nequick *n = malloc(sizeof *n);
    if (n == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the tables of NeQuick-G");
    _Static_assert(sizeof(neq_month) ==
                       2 * (NEQ_F2_ROWS * NEQ_F2_TERMS + NEQ_M3_ROWS * NEQ_M3_TERMS) * sizeof(double),
                   "a month is a file's numbers in their order");
    orr_status s = table(folder, "modip", &n->modip_deg[0][0], NEQ_MODIP * NEQ_MODIP, diag);
    for (int k = 0; k < 12 && s == ORR_OK; k++) {
        char name[16];
        snprintf(name, sizeof name, "ccir%d", 11 + k);
        s = table(folder, name, &n->month[k].f2[0][0][0], sizeof(neq_month) / sizeof(double), diag);
    }
    if (s != ORR_OK) {
        free(n);
        return s;
    }
    *out = n;
    return ORR_OK;
}

void orr_nequick_free(orr_nequick *n) { free(n); }

_Static_assert(sizeof(orr_nequick) == ORR_NEQUICK_NUMBERS * sizeof(double),
               "tables are doubles without a gap");

const double *orr_nequick_numbers(const orr_nequick *n) { return (const double *)(const void *)n; }

orr_status orr_nequick_of_numbers(const double *number, orr_nequick **out, orr_diag *diag)
{
    *out = NULL;
    for (size_t i = 0; i < ORR_NEQUICK_NUMBERS; i++)
        if (!isfinite(number[i]))
            return orr_diag_set(diag, ORR_E_FORMAT, "a table of NeQuick-G holds what is no number");
    orr_nequick *n = malloc(sizeof *n);
    if (n == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for NeQuick-G's tables");
    memcpy(n, number, sizeof *n);
    *out = n;
    return ORR_OK;
}
