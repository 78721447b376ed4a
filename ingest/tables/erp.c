// SPDX-License-Identifier: GPL-3.0-or-later
// Earth rotation files, version 2 (IGSMAIL-1943, 1998): pole in 1e-6 arcsec, UT and LOD in 1e-7 s. The order
// of the columns is the file's own; the line that starts with MJD names them.
#include "ingest/tables/erp.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "core/vec.h"
#include "ingest/tables/erp_private.h"

#define RAD_PER_UAS (1e-6 / 3600.0 * ORR_RAD_PER_DEG)
#define S_PER_UNIT 1e-7

typedef enum erp_column {
    C_OTHER,
    C_MJD,
    C_X,
    C_Y,
    C_UT1_UTC,
    C_UT1_TAI,
    C_LOD,
    C_SX,
    C_SY,
    C_SUT,
    C_SLOD,
    C_NR,
    C_NF,
    C_NT,
    C_XRT,
    C_YRT,
    C_SXR,
    C_SYR,
    C_DPSI,
    C_DEPS,
    C_UT1R,
    C_LODR,
    C_KINDS
} erp_column;

// The centres' words, without case and punctuation.
static const struct {
    const char *word;
    erp_column column;
} words[] = {
    {"MJD", C_MJD},       {"XPOLE", C_X},        {"XP", C_X},          {"X", C_X},
    {"YPOLE", C_Y},       {"YP", C_Y},           {"Y", C_Y},           {"UT1UTC", C_UT1_UTC},
    {"UTUTC", C_UT1_UTC}, {"UT1TAI", C_UT1_TAI}, {"UTTAI", C_UT1_TAI}, {"LOD", C_LOD},
    {"XSIG", C_SX},       {"SX", C_SX},          {"YSIG", C_SY},       {"SY", C_SY},
    {"UTSIG", C_SUT},     {"UT1SIG", C_SUT},     {"SUT", C_SUT},       {"LODSIG", C_SLOD},
    {"SLD", C_SLOD},      {"SLOD", C_SLOD},      {"NR", C_NR},         {"NF", C_NF},
    {"NT", C_NT},         {"XRT", C_XRT},        {"YRT", C_YRT},       {"XRTSIG", C_SXR},
    {"SXR", C_SXR},       {"SXRT", C_SXR},       {"YRTSIG", C_SYR},    {"SYR", C_SYR},
    {"SYRT", C_SYR},      {"DPSI", C_DPSI},      {"DEPS", C_DEPS},     {"UT1RUTC", C_UT1R},
    {"UT1RTAI", C_UT1R},  {"LODR", C_LODR},
};

void orr_erp_series_free(orr_eop_series *s)
{
    if (s == NULL) return;
    free(s->mjd_utc);
    free(s->value);
    *s = (orr_eop_series){0};
}

void orr_erp_free(orr_erp *x)
{
    if (x == NULL) return;
    orr_erp_series_free(&x->series);
    free(x->detail);
    *x = (orr_erp){0};
}

static erp_column column_of(orr_view word)
{
    char plain[16];
    size_t n = 0;
    for (size_t i = 0; i < word.n; i++) {
        if (!isalnum((unsigned char)word.p[i])) continue;
        if (n + 1 == sizeof plain) return C_OTHER;
        plain[n++] = (char)toupper((unsigned char)word.p[i]);
    }
    plain[n] = '\0';
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        if (strcmp(plain, words[i].word) == 0) return words[i].column;
    return C_OTHER;
}

// The line that names the columns. "UT1 -TAI" and "UT1- UTC" are one name.
static orr_status read_columns(erp_reader *r, orr_view line)
{
    orr_view rest = line, word, last = {0};
    bool seen[C_KINDS] = {false};
    r->n_columns = 0;
    while (orr_view_word(&rest, &word)) {
        bool joined = r->n_columns > 0 && (word.p[0] == '-' || last.p[last.n - 1] == '-');
        if (joined) { // a view from the start of the name to its end
            word.n = (size_t)(word.p + word.n - last.p);
            word.p = last.p;
            r->n_columns--;
        } else if (r->n_columns == ERP_MAX_COLUMNS) {
            return orr_cursor_error(&r->c, r->diag, ORR_E_LIMIT, 0, "more than %d columns", ERP_MAX_COLUMNS);
        }
        r->column[r->n_columns++] = (int)column_of(word);
        last = word;
    }
    for (size_t i = 0; i < r->n_columns; i++) {
        int k = r->column[i];
        if (k == C_UT1R || k == C_LODR)
            return orr_cursor_error(&r->c, r->diag, ORR_E_UNSUPPORTED, 1,
                                    "%s: zonal tides are taken out of this file, which is not offered",
                                    k == C_UT1R ? "UT1R" : "LODR");
        if (k != C_OTHER && seen[k])
            return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1,
                                    "column %zu has the name of an earlier one", i + 1);
        seen[k] = true;
    }
    if (!seen[C_MJD] || !seen[C_X] || !seen[C_Y] || !(seen[C_UT1_UTC] || seen[C_UT1_TAI]))
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1,
                                "the column line does not name MJD, both coordinates of the pole and UT1");
    return ORR_OK;
}

