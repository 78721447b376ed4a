// SPDX-License-Identifier: GPL-3.0-or-later
// Column declarations of telemetry tables.
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/vec.h"
#include "ingest/telemetry/telemetry_private.h"

typedef struct alias {
    const char *name;
    telemetry_quantity quantity;
} alias;

static const alias aliases[] = {
    {"t", Q_TIME},
    {"time", Q_TIME},
    {"timestamp", Q_TIME},
    {"seconds", Q_TIME},
    {"sec", Q_TIME},
    {"utc", Q_TIME},
    {"week", Q_WEEK},
    {"gpsweek", Q_WEEK},
    {"tow", Q_TOW},
    {"sow", Q_TOW},
    {"lat", Q_LAT},
    {"latitude", Q_LAT},
    {"phi", Q_LAT},
    {"lon", Q_LON},
    {"lng", Q_LON},
    {"long", Q_LON},
    {"longitude", Q_LON},
    {"lambda", Q_LON},
    {"h", Q_HEIGHT},
    {"height", Q_HEIGHT},
    {"alt", Q_HEIGHT},
    {"altitude", Q_HEIGHT},
    {"hgt", Q_HEIGHT},
    {"x", Q_X},
    {"y", Q_Y},
    {"z", Q_Z},
    {"heading", Q_HEADING},
    {"yaw", Q_HEADING},
    {"hdg", Q_HEADING},
    {"azimuth", Q_HEADING},
    {"pitch", Q_PITCH},
    {"theta", Q_PITCH},
    {"roll", Q_ROLL},
    {"gamma", Q_ROLL},
    {"fix", Q_FIX},
    {"quality", Q_FIX},
    {"-", Q_SKIP},
    {"skip", Q_SKIP},
};

typedef struct unit {
    const char *name;
    char dimension; // t time, a angle, l length
    double scale;
} unit;

static const unit units[] = {
    {"s", 't', 1.0},   {"sec", 't', 1.0},  {"ms", 't', 1e-3},  {"us", 't', 1e-6},
    {"ns", 't', 1e-9}, {"min", 't', 60.0}, {"h", 't', 3600.0}, {"deg", 'a', ORR_RAD_PER_DEG},
    {"rad", 'a', 1.0}, {"m", 'l', 1.0},    {"km", 'l', 1e3},   {"ft", 'l', 0.3048},
    {"mm", 'l', 1e-3},
};

static char dimension_of(telemetry_quantity q)
{
    switch (q) {
    case Q_TIME:
    case Q_TOW:
        return 't';
    case Q_LAT:
    case Q_LON:
    case Q_HEADING:
    case Q_PITCH:
    case Q_ROLL:
        return 'a';
    case Q_HEIGHT:
    case Q_X:
    case Q_Y:
    case Q_Z:
        return 'l';
    default:
        return '-';
    }
}

static bool find_unit(const char *name, char dimension, double *scale)
{
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++)
        if (units[i].dimension == dimension && strcmp(units[i].name, name) == 0) {
            *scale = units[i].scale;
            return true;
        }
    return false;
}

static bool find_quantity(const char *name, telemetry_quantity *q)
{
    for (size_t i = 0; i < sizeof aliases / sizeof aliases[0]; i++)
        if (strcmp(aliases[i].name, name) == 0) {
            *q = aliases[i].quantity;
            return true;
        }
    return false;
}

// "Roll [deg]", "roll(deg)" or "roll_deg" into its name and unit, lower case.
static void cut(orr_view field, char name[64], char unit_name[32])
{
    char text[96];
    orr_view_copy(orr_view_trim(field), text, sizeof text);
    size_t n = strlen(text);
    if (n >= 2 && text[0] == '"' && text[n - 1] == '"') {
        memmove(text, text + 1, n - 2);
        text[n - 2] = '\0';
    }
    for (char *p = text; *p != '\0'; p++) *p = (char)tolower((unsigned char)*p);
    unit_name[0] = '\0';
    char *open = strpbrk(text, "[(");
    if (open != NULL) {
        char *close = strpbrk(open, "])");
        if (close != NULL) *close = '\0';
        snprintf(unit_name, 32, "%.31s", open + 1);
        *open = '\0';
    } else {
        char *last = strrchr(text, '_');
        double scale;
        if (last != NULL && last != text &&
            (find_unit(last + 1, 't', &scale) || find_unit(last + 1, 'a', &scale) ||
             find_unit(last + 1, 'l', &scale))) {
            snprintf(unit_name, 32, "%.31s", last + 1);
            *last = '\0';
        }
    }
    n = strlen(text);
    while (n > 0 && (text[n - 1] == ' ' || text[n - 1] == '\t')) text[--n] = '\0';
    snprintf(name, 64, "%.63s", text);
}

