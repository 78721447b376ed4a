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

// How a log's own clock goes, where it tells GPS time beside it: t_s of an angle is host + offset_s +
// drift (host - origin_s).
typedef struct orr_clock_tie {
    size_t n;         // rows that tell both clocks; 0: the log has one clock
    double origin_s;  // middle of the own clock's readings
    double offset_s;  // what t0 is before GPS time at 0 s of the own clock: t0 is a multiple of 10 ms
    double drift;     // of GPS time against the own clock, s/s; 0 where less than a minute determines it
    double scatter_s; // robust standard deviation of the rows about the line
} orr_clock_tie;

// t_s of an instant that the log's own clock tells.
double orr_clock_tied_s(const orr_clock_tie *tie, double host_s);

// Rows in the order of the file; sessions of NMEA logs in the order of time. Times are seconds after t0 (if
// absolute), else after the zero of the file's own clock. A file may hold places, angles or both.
typedef struct orr_telemetry {
    orr_telemetry_kind kind;
    bool absolute;   // t0 is known: from dates, GPS week and seconds, or a line "t in seconds after ... GPS"
    orr_time t0;     // instant of t_s = 0, where absolute
    double period_s; // where not absolute: 86400, the times are seconds of a UTC day that nothing tells;
                     // 604800, of a GPS week; 0, of a clock that has nothing to do with either
    orr_clock_tie tie; // places then have GPS time, angles the own clock brought onto it
    size_t n_position;
    double *position_t_s;
    orr_geodetic *position; // radians and metres above the ellipsoid (or whatever the file calls height)
    int64_t *position_line; // of the file
    size_t n_attitude;
    double *attitude_t_s;
    double *heading_rad, *pitch_rad,
        *roll_rad; // clockwise from North, nose up, right wing down; NAN: not given
    int64_t *attitude_line;
    size_t
        notes; // sentences on the log as a whole that reading it added to the warnings, before those on rows
    size_t rows;       // data rows seen
    size_t unreadable; // rows left out here: text for a number, NAN, a latitude past a pole, no fix, a wrong
                       // checksum
} orr_telemetry;

// Columns of a table, e.g. "-,t[ms],roll[deg],pitch[-deg],heading[rad]": names divided by commas, each with
// its unit in brackets. Names (aliases): t (time), week, tow, instant (datetime, utc), date, lat, lon, height (alt;
// above the ellipsoid), height_msl (above sea level), geoid, x, y, z (ecef), heading (yaw), pitch, roll, qw, qx, qy,
// qz (forward-right-down to North-East-Down, or with [enu] forward-left-up to East-North-Up), fix (rows whose number
// is below fix[>=3] are left out), and '-' for a column to skip. Units: s ms us ns min h, unix (seconds since 1970),
// utc gps (text, ISO 8601 with or without a zone), deg rad degE7 cdeg, m km cm mm ft; a leading '-' turns the sign.
// NULL: the file says so itself, in a header row (names as above, and those of PX4 and ArduPilot) or a line
// "# columns: ...", or it has one of the known shapes: 7 numbers (t, lat, lon, height, heading, pitch, roll in s,
// deg, m) or 4 (motion). Fields are divided by commas, semicolons, tabs or blanks, and may be quoted; with another
// separator a comma may be a decimal one. Lines starting with '#' are comments. Files may be compressed. Every row
// that is left out raises a warning with its line.
//
// Seconds of a day or week that start again at 0 run on. A log that tells GPS time (week and tow, or instants) and a
// clock of its own is tied over its whole length: places have GPS time, angles the own clock brought onto it. NMEA:
// GGA, GNS (places), RMC, ZDA (dates), HDT, THS (headings) of any talker; each session has the date that its valid
// sentences agree on. Heights above sea level without a separation take it from GeographicLib's geoid where that is
// installed, else a warning says that they are taken as they are.
//
// Reads a log.
//   Given:    path          of the file
//             columns       declaration of the columns, NULL: the file says so
//             leap          table of leap seconds; NULL: built-in
//   Returned: out           its rows; free with orr_telemetry_free
//             warnings      what concerns the log as a whole, then rows that were left out; may be NULL
//   Notes:    ORR_E_FORMAT (no telemetry, columns that make no place and no angles), ORR_E_ARG (a bad
//             declaration), ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_telemetry_read(const char *path, const char *columns, const orr_leap_table *leap,
                              orr_telemetry *out, orr_warnings *warnings, orr_diag *diag);

// The same from bytes in memory.
//   Given:    name          of the file, for sentences
//             data, n       its bytes, compressed or not
//             columns       as above
//             leap          as above
//   Returned: out           its rows; free with orr_telemetry_free
//             warnings      as above
//   Notes:    As above.
orr_status orr_telemetry_read_bytes(const char *name, const void *data, size_t n, const char *columns,
                                    const orr_leap_table *leap, orr_telemetry *out, orr_warnings *warnings,
                                    orr_diag *diag);

// Frees the rows; an empty log is allowed.
void orr_telemetry_free(orr_telemetry *t);

#endif
