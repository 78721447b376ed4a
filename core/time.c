// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time.h"

#include <math.h>
#include <string.h>
#include <strings.h>

#include "core/time_private.h"

static const struct {
    orr_scale scale;
    const char *name;
    const char *other;
} SCALES[] = {
    {ORR_SCALE_GPS, "GPS", "GPST"}, {ORR_SCALE_UTC, "UTC", "UTC"},  {ORR_SCALE_TAI, "TAI", "TAI"},
    {ORR_SCALE_TT, "TT ", "TT"},    {ORR_SCALE_GLO, "GLO", "GLO"},  {ORR_SCALE_GAL, "GAL", "GST"},
    {ORR_SCALE_BDT, "BDT", "BDS"},  {ORR_SCALE_QZS, "QZS", "QZSS"}, {ORR_SCALE_IRN, "IRN", "IRN"},
};
#define N_SCALES (sizeof SCALES / sizeof SCALES[0])

const char *orr_scale_name(orr_scale s)
{
    for (size_t i = 0; i < N_SCALES; i++)
        if (SCALES[i].scale == s) return SCALES[i].name;
    return "???";
}

static bool same_name(const char *a, size_t len, const char *b)
{
    return strlen(b) == len && strncasecmp(a, b, len) == 0;
}

orr_status orr_scale_parse(const char *name, size_t len, orr_scale *out)
{
    for (size_t i = 0; i < N_SCALES; i++) {
        if (same_name(name, len, SCALES[i].name) || same_name(name, len, SCALES[i].other)) {
            *out = SCALES[i].scale;
            return ORR_OK;
        }
    }
    return ORR_E_ARG;
}

// --- calendar ---

bool orr_is_leap_year(int year) { return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0; }

static int days_in_month(int year, int month)
{
    static const int days[12] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    return days[month - 1] + (month == 2 && orr_is_leap_year(year) ? 1 : 0);
}

// Years are counted from 1 March, so that the leap day is the last of its year; eras of 400 years have 146097
// days.
int32_t orr_mjd_from_date(int year, int month, int day)
{
    int64_t y = (int64_t)year - (month <= 2 ? 1 : 0);
    int64_t era = orr_floor_div(y, 400), yoe = y - 400 * era;
    int64_t mp = (month + 9) % 12;
    int64_t doy = (153 * mp + 2) / 5 + day - 1;
    int64_t doe = 365 * yoe + yoe / 4 - yoe / 100 + doy;
    return (int32_t)(146097 * era + doe - 678881); // MJD of 0000-03-01 is -678881
}

void orr_date_from_mjd(int32_t mjd, int *year, int *month, int *day)
{
    int64_t z = (int64_t)mjd + 678881;
    int64_t era = orr_floor_div(z, 146097), doe = z - 146097 * era;
    int64_t yoe = (doe - doe / 1460 + doe / 36524 - doe / 146096) / 365;
    int64_t doy = doe - (365 * yoe + yoe / 4 - yoe / 100);
    int64_t mp = (5 * doy + 2) / 153;
    *day = (int)(doy - (153 * mp + 2) / 5 + 1);
    *month = (int)(mp < 10 ? mp + 3 : mp - 9);
    *year = (int)(yoe + 400 * era + (*month <= 2 ? 1 : 0));
}

int orr_day_of_year(int year, int month, int day)
{
    return orr_mjd_from_date(year, month, day) - orr_mjd_from_date(year, 1, 1) + 1;
}

// --- scales ---

int orr_leap_tai_minus_utc(orr_time t, const orr_leap_table *leap)
{
    if (leap == NULL) leap = orr_leap_builtin();
    return leap->entry[orr_leap_index_tai(leap, orr_tai_seconds(t))].tai_minus_utc_s;
}

bool orr_leap_expired(orr_time t, const orr_leap_table *leap)
{
    if (leap == NULL) leap = orr_leap_builtin();
    return orr_tai_seconds(t) - orr_leap_tai_minus_utc(t, leap) >= (int64_t)leap->expires_mjd * ORR_S_PER_DAY;
}

