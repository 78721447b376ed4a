// SPDX-License-Identifier: GPL-3.0-or-later
// SP3 beside line splitting by memchr and bare zlib inflate of the same bytes.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/bench_file.h"
#include "ingest/input/input.h"
#include "ingest/sp3/sp3.h"

static void parse(void *arg)
{
    const bench_file *j = arg;
    orr_sp3 s;
    orr_diag diag = {0};
    if (orr_sp3_parse("bench", j->text, j->n, NULL, &s, NULL, &diag) != ORR_OK) abort();
    bench_use(s.record[0].pos_m[0]);
    orr_sp3_free(&s);
}

static void open_whole(void *arg)
{
    const bench_file *j = arg;
    orr_bytes b;
    orr_diag diag = {0};
    if (orr_input_read_bytes("bench", j->packed, j->n_packed, NULL, &b, &diag) != ORR_OK) abort();
    bench_use(b.text[0]);
    orr_bytes_free(&b);
}

static void open_stream(void *arg)
{
    const bench_file *j = arg;
    orr_input *in = NULL;
    orr_view line;
    orr_diag diag = {0};
    size_t lines = 0;
    if (orr_input_open_bytes("bench", j->packed, j->n_packed, NULL, &in, &diag) != ORR_OK) abort();
    while (orr_input_line(in, &line)) lines++;
    bench_use((double)lines);
    orr_input_close(in);
}

static void read_file(void *arg)
{
    const bench_file *j = arg;
    orr_sp3 s;
    orr_diag diag = {0};
    if (orr_sp3_read(j->path, NULL, &s, NULL, &diag) != ORR_OK) abort();
    bench_use(s.record[0].pos_m[0]);
    orr_sp3_free(&s);
}

// A day of 80 satellites every 5 minutes, for machines without real files.
static char *made_day(size_t *n)
{
    orr_sp3 s;
    orr_diag diag = {0};
    char *text = NULL;
    if (orr_sp3_alloc(80, 289, &s, &diag) != ORR_OK) abort();
    for (size_t k = 0; k < 80; k++) s.sat[k] = orr_sat_make("GRE"[k / 30], (int)(1 + k % 30));
    for (size_t e = 0; e < 289; e++) {
        s.epoch[e] = orr_time_from_week(2300, 0) + (orr_time)e * 300 * ORR_NS_PER_S;
        for (size_t k = 0; k < 80; k++) {
            orr_sp3_record *r = &s.record[e * 80 + k];
            double a = 0.0436 * (double)e + 0.7 * (double)k;
            r->pos_m[0] = 26e6 * cos(a);
            r->pos_m[1] = 15.6e6 * sin(a);
            r->pos_m[2] = 20.8e6 * sin(a);
            r->clock_s = 1e-4 * sin((double)k);
        }
    }
    FILE *f = open_memstream(&text, n);
    if (f == NULL || orr_sp3_print(&s, f, &diag) != ORR_OK) abort();
    fclose(f);
    orr_sp3_free(&s);
    return text;
}

static void rows(bench *b, const char *name, bench_file *f)
{
    char label[160];
    snprintf(label, sizeof label, "%s: text to table", name);
    bench_row(b, label, bench_file_rate(b, parse, f), bench_file_split_rate(b, f), "MB/s", "splitting lines");
    if (f->packed == NULL || f->packed[1] != 0x8b) return;
    const double bare = bench_file_inflate_rate(b, f);
    snprintf(label, sizeof label, "%s: gzip to text, whole", name);
    bench_row(b, label, bench_file_rate(b, open_whole, f), bare, "MB/s", "bare inflate");
    snprintf(label, sizeof label, "%s: gzip to lines, streamed", name);
    bench_row(b, label, bench_file_rate(b, open_stream, f), bare, "MB/s", "bare inflate");
    snprintf(label, sizeof label, "%s: gzip file to table", name);
    bench_row(b, label, bench_file_rate(b, read_file, f), bare, "MB/s", "bare inflate");
}

void bench_ingest_sp3(bench *b)
{
    bench_group(b, "SP3 (MB of text a second)");
    bench_file made = {.path = ""};
    made.text = made_day(&made.n);
    rows(b, "made day, 80 satellites", &made);
    bench_file_free(&made);
    static const struct {
        const char *path, *name;
    } files[] = {{"2024-035/COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz", "CODE day, 80 satellites"},
                 {"2015-200-velocity/test_input_sp3_nav_2015_200.sp3.gz", "NGA day with velocities"},
                 {"2008-279/COD15000.EPH.Z", "CODE day of 2008, .Z"}};
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        bench_file f;
        if (!bench_file_load(b, files[i].path, &f)) continue;
        bench_file_unpack(&f);
        rows(b, files[i].name, &f);
        if (f.packed[1] == 0x9d)
            bench_row(b, ".Z to text", bench_file_rate(b, open_whole, &f), 0, "MB/s", "");
        bench_file_free(&f);
    }
}