// Version 2 fixes the units; a units line that says otherwise ("E-5\"", "10**-5") is a contradiction.
static orr_status check_units(erp_reader *r, orr_view line)
{
    for (size_t i = 0; i + 2 < line.n; i++) {
        bool power = (toupper((unsigned char)line.p[i]) == 'E' || line.p[i] == '*') && line.p[i + 1] == '-' &&
                     isdigit((unsigned char)line.p[i + 2]);
        if (!power) continue;
        if (line.p[i + 2] == '6') return ORR_OK;
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, (int)i + 1,
                                "the units line says 1e-%c; version 2 has the pole in 1e-6 arc seconds",
                                line.p[i + 2]);
    }
    return ORR_OK;
}

static double numeric(const double *v, const bool *has, erp_column k, double factor)
{
    return has[k] ? v[k] * factor : ORR_NAN;
}

static int count(const double *v, const bool *has, erp_column k)
{
    return has[k] && v[k] >= 0 && v[k] < 1e6 ? (int)v[k] : -1;
}

static orr_status read_row(erp_reader *r, orr_view line)
{
    double v[C_KINDS] = {0};
    bool has[C_KINDS] = {false};
    size_t n = 0;
    orr_view rest = line, word;
    if (r->n_columns == 0)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1,
                                "numbers before a line that names the columns (MJD ...)");
    for (; n < r->n_columns && orr_view_word(&rest, &word); n++) {
        int k = r->column[n];
        int column = (int)(word.p - line.p) + 1;
        double x;
        if (k == C_OTHER) continue;
        if (orr_view_real(word, &x) != ORR_FIELD_OK)
            return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, column, "column %zu is no number", n + 1);
        v[k] = x;
        has[k] = true;
    }
    bool more = orr_view_word(&rest, &word);
    if (r->c.unterminated && n < r->n_columns) // its last number may be half of one
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0,
                                "the file ends inside a line: it is cut short");
    if (!has[C_MJD] || !has[C_X] || !has[C_Y] || !(has[C_UT1_UTC] || has[C_UT1_TAI]))
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1, "the line ends before the pole and UT1");
    if ((more || n < r->n_columns) && !r->other_count_said) {
        r->other_count_said = true;
        orr_cursor_warn(&r->c, r->warnings, 1, "the header names %zu columns, this line has %s", r->n_columns,
                        more ? "more" : "fewer");
    }
    erp_row e = {.mjd = v[C_MJD]};
    e.eop.xp_rad = v[C_X] * RAD_PER_UAS;
    e.eop.yp_rad = v[C_Y] * RAD_PER_UAS;
    e.eop.lod_s = has[C_LOD] ? v[C_LOD] * S_PER_UNIT : 0.0;
    if (has[C_UT1_UTC]) {
        e.eop.ut1_utc_s = v[C_UT1_UTC] * S_PER_UNIT;
    } else if (!(e.mjd > ERP_FIRST_MJD && e.mjd < ERP_LAST_MJD)) {
        return erp_bad_date(r, e.mjd);
    } else {
        double day = floor(e.mjd);
        orr_time t = orr_time_from_mjd((int32_t)day, e.mjd - day, ORR_SCALE_UTC, r->leap);
        e.eop.ut1_utc_s = v[C_UT1_TAI] * S_PER_UNIT + orr_leap_tai_minus_utc(t, r->leap);
    }
    const double per_day = RAD_PER_UAS / ORR_S_PER_DAY;
    e.detail = (orr_erp_detail){.xp_sdev_rad = numeric(v, has, C_SX, RAD_PER_UAS),
                                .yp_sdev_rad = numeric(v, has, C_SY, RAD_PER_UAS),
                                .ut1_sdev_s = numeric(v, has, C_SUT, S_PER_UNIT),
                                .lod_sdev_s = numeric(v, has, C_SLOD, S_PER_UNIT),
                                .xp_rate_radps = numeric(v, has, C_XRT, per_day),
                                .yp_rate_radps = numeric(v, has, C_YRT, per_day),
                                .xp_rate_sdev_radps = numeric(v, has, C_SXR, per_day),
                                .yp_rate_sdev_radps = numeric(v, has, C_SYR, per_day),
                                .dpsi_rad = numeric(v, has, C_DPSI, RAD_PER_UAS),
                                .deps_rad = numeric(v, has, C_DEPS, RAD_PER_UAS),
                                .n_receivers = count(v, has, C_NR),
                                .n_fixed = count(v, has, C_NF),
                                .n_satellites = count(v, has, C_NT)};
    return erp_add_row(r, &e);
}

