// SPDX-License-Identifier: GPL-3.0-or-later
// NMEA 0183 sentences GGA (place), RMC (date) and HDT (heading), from any talker.
#include <math.h>
#include <string.h>

#include "core/nan.h"
#include "core/vec.h"
#include "ingest/telemetry/telemetry_private.h"

#define MAX_FIELDS 40

typedef struct nmea_state {
    bool dated, have_base;
    int32_t mjd;          // day of the last RMC
    double day_s, last_s; // times of day run on over midnight: seconds since the first sentence's day
    double base_s;
} nmea_state;

// Between '$' and '*'; false where the checksum is wrong or missing.
static bool sentence(orr_view line, orr_view *body)
{
    const char *dollar = memchr(line.p, '$', line.n);
    if (dollar == NULL) return false;
    line.n -= (size_t)(dollar + 1 - line.p);
    line.p = dollar + 1;
    const char *star = memchr(line.p, '*', line.n);
    if (star == NULL || line.n - (size_t)(star - line.p) < 3) return false;
    unsigned sum = 0, said = 0;
    for (const char *p = line.p; p < star; p++) sum ^= (unsigned char)*p;
    for (int k = 1; k <= 2; k++) {
        char c = star[k];
        unsigned d = c >= '0' && c <= '9'                     ? (unsigned)(c - '0')
                     : (c | 0x20) >= 'a' && (c | 0x20) <= 'f' ? (unsigned)((c | 0x20) - 'a' + 10)
                                                              : 99u;
        if (d == 99u) return false;
        said = 16 * said + d;
    }
    *body = (orr_view){line.p, (size_t)(star - line.p)};
    return sum == said;
}

// hhmmss.ss to seconds of the day.
static bool time_of_day(orr_view f, double *s)
{
    int h, m;
    double sec;
    if (f.n < 6 || orr_field_int_in(f, 1, 2, 0, 23, &h) != ORR_FIELD_OK ||
        orr_field_int_in(f, 3, 2, 0, 59, &m) != ORR_FIELD_OK ||
        orr_field_real(f, 5, (int)f.n - 4, &sec) != ORR_FIELD_OK || !(sec >= 0.0 && sec < 61.0))
        return false;
    *s = 3600.0 * h + 60.0 * m + sec;
    return true;
}

// (d)ddmm.mmmm with its hemisphere, to radians.
static bool angle(orr_view f, orr_view hemisphere, double limit_deg, double *rad)
{
    double v;
    if (hemisphere.n != 1 || orr_view_real(f, &v) != ORR_FIELD_OK || v < 0.0) return false;
    double deg = floor(v / 100.0), minutes = v - 100.0 * deg;
    deg += minutes / 60.0;
    char c = hemisphere.p[0];
    if (minutes >= 60.0 || deg > limit_deg || strchr(limit_deg > 100 ? "EW" : "NS", c) == NULL) return false;
    *rad = (c == 'S' || c == 'W' ? -deg : deg) * ORR_RAD_PER_DEG;
    return true;
}

// Seconds since the first sentence, over midnight too.
static double running(nmea_state *st, double s)
{
    if (st->have_base && s + st->day_s < st->last_s - 43200.0) st->day_s += 86400.0;
    s += st->day_s;
    if (!st->have_base) st->base_s = s;
    st->have_base = true;
    st->last_s = s;
    return s - st->base_s;
}

static orr_status take_rmc(const orr_view *f, size_t n, nmea_state *st, orr_telemetry *out)
{
    int d, m, y;
    double s;
    if (n < 10 || st->dated || !time_of_day(f[1], &s) ||
        orr_field_int_in(f[9], 1, 2, 1, 31, &d) != ORR_FIELD_OK ||
        orr_field_int_in(f[9], 3, 2, 1, 12, &m) != ORR_FIELD_OK ||
        orr_field_int_in(f[9], 5, 2, 0, 99, &y) != ORR_FIELD_OK)
        return ORR_OK; // no date yet (no fix), or one that is known already
    orr_civil c = {.year = y < 80 ? 2000 + y : 1900 + y,
                   .month = m,
                   .day = d,
                   .hour = (int)(s / 3600.0),
                   .minute = (int)(fmod(s, 3600.0) / 60.0)};
    orr_time t;
    if (orr_time_from_civil(&c, ORR_SCALE_UTC, NULL, &t) != ORR_OK) return ORR_OK;
    st->dated = true;
    double since = running(st, s); // this sentence's running time is the instant just made, plus its seconds
    out->absolute = true;
    out->t0 = orr_time_add_s(t, fmod(s, 60.0) - since);
    return ORR_OK;
}

orr_status telemetry_read_nmea(orr_input *in, orr_telemetry *out, orr_warnings *w, orr_diag *diag)
{
    nmea_state st = {0};
    orr_view line, body;
    orr_status s = ORR_OK;
    double now_s = 0.0;
    bool timed = false;
    while (s == ORR_OK && orr_input_line(in, &line)) {
        if (orr_view_is_blank(line)) continue;
        out->rows++;
        if (!sentence(line, &body)) {
            telemetry_drop(out, in, w, "its checksum is wrong or missing");
            continue;
        }
        orr_view f[MAX_FIELDS], rest = body;
        size_t n = 0;
        while (n < MAX_FIELDS && orr_view_split(&rest, ',', &f[n])) n++;
        if (n == 0 || f[0].n != 5) continue;
        orr_view kind = {f[0].p + 2, 3};
        double a, lat, lon, h, geoid = 0.0, heading;
        int quality;
        if (orr_view_equals(kind, "GGA")) {
            if (n < 12 || !time_of_day(f[1], &a) || !angle(f[2], f[3], 90, &lat) ||
                !angle(f[4], f[5], 180, &lon) ||
                orr_field_int_in(f[6], 1, (int)f[6].n, 0, 9, &quality) != ORR_FIELD_OK || quality == 0 ||
                orr_view_real(f[9], &h) != ORR_FIELD_OK || orr_view_real(f[11], &geoid) == ORR_FIELD_BAD) {
                telemetry_drop(out, in, w, "it has no position fix, or a field that is none");
                continue;
            }
            now_s = running(&st, a);
            timed = true;
            s = telemetry_add_position(out, now_s, (orr_geodetic){lat, lon, h + geoid},
                                       orr_input_line_number(in), diag);
        } else if (orr_view_equals(kind, "RMC")) {
            s = take_rmc(f, n, &st, out);
        } else if (orr_view_equals(kind, "HDT") && timed && n >= 2) {
            if (orr_view_real(f[1], &heading) != ORR_FIELD_OK || !(fabs(heading) <= 360.0)) {
                telemetry_drop(out, in, w, "its heading is no angle");
                continue;
            }
            s = telemetry_add_attitude(out, now_s, heading * ORR_RAD_PER_DEG, ORR_NAN, ORR_NAN,
                                       orr_input_line_number(in), diag);
        }
    }
    return s == ORR_OK ? orr_input_status(in, diag) : s;
}
