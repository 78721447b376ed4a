// SPDX-License-Identifier: GPL-3.0-or-later
// Column declarations and header rows of telemetry tables.
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/vec.h"
#include "ingest/telemetry/telemetry_private.h"

// Where a name has its meaning.
typedef enum family { ANYWHERE, HEADER, PX4, ARDUPILOT } family;

typedef struct alias {
    const char *name;
    telemetry_quantity quantity;
    int rank;         // of names for one quantity in one header the highest is used
    const char *unit; // where the header tells none; NULL: s, deg, m
    family where;
} alias;

// The first that fits is used: names with a narrower meaning stand first. PX4: topics vehicle_gps_position,
// sensor_gps, vehicle_global_position and vehicle_attitude as ulog2csv writes them; ArduPilot: messages GPS, POS,
// ATT and AHR2 of data-flash logs; MAVLink's GLOBAL_POSITION_INT, GPS_RAW_INT and ATTITUDE.
static const alias aliases[] = {
    {"timestamp", Q_TIME, 1, "us", PX4},
    {"heading", Q_HEADING, 3, "rad", PX4},
    {"alt", Q_HEIGHT_SEA, 1, NULL, PX4},
    {"alt", Q_HEIGHT_SEA, 1, NULL, ARDUPILOT},
    {"status", Q_FIX, 1, ">=3", ARDUPILOT},
    {"gms", Q_TOW, 1, "ms", ARDUPILOT},
    {"gwk", Q_WEEK, 1, NULL, ARDUPILOT},
    {"timeus", Q_TIME, 3, "us", HEADER},
    {"time_usec", Q_TIME, 3, "us", HEADER},
    {"time_boot", Q_TIME, 3, "ms", HEADER},
    {"timems", Q_TIME, 3, "ms", HEADER},
    {"fix_type", Q_FIX, 2, ">=3", HEADER},
    {"hdg", Q_HEADING, 2, "cdeg", PX4},
    {"t", Q_TIME, 4, NULL, ANYWHERE},
    {"time", Q_TIME, 2, NULL, ANYWHERE},
    {"timestamp", Q_TIME, 1, NULL, ANYWHERE},
    {"sod", Q_OF_DAY, 1, NULL, ANYWHERE},
    {"seconds_of_day", Q_OF_DAY, 1, NULL, ANYWHERE},
    {"time_of_day", Q_OF_DAY, 1, NULL, ANYWHERE},
    {"seconds", Q_TIME, 1, NULL, ANYWHERE},
    {"sec", Q_TIME, 1, NULL, ANYWHERE},
    {"utc", Q_TIME, 1, NULL, ANYWHERE},
    {"t_gps", Q_INSTANT, 3, "gps", ANYWHERE},
    {"time_gps", Q_INSTANT, 3, "gps", ANYWHERE},
    {"gps_time", Q_INSTANT, 3, "gps", ANYWHERE},
    {"instant", Q_INSTANT, 3, NULL, ANYWHERE},
    {"t_utc", Q_INSTANT, 3, NULL, ANYWHERE},
    {"time_utc", Q_INSTANT, 2, NULL, ANYWHERE},
    {"utc_time", Q_INSTANT, 2, NULL, ANYWHERE},
    {"utc time", Q_INSTANT, 2, NULL, ANYWHERE},
    {"timestamp utc", Q_INSTANT, 2, NULL, ANYWHERE},
    {"timestamp_utc", Q_INSTANT, 2, NULL, ANYWHERE},
    {"gps time", Q_INSTANT, 3, "gps", ANYWHERE},
    {"datetime", Q_INSTANT, 2, NULL, ANYWHERE},
    {"date_time", Q_INSTANT, 2, NULL, ANYWHERE},
    {"date time", Q_INSTANT, 2, NULL, ANYWHERE},
    {"epoch", Q_INSTANT, 1, NULL, ANYWHERE},
    {"date", Q_DATE, 1, NULL, ANYWHERE},
    {"week", Q_WEEK, 2, NULL, ANYWHERE},
    {"gpsweek", Q_WEEK, 1, NULL, ANYWHERE},
    {"gps_week", Q_WEEK, 1, NULL, ANYWHERE},
    {"tow", Q_TOW, 2, NULL, ANYWHERE},
    {"sow", Q_TOW, 1, NULL, ANYWHERE},
    {"itow", Q_TOW, 1, "ms", ANYWHERE},
    {"gps_tow", Q_TOW, 1, NULL, ANYWHERE},
    {"lat", Q_LAT, 2, NULL, ANYWHERE},
    {"latitude", Q_LAT, 1, NULL, ANYWHERE},
    {"phi", Q_LAT, 0, NULL, ANYWHERE},
    {"lon", Q_LON, 2, NULL, ANYWHERE},
    {"lng", Q_LON, 1, NULL, ANYWHERE},
    {"long", Q_LON, 1, NULL, ANYWHERE},
    {"longitude", Q_LON, 1, NULL, ANYWHERE},
    {"lambda", Q_LON, 0, NULL, ANYWHERE},
    {"alt_ellipsoid", Q_HEIGHT, 3, NULL, ANYWHERE},
    {"altitude_ellipsoid", Q_HEIGHT, 3, NULL, ANYWHERE},
    {"ellipsoidal_height", Q_HEIGHT, 3, NULL, ANYWHERE},
    {"hae", Q_HEIGHT, 3, NULL, ANYWHERE},
    {"height", Q_HEIGHT, 2, NULL, ANYWHERE},
    {"hgt", Q_HEIGHT, 2, NULL, ANYWHERE},
    {"h", Q_HEIGHT, 2, NULL, ANYWHERE},
    {"alt", Q_HEIGHT, 1, NULL, ANYWHERE},
    {"altitude", Q_HEIGHT, 1, NULL, ANYWHERE},
    {"height_msl", Q_HEIGHT_SEA, 3, NULL, ANYWHERE},
    {"altitude_msl", Q_HEIGHT_SEA, 3, NULL, ANYWHERE},
    {"alt_msl", Q_HEIGHT_SEA, 3, NULL, ANYWHERE},
    {"hmsl", Q_HEIGHT_SEA, 3, NULL, ANYWHERE},
    {"msl", Q_HEIGHT_SEA, 2, NULL, ANYWHERE},
    {"elevation", Q_HEIGHT_SEA, 1, NULL, ANYWHERE},
    {"ele", Q_HEIGHT_SEA, 1, NULL, ANYWHERE},
    {"geoid", Q_GEOID, 2, NULL, ANYWHERE},
    {"undulation", Q_GEOID, 1, NULL, ANYWHERE},
    {"geoid_separation", Q_GEOID, 1, NULL, ANYWHERE},
    {"x", Q_X, 1, NULL, ANYWHERE},
    {"y", Q_Y, 1, NULL, ANYWHERE},
    {"z", Q_Z, 1, NULL, ANYWHERE},
    {"heading", Q_HEADING, 3, NULL, ANYWHERE},
    {"yaw", Q_HEADING, 2, NULL, ANYWHERE},
    {"hdg", Q_HEADING, 2, NULL, ANYWHERE},
    {"azimuth", Q_HEADING, 1, NULL, ANYWHERE},
    {"pitch", Q_PITCH, 2, NULL, ANYWHERE},
    {"theta", Q_PITCH, 1, NULL, ANYWHERE},
    {"roll", Q_ROLL, 2, NULL, ANYWHERE},
    {"gamma", Q_ROLL, 1, NULL, ANYWHERE},
    {"qw", Q_QW, 2, NULL, ANYWHERE},
    {"qx", Q_QX, 2, NULL, ANYWHERE},
    {"qy", Q_QY, 2, NULL, ANYWHERE},
    {"qz", Q_QZ, 2, NULL, ANYWHERE},
    {"q0", Q_QW, 1, NULL, ANYWHERE},
    {"q1", Q_QX, 1, NULL, ANYWHERE},
    {"q2", Q_QY, 1, NULL, ANYWHERE},
    {"q3", Q_QZ, 1, NULL, ANYWHERE},
    {"fix", Q_FIX, 2, NULL, ANYWHERE},
    {"quality", Q_FIX, 1, NULL, ANYWHERE},
    {"-", Q_SKIP, 0, NULL, ANYWHERE},
    {"skip", Q_SKIP, 0, NULL, ANYWHERE},
};