bool telemetry_field(orr_view *rest, char separator, orr_view *field)
{
    if (separator == ' ') return orr_view_word(rest, field);
    if (!orr_view_split(rest, separator, field)) return false;
    *field = orr_view_trim(*field);
    return true;
}

static orr_status set_unit(telemetry_column *c, const char *name, const char *u, const char *file,
                           int64_t line, int column, orr_diag *diag)
{
    double sign = 1.0;
    char dimension = dimension_of(c->quantity);
    c->scale = dimension == 'a' ? ORR_RAD_PER_DEG : 1.0;
    if (*u == '\0' && c->quantity != Q_FIX) return ORR_OK;
    if (c->quantity == Q_FIX) {
        c->scale = 1.0;
        if (*u == '\0') return ORR_OK;
        if (u[0] == '>' && u[1] == '=') u += 2;
        if (orr_view_real(orr_view_of(u), &c->scale) == ORR_FIELD_OK) return ORR_OK;
    } else if (c->quantity == Q_TIME &&
               (strcmp(u, "utc") == 0 || strcmp(u, "gps") == 0 || strcmp(u, "iso") == 0)) {
        c->time_text = u[0] == 'u' ? 1 : 2;
        return ORR_OK;
    } else {
        if (*u == '-') {
            sign = -1.0;
            u++;
        }
        if (find_unit(u, dimension, &c->scale)) {
            c->scale *= sign;
            return ORR_OK;
        }
    }
    return orr_diag_at(diag, ORR_E_ARG, file, line, column, "column \"%s\" cannot have the unit \"%s\"", name,
                       u);
}

orr_status telemetry_columns_parse(orr_view text, char separator, bool lenient, const char *file,
                                   int64_t line, telemetry_table *out, orr_warnings *warnings, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    for (int q = 0; q < Q_COUNT; q++) out->where[q] = -1;
    orr_view rest = text, field;
    while (telemetry_field(&rest, separator, &field)) {
        char name[64], unit_name[32];
        telemetry_column c = {.quantity = Q_SKIP, .scale = 1.0};
        if (out->n == ORR_TELEMETRY_MAX_COLUMNS)
            return orr_diag_at(diag, ORR_E_LIMIT, file, line, 0, "more than %d columns",
                               ORR_TELEMETRY_MAX_COLUMNS);
        int place = (int)(field.p - text.p) + 1;
        cut(field, name, unit_name);
        if (!find_quantity(name, &c.quantity)) {
            if (!lenient)
                return orr_diag_at(
                    diag, ORR_E_ARG, file, line, place,
                    "no column is called \"%s\"; known are t, week, tow, lat, lon, height, x, y, z, heading, "
                    "pitch, roll, fix and - for a column to skip",
                    name);
            orr_warnings_add(warnings, file, line, place, "column \"%s\" is not known and is skipped", name);
        }
        if (c.quantity != Q_SKIP) {
            orr_status s = set_unit(&c, name, unit_name, file, line, place, diag);
            if (s != ORR_OK) return s;
            if (out->where[c.quantity] >= 0)
                return orr_diag_at(diag, ORR_E_ARG, file, line, place, "column \"%s\" is declared twice",
                                   name);
            out->where[c.quantity] = (int)out->n;
        }
        out->column[out->n++] = c;
    }
    const int *w = out->where;
    bool time = w[Q_TIME] >= 0 || (w[Q_WEEK] >= 0 && w[Q_TOW] >= 0);
    bool place =
        (w[Q_LAT] >= 0 && w[Q_LON] >= 0 && w[Q_HEIGHT] >= 0) || (w[Q_X] >= 0 && w[Q_Y] >= 0 && w[Q_Z] >= 0);
    bool angles = w[Q_HEADING] >= 0 || w[Q_PITCH] >= 0 || w[Q_ROLL] >= 0;
    if (!time || (!place && !angles))
        return orr_diag_at(diag, ORR_E_FORMAT, file, line, 0,
                           "these columns have %s; telemetry needs a time (t, or week and tow) and a place "
                           "(lat, lon, height or "
                           "x, y, z) or angles (heading, pitch, roll); declare them, e.g. "
                           "\"t[s],lat[deg],lon[deg],height[m]\"",
                           !time ? "no time" : "neither a whole place nor angles");
    return ORR_OK;
}
