// SPDX-License-Identifier: GPL-3.0-or-later
// The text cursor and its fields: lines cover the block, numbers are what the C library reads.
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "core/cursor.h"
#include "ingest/input/sniff.h"

static void check_real(orr_view v)
{
    double x = 7;
    orr_field f = orr_view_real(v, &x);
    if (f != ORR_FIELD_OK) {
        if (x != 7) abort();
        return;
    }
    // What was taken must be a number for strtod too, once its exponent has a letter and a sign that C knows.
    char text[320];
    size_t n = 0;
    v = orr_view_trim(v);
    for (size_t i = 0; i < v.n; i++) {
        char c = v.p[i];
        bool sign = i > 0 && strchr("DdEe", v.p[i - 1]) != NULL;
        // Fortran leaves the letter out where the exponent has three digits.
        if ((c == '-' || c == '+') && i > 0 && strchr("0123456789.", v.p[i - 1]) != NULL) text[n++] = 'e';
        text[n++] = c == 'D' || c == 'd' ? 'e' : c == ' ' && sign ? '+' : c;
    }
    text[n] = '\0';
    char *end;
    if (strtod(text, &end) != x || *end != '\0') abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    const char *text = (const char *)data;
    (void)orr_sniff((orr_view){text, n});
    orr_cursor c;
    orr_view line, part;
    size_t seen = 0;
    orr_cursor_init(&c, "fuzz", text, n);
    while (orr_cursor_next(&c, &line)) {
        if (line.p != text + seen) abort();
        seen = (size_t)(c.at - text);
        check_real(line);
        for (int col = 1; col < 90; col += 7) check_real(orr_view_cols(line, col, 14));
        int64_t i = 0;
        (void)orr_field_int(line, 3, 9, &i);
        orr_view rest = line;
        while (orr_view_word(&rest, &part)) check_real(part);
        rest = line;
        size_t fields = 0;
        while (orr_view_split(&rest, ',', &part)) fields += part.n + 1;
        if (fields != line.n + 1) abort();
        char copy[40];
        if (strlen(orr_view_copy(line, copy, sizeof copy)) > 39) abort();
    }
    if (!c.too_long && seen != n) abort();
    return 0;
}
