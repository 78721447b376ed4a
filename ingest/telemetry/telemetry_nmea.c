// SPDX-License-Identifier: GPL-3.0-or-later
// NMEA 0183 sentences GGA and GNS (places), RMC and ZDA (dates), HDT and THS (headings), from any talker.
// Whatever stands before a sentence in its line (a stamp of the recorder, the end of a sentence that the log
// begins inside) is passed over.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/nan.h"
#include "core/vec.h"
#include "ingest/telemetry/telemetry_private.h"

#define MAX_FIELDS 40
#define HEAD_LINES 100 // looked at to know NMEA

static unsigned hex(char c)
{
    return c >= '0' && c <= '9'                     ? (unsigned)(c - '0')
           : (c | 0x20) >= 'a' && (c | 0x20) <= 'f' ? (unsigned)((c | 0x20) - 'a' + 10)
                                                    : 99u;
}

// The next sentence of a line with a good checksum, between '$' and '*'; what stands around it is passed over. Start
// with *at at the line's begin.
static bool sentence(orr_view line, const char **at, orr_view *body)
{
    const char *end = line.p + line.n;
    for (const char *dollar = *at; dollar < end; dollar++) {
        if (*dollar != '$') continue;
        unsigned sum = 0;
        const char *p = dollar + 1;
        while (p < end && *p != '*' && *p != '$') sum ^= (unsigned char)*p++;
        if (end - p < 3 || *p != '*') continue;
        unsigned high = hex(p[1]), low = hex(p[2]);
        if (high > 15 || low > 15 || sum != 16 * high + low) continue;
        *body = (orr_view){dollar + 1, (size_t)(p - dollar - 1)};
        *at = p + 3;
        return true;
    }
    return false;
}

// A sentence that ends with its line and has no checksum, which the standard allows for most.
static bool bare_sentence(orr_view line, const char **at, orr_view *body)
{
    const char *end = line.p + line.n, *dollar = memchr(*at, '$', (size_t)(end - *at));
    if (dollar == NULL || end - dollar < 8 || dollar[6] != ',' ||
        memchr(dollar, '*', (size_t)(end - dollar)) != NULL)
        return false;
    for (int k = 1; k < 6; k++)
        if (!(dollar[k] >= 'A' && dollar[k] <= 'Z')) return false;
    *body = (orr_view){dollar + 1, (size_t)(end - dollar - 1)};
    *at = end;
    return true;
}

// What the first lines are of: sentences with checksums (any is enough), or none of these and bare ones for the most part.
typedef enum head_kind { HEAD_OTHER, HEAD_CHECKED, HEAD_BARE } head_kind;

static head_kind kind_of(orr_view head)
{
    orr_cursor c;
    orr_view line, body;
    int lines = 0, bare = 0;
    orr_cursor_init(&c, "", head.p, head.n);
    while (lines < HEAD_LINES && orr_cursor_next(&c, &line)) {
        orr_view t = orr_view_trim(line);
        if (t.n == 0) continue;
        if (lines++ == 0 && (t.p[0] == '$' || t.p[0] == '!') && memchr(t.p, '*', t.n) != NULL)
            return HEAD_CHECKED;
        const char *at = line.p;
        if (sentence(line, &at, &body) && body.n >= 6 && body.p[5] == ',') return HEAD_CHECKED;
        at = line.p;
        bare += bare_sentence(line, &at, &body);
    }
    return bare >= 2 && bare > lines / 2 ? HEAD_BARE : HEAD_OTHER;
}

bool telemetry_is_nmea(orr_view head) { return kind_of(head) != HEAD_OTHER; }

