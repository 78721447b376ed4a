// SPDX-License-Identifier: GPL-3.0-or-later
// One row of a table: its fields by their columns, and what they are together: an instant, a place, angles.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/nan.h"
#include "ingest/telemetry/telemetry_private.h"

#define NO_NUMBER "a field is no finite number"

// Text or number of a column of time; NULL, or why the row is to be left out.
static const char *read_time(const telemetry_column *c, orr_view field, const orr_leap_table *leap,
                             telemetry_row *r)
{
    double x;
    bool number = telemetry_number(field, &x) == ORR_FIELD_OK;
    if (c->form == FORM_UNIX || (c->quantity == Q_INSTANT && c->form == FORM_OPEN && number)) {
        if (!number) return field.n == 0 || telemetry_is_nan(field) ? NULL : NO_NUMBER;
        if (x > 0.0) r->at = telemetry_unix_time(x, c->scale, leap); // 0: not known yet
        return NULL;
    }
    if (number && (c->form == FORM_NUMBER || c->form == FORM_OPEN)) {
        r->value[c->quantity] = x * c->scale;
        r->has[c->quantity] = true;
        return NULL;
    }
    if (c->form == FORM_NUMBER) return NO_NUMBER;
    orr_time at;
    double of_day_s;
    if (!telemetry_time_text(field, c->form == FORM_TEXT_GPS ? ORR_SCALE_GPS : ORR_SCALE_UTC, leap, &at,
                             &of_day_s)) {
        // A word in a column of numbers is no time at all.
        bool digit = field.n > 0 && field.p[0] >= '0' && field.p[0] <= '9';
        return c->form == FORM_OPEN && !digit ? NO_NUMBER : "its time is no ISO 8601 date and time";
    }
    if (at != ORR_TIME_NONE) r->at = at;
    if (!isnan(of_day_s)) r->of_day_s = of_day_s;
    return NULL;
}

static bool is_optional(telemetry_quantity q)
{
    return q == Q_WEEK || q == Q_TOW || q == Q_GEOID || (q >= Q_HEADING && q <= Q_QZ);
}
static bool is_place(telemetry_quantity q) { return q >= Q_LAT && q <= Q_Z; }

const char *telemetry_row_read(const telemetry_table *t, char separator, const orr_leap_table *leap,
                               orr_view line, telemetry_row *r)
{
    memset(r, 0, sizeof *r);
    r->at = ORR_TIME_NONE;
    r->of_day_s = ORR_NAN;
    orr_view rest = line, field;
    size_t n = 0, blank_places = 0;
    for (; n < t->n && telemetry_field(&rest, separator, &field); n++) {
        const telemetry_column *c = &t->column[n];
        if (c->quantity == Q_SKIP) continue;
        if (c->quantity == Q_TIME || c->quantity == Q_INSTANT) {
            const char *why = read_time(c, field, leap, r);
            if (why != NULL) return why;
            continue;
        }
        if (c->quantity == Q_DATE) {
            r->has[Q_DATE] = telemetry_date_text(field, &r->mjd);
            if (!r->has[Q_DATE]) return "its date is none (2024-08-15 would be one)";
            continue;
        }
        double x;
        orr_field f = telemetry_number(field, &x);
        if (f != ORR_FIELD_OK) {
            bool absent = f == ORR_FIELD_BLANK || telemetry_is_nan(field);
            if (absent && is_optional(c->quantity)) continue;
            if (f == ORR_FIELD_BLANK && is_place(c->quantity)) {
                blank_places++;
                continue;
            }
            return NO_NUMBER;
        }
        r->value[c->quantity] = c->quantity == Q_FIX ? x : x * c->scale;
        r->has[c->quantity] = true;
        if (c->quantity == Q_FIX && x < c->scale) return "it has no position fix";
    }
    if (n < t->n) return "it has too few fields";
    if (t->header && separator != ' ')
        while (telemetry_field(&rest, separator, &field))
            if (field.n > 0)
                return "it has more fields than the header has names (decimal commas need another character, "
                       "or quotes, "
                       "between fields)";
    bool angles = r->has[Q_HEADING] || r->has[Q_PITCH] || r->has[Q_ROLL] || r->has[Q_QW];
    return blank_places > 0 && !angles ? NO_NUMBER : NULL;
}

