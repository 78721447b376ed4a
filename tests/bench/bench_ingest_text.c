// SPDX-License-Identifier: GPL-3.0-or-later
// Number fields beside the C library's strtod.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/bench.h"
#include "core/cursor.h"

enum { FIELDS = 1000, WIDTH = 20 };

typedef struct fields {
    char text[FIELDS][WIDTH];
    size_t n[FIELDS];
} fields;

static void ours(void *arg)
{
    const fields *f = arg;
    double x = 0, sum = 0;
    for (int i = 0; i < FIELDS; i++) {
        if (orr_view_real((orr_view){f->text[i], f->n[i]}, &x) == ORR_FIELD_OK) sum += x;
    }
    bench_use(sum);
}

static void library(void *arg)
{
    const fields *f = arg;
    double sum = 0;
    for (int i = 0; i < FIELDS; i++) sum += strtod(f->text[i], NULL);
    bench_use(sum);
}

static void row(bench *b, const char *name, const char *format, double least, double most)
{
    static fields f;
    for (int i = 0; i < FIELDS; i++) {
        double x = least * pow(most / least, fabs(sin(i))) * (i % 2 == 0 ? 1 : -1);
        f.n[i] = (size_t)snprintf(f.text[i], WIDTH, format, x);
    }
    bench_row(b, name, bench_seconds(b, ours, &f) / FIELDS * 1e9,
              bench_seconds(b, library, &f) / FIELDS * 1e9, "ns", "strtod");
}

void bench_ingest_text(bench *b)
{
    bench_group(b, "Number fields, one at a time");
    row(b, "14.6f, as SP3 writes coordinates", "%14.6f", 1e-3, 3e4);
    row(b, "14.3f, as RINEX writes ranges", "%14.3f", 1e3, 3e7);
    row(b, "19.12E, as RINEX writes ephemerides", "%19.12E", 1e-18, 1e6);
}
