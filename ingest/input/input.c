// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/input/input.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "ingest/input/sniff.h"
#include "ingest/input/stage.h"

enum { MAX_LAYERS = 3, BUFFER = 1 << 18, HEAD = 1 << 16 };
#define WHOLE ((size_t)64 << 20) // compressed files up to so many bytes are expanded at one go

struct orr_input {
    char *name;
    orr_stage *top; // its `below` chain ends at the file
    orr_stage *bottom;
    orr_input_limits limits;
    bool at_end; // the stages have no more
    bool failed;
    orr_diag failure;
    // Lines: buf[from, to) is text not yet returned.
    char *buf;
    size_t capacity, from, to;
    size_t line_from; // where the line returned last began, for orr_input_unline
    bool has_line, unlined;
    int64_t line;
};

orr_input_limits orr_input_default_limits(void)
{
    return (orr_input_limits){.max_bytes = (size_t)1 << 31,
                              .max_line = ORR_LINE_MAX,
                              .max_ratio = 300,
                              .ratio_grace = (size_t)64 << 20};
}

// Files that are no text at all and that people do hold in hand; named so that the cure is plain.
static const char *foreign_name(const uint8_t *b, size_t n)
{
    static const struct {
        const char *magic;
        size_t n;
        const char *what;
    } known[] = {
        {"PK\x03\x04", 4, "a zip archive: unpack it and give the file inside"},
        {"PK\x05\x06", 4, "an empty zip archive"},
        {"BZh", 3, "bzip2 data: unpack it with bunzip2 first"},
        {"\xfd"
         "7zXZ",
         5, "xz data: unpack it with unxz first"},
        {"\x28\xb5\x2f\xfd", 4, "zstd data: unpack it with unzstd first"},
        {"7z\xbc\xaf", 4, "a 7-zip archive: unpack it and give the file inside"},
        {"Rar!", 4, "a rar archive: unpack it and give the file inside"},
        {"\x1f\xa0", 2, "LZH-compressed data (SCO compress -H), which is not read"},
        {"\x1f\x1e", 2, "packed data (Unix pack), which is not read"},
        {"%PDF", 4, "a PDF document"},
        {"\x7f"
         "ELF",
         4, "a program"},
        {"\x89PNG", 4, "a picture (PNG)"},
        {"\xff\xfe", 2, "UTF-16 text: save it as ASCII or UTF-8"},
        {"\xfe\xff", 2, "UTF-16 text: save it as ASCII or UTF-8"},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (n >= known[i].n && memcmp(b, known[i].magic, known[i].n) == 0) return known[i].what;
    return NULL;
}

// Puts a decompressor on top for as long as what comes out is compressed again.
static orr_status add_layers(orr_stage **top, orr_diag *diag)
{
    for (int layers = 0;; layers++) {
        const uint8_t *b = NULL;
        size_t n = 0;
        orr_status st = orr_stage_peek(*top, &b, &n, diag);
        if (st != ORR_OK) return st;
        const char *name = (*top)->name;
        if (n == 0)
            return orr_diag_at(diag, ORR_E_KIND, name, 0, 0,
                               layers == 0 ? "the file is empty" : "the file expands to nothing");
        bool gzip = n >= 2 && b[0] == 0x1f && b[1] == 0x8b;
        bool lzw = n >= 2 && b[0] == 0x1f && b[1] == 0x9d;
        if (!gzip && !lzw) {
            const char *what = foreign_name(b, n);
            if (what != NULL) return orr_diag_at(diag, ORR_E_KIND, name, 0, 0, "this is %s", what);
            return ORR_OK;
        }
        if (layers == MAX_LAYERS)
            return orr_diag_at(diag, ORR_E_LIMIT, name, 0, 0, "compressed more than %d times over",
                               MAX_LAYERS);
        orr_stage *next = NULL;
        st = gzip ? orr_stage_gzip(*top, &next, diag) : orr_stage_lzw(*top, &next, diag);
        if (st != ORR_OK) return st;
        *top = next;
    }
}

static bool starts_nocase(const char *p, size_t n, const char *s)
{
    size_t k = strlen(s);
    return n >= k && strncasecmp(p, s, k) == 0;
}

// Text whose lines end with CR alone would be one line to every reader.
static orr_status refuse_bare_cr(const char *name, const char *p, size_t n, orr_diag *diag)
{
    if (n > HEAD) n = HEAD;
    if (n == 0 || memchr(p, '\r', n - 1) == NULL || memchr(p, '\n', n) != NULL || memchr(p, '\0', n) != NULL)
        return ORR_OK;
    return orr_diag_at(diag, ORR_E_KIND, name, 0, 0,
                       "lines end with CR alone, as on old Macintoshes: turn them into LF (tr '\\r' '\\n')");
}

// A server's answer (login form, "404 not found") saved under the name of the file that was asked for.
static orr_status refuse_web_page(const char *name, const char *p, size_t n, orr_diag *diag)
{
    if (n >= 3 && memcmp(p, "\xef\xbb\xbf", 3) == 0) {
        p += 3;
        n -= 3;
    }
    while (n > 0 && (*p == ' ' || *p == '\t' || *p == '\r' || *p == '\n')) {
        p++;
        n--;
    }
    if (n == 0 || *p != '<') return refuse_bare_cr(name, p, n, diag);
    static const char *const opening[] = {"<!doctype", "<html",   "<head", "<body",
                                          "<!--",      "<script", "<title"};
    bool page = false;
    for (size_t i = 0; i < sizeof opening / sizeof *opening; i++)
        page = page || starts_nocase(p, n, opening[i]);
    if (page)
        return orr_diag_at(
            diag, ORR_E_KIND, name, 0, 0,
            "this is a web page, not a data file (a server's error or login page saved under the "
            "file's name?): fetch it again");
    if (starts_nocase(p, n, "<?xml"))
        return orr_diag_at(diag, ORR_E_KIND, name, 0, 0,
                           "this is an XML document (a server's error message?), not a data file");
    return ORR_OK;
}

static void set_failure(orr_input *in, const orr_diag *why)
{
    in->failed = true;
    in->failure = *why;
}

// One read through the limits.
static orr_status draw(orr_input *in, void *to, size_t capacity, size_t *got, orr_diag *diag)
{
    *got = 0;
    if (in->at_end) return ORR_OK;
    orr_status st = orr_stage_read(in->top, to, capacity, got, diag);
    if (st != ORR_OK) return st;
    in->at_end = *got == 0;
    uint64_t out = in->top->total, packed = in->bottom->total;
    if (out > in->limits.max_bytes)
        return orr_diag_at(diag, ORR_E_LIMIT, in->name, 0, 0,
                           "the text is longer than %zu bytes, the limit of this reader",
                           in->limits.max_bytes);
    if (out > in->limits.ratio_grace && out / in->limits.max_ratio > packed)
        return orr_diag_at(diag, ORR_E_LIMIT, in->name, 0, 0,
                           "expands more than %zu-fold, which no data file does (a decompression bomb?)",
                           in->limits.max_ratio);
    return ORR_OK;
}

static orr_status open_stage(orr_stage *bottom, const orr_input_limits *limits, orr_input **out,
                             orr_diag *diag)
{
    orr_input *in = calloc(1, sizeof *in);
    if (in == NULL) {
        bottom->close(bottom);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    in->top = in->bottom = bottom;
    in->limits = limits != NULL ? *limits : orr_input_default_limits();
    orr_status st = ORR_OK;
    in->name = strdup(bottom->name);
    if (in->name == NULL) {
        st = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    } else {
        bottom->name = in->name;
        st = add_layers(&in->top, diag);
    }
    if (st != ORR_OK) {
        orr_input_close(in);
        return st;
    }
    *out = in;
    return ORR_OK;
}

// Spreadsheets begin a text with UTF-8's byte order mark, which is none of it.
#define MARK_LENGTH 3
static size_t mark_length(const char *text, size_t n)
{
    return n >= MARK_LENGTH && memcmp(text, "\xEF\xBB\xBF", MARK_LENGTH) == 0 ? MARK_LENGTH : 0;
}

// Room for lines, and the first bytes looked at.
static orr_status start_stream(orr_input *in, orr_diag *diag)
{
    in->capacity = BUFFER;
    in->buf = malloc(in->capacity);
    if (in->buf == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    while (in->to < HEAD && !in->at_end) {
        size_t got = 0;
        orr_diag why = {0};
        orr_status st = draw(in, in->buf + in->to, in->capacity - in->to, &got, &why);
        if (st != ORR_OK) { // what came before the damage can still be told
            set_failure(in, &why);
            if (in->to == 0) {
                if (diag != NULL) *diag = why;
                return st;
            }
            break;
        }
        in->to += got;
    }
    in->from = mark_length(in->buf, in->to);
    return refuse_web_page(in->name, in->buf, in->to, diag);
}

static orr_status open_stream(orr_stage *bottom, const orr_input_limits *limits, orr_input **out,
                              orr_diag *diag)
{
    *out = NULL;
    orr_input *in = NULL;
    orr_status st = open_stage(bottom, limits, &in, diag);
    if (st != ORR_OK) return st;
    st = start_stream(in, diag);
    if (st != ORR_OK) {
        orr_input_close(in);
        return st;
    }
    *out = in;
    return ORR_OK;
}

orr_status orr_input_open(const char *path, const orr_input_limits *limits, orr_input **out, orr_diag *diag)
{
    *out = NULL;
    orr_stage *bottom = NULL;
    size_t size = 0;
    orr_status st = orr_stage_file(path, &bottom, &size, diag);
    return st == ORR_OK ? open_stream(bottom, limits, out, diag) : st;
}

orr_status orr_input_open_bytes(const char *name, const void *data, size_t n, const orr_input_limits *limits,
                                orr_input **out, orr_diag *diag)
{
    *out = NULL;
    orr_stage *bottom = NULL;
    orr_status st = orr_stage_memory(name, data, n, &bottom, diag);
    return st == ORR_OK ? open_stream(bottom, limits, out, diag) : st;
}

void orr_input_close(orr_input *in)
{
    if (in == NULL) return;
    for (orr_stage *s = in->top; s != NULL;) {
        orr_stage *below = s->below;
        s->close(s);
        s = below;
    }
    free(in->buf);
    free(in->name);
    free(in);
}

const char *orr_input_name(const orr_input *in) { return in->name; }
int64_t orr_input_line_number(const orr_input *in) { return in->line; }
orr_view orr_input_head(orr_input *in) { return (orr_view){in->buf + in->from, in->to - in->from}; }

orr_status orr_input_status(const orr_input *in, orr_diag *diag)
{
    if (!in->failed) return ORR_OK;
    if (diag != NULL) *diag = in->failure;
    return in->failure.status;
}

// Makes room behind the text that is not yet returned: moves it down, and grows the buffer up to the longest
// line.
static bool make_room(orr_input *in)
{
    if (in->from > 0) {
        memmove(in->buf, in->buf + in->from, in->to - in->from);
        in->to -= in->from;
        in->from = in->line_from = 0;
    }
    if (in->to < in->capacity) return true;
    orr_diag why = {0};
    if (in->to > in->limits.max_line) {
        orr_diag_at(&why, ORR_E_LIMIT, in->name, in->line + 1, 0,
                    "this line is longer than %zu bytes; no format of this kind has such lines",
                    in->limits.max_line);
        set_failure(in, &why);
        return false;
    }
    char *grown = realloc(in->buf, in->capacity * 2);
    if (grown == NULL) {
        orr_diag_set(&why, ORR_E_MEMORY, "out of memory");
        set_failure(in, &why);
        return false;
    }
    in->buf = grown;
    in->capacity *= 2;
    return true;
}

bool orr_input_line(orr_input *in, orr_view *line)
{
    if (in->unlined) {
        in->from = in->line_from;
        in->unlined = false;
    }
    in->has_line = false;
    size_t searched = in->from;
    const char *lf;
    while ((lf = memchr(in->buf + searched, '\n', in->to - searched)) == NULL) {
        if (in->failed) return false; // a line cut by damage is no line
        if (in->at_end) break;
        size_t keep = in->to - in->from;
        if (!make_room(in)) return false;
        searched = in->from + keep;
        size_t got = 0;
        orr_diag why = {0};
        if (draw(in, in->buf + in->to, in->capacity - in->to, &got, &why) != ORR_OK) set_failure(in, &why);
        in->to += got;
    }
    const char *p = in->buf + in->from;
    size_t n = lf != NULL ? (size_t)(lf - p) : in->to - in->from;
    if (lf == NULL && n == 0) return false;
    in->line++;
    if (n > in->limits.max_line) {
        orr_diag why = {0};
        orr_diag_at(&why, ORR_E_LIMIT, in->name, in->line, 0,
                    "this line is longer than %zu bytes; no format of this kind has such lines",
                    in->limits.max_line);
        set_failure(in, &why);
        in->from = in->to;
        return false;
    }
    in->has_line = true;
    in->line_from = in->from;
    in->from += n + (lf != NULL ? 1 : 0);
    if (n > 0 && p[n - 1] == '\r') n--;
    *line = (orr_view){p, n};
    return true;
}

void orr_input_unline(orr_input *in)
{
    if (in->unlined || !in->has_line) return;
    in->unlined = true;
    in->line--;
}

// What every whole text goes through: web pages, the byte order mark, the final NUL.
static orr_status finish_whole(const char *name, orr_bytes *b, orr_diag *diag)
{
    orr_status st = refuse_web_page(name, b->text, b->n, diag);
    if (st != ORR_OK) return st;
    if (mark_length(b->text, b->n) > 0) {
        b->n -= mark_length(b->text, b->n);
        memmove(b->text, b->text + MARK_LENGTH, b->n);
    }
    b->text[b->n] = '\0';
    return ORR_OK;
}

// A plain gzip file by the short way. False where it is none, or not so plain: then the layers look at it.
static bool read_gzip(const uint8_t *packed, size_t n, const orr_input_limits *limits, orr_bytes *b)
{
    const orr_input_limits l = limits != NULL ? *limits : orr_input_default_limits();
    if (n < 2 || packed[0] != 0x1f || packed[1] != 0x8b) return false;
    size_t limit = n < (SIZE_MAX - l.ratio_grace) / l.max_ratio ? n * l.max_ratio + l.ratio_grace : SIZE_MAX;
    if (limit > l.max_bytes) limit = l.max_bytes;
    if (!orr_gzip_whole(packed, n, limit, &b->text, &b->n)) return false;
    const uint8_t *text = (const uint8_t *)b->text;
    if (b->n > 0 && text[0] != 0x1f && foreign_name(text, b->n) == NULL) return true;
    orr_bytes_free(b);
    return false;
}

static orr_status read_whole(orr_stage *bottom, size_t hint, const orr_input_limits *limits, orr_bytes *out,
                             orr_diag *diag)
{
    orr_input *in = NULL;
    orr_status st = open_stage(bottom, limits, &in, diag);
    if (st != ORR_OK) return st;
    // One byte over the text, for the NUL; a file that is not compressed then fits at the first go.
    size_t capacity = (in->top == in->bottom ? hint : 4 * hint) + 65536;
    orr_bytes b = {.text = malloc(capacity)};
    if (b.text == NULL) st = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    bool judged = in->limits.kinds == 0;
    while (st == ORR_OK && !in->at_end) {
        size_t got = 0;
        st = draw(in, b.text + b.n, capacity - b.n - 1, &got, diag);
        b.n += got;
        if (st == ORR_OK && !judged && b.n > ORR_INPUT_JUDGED) {
            st = orr_sniff_expect(in->name, (orr_view){b.text, HEAD}, in->limits.kinds, diag);
            judged = true;
        }
        if (st == ORR_OK && !in->at_end && capacity - b.n - 1 < 4096) {
            char *grown = realloc(b.text, capacity * 2);
            if (grown == NULL) {
                st = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
            } else {
                b.text = grown;
                capacity *= 2;
            }
        }
    }
    if (st == ORR_OK) st = finish_whole(in->name, &b, diag);
    orr_input_close(in);
    if (st != ORR_OK) {
        free(b.text);
        return st;
    }
    *out = b;
    return ORR_OK;
}

// All bytes of a stage as they are; *n is 0 where there are more than `most`, which are left to the stage.
static orr_status slurp(orr_stage *s, size_t most, uint8_t **bytes, size_t *n, orr_diag *diag)
{
    *n = 0;
    *bytes = malloc(most + 1);
    if (*bytes == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    size_t got = 1;
    orr_status st = ORR_OK;
    while (st == ORR_OK && got > 0 && *n <= most) {
        st = orr_stage_read(s, *bytes + *n, most + 1 - *n, &got, diag);
        *n += got;
    }
    return st;
}

orr_status orr_input_read_bytes(const char *name, const void *data, size_t n, const orr_input_limits *limits,
                                orr_bytes *out, orr_diag *diag)
{
    *out = (orr_bytes){0};
    if (read_gzip(data, n, limits, out)) {
        orr_status st = finish_whole(name, out, diag);
        if (st != ORR_OK) orr_bytes_free(out);
        return st;
    }
    orr_stage *bottom = NULL;
    orr_status st = orr_stage_memory(name, data, n, &bottom, diag);
    return st == ORR_OK ? read_whole(bottom, n, limits, out, diag) : st;
}

orr_status orr_input_read_all(const char *path, const orr_input_limits *limits, orr_bytes *out,
                              orr_diag *diag)
{
    *out = (orr_bytes){0};
    orr_stage *bottom = NULL;
    const uint8_t *first;
    uint8_t *packed = NULL;
    size_t hint = 0, n = 0;
    orr_status st = orr_stage_file(path, &bottom, &hint, diag);
    if (st != ORR_OK) return st;
    st = orr_stage_peek(bottom, &first, &n, diag);
    const bool whole =
        st == ORR_OK && hint > 0 && hint <= WHOLE && n >= 2 && first[0] == 0x1f && first[1] == 0x8b;
    if (st == ORR_OK && !whole) return read_whole(bottom, hint, limits, out, diag);
    if (st == ORR_OK) st = slurp(bottom, hint, &packed, &n, diag);
    bottom->close(bottom);
    if (st == ORR_OK && n > hint)
        st = orr_diag_at(diag, ORR_E_IO, path, 0, 0, "the file grew while it was read");
    if (st == ORR_OK) st = orr_input_read_bytes(path, packed, n, limits, out, diag);
    free(packed);
    return st;
}

void orr_bytes_free(orr_bytes *b)
{
    free(b->text);
    *b = (orr_bytes){0};
}
