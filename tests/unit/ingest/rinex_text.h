// SPDX-License-Identifier: GPL-3.0-or-later
// RINEX text made line by line, for the tests of the readers.
#ifndef ORR_TESTS_RINEX_TEXT_H
#define ORR_TESTS_RINEX_TEXT_H

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TEXT_BLANK 1e300 // a field left blank

typedef struct text {
    char *p;
    size_t n, capacity;
} text;

static inline void text_add(text *t, const char *fmt, ...)
{
    char line[2048];
    va_list ap;
    va_start(ap, fmt);
    int len = vsnprintf(line, sizeof line, fmt, ap);
    va_end(ap);
    size_t n = len > 0 ? (size_t)len : 0;
    if (t->n + n + 1 > t->capacity) t->p = realloc(t->p, t->capacity = 2 * (t->n + n) + 1024);
    memcpy(t->p + t->n, line, n + 1);
    t->n += n;
}

static inline void text_header(text *t, const char *what, const char *label)
{
    text_add(t, "%-60s%s\n", what, label);
}

// D19.12 fields with the given exponent letter, `indent` blanks before them; TEXT_BLANK leaves a field blank.
static inline void text_fields(text *t, int indent, char letter, int n, const double *v)
{
    text_add(t, "%*s", indent, "");
    for (int i = 0; i < n; i++) {
        char field[32];
        snprintf(field, sizeof field, "%19.12E", v[i]);
        for (char *c = field; *c != '\0'; c++)
            if (*c == 'E') *c = letter;
        if (v[i] == TEXT_BLANK)
            text_add(t, "%19s", "");
        else
            text_add(t, "%s", field);
    }
    text_add(t, "\n");
}

static inline void text_free(text *t)
{
    free(t->p);
    *t = (text){0};
}

#endif
