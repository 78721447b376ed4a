// SPDX-License-Identifier: GPL-3.0-or-later
// What inspect tells of a table of numbers, such as a flight log: its shape. What the columns mean is said to
// the command that reads it (`orrery track --help`).
#include <ctype.h>
#include <string.h>

#include "ingest/input/input.h"
#include "ingest/inspect/inspect.h"

#define MOST_COLUMNS 64 // shapes beyond are told as "more"

// Fields of a line: runs between commas, semicolons and blanks; a separator other than a blank also bounds an
// empty field.
static size_t count_fields(orr_view line)
{
    size_t n = 0;
    bool inside = false, expecting = false;
    for (size_t i = 0; i < line.n; i++) {
        char c = line.p[i];
        bool blank = c == ' ' || c == '\t' || c == '\r', mark = c == ',' || c == ';';
        if (mark) {
            n += !inside && (expecting || n == 0);
            expecting = true;
            inside = false;
        } else if (blank) {
            inside = false;
        } else if (!inside) {
            inside = true;
            expecting = false;
            n++;
        }
    }
    return n;
}

static bool starts_with_number(orr_view line)
{
    size_t i = 0;
    while (i < line.n && (line.p[i] == ' ' || line.p[i] == '\t')) i++;
    if (i < line.n && (line.p[i] == '-' || line.p[i] == '+')) i++;
    return i < line.n && isdigit((unsigned char)line.p[i]);
}

orr_status orr_inspect_table(const char *path, orr_inspection *r, orr_diag *diag)
{
    orr_input *in = NULL;
    orr_status s = r->raw != NULL ? orr_input_open_bytes(path, r->raw->text, r->raw->n, NULL, &in, diag)
                                  : orr_input_open(path, NULL, &in, diag);
    if (s != ORR_OK) return s;
    int64_t rows = 0, words = 0, of_width[MOST_COLUMNS + 1] = {0};
    orr_view line;
    while (orr_input_line(in, &line)) {
        size_t n = count_fields(line);
        if (n == 0) continue;
        if (!starts_with_number(line)) {
            words++;
            continue;
        }
        rows++;
        of_width[n < MOST_COLUMNS ? n : MOST_COLUMNS]++;
    }
    s = orr_input_status(in, diag);
    orr_input_close(in);
    if (s != ORR_OK) return s;
    size_t usual = 0;
    for (size_t k = 1; k <= MOST_COLUMNS; k++)
        if (of_width[k] > of_width[usual]) usual = k;
    r->records = rows;
    orr_inspect_fact_add(r, "columns", "%zu%s", usual, usual == MOST_COLUMNS ? " or more" : "");
    if (words > 0) orr_inspect_fact_add(r, "other lines", "%lld, headings or remarks", (long long)words);
    if (rows > of_width[usual])
        orr_warnings_add(&r->warnings, path, 0, 0,
                         "%lld of %lld rows have another number of columns than %zu",
                         (long long)(rows - of_width[usual]), (long long)rows, usual);
    return ORR_OK;
}
