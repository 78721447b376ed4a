// SPDX-License-Identifier: GPL-3.0-or-later
// Time. Inside the program an instant is one integer: nanoseconds of the GPS scale since 1980-01-06T00:00:00
// GPS. It never steps and never rounds; UTC with its leap seconds and all other scales exist at the edges
// alone.
#ifndef ORR_CORE_TIME_H
#define ORR_CORE_TIME_H

#include "core/leap.h"

typedef int64_t orr_time; // covers 1687 to 2272

#define ORR_TIME_NONE INT64_MIN // "no instant"; no routine returns it as a value
// Readers of binary files refuse instants farther from 1980 than this (73 years): differences of two that are
// nearer fit in an orr_time.
#define ORR_TIME_FAR (INT64_C(1) << 61)
// Whether t is nearer to 1980 than that.
static inline bool orr_time_is_near(orr_time t) { return t > -ORR_TIME_FAR && t < ORR_TIME_FAR; }
// The years that are read: any two instants within them are nearer than an orr_time can say.
#define ORR_TIME_FIRST_YEAR 1960
#define ORR_TIME_LAST_YEAR 2250
#define ORR_NS_PER_S INT64_C(1000000000)
#define ORR_BDT_BEHIND_GPS_NS (14 * ORR_NS_PER_S)
#define ORR_BDT_WEEK_0 1356 // GPS week of BDT's week 0
#define ORR_S_PER_WEEK 604800

typedef enum orr_scale {
    ORR_SCALE_GPS,
    ORR_SCALE_UTC,
    ORR_SCALE_TAI, // GPS + 19 s
    ORR_SCALE_TT,  // GPS + 51.184 s
    ORR_SCALE_GLO, // as SP3 and RINEX use it: UTC (without the three hours of Moscow)
    ORR_SCALE_GAL, // GPS as far as labels go (offset below 50 ns is a clock matter)
    ORR_SCALE_BDT, // GPS - 14 s
    ORR_SCALE_QZS, // as GPS
    ORR_SCALE_IRN, // as GPS
} orr_scale;

// Three-letter name as in SP3 and RINEX ("GPS", "UTC", "TAI", "GLO", "GAL", "BDT", "QZS", "IRN"; "TT ").
const char *orr_scale_name(orr_scale s);
orr_status orr_scale_parse(const char *name, size_t len,
                           orr_scale *out); // case-insensitive, "BDS" and "QZSS" too

// A date and time of day as written. second may be 60 in UTC and GLO where a leap second is inserted.
typedef struct orr_civil {
    int year, month, day, hour, minute, second; // Gregorian; month 1-12, day 1-31
    int32_t ns;                                 // 0 .. 999999999
} orr_civil;

// TAI - UTC at an instant, in seconds. leap may be NULL (built-in) in this and every routine below.
int orr_leap_tai_minus_utc(orr_time t, const orr_leap_table *leap);
// Whether the table makes no promise at t: its UTC day is that of the table's expiry or later.
bool orr_leap_expired(orr_time t, const orr_leap_table *leap);
// Warns where that is so of the last UTC label that was converted: a leap second that was announced since is not in it.
//   Given:    t           the last instant; ORR_TIME_NONE: none was
//             leap        the table; NULL: built-in
//             file        whose labels they are, for the message; may be NULL
//   Returned: w           with the warning, which says what to do; may be NULL
void orr_leap_warn(orr_time t, const orr_leap_table *leap, const char *file, orr_warnings *w);

// Checks every field (months, days, a 60th second only where the table has one). 24:00:00 is accepted and is
// the next day's 00:00:00. ORR_E_ARG if it is no date, ORR_E_RANGE outside the years above and, in UTC and GLO,
// before the table's first day (1972: UTC had no whole leap seconds before). The way back has no error:
// before 1972 it holds the first entry.
orr_status orr_time_from_civil(const orr_civil *c, orr_scale scale, const orr_leap_table *leap,
                               orr_time *out);
// The date and time of day of an instant in a scale.
void orr_time_to_civil(orr_time t, orr_scale scale, const orr_leap_table *leap, orr_civil *out);

// Dates are of the proleptic Gregorian calendar. The modified Julian day of one:
int32_t orr_mjd_from_date(int year, int month, int day);
// The date of a modified Julian day.
void orr_date_from_mjd(int32_t mjd, int *year, int *month, int *day);
int orr_day_of_year(int year, int month, int day); // 1..366
bool orr_is_leap_year(int year);                   // has a 29 February

