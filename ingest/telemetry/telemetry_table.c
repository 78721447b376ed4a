// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of numbers: what a table is, rows to places and angles on one clock or two.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/nan.h"
#include "core/robust.h"
#include "ingest/telemetry/telemetry_private.h"

// Bounds of clocks: until 2053, and 127 years (seconds since 1970 fit), so that sums and differences of two
// do too.
#define ROUND_NS (ORR_NS_PER_S / 100)
#define LAST_WEEK 3800.0
#define LAST_TIME_S 4e9
#define FAR_TIME "its time is out of all bounds"

typedef struct table_reader {
    telemetry_reader *r;
    telemetry_table table;
    char separator;
    bool scaled;   // units that nothing names have been looked at
    orr_time zero; // of the log's clock, from a comment; ORR_TIME_NONE
    bool have_base;
    orr_time base; // of GPS times: the first
    telemetry_clock host, tow;
    telemetry_ties ties;
    double last_gps_s;
    size_t n_gps;           // of places, one each
    double *gps_s;          // NAN: the row tells none
    size_t n_fast, n_moved; // places at one GPS time with the place before, and those of them that moved
    double period_s;        // of times that no date goes with
} table_reader;

// --- what a table is ---

// Fields of a row as numbers, as long as they are; -1 where a field is text.
static int count_numbers(orr_view line, char separator, double v[8])
{
    orr_view rest = line, field;
    int n = 0;
    while (telemetry_field(&rest, separator, &field)) {
        double x;
        orr_field f = telemetry_number(field, &x);
        if (f == ORR_FIELD_BLANK && rest.p == NULL && n > 0) break; // a separator at the end of the row
        if (f != ORR_FIELD_OK) {
            if (!telemetry_is_nan(field)) return -1;
            x = 0.0;
        }
        if (n < 8) v[n] = x;
        n++;
    }
    return n;
}

static orr_status known_shape(table_reader *t, orr_view line, orr_diag *diag)
{
    double v[8] = {0};
    int n = count_numbers(line, t->separator, v);
    orr_telemetry *out = t->r->out;
    const orr_input *in = t->r->in;
    const char *columns = NULL;
    if (n == 4) {
        double r = sqrt(v[1] * v[1] + v[2] * v[2] + v[3] * v[3]);
        out->kind = r > 6.0e6 && r < 1.0e8 ? ORR_TELEMETRY_MOTION_ECEF : ORR_TELEMETRY_MOTION_LLH;
        columns = out->kind == ORR_TELEMETRY_MOTION_ECEF ? "t,x,y,z" : "t,lat,lon,height";
    } else if (n == 7) {
        columns = "t,lat,lon,height,heading,pitch,roll";
    }
    if (columns == NULL)
        return orr_diag_at(
            diag, ORR_E_FORMAT, orr_input_name(in), orr_input_line_number(in), 0,
            n < 0 ? "the first row is neither a header of names nor numbers alone: declare the columns, e.g. "
                    "\"t[s],lat[deg],lon[deg],height[m],heading[deg],pitch[deg],roll[deg]\" (- skips one)"
                  : "rows of %d numbers without a header: declare the columns, e.g. "
                    "\"t[s],lat[deg],lon[deg],height[m],heading[deg],pitch[deg],roll[deg]\" (- skips one)",
            n);
    return telemetry_columns_parse(orr_view_of(columns), ',', false, NULL, 0, &t->table, NULL, diag);
}

static bool letter(char c) { return (c | 0x20) >= 'a' && (c | 0x20) <= 'z'; }

// A row of names: its first field begins with a letter, and it has no number.
static bool is_header(orr_view v, char separator)
{
    double v8[8];
    char c = v.p[0] == '"' ? v.p[v.n > 1 ? 1 : 0] : v.p[0];
    return letter(c) && count_numbers(v, separator, v8) < 0;
}

// "t in seconds after 2024-02-04T10:00:00 GPS" of 'orrery track', "...; t0 2024-02-04T10:00:00 GPS" of 'orrery imu'.
static bool zero_of_comment(orr_view comment, const orr_leap_table *leap, orr_time *zero)
{
    char text[256];
    orr_view_copy(comment, text, sizeof text);
    static const char *const before[] = {"seconds after ", "t0 "};
    for (size_t k = 0; k < 2; k++) {
        const char *p = strstr(text, before[k]);
        double of_day_s;
        if (p == NULL) continue;
        p += strlen(before[k]);
        size_t n = strcspn(p, ",;");
        if (telemetry_time_text(orr_view_trim((orr_view){p, n}), ORR_SCALE_GPS, leap, zero, &of_day_s) &&
            *zero != ORR_TIME_NONE && orr_time_is_near(*zero))
            return true;
    }
    return false;
}

