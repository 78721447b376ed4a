// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/input/text_records.h"
#include "core/array.h"
#include "core/nan.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

orr_read_limits orr_read_default_limits(void)
{
    return (orr_read_limits){
        .max_bytes = (size_t)2 << 30, .max_records = 20 * 1000 * 1000, .max_values = 100 * 1000 * 1000};
}

orr_status orr_records_grow(void *array, size_t n, size_t element_size, size_t limit, const char *what,
                            const orr_cursor *at, orr_diag *diag)
{
    if (n >= limit)
        return orr_cursor_error(at, diag, ORR_E_LIMIT, 0,
                                "more than %zu %s, which is the limit of this reader", limit, what);
    if (!orr_array_grow(array, n, element_size))
        return orr_cursor_error(at, diag, ORR_E_MEMORY, 0, "no memory for more than %zu %s", n, what);
    return ORR_OK;
}

void orr_records_leave_out(orr_records_tally *tally, const orr_cursor *at, int column, const char *why,
                           orr_warnings *warnings)
{
    if (tally->left_out++ == 0) orr_cursor_error(at, &tally->first, ORR_E_FORMAT, column, "%s", why);
    orr_cursor_warn(at, warnings, column, "%s; the line is left out", why);
}

orr_status orr_records_verdict(const orr_records_tally *tally, orr_diag *diag)
{
    if (tally->left_out <= tally->good) return ORR_OK;
    const orr_diag *d = &tally->first;
    return orr_diag_at(diag, ORR_E_FORMAT, d->file, d->line, d->column, "%s; of %zu lines %zu cannot be read",
                       d->text, tally->good + tally->left_out, tally->left_out);
}

orr_status orr_records_load(const char *path, const orr_read_limits *limits, uint64_t kinds, orr_bytes *out,
                            orr_diag *diag)
{
    orr_input_limits in = orr_input_default_limits();
    in.max_bytes = limits != NULL ? limits->max_bytes : orr_read_default_limits().max_bytes;
    in.kinds = kinds;
    return orr_input_read_all(path, &in, out, diag);
}

orr_view orr_records_label(orr_view line) { return orr_view_trim(orr_view_cols(line, 61, 20)); }

bool orr_records_label_is(orr_view label, const char *name)
{
    size_t i = 0;
    while (*name != '\0') {
        if (i >= label.n) return false;
        char c = label.p[i] == '_' || label.p[i] == '\t' ? ' ' : label.p[i];
        if (toupper((unsigned char)c) != toupper((unsigned char)*name)) return false;
        i++;
        if (c == ' ')
            while (i < label.n && (label.p[i] == ' ' || label.p[i] == '\t')) i++;
        name++;
    }
    return i == label.n;
}

static bool digits(orr_view v, int lo, int hi, int *out)
{
    int x = 0;
    if (v.n == 0 || v.n > 9) return false;
    for (size_t i = 0; i < v.n; i++) {
        if (v.p[i] < '0' || v.p[i] > '9') return false;
        x = x * 10 + (v.p[i] - '0');
    }
    if (x < lo || x > hi) return false;
    *out = x;
    return true;
}

bool orr_records_sinex_time(orr_view v, orr_scale scale, const orr_leap_table *leap, orr_time *out)
{
    v = orr_view_trim(v);
    *out = ORR_TIME_NONE;
    if (v.n == 0) return true;
    orr_view rest = v, part[3];
    for (int i = 0; i < 3; i++)
        if (!orr_view_split(&rest, ':', &part[i])) return false;
    if (rest.p != NULL && rest.n > 0) return false;
    int year, doy, sod;
    for (int i = 0; i < 3; i++) part[i] = orr_view_trim(part[i]);
    if (!digits(part[0], 0, 9999, &year) || !digits(part[1], 0, 366, &doy) ||
        !digits(part[2], 0, 86400, &sod))
        return false;
    if (year == 0 && doy == 0 && sod == 0) return true;
    if (part[0].n <= 2) year += year <= 50 ? 2000 : 1900;
    if (doy == 0 || doy > (orr_is_leap_year(year) ? 366 : 365) || year < ORR_TIME_FIRST_YEAR ||
        year > ORR_TIME_LAST_YEAR)
        return false;
    int32_t mjd = orr_mjd_from_date(year, 1, 1) + doy - 1;
    orr_civil c = {.hour = sod / 3600, .minute = sod / 60 % 60, .second = sod % 60};
    orr_date_from_mjd(mjd, &c.year, &c.month, &c.day);
    return orr_time_from_civil(&c, scale, leap, out) == ORR_OK;
}

