// SPDX-License-Identifier: GPL-3.0-or-later
// The IERS' own files of Earth rotation: Bulletin A as finals.all, finals2000A.all, .data and .daily (readme.finals2000A:
// fixed columns), and EOP C04 in the forms of 08, 14 (year, month, day, MJD, values) and 20 (with the hour, and rates).
// Text, predictions without values and comments are passed over.
#include <math.h>

#include "core/nan.h"
#include "core/vec.h"
#include "ingest/tables/erp_private.h"

#define FIRST_MJD 41317 // 1972-01-01, from which UTC has whole leap seconds
#define RAD_PER_ARCSEC (ORR_RAD_PER_DEG / 3600)
#define RAD_PER_MAS (RAD_PER_ARCSEC * 1e-3)

// "73 1 2 41684.00 I ..." of finals: the date in columns 1-6 is that of the MJD in 8-15.
static bool finals_date(orr_view line, double *mjd)
{
    int year, month, day;
    if (orr_field_int_in(line, 1, 2, 0, 99, &year) != ORR_FIELD_OK ||
        orr_field_int_in(line, 3, 2, 1, 12, &month) != ORR_FIELD_OK ||
        orr_field_int_in(line, 5, 2, 1, 31, &day) != ORR_FIELD_OK || orr_view_char(line, 7) != ' ' ||
        orr_field_real(line, 8, 8, mjd) != ORR_FIELD_OK)
        return false;
    // Two digits: 1973 (the first year of the files) to 2072.
    return floor(*mjd) == orr_mjd_from_date(year + (year < 73 ? 2000 : 1900), month, day);
}

// The words of a line of C04 as numbers; 0 where it is none: the date in front must be that of the MJD behind it.
static size_t c04_numbers(orr_view line, double v[32], size_t *mjd_at)
{
    orr_view rest = line, word;
    size_t n = 0;
    for (; orr_view_word(&rest, &word); n++)
        if (n == 32 || orr_view_real(word, &v[n]) != ORR_FIELD_OK) return 0;
    if (n < 8 || !(v[0] >= 1846 && v[0] < 2200 && v[1] >= 1 && v[1] <= 12 && v[2] >= 1 && v[2] <= 31))
        return 0;
    const int32_t mjd = orr_mjd_from_date((int)v[0], (int)v[1], (int)v[2]);
    for (*mjd_at = 3; *mjd_at < 5; ++*mjd_at)
        if (floor(v[*mjd_at]) == mjd) return n;
    return 0;
}

erp_iers_kind erp_iers_line(orr_view line)
{
    double mjd, v[32];
    size_t at;
    char flag = orr_view_char(line, 17);
    if ((flag == 'I' || flag == 'P') && finals_date(line, &mjd)) return ERP_FINALS;
    return c04_numbers(line, v, &at) > 0 ? ERP_C04 : ERP_NOT_IERS;
}

static void no_detail(orr_erp_detail *d)
{
    *d = (orr_erp_detail){ORR_NAN, ORR_NAN, ORR_NAN, ORR_NAN, ORR_NAN, ORR_NAN, ORR_NAN,
                          ORR_NAN, ORR_NAN, ORR_NAN, -1,      -1,      -1};
}

// A number of a fixed field; `missing` where it is blank. False where it is bad.
static bool field(orr_view line, int column, int width, double factor, double missing, double *out)
{
    double v;
    orr_field got = orr_field_real(line, column, width, &v);
    *out = got == ORR_FIELD_OK ? v * factor : missing;
    return got != ORR_FIELD_BAD;
}

// Bulletin A's values, which stand for all days; those of Bulletin B behind them come a month later.
static orr_status finals_row(erp_reader *r, orr_view line)
{
    erp_row e = {0};
    no_detail(&e.detail);
    if (!finals_date(line, &e.mjd))
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1, "the date is not that of the MJD");
    if (orr_view_is_blank(orr_view_cols(line, 17, 59))) return ORR_OK; // a day to come
    struct {
        int column, width;
        double factor, missing;
        double *to;
    } const fields[] = {{19, 9, RAD_PER_ARCSEC, ORR_NAN, &e.eop.xp_rad},
                        {28, 9, RAD_PER_ARCSEC, ORR_NAN, &e.detail.xp_sdev_rad},
                        {38, 9, RAD_PER_ARCSEC, ORR_NAN, &e.eop.yp_rad},
                        {47, 9, RAD_PER_ARCSEC, ORR_NAN, &e.detail.yp_sdev_rad},
                        {59, 10, 1, ORR_NAN, &e.eop.ut1_utc_s},
                        {69, 10, 1, ORR_NAN, &e.detail.ut1_sdev_s},
                        {80, 7, 1e-3, 0, &e.eop.lod_s},
                        {87, 7, 1e-3, ORR_NAN, &e.detail.lod_sdev_s},
                        {98, 9, RAD_PER_MAS, ORR_NAN, &e.detail.dpsi_rad},
                        {117, 9, RAD_PER_MAS, ORR_NAN, &e.detail.deps_rad}};
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++)
        if (!field(line, fields[i].column, fields[i].width, fields[i].factor, fields[i].missing,
                   fields[i].to))
            return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, fields[i].column,
                                    "a field that is no number");
    if (isnan(e.eop.xp_rad) || isnan(e.eop.yp_rad) || isnan(e.eop.ut1_utc_s))
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 19, "the pole or UT1 - UTC is missing");
    if (r->c.unterminated && line.n < 68)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0,
                                "the file ends inside a line: it is cut short");
    return erp_add_row(r, &e);
}

