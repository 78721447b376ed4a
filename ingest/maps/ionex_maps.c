// SPDX-License-Identifier: GPL-3.0-or-later
// The maps of an IONEX file: blocks of rows of I5 integers, sixteen a line.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "ingest/input/text_records.h"
#include "ingest/maps/ionex_private.h"

const char *const ionex_kind_name[IONEX_KINDS] = {"TEC", "RMS", "HEIGHT"};

// One map being read.
typedef struct open_map {
    ionex_kind kind;
    int64_t number;
    int64_t line; // where it started
    orr_time epoch;
    int exponent;
    bool own_exponent;
    size_t rows;
    double *value;
} open_map;

static orr_status next_line(ionex_reader *r, const open_map *m, orr_view *line)
{
    if (orr_cursor_next(&r->c, line)) return ORR_OK;
    orr_status s = orr_cursor_status(&r->c, r->diag);
    if (s != ORR_OK) return s;
    return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0,
                            "the file ends inside %s map %lld, which started in line %lld: it is cut short",
                            ionex_kind_name[m->kind], (long long)m->number, (long long)m->line);
}

// Room for one more map of a kind, all NAN. Memory grows with what was read, never with what a header
// promises.
static orr_status add_map(ionex_reader *r, open_map *m)
{
    ionex_maps *all = &r->maps[m->kind];
    size_t most = r->limits.max_values / r->map_size;
    if (most > r->limits.max_records) most = r->limits.max_records;
    if (all->n == all->capacity) {
        if (all->n >= most)
            return orr_cursor_error(&r->c, r->diag, ORR_E_LIMIT, 0, "more than %zu maps of this size", most);
        // Every value takes at least one byte of text: the rest of the file bounds what can still come.
        size_t next = all->capacity == 0 ? 1 : all->capacity * 2;
        size_t left = (size_t)(r->c.end - r->c.at) / r->map_size + 1;
        if (all->capacity == 0 && r->n_maps_declared > 0 && (uint64_t)r->n_maps_declared <= left)
            next = (size_t)r->n_maps_declared;
        if (next > most) next = most;
        orr_time *epoch = realloc(all->epoch, next * sizeof *epoch);
        if (epoch != NULL) all->epoch = epoch;
        int64_t *number = realloc(all->number, next * sizeof *number);
        if (number != NULL) all->number = number;
        double *value = realloc(all->value, next * r->map_size * sizeof *value);
        if (value != NULL) all->value = value;
        if (epoch == NULL || number == NULL || value == NULL)
            return orr_cursor_error(&r->c, r->diag, ORR_E_MEMORY, 0, "no memory for %zu maps", next);
        all->capacity = next;
    }
    m->value = all->value + all->n * r->map_size;
    for (size_t i = 0; i < r->map_size; i++) m->value[i] = ORR_NAN;
    return ORR_OK;
}

// Five characters as an integer. 0: good, 1: blank, 2: no number.
static int int5(const char *p, int *out)
{
    int i = 0, v = 0;
    while (i < 5 && p[i] == ' ') i++;
    if (i == 5) return 1;
    bool negative = p[i] == '-';
    if ((negative || p[i] == '+') && ++i == 5) return 2;
    for (; i < 5; i++) {
        unsigned d = (unsigned char)p[i] - (unsigned)'0';
        if (d > 9) return 2;
        v = v * 10 + (int)d;
    }
    *out = negative ? -v : v;
    return 0;
}