static bool is_version_line(orr_view line, int *version)
{
    orr_view rest = line, word;
    int64_t k;
    if (!orr_view_word(&rest, &word) || word.n != 7) return false;
    for (size_t i = 0; i < 7; i++)
        if (toupper((unsigned char)word.p[i]) != "VERSION"[i]) return false;
    if (!orr_view_word(&rest, &word) || orr_view_int(word, &k) != ORR_FIELD_OK || k < 0 || k > 99)
        return false;
    *version = (int)k;
    return true;
}

// A line that cannot be read is told and left out; one that the file's end cuts is the sign of a cut file.
static orr_status take_row(erp_reader *r, orr_view line)
{
    orr_diag *const diag = r->diag;
    orr_diag why = {0};
    r->diag = &why;
    orr_status s = read_row(r, line);
    r->diag = diag;
    r->tally.good += s == ORR_OK;
    if (s == ORR_E_FORMAT && !r->c.unterminated) {
        orr_records_leave_out(&r->tally, &r->c, why.column, why.text, r->warnings);
        return ORR_OK;
    }
    if (s != ORR_OK && diag != NULL) *diag = why;
    return s;
}

#define MOST_TEXT_LINES 60

static orr_status read_lines(erp_reader *r)
{
    orr_view line;
    bool after_columns = false, text = false;
    while (orr_cursor_next(&r->c, &line)) {
        orr_view rest = line, word;
        orr_status s = ORR_OK;
        int version;
        double number;
        if (!orr_view_word(&rest, &word)) continue;
        if (r->out->version == 0 || is_version_line(line, &version)) {
            // Files of several days are often one behind the other, each with its header.
            if (!is_version_line(line, &version)) {
                erp_iers_kind kind = erp_iers_line(line);
                if (kind != ERP_NOT_IERS) return erp_read_iers(r, line, kind);
                text = true; // the IERS' C04 has a page of text before its values
                if (r->c.line < MOST_TEXT_LINES) continue;
                break;
            }
            if (version != 2)
                return orr_cursor_error(&r->c, r->diag, ORR_E_UNSUPPORTED, 1,
                                        "version %d of Earth rotation files is not known (2 is)", version);
            r->out->version = version;
            r->n_columns = 0;
        } else if (column_of(word) == C_MJD) {
            s = read_columns(r, line);
            after_columns = true;
            if (s != ORR_OK) return s;
            continue;
        } else if (orr_view_real(word, &number) == ORR_FIELD_OK && r->n_columns > 0) {
            s = take_row(r, line);
        } else if (after_columns) {
            s = check_units(r, line);
        } else if (r->n_columns > 0 && isdigit((unsigned char)word.p[0])) {
            orr_records_leave_out(&r->tally, &r->c, 1, "a line that does not start with a date (MJD)",
                                  r->warnings);
        } else if (r->n_columns > 0) {
            orr_cursor_warn(&r->c, r->warnings, 1, "a line of text among the values is passed over");
        } else if (r->out->title[0] == '\0') {
            orr_view_copy(orr_view_trim(line), r->out->title, sizeof r->out->title);
        }
        after_columns = false;
        if (s != ORR_OK) return s;
    }
    orr_status s = orr_cursor_status(&r->c, r->diag);
    if (s != ORR_OK) return s;
    if (r->out->version == 0)
        return orr_cursor_error(
            &r->c, r->diag, ORR_E_KIND, 0, "%s",
            text ? "not an Earth rotation file: neither \"version 2\" of the IGS nor values of the "
                   "IERS (finals, C04) in its first lines"
                 : "the file is empty");
    s = orr_records_verdict(&r->tally, r->diag);
    if (s != ORR_OK) return s;
    if (r->n == 0)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0, "the file has no line of Earth rotation");
    return ORR_OK;
}

