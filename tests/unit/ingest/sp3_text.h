// SPDX-License-Identifier: GPL-3.0-or-later
// Makes SP3 text for tests: a sound file of any version from a few settings, to be spoilt by the tests line
// by line.
#ifndef ORR_TESTS_SP3_TEXT_H
#define ORR_TESTS_SP3_TEXT_H

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct sp3_text {
    char *text;
    size_t n, capacity;
} sp3_text;

static inline void sp3_append(sp3_text *t, const char *text, size_t n)
{
    if (t->n + n + 1 > t->capacity) {
        t->capacity = 2 * t->capacity + n + 4096;
        t->text = realloc(t->text, t->capacity);
        if (t->text == NULL) abort();
    }
    memcpy(t->text + t->n, text, n);
    t->n += n;
    t->text[t->n] = '\0';
}

static inline void sp3_add(sp3_text *t, const char *fmt, ...)
{
    char line[1024];
    va_list ap;
    va_start(ap, fmt);
    int n = vsnprintf(line, sizeof line, fmt, ap);
    va_end(ap);
    if (n < 0 || (size_t)n >= sizeof line) abort();
    sp3_append(t, line, (size_t)n);
}

// Header: `mode` is "#cP" and so on, `scale` the three letters of %c, satellites "G01G02" without blanks
// between.
static inline void sp3_add_header(sp3_text *t, const char *mode, const char *scale, int epochs,
                                  const char *sats)
{
    int n = (int)strlen(sats) / 3, lines = (n + 16) / 17 < 5 ? 5 : (n + 16) / 17;
    sp3_add(t, "%s2024  2  4  0  0  0.00000000 %7d d+D   TEST  FIT TEST\n", mode, epochs);
    sp3_add(t, "## 2300      0.00000000   900.00000000 60344 0.0000000000000\n");
    for (int l = 0, s = 0; l < lines; l++) {
        if (l == 0)
            sp3_add(t, "+  %3d   ", n);
        else
            sp3_add(t, "+        ");
        for (int i = 0; i < 17; i++, s++) {
            if (s < n)
                sp3_add(t, "%.3s", sats + 3 * s);
            else
                sp3_add(t, "  0");
        }
        sp3_add(t, "\n");
    }
    for (int l = 0, s = 0; l < lines; l++) {
        sp3_add(t, "++       ");
        for (int i = 0; i < 17; i++, s++) sp3_add(t, "%3d", s < n ? 1 + s % 9 : 0);
        sp3_add(t, "\n");
    }
    sp3_add(t, "%%c M  cc %s ccc cccc cccc cccc cccc ccccc ccccc ccccc ccccc\n", scale);
    sp3_add(t, "%%c cc cc ccc ccc cccc cccc cccc cccc ccccc ccccc ccccc ccccc\n");
    sp3_add(t, "%%f  1.2500000  1.025000000  0.00000000000  0.000000000000000\n");
    sp3_add(t, "%%f  0.0000000  0.000000000  0.00000000000  0.000000000000000\n");
    for (int i = 0; i < 2; i++) sp3_add(t, "%%i    0    0    0    0      0      0      0      0         0\n");
    for (int i = 0; i < 4; i++) sp3_add(t, "/* COMMENT %d\n", i);
}

static inline void sp3_add_epoch_line(sp3_text *t, int hour, int minute, double second)
{
    sp3_add(t, "*  2024  2  4 %2d %2d %11.8f\n", hour, minute, second);
}

#endif
