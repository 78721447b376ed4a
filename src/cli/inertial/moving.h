// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands on trajectories and inertial readings share: a scenario or a telemetry log, with options
// on top.
#ifndef ORR_CLI_INERTIAL_MOVING_H
#define ORR_CLI_INERTIAL_MOVING_H

#include "src/cli/frame/cli.h"
#include "src/config/scenario.h"
#include "src/make/moving.h"

// Options for the tables of such commands; orr_cli_moving_open reads them.
#define ORR_CLI_MOVING_OPTIONS                                                                               \
    {.name = "telemetry",                                                                                    \
     .kind = ORR_OPT_TEXT,                                                                                   \
     .value = "FILE",                                                                                        \
     .repeated = true,                                                                                       \
     .help = "A log instead of a scenario: a table with named columns, NMEA, or a user-motion file of "      \
             "gps-sdr-sim; may be "                                                                          \
             "compressed. Twice for places and angles in two logs on one clock."},                           \
        {.name = "columns",                                                                                  \
         .applies = "telemetry",                                                                             \
         .kind = ORR_OPT_TEXT,                                                                               \
         .value = "LIST",                                                                                    \
         .repeated = true,                                                                                   \
         .help = "Columns of the first, second log, e.g. \"-,t[ms],roll[deg],pitch[-deg],heading\": t, "     \
                 "week, tow, instant, date, lat, lon, height, height_msl, geoid, x, y, z, heading, pitch, "  \
                 "roll, qw, qx, qy, qz, fix[>=3], - to skip one. Not needed where a header says so."},       \
        {.name = "start",                                                                                    \
         .kind = ORR_OPT_TIME,                                                                               \
         .value = "T",                                                                                       \
         .help = "Instant of the begin, overruling scenario and log."},                                      \
        {.name = "duration",                                                                                 \
         .kind = ORR_OPT_DURATION,                                                                           \
         .value = "S",                                                                                       \
         .help = "Length, overruling the scenario."},                                                        \
        {.name = "transfer",                                                                                 \
         .kind = ORR_OPT_TEXT,                                                                               \
         .value = "LAT,LON[,AZ]",                                                                            \
         .help = "Carry the whole trajectory so that its middle comes to this place (degrees), turned by "   \
                 "AZ: 90,0 flies it "                                                                        \
                 "over the pole."},                                                                          \
        {.name = "transfer-attitude",                                                                        \
         .applies = "transfer",                                                                              \
         .kind = ORR_OPT_CHOICE,                                                                             \
         .value = "level|literal",                                                                           \
         .help = "Roll and pitch stay as they were against the ellipsoid's vertical, or against the "        \
                 "geocentric one, (20) as it stands, up to 0.19 deg off. Default level."},                   \
        {.name = "degree",                                                                                   \
         .kind = ORR_OPT_CHOICE,                                                                             \
         .value = "3|5",                                                                                     \
         .help = "Of a log's splines. Default 3."},                                                          \
        {.name = "per-knot",                                                                                 \
         .kind = ORR_OPT_REAL,                                                                               \
         .value = "P",                                                                                       \
         .min = 0.1,                                                                                         \
         .max = 1000,                                                                                        \
         .help = "Samples of a log's places per knot. Default: enough for a knot a second."},                \
        {.name = "attitude-per-knot",                                                                        \
         .kind = ORR_OPT_REAL,                                                                               \
         .value = "P",                                                                                       \
         .min = 0.1,                                                                                         \
         .max = 1000,                                                                                        \
         .help = "Samples of its angles per knot. Default: enough for a knot every 0.2 s."},                 \
    {                                                                                                        \
        .writes = true, .name = "report", .kind = ORR_OPT_TEXT, .value = "FILE",                             \
        .help = "Write every row of the log that was left out (CSV)."                                        \
    }

// Axes of what is written.
#define ORR_CLI_AXES_OPTION                                                                                  \
    {                                                                                                        \
        .name = "axes", .kind = ORR_OPT_CHOICE, .value = "rfu|frd",                                          \
        .help = "Body axes right, forward, up and velocities East, North, Up; or forward, right, down and "  \
                "North, East, Down. Default rfu."                                                            \
    }
orr_imu_axes orr_cli_axes(const orr_cli *c); // what --axes says

// Reads the operand (a scenario) or --telemetry, applies the options, prepares the motion and says what a
// log's fit did. `inputs` (may be NULL) gets the scenario's name and hash. An exit status; on ORR_EXIT_OK free both.
int orr_cli_moving_open(orr_cli *c, orr_scenario *scenario, orr_inputs *inputs, orr_moving *moving);

#endif
