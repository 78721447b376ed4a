// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of a row: numbers, times and dates as people and spreadsheets write them.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "ingest/telemetry/telemetry_private.h"

char telemetry_separator(orr_view line)
{
    if (memchr(line.p, ';', line.n) != NULL) return ';';
    if (memchr(line.p, ',', line.n) != NULL) {
        // A comma inside quotes, or one between digits of fields that tabs divide, is a decimal comma.
        if (memchr(line.p, '\t', line.n) == NULL) {
            bool quoted = false;
            for (size_t k = 0; k < line.n; k++) {
                if (line.p[k] == '"') quoted = !quoted;
                if (line.p[k] == ',' && !quoted) return ',';
            }
            return ' ';
        }
        return '\t';
    }
    if (memchr(line.p, '\t', line.n) == NULL) return ' ';
    // Tabs that align columns are blanks; tabs between fields are not: a field may have blanks, or be empty.
    orr_view rest = line, part;
    bool blanks = false;
    while (orr_view_split(&rest, '\t', &part)) {
        orr_view v = orr_view_trim(part);
        if (v.n == 0) return ' ';
        blanks = blanks || memchr(v.p, ' ', v.n) != NULL;
    }
    return blanks ? ' ' : '\t';
}

bool telemetry_field(orr_view *rest, char separator, orr_view *field)
{
    if (rest->p == NULL) return false;
    while (rest->n > 0 && (*rest->p == ' ' || (separator != '\t' && *rest->p == '\t'))) rest->p++, rest->n--;
    if (separator == ' ' && rest->n == 0) return false;
    const char *end = rest->p + rest->n, *p = rest->p;
    if (rest->n > 0 && *p == '"') {
        const char *close = memchr(p + 1, '"', (size_t)(end - p - 1));
        if (close == NULL) close = end;
        *field = orr_view_trim((orr_view){p + 1, (size_t)(close - p - 1)});
        p = close < end ? close + 1 : end;
        while (p < end && *p != separator && !(separator == ' ' && *p == '\t')) p++;
    } else {
        while (p < end && *p != separator && !(separator == ' ' && *p == '\t')) p++;
        *field = orr_view_trim((orr_view){rest->p, (size_t)(p - rest->p)});
    }
    if (p < end) {
        rest->p = p + 1;
        rest->n = (size_t)(end - p - 1);
    } else {
        *rest = (orr_view){NULL, 0};
    }
    return true;
}

orr_field telemetry_number(orr_view field, double *x)
{
    orr_field f = orr_view_real(field, x);
    if (f != ORR_FIELD_BAD || field.n > 64) return f;
    char text[65];
    memcpy(text, field.p, field.n);
    text[field.n] = '\0';
    char *comma = memchr(text, ',', field.n);
    if (comma == NULL || strchr(comma + 1, ',') != NULL || memchr(text, '.', field.n) != NULL) return f;
    *comma = '.';
    return orr_view_real((orr_view){text, field.n}, x);
}

bool telemetry_is_nan(orr_view field)
{
    char word[8];
    orr_view_copy(field, word, sizeof word);
    for (char *p = word; *p != '\0'; p++) *p = (char)(*p | 0x20);
    return field.n <= 4 && (strcmp(word, "nan") == 0 || strcmp(word, "-nan") == 0);
}

bool telemetry_is_whole(double x) { return fabs(x - nearbyint(x)) < 1e-5; }

static bool digits(const char *p, size_t n)
{
    for (size_t k = 0; k < n; k++)
        if (p[k] < '0' || p[k] > '9') return false;
    return true;
}

static bool valid_date(int y, int m, int d, int32_t *mjd)
{
    if (y < ORR_TIME_FIRST_YEAR || y > ORR_TIME_LAST_YEAR || m < 1 || m > 12 || d < 1 || d > 31) return false;
    *mjd = orr_mjd_from_date(y, m, d);
    int y2, m2, d2;
    orr_date_from_mjd(*mjd, &y2, &m2, &d2);
    return y2 == y && m2 == m && d2 == d; // no 31st of April
}

bool telemetry_date_text(orr_view field, int32_t *mjd)
{
    char t[16];
    if (field.n < 8 || field.n >= sizeof t) return false;
    orr_view_copy(field, t, sizeof t);
    int a, b, c, used = 0;
    if (field.n == 8 && digits(t, 8)) {
        a = atoi(t);
        return valid_date(a / 10000, a / 100 % 100, a % 100, mjd);
    }
    if (digits(t, 4) && (t[4] == '-' || t[4] == '/' || t[4] == '.')) {
        for (char *p = t; *p != '\0'; p++)
            if (*p == '/' || *p == '.') *p = '-';
        return sscanf(t, "%4d-%2d-%2d%n", &a, &b, &c, &used) == 3 && (size_t)used == field.n &&
               valid_date(a, b, c, mjd);
    }
    // Day first where dots divide, as those countries write that do so; slashes would be of either kind.
    return sscanf(t, "%2d.%2d.%4d%n", &c, &b, &a, &used) == 3 && (size_t)used == field.n &&
           valid_date(a, b, c, mjd);
}