typedef struct unit {
    const char *name;
    char dimension; // t time, a angle, l length
    double scale;
} unit;

static const unit units[] = {
    {"s", 't', 1.0},
    {"sec", 't', 1.0},
    {"second", 't', 1.0},
    {"seconds", 't', 1.0},
    {"ms", 't', 1e-3},
    {"msec", 't', 1e-3},
    {"us", 't', 1e-6},
    {"usec", 't', 1e-6},
    {"ns", 't', 1e-9},
    {"nsec", 't', 1e-9},
    {"min", 't', 60.0},
    {"h", 't', 3600.0},
    {"deg", 'a', ORR_RAD_PER_DEG},
    {"degree", 'a', ORR_RAD_PER_DEG},
    {"degrees", 'a', ORR_RAD_PER_DEG},
    {"\xc2\xb0", 'a', ORR_RAD_PER_DEG},
    {"dege7", 'a', 1e-7 * ORR_RAD_PER_DEG},
    {"1e-7deg", 'a', 1e-7 * ORR_RAD_PER_DEG},
    {"1e-7 deg", 'a', 1e-7 * ORR_RAD_PER_DEG},
    {"cdeg", 'a', 1e-2 * ORR_RAD_PER_DEG},
    {"rad", 'a', 1.0},
    {"mrad", 'a', 1e-3},
    {"m", 'l', 1.0},
    {"meter", 'l', 1.0},
    {"meters", 'l', 1.0},
    {"metres", 'l', 1.0},
    {"km", 'l', 1e3},
    {"dm", 'l', 0.1},
    {"cm", 'l', 1e-2},
    {"mm", 'l', 1e-3},
    {"ft", 'l', 0.3048},
    {"feet", 'l', 0.3048},
};

