// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/status.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *orr_status_name(orr_status s)
{
    switch (s) {
    case ORR_OK:
        return "ok";
    case ORR_E_ARG:
        return "bad argument";
    case ORR_E_IO:
        return "input/output error";
    case ORR_E_KIND:
        return "wrong kind of file";
    case ORR_E_FORMAT:
        return "format error";
    case ORR_E_LIMIT:
        return "limit exceeded";
    case ORR_E_RANGE:
        return "out of range";
    case ORR_E_NODATA:
        return "no data";
    case ORR_E_NUMERIC:
        return "numerical failure";
    case ORR_E_MEMORY:
        return "out of memory";
    case ORR_E_UNSUPPORTED:
        return "unsupported";
    case ORR_E_INTERRUPTED:
        return "interrupted";
    }
    return "unknown status";
}

// snprintf into buf; a text that does not fit ends in "..." so that the reader sees that it was cut.
static void print_cut(char *buf, size_t n, const char *fmt, va_list args)
{
    int len = vsnprintf(buf, n, fmt, args);
    if (len < 0)
        snprintf(buf, n, "(unprintable message)");
    else if ((size_t)len >= n)
        memcpy(buf + n - 4, "...", 4);
}

static void fill(orr_diag *d, orr_status s, const char *file, int64_t line, int column, const char *fmt,
                 va_list args)
{
    d->status = s;
    d->line = line;
    d->column = column;
    d->file[0] = '\0';
    if (file != NULL) {
        size_t len = strlen(file);
        if (len < sizeof d->file) {
            memcpy(d->file, file, len + 1);
        } else { // the end of a path says more than its beginning
            memcpy(d->file, "...", 3);
            memcpy(d->file + 3, file + len - (sizeof d->file - 4), sizeof d->file - 3);
        }
    }
    print_cut(d->text, sizeof d->text, fmt, args);
}

orr_status orr_diag_set(orr_diag *d, orr_status s, const char *fmt, ...)
{
    if (d != NULL) {
        va_list args;
        va_start(args, fmt);
        fill(d, s, NULL, 0, 0, fmt, args);
        va_end(args);
    }
    return s;
}

orr_status orr_diag_at(orr_diag *d, orr_status s, const char *file, int64_t line, int column, const char *fmt,
                       ...)
{
    if (d != NULL) {
        va_list args;
        va_start(args, fmt);
        fill(d, s, file, line, column, fmt, args);
        va_end(args);
    }
    return s;
}

char *orr_diag_format(const orr_diag *d, char *buf, size_t n)
{
    if (n == 0) return buf;
    char place[sizeof d->file + 48];
    int len = 0;
    place[0] = '\0';
    if (d->file[0] != '\0') len = snprintf(place, sizeof place, "%s:", d->file);
    if (d->line > 0) {
        len += snprintf(place + len, sizeof place - (size_t)len, "%s%lld:", len == 0 ? "line " : "",
                        (long long)d->line);
        if (d->column > 0) snprintf(place + len, sizeof place - (size_t)len, "%d:", d->column);
    }
    snprintf(buf, n, "%s%s%s", place, place[0] != '\0' ? " " : "", d->text);
    return buf;
}

void orr_warnings_add(orr_warnings *w, const char *file, int64_t line, int column, const char *fmt, ...)
{
    if (w == NULL) return;
    w->count++;
    if (w->kept >= ORR_WARNINGS_KEPT) return;
    if (w->item == NULL) { // one allocation of the known maximum; without memory the count alone is kept
        w->item = calloc(ORR_WARNINGS_KEPT, sizeof *w->item);
        if (w->item == NULL) return;
    }
    va_list args;
    va_start(args, fmt);
    fill(&w->item[w->kept++], ORR_OK, file, line, column, fmt, args);
    va_end(args);
}

void orr_warnings_free(orr_warnings *w)
{
    if (w == NULL) return;
    free(w->item);
    *w = (orr_warnings){0};
}