// "hh:mm", "hh:mm:ss", "hh:mm:ss.sss", and the same without colons, to seconds; moves *at behind. A 60th second is the 59th and *leap.
static bool take_clock(const char **at, double *s, bool *leap)
{
    const char *p = *at;
    int h = 0, m = 0, sec = 0;
    double part = 0.0;
    size_t n = digits(p, 2) ? 2 : digits(p, 1) ? 1 : 0;
    if (n == 0) return false;
    for (size_t k = 0; k < n; k++) h = 10 * h + (p[k] - '0');
    p += n;
    const bool compact = n == 2 && *p != ':'; // hhmmss
    p += compact ? 0 : 1;
    if ((!compact && p[-1] != ':') || !digits(p, 2)) return false;
    m = 10 * (p[0] - '0') + (p[1] - '0');
    p += 2;
    if (compact ? digits(p, 1) : *p == ':') {
        p += compact ? 0 : 1;
        if (!digits(p, 2)) return false;
        sec = 10 * (p[0] - '0') + (p[1] - '0');
        p += 2;
        if (*p == '.' || *p == ',') {
            double number = 0.0, unit = 1.0;
            for (p++; *p >= '0' && *p <= '9'; p++)
                if (unit < 1e12) {
                    number = 10.0 * number + (*p - '0');
                    unit *= 10.0;
                }
            part = number / unit;
        }
    }
    *leap = sec == 60;
    *s = 3600.0 * h + 60.0 * m + (*leap ? 59 : sec) + part;
    *at = p;
    return m < 60 && sec <= 60 && (*s < TELEMETRY_DAY_S || (*s == TELEMETRY_DAY_S && h == 24));
}

// Behind a time: nothing, the name of a scale, or an offset from UTC, *east_s. False if it is none of these.
static bool take_zone(const char *p, orr_scale *scale, double *east_s)
{
    while (*p == ' ') p++;
    *east_s = 0.0;
    size_t n = strlen(p);
    if (n == 0) return true;
    if (*p != '+' && *p != '-') {
        if ((*p == 'Z' || *p == 'z') && n == 1) {
            *scale = ORR_SCALE_UTC;
            return true;
        }
        return orr_scale_parse(p, n, scale) == ORR_OK;
    }
    int h, m = 0;
    if (!digits(p + 1, n > 2 ? 2 : 1) || n < 3) return false;
    h = 10 * (p[1] - '0') + (p[2] - '0');
    const char *q = p + 3;
    if (*q == ':') q++;
    if (*q != '\0') {
        if (!digits(q, 2) || q[2] != '\0') return false;
        m = 10 * (q[0] - '0') + (q[1] - '0');
    }
    if (h > 18 || m > 59) return false;
    *east_s = (*p == '-' ? -1.0 : 1.0) * (3600.0 * h + 60.0 * m);
    *scale = ORR_SCALE_UTC;
    return true;
}

bool telemetry_time_text(orr_view field, orr_scale usual, const orr_leap_table *leap, orr_time *at,
                         double *of_day_s)
{
    char text[64];
    *at = ORR_TIME_NONE;
    *of_day_s = ORR_NAN;
    if (field.n == 0 || field.n >= sizeof text) return false;
    orr_view_copy(field, text, sizeof text);
    const char *p = text, *divide = strpbrk(text, "Tt ");
    int32_t mjd = 0;
    double s, east_s;
    bool sixtieth;
    if (telemetry_date_text(field, &mjd)) { // a date alone is its midnight
        *at = orr_time_from_mjd(mjd, 0.0, usual, leap);
        return true;
    }
    // A blank or T divides date and time where a digit follows; "TAI" behind the time divides nothing.
    bool dated =
        divide != NULL && divide[strspn(divide, "Tt ")] >= '0' && divide[strspn(divide, "Tt ")] <= '9';
    if (dated) {
        if (!telemetry_date_text((orr_view){text, (size_t)(divide - text)}, &mjd))
            return orr_time_parse(text, leap, at, NULL) == ORR_OK; // days of the year
        p = divide + 1;
        while (*p == ' ') p++;
    }
    // Without a date digits alone are a number, not a time of day.
    if (!dated && strchr(text, ':') == NULL) return false;
    if (!take_clock(&p, &s, &sixtieth) || !take_zone(p, &usual, &east_s)) return false;
    s -= east_s;
    if (!dated) {
        *of_day_s = s + (sixtieth ? 1.0 : 0.0);
        return true;
    }
    // The 60th second stands before a midnight of UTC, which is another time of day in another zone: it is a
    // second behind the 59th, and before the next day where the table has it.
    double days = floor(s / TELEMETRY_DAY_S);
    mjd += (int32_t)days;
    *at = orr_time_add_s(orr_time_from_mjd(mjd, 0.0, usual, leap),
                         s - days * TELEMETRY_DAY_S + (sixtieth ? 1.0 : 0.0));
    return !sixtieth || (s - days * TELEMETRY_DAY_S >= TELEMETRY_DAY_S - 1.0 &&
                         *at < orr_time_from_mjd(mjd + 1, 0.0, usual, leap));
}

orr_time telemetry_unix_time(double x, double scale, const orr_leap_table *leap)
{
    // Remainder and quotient by whole days in the number's own unit, so that microseconds stay exact.
    double day = TELEMETRY_DAY_S / scale, days = floor(x / day);
    if (!(fabs(days) < 60000.0)) return ORR_TIME_NONE;
    return orr_time_add_s(orr_time_from_mjd(40587 + (int32_t)days, 0.0, ORR_SCALE_UTC, leap),
                          (x - days * day) * scale);
}
