// SPDX-License-Identifier: GPL-3.0-or-later
// Dates of a log of sentences that tell the time of day alone. The log is divided into sessions, stretches over
// which the time of day runs on; each session has the date that most of its dated sentences agree on, and what
// contradicts is told.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/array.h"
#include "core/nan.h"
#include "ingest/telemetry/telemetry_private.h"

#define LEAST_RUN 3           // dates that agree, one after the other, are no slip
#define ROLLOVER_DAYS 7168    // 1024 weeks: what a receiver is off by that lost count of the GPS week
#define LONGEST_PAUSE_S 600.0 // within a session
#define LAST_DAY 36525
#define BACK_S 5.0 // sentences of an epoch may be out of order

typedef struct session {
    size_t from, to; // events
    bool dated;
    int32_t
        mjd; // of the day that the session begins on; without a date, of the day counted from the log's first
    double begin_s, end_s; // seconds of the first and the last event, from that day's midnight on
    orr_time begin;        // to sort by
} session;

// Whether a date stood still over a midnight that the times of day passed: what a recorder writes that looked at
// the calendar once. Such dates count for nothing.
//   Given:    day, mjd   of the dated event: midnights since the begin of its session, and its date
//             last_day, last_mjd   of the last date that counted
static bool stood_still(int32_t day, int32_t mjd, int32_t last_day, int32_t last_mjd)
{
    return day > last_day && mjd == last_mjd;
}

typedef struct sessions {
    size_t n;
    session *item;
    int32_t *day; // of each event since its session's begin: midnights passed
} sessions;

static orr_status open_session(sessions *s, size_t at, orr_diag *diag)
{
    if (!ORR_ARRAY_GROW(s->item, s->n))
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu sessions", s->n);
    s->item[s->n++] = (session){.from = at, .to = at};
    return ORR_OK;
}

// Cuts where the time of day does not run on; the days are counted within each session.
static orr_status divide(const nmea_log *log, sessions *out, const telemetry_reader *r, orr_diag *diag)
{
    orr_status s = ORR_OK;
    int32_t day = 0;
    for (size_t k = 0; k < log->n && s == ORR_OK; k++) {
        const nmea_event *e = &log->event[k];
        double step = k > 0 ? e->tod_s - log->event[k - 1].tod_s : 0.0;
        int32_t midnight = step < -0.5 * TELEMETRY_DAY_S ? 1 : step > 0.5 * TELEMETRY_DAY_S ? -1 : 0;
        step += midnight * TELEMETRY_DAY_S;
        if (k == 0 || step < -BACK_S || step > LONGEST_PAUSE_S) {
            s = open_session(out, k, diag);
            if (s != ORR_OK) return s;
            day = midnight = 0;
        }
        day += midnight;
        if (abs(day) > LAST_DAY)
            return orr_diag_at(diag, ORR_E_LIMIT, orr_input_name(r->in), e->line, 0,
                               "the log passes midnight more than %d times; its times of day are no clock's",
                               LAST_DAY);
        out->day[k] = day;
        out->item[out->n - 1].to = k + 1;
    }
    return s;
}

// The day that a dated event says its session begins on.
static int32_t base_of(const nmea_log *log, const sessions *s, size_t k)
{
    return log->event[k].mjd - s->day[k];
}

// A pause of whole days leaves the time of day running on: the dates tell. Cuts a session where they step forward
// and agree on both sides.
static orr_status cut_whole_days(const nmea_log *log, sessions *s, orr_diag *diag)
{
    sessions out = {.day = s->day};
    orr_status status = ORR_OK;
    for (size_t i = 0; i < s->n && status == ORR_OK; i++) {
        status = open_session(&out, s->item[i].from, diag);
        size_t run = 0, held = 0, first = s->item[i].from, last = SIZE_MAX;
        int32_t base = 0, before = 0; // of the run now, and of the run that the session has
        for (size_t k = s->item[i].from; k < s->item[i].to && status == ORR_OK; k++) {
            if (log->event[k].place || log->event[k].doubtful) continue;
            if (run > 0 && base_of(log, s, k) == base) {
                run++;
            } else {
                if (run >= LEAST_RUN) {
                    before = base;
                    held = run;
                }
                base = base_of(log, s, k);
                run = 1;
                first = k;
                // Places of the same epoch stand before their date or behind it.
                bool paired = last != SIZE_MAX && log->event[last].tod_s == log->event[k].tod_s;
                while (!paired && first > out.item[out.n - 1].from + 1 &&
                       log->event[first - 1].tod_s == log->event[k].tod_s)
                    first--;
            }
            last = k;
            if (run == LEAST_RUN && held >= LEAST_RUN && base > before &&
                (base - before) % ROLLOVER_DAYS != 0) {
                out.item[out.n - 1].to = first;
                status = open_session(&out, first, diag);
                held = 0;
            }
        }
        if (status == ORR_OK) out.item[out.n - 1].to = s->item[i].to;
    }
    free(s->item);
    s->item = out.item;
    s->n = out.n;
    return status;
}

