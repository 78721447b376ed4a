// SPDX-License-Identifier: GPL-3.0-or-later
// IONEX, clocks, biases and antennas beside line splitting by memchr and bare zlib inflate of the same bytes.
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "bench/bench.h"
#include "ingest/input/input.h"
#include "ingest/maps/ionex.h"
#include "ingest/rinex/clk.h"
#include "ingest/tables/antex.h"
#include "ingest/tables/bias.h"
#include "read_file.h"

READ_FILE_BY_PARSER(ionex)

typedef struct job {
    const char *path;
    const uint8_t *packed;
    size_t n_packed;
    char *text, *room;
    size_t n;
} job;

static void split(void *arg)
{
    const job *j = arg;
    size_t lines = 0;
    for (const char *p = j->text, *end = p + j->n; p < end; lines++) {
        const char *lf = memchr(p, '\n', (size_t)(end - p));
        p = lf != NULL ? lf + 1 : end;
    }
    bench_use((double)lines);
}

static void inflate_bare(void *arg)
{
    const job *j = arg;
    z_stream z = {0};
    if (inflateInit2(&z, 15 + 16) != Z_OK) abort();
    z.next_in = (Bytef *)(uintptr_t)j->packed;
    z.avail_in = (uInt)j->n_packed;
    z.next_out = (Bytef *)j->room;
    z.avail_out = (uInt)j->n;
    if (inflate(&z, Z_FINISH) != Z_STREAM_END) abort();
    inflateEnd(&z);
}

static void ionex_text(void *arg)
{
    const job *j = arg;
    orr_ionex x;
    orr_diag d = {0};
    if (orr_ionex_parse("bench", j->text, j->n, NULL, &x, NULL, &d) != ORR_OK) abort();
    bench_use(x.tec_tecu[0]);
    orr_ionex_free(&x);
}

static void ionex_file(void *arg)
{
    const job *j = arg;
    orr_ionex x;
    orr_diag d = {0};
    if (read_ionex(j->path, NULL, &x, NULL, &d) != ORR_OK) abort();
    bench_use(x.tec_tecu[0]);
    orr_ionex_free(&x);
}

static void clk_text(void *arg)
{
    const job *j = arg;
    orr_clk x;
    orr_diag d = {0};
    if (orr_clk_parse("bench", j->text, j->n, NULL, &x, NULL, &d) != ORR_OK) abort();
    bench_use(x.interval_s);
    orr_clk_free(&x);
}

static void bias_text(void *arg)
{
    const job *j = arg;
    orr_bias_set x;
    orr_diag d = {0};
    if (orr_bias_parse("bench", j->text, j->n, NULL, &x, NULL, &d) != ORR_OK) abort();
    bench_use(x.bias[0].value_s);
    orr_bias_free(&x);
}

static void antex_text(void *arg)
{
    const job *j = arg;
    orr_antex x;
    orr_diag d = {0};
    if (orr_antex_parse("bench", j->text, j->n, NULL, &x, NULL, &d) != ORR_OK) abort();
    bench_use(x.version);
    orr_antex_free(&x);
}

static double rate(bench *b, void (*work)(void *), job *j)
{
    return (double)j->n / bench_seconds(b, work, j) / 1e6;
}

void bench_ingest_products(bench *b)
{
    bench_group(b, "Maps, clocks, biases, antennas (MB of text a second)");
    static const struct {
        const char *path, *name;
        void (*text)(void *), (*file)(void *);
    } files[] = {
        {"2024-035/COD0OPSFIN_20240350000_01D_01H_GIM.INX.gz", "IONEX, 25 hourly maps with RMS", ionex_text,
         ionex_file},
        {"2008-279/whp15000.clk.Z", "RINEX clocks, 30 s", clk_text, NULL},
        {"2024-035/COD0OPSFIN_20240350000_01D_01D_OSB.BIA.gz", "Bias-SINEX, 14 361 biases", bias_text, NULL},
        {"antex/igs05.atx.gz", "ANTEX, 292 antennas", antex_text, NULL},
    };
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        char path[512], label[160];
        job j = {.path = path};
        void *packed = bench_data(files[i].path, path, sizeof path, &j.n_packed);
        if (packed == NULL) {
            bench_note(b, "%s is not here (set ORRERY_DATA)", files[i].path);
            continue;
        }
        orr_bytes text;
        orr_diag diag = {0};
        j.packed = packed;
        if (orr_input_read_bytes(path, packed, j.n_packed, NULL, &text, &diag) != ORR_OK) abort();
        j.text = text.text;
        j.n = text.n;
        j.room = malloc(j.n);
        if (j.room == NULL) abort();
        snprintf(label, sizeof label, "%s: text to table", files[i].name);
        bench_row(b, label, rate(b, files[i].text, &j), rate(b, split, &j), "MB/s", "splitting lines");
        if (files[i].file != NULL && j.packed[1] == 0x8b) {
            snprintf(label, sizeof label, "%s: gzip file to table", files[i].name);
            bench_row(b, label, rate(b, files[i].file, &j), rate(b, inflate_bare, &j), "MB/s",
                      "bare inflate");
        }
        free(j.room);
        free(packed);
        orr_bytes_free(&text);
    }
}
