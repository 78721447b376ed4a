// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/rinex/rinex_labels.h"

#include <ctype.h>
#include <math.h>

// Columns are characters: names in UTF-8 push the label to the right. (A byte of Latin-1 is a column by
// itself.)
static int bytes_more_than_columns(orr_view line)
{
    int more = 0;
    for (size_t i = 1; i < line.n && i < (size_t)(60 + more); i++) {
        unsigned char before = (unsigned char)line.p[i - 1], c = (unsigned char)line.p[i];
        more += (c & 0xc0) == 0x80 && before >= 0x80;
    }
    return more;
}

orr_view orr_rinex_label(orr_view line)
{
    return orr_view_trim(orr_view_cols(line, 61 + bytes_more_than_columns(line), 20));
}

orr_status orr_rinex_first_line(const char *name, orr_view line, orr_rinex_first *out, orr_diag *diag)
{
    // A byte-order mark of an editor is no part of the format, but no harm either.
    if (line.n >= 3 && line.p[0] == '\xef' && line.p[1] == '\xbb' && line.p[2] == '\xbf') {
        line.p += 3;
        line.n -= 3;
    }
    if (!orr_view_equals(orr_rinex_label(line), "RINEX VERSION / TYPE"))
        return orr_diag_at(diag, ORR_E_KIND, name, 1, 61,
                           "not a RINEX file: its first line does not end with RINEX VERSION / TYPE");
    double version = 0;
    if (orr_field_real(line, 1, 20, &version) != ORR_FIELD_OK)
        return orr_diag_at(diag, ORR_E_FORMAT, name, 1, 1, "the RINEX version is not a number");
    if (version < 2 || version >= 5)
        return orr_diag_at(diag, ORR_E_UNSUPPORTED, name, 1, 1,
                           "RINEX version %.2f is not read (2.00 to 4.02 are)", version);
    out->version = version;
    // Column 21 is the type; in RINEX 3 a navigation file may say "N: GNSS NAV DATA" or "NAVIGATION DATA".
    out->type = (char)toupper((unsigned char)orr_view_char(line, 21));
    out->system = (char)toupper((unsigned char)orr_view_char(line, 41));
    return ORR_OK;
}

void orr_rinex_check_version(const char *name, double version, orr_warnings *warnings)
{
    // Those of observations and navigation data (RINEX 2.11, 2.12 and 2.20 of LEOs; 3.00 to 3.05; 4.00 to 4.02).
    static const int known[] = {200, 201, 202, 210, 211, 212, 220, 300,
                                301, 302, 303, 304, 305, 400, 401, 402};
    const int v = (int)lround(version * 100);
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
        if (known[i] == v) return;
    orr_warnings_add(warnings, name, 1, 1, "there is no RINEX version %.2f; read as the last before it",
                     version);
}

void orr_rinex_check_width(const char *name, int64_t line_number, orr_view line, bool *told,
                           orr_warnings *warnings)
{
    if (*told || orr_view_trim(orr_view_cols(line, 81 + bytes_more_than_columns(line), 200)).n == 0) return;
    *told = true;
    orr_warnings_add(warnings, name, line_number, 81,
                     "the header has text behind column 80, which is not read");
}

bool orr_rinex_seconds(orr_view line, int col, int width, int64_t *ps)
{
    double s = 0;
    if (orr_field_real(line, col, width, &s) != ORR_FIELD_OK || !(s >= 0 && s < 61)) return false;
    *ps = (int64_t)llround(s * 1e7) * 100000; // seven decimals are what the formats have
    return true;
}

orr_status orr_rinex_time(const orr_rinex_date *d, orr_scale scale, const orr_leap_table *leap, orr_time *out)
{
    int year = d->year;
    if (year >= 0 && year < 80)
        year += 2000;
    else if (year >= 80 && year < 100)
        year += 1900;
    int64_t ns = (d->second_ps + 500) / 1000;
    orr_civil c = {year, d->month, d->day, d->hour, d->minute, 0, 0};
    int64_t whole = ns / ORR_NS_PER_S;
    if (whole >= 60) { // a leap second where there is one, else a rounded-up 59.99999995
        c.second = 60;
        c.ns = (int32_t)(ns % ORR_NS_PER_S);
        if (orr_time_from_civil(&c, scale, leap, out) == ORR_OK) return ORR_OK;
        c.second = 0;
        c.ns = 0;
        orr_status s = orr_time_from_civil(&c, scale, leap, out);
        if (s == ORR_OK) *out += ns;
        return s;
    }
    c.second = (int)whole;
    c.ns = (int32_t)(ns % ORR_NS_PER_S);
    return orr_time_from_civil(&c, scale, leap, out);
}
