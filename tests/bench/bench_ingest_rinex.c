// SPDX-License-Identifier: GPL-3.0-or-later
// RINEX navigation and observation files beside line splitting by memchr and bare zlib inflate of the same
// bytes. Figures are of plain RINEX text; Hatanaka rows count the text that the compressed file stands for.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "bench/bench.h"
#include "ingest/rinex/crinex.h"
#include "ingest/rinex/rinex_nav.h"
#include "ingest/rinex/rinex_obs.h"

typedef struct job {
    char *text, *room; // room for an inflated copy
    size_t n, capacity;
    uint8_t *packed; // gzip of text, or of what the file holds
    size_t n_packed, n_inflated;
    const char *path;
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
    z.next_in = j->packed;
    z.avail_in = (uInt)j->n_packed;
    z.next_out = (Bytef *)j->room;
    z.avail_out = (uInt)j->n_inflated;
    if (inflate(&z, Z_FINISH) != Z_STREAM_END) abort();
    inflateEnd(&z);
}

static void nav_text(void *arg)
{
    const job *j = arg;
    orr_nav nav;
    if (orr_nav_parse("bench", j->text, j->n, NULL, &nav, NULL, NULL) != ORR_OK) abort();
    bench_use((double)nav.n_eph);
    orr_nav_free(&nav);
}

static void nav_file(void *arg)
{
    const job *j = arg;
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

static void obs_text(void *arg) { read_epochs(((job *)arg)->text, ((job *)arg)->n); }
static void obs_packed(void *arg) { read_epochs(((job *)arg)->packed, ((job *)arg)->n_packed); }

static bool keep(void *user, const char *line, size_t n)
{
    job *j = user;
    if (j->n + n + 1 > j->capacity) {
        j->capacity = 2 * (j->n + n) + 65536;
        j->text = realloc(j->text, j->capacity);
        if (j->text == NULL) abort();
    }
    memcpy(j->text + j->n, line, n);
    j->text[j->n + n] = '\n';
    j->n += n + 1;
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
    const job *j = arg;
    orr_input *in = NULL;
    size_t n = 0;
    if (orr_input_open_bytes("bench", j->packed, j->n_packed, NULL, &in, NULL) != ORR_OK) abort();
    if (orr_crinex_expand(in, count_only, &n, NULL, NULL) != ORR_OK) abort();
    orr_input_close(in);
    bench_use((double)n);
}

static void gzip(const job *text, job *out)
{
    z_stream z = {0};
    if (deflateInit2(&z, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK) abort();
    size_t room = deflateBound(&z, (uLong)text->n);
    out->packed = malloc(room);
    if (out->packed == NULL) abort();
    z.next_in = (Bytef *)text->text;
    z.avail_in = (uInt)text->n;
    z.next_out = out->packed;
    z.avail_out = (uInt)room;
    if (deflate(&z, Z_FINISH) != Z_STREAM_END) abort();
    out->n_packed = z.total_out;
    out->n_inflated = text->n;
    deflateEnd(&z);
}

static double rate(bench *b, void (*work)(void *), job *j)
{
    return (double)j->n / bench_seconds(b, work, j) / 1e6;
}

// bare inflate in MB of j->n a second, so that it compares with the rows
static double inflate_rate(bench *b, job *j)
{
    j->room = malloc(j->n_inflated);
    if (j->room == NULL) abort();
    double r = rate(b, inflate_bare, j);
    free(j->room);
    j->room = NULL;
    return r;
}

static bool load(bench *b, const char *name, char path[512], job *j)
{
    j->path = path;
    j->packed = bench_data(name, path, 512, &j->n_packed);
    if (j->packed == NULL) bench_note(b, "%s is not here (set ORRERY_DATA)", name);
    return j->packed != NULL;
}

static void nav_rows(bench *b, const char *file, const char *name)
{
    char path[512], label[160];
    job j = {0};
    orr_bytes text;
    if (!load(b, file, path, &j)) return;
    if (orr_input_read_bytes(path, j.packed, j.n_packed, NULL, &text, NULL) != ORR_OK) abort();
    j.text = text.text;
    j.n = j.n_inflated = text.n;
    snprintf(label, sizeof label, "%s: text to records", name);
    bench_row(b, label, rate(b, nav_text, &j), rate(b, split, &j), "MB/s", "splitting lines");
    snprintf(label, sizeof label, "%s: gzip file to records", name);
    bench_row(b, label, rate(b, nav_file, &j), inflate_rate(b, &j), "MB/s", "bare inflate");
    free(j.packed);
    orr_bytes_free(&text);
}

static void obs_rows(bench *b, const char *file, const char *name)
{
    char path[512], label[160];
    job compact = {0}, plain = {0};
    orr_input *in = NULL;
    orr_bytes text;
    if (!load(b, file, path, &compact)) return;
    if (orr_input_open_bytes(path, compact.packed, compact.n_packed, NULL, &in, NULL) != ORR_OK) abort();
    if (orr_crinex_expand(in, keep, &plain, NULL, NULL) != ORR_OK) abort();
    orr_input_close(in);
    if (orr_input_read_bytes(path, compact.packed, compact.n_packed, NULL, &text, NULL) != ORR_OK) abort();
    compact.n = plain.n;
    compact.n_inflated = text.n;
    orr_bytes_free(&text);
    snprintf(label, sizeof label, "%s: text to epochs", name);
    double lines = rate(b, split, &plain);
    bench_row(b, label, rate(b, obs_text, &plain), lines, "MB/s", "splitting lines");
    gzip(&plain, &plain);
    snprintf(label, sizeof label, "%s: gzip to epochs", name);
    bench_row(b, label, rate(b, obs_packed, &plain), inflate_rate(b, &plain), "MB/s", "bare inflate");
    double bare = inflate_rate(b, &compact);
    snprintf(label, sizeof label, "%s: .crx.gz to epochs", name);
    bench_row(b, label, rate(b, obs_packed, &compact), bare, "MB/s", "bare inflate of the .crx");
    snprintf(label, sizeof label, "%s: .crx.gz to RINEX text", name);
    bench_row(b, label, rate(b, expand, &compact), bare, "MB/s", "bare inflate of the .crx");
    free(plain.packed);
    free(plain.text);
    free(compact.packed);
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
