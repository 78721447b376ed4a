// SPDX-License-Identifier: GPL-3.0-or-later
// Instants and lengths of time as people write them.
#include <stdio.h>
#include <string.h>

#include "core/time.h"

static bool digit(char c) { return c >= '0' && c <= '9'; }

static const int32_t POWER10[10] = {1,      10,      100,      1000,      10000,
                                    100000, 1000000, 10000000, 100000000, 1000000000};

// --- writing ---

static void print(orr_time t, orr_scale scale, int decimals, const orr_leap_table *leap, const char *suffix,
                  char buf[ORR_TIME_TEXT])
{
    orr_civil c;
    orr_time_to_civil(t, scale, leap, &c);
    int n = snprintf(buf, ORR_TIME_TEXT, "%04d-%02d-%02dT%02d:%02d:%02d", c.year, c.month, c.day, c.hour,
                     c.minute, c.second);
    if (decimals > 0)
        n += snprintf(buf + n, ORR_TIME_TEXT - (size_t)n, ".%0*d", decimals,
                      (int)(c.ns / POWER10[9 - decimals]));
    snprintf(buf + n, ORR_TIME_TEXT - (size_t)n, "%s", suffix);
}

char *orr_time_format(orr_time t, orr_scale scale, int decimals, const orr_leap_table *leap,
                      char buf[ORR_TIME_TEXT])
{
    if (decimals < 0) decimals = 0;
    if (decimals > 9) decimals = 9;
    // Rounded in the scale itself: TT alone differs from GPS by a part of a second.
    int64_t q = POWER10[9 - decimals], part = scale == ORR_SCALE_TT ? INT64_C(184000000) : 0;
    int64_t rest = (t % q + part % q + q) % q;
    t = orr_time_add(t, 2 * rest >= q ? q - rest : -rest);
    char suffix[8] = "";
    if (scale == ORR_SCALE_UTC)
        snprintf(suffix, sizeof suffix, "Z");
    else if (scale == ORR_SCALE_TT)
        snprintf(suffix, sizeof suffix, " TT");
    else if (scale != ORR_SCALE_GPS)
        snprintf(suffix, sizeof suffix, " %s", orr_scale_name(scale));
    print(t, scale, decimals, leap, suffix, buf);
    return buf;
}

char *orr_time_text(orr_time t, char buf[ORR_TIME_TEXT])
{
    int64_t ns = orr_floor_mod(t, ORR_NS_PER_S);
    int decimals = 0;
    for (; ns != 0; decimals++) ns = ns * 10 % ORR_NS_PER_S;
    print(t, ORR_SCALE_GPS, decimals, NULL, "", buf);
    return buf;
}

// --- reading ---

// An unsigned integer of min to max digits (at most nine); moves *p on.
static bool take_int(const char **p, int min, int max, int *out)
{
    int n = 0, v = 0;
    while (n < max && digit((*p)[n])) v = 10 * v + ((*p)[n++] - '0');
    if (n < min) return false;
    *p += n;
    *out = v;
    return true;
}

// ".ddd" of at most nine digits, as nanoseconds; nothing there is zero.
static bool take_fraction(const char **p, int32_t *ns)
{
    *ns = 0;
    if (**p != '.' && **p != ',') return true;
    const char *q = *p + 1;
    int n = 0, v = 0;
    while (digit(q[n])) {
        if (n == 9) return false;
        v = 10 * v + (q[n++] - '0');
    }
    if (n == 0) return false;
    *ns = v * POWER10[9 - n];
    *p = q + n;
    return true;
}

#define FORMS                                                                                                \
    "use 2024-02-04T00:15:00 (GPS time; with Z or UTC, TAI, TT, GLO, GAL, BDT for another scale, or "        \
    "+00:00), "                                                                                              \
    "2024-035T00:15, 2024:035:00900, \"2024 2 4 0 15 0\", MJD60344.25 or week:seconds as in 2300:900"

static orr_status refuse(orr_diag *diag, orr_status s, const char *text, const char *why)
{
    return orr_diag_set(diag, s, "\"%.60s\" is no time: %s", text, why);
}

static orr_status parse_week(const char *text, orr_time *out, orr_diag *diag)
{
    const char *p = text;
    int week, second;
    int32_t ns;
    if (!take_int(&p, 1, 5, &week) || *p++ != ':' || !take_int(&p, 1, 6, &second) ||
        !take_fraction(&p, &ns) || *p != '\0')
        return refuse(diag, ORR_E_ARG, text, FORMS);
    if (second >= ORR_S_PER_WEEK)
        return refuse(diag, ORR_E_ARG, text, "a week has 604800 seconds, counted from 0");
    if (week > 14091) return refuse(diag, ORR_E_RANGE, text, "the years 1960 to 2250 are understood");
    *out = orr_time_from_week(week, second * ORR_NS_PER_S + ns);
    return ORR_OK;
}

