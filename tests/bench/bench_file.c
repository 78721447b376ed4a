// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_file.h"

#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "ingest/input/input.h"

bool bench_file_load(bench *b, const char *name, bench_file *out)
{
    *out = (bench_file){.path = ""};
    out->packed = bench_data(name, out->path, sizeof out->path, &out->n_packed);
    if (out->packed == NULL) bench_note(b, "%s is not here (set ORRERY_DATA)", name);
    return out->packed != NULL;
}

void bench_file_unpack(bench_file *f)
{
    orr_bytes text;
    if (orr_input_read_bytes(f->path, f->packed, f->n_packed, NULL, &text, NULL) != ORR_OK) abort();
    f->text = malloc(text.n + 1);
    if (f->text == NULL) abort();
    memcpy(f->text, text.text, text.n);
    f->text[text.n] = '\0';
    f->n = f->n_inflated = text.n;
    orr_bytes_free(&text);
}

void bench_file_free(bench_file *f)
{
    free(f->text);
    free(f->packed);
    *f = (bench_file){.path = ""};
}

double bench_file_rate(bench *b, void (*work)(void *), bench_file *f)
{
    return (double)f->n / bench_seconds(b, work, f) / 1e6;
}

static void split(void *arg)
{
    const bench_file *f = arg;
    size_t lines = 0;
    for (const char *p = f->text, *end = p + f->n; p < end; lines++) {
        const char *lf = memchr(p, '\n', (size_t)(end - p));
        p = lf != NULL ? lf + 1 : end;
    }
    bench_use((double)lines);
}

double bench_file_split_rate(bench *b, bench_file *f) { return bench_file_rate(b, split, f); }

typedef struct inflating {
    const bench_file *file;
    uint8_t *room;
} inflating;

static void inflate_bare(void *arg)
{
    const inflating *i = arg;
    z_stream z = {0};
    if (inflateInit2(&z, 15 + 16) != Z_OK) abort();
    z.next_in = i->file->packed;
    z.avail_in = (uInt)i->file->n_packed;
    z.next_out = i->room;
    z.avail_out = (uInt)i->file->n_inflated;
    if (inflate(&z, Z_FINISH) != Z_STREAM_END) abort();
    inflateEnd(&z);
}

double bench_file_inflate_rate(bench *b, bench_file *f)
{
    inflating i = {f, malloc(f->n_inflated)};
    if (i.room == NULL) abort();
    const double rate = (double)f->n / bench_seconds(b, inflate_bare, &i) / 1e6;
    free(i.room);
    return rate;
}
