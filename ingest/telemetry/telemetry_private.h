// SPDX-License-Identifier: GPL-3.0-or-later
// Inside of the telemetry reader: telemetry.c opens a log and reads tables, telemetry_nmea.c reads NMEA,
// telemetry_columns.c names columns, telemetry_rows.c keeps what is read.
#ifndef ORR_INGEST_TELEMETRY_TELEMETRY_PRIVATE_H
#define ORR_INGEST_TELEMETRY_TELEMETRY_PRIVATE_H

#include "ingest/input/input.h"
#include "ingest/telemetry/telemetry.h"

typedef enum telemetry_quantity {
    Q_SKIP,
    Q_TIME,
    Q_WEEK,
    Q_TOW,
    Q_LAT,
    Q_LON,
    Q_HEIGHT,
    Q_X,
    Q_Y,
    Q_Z,
    Q_HEADING,
    Q_PITCH,
    Q_ROLL,
    Q_FIX,
    Q_COUNT,
} telemetry_quantity;

typedef struct telemetry_column {
    telemetry_quantity quantity;
    double scale;  // to s, rad, m; of Q_FIX: the least number that counts
    int time_text; // 0 number, 1 ISO text in UTC, 2 ISO text in GPS
} telemetry_column;

typedef struct telemetry_table {
    size_t n;
    telemetry_column column[ORR_TELEMETRY_MAX_COLUMNS];
    int where[Q_COUNT]; // column of a quantity, -1 for none
} telemetry_table;

// From a declaration or a header row whose names are divided by `separator` (' ' means blanks). Unknown names
// are skipped with a warning where `lenient`, else refused.
orr_status telemetry_columns_parse(orr_view text, char separator, bool lenient, const char *file,
                                   int64_t line, telemetry_table *out, orr_warnings *warnings,
                                   orr_diag *diag);

// Next field of a row; blanks around it are cut.
bool telemetry_field(orr_view *rest, char separator, orr_view *field);

// One place or set of angles, appended. NULL diag is not allowed.
orr_status telemetry_add_position(orr_telemetry *t, double t_s, orr_geodetic at, int64_t line,
                                  orr_diag *diag);
orr_status telemetry_add_attitude(orr_telemetry *t, double t_s, double heading_rad, double pitch_rad,
                                  double roll_rad, int64_t line, orr_diag *diag);

// A row that is left out.
void telemetry_drop(orr_telemetry *t, const orr_input *in, orr_warnings *w, const char *why);

orr_status telemetry_read_nmea(orr_input *in, orr_telemetry *out, orr_warnings *w, orr_diag *diag);

#endif