// What goes on from midnight of the day that c has: seconds of the day as SINEX counts them.
static bool put_second_of_day(int second, orr_civil *c)
{
    c->hour = second / 3600;
    c->minute = second / 60 % 60;
    c->second = second % 60;
    return second <= 86400;
}

static bool put_day_of_year(int doy, orr_civil *c, const char **why)
{
    if (doy < 1 || doy > (orr_is_leap_year(c->year) ? 366 : 365)) {
        *why = "the year has no such day";
        return false;
    }
    orr_date_from_mjd(orr_mjd_from_date(c->year, 1, 1) + doy - 1, &c->year, &c->month, &c->day);
    return true;
}

// SINEX: "YYYY:DDD:SSSSS", or with the year's last two digits, of 1950 to 2049.
static bool take_sinex(const char **p, orr_civil *c, const char **why)
{
    const char *begin = *p;
    int doy, second;
    if (!take_int(p, 2, 4, &c->year) || *p - begin == 3 || *(*p)++ != ':') return false;
    if (*p - begin == 3) c->year += c->year < 50 ? 2000 : 1900;
    if (!take_int(p, 3, 3, &doy) || *(*p)++ != ':' || !take_int(p, 5, 5, &second)) return false;
    return put_day_of_year(doy, c, why) && put_second_of_day(second, c);
}

// "YYYY M D", then "h", "h m", "h m s", "h m s.s", divided by blanks as in tables and in SP3.
static bool take_columns(const char **p, orr_civil *c)
{
    int *const part[] = {&c->year, &c->month, &c->day, &c->hour, &c->minute, &c->second};
    for (int i = 0; i < 6; i++) {
        const char *q = *p;
        while (*q == ' ') q++;
        if (!digit(*q)) return i > 2; // the date is there; a scale may follow
        if (i > 0 && q == *p) return false;
        if (!take_int(&q, i == 0 ? 4 : 1, i == 0 ? 4 : 2, part[i])) return false;
        *p = q;
        if (i > 1 && **p == '\0') return true;
    }
    return take_fraction(p, &c->ns);
}

// "MJD60344.25", a blank behind the letters allowed: the modified Julian day and its part, to 1 ns.
static bool take_mjd(const char **p, orr_civil *c)
{
    int day, n = 0;
    int64_t part = 0; // in 1e-14 days
    *p += 3;
    while (**p == ' ') (*p)++;
    if (!take_int(p, 1, 6, &day)) return false;
    if (**p == '.')
        for ((*p)++; digit(**p); (*p)++, n++)
            if (n < 14) part = 10 * part + (**p - '0');
    for (; n < 14; n++) part *= 10;
    const int64_t ns = (part * 864 + 500) / 1000;
    orr_date_from_mjd(day, &c->year, &c->month, &c->day);
    c->ns = (int32_t)(ns % ORR_NS_PER_S);
    return put_second_of_day((int)(ns / ORR_NS_PER_S), c);
}

// "+hh:mm" or "-hh:mm", "+hhmm" and "+hh": the zone's time minus UTC, in minutes.
static bool take_zone(const char *p, int *minutes)
{
    const int sign = *p == '-' ? -1 : 1;
    int hour, minute = 0;
    if ((*p != '+' && *p != '-') || (p++, !take_int(&p, 2, 2, &hour))) return false;
    if (*p == ':') p++;
    if (*p != '\0' && !take_int(&p, 2, 2, &minute)) return false;
    *minutes = sign * (60 * hour + minute);
    return *p == '\0' && hour <= 14 && minute < 60;
}

// "YYYY-MM-DD" or "YYYY-DDD"
static bool take_date(const char **p, orr_civil *c, const char **why)
{
    if (!take_int(p, 4, 4, &c->year) || **p != '-') return false;
    (*p)++;
    const char *q = *p;
    int doy;
    if (take_int(&q, 3, 3, &doy) && !digit(*q) && *q != '-') {
        *p = q;
        return put_day_of_year(doy, c, why);
    }
    if (!take_int(p, 1, 2, &c->month) || **p != '-') return false;
    (*p)++;
    return take_int(p, 1, 2, &c->day);
}

// "hh", "hh:mm", "hh:mm:ss", "hh:mm:ss.s"
static bool take_clock(const char **p, orr_civil *c)
{
    const char *begin = *p;
    if (!take_int(p, 1, 2, &c->hour)) return false;
    if (**p != ':') return *p - begin == 2;
    (*p)++;
    if (!take_int(p, 2, 2, &c->minute)) return false;
    if (**p != ':') return true;
    (*p)++;
    return take_int(p, 2, 2, &c->second) && take_fraction(p, &c->ns);
}