bool telemetry_row_units(telemetry_table *table, telemetry_reader *reader, telemetry_row *r)
{
    if (!r->has[Q_LAT] || !r->has[Q_LON]) return false;
    telemetry_column *lat = &table->column[table->where[Q_LAT]], *lon = &table->column[table->where[Q_LON]];
    double lat_deg = r->value[Q_LAT] * ORR_DEG_PER_RAD, lon_deg = r->value[Q_LON] * ORR_DEG_PER_RAD;
    if (!lat->assumed || !lon->assumed || !(fabs(lat_deg) <= 9e8 && fabs(lon_deg) <= 3.6e9) ||
        !(fabs(lat_deg) > 1e4 || fabs(lon_deg) > 1e4) || !telemetry_is_whole(lat_deg) ||
        !telemetry_is_whole(lon_deg))
        return true;
    bool mm = false;
    lat->scale *= 1e-7;
    lon->scale *= 1e-7;
    r->value[Q_LAT] *= 1e-7;
    r->value[Q_LON] *= 1e-7;
    for (int q = Q_HEIGHT; q <= Q_HEIGHT_SEA; q++) {
        if (table->where[q] < 0 || !table->column[table->where[q]].assumed || !r->has[q] ||
            !telemetry_is_whole(r->value[q]))
            continue;
        table->column[table->where[q]].scale = 1e-3;
        r->value[q] *= 1e-3;
        mm = true;
    }
    orr_warnings_add(
        reader->notes, orr_input_name(reader->in), orr_input_line_number(reader->in), 0,
        "latitude and longitude name no unit and cannot be degrees: they are taken as 1e-7 deg%s",
        mm ? ", and heights as mm" : "");
    return true;
}

bool telemetry_row_turned(const telemetry_row *r, bool enu, double *heading, double *pitch, double *roll)
{
    double w = r->value[Q_QW], x = r->value[Q_QX], y = r->value[Q_QY], z = r->value[Q_QZ];
    double n2 = w * w + x * x + y * y + z * z;
    if (!(fabs(n2 - 1.0) < 0.05)) return false;
    *heading = atan2(2.0 * (w * z + x * y), w * w + x * x - y * y - z * z);
    *pitch = asin(fmax(-1.0, fmin(1.0, 2.0 * (w * y - z * x) / n2)));
    *roll = atan2(2.0 * (w * x + y * z), w * w - x * x - y * y + z * z);
    if (enu) { // from East counter-clockwise, nose down positive
        *heading = 0.5 * ORR_PI - *heading;
        *pitch = -*pitch;
    }
    if (*heading < 0.0) *heading += 2.0 * ORR_PI;
    return true;
}

const char *telemetry_row_place(telemetry_row *r, orr_geodetic *at, bool *place, bool *above_sea)
{
    bool height = r->has[Q_HEIGHT] || r->has[Q_HEIGHT_SEA];
    *place = r->has[Q_LAT] && r->has[Q_LON] && height;
    *above_sea = !r->has[Q_HEIGHT] && !r->has[Q_GEOID];
    *at = (orr_geodetic){r->value[Q_LAT], r->value[Q_LON],
                         r->has[Q_HEIGHT] ? r->value[Q_HEIGHT] : r->value[Q_HEIGHT_SEA] + r->value[Q_GEOID]};
    if (r->has[Q_X] && r->has[Q_Y] && r->has[Q_Z]) {
        orr_vec3 x = {r->value[Q_X], r->value[Q_Y], r->value[Q_Z]};
        double n = orr_vec3_norm(x);
        *place = true;
        *above_sea = false;
        if (!(n > 6.2e6 && n < 1e8)) return "its place is not near the Earth's surface";
        *at = orr_earth_from_ecef(x);
    } else if (*place) {
        if (!(fabs(at->lat_rad) <= 0.5 * ORR_PI + 1e-12)) {
            snprintf(r->why, sizeof r->why, "latitude %.6g deg is past a pole",
                     at->lat_rad * ORR_DEG_PER_RAD);
            return r->why;
        }
        if (!(fabs(at->lon_rad) <= 4.0 * ORR_PI) || !(fabs(at->height_m) < 1e7))
            return "its longitude or height is out of all bounds";
    }
    return NULL;
}
