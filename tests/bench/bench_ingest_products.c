// SPDX-License-Identifier: GPL-3.0-or-later
// IONEX, clocks, biases and antennas beside line splitting by memchr and bare zlib inflate of the same bytes.
#include <stdio.h>
#include <stdlib.h>

#include "bench/bench_file.h"
#include "ingest/maps/ionex.h"
#include "ingest/rinex/clk.h"
#include "ingest/tables/antex.h"
#include "ingest/tables/bias.h"
#include "read_file.h"

READ_FILE_BY_PARSER(ionex)

static void ionex_text(void *arg)
{
    const bench_file *j = arg;
    orr_ionex x;
    orr_diag d = {0};
    if (orr_ionex_parse("bench", j->text, j->n, NULL, &x, NULL, &d) != ORR_OK) abort();
    bench_use(x.tec_tecu[0]);
    orr_ionex_free(&x);
}

static void ionex_file(void *arg)
{
    const bench_file *j = arg;
    orr_ionex x;
    orr_diag d = {0};
    if (read_ionex(j->path, NULL, &x, NULL, &d) != ORR_OK) abort();
    bench_use(x.tec_tecu[0]);
    orr_ionex_free(&x);
}

static void clk_text(void *arg)
{
    const bench_file *j = arg;
    orr_clk x;
    orr_diag d = {0};
    if (orr_clk_parse("bench", j->text, j->n, NULL, &x, NULL, &d) != ORR_OK) abort();
    bench_use(x.interval_s);
    orr_clk_free(&x);
}

static void bias_text(void *arg)
{
    const bench_file *j = arg;
    orr_bias_set x;
    orr_diag d = {0};
    if (orr_bias_parse("bench", j->text, j->n, NULL, &x, NULL, &d) != ORR_OK) abort();
    bench_use(x.bias[0].value_s);
    orr_bias_free(&x);
}

static void antex_text(void *arg)
{
    const bench_file *j = arg;
    orr_antex x;
    orr_diag d = {0};
    if (orr_antex_parse("bench", j->text, j->n, NULL, &x, NULL, &d) != ORR_OK) abort();
    bench_use(x.version);
    orr_antex_free(&x);
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
        char label[160];
        bench_file f;
        if (!bench_file_load(b, files[i].path, &f)) continue;
        bench_file_unpack(&f);
        snprintf(label, sizeof label, "%s: text to table", files[i].name);
        bench_row(b, label, bench_file_rate(b, files[i].text, &f), bench_file_split_rate(b, &f), "MB/s",
                  "splitting lines");
        if (files[i].file != NULL && f.packed[1] == 0x8b) {
            snprintf(label, sizeof label, "%s: gzip file to table", files[i].name);
            bench_row(b, label, bench_file_rate(b, files[i].file, &f), bench_file_inflate_rate(b, &f), "MB/s",
                      "bare inflate");
        }
        bench_file_free(&f);
    }
}
