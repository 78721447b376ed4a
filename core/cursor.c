// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cursor.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void orr_cursor_init(orr_cursor *c, const char *name, const char *text, size_t n)
{
    *c = (orr_cursor){.name = name, .at = text, .end = text + n, .max_line = ORR_LINE_MAX};
}

bool orr_cursor_next(orr_cursor *c, orr_view *line)
{
    if (c->at >= c->end || c->too_long) return false;
    size_t left = (size_t)(c->end - c->at);
    const char *lf = memchr(c->at, '\n', left);
    size_t n = lf != NULL ? (size_t)(lf - c->at) : left;
    c->line++;
    if (n > c->max_line) {
        c->too_long = true;
        return false;
    }
    *line = (orr_view){c->at, n};
    if (n > 0 && c->at[n - 1] == '\r') line->n--;
    c->unterminated = lf == NULL;
    c->at = lf != NULL ? lf + 1 : c->end;
    return true;
}

orr_status orr_cursor_status(const orr_cursor *c, orr_diag *diag)
{
    if (!c->too_long) return ORR_OK;
    return orr_diag_at(diag, ORR_E_LIMIT, c->name, c->line, 0,
                       "this line is longer than %zu bytes; no format of this kind has such lines",
                       c->max_line);
}

orr_status orr_cursor_error(const orr_cursor *c, orr_diag *diag, orr_status s, int column, const char *fmt,
                            ...)
{
    char text[sizeof diag->text];
    va_list ap;
    va_start(ap, fmt);
    vsnprintf(text, sizeof text, fmt, ap);
    va_end(ap);
    return orr_diag_at(diag, s, c->name, c->line, column, "%s", text);
}

void orr_cursor_warn(const orr_cursor *c, orr_warnings *w, int column, const char *fmt, ...)
{
    if (w == NULL) return;
    char text[sizeof((orr_diag *)0)->text];
    va_list ap;
    va_start(ap, fmt);
    vsnprintf(text, sizeof text, fmt, ap);
    va_end(ap);
    orr_warnings_add(w, c->name, c->line, column, "%s", text);
}

static bool is_blank(char c) { return c == ' ' || c == '\t'; }

orr_view orr_view_of(const char *nul_terminated)
{
    return (orr_view){nul_terminated, strlen(nul_terminated)};
}

orr_view orr_view_cols(orr_view line, int col, int width)
{
    size_t from = (size_t)(col - 1);
    if (from >= line.n) return (orr_view){line.p + line.n, 0};
    size_t left = line.n - from;
    return (orr_view){line.p + from, (size_t)width < left ? (size_t)width : left};
}

orr_view orr_view_rtrim(orr_view v)
{
    while (v.n > 0 && is_blank(v.p[v.n - 1])) v.n--;
    return v;
}

orr_view orr_view_trim(orr_view v)
{
    v = orr_view_rtrim(v);
    while (v.n > 0 && is_blank(*v.p)) {
        v.p++;
        v.n--;
    }
    return v;
}

bool orr_view_is_blank(orr_view v) { return orr_view_rtrim(v).n == 0; }

bool orr_view_equals(orr_view v, const char *s)
{
    size_t n = strlen(s);
    return v.n == n && memcmp(v.p, s, n) == 0;
}

bool orr_view_starts(orr_view v, const char *s)
{
    size_t n = strlen(s);
    return v.n >= n && memcmp(v.p, s, n) == 0;
}

bool orr_view_contains(orr_view v, const char *s)
{
    size_t n = strlen(s);
    for (size_t i = 0; i + n <= v.n; i++)
        if (memcmp(v.p + i, s, n) == 0) return true;
    return false;
}

static void copy_printable(char *to, const char *from, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        unsigned char c = (unsigned char)from[i];
        to[i] = from[i];
        if (c == '\t')
            to[i] = ' ';
        else if (c < 0x20 || c == 0x7f)
            to[i] = '?';
    }
    to[n] = '\0';
}

char *orr_view_copy(orr_view v, char *buf, size_t n)
{
    copy_printable(buf, v.p, v.n < n ? v.n : n - 1);
    return buf;
}

char *orr_view_dup(orr_view v)
{
    char *s = malloc(v.n + 1);
    if (s != NULL) copy_printable(s, v.p, v.n);
    return s;
}

bool orr_view_word(orr_view *rest, orr_view *word)
{
    while (rest->n > 0 && is_blank(*rest->p)) {
        rest->p++;
        rest->n--;
    }
    size_t n = 0;
    while (n < rest->n && !is_blank(rest->p[n])) n++;
    *word = (orr_view){rest->p, n};
    rest->p += n;
    rest->n -= n;
    return n > 0;
}

bool orr_view_split(orr_view *rest, char separator, orr_view *part)
{
    if (rest->p == NULL) return false;
    const char *cut = rest->n > 0 ? memchr(rest->p, separator, rest->n) : NULL;
    if (cut == NULL) {
        *part = *rest;
        *rest = (orr_view){NULL, 0};
        return true;
    }
    part->p = rest->p;
    part->n = (size_t)(cut - rest->p);
    rest->n -= part->n + 1;
    rest->p = cut + 1;
    return true;
}

orr_field orr_field_real(orr_view line, int col, int width, double *out)
{
    return orr_view_real(orr_view_cols(line, col, width), out);
}

orr_field orr_field_int(orr_view line, int col, int width, int64_t *out)
{
    return orr_view_int(orr_view_cols(line, col, width), out);
}

orr_field orr_field_int_in(orr_view line, int col, int width, int lo, int hi, int *out)
{
    int64_t v = 0;
    orr_field f = orr_field_int(line, col, width, &v);
    if (f != ORR_FIELD_OK) return f;
    if (v < lo || v > hi) return ORR_FIELD_BAD;
    *out = (int)v;
    return ORR_FIELD_OK;
}

orr_field orr_view_int(orr_view v, int64_t *out)
{
    const char *p = v.p, *end = v.p + v.n;
    while (p < end && is_blank(*p)) p++;
    if (p == end) return ORR_FIELD_BLANK;
    bool minus = *p == '-';
    if (*p == '-' || *p == '+') p++;
    const char *digits = p;
    uint64_t m = 0;
    for (; p < end; p++) {
        unsigned d = (unsigned)(unsigned char)*p - '0';
        if (d > 9) break;
        if (m > (UINT64_MAX - 9) / 10) return ORR_FIELD_BAD;
        m = m * 10 + d;
    }
    if (p == digits) return ORR_FIELD_BAD;
    while (p < end && is_blank(*p)) p++;
    if (p != end || m > (uint64_t)INT64_MAX + (minus ? 1 : 0)) return ORR_FIELD_BAD;
    *out = !minus ? (int64_t)m : m > (uint64_t)INT64_MAX ? INT64_MIN : -(int64_t)m;
    return ORR_FIELD_OK;
}
