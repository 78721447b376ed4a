// SPDX-License-Identifier: GPL-3.0-or-later
// Inside of the telemetry reader. telemetry.c opens a log; telemetry_table.c reads tables, with
// telemetry_columns.c (what the columns are), telemetry_row.c (one row) and telemetry_clock.c (two clocks in one log);
// telemetry_nmea.c reads sentences, with telemetry_sessions.c (their dates). Below them: telemetry_values.c
// (fields) and telemetry_rows.c (what is kept).
#ifndef ORR_INGEST_TELEMETRY_TELEMETRY_PRIVATE_H
#define ORR_INGEST_TELEMETRY_TELEMETRY_PRIVATE_H

#include "ingest/input/input.h"
#include "ingest/telemetry/telemetry.h"

#define TELEMETRY_DAY_S 86400.0
#define TELEMETRY_WEEK_S 604800.0

typedef struct telemetry_reader {
    orr_input *in;
    orr_telemetry *out;
    orr_warnings *notes; // sentences on the log as a whole; may be NULL
    orr_warnings rows;   // rows that are left out
    size_t n_above_sea;  // places whose heights are above sea level: their indices
    size_t *above_sea;
    const orr_leap_table *leap; // NULL: built-in
} telemetry_reader;

// --- columns ---

typedef enum telemetry_quantity {
    Q_SKIP,
    Q_TIME,    // of the log's own clock, or an instant as text
    Q_OF_DAY,  // seconds of a UTC day
    Q_INSTANT, // an instant: text, or seconds since 1970 (UTC)
    Q_DATE,    // a date as text, beside a time of day
    Q_WEEK,    // GPS week
    Q_TOW,     // seconds of it
    Q_LAT,
    Q_LON,
    Q_HEIGHT,     // above the ellipsoid
    Q_HEIGHT_SEA, // above sea level
    Q_GEOID,      // height of the geoid above the ellipsoid
    Q_X,
    Q_Y,
    Q_Z,
    Q_HEADING,
    Q_PITCH,
    Q_ROLL,
    Q_QW, // quaternion
    Q_QX,
    Q_QY,
    Q_QZ,
    Q_FIX,
    Q_COUNT,
} telemetry_quantity;

typedef enum telemetry_form {
    FORM_NUMBER,
    FORM_TEXT_UTC, // date and time as text, in UTC unless it says otherwise
    FORM_TEXT_GPS,
    FORM_OPEN, // a number, or else text in UTC
    FORM_UNIX, // seconds since 1970-01-01 UTC, without leap seconds
} telemetry_form;

typedef struct telemetry_column {
    telemetry_quantity quantity;
    telemetry_form form;
    double scale; // to s, rad, m; of Q_FIX: the least number that counts
    bool assumed; // the unit is the usual one, nothing names it
} telemetry_column;

typedef struct telemetry_table {
    size_t n;
    telemetry_column column[ORR_TELEMETRY_MAX_COLUMNS];
    int where[Q_COUNT]; // column of a quantity, -1 for none
    bool header;        // names stand in the file: a row has as many fields as there are names
    bool enu;           // the quaternion turns body axes forward, left, up into East, North, Up
} telemetry_table;

// The columns that a declaration or a header row names.
//   Given:    text        names divided by
//             separator   (' ' means blanks)
//             header      a header row of the file: names that are not known are skipped with a warning, and
//                         names of autopilots are understood; else every name must be known
//             file, line  for sentences; NULL and 0 of a declaration
//   Returned: out         the columns
//             notes       names that were skipped; may be NULL
//   Notes:    ORR_E_ARG (a name or unit that is not known), ORR_E_FORMAT (no time, no place and no angles),
//             ORR_E_LIMIT.
orr_status telemetry_columns_parse(orr_view text, char separator, bool header, const char *file, int64_t line,
                                   telemetry_table *out, orr_warnings *notes, orr_diag *diag);

// --- fields ---

// What divides the fields of a line: ';', ',', a tab, or blanks (' ').
char telemetry_separator(orr_view line);
// Next field of a row; blanks around it and quotes are cut. False when nothing is left. Start with rest->p not NULL.
bool telemetry_field(orr_view *rest, char separator, orr_view *field);
// A number, with a decimal comma too. BAD where it is no finite number.
orr_field telemetry_number(orr_view field, double *x);
bool telemetry_is_nan(orr_view field);
// Whether a number is whole but for the rounding of its unit.
bool telemetry_is_whole(double x);

// A date and time of day as text. With a date *at is the instant and *of_day_s NAN; a time of day alone
// ("10:00:18.5") is *of_day_s, in seconds, and *at ORR_TIME_NONE. A zone may follow: Z, UTC, GPS, another scale,
// +00:00, -0530. False if it is no time.
//   Given:    field     the text
//             usual     scale of text that names none
//             leap      table of leap seconds; NULL: built-in
//   Returned: at        the instant, or ORR_TIME_NONE
//             of_day_s  the time of day, or NAN
bool telemetry_time_text(orr_view field, orr_scale usual, const orr_leap_table *leap, orr_time *at,
                         double *of_day_s);