static char dimension_of(telemetry_quantity q)
{
    switch (q) {
    case Q_TIME:
    case Q_OF_DAY:
    case Q_INSTANT:
    case Q_TOW:
        return 't';
    case Q_LAT:
    case Q_LON:
    case Q_HEADING:
    case Q_PITCH:
    case Q_ROLL:
        return 'a';
    case Q_HEIGHT:
    case Q_HEIGHT_SEA:
    case Q_GEOID:
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

typedef struct name {
    char word[64], unit[32];
    int place; // in the line, from 1
    bool skipped;
} name;

// "Roll [deg]", "roll(deg)" or "roll_deg" into its name and unit, lower case; "q[0]" is a name with a number.
static void cut(orr_view field, name *out)
{
    char text[96];
    orr_view_copy(orr_view_trim(field), text, sizeof text);
    size_t n = strlen(text);
    if (n >= 2 && text[0] == '"' && text[n - 1] == '"') {
        memmove(text, text + 1, n - 2);
        text[n - 2] = '\0';
    }
    for (char *p = text; *p != '\0'; p++) *p = (char)tolower((unsigned char)*p);
    out->unit[0] = '\0';
    char *open = strpbrk(text, "[(");
    if (open != NULL && isdigit((unsigned char)open[1]) && open[2] == ']' && open[3] == '\0') {
        open[0] = open[1];
        open[1] = '\0';
    } else if (open != NULL) {
        char *close = strpbrk(open, "])");
        if (close != NULL) *close = '\0';
        snprintf(out->unit, sizeof out->unit, "%.31s", open + 1);
        *open = '\0';
    } else {
        char *last = strrchr(text, '_');
        double scale;
        if (last != NULL && last != text &&
            (find_unit(last + 1, 't', &scale) || find_unit(last + 1, 'a', &scale) ||
             find_unit(last + 1, 'l', &scale))) {
            snprintf(out->unit, sizeof out->unit, "%.31s", last + 1);
            *last = '\0';
        }
    }
    n = strlen(text);
    while (n > 0 && (text[n - 1] == ' ' || text[n - 1] == '\t')) text[--n] = '\0';
    snprintf(out->word, sizeof out->word, "%.63s", text);
}

static bool has(const name *names, size_t n, const char *word)
{
    for (size_t k = 0; k < n; k++)
        if (strcmp(names[k].word, word) == 0) return true;
    return false;
}

// Whose table a header is, by names that no one else uses.
static family family_of(const name *names, size_t n)
{
    static const char *const px4[] = {"timestamp_sample", "s_variance_m",      "c_variance",
                                      "alt_ellipsoid",    "delta_q_reset0",    "q_reset0",
                                      "noise_per_ms",     "altitude_ellipsoid"};
    if (has(names, n, "timeus")) return ARDUPILOT;
    if (has(names, n, "time_usec") || has(names, n, "time_boot")) return PX4; // MAVLink's messages
    for (size_t k = 0; k < sizeof px4 / sizeof px4[0]; k++)
        if (has(names, n, "timestamp") && has(names, n, px4[k])) return PX4;
    if (has(names, n, "timestamp") && has(names, n, "q0") && has(names, n, "q3")) return PX4;
    return ANYWHERE;
}

static const alias *find_alias(const char *word, bool header, family of)
{
    for (size_t i = 0; i < sizeof aliases / sizeof aliases[0]; i++) {
        const alias *a = &aliases[i];
        bool here = a->where == ANYWHERE || (header && (a->where == HEADER || a->where == of));
        if (here && strcmp(a->name, word) == 0) return a;
    }
    return NULL;
}

static orr_status set_unit(telemetry_column *c, const name *column, const char *u, const char *file,
                           int64_t line, orr_diag *diag)
{
    double sign = 1.0;
    char dimension = dimension_of(c->quantity);
    c->scale = dimension == 'a' ? ORR_RAD_PER_DEG : 1.0;
    const bool is_instant = c->quantity == Q_TIME || c->quantity == Q_INSTANT;
    c->form = is_instant ? FORM_OPEN : FORM_NUMBER;
    if (*u == '\0') {
        c->assumed = true;
        return ORR_OK;
    }
    if (c->quantity == Q_FIX) {
        if (u[0] == '>' && u[1] == '=') u += 2;
        if (orr_view_real(orr_view_of(u), &c->scale) == ORR_FIELD_OK) return ORR_OK;
    } else if (is_instant && strcmp(u, "unix") == 0) {
        c->form = FORM_UNIX;
        return ORR_OK;
    } else if (is_instant && (strcmp(u, "utc") == 0 || strcmp(u, "gps") == 0 || strcmp(u, "iso") == 0)) {
        c->form = u[0] == 'u' ? FORM_TEXT_UTC : FORM_TEXT_GPS;
        return ORR_OK;
    } else if (c->quantity == Q_HEIGHT && (strcmp(u, "msl") == 0 || strcmp(u, "amsl") == 0)) {
        c->quantity = Q_HEIGHT_SEA;
        return ORR_OK;
    } else if (c->quantity >= Q_QW && c->quantity <= Q_QZ &&
               (strcmp(u, "ned") == 0 || strcmp(u, "enu") == 0)) {
        c->scale = u[0] == 'e' ? -1.0 : 1.0; // noted by the caller
        return ORR_OK;
    } else {
        if (*u == '-') {
            sign = -1.0;
            u++;
        }
        if (find_unit(u, dimension, &c->scale)) {
            c->scale *= sign;
            if (c->quantity == Q_TIME) c->form = FORM_NUMBER;
            if (c->quantity == Q_INSTANT) c->form = FORM_UNIX;
            return ORR_OK;
        }
    }
    return orr_diag_at(diag, ORR_E_ARG, file, line, column->place,
                       "column \"%s\" cannot have the unit \"%s\"", column->word, u);
}

static orr_status check_whole(const telemetry_table *t, const char *file, int64_t line, orr_diag *diag)
{
    const int *w = t->where;
    bool time = w[Q_TIME] >= 0 || w[Q_OF_DAY] >= 0 || w[Q_TOW] >= 0 || w[Q_INSTANT] >= 0;
    bool place = (w[Q_LAT] >= 0 && w[Q_LON] >= 0 && (w[Q_HEIGHT] >= 0 || w[Q_HEIGHT_SEA] >= 0)) ||
                 (w[Q_X] >= 0 && w[Q_Y] >= 0 && w[Q_Z] >= 0);
    bool turned = w[Q_QW] >= 0 && w[Q_QX] >= 0 && w[Q_QY] >= 0 && w[Q_QZ] >= 0;
    bool angles = w[Q_HEADING] >= 0 || w[Q_PITCH] >= 0 || w[Q_ROLL] >= 0 || turned;
    if (time && (place || angles)) return ORR_OK;
    return orr_diag_at(
        diag, ORR_E_FORMAT, file, line, 0,
        "these columns have %s; telemetry needs a time (t, an instant, or week and tow) and a place "
        "(lat, lon, height or x, y, z) or angles (heading, pitch, roll, or qw, qx, qy, qz); declare "
        "them, e.g. \"t[s],lat[deg],lon[deg],height[m]\"",
        !time ? "no time" : "neither a whole place nor angles");
}

static orr_status unknown(const name *c, const char *file, int64_t line, orr_diag *diag)
{
    return orr_diag_at(
        diag, ORR_E_ARG, file, line, c->place,
        "no column is called \"%s\"; known are t, week, tow, instant, date, lat, lon, height, "
        "height_msl, geoid, x, y, z, heading, pitch, roll, qw, qx, qy, qz, fix and - for a column to "
        "skip",
        c->word);
}

orr_status telemetry_columns_parse(orr_view text, char separator, bool header, const char *file, int64_t line,
                                   telemetry_table *out, orr_warnings *notes, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    out->header = header;
    for (int q = 0; q < Q_COUNT; q++) out->where[q] = -1;
    name names[ORR_TELEMETRY_MAX_COLUMNS];
    size_t n = 0;
    orr_view rest = text, field;
    while (telemetry_field(&rest, separator, &field)) {
        if (field.n == 0 && rest.p == NULL && n > 0 && header) break; // a separator at the end
        if (n == ORR_TELEMETRY_MAX_COLUMNS)
            return orr_diag_at(diag, ORR_E_LIMIT, file, line, 0, "more than %d columns",
                               ORR_TELEMETRY_MAX_COLUMNS);
        names[n].place = field.p != NULL ? (int)(field.p - text.p) + 1 : 0;
        names[n].skipped = false;
        cut(field, &names[n++]);
    }
    // Tables of `orrery track` and `imu` tell one clock twice: seconds after an instant, and instants.
    const bool twice = header && n > 1 && strcmp(names[0].word, "t") == 0 &&
                       strcmp(names[0].unit, "s") == 0 && strcmp(names[n - 1].word, "t_gps") == 0;
    family of = header ? family_of(names, n) : ANYWHERE;
    bool from_one = has(names, n, "q4") && !has(names, n, "q0"); // AHR2 counts its quaternion from 1
    const alias *taken[Q_COUNT] = {NULL};
    size_t n_unknown = 0;
    int first_unknown = 0;
    char words[200] = "";
    for (size_t k = 0; k < n; k++) {
        name *c = &names[k];
        telemetry_column column = {.quantity = Q_SKIP, .scale = 1.0};
        if (from_one && c->word[0] == 'q' && c->word[1] >= '1' && c->word[1] <= '4' && c->word[2] == '\0')
            c->word[1]--;
        const alias *a = find_alias(c->word, header, of);
        // The yaw that a receiver of two antennas would tell, 0 without: no attitude of the vehicle.
        if (of == ARDUPILOT && has(names, n, "gms") && strcmp(c->word, "yaw") == 0) a = NULL;
        if (twice && k == 0) {
            out->column[out->n++] = column;
            continue;
        }
        if (a == NULL) {
            if (!header) return unknown(c, file, line, diag);
            size_t at = strlen(words);
            snprintf(words + at, sizeof words - at, "%s%s", at > 0 ? ", " : "", c->word);
            if (n_unknown++ == 0) first_unknown = c->place;
        } else if (a->quantity != Q_SKIP) {
            column.quantity = a->quantity;
            const char *u = c->unit[0] != '\0' || a->unit == NULL ? c->unit : a->unit;
            orr_status s = set_unit(&column, c, u, file, line, diag);
            if (s != ORR_OK) return s;
            column.assumed = column.assumed || (header && c->unit[0] == '\0' && a->unit == NULL);
            if (column.quantity >= Q_QW && column.quantity <= Q_QZ) {
                out->enu = out->enu || column.scale < 0.0;
                column.scale = 1.0;
            }
            telemetry_quantity q = column.quantity;
            if (taken[q] != NULL && (!header || taken[q]->rank == a->rank))
                return orr_diag_at(diag, ORR_E_ARG, file, line, c->place, "column \"%s\" is declared twice",
                                   c->word);
            if (taken[q] != NULL && taken[q]->rank > a->rank) {
                column = (telemetry_column){.quantity = Q_SKIP, .scale = 1.0};
            } else {
                if (taken[q] != NULL) out->column[out->where[q]].quantity = Q_SKIP;
                taken[q] = a;
                out->where[q] = (int)k;
            }
        }
        out->column[out->n++] = column;
    }
    if (n_unknown > 0)
        orr_warnings_add(notes, file, line, first_unknown, "column%s %s%s not known and skipped",
                         n_unknown == 1 ? "" : "s", words, n_unknown == 1 ? " is" : " are");
    return check_whole(out, file, line, diag);
}
