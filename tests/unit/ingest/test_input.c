// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include <unistd.h>
#include <zlib.h>

#include "ingest/input/input.h"
#include "lzw_encoder.h"

// Text that compresses as products do: numbered lines with digits that look random.
static char *made_text(size_t lines, size_t *n)
{
    char *t = malloc(lines * 64 + 1);
    uint64_t s = 1;
    *n = 0;
    for (size_t i = 0; i < lines; i++) {
        s = s * 6364136223846793005u + 1442695040888963407u;
        *n += (size_t)sprintf(t + *n, "PG%02u %14.6f%14.6f line %zu\n", (unsigned)(i % 32),
                              (double)(s >> 40) / 1e3, (double)(s >> 44) / 1e3, i);
    }
    return t;
}

static uint8_t *gzip(const void *data, size_t n, size_t *out_n)
{
    z_stream z = {0};
    assert_int_equal(deflateInit2(&z, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);
    uLong cap = deflateBound(&z, (uLong)n) + 64;
    uint8_t *out = malloc(cap);
    z.next_in = (Bytef *)(uintptr_t)data;
    z.avail_in = (uInt)n;
    z.next_out = out;
    z.avail_out = (uInt)cap;
    assert_int_equal(deflate(&z, Z_FINISH), Z_STREAM_END);
    *out_n = z.total_out;
    deflateEnd(&z);
    return out;
}

static uint8_t *concat(const void *a, size_t na, const void *b, size_t nb)
{
    uint8_t *c = malloc(na + nb + 1);
    memcpy(c, a, na);
    if (nb > 0) memcpy(c + na, b, nb);
    return c;
}

// Both faces must give the same bytes.
static void expect_text(const void *data, size_t n, const char *text, size_t text_n)
{
    orr_bytes b;
    orr_diag d = {0};
    ASSERT_OK(orr_input_read_bytes("made", data, n, NULL, &b, &d), d);
    assert_int_equal(b.n, text_n);
    assert_memory_equal(b.text, text, text_n);
    assert_int_equal(b.text[b.n], 0);
    orr_bytes_free(&b);

    orr_input *in = NULL;
    ASSERT_OK(orr_input_open_bytes("made", data, n, NULL, &in, &d), d);
    orr_cursor c;
    orr_view want, got;
    orr_cursor_init(&c, "made", text, text_n);
    while (orr_cursor_next(&c, &want)) {
        assert_true(orr_input_line(in, &got));
        assert_int_equal(got.n, want.n);
        assert_memory_equal(got.p, want.p, want.n);
        assert_int_equal(orr_input_line_number(in), c.line);
        if (c.line % 7 == 0) { // put back and read again
            orr_input_unline(in);
            assert_true(orr_input_line(in, &got));
            assert_memory_equal(got.p, want.p, want.n);
        }
    }
    assert_false(orr_input_line(in, &got));
    ASSERT_OK(orr_input_status(in, &d), d);
    orr_input_close(in);
}

// Both faces must refuse with this status; returns the sentence of the first.
static const char *expect_refusal(const void *data, size_t n, const orr_input_limits *limits,
                                  orr_status status)
{
    static orr_diag d;
    orr_bytes b;
    d = (orr_diag){0};
    assert_int_equal(orr_input_read_bytes("made", data, n, limits, &b, &d), status);
    assert_null(b.text);
    orr_input *in = NULL;
    orr_view line;
    orr_diag e = {0};
    orr_status st = orr_input_open_bytes("made", data, n, limits, &in, &e);
    if (st == ORR_OK) {
        while (orr_input_line(in, &line)) continue;
        st = orr_input_status(in, &e);
        orr_input_close(in);
    }
    assert_int_equal(st, status);
    assert_true(strlen(e.text) > 0);
    return d.text;
}

static void test_plain(void **state)
{
    (void)state;
    expect_text("a\nb", 3, "a\nb", 3);
    expect_text("\n", 1, "\n", 1);
    size_t n;
    char *t = made_text(20000, &n); // over a megabyte: the stream's buffer turns over several times
    expect_text(t, n, t, n);
    free(t);
}

static void test_gzip(void **state)
{
    (void)state;
    size_t n, zn, an;
    char *t = made_text(20000, &n);
    uint8_t *z = gzip(t, n, &zn);
    expect_text(z, zn, t, n);
    // Members one after the other, an empty one among them, and padding behind.
    uint8_t *half = gzip(t, n / 2, &an), *none, *rest;
    size_t nn, rn;
    none = gzip("", 0, &nn);
    rest = gzip(t + n / 2, n - n / 2, &rn);
    uint8_t *ab = concat(half, an, none, nn), *abc = concat(ab, an + nn, rest, rn);
    static const uint8_t zeros[700];
    uint8_t *padded = concat(abc, an + nn + rn, zeros, sizeof zeros);
    expect_text(abc, an + nn + rn, t, n);
    expect_text(padded, an + nn + rn + sizeof zeros, t, n);
    // gzip inside gzip, as a server that compresses once more sends it.
    size_t zzn;
    uint8_t *zz = gzip(z, zn, &zzn);
    expect_text(zz, zzn, t, n);
    // Cut anywhere, it is refused; so is a changed byte in the middle (the CRC at least sees it) and trailing
    // rubbish.
    for (size_t cut = 2; cut < zn; cut += 1 + zn / 50) expect_refusal(z, cut, NULL, ORR_E_FORMAT);
    z[zn / 2] ^= 0x10;
    expect_refusal(z, zn, NULL, ORR_E_FORMAT);
    uint8_t *rubbish = concat(rest, rn, "rubbish", 7);
    expect_refusal(rubbish, rn + 7, NULL, ORR_E_FORMAT);
    free(rubbish);
    free(zz);
    free(padded);
    free(abc);
    free(ab);
    free(rest);
    free(none);
    free(half);
    free(z);
    free(t);
}

static void test_lzw(void **state)
{
    (void)state;
    size_t n, zn;
    char *t = made_text(30000, &n);
    for (int width = 10; width <= 16; width++)
        for (int block = 0; block < 2; block++) {
            uint8_t *z = lzw_encode((uint8_t *)t, n, width, block != 0, 0, &zn);
            expect_text(z, zn, t, n);
            free(z);
        }
    const unsigned clear_every[] = {1, 7, 8, 255, 256, 257, 1000, 9999};
    for (size_t i = 0; i < sizeof clear_every / sizeof *clear_every; i++) {
        uint8_t *z = lzw_encode((uint8_t *)t, 60000, 16, true, clear_every[i], &zn);
        expect_text(z, zn, t, 60000);
        free(z);
    }
    // Runs make codes that are used in the step that defines them, and the longest texts of a code.
    char *run = malloc(3000000);
    memset(run, 'x', 3000000);
    uint8_t *z = lzw_encode((uint8_t *)run, 3000000, 16, true, 0, &zn);
    orr_bytes b;
    orr_diag d = {0};
    ASSERT_OK(orr_input_read_bytes("run", z, zn, NULL, &b, &d), d);
    assert_int_equal(b.n, 3000000);
    assert_memory_equal(b.text, run, 3000000);
    orr_bytes_free(&b);
    free(run);
    free(z);
    for (size_t k = 0; k < 20; k++) { // every small size: ends in all positions of a group
        z = lzw_encode((uint8_t *)t, 1 + k, 16, true, 3, &zn);
        expect_text(z, zn, t, 1 + k);
        free(z);
    }
    // gzip inside .Z
    size_t gn;
    uint8_t *g = gzip(t, n, &gn), *gz = lzw_encode(g, gn, 16, true, 0, &zn);
    expect_text(gz, zn, t, n);
    free(gz);
    free(g);
    free(t);
}

static void test_lzw_damaged(void **state)
{
    (void)state;
    assert_non_null(strstr(expect_refusal("\x1f\x9d", 2, NULL, ORR_E_FORMAT), ".Z"));
    expect_refusal("\x1f\x9d\x88", 3, NULL, ORR_E_FORMAT);     // 8 bits
    expect_refusal("\x1f\x9d\x91", 3, NULL, ORR_E_FORMAT);     // 17 bits
    expect_refusal("\x1f\x9d\xb0", 3, NULL, ORR_E_FORMAT);     // a reserved bit
    expect_refusal("\x1f\x9d\x90", 3, NULL, ORR_E_KIND);       // expands to nothing
    expect_refusal("\x1f\x9d\x90\x41", 4, NULL, ORR_E_FORMAT); // half a code
    // 'A' then code 300, which nothing defined; and a first code that is no byte.
    uint8_t z[8] = {0x1f, 0x9d, 0x90};
    lzw_writer w = {.out = z, .bits = 24, .capacity = sizeof z};
    lzw_put(&w, 'A', 9);
    lzw_put(&w, 300, 9);
    expect_refusal(z, (w.bits + 7) / 8, NULL, ORR_E_FORMAT);
    uint8_t y[8] = {0x1f, 0x9d, 0x90};
    w = (lzw_writer){.out = y, .bits = 24, .capacity = sizeof y};
    lzw_put(&w, 400, 9);
    expect_refusal(y, (w.bits + 7) / 8, NULL, ORR_E_FORMAT);
}

static void test_limits(void **state)
{
    (void)state;
    size_t n, zn;
    char *t = made_text(2000, &n);
    orr_input_limits l = orr_input_default_limits();
    l.max_bytes = n - 1;
    expect_refusal(t, n, &l, ORR_E_LIMIT);
    l.max_bytes = n;
    orr_bytes b;
    orr_diag d = {0};
    ASSERT_OK(orr_input_read_bytes("made", t, n, &l, &b, &d), d);
    orr_bytes_free(&b);
    free(t);
    // A megabyte of zeros in a thousand bytes.
    char *zeros = calloc(1, 1 << 20);
    uint8_t *z = gzip(zeros, 1 << 20, &zn);
    l = orr_input_default_limits();
    l.max_ratio = 100;
    l.ratio_grace = 1 << 16;
    assert_non_null(strstr(expect_refusal(z, zn, &l, ORR_E_LIMIT), "100-fold"));
    free(z);
    free(zeros);
    // Lines: at the limit and over it, within the stream's buffer and beyond it.
    for (size_t max = 100; max <= 1000000; max *= 100) {
        char *line = malloc(max + 2);
        memset(line, 'x', max + 1);
        line[max + 1] = '\n';
        l = orr_input_default_limits();
        l.max_line = max;
        orr_input *in = NULL;
        orr_view v;
        ASSERT_OK(orr_input_open_bytes("made", line + 1, max + 1, &l, &in, &d), d);
        assert_true(orr_input_line(in, &v) && v.n == max);
        orr_input_close(in);
        ASSERT_OK(orr_input_open_bytes("made", line, max + 2, &l, &in, &d), d);
        assert_false(orr_input_line(in, &v));
        assert_int_equal(orr_input_status(in, &d), ORR_E_LIMIT);
        orr_input_close(in);
        free(line);
    }
}

static void test_not_data(void **state)
{
    (void)state;
    assert_non_null(strstr(expect_refusal("", 0, NULL, ORR_E_KIND), "empty"));
    const char *pages[] = {"<!DOCTYPE html>\n<html>", "\xef\xbb\xbf\n <HTML><head>", "<html lang=en>"};
    for (size_t i = 0; i < 3; i++) {
        size_t zn;
        uint8_t *z = gzip(pages[i], strlen(pages[i]), &zn);
        assert_non_null(strstr(expect_refusal(pages[i], strlen(pages[i]), NULL, ORR_E_KIND), "web page"));
        assert_non_null(strstr(expect_refusal(z, zn, NULL, ORR_E_KIND), "web page"));
        free(z);
    }
    assert_non_null(strstr(expect_refusal("one\rtwo\rthree", 13, NULL, ORR_E_KIND), "CR alone"));
    expect_text("one\r", 4, "one\r", 4); // cut inside CR LF
    assert_non_null(strstr(expect_refusal("PK\x03\x04....", 8, NULL, ORR_E_KIND), "zip"));
    orr_diag d = {0};
    orr_bytes b;
    assert_int_equal(orr_input_read_all(ORR_BINARY_DIR, NULL, &b, &d), ORR_E_KIND);
    assert_non_null(strstr(d.text, "folder"));
    assert_int_equal(orr_input_read_all(ORR_BINARY_DIR "/no-such-file", NULL, &b, &d), ORR_E_IO);
}

static void test_file(void **state)
{
    (void)state;
    const char *path = ORR_BINARY_DIR "/test_input.tmp";
    size_t n;
    char *t = made_text(5000, &n);
    FILE *f = fopen(path, "wb");
    assert_non_null(f);
    assert_int_equal(fwrite(t, 1, n, f), n);
    fclose(f);
    orr_diag d = {0};
    orr_bytes b;
    ASSERT_OK(orr_input_read_all(path, NULL, &b, &d), d);
    assert_int_equal(b.n, n);
    assert_memory_equal(b.text, t, n);
    orr_bytes_free(&b);
    orr_input *in = NULL;
    ASSERT_OK(orr_input_open(path, NULL, &in, &d), d);
    assert_string_equal(orr_input_name(in), path);
    assert_true(orr_input_head(in).n >= 1000);
    orr_input_close(in);
    unlink(path);
    free(t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_plain),       cmocka_unit_test(test_gzip),   cmocka_unit_test(test_lzw),
        cmocka_unit_test(test_lzw_damaged), cmocka_unit_test(test_limits), cmocka_unit_test(test_not_data),
        cmocka_unit_test(test_file),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