// 2024-08-15, 2024/08/15, 20240815, 15.08.2024 to the day (MJD).
bool telemetry_date_text(orr_view field, int32_t *mjd);
// Instant of so many seconds since 1970-01-01 UTC, times `scale`.
orr_time telemetry_unix_time(double x, double scale, const orr_leap_table *leap);

// --- one row of a table ---

typedef struct telemetry_row {
    bool has[Q_COUNT];
    double value[Q_COUNT];
    orr_time at;     // an instant that the row tells as text or in seconds since 1970; ORR_TIME_NONE
    double of_day_s; // a time of day as text; NAN
    int32_t mjd;     // of Q_DATE
    char why[64];    // where a sentence of its own is needed
} telemetry_row;

// Reads a row's fields.
//   Given:    table         its columns
//             separator     what divides them
//             leap          table of leap seconds; NULL: built-in
//             line          the row
//   Returned: r             the fields
//             (value)       NULL, or why the row is to be left out
const char *telemetry_row_read(const telemetry_table *table, char separator, const orr_leap_table *leap,
                               orr_view line, telemetry_row *r);
// Autopilots write 1e-7 deg and mm as whole numbers: where no unit is told and the numbers cannot be degrees, the columns
// and this row are made that. False where the row has no place to judge by.
bool telemetry_row_units(telemetry_table *table, telemetry_reader *reader, telemetry_row *r);
// The row's place; NULL, or why there is none that can be used.
const char *telemetry_row_place(telemetry_row *r, orr_geodetic *at, bool *place, bool *above_sea);
// Angles of the quaternion that turns body axes (forward, right, down) into North, East, Down.
//   Given:    r             the row
//             enu           the quaternion turns forward, left, up into East, North, Up
//   Returned: heading, pitch, roll   rad
//             (value)       false where it has not unit length
bool telemetry_row_turned(const telemetry_row *r, bool enu, double *heading, double *pitch, double *roll);

// --- clocks ---

// A clock of seconds that start again at 0 after a day or a week, made to run on.
typedef struct telemetry_clock {
    bool begun;
    double last_s, added_s;
    double period_s; // of the last time it started again; 0: it never did
} telemetry_clock;
// Seconds that run on; *again tells that the clock has just started again.
double telemetry_clock_run(telemetry_clock *c, double t_s, bool *again);

// Rows that tell two clocks, and the line that ties them.
typedef struct telemetry_ties {
    size_t n;
    double *host_s, *gps_s; // seconds of the log's own clock; GPS time, s after any instant
} telemetry_ties;
orr_status telemetry_ties_add(telemetry_ties *t, double host_s, double gps_s, orr_diag *diag);
void telemetry_ties_free(telemetry_ties *t);
// The robust line gps = host + *offset_s + drift (host - origin).
//   Given:    t         at least one tie; their order is lost
//   Returned: out       origin, drift, scatter
//             offset_s  of the origin
//   Notes:    ORR_E_MEMORY.
orr_status telemetry_tie(const telemetry_ties *t, orr_clock_tie *out, double *offset_s, orr_diag *diag);

// --- sentences of NMEA and their dates ---

typedef struct nmea_event {
    bool place;    // a place; else a date
    double tod_s;  // seconds of the UTC day, up to 86401 in a leap second
    int32_t mjd;   // of a date
    bool doubtful; // of a date: it may be that of a clock that was never set
    orr_geodetic at;
    bool above_sea; // no separation of the geoid
    int64_t line;
    double heading_rad; // that follows a place; NAN: none
    double t_s;         // made by telemetry_dates
} nmea_event;

typedef struct nmea_log {
    size_t n;
    nmea_event *event;
} nmea_log;

// Dates the events: t_s of each, seconds after out->t0 if the log tells dates, else of an unknown UTC day; events of
// sessions that stand in the file in another order are sorted. Notes tell what dates contradict.
orr_status telemetry_dates(nmea_log *log, telemetry_reader *r, orr_diag *diag);

// Whether the text has a sentence "$xxXXX,...*hh" with a good checksum among its first lines.
bool telemetry_is_nmea(orr_view head);
orr_status telemetry_read_nmea(telemetry_reader *r, orr_diag *diag);
// `columns`: a declaration, or NULL.
orr_status telemetry_read_table(telemetry_reader *r, const char *columns, orr_diag *diag);

// --- rows ---

// One place or set of angles, appended.
orr_status telemetry_add_position(orr_telemetry *t, double t_s, orr_geodetic at, int64_t line,
                                  orr_diag *diag);
// Angles, likewise; NAN is an angle that is not given.
//   Given:    t_s                               time
//             heading_rad, pitch_rad, roll_rad  clockwise from North, nose up, right wing down
//             line                              of the file
//   Returned: t                                 the log, longer by one
//   Notes:    ORR_E_LIMIT, ORR_E_MEMORY.
orr_status telemetry_add_attitude(orr_telemetry *t, double t_s, double heading_rad, double pitch_rad,
                                  double roll_rad, int64_t line, orr_diag *diag);
// The last place's height is above sea level.
orr_status telemetry_mark_above_sea(telemetry_reader *r, orr_diag *diag);

// A row that is left out.
void telemetry_drop(telemetry_reader *r, const char *why);

#endif