// The usual field: blanks, then digits. Five bytes at once; false for everything else (signs, letters, blank
// fields).
static inline bool plain5(const char *p, int *out)
{
    const uint64_t ones = UINT64_C(0x0101010101), low4 = UINT64_C(0x0f0f0f0f0f);
    // The first character in the lowest byte, whatever the machine; compilers make two loads of it.
    const unsigned char *u = (const unsigned char *)p;
    uint64_t x = (uint64_t)u[0] | (uint64_t)u[1] << 8 | (uint64_t)u[2] << 16 | (uint64_t)u[3] << 24 |
                 (uint64_t)u[4] << 32;
    uint64_t digit = (x >> 4) & ones; // '0'..'9' are 0x30..0x39, a blank is 0x20
    uint64_t mask = digit * 15;
    // Every byte is 0x3n or exactly 0x20; n is at most 9; behind a digit no blank; the last one is a digit.
    if ((x & (low4 << 4)) != (ones << 5 | digit << 4) || (x & low4 & ~mask) != 0) return false;
    uint64_t d = x & low4;
    if ((((d + ones * 6) & (ones << 4)) | (digit << 8 & ~digit & UINT64_C(0xffffffffff)) |
         (~digit & UINT64_C(1) << 32)) != 0)
        return false;
    *out = (int)((d & 15) * 10000 + (d >> 8 & 15) * 1000 + (d >> 16 & 15) * 100 + (d >> 24 & 15) * 10 +
                 (d >> 32 & 15));
    return true;
}

// As many usual fields from the start of a line as there are, into row; the rest is for the careful way.
static size_t plain_fields(const char *p, size_t n, double by, bool divide, double *row)
{
    int v[IONEX_PER_LINE];
    size_t k = 0;
    while (k < n && plain5(p + 5 * k, &v[k])) k++;
    // Division, because a tenth is no double and ten is: 173 / 10 is the double nearest 17.3.
    if (divide)
        for (size_t i = 0; i < k; i++) row[i] = v[i] / by;
    else
        for (size_t i = 0; i < k; i++) row[i] = v[i] * by;
    for (size_t i = 0; i < k; i++)
        if (v[i] == IONEX_MISSING) row[i] = ORR_NAN;
    return k;
}

