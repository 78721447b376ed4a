// SPDX-License-Identifier: GPL-3.0-or-later
// RINEX navigation and observation files beside line splitting by memchr and bare zlib inflate of the same
// bytes. Figures are of plain RINEX text; Hatanaka rows count the text that the compressed file stands for.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "bench/bench_file.h"
#include "ingest/rinex/crinex.h"
#include "ingest/rinex/rinex_nav.h"
#include "ingest/rinex/rinex_obs.h"

static void nav_text(void *arg)
{
    const bench_file *j = arg;
    orr_nav nav;
    if (orr_nav_parse("bench", j->text, j->n, NULL, &nav, NULL, NULL) != ORR_OK) abort();
    bench_use((double)nav.n_eph);
    orr_nav_free(&nav);
}

static void nav_file(void *arg)
{
    const bench_file *j = arg;
    orr_nav nav;
    if (orr_nav_read(j->path, NULL, &nav, NULL, NULL) != ORR_OK) abort();
    bench_use((double)nav.n_eph);
    orr_nav_free(&nav);
}

static void read_epochs(const void *data, size_t n)
{
    orr_rinex_obs *r = NULL;
    const orr_rinex_obs_epoch *e = NULL;
    if (orr_rinex_obs_open_memory("bench", data, n, NULL, NULL, &r, NULL) != ORR_OK) abort();
    double sum = 0;
    while (orr_rinex_obs_next(r, &e, NULL) == ORR_OK && e != NULL)
        if (e->n_sats > 0) sum += e->value[0];
    bench_use(sum);
    orr_rinex_obs_close(r);
}

static void obs_text(void *arg) { read_epochs(((bench_file *)arg)->text, ((bench_file *)arg)->n); }
static void obs_packed(void *arg) { read_epochs(((bench_file *)arg)->packed, ((bench_file *)arg)->n_packed); }

// RINEX text that grows by lines.
typedef struct growing {
    bench_file *file;
    size_t capacity;
} growing;

static bool keep(void *user, const char *line, size_t n)
{
    growing *g = user;
    bench_file *f = g->file;
    if (f->n + n + 1 > g->capacity) {
        g->capacity = 2 * (f->n + n) + 65536;
        f->text = realloc(f->text, g->capacity);
        if (f->text == NULL) abort();
    }
    memcpy(f->text + f->n, line, n);
    f->text[f->n + n] = '\n';
    f->n += n + 1;
    return true;
}

static bool count_only(void *user, const char *line, size_t n)
{
    (void)line;
    *(size_t *)user += n + 1;
    return true;
}

static void expand(void *arg)
{
    const bench_file *j = arg;
    orr_input *in = NULL;
    size_t n = 0;
    if (orr_input_open_bytes("bench", j->packed, j->n_packed, NULL, &in, NULL) != ORR_OK) abort();
    if (orr_crinex_expand(in, count_only, &n, NULL, NULL) != ORR_OK) abort();
    orr_input_close(in);
    bench_use((double)n);
}

static void gzip(bench_file *f)
{
    z_stream z = {0};
    if (deflateInit2(&z, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK) abort();
    size_t room = deflateBound(&z, (uLong)f->n);
    f->packed = malloc(room);
    if (f->packed == NULL) abort();
    z.next_in = (Bytef *)f->text;
    z.avail_in = (uInt)f->n;
    z.next_out = f->packed;
    z.avail_out = (uInt)room;
    if (deflate(&z, Z_FINISH) != Z_STREAM_END) abort();
    f->n_packed = z.total_out;
    f->n_inflated = f->n;
    deflateEnd(&z);
}

static void nav_rows(bench *b, const char *file, const char *name)
{
    char label[160];
    bench_file f;
    if (!bench_file_load(b, file, &f)) return;
    bench_file_unpack(&f);
    snprintf(label, sizeof label, "%s: text to records", name);
    bench_row(b, label, bench_file_rate(b, nav_text, &f), bench_file_split_rate(b, &f), "MB/s",
              "splitting lines");
    snprintf(label, sizeof label, "%s: gzip file to records", name);
    bench_row(b, label, bench_file_rate(b, nav_file, &f), bench_file_inflate_rate(b, &f), "MB/s",
              "bare inflate");
    bench_file_free(&f);
}

static void obs_rows(bench *b, const char *file, const char *name)
{
    char label[160];
    bench_file compact, plain = {.path = ""};
    growing text = {&plain, 0};
    orr_input *in = NULL;
    if (!bench_file_load(b, file, &compact)) return;
    if (orr_input_open_bytes(compact.path, compact.packed, compact.n_packed, NULL, &in, NULL) != ORR_OK)
        abort();
    if (orr_crinex_expand(in, keep, &text, NULL, NULL) != ORR_OK) abort();
    orr_input_close(in);
    bench_file_unpack(&compact);
    compact.n = plain.n; // the text that it stands for
    snprintf(label, sizeof label, "%s: text to epochs", name);
    bench_row(b, label, bench_file_rate(b, obs_text, &plain), bench_file_split_rate(b, &plain), "MB/s",
              "splitting lines");
    gzip(&plain);
    snprintf(label, sizeof label, "%s: gzip to epochs", name);
    bench_row(b, label, bench_file_rate(b, obs_packed, &plain), bench_file_inflate_rate(b, &plain), "MB/s",
              "bare inflate");
    const double bare = bench_file_inflate_rate(b, &compact);
    snprintf(label, sizeof label, "%s: .crx.gz to epochs", name);
    bench_row(b, label, bench_file_rate(b, obs_packed, &compact), bare, "MB/s", "bare inflate of the .crx");
    snprintf(label, sizeof label, "%s: .crx.gz to RINEX text", name);
    bench_row(b, label, bench_file_rate(b, expand, &compact), bare, "MB/s", "bare inflate of the .crx");
    bench_file_free(&plain);
    bench_file_free(&compact);
}

void bench_ingest_rinex(bench *b)
{
    bench_group(b, "RINEX navigation (MB of text a second)");
    nav_rows(b, "rinex4-nav/BRD400DLR_S_20230710000_01D_MN.rnx.gz", "global day, version 4");
    nav_rows(b, "2020-177/ESBC00DNK_R_20201770000_01D_MN.rnx.gz", "station day, version 3");
    nav_rows(b, "2010-182/brdc1820.10n.gz", "GPS day, version 2");
    bench_group(b, "RINEX observations (MB of plain RINEX a second)");
    obs_rows(b, "2024-035/BOR100POL_R_20240350000_01D_30S_MO.crx.gz", "station day, version 3");
    obs_rows(b, "2020-177/ESBC00DNK_R_20201770000_01D_30S_MO.crx.gz", "station day, 20 types a satellite");
}
