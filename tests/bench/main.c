// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the benchmarks: all of them, or those whose names hold one of the words given.
#include "bench/bench.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

struct bench {
    int runs;
    double run_s; // least length of a run
};

static const struct {
    const char *name;
    void (*run)(bench *b);
} benches[] = {
#define ORR_BENCH(name) {#name, bench_##name},
#include "bench/benches.def"
#undef ORR_BENCH
};

static double now_s(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

void bench_group(bench *b, const char *heading)
{
    (void)b;
    printf("\n%s\n  %-52s %12s %12s %8s\n", heading, "", "ours", "limit", "ratio");
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double bench_seconds(bench *b, void (*work)(void *arg), void *arg)
{
    long calls = 1;
    double took;
    for (;; calls *= 2) { // the first calls also warm caches and pages
        double start = now_s();
        for (long i = 0; i < calls; i++) work(arg);
        took = now_s() - start;
        if (took >= b->run_s) break;
    }
    double run[16];
    for (int r = 0; r < b->runs; r++) {
        double start = now_s();
        for (long i = 0; i < calls; i++) work(arg);
        run[r] = (now_s() - start) / (double)calls;
    }
    qsort(run, (size_t)b->runs, sizeof run[0], compare);
    return run[b->runs / 2];
}

void bench_row(bench *b, const char *name, double ours, double limit, const char *unit,
               const char *limit_name)
{
    (void)b;
    char text[2][32];
    snprintf(text[0], sizeof text[0], "%.4g %s", ours, unit);
    snprintf(text[1], sizeof text[1], "%.4g %s", limit, unit);
    if (limit > 0)
        printf("  %-52s %12s %12s %8.3g  %s\n", name, text[0], text[1], ours / limit, limit_name);
    else
        printf("  %-52s %12s\n", name, text[0]);
    fflush(stdout);
}

void bench_note(bench *b, const char *fmt, ...)
{
    (void)b;
    va_list ap;
    va_start(ap, fmt);
    fputs("  ", stdout);
    vprintf(fmt, ap);
    putchar('\n');
    va_end(ap);
}

void bench_use(double v)
{
    static volatile double kept;
    kept = v;
    (void)kept;
}

void *bench_data(const char *name, char *path, size_t n, size_t *bytes)
{
    const char *root = getenv("ORRERY_DATA");
    if (root == NULL || *root == '\0') root = ORR_SOURCE_DIR "/../shared/data";
    snprintf(path, n, "%s/%s", root, name);
    FILE *f = fopen(path, "rb");
    if (f == NULL) return NULL;
    char *data = NULL;
    size_t used = 0, capacity = 0, got;
    do {
        if (used == capacity) {
            capacity = 2 * capacity + 65536;
            data = realloc(data, capacity);
            if (data == NULL) abort();
        }
        got = fread(data + used, 1, capacity - used, f);
        used += got;
    } while (got > 0);
    fclose(f);
    *bytes = used;
    return data;
}

int main(int argc, char **argv)
{
    bench b = {.runs = 7, .run_s = 0.05};
    for (size_t i = 0; i < sizeof benches / sizeof benches[0]; i++) {
        bool wanted = argc < 2;
        for (int a = 1; a < argc; a++) wanted = wanted || strstr(benches[i].name, argv[a]) != NULL;
        if (wanted) benches[i].run(&b);
    }
    return 0;
}