static const double power[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

// Values of one line into row[done..n); returns how many, or -1 after setting the diagnostic.
static int line_values(ionex_reader *r, orr_view line, const open_map *m, double *row, size_t done, size_t n)
{
    double by = power[m->exponent < 0 ? -m->exponent : m->exponent];
    bool divide = m->exponent < 0;
    size_t most = n - done < IONEX_PER_LINE ? n - done : IONEX_PER_LINE;
    size_t plain = plain_fields(line.p, line.n / 5 < most ? line.n / 5 : most, by, divide, row);
    int got = (int)plain;
    for (size_t k = plain; k < most; k++) {
        int v = 0, bad;
        if (line.n >= 5 * k + 5) {
            bad = int5(line.p + 5 * k, &v);
        } else {
            char last[5] = "     ";
            if (line.n > 5 * k) memcpy(last, line.p + 5 * k, line.n - 5 * k);
            bad = int5(last, &v);
        }
        if (bad == 1 && orr_view_is_blank(orr_view_cols(line, (int)(5 * k) + 1, (int)(5 * IONEX_PER_LINE))))
            break;
        if (bad != 0) {
            char shown[8];
            orr_cursor_error(
                &r->c, r->diag, ORR_E_FORMAT, (int)(5 * k) + 1,
                "\"%s\" in columns %zu to %zu is no integer of a map (16 fields of 5 columns a line)",
                orr_view_copy(orr_view_cols(line, (int)(5 * k) + 1, 5), shown, sizeof shown), 5 * k + 1,
                5 * k + 5);
            return -1;
        }
        if (v == IONEX_MISSING) {
            row[k] = ORR_NAN;
        } else {
            row[k] = divide ? v / by : v * by;
            if (v < 0 && r->negatives++ == 0) r->first_negative_line = r->c.line;
        }
        got++;
    }
    return got;
}

// Where on the header's axis a value lies; -1 if between its points or outside.
static long place(const double axis[3], size_t n, double v)
{
    if (n == 1) return fabs(v - axis[0]) < 0.051 ? 0 : -1;
    double k = (v - axis[0]) / axis[2];
    if (!(k > -0.1 && k < (double)n - 0.9) || fabs(v - (axis[0] + round(k) * axis[2])) > 0.051) return -1;
    return (long)round(k);
}

// A LAT/LON1/LON2/DLON/H line and the values that follow it.
static orr_status read_row(ionex_reader *r, orr_view line, open_map *m)
{
    static const char *const name[] = {"latitude", "first longitude", "last longitude", "step of longitude",
                                       "height"};
    orr_ionex *x = r->out;
    double f[5];
    for (int i = 0; i < 5; i++) {
        orr_field got = orr_field_real(line, 3 + 6 * i, 6, &f[i]);
        if (i == 4 && got == ORR_FIELD_BLANK && x->n_heights == 1) {
            f[4] = r->axis[IONEX_AXIS_HEIGHT][0];
        } else if (got != ORR_FIELD_OK) {
            return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 3 + 6 * i,
                                    "the %s of a row is missing or malformed", name[i]);
        }
    }
    const double *lon = r->axis[IONEX_AXIS_LON];
    long i_lat = place(r->axis[IONEX_AXIS_LAT], x->n_lats, f[0]);
    long i_hgt = place(r->axis[IONEX_AXIS_HEIGHT], x->n_heights, f[4]);
    if (i_lat < 0)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 3, "latitude %.1f is not on the header's grid",
                                f[0]);
    if (i_hgt < 0)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 27,
                                "height %.1f km is not on the header's grid", f[4]);
    if (fabs(f[1] - lon[0]) > 0.051 || fabs(f[2] - lon[1]) > 0.051 ||
        (x->n_lons > 1 && fabs(f[3] - lon[2]) > 0.051))
        return orr_cursor_error(
            &r->c, r->diag, ORR_E_FORMAT, 9,
            "longitudes %.1f to %.1f by %.1f of this row differ from the header's %.1f to %.1f by %.1f", f[1],
            f[2], f[3], lon[0], lon[1], lon[2]);
    double *row = m->value + ((size_t)i_hgt * x->n_lats + (size_t)i_lat) * x->n_lons;
    for (size_t done = 0; done < x->n_lons;) {
        orr_view values;
        orr_status s = next_line(r, m, &values);
        if (s != ORR_OK) return s;
        int got = line_values(r, values, m, row + done, done, x->n_lons);
        if (got < 0) return ORR_E_FORMAT;
        if (got == 0)
            return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1,
                                    "only %zu of the %zu values of latitude %.1f", done, x->n_lons, f[0]);
        done += (size_t)got;
    }
    m->rows++;
    return ORR_OK;
}

static orr_status close_map(ionex_reader *r, open_map *m)
{
    ionex_maps *all = &r->maps[m->kind];
    size_t rows = r->out->n_lats * r->out->n_heights;
    if (m->rows != rows)
        orr_cursor_warn(&r->c, r->warnings, 0, "%s map %lld has %zu rows, the grid %zu",
                        ionex_kind_name[m->kind], (long long)m->number, m->rows, rows);
    if (m->epoch == ORR_TIME_NONE && m->kind != IONEX_TEC) { // the epoch of the TEC map of the same number
        const ionex_maps *tec = &r->maps[IONEX_TEC];
        for (size_t i = 0; i < tec->n; i++)
            if (tec->number[i] == m->number) m->epoch = tec->epoch[i];
    }
    if (m->epoch == ORR_TIME_NONE)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0, "%s map %lld has no EPOCH OF CURRENT MAP",
                                ionex_kind_name[m->kind], (long long)m->number);
    if (!m->own_exponent && r->last_own_exponent_map > 0)
        orr_cursor_warn(
            &r->c, r->warnings, 0,
            "%s map %lld has no EXPONENT of its own although an earlier map has: the header's %d is taken",
            ionex_kind_name[m->kind], (long long)m->number, r->out->exponent);
    if (m->own_exponent && m->exponent != r->out->exponent) r->last_own_exponent_map++;
    all->epoch[all->n] = m->epoch;
    all->number[all->n] = m->number;
    all->n++;
    return ORR_OK;
}

