// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/telemetry/telemetry.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "core/robust.h"
#include "ingest/telemetry/telemetry_private.h"

void orr_telemetry_free(orr_telemetry *t)
{
    free(t->position_t_s);
    free(t->position);
    free(t->position_line);
    free(t->attitude_t_s);
    free(t->heading_rad);
    free(t->pitch_rad);
    free(t->roll_rad);
    free(t->attitude_line);
    memset(t, 0, sizeof *t);
}

static char separator_of(orr_view line)
{
    for (const char *s = ",;\t"; *s != '\0'; s++)
        if (memchr(line.p, *s, line.n) != NULL) return *s == '\t' ? ' ' : *s;
    return ' ';
}

// Fields of a row as numbers, as long as they are; -1 where a field is text.
static int count_numbers(orr_view line, char separator, double v[8])
{
    orr_view rest = line, field;
    int n = 0;
    while (telemetry_field(&rest, separator, &field)) {
        double x;
        orr_field f = orr_view_real(field, &x);
        if (f == ORR_FIELD_BLANK && rest.n == 0 && n > 0) break; // a separator at the end of the row
        if (f != ORR_FIELD_OK) {
            char word[8];
            orr_view_copy(field, word, sizeof word);
            for (char *p = word; *p != '\0'; p++) *p = (char)(*p | 0x20);
            if (strcmp(word, "nan") != 0) return -1;
            x = 0.0;
        }
        if (n < 8) v[n] = x;
        n++;
    }
    return n;
}

static orr_status known_shape(orr_view line, char separator, const orr_input *in, orr_telemetry *out,
                              telemetry_table *table, orr_diag *diag)
{
    double v[8] = {0};
    int n = count_numbers(line, separator, v);
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
            "rows of %d numbers without a header: declare the columns, e.g. "
            "\"t[s],lat[deg],lon[deg],height[m],heading[deg],pitch[deg],roll[deg]\" (- skips one)",
            n);
    return telemetry_columns_parse(orr_view_of(columns), ',', false, NULL, 0, table, NULL, diag);
}

typedef struct row {
    bool has[Q_COUNT];
    double value[Q_COUNT];
    bool timed;
    orr_time time;
} row;

// Reads a row's fields; NULL, or why the row is to be left out.
static const char *read_row(orr_view line, char separator, const telemetry_table *table, row *r)
{
    memset(r, 0, sizeof *r);
    orr_view rest = line, field;
    size_t n = 0;
    for (; n < table->n && telemetry_field(&rest, separator, &field); n++) {
        const telemetry_column *c = &table->column[n];
        if (c->quantity == Q_SKIP) continue;
        if (c->time_text != 0) {
            char text[64];
            size_t len = field.n < 40 ? field.n : 40;
            memcpy(text, field.p, len);
            strcpy(text + len, c->time_text == 1 && (len == 0 || text[len - 1] != 'Z') ? "Z" : "");
            if (orr_time_parse(text, NULL, &r->time, NULL) != ORR_OK)
                return "its time is no ISO 8601 date and time";
            r->timed = true;
            continue;
        }
        double x;
        if (orr_view_real(field, &x) != ORR_FIELD_OK) return "a field is no finite number";
        r->value[c->quantity] = c->quantity == Q_FIX ? x : x * c->scale;
        r->has[c->quantity] = true;
        if (c->quantity == Q_FIX && x < c->scale) return "it has no position fix";
    }
    return n < table->n ? "it has too few fields" : NULL;
}

typedef struct table_state {
    bool have_base;
    orr_time base; // of ISO times
    // GPS week and seconds against the file's own clock: the first pairs, whose median ties the two
    size_t n_ties;
    double tie_s[1001];
    orr_time tie_origin;
} table_state;

// Bounds of clocks: until 2053, and 127 years (seconds since 1970 fit), so that sums and differences of two
// do too.
#define LAST_WEEK 3800.0
#define LAST_TIME_S 4e9
#define FAR_TIME "its time is out of all bounds"