static bool civil_from(const double f[6], orr_scale scale, const orr_leap_table *leap, orr_time *out)
{
    for (int i = 0; i < 5; i++)
        if (!(f[i] >= 0 && f[i] <= 9999 && f[i] == floor(f[i]))) return false;
    if (!(f[5] >= 0 && f[5] < 62)) return false;
    double whole = floor(f[5]);
    double ns = round((f[5] - whole) * 1e9);
    if (ns >= 1e9) ns = 999999999; // 59.9999999999 must not become a 60th second
    orr_civil c = {(int)f[0], (int)f[1], (int)f[2], (int)f[3], (int)f[4], (int)whole, (int32_t)ns};
    return orr_time_from_civil(&c, scale, leap, out) == ORR_OK;
}

bool orr_records_civil(orr_view v, orr_scale scale, const orr_leap_table *leap, orr_time *out)
{
    double f[6];
    orr_view word;
    for (int i = 0; i < 6; i++)
        if (!orr_view_word(&v, &word) || orr_view_real(word, &f[i]) != ORR_FIELD_OK) return false;
    return civil_from(f, scale, leap, out);
}

bool orr_records_civil_columns(orr_view line, int col, int width, orr_scale scale, const orr_leap_table *leap,
                               orr_time *out)
{
    double f[6];
    for (int i = 0; i < 6; i++)
        if (orr_field_real(line, col + i * width, width, &f[i]) != ORR_FIELD_OK) return false;
    return civil_from(f, scale, leap, out);
}

orr_status orr_records_add_text(char ***list, size_t *n, orr_view v, size_t limit, const orr_cursor *at,
                                orr_diag *diag)
{
    orr_status s = orr_records_grow(list, *n, sizeof **list, limit, "lines of comment", at, diag);
    if (s != ORR_OK) return s;
    char *copy = orr_view_dup(orr_view_rtrim(v));
    if (copy == NULL) return orr_cursor_error(at, diag, ORR_E_MEMORY, 0, "no memory for a line of comment");
    (*list)[(*n)++] = copy;
    return ORR_OK;
}

void orr_records_free_texts(char **list, size_t n)
{
    for (size_t i = 0; list != NULL && i < n; i++) free(list[i]);
    free(list);
}

static int by_step(const void *a, const void *b)
{
    int64_t x = *(const int64_t *)a, y = *(const int64_t *)b;
    return (x > y) - (x < y);
}

double orr_records_usual_step_s(const orr_time *t, size_t n, int64_t *scratch)
{
    if (n < 2) return ORR_NAN;
    for (size_t i = 1; i < n; i++) scratch[i - 1] = t[i] - t[i - 1];
    qsort(scratch, n - 1, sizeof *scratch, by_step);
    size_t best = 0, most = 0;
    for (size_t i = 0, run; i < n - 1; i += run) {
        for (run = 1; i + run < n - 1 && scratch[i + run] == scratch[i];) run++;
        if (run > most) {
            most = run;
            best = i;
        }
    }
    return (double)scratch[best] / (double)ORR_NS_PER_S;
}

void orr_records_program_line(orr_view line, char program[21], char run_by[21], char date[21])
{
    orr_view_copy(orr_view_trim(orr_view_cols(line, 1, 20)), program, 21);
    orr_view_copy(orr_view_trim(orr_view_cols(line, 21, 20)), run_by, 21);
    orr_view_copy(orr_view_trim(orr_view_cols(line, 41, 20)), date, 21);
}
