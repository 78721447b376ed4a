// SPDX-License-Identifier: GPL-3.0-or-later
// Telemetry of a moving body as text: tables of numbers with named columns, NMEA 0183, and user-motion files
// of gps-sdr-sim. Reading only turns rows into places and angles; what is wrong with the flight is for the
// fit to find.
#ifndef ORR_INGEST_TELEMETRY_TELEMETRY_H
#define ORR_INGEST_TELEMETRY_TELEMETRY_H

#include "core/earth.h"
#include "core/status.h"
#include "core/time.h"

#define ORR_TELEMETRY_MAX_ROWS ((size_t)20000000)
#define ORR_TELEMETRY_MAX_COLUMNS 128

typedef enum orr_telemetry_kind {
    ORR_TELEMETRY_TABLE,
    ORR_TELEMETRY_NMEA,
    ORR_TELEMETRY_MOTION_ECEF, // gps-sdr-sim: t, x, y, z
    ORR_TELEMETRY_MOTION_LLH,  // gps-sdr-sim: t, latitude, longitude, height
} orr_telemetry_kind;

// Rows in the order of the file. Times are seconds of the file's own clock after clock_t0 (if absolute), else
// after its zero. A file may hold places, angles or both.
typedef struct orr_telemetry {
    orr_telemetry_kind kind;
    bool absolute; // t0 is known: from ISO times, GPS week and seconds, or NMEA dates
    orr_time t0;   // instant of t_s = 0, where absolute
    size_t n_position;
    double *position_t_s;
    orr_geodetic *position; // radians and metres above the ellipsoid (or whatever the file calls height)
    int64_t *position_line; // of the file
    size_t n_attitude;
    double *attitude_t_s;
    double *heading_rad, *pitch_rad,
        *roll_rad; // clockwise from North, nose up, right wing down; NAN: not given
    int64_t *attitude_line;
    size_t rows;       // data rows seen
    size_t unreadable; // rows left out here: text for a number, NAN, a latitude past a pole, no fix, a wrong
                       // checksum
} orr_telemetry;

// Columns of a table, e.g. "-,t[ms],roll[deg],pitch[-deg],heading[rad]": names divided by commas, each with
// its unit in brackets. Names (aliases): t (time), week, tow, lat, lon, height (alt), x, y, z (ecef), heading
// (yaw), pitch, roll, fix (rows whose number is below fix[>=3] are left out), and '-' for a column to skip.
// Units: s ms us ns min h utc gps (the last two: ISO 8601 text), deg rad, m km ft; a leading '-' turns the
// sign. NULL: the file says so itself, in a header row or a line "# columns: ...", or it has one of the known
// shapes: 7 numbers (t, lat, lon, height, heading, pitch, roll in s, deg, m) or 4 (motion). Fields are
// divided by commas, semicolons, tabs or blanks; lines starting with '#' are comments. Files may be
// compressed. Every row that is left out raises a warning with its line.
//
// Reads a log.
//   Given:    path          of the file
//             columns       declaration of the columns, NULL: the file says so
//   Returned: out           its rows; free with orr_telemetry_free
//             warnings      rows that were left out, columns that are not known; may be NULL
//   Notes:    ORR_E_FORMAT (no telemetry, columns that make no place and no angles), ORR_E_ARG (a bad
//             declaration), ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_telemetry_read(const char *path, const char *columns, orr_telemetry *out,
                              orr_warnings *warnings, orr_diag *diag);

// The same from bytes in memory.
//   Given:    name          of the file, for sentences
//             data, n       its bytes, compressed or not
//             columns       as above
//   Returned: out           its rows; free with orr_telemetry_free
//             warnings      as above
//   Notes:    As above.
orr_status orr_telemetry_read_bytes(const char *name, const void *data, size_t n, const char *columns,
                                    orr_telemetry *out, orr_warnings *warnings, orr_diag *diag);

// Frees the rows; an empty log is allowed.
void orr_telemetry_free(orr_telemetry *t);

#endif