// hhmmss.ss to seconds of the day; the 60th second is 86400 and more.
static bool time_of_day(orr_view f, double *s)
{
    int h, m;
    double sec;
    if (f.n < 6 || orr_field_int_in(f, 1, 2, 0, 23, &h) != ORR_FIELD_OK ||
        orr_field_int_in(f, 3, 2, 0, 59, &m) != ORR_FIELD_OK ||
        orr_field_real(f, 5, (int)f.n - 4, &sec) != ORR_FIELD_OK || !(sec >= 0.0 && sec < 61.0) ||
        (sec >= 60.0 && (h != 23 || m != 59)))
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

// GGA: time, latitude, longitude, quality, satellites, HDOP, height, M, separation of the geoid, M.
// GNS: the same with modes of the systems ("AAN") for the quality, and no units.
static bool take_place(const orr_view *f, size_t n, bool gns, nmea_event *e)
{
    size_t separation = gns ? 10 : 11;
    double h, geoid = 0.0;
    int quality = 0;
    if (n < 10 || !time_of_day(f[1], &e->tod_s) || !angle(f[2], f[3], 90, &e->at.lat_rad) ||
        !angle(f[4], f[5], 180, &e->at.lon_rad) || orr_view_real(f[9], &h) != ORR_FIELD_OK)
        return false;
    if (gns) {
        for (size_t k = 0; k < f[6].n; k++) quality |= f[6].p[k] != 'N';
    } else if (orr_field_int_in(f[6], 1, (int)f[6].n, 0, 9, &quality) != ORR_FIELD_OK) {
        return false;
    }
    if (quality == 0) return false;
    orr_field told = n > separation ? orr_view_real(f[separation], &geoid) : ORR_FIELD_BLANK;
    if (told == ORR_FIELD_BAD) return false;
    e->above_sea = told == ORR_FIELD_BLANK;
    e->at.height_m = h + geoid;
    e->place = true;
    return true;
}

static bool day_of(int year, int month, int day, int32_t *mjd)
{
    int y, m, d;
    *mjd = orr_mjd_from_date(year, month, day);
    orr_date_from_mjd(*mjd, &y, &m, &d);
    return y == year && m == month && d == day;
}

// RMC: time, status (A valid, V warning), ..., ddmmyy in field 9, mode (N not valid) in field 12.
static bool take_rmc(const orr_view *f, size_t n, nmea_event *e)
{
    int d, m, y;
    if (n < 10 || !orr_view_equals(f[2], "A") || (n > 12 && orr_view_equals(f[12], "N")) ||
        !time_of_day(f[1], &e->tod_s) || f[9].n != 6 ||
        orr_field_int_in(f[9], 1, 2, 1, 31, &d) != ORR_FIELD_OK ||
        orr_field_int_in(f[9], 3, 2, 1, 12, &m) != ORR_FIELD_OK ||
        orr_field_int_in(f[9], 5, 2, 0, 99, &y) != ORR_FIELD_OK)
        return false; // no date, or no fix: a receiver without one tells the date it was switched on with
    return day_of(y < 80 ? 2000 + y : 1900 + y, m, d, &e->mjd);
}

// ZDA: time, day, month, year. It has no status.
static bool take_zda(const orr_view *f, size_t n, nmea_event *e)
{
    int d, m, y;
    if (n < 5 || !time_of_day(f[1], &e->tod_s) ||
        orr_field_int_in(f[2], 1, (int)f[2].n, 1, 31, &d) != ORR_FIELD_OK ||
        orr_field_int_in(f[3], 1, (int)f[3].n, 1, 12, &m) != ORR_FIELD_OK ||
        orr_field_int_in(f[4], 1, (int)f[4].n, 1980, 2200, &y) != ORR_FIELD_OK)
        return false;
    e->doubtful = true;
    return day_of(y, m, d, &e->mjd);
}

static orr_status add_event(nmea_log *log, const nmea_event *e, orr_diag *diag)
{
    if (log->n >= 2 * ORR_TELEMETRY_MAX_ROWS)
        return orr_diag_set(diag, ORR_E_LIMIT, "more than %zu rows of telemetry", log->n);
    if (!ORR_ARRAY_GROW(log->event, log->n))
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu sentences", log->n);
    log->event[log->n++] = *e;
    return ORR_OK;
}

// What a log has of one kind: sentences of the other are not needed.
typedef struct seen {
    nmea_log log;
    bool gga; // then GNS repeats what GGA says
    size_t last_place, n_places;
} seen;

static orr_status take(telemetry_reader *r, const orr_view *f, size_t n, seen *st, orr_diag *diag)
{
    orr_view kind = {f[0].p + 2, 3};
    nmea_event e = {.line = orr_input_line_number(r->in), .heading_rad = ORR_NAN};
    bool gns = orr_view_equals(kind, "GNS"), gga = orr_view_equals(kind, "GGA");
    if (gga || (gns && !st->gga)) {
        if (!take_place(f, n, gns, &e)) {
            telemetry_drop(r, "it has no position fix, or a field that is none");
            return ORR_OK;
        }
        if (gga && !st->gga && st->n_places > 0) { // places of GNS until here: GGA has them too from here on
            st->gga = true;
            if (st->log.event[st->last_place].tod_s == e.tod_s) return ORR_OK;
        }
        st->gga = st->gga || gga;
        st->last_place = st->log.n;
        st->n_places++;
        return add_event(&st->log, &e, diag);
    }
    if ((orr_view_equals(kind, "RMC") && take_rmc(f, n, &e)) ||
        (orr_view_equals(kind, "ZDA") && take_zda(f, n, &e)))
        return add_event(&st->log, &e, diag);
    if ((orr_view_equals(kind, "HDT") || orr_view_equals(kind, "THS")) && st->n_places > 0 && n >= 2) {
        double heading;
        if (orr_view_equals(kind, "THS") && n > 2 && orr_view_equals(f[2], "V")) return ORR_OK;
        if (orr_view_real(f[1], &heading) != ORR_FIELD_OK || !(fabs(heading) <= 360.0)) {
            telemetry_drop(r, "its heading is no angle");
            return ORR_OK;
        }
        // A heading has no time: it is that of the place before it.
        st->log.event[st->last_place].heading_rad = heading * ORR_RAD_PER_DEG;
    }
    return ORR_OK;
}

static orr_status keep(telemetry_reader *r, const nmea_log *log, orr_diag *diag)
{
    orr_status s = ORR_OK;
    for (size_t k = 0; k < log->n && s == ORR_OK; k++) {
        const nmea_event *e = &log->event[k];
        if (!e->place) continue;
        s = telemetry_add_position(r->out, e->t_s, e->at, e->line, diag);
        if (s == ORR_OK && e->above_sea) s = telemetry_mark_above_sea(r, diag);
        if (s == ORR_OK && !isnan(e->heading_rad))
            s = telemetry_add_attitude(r->out, e->t_s, e->heading_rad, ORR_NAN, ORR_NAN, e->line, diag);
    }
    return s;
}

orr_status telemetry_read_nmea(telemetry_reader *r, orr_diag *diag)
{
    seen st = {0};
    orr_view line, body;
    orr_status s = ORR_OK;
    bool (*const next)(orr_view, const char **, orr_view *) =
        kind_of(orr_input_head(r->in)) == HEAD_BARE ? bare_sentence : sentence;
    if (next == bare_sentence)
        orr_warnings_add(r->notes, orr_input_name(r->in), 1, 0,
                         "its sentences have no checksums: they are taken as they are");
    while (s == ORR_OK && orr_input_line(r->in, &line)) {
        if (orr_view_is_blank(line)) continue;
        r->out->rows++;
        const char *at = line.p;
        if (!next(line, &at, &body)) {
            telemetry_drop(r, orr_input_line_number(r->in) == 1 && memchr(line.p, '$', line.n) == NULL
                                  ? "the log begins inside a sentence"
                                  : "its checksum is wrong or missing");
            continue;
        }
        do {
            orr_view f[MAX_FIELDS], rest = body;
            size_t n = 0;
            while (n < MAX_FIELDS && orr_view_split(&rest, ',', &f[n])) n++;
            if (n > 0 && f[0].n == 5) s = take(r, f, n, &st, diag);
        } while (s == ORR_OK && next(line, &at, &body));
    }
    if (s == ORR_OK) s = orr_input_status(r->in, diag);
    if (s == ORR_OK) s = telemetry_dates(&st.log, r, diag);
    if (s == ORR_OK) s = keep(r, &st.log, diag);
    free(st.log.event);
    return s;
}