static orr_status take_row(const row *r, const telemetry_table *table, const orr_input *in, table_state *st,
                           orr_telemetry *out, orr_warnings *w, orr_diag *diag)
{
    int64_t line = orr_input_line_number(in);
    double t_s = r->value[Q_TIME];
    orr_time week_time = ORR_TIME_NONE;
    if (r->has[Q_WEEK] && r->has[Q_TOW] && r->value[Q_WEEK] >= 1.0 && r->value[Q_WEEK] < LAST_WEEK &&
        r->value[Q_TOW] >= 0.0 && r->value[Q_TOW] < 604800.0)
        week_time = orr_time_add_s(orr_time_from_week((int32_t)r->value[Q_WEEK], 0), r->value[Q_TOW]);
    if (r->timed || table->where[Q_TIME] < 0) {
        orr_time at = r->timed ? r->time : week_time;
        if (at == ORR_TIME_NONE || !orr_time_is_near(at)) {
            telemetry_drop(out, in, w, r->timed ? FAR_TIME : "its GPS week and seconds are no time");
            return ORR_OK;
        }
        if (!st->have_base) st->base = at;
        st->have_base = true;
        t_s = orr_time_diff_s(at, st->base);
    }
    if (!(fabs(t_s) < LAST_TIME_S)) {
        telemetry_drop(out, in, w, FAR_TIME);
        return ORR_OK;
    }
    if (!r->timed && table->where[Q_TIME] >= 0 && week_time != ORR_TIME_NONE &&
        st->n_ties < sizeof st->tie_s / sizeof st->tie_s[0]) {
        if (st->n_ties == 0) st->tie_origin = orr_time_add_s(week_time, -t_s);
        st->tie_s[st->n_ties++] = orr_time_diff_s(week_time, st->tie_origin) - t_s;
    }
    orr_geodetic at = {r->value[Q_LAT], r->value[Q_LON], r->value[Q_HEIGHT]};
    bool place = r->has[Q_LAT] && r->has[Q_LON] && r->has[Q_HEIGHT];
    if (r->has[Q_X] && r->has[Q_Y] && r->has[Q_Z]) {
        orr_vec3 x = {r->value[Q_X], r->value[Q_Y], r->value[Q_Z]};
        double n = orr_vec3_norm(x);
        if (!(n > 6.2e6 && n < 1e8)) {
            telemetry_drop(out, in, w, "its place is not near the Earth's surface");
            return ORR_OK;
        }
        at = orr_earth_from_ecef(x);
        place = true;
    } else if (place) {
        if (!(fabs(at.lat_rad) <= 0.5 * ORR_PI + 1e-12)) {
            char why[80];
            snprintf(why, sizeof why, "latitude %.6g deg is past a pole", at.lat_rad * ORR_DEG_PER_RAD);
            telemetry_drop(out, in, w, why);
            return ORR_OK;
        }
        if (!(fabs(at.lon_rad) <= 4.0 * ORR_PI) || !(fabs(at.height_m) < 1e7)) {
            telemetry_drop(out, in, w, "its longitude or height is out of all bounds");
            return ORR_OK;
        }
    }
    orr_status s = place ? telemetry_add_position(out, t_s, at, line, diag) : ORR_OK;
    if (s == ORR_OK && (r->has[Q_HEADING] || r->has[Q_PITCH] || r->has[Q_ROLL])) {
        double h = r->has[Q_HEADING] ? r->value[Q_HEADING] : ORR_NAN,
               p = r->has[Q_PITCH] ? r->value[Q_PITCH] : ORR_NAN,
               q = r->has[Q_ROLL] ? r->value[Q_ROLL] : ORR_NAN;
        s = telemetry_add_attitude(out, t_s, h, p, q, line, diag);
    }
    return s;
}

