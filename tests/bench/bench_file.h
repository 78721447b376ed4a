// SPDX-License-Identifier: GPL-3.0-or-later
// A text file for the readers' rows, and what the machine does with its bytes at best.
#ifndef BENCH_FILE_H
#define BENCH_FILE_H

#include <stddef.h>
#include <stdint.h>

#include "bench/bench.h"

typedef struct bench_file {
    char path[512];
    char *text; // that the figures count
    size_t n;
    uint8_t *packed; // as the file is, or a gzip of `text`; NULL: there is none
    size_t n_packed;
    size_t n_inflated; // bytes that `packed` inflates to
} bench_file;

// Reads a file of the tests' data as it is; false, with a note in the table, where it is not here.
bool bench_file_load(bench *b, const char *name, bench_file *out);
// Its text as orr_input gives it. Ends the program where that cannot be had.
void bench_file_unpack(bench_file *f);
// Frees what the two above made.
void bench_file_free(bench_file *f);

// Megabytes of `text` a second; `work` gets the file.
double bench_file_rate(bench *b, void (*work)(void *), bench_file *f);
// The same of lines found by memchr, and of zlib's inflate of a gzip file.
double bench_file_split_rate(bench *b, bench_file *f);
double bench_file_inflate_rate(bench *b, bench_file *f);

#endif