static void say_again(table_reader *t, double period_s)
{
    orr_warnings_add(t->r->notes, orr_input_name(t->r->in), orr_input_line_number(t->r->in), 0,
                     "the seconds start again here: they are taken as those of the next %s",
                     period_s == TELEMETRY_DAY_S ? "day" : "week");
}

// The row's GPS time after the first one's, NAN where it tells none, and the time of the log's own clock, likewise.
// NULL, or why the row is to be left out.
static const char *times_of(table_reader *t, const telemetry_row *r, double *gps_s, double *host_s)
{
    const int *where = t->table.where;
    orr_time at = r->at;
    bool again;
    *gps_s = *host_s = ORR_NAN;
    if (r->has[Q_WEEK] && r->has[Q_TOW] && r->value[Q_WEEK] >= 1.0 && r->value[Q_WEEK] < LAST_WEEK &&
        r->value[Q_TOW] >= 0.0 && r->value[Q_TOW] < TELEMETRY_WEEK_S && at == ORR_TIME_NONE)
        at = orr_time_add_s(orr_time_from_week((int32_t)r->value[Q_WEEK], 0), r->value[Q_TOW]);
    double of_day_s = r->has[Q_OF_DAY] ? r->value[Q_OF_DAY] : r->of_day_s;
    if (!isnan(of_day_s) && !(fabs(of_day_s) < LAST_TIME_S)) return FAR_TIME;
    bool own = r->has[Q_TIME];
    if (r->has[Q_DATE] && at == ORR_TIME_NONE && (!isnan(of_day_s) || own)) {
        at = orr_time_add_s(orr_time_from_mjd(r->mjd, 0.0, ORR_SCALE_UTC, t->r->leap),
                            !isnan(of_day_s) ? of_day_s : r->value[Q_TIME]);
        of_day_s = ORR_NAN;
        own = false;
    }
    if (at != ORR_TIME_NONE && !orr_time_is_near(at)) return FAR_TIME;
    if (at != ORR_TIME_NONE) {
        if (!t->have_base && r->has[Q_WEEK] && r->value[Q_WEEK] < 1024.0 && r->at == ORR_TIME_NONE)
            orr_warnings_add(
                t->r->notes, orr_input_name(t->r->in), orr_input_line_number(t->r->in), 0,
                "GPS week %.0f is of %s: if the receiver counts weeks modulo 1024, add what is missing",
                r->value[Q_WEEK], r->value[Q_WEEK] < 521.0 ? "the 1980s" : "the 1990s");
        if (!t->have_base) t->base = at;
        t->have_base = true;
        *gps_s = orr_time_diff_s(at, t->base);
        if (!(fabs(*gps_s) < LAST_TIME_S)) return FAR_TIME;
    }
    if (own) {
        if (!(fabs(r->value[Q_TIME]) < LAST_TIME_S)) return FAR_TIME;
        *host_s = telemetry_clock_run(&t->host, r->value[Q_TIME], &again);
        if (again) say_again(t, t->host.period_s);
    } else if (!isnan(of_day_s)) {
        *host_s = telemetry_clock_run(&t->host, of_day_s, &again);
        if (again) say_again(t, TELEMETRY_DAY_S);
        t->period_s = TELEMETRY_DAY_S;
    } else if (where[Q_WEEK] < 0 && r->has[Q_TOW]) {
        if (!(r->value[Q_TOW] >= 0.0 && r->value[Q_TOW] <= TELEMETRY_WEEK_S)) return FAR_TIME;
        *host_s = telemetry_clock_run(&t->tow, r->value[Q_TOW], &again);
        t->period_s = TELEMETRY_WEEK_S;
    }
    if (isnan(*gps_s) && isnan(*host_s))
        return where[Q_WEEK] >= 0 && where[Q_TOW] >= 0 ? "its GPS week and seconds are no time"
                                                       : "it tells no time";
    return NULL;
}

static orr_status keep_place(table_reader *t, double host_s, double gps_s, orr_geodetic at, bool above_sea,
                             orr_diag *diag)
{
    orr_telemetry *out = t->r->out;
    size_t n = out->n_position;
    if (n > 0 && t->gps_s[n - 1] == gps_s) {
        const orr_geodetic *last = &out->position[n - 1];
        t->n_fast++;
        t->n_moved +=
            at.lat_rad != last->lat_rad || at.lon_rad != last->lon_rad || at.height_m != last->height_m;
    }
    if (!ORR_ARRAY_GROW(t->gps_s, t->n_gps))
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu rows", n);
    t->gps_s[t->n_gps++] = gps_s;
    orr_status s = telemetry_add_position(out, host_s, at, orr_input_line_number(t->r->in), diag);
    return s == ORR_OK && above_sea ? telemetry_mark_above_sea(t->r, diag) : s;
}