// The modified Julian date of an instant in a scale.
//   Given:    t          the instant
//             scale      of the date
//             leap       table of leap seconds; NULL: built-in
//   Returned: mjd        whole days
//             fraction   of a day of 86400 s, [0, 1)
//   Notes:    in UTC and GLO a leap second is held at the day's end (ERFA's quasi-JD stretches the day instead).
void orr_time_mjd(orr_time t, orr_scale scale, const orr_leap_table *leap, int32_t *mjd, double *fraction);
// The way back, to the nearest nanosecond of fraction; saturates as the sums below.
orr_time orr_time_from_mjd(int32_t mjd, double fraction, orr_scale scale, const orr_leap_table *leap);

// For qsort and bsearch over orr_time, ascending.
int orr_time_order(const void *a, const void *b);

// GPS week (unlimited, no rollover) and seconds of week as nanoseconds [0, 604800e9). Negative weeks before
// 1980.
void orr_time_week(orr_time t, int32_t *week, int64_t *ns_of_week);
// The way back; saturates as the sums below.
orr_time orr_time_from_week(int32_t week, int64_t ns_of_week);

// t + ns nanoseconds. What does not fit is the nearest that does, never ORR_TIME_NONE: an instant of anyone may be
// at an end of the axis.
static inline orr_time orr_time_add(orr_time t, int64_t ns)
{
    int64_t sum;
    if (__builtin_add_overflow(t, ns, &sum)) return ns < 0 ? -INT64_MAX : INT64_MAX;
    return sum == INT64_MIN ? -INT64_MAX : sum;
}
// a - b in nanoseconds, which saturates likewise.
static inline int64_t orr_time_sub_ns(orr_time a, orr_time b)
{
    int64_t difference;
    if (__builtin_sub_overflow(a, b, &difference)) return a < b ? -INT64_MAX : INT64_MAX;
    return difference == INT64_MIN ? -INT64_MAX : difference;
}

// a / b rounded down, whatever the signs.
static inline int64_t orr_floor_div(int64_t a, int64_t b)
{
    int64_t q = a / b;
    return a % b != 0 && (a < 0) != (b < 0) ? q - 1 : q;
}

// What orr_floor_div leaves: [0, b) for b > 0.
static inline int64_t orr_floor_mod(int64_t a, int64_t b)
{
    int64_t r = a % b;
    return r != 0 && (r < 0) != (b < 0) ? r + b : r;
}

// a - b in seconds, the double nearest to the true value: whole seconds are whole, and half a nanosecond is
// kept for |a - b| < 48 days. Saturates as orr_time_sub_ns.
static inline double orr_time_diff_s(orr_time a, orr_time b) { return (double)orr_time_sub_ns(a, b) / 1e9; }
// t + s seconds, rounded to the nearest nanosecond; a sum beyond the axis is its end, never ORR_TIME_NONE.
orr_time orr_time_add_s(orr_time t, double s);

#define ORR_TIME_TEXT 48
// The text "2024-02-04T00:15:00" of an instant.
//   Given:    t          the instant
//             scale      of the text: GPS has no suffix, UTC "Z", any other its name (" TAI"), so that
//                        orr_time_parse reads it back
//             decimals   digits of seconds, 0 to 9; rounded to them
//             leap       table of leap seconds; NULL: built-in
//   Returned: buf        the text
//             (value)    buf
char *orr_time_format(orr_time t, orr_scale scale, int decimals, const orr_leap_table *leap,
                      char buf[ORR_TIME_TEXT]);
// Shortest text that reads back exactly (as many decimals as needed), GPS scale, no suffix.
char *orr_time_text(orr_time t, char buf[ORR_TIME_TEXT]);
// Reads what the command line accepts: ISO 8601 date or date and time ('T' or blank between, minutes
// and seconds optional), with an optional suffix " GPS", " UTC", "Z" (= UTC), " TAI", " GLO", " GAL", " BDT",
// " TT"; GPS without one; "+hh:mm" (UTC and the zone's offset); "WWWW:SSSSSS.s" (GPS week and seconds); "YYYY-DDD" with an
// optional "Thh:mm[:ss]"; SINEX' "YYYY:DDD:SSSSS"; "YYYY M D h m s" in columns; "MJD60344.25".
orr_status orr_time_parse(const char *text, const orr_leap_table *leap, orr_time *out, orr_diag *diag);
// A length of time, not negative: "900", "900s", "15min" (or "15m"), "2h", "1d", "0.1", "100ms", "us", "ns"
// -> nanoseconds.
orr_status orr_duration_parse(const char *text, int64_t *ns, orr_diag *diag);

#endif