static void date_words(int32_t mjd, char text[40])
{
    int y, m, d;
    orr_date_from_mjd(mjd, &y, &m, &d);
    snprintf(text, 40, "%04d-%02d-%02d", y, m, d);
}

static int ascending(const void *a, const void *b)
{
    int32_t x = *(const int32_t *)a, y = *(const int32_t *)b;
    return (x > y) - (x < y);
}

// The date that most sentences of a session agree on; those without a status count where no others are.
static orr_status vote(const nmea_log *log, const sessions *s, session *q, telemetry_reader *r,
                       orr_diag *diag)
{
    size_t sure = 0, all = 0;
    for (size_t k = q->from; k < q->to; k++) {
        if (log->event[k].place) continue;
        all++;
        sure += !log->event[k].doubtful;
    }
    if (all == 0) return ORR_OK;
    bool doubtful = sure == 0;
    int32_t *base = malloc(all * sizeof *base);
    if (base == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu dates", all);
    size_t n = 0;
    const nmea_event *last = NULL;
    int32_t last_day = 0;
    for (size_t k = q->from; k < q->to; k++) {
        const nmea_event *e = &log->event[k];
        if (e->place || e->doubtful != doubtful) continue;
        if (last != NULL && stood_still(s->day[k], e->mjd, last_day, last->mjd)) continue;
        base[n++] = base_of(log, s, k);
        last = e;
        last_day = s->day[k];
    }
    qsort(base, n, sizeof *base, ascending);
    size_t best = 0;
    for (size_t k = 0; k < n;) {
        size_t e = k;
        while (e < n && base[e] == base[k]) e++;
        if (e - k >= best) { // of equals the later: a clock that is not set yet shows an early date
            best = e - k;
            q->mjd = base[k];
        }
        k = e;
    }
    q->dated = true;
    free(base);
    if (best == (doubtful ? all : sure)) return ORR_OK;
    for (size_t k = q->from; k < q->to; k++) {
        const nmea_event *e = &log->event[k];
        if (e->place || e->doubtful != doubtful || base_of(log, s, k) == q->mjd) continue;
        char says[40], agreed[40];
        date_words(e->mjd, says);
        date_words(q->mjd + s->day[k], agreed);
        orr_warnings_add(r->notes, orr_input_name(r->in), e->line, 0,
                         "the dates contradict: it says %s; %zu of %zu sentences say %s, which is used", says,
                         best, n, agreed);
        break;
    }
    return ORR_OK;
}

// Seconds from the midnight that a session begins behind; a leap second whose day nothing tells is counted.
static double since_midnight(const nmea_log *log, const sessions *s, size_t k)
{
    return log->event[k].tod_s + TELEMETRY_DAY_S * s->day[k];
}

static double passed_since(const session *before, const session *q)
{
    return TELEMETRY_DAY_S * (q->mjd - before->mjd) + q->begin_s - before->end_s;
}

static bool has_places(const nmea_log *log, const session *q)
{
    for (size_t k = q->from; k < q->to; k++)
        if (log->event[k].place) return true;
    return false;
}

// Whether two sessions are one flight that the log tells twice, its places in one block and its dates in another: they share
// their times of day, and one of them has no places.
static bool one_flight(const nmea_log *log, const session *a, const session *b)
{
    return a->begin_s <= b->end_s && b->begin_s <= a->end_s && !(has_places(log, a) && has_places(log, b));
}

// Sessions without a date follow the one before, or precede the one behind, as soon as their times of day let them.
static void date_the_others(sessions *s, telemetry_reader *r, const nmea_log *log)
{
    size_t first = 0;
    while (first < s->n && !s->item[first].dated) first++;
    bool any = first < s->n;
    for (size_t i = any ? first : 0; i < s->n; i++) {
        session *q = &s->item[i];
        if (q->dated || (!any && i == 0)) continue;
        q->mjd = s->item[i - 1].mjd;
        while (passed_since(&s->item[i - 1], q) < 0.0 && !one_flight(log, &s->item[i - 1], q)) q->mjd++;
    }
    for (size_t i = first; any && i-- > 0;) {
        session *q = &s->item[i];
        q->mjd = s->item[i + 1].mjd;
        while (passed_since(q, &s->item[i + 1]) < 0.0 && !one_flight(log, q, &s->item[i + 1])) q->mjd--;
    }
    for (size_t i = 0; any && i < s->n; i++) {
        session *q = &s->item[i];
        if (q->dated) continue;
        char text[40];
        date_words(q->mjd, text);
        orr_warnings_add(
            r->notes, orr_input_name(r->in), log->event[q->from].line, 0,
            "no sentence dates the session that begins here: %s is assumed, from the session %s it", text,
            i < first ? "behind" : "before");
        q->dated = true;
    }
}

static int by_time(const void *a, const void *b)
{
    const session *x = a, *y = b;
    if (x->begin != y->begin) return x->begin < y->begin ? -1 : 1;
    return (x->from > y->from) - (x->from < y->from);
}

// Events in the order of time, session by session.
static orr_status sort(nmea_log *log, const sessions *s, orr_diag *diag)
{
    nmea_event *sorted = malloc(log->n * sizeof *sorted);
    if (sorted == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu sentences", log->n);
    size_t n = 0;
    for (size_t i = 0; i < s->n; i++)
        for (size_t k = s->item[i].from; k < s->item[i].to; k++) sorted[n++] = log->event[k];
    free(log->event);
    log->event = sorted;
    return ORR_OK;
}

// Instants of a log that has dates.
static orr_status date_events(nmea_log *log, sessions *s, telemetry_reader *r, orr_diag *diag)
{
    orr_time zero = ORR_TIME_NONE;
    int64_t past_table = 0;
    bool ordered = true;
    for (size_t i = 0; i < s->n; i++) {
        session *q = &s->item[i];
        q->begin = orr_time_add_s(orr_time_from_mjd(q->mjd, 0.0, ORR_SCALE_UTC, r->leap), q->begin_s);
        ordered = ordered && (i == 0 || q->begin >= s->item[i - 1].begin);
        if (zero == ORR_TIME_NONE || q->begin < zero) zero = q->begin;
    }
    for (size_t i = 0; i < s->n; i++)
        for (size_t k = s->item[i].from; k < s->item[i].to; k++) {
            nmea_event *e = &log->event[k];
            int32_t mjd = s->item[i].mjd + s->day[k];
            orr_time midnight = orr_time_from_mjd(mjd, 0.0, ORR_SCALE_UTC, r->leap);
            orr_time at = orr_time_add_s(midnight, e->tod_s);
            if (e->tod_s >= TELEMETRY_DAY_S && past_table == 0 &&
                at >= orr_time_from_mjd(mjd + 1, 0.0, ORR_SCALE_UTC, r->leap))
                past_table = e->line;
            e->t_s = orr_time_diff_s(at, zero);
        }
    if (past_table > 0)
        orr_warnings_add(
            r->notes, orr_input_name(r->in), past_table, 0,
            "it tells a 60th second, and the table of leap seconds has none on that day: the seconds "
            "before and behind it cannot both be right");
    r->out->absolute = true;
    r->out->t0 = zero;
    if (ordered) return ORR_OK;
    qsort(s->item, s->n, sizeof *s->item, by_time);
    return sort(log, s, diag);
}

// Seconds of an unknown day, with the leap seconds that the log itself shows.
static void count_events(nmea_log *log, const sessions *s, telemetry_reader *r)
{
    double leaps = 0.0;
    bool within = false;
    for (size_t i = 0; i < s->n; i++)
        for (size_t k = s->item[i].from; k < s->item[i].to; k++) {
            nmea_event *e = &log->event[k];
            if (within && e->tod_s < 0.5 * TELEMETRY_DAY_S) {
                leaps += 1.0;
                within = false;
            }
            within = within || e->tod_s >= TELEMETRY_DAY_S;
            e->t_s = since_midnight(log, s, k) + TELEMETRY_DAY_S * s->item[i].mjd + leaps;
        }
    r->out->period_s = TELEMETRY_DAY_S;
}

orr_status telemetry_dates(nmea_log *log, telemetry_reader *r, orr_diag *diag)
{
    if (log->n == 0) return ORR_OK;
    sessions s = {.day = malloc(log->n * sizeof *s.day)};
    if (s.day == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu sentences", log->n);
    orr_status status = divide(log, &s, r, diag);
    if (status == ORR_OK) status = cut_whole_days(log, &s, diag);
    bool dated = false;
    for (size_t i = 0; i < s.n && status == ORR_OK; i++) {
        session *q = &s.item[i];
        // Days are counted from the session's first event, wherever it was cut.
        int32_t from = s.day[q->from];
        for (size_t k = q->from; k < q->to; k++) s.day[k] -= from;
        q->begin_s = since_midnight(log, &s, q->from);
        q->end_s = since_midnight(log, &s, q->to - 1);
        status = vote(log, &s, q, r, diag);
        dated = dated || q->dated;
    }
    if (status == ORR_OK) {
        date_the_others(&s, r, log);
        if (dated)
            status = date_events(log, &s, r, diag);
        else
            count_events(log, &s, r);
    }
    free(s.item);
    free(s.day);
    return status;
}