orr_status orr_time_parse(const char *text, const orr_leap_table *leap, orr_time *out, orr_diag *diag)
{
    if (leap == NULL) leap = orr_leap_builtin();
    const char *p = text;
    while (digit(*p)) p++;
    const bool colon = *p == ':';
    if (colon && strchr(p + 1, ':') == NULL) return parse_week(text, out, diag);

    orr_civil c = {0};
    orr_scale scale = ORR_SCALE_GPS;
    const char *why = FORMS;
    int zone = 0;
    const bool columns = p == text + 4 && *p == ' ',
               mjd = strncmp(text, "MJD", 3) == 0 || strncmp(text, "mjd", 3) == 0;
    p = text;
    const bool good = colon     ? take_sinex(&p, &c, &why)
                      : columns ? take_columns(&p, &c)
                      : mjd     ? take_mjd(&p, &c)
                                : take_date(&p, &c, &why);
    if (!good) return refuse(diag, ORR_E_ARG, text, why);
    const bool iso = !colon && !columns && !mjd;
    if (iso && (*p == 'T' || *p == 't' || *p == ' ') && digit(p[1])) {
        p++;
        if (!take_clock(&p, &c)) return refuse(diag, ORR_E_ARG, text, FORMS);
    }
    while (*p == ' ') p++;
    if ((*p == 'Z' || *p == 'z') && p[1] == '\0')
        scale = ORR_SCALE_UTC;
    else if (take_zone(p, &zone))
        scale = ORR_SCALE_UTC;
    else if (*p != '\0' && orr_scale_parse(p, strlen(p), &scale) != ORR_OK)
        return refuse(diag, ORR_E_ARG, text, FORMS);

    orr_status status = orr_time_from_civil(&c, scale, leap, out);
    if (status == ORR_OK) *out = orr_time_add(*out, -zone * 60 * ORR_NS_PER_S);
    if (status == ORR_E_RANGE && c.year >= ORR_TIME_FIRST_YEAR && c.year <= ORR_TIME_LAST_YEAR)
        return refuse(diag, status, text,
                      "UTC and GLO have whole leap seconds since 1972-01-01 only; use GPS or TAI");
    if (status == ORR_E_RANGE) return refuse(diag, status, text, "the years 1960 to 2250 are understood");
    if (status != ORR_OK && c.second == 60)
        return refuse(diag, status, text, "no leap second was inserted there, or the scale has none");
    if (status != ORR_OK) return refuse(diag, status, text, "there is no such date or time of day");
    return ORR_OK;
}

orr_status orr_duration_parse(const char *text, int64_t *ns, orr_diag *diag)
{
    static const struct {
        const char *name;
        int64_t ns;
    } units[] = {
        {"", INT64_C(1000000000)},
        {"s", INT64_C(1000000000)},
        {"ms", INT64_C(1000000)},
        {"us", INT64_C(1000)},
        {"ns", INT64_C(1)},
        {"min", INT64_C(60000000000)},
        {"m", INT64_C(60000000000)},
        {"h", INT64_C(3600000000000)},
        {"d", INT64_C(86400000000000)},
    };
    const char *p = text;
    int whole = 0;
    int32_t fraction = 0;
    bool good = digit(*p) || *p == '.';
    if (good && digit(*p)) good = take_int(&p, 1, 9, &whole);
    good = good && take_fraction(&p, &fraction);
    while (good && *p == ' ') p++;
    for (size_t i = 0; good && i < sizeof units / sizeof units[0]; i++) {
        if (strcmp(p, units[i].name) != 0) continue;
        int64_t unit = units[i].ns;
        if (whole > INT64_MAX / unit - 1)
            return orr_diag_set(diag, ORR_E_RANGE, "\"%.60s\" is longer than 292 years", text);
        // fraction is in 1e-9 of the unit; a part of a nanosecond is not dropped in silence
        int64_t part =
            unit >= ORR_NS_PER_S ? fraction * (unit / ORR_NS_PER_S) : fraction / (ORR_NS_PER_S / unit);
        if (unit < ORR_NS_PER_S && fraction % (ORR_NS_PER_S / unit) != 0)
            return orr_diag_set(diag, ORR_E_ARG, "\"%.60s\" is finer than a nanosecond", text);
        *ns = whole * unit + part;
        return ORR_OK;
    }
    return orr_diag_set(diag, ORR_E_ARG,
                        "\"%.60s\" is no length of time; use 900, 900s, 15min, 2h, 1d or 0.1", text);
}

void orr_leap_warn(orr_time t, const orr_leap_table *leap, const char *file, orr_warnings *w)
{
    char last[ORR_TIME_TEXT];
    int year, month, day;
    if (leap == NULL) leap = orr_leap_builtin();
    if (t == ORR_TIME_NONE || !orr_leap_expired(t, leap)) return;
    orr_date_from_mjd(leap->expires_mjd, &year, &month, &day);
    orr_warnings_add(w, file, 0, 0,
                     "UTC up to %s lies beyond the table of leap seconds, which is certain to %04d-%02d-%02d "
                     "alone; a newer "
                     "leap-seconds.list is taken by --leap-seconds FILE or ORRERY_LEAP_SECONDS",
                     orr_time_format(t, ORR_SCALE_UTC, 0, leap, last), year, month, day);
}