static orr_status take_row(table_reader *t, telemetry_row *r, orr_diag *diag)
{
    double gps_s, host_s;
    orr_geodetic at;
    bool place, above_sea;
    if (!t->scaled) t->scaled = telemetry_row_units(&t->table, t->r, r);
    const char *why = times_of(t, r, &gps_s, &host_s);
    if (why == NULL) why = telemetry_row_place(r, &at, &place, &above_sea);
    if (why != NULL) {
        telemetry_drop(t->r, why);
        return ORR_OK;
    }
    orr_status s = ORR_OK;
    // Rows that repeat a GPS time tell when they were written, not when it was.
    if (!isnan(gps_s) && !isnan(host_s) && (t->ties.n == 0 || gps_s != t->last_gps_s))
        s = telemetry_ties_add(&t->ties, host_s, gps_s, diag);
    t->last_gps_s = gps_s;
    double own_s = isnan(host_s) ? gps_s : host_s;
    if (s == ORR_OK && place) s = keep_place(t, own_s, gps_s, at, above_sea, diag);
    double h = r->has[Q_HEADING] ? r->value[Q_HEADING] : ORR_NAN,
           p = r->has[Q_PITCH] ? r->value[Q_PITCH] : ORR_NAN, q = r->has[Q_ROLL] ? r->value[Q_ROLL] : ORR_NAN;
    bool turned = r->has[Q_QW] && r->has[Q_QX] && r->has[Q_QY] && r->has[Q_QZ];
    bool angles = r->has[Q_HEADING] || r->has[Q_PITCH] || r->has[Q_ROLL];
    if (s == ORR_OK && !angles && turned) {
        angles = telemetry_row_turned(r, t->table.enu, &h, &p, &q);
        if (!angles) telemetry_drop(t->r, "its quaternion has not unit length");
    }
    return s == ORR_OK && angles
               ? telemetry_add_attitude(t->r->out, own_s, h, p, q, orr_input_line_number(t->r->in), diag)
               : s;
}

// --- the log ---

// Places onto GPS time, angles onto the line that ties the clocks.
static orr_status tie_clocks(table_reader *t, orr_diag *diag)
{
    orr_telemetry *out = t->r->out;
    double offset_s;
    orr_status s = telemetry_tie(&t->ties, &out->tie, &offset_s, diag);
    if (s != ORR_OK) return s;
    out->absolute = true;
    // A round zero, so that places at round GPS times have round seconds.
    orr_time zero = orr_time_add_s(t->base, offset_s);
    out->t0 = orr_floor_div(zero + ROUND_NS / 2, ROUND_NS) * ROUND_NS;
    out->tie.offset_s = orr_time_diff_s(zero, out->t0);
    double shift_s = orr_time_diff_s(t->base, out->t0);
    bool coarse = t->n_moved > out->n_position / 5;
    for (size_t k = 0; k < out->n_position; k++)
        out->position_t_s[k] = isnan(t->gps_s[k]) || coarse
                                   ? orr_clock_tied_s(&out->tie, out->position_t_s[k])
                                   : t->gps_s[k] + shift_s;
    for (size_t k = 0; k < out->n_attitude; k++)
        out->attitude_t_s[k] = orr_clock_tied_s(&out->tie, out->attitude_t_s[k]);
    if (coarse)
        orr_warnings_add(
            t->r->notes, orr_input_name(t->r->in), 0, 0,
            "GPS time is told too seldom for places of their own: they have the log's own clock, brought "
            "onto GPS time over the whole log");
    if (fabs(out->tie.drift) > 1e-3 || out->tie.scatter_s > 1.0)
        orr_warnings_add(
            t->r->notes, orr_input_name(t->r->in), 0, 0,
            "the log's two clocks do not go together (drift %.0f ppm, scatter %.2g s): are both in the "
            "right unit?",
            1e6 * out->tie.drift, out->tie.scatter_s);
    return ORR_OK;
}