// A line that belongs to nothing is told and passed over; more of them than a map has rows, and this is no file of maps.
static orr_status stray_line(ionex_reader *r, const char *what)
{
    if (r->stray++ >= r->out->n_lats * r->out->n_heights)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1, "%s, and %zu such lines before it", what,
                                r->stray - 1);
    orr_cursor_warn(&r->c, r->warnings, 1, "%s; it is passed over", what);
    return ORR_OK;
}

static orr_status read_map(ionex_reader *r, orr_view first, ionex_kind kind)
{
    open_map m = {.kind = kind, .line = r->c.line, .epoch = ORR_TIME_NONE, .exponent = r->out->exponent};
    if (orr_field_int(first, 1, 6, &m.number) != ORR_FIELD_OK) {
        m.number = (int64_t)r->maps[kind].n + 1;
        orr_cursor_warn(&r->c, r->warnings, 1, "a map without a number; taken as %lld", (long long)m.number);
    }
    char end_label[24], start_label[24];
    snprintf(end_label, sizeof end_label, "END OF %s MAP", ionex_kind_name[kind]);
    snprintf(start_label, sizeof start_label, "START OF");
    orr_status s = add_map(r, &m);
    while (s == ORR_OK) {
        orr_view line;
        s = next_line(r, &m, &line);
        if (s != ORR_OK) break;
        orr_view label = orr_records_label(line);
        if (orr_records_label_is(label, "LAT/LON1/LON2/DLON/H")) {
            s = read_row(r, line, &m);
        } else if (orr_records_label_is(label, end_label)) {
            return close_map(r, &m);
        } else if (orr_records_label_is(label, "EPOCH OF CURRENT MAP")) {
            if (!orr_records_civil_columns(line, 1, 6, ORR_SCALE_UTC, r->limits.leap, &m.epoch))
                s = orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1, "the epoch of a map is no date");
        } else if (orr_records_label_is(label, "EXPONENT")) {
            m.own_exponent = true;
            if (orr_field_int_in(line, 1, 6, -9, 9, &m.exponent) != ORR_FIELD_OK)
                s = orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1, "EXPONENT is no number from -9 to 9");
        } else if (orr_view_starts(label, start_label) || orr_view_starts(label, "END OF")) {
            s = orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 61,
                                 "%s map %lld, started in line %lld, is not ended before this",
                                 ionex_kind_name[kind], (long long)m.number, (long long)m.line);
        } else if (!orr_records_label_is(label, "COMMENT") && !orr_view_is_blank(line)) {
            s = stray_line(r, "a line that is neither a label of a map nor a value of a row");
        }
    }
    return s;
}

orr_status ionex_read_maps(ionex_reader *r)
{
    orr_view line;
    while (orr_cursor_next(&r->c, &line)) {
        orr_view label = orr_records_label(line);
        orr_status s = ORR_OK;
        if (orr_view_is_blank(line) || orr_records_label_is(label, "COMMENT")) {
            continue;
        } else if (r->end_of_file_seen) {
            orr_cursor_warn(&r->c, r->warnings, 1, "lines after END OF FILE are not read");
            return ORR_OK;
        } else if (orr_records_label_is(label, "START OF TEC MAP")) {
            s = read_map(r, line, IONEX_TEC);
        } else if (orr_records_label_is(label, "START OF RMS MAP")) {
            s = read_map(r, line, IONEX_RMS);
        } else if (orr_records_label_is(label, "START OF HEIGHT MAP")) {
            s = read_map(r, line, IONEX_HGT);
        } else if (orr_records_label_is(label, "END OF FILE")) {
            r->end_of_file_seen = true;
        } else {
            s = stray_line(r, "a line outside the maps");
        }
        if (s != ORR_OK) return s;
    }
    return orr_cursor_status(&r->c, r->diag);
}