static orr_status read_table(orr_input *in, const char *columns, orr_telemetry *out, orr_warnings *w,
                             orr_diag *diag)
{
    telemetry_table table;
    table_state *st = calloc(1, sizeof *st);
    if (st == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory");
    bool declared = columns != NULL, have_separator = false;
    char separator = ' ';
    orr_view line;
    orr_status s = ORR_OK;
    if (declared) s = telemetry_columns_parse(orr_view_of(columns), ',', false, NULL, 0, &table, NULL, diag);
    while (s == ORR_OK && orr_input_line(in, &line)) {
        if (orr_view_is_blank(line)) continue;
        orr_view v = orr_view_trim(line);
        if (v.p[0] == '#') {
            orr_view rest = {v.p + 1, v.n - 1};
            rest = orr_view_trim(rest);
            if (columns == NULL && orr_view_starts(rest, "columns:")) {
                rest.p += 8;
                rest.n -= 8;
                s = telemetry_columns_parse(orr_view_trim(rest), ',', false, orr_input_name(in),
                                            orr_input_line_number(in), &table, NULL, diag);
                declared = true;
            }
            continue;
        }
        if (!have_separator) {
            double v8[8];
            separator = separator_of(v);
            have_separator = true;
            bool numbers = count_numbers(v, separator, v8) > 0;
            if (!declared) {
                char c = v.p[0] == '"' ? v.p[v.n > 1 ? 1 : 0] : v.p[0];
                bool words = (c | 0x20) >= 'a' && (c | 0x20) <= 'z';
                declared = true;
                if (!numbers && words) {
                    s = telemetry_columns_parse(v, separator, true, orr_input_name(in),
                                                orr_input_line_number(in), &table, w, diag);
                    continue;
                }
                s = known_shape(v, separator, in, out, &table, diag);
                if (s != ORR_OK) break;
            } else if (!numbers && (v.p[0] == '"' || ((v.p[0] | 0x20) >= 'a' && (v.p[0] | 0x20) <= 'z'))) {
                continue; // a header row above columns that were declared otherwise
            }
        }
        row r;
        out->rows++;
        const char *why = read_row(v, separator, &table, &r);
        if (why != NULL)
            telemetry_drop(out, in, w, why);
        else
            s = take_row(&r, &table, in, st, out, w, diag);
    }
    if (s == ORR_OK) s = orr_input_status(in, diag);
    if (s == ORR_OK && st->have_base) {
        out->absolute = true;
        out->t0 = st->base;
    } else if (s == ORR_OK && st->n_ties > 0) {
        out->absolute = true;
        out->t0 = orr_time_add_s(st->tie_origin, orr_upper_median(st->tie_s, st->n_ties));
    }
    free(st);
    return s;
}

static orr_status read_input(orr_input *in, const char *columns, orr_telemetry *out, orr_warnings *w,
                             orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_view head = orr_input_head(in), line = head;
    // NMEA is known by its first sentence, whatever comes before it in the line.
    const char *end = head.n > 0 ? memchr(head.p, '\n', head.n) : NULL;
    if (end != NULL) line.n = (size_t)(end - head.p);
    bool nmea = columns == NULL && line.n > 0 && (orr_view_starts(line, "$") || orr_view_starts(line, "!"));
    if (nmea) out->kind = ORR_TELEMETRY_NMEA;
    orr_status s = nmea ? telemetry_read_nmea(in, out, w, diag) : read_table(in, columns, out, w, diag);
    if (s == ORR_OK && out->n_position == 0 && out->n_attitude == 0)
        s = orr_diag_at(diag, ORR_E_FORMAT, orr_input_name(in), 0, 0,
                        "no row of telemetry could be used (%zu rows, %zu left out)", out->rows,
                        out->unreadable);
    if (s != ORR_OK) orr_telemetry_free(out);
    return s;
}

orr_status orr_telemetry_read(const char *path, const char *columns, orr_telemetry *out,
                              orr_warnings *warnings, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_input *in;
    orr_status s = orr_input_open(path, NULL, &in, diag);
    if (s != ORR_OK) return s;
    s = read_input(in, columns, out, warnings, diag);
    orr_input_close(in);
    return s;
}

orr_status orr_telemetry_read_bytes(const char *name, const void *data, size_t n, const char *columns,
                                    orr_telemetry *out, orr_warnings *warnings, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_input *in;
    orr_status s = orr_input_open_bytes(name, data, n, NULL, &in, diag);
    if (s != ORR_OK) return s;
    s = read_input(in, columns, out, warnings, diag);
    orr_input_close(in);
    return s;
}