static orr_status c04_row(erp_reader *r, orr_view line)
{
    double v[32];
    size_t at, n = c04_numbers(line, v, &at);
    erp_row e = {0};
    no_detail(&e.detail);
    if (n == 0)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1,
                                "a line that is not a date, its MJD and numbers");
    if (v[at] < FIRST_MJD) return ORR_OK; // UTC had no whole leap seconds
    // 14: x y UT1-UTC LOD dX dY, then their uncertainties in that order; 20: x y UT1-UTC dX dY x' y' LOD, likewise.
    const bool hour = at == 4;
    const size_t want = at + 1 + (hour ? 16 : 12), lod = hour ? 7 : 3, sdev = hour ? 8 : 6;
    if (n < want)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0, "%zu numbers instead of %zu", n, want);
    const double *x = &v[at + 1];
    e.mjd = v[at];
    if (hour && e.mjd == floor(e.mjd)) e.mjd += v[3] / 24;
    e.eop = (orr_eop){
        .xp_rad = x[0] * RAD_PER_ARCSEC, .yp_rad = x[1] * RAD_PER_ARCSEC, .ut1_utc_s = x[2], .lod_s = x[lod]};
    e.detail.xp_sdev_rad = x[sdev] * RAD_PER_ARCSEC;
    e.detail.yp_sdev_rad = x[sdev + 1] * RAD_PER_ARCSEC;
    e.detail.ut1_sdev_s = x[sdev + 2];
    e.detail.lod_sdev_s = x[sdev + lod];
    e.detail.dpsi_rad = x[hour ? 3 : 4] * RAD_PER_ARCSEC;
    e.detail.deps_rad = x[hour ? 4 : 5] * RAD_PER_ARCSEC;
    if (hour) {
        e.detail.xp_rate_radps = x[5] * RAD_PER_ARCSEC / ORR_S_PER_DAY;
        e.detail.yp_rate_radps = x[6] * RAD_PER_ARCSEC / ORR_S_PER_DAY;
        e.detail.xp_rate_sdev_radps = x[sdev + 5] * RAD_PER_ARCSEC / ORR_S_PER_DAY;
        e.detail.yp_rate_sdev_radps = x[sdev + 6] * RAD_PER_ARCSEC / ORR_S_PER_DAY;
    }
    return erp_add_row(r, &e);
}

orr_status erp_read_iers(erp_reader *r, orr_view line, erp_iers_kind kind)
{
    orr_diag *const diag = r->diag;
    orr_view_copy(orr_view_of(kind == ERP_FINALS ? "IERS finals (Bulletin A)" : "IERS EOP C04"),
                  r->out->title, sizeof r->out->title);
    bool more = true;
    for (; more; more = orr_cursor_next(&r->c, &line)) {
        if (orr_view_is_blank(line) || line.p[0] == '#') continue;
        orr_diag why = {0};
        r->diag = &why;
        orr_status s = kind == ERP_FINALS ? finals_row(r, line) : c04_row(r, line);
        r->diag = diag;
        r->tally.good += s == ORR_OK;
        if (s == ORR_E_FORMAT && !r->c.unterminated) {
            orr_records_leave_out(&r->tally, &r->c, why.column, why.text, r->warnings);
        } else if (s != ORR_OK) {
            if (diag != NULL) *diag = why;
            return s;
        }
    }
    orr_status s = orr_cursor_status(&r->c, diag);
    if (s == ORR_OK) s = orr_records_verdict(&r->tally, diag);
    if (s == ORR_OK && r->n == 0)
        s = orr_cursor_error(&r->c, diag, ORR_E_FORMAT, 0,
                             "the file has no line of Earth rotation since 1972");
    return s;
}