static int by_date(const void *a, const void *b)
{
    const erp_row *x = a, *y = b;
    if (x->mjd != y->mjd) return x->mjd < y->mjd ? -1 : 1;
    return (x->order > y->order) - (x->order < y->order);
}

// Labels and UT1 - UTC by a run's table of leap seconds, as they are by the built-in one. UT1 itself stays.
static void by_builtin(const orr_leap_table *leap, orr_eop_series *s)
{
    for (size_t i = 0; leap != NULL && i < s->n; i++) {
        int32_t day = (int32_t)floor(s->mjd_utc[i]);
        double fraction;
        const orr_time t = orr_time_from_mjd(day, s->mjd_utc[i] - day, ORR_SCALE_UTC, leap);
        const int ahead_s = orr_leap_tai_minus_utc(t, NULL) - orr_leap_tai_minus_utc(t, leap);
        if (ahead_s == 0) continue; // the label keeps its very digits
        orr_time_mjd(t, ORR_SCALE_UTC, NULL, &day, &fraction);
        s->mjd_utc[i] = day + fraction;
        s->value[i].ut1_utc_s += ahead_s;
    }
}

static orr_status make_series(erp_reader *r)
{
    orr_erp *x = r->out;
    x->series.mjd_utc = malloc(r->n * sizeof *x->series.mjd_utc);
    x->series.value = malloc(r->n * sizeof *x->series.value);
    x->detail = malloc(r->n * sizeof *x->detail);
    if (x->series.mjd_utc == NULL || x->series.value == NULL || x->detail == NULL)
        return orr_cursor_error(&r->c, r->diag, ORR_E_MEMORY, 0, "no memory for %zu lines", r->n);
    bool sorted = true;
    for (size_t i = 1; i < r->n; i++) sorted &= r->row[i].mjd >= r->row[i - 1].mjd;
    if (!sorted) {
        orr_warnings_add(r->warnings, r->c.name, 0, 0,
                         "lines are not in the order of time; they were sorted");
        qsort(r->row, r->n, sizeof *r->row, by_date);
    }
    for (size_t i = 0; i < r->n; i++) {
        size_t k = x->series.n;
        if (k > 0 && x->series.mjd_utc[k - 1] == r->row[i].mjd) {
            orr_warnings_add(r->warnings, r->c.name, 0, 0, "MJD %.2f stands twice; the later line is kept",
                             r->row[i].mjd);
            k--;
        } else {
            x->series.n++;
        }
        x->series.mjd_utc[k] = r->row[i].mjd;
        x->series.value[k] = r->row[i].eop;
        x->detail[k] = r->row[i].detail;
    }
    by_builtin(r->leap, &x->series);
    return ORR_OK;
}

orr_status orr_erp_parse(const char *name, const char *text, size_t n, const orr_leap_table *leap,
                         const orr_read_limits *limits, orr_erp *out, orr_warnings *warnings, orr_diag *diag)
{
    *out = (orr_erp){0};
    erp_reader r = {.out = out, .warnings = warnings, .diag = diag, .leap = leap};
    r.limits = limits != NULL ? *limits : orr_read_default_limits();
    orr_cursor_init(&r.c, name, text, n);
    orr_status s = read_lines(&r);
    if (s == ORR_OK) s = make_series(&r);
    free(r.row);
    if (s != ORR_OK) orr_erp_free(out);
    return s;
}

orr_status orr_erp_merge(const orr_erp *in, size_t n, orr_eop_series *out, orr_diag *diag)
{
    *out = (orr_eop_series){0};
    size_t total = 0;
    for (size_t i = 0; i < n; i++) total += in[i].series.n;
    if (total == 0) return ORR_OK;
    erp_row *row = malloc(total * sizeof *row);
    out->mjd_utc = malloc(total * sizeof *out->mjd_utc);
    out->value = malloc(total * sizeof *out->value);
    if (row == NULL || out->mjd_utc == NULL || out->value == NULL) {
        free(row);
        orr_erp_series_free(out);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu lines of Earth rotation", total);
    }
    size_t k = 0;
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < in[i].series.n; j++, k++)
            row[k] = (erp_row){.mjd = in[i].series.mjd_utc[j], .order = k, .eop = in[i].series.value[j]};
    qsort(row, total, sizeof *row, by_date);
    for (size_t i = 0; i < total; i++) {
        if (out->n == 0 || out->mjd_utc[out->n - 1] != row[i].mjd) out->n++;
        out->mjd_utc[out->n - 1] = row[i].mjd;
        out->value[out->n - 1] = row[i].eop;
    }
    free(row);
    return ORR_OK;
}
