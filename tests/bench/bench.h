// SPDX-License-Identifier: GPL-3.0-or-later
// Benchmarks in one table: what we do beside what this machine can do at best in the same run, so that a
// figure means something on any machine. Nothing here passes or fails. A new one is a file bench_<name>.c
// that defines void bench_<name>(bench *b), and one line in benches.def.
#ifndef ORR_TESTS_BENCH_H
#define ORR_TESTS_BENCH_H

#include <stdbool.h>
#include <stddef.h>

typedef struct bench bench;

// A heading over the rows that follow.
void bench_group(bench *b, const char *heading);
// Seconds of one call of work(arg): the median of several runs, each of so many calls that the clock is fine
// enough.
double bench_seconds(bench *b, void (*work)(void *arg), void *arg);
// A row "name | ours | limit | ratio". `unit` is of both figures ("MB/s", "ns", "ms"). ratio is ours / limit
// for rates and times alike; `limit_name` says what the limit is. A limit of 0 leaves both out.
void bench_row(bench *b, const char *name, double ours, double limit, const char *unit,
               const char *limit_name);
// A line of talk between rows: where the time goes, what was left out and why.
void bench_note(bench *b, const char *fmt, ...);
// Keeps a result alive that nobody looks at.
void bench_use(double v);

// A file below ORRERY_DATA as bytes (malloc'ed, as they are on disk); NULL where it is not there. The path
// goes into `path` of n bytes.
void *bench_data(const char *name, char *path, size_t n, size_t *bytes);

#define ORR_BENCH(name) void bench_##name(bench *b);
#include "bench/benches.def"
#undef ORR_BENCH

#endif
