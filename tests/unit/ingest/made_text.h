// SPDX-License-Identifier: GPL-3.0-or-later
// Files made line by line inside a test.
#ifndef ORR_TESTS_MADE_TEXT_H
#define ORR_TESTS_MADE_TEXT_H

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct made_text {
    char *s;
    size_t n, capacity;
} made_text;

static inline void made_bytes(made_text *t, const char *p, size_t n)
{
    if (n > (size_t)1 << 30) abort(); // nobody makes that; the optimiser is told so
    if (t->n + n + 1 > t->capacity) {
        t->capacity = 2 * (t->n + n + 1);
        char *s = realloc(t->s, t->capacity);
        if (s == NULL) abort();
        t->s = s;
    }
    memcpy(t->s + t->n, p, n);
    t->n += n;
    t->s[t->n] = '\0';
}

// Text as it stands, no newline added.
static inline void made_add(made_text *t, const char *format, ...) __attribute__((format(printf, 2, 3)));
static inline void made_add(made_text *t, const char *format, ...)
{
    char line[4096];
    va_list a;
    va_start(a, format);
    int n = vsnprintf(line, sizeof line, format, a);
    va_end(a);
    if (n < 0 || (size_t)n >= sizeof line) abort();
    made_bytes(t, line, (size_t)n);
}

// A line with its label in columns 61-80.
static inline void made_label(made_text *t, const char *text, const char *label)
{
    made_add(t, "%-60s%-20s\n", text, label);
}

// Replaces the first `from` by `to` (any length); aborts where there is none, so that a test cannot pass by
// accident.
static inline void made_replace(made_text *t, const char *from, const char *to)
{
    char *at = t->s != NULL ? strstr(t->s, from) : NULL;
    if (at == NULL) abort();
    size_t head = (size_t)(at - t->s), tail = t->n - head - strlen(from);
    made_text r = {0};
    made_bytes(&r, t->s, head);
    made_bytes(&r, to, strlen(to));
    made_bytes(&r, at + strlen(from), tail);
    free(t->s);
    *t = r;
}

static inline void made_free(made_text *t)
{
    free(t->s);
    *t = (made_text){0};
}

#endif