static bool is_utc(orr_scale s) { return s == ORR_SCALE_UTC || s == ORR_SCALE_GLO; }

// Scale - GPS in nanoseconds, for those that differ by a constant.
static int64_t offset_ns(orr_scale s)
{
    switch (s) {
    case ORR_SCALE_TAI:
        return ORR_TAI_MINUS_GPS_S * ORR_NS_PER_S;
    case ORR_SCALE_TT:
        return INT64_C(51184000000);
    case ORR_SCALE_BDT:
        return -14 * ORR_NS_PER_S;
    default:
        return 0;
    }
}

// The day (MJD) and nanosecond of day of an instant. In UTC the nanosecond of day may reach past 86400 s.
static void split(orr_time t, orr_scale scale, const orr_leap_table *leap, int32_t *mjd, int64_t *ns_of_day)
{
    if (leap == NULL) leap = orr_leap_builtin();
    int64_t s = orr_floor_div(t, ORR_NS_PER_S), ns = orr_floor_mod(t, ORR_NS_PER_S);
    if (is_utc(scale)) {
        int64_t tai_s = orr_tai_seconds(t);
        size_t i = orr_leap_index_tai(leap, tai_s);
        s = tai_s - leap->entry[i].tai_minus_utc_s;
        int64_t day = orr_floor_div(s, ORR_S_PER_DAY);
        if (i + 1 < leap->n && day >= leap->entry[i + 1].mjd)
            day = leap->entry[i + 1].mjd - 1; // the leap second
        *mjd = (int32_t)day;
        *ns_of_day = (s - day * ORR_S_PER_DAY) * ORR_NS_PER_S + ns;
        return;
    }
    ns += offset_ns(scale) % ORR_NS_PER_S;
    s += offset_ns(scale) / ORR_NS_PER_S + ns / ORR_NS_PER_S + (int64_t)ORR_MJD_GPS_EPOCH * ORR_S_PER_DAY;
    ns %= ORR_NS_PER_S;
    int64_t day = orr_floor_div(s, ORR_S_PER_DAY);
    *mjd = (int32_t)day;
    *ns_of_day = (s - day * ORR_S_PER_DAY) * ORR_NS_PER_S + ns;
}

// n units of so many nanoseconds, or the end of the axis.
static orr_time of_units(int64_t n, int64_t unit_ns)
{
    const int64_t most = INT64_MAX / unit_ns;
    return n > most ? INT64_MAX : n < -most ? -INT64_MAX : n * unit_ns;
}

// What is added to an end leads nowhere back.
static orr_time beyond(orr_time t, int64_t ns)
{
    return t == INT64_MAX || t == -INT64_MAX ? t : orr_time_add(t, ns);
}

static orr_time join(int32_t mjd, int64_t ns_of_day, orr_scale scale, const orr_leap_table *leap)
{
    if (leap == NULL) leap = orr_leap_builtin();
    int64_t shift_ns =
        is_utc(scale) ? (orr_leap_of_day(leap, mjd) - ORR_TAI_MINUS_GPS_S) * ORR_NS_PER_S : -offset_ns(scale);
    orr_time day = of_units((int64_t)mjd - ORR_MJD_GPS_EPOCH, ORR_S_PER_DAY * ORR_NS_PER_S);
    return beyond(beyond(day, ns_of_day), shift_ns);
}