// A number without a unit whose steps are whole and too long for its places to move in: milliseconds or microseconds.
static orr_status guess_clock(table_reader *t, orr_diag *diag)
{
    orr_telemetry *out = t->r->out;
    int column = t->table.where[Q_TIME];
    size_t n = out->n_position, kept = 0;
    if (column < 0 || !t->table.column[column].assumed || t->have_base || n < 8 || t->host.period_s > 0.0)
        return ORR_OK;
    double *step = malloc(2 * n * sizeof *step);
    if (step == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu rows", n);
    double *speed = step + n;
    bool whole = true;
    for (size_t k = 1; k < n; k++) {
        double d = out->position_t_s[k] - out->position_t_s[k - 1];
        whole = whole && telemetry_is_whole(out->position_t_s[k]);
        if (!(d > 0.0)) continue;
        orr_vec3 a = orr_earth_to_ecef(out->position[k - 1]), b = orr_earth_to_ecef(out->position[k]);
        step[kept] = d;
        speed[kept++] = orr_vec3_norm(orr_vec3_sub(b, a)) / d;
    }
    double step_s = kept > 0 ? orr_median(step, kept) : 0.0,
           speed_mps = kept > 0 ? orr_median(speed, kept) : 0.0;
    free(step);
    double unit = step_s >= 5000.0 ? 1e-6 : 1e-3;
    // No log of a flight has rows 10 s apart in which its body creeps; in the other unit it moves as bodies do.
    if (!whole || step_s < 10.0 || !(speed_mps > 0.0 && speed_mps < 0.3) || speed_mps / unit > 3000.0)
        return ORR_OK;
    for (size_t k = 0; k < n; k++) out->position_t_s[k] *= unit;
    for (size_t k = 0; k < out->n_attitude; k++) out->attitude_t_s[k] *= unit;
    orr_warnings_add(
        t->r->notes, orr_input_name(t->r->in), 0, 0,
        "the times name no unit; rows %.0f apart in which the body moves by %.2g m are taken as %s", step_s,
        step_s * speed_mps, unit < 1e-4 ? "microseconds" : "milliseconds");
    return ORR_OK;
}

static orr_status set_zero(table_reader *t, orr_diag *diag)
{
    orr_telemetry *out = t->r->out;
    orr_status s = guess_clock(t, diag);
    if (s != ORR_OK) return s;
    if (t->ties.n > 0) return tie_clocks(t, diag);
    if (t->have_base) {
        out->absolute = true;
        out->t0 = t->base;
    } else if (t->zero != ORR_TIME_NONE) {
        out->absolute = true;
        out->t0 = t->zero;
    } else {
        out->period_s = t->period_s > 0.0 ? t->period_s : t->host.period_s;
    }
    return ORR_OK;
}

// A line that is no row: a comment, which may say what the columns or the clock are.
static orr_status take_comment(table_reader *t, orr_view v, bool *declared, orr_diag *diag)
{
    orr_view rest = orr_view_trim((orr_view){v.p + 1, v.n - 1});
    if (t->zero == ORR_TIME_NONE && zero_of_comment(rest, t->r->leap, &t->zero)) return ORR_OK;
    if (*declared || !orr_view_starts(rest, "columns:")) return ORR_OK;
    rest.p += 8;
    rest.n -= 8;
    *declared = true;
    return telemetry_columns_parse(orr_view_trim(rest), ',', false, orr_input_name(t->r->in),
                                   orr_input_line_number(t->r->in), &t->table, NULL, diag);
}

static orr_status read_lines(table_reader *t, bool declared, orr_diag *diag)
{
    telemetry_reader *r = t->r;
    bool begun = false, tell_columns = declared;
    orr_view line;
    orr_status s = ORR_OK;
    while (s == ORR_OK && orr_input_line(r->in, &line)) {
        orr_view v = orr_view_trim(line);
        if (v.n == 0) continue;
        if (v.p[0] == '#') {
            s = take_comment(t, v, &tell_columns, diag);
            declared = declared || tell_columns;
            continue;
        }
        if (!begun && v.n == 5 && memcmp(v.p, "sep=", 4) == 0)
            continue; // a spreadsheet's note of its separator
        if (!begun) {
            begun = true;
            t->separator = telemetry_separator(v);
            bool header = is_header(v, t->separator);
            if (header && !declared)
                s = telemetry_columns_parse(v, t->separator, true, orr_input_name(r->in),
                                            orr_input_line_number(r->in), &t->table, r->notes, diag);
            else if (!declared)
                s = known_shape(t, v, diag);
            if (header || s != ORR_OK)
                continue; // a header above columns that were declared otherwise is passed over
        }
        telemetry_row fields;
        r->out->rows++;
        const char *why = telemetry_row_read(&t->table, t->separator, r->leap, v, &fields);
        if (why != NULL)
            telemetry_drop(r, why);
        else
            s = take_row(t, &fields, diag);
    }
    return s == ORR_OK ? orr_input_status(r->in, diag) : s;
}

orr_status telemetry_read_table(telemetry_reader *r, const char *columns, orr_diag *diag)
{
    table_reader *t = calloc(1, sizeof *t);
    if (t == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory");
    t->r = r;
    t->zero = ORR_TIME_NONE;
    orr_status s = ORR_OK;
    if (columns != NULL)
        s = telemetry_columns_parse(orr_view_of(columns), ',', false, NULL, 0, &t->table, NULL, diag);
    if (s == ORR_OK) s = read_lines(t, columns != NULL, diag);
    if (s == ORR_OK) s = set_zero(t, diag);
    telemetry_ties_free(&t->ties);
    free(t->gps_s);
    free(t);
    return s;
}