orr_status orr_time_from_civil(const orr_civil *c, orr_scale scale, const orr_leap_table *leap, orr_time *out)
{
    if (leap == NULL) leap = orr_leap_builtin();
    if (c->month < 1 || c->month > 12 || c->hour < 0 || c->minute < 0 || c->minute > 59 || c->second < 0 ||
        c->second > 60 || c->ns < 0 || c->ns > 999999999 || c->hour > 24 || c->day < 1)
        return ORR_E_ARG;
    if (c->hour == 24 && (c->minute != 0 || c->second != 0 || c->ns != 0)) return ORR_E_ARG;
    if (c->year < ORR_TIME_FIRST_YEAR || c->year > ORR_TIME_LAST_YEAR) return ORR_E_RANGE;
    if (c->day > days_in_month(c->year, c->month)) return ORR_E_ARG;
    int32_t mjd = orr_mjd_from_date(c->year, c->month, c->day);
    int64_t second_of_day = c->hour * 3600 + c->minute * 60 + c->second;
    int64_t length = ORR_S_PER_DAY; // of this day
    if (is_utc(scale)) {
        if (mjd < leap->entry[0].mjd) return ORR_E_RANGE;
        length += orr_leap_of_day(leap, mjd + 1) - orr_leap_of_day(leap, mjd);
    }
    if (c->hour == 24) {
        mjd++;
        second_of_day = 0;
    } else if (second_of_day >= length) {
        return ORR_E_ARG;
    } else if (c->second == 60 && (c->hour != 23 || c->minute != 59)) {
        return ORR_E_ARG;
    }
    *out = join(mjd, second_of_day * ORR_NS_PER_S + c->ns, scale, leap);
    return ORR_OK;
}

void orr_time_to_civil(orr_time t, orr_scale scale, const orr_leap_table *leap, orr_civil *out)
{
    int32_t mjd;
    int64_t ns_of_day;
    split(t, scale, leap, &mjd, &ns_of_day);
    orr_date_from_mjd(mjd, &out->year, &out->month, &out->day);
    int64_t s = ns_of_day / ORR_NS_PER_S;
    int64_t extra = s >= ORR_S_PER_DAY ? s - (ORR_S_PER_DAY - 1) : 0; // 23:59:60 is second 86400
    s -= extra;
    out->hour = (int)(s / 3600);
    out->minute = (int)(s / 60 % 60);
    out->second = (int)(s % 60 + extra);
    out->ns = (int32_t)(ns_of_day % ORR_NS_PER_S);
}

void orr_time_mjd(orr_time t, orr_scale scale, const orr_leap_table *leap, int32_t *mjd, double *fraction)
{
    int64_t ns_of_day;
    split(t, scale, leap, mjd, &ns_of_day);
    double f = (double)ns_of_day / (ORR_S_PER_DAY * 1e9);
    *fraction = f < 1.0 ? f : nextafter(1.0, 0.0);
}

orr_time orr_time_from_mjd(int32_t mjd, double fraction, orr_scale scale, const orr_leap_table *leap)
{
    orr_time ns_of_day = orr_time_add_s(0, fraction * ORR_S_PER_DAY);
    return join(mjd, ns_of_day, scale, leap);
}

int orr_time_order(const void *a, const void *b)
{
    const orr_time x = *(const orr_time *)a, y = *(const orr_time *)b;
    return (x > y) - (x < y);
}

// --- weeks and sums ---

#define NS_PER_WEEK (ORR_S_PER_WEEK * ORR_NS_PER_S)

void orr_time_week(orr_time t, int32_t *week, int64_t *ns_of_week)
{
    int64_t w = orr_floor_div(t, NS_PER_WEEK);
    *week = (int32_t)w;
    *ns_of_week = orr_floor_mod(t, NS_PER_WEEK);
}

orr_time orr_time_from_week(int32_t week, int64_t ns_of_week)
{
    return beyond(of_units(week, NS_PER_WEEK), ns_of_week);
}

orr_time orr_time_add_s(orr_time t, double s)
{
    // Whole seconds first: the nanoseconds of a year need more bits than a product of doubles keeps exactly.
    if (!(fabs(s) < 9.2e9)) return s < 0 ? -INT64_MAX : INT64_MAX; // NAN too
    double whole = floor(s);
    return orr_time_add(t, (int64_t)whole * ORR_NS_PER_S + llround((s - whole) * 1e9));
}
