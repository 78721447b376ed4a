// SPDX-License-Identifier: GPL-3.0-or-later
// The scenario file: what one run of the service is made of. docs/scenario.md explains it. Each section is a
// table in a file of its own (section_*.c); the root table in scenario.c puts them together.
#ifndef ORR_CONFIG_SCENARIO_H
#define ORR_CONFIG_SCENARIO_H

#include "src/config/marks.h"
#include "src/config/section_channel.h"
#include "src/config/section_clocks.h"
#include "src/config/section_fast_ionosphere.h"
#include "src/config/section_faults.h"
#include "src/config/section_gravity.h"
#include "src/config/section_imu.h"
#include "src/config/section_ionosphere.h"
#include "src/config/section_jammers.h"
#include "src/config/section_land_mobile.h"
#include "src/config/section_multipath.h"
#include "src/config/section_navdata.h"
#include "src/config/section_obstacles.h"
#include "src/config/section_orbit.h"
#include "src/config/section_receiver.h"
#include "src/config/section_replay.h"
#include "src/config/section_site.h"
#include "src/config/section_spoofers.h"
#include "src/config/section_trajectory.h"
#include "src/config/section_units.h"

// What moves: a trajectory, and what belongs to it.
typedef struct orr_scenario_motion {
    orr_scenario_trajectory trajectory;
    orr_scenario_units units;
    orr_scenario_gravity gravity;
    orr_scenario_imu imu;
} orr_scenario_motion;

typedef struct orr_scenario_serve {
    orr_text_list listen; // URLs
    char *access;         // file of who may come in (src/config/access.h)
    bool insecure_listen;
} orr_scenario_serve;

#define ORR_SCENARIO_SCHEMA 1 // the newest that this program reads

typedef struct orr_scenario {
    char *title;
    int64_t schema; // that the file was written for
    orr_scenario_orbit orbit;
    orr_scenario_navdata navdata;
    orr_scenario_iono iono;
    orr_scenario_receiver receiver;
    orr_scenario_motion motion;
    orr_text_list signals; // "G:L1CA", "E", ...
    orr_scenario_troposphere troposphere;
    bool has_troposphere;
    orr_scenario_antennas antennas;
    orr_scenario_satellites satellites;
    orr_scenario_mask mask;
    orr_scenario_channel channel;
    orr_scenario_obstacles obstacles;
    orr_scenario_jammers jammers;
    orr_scenario_spoofers spoofers;
    orr_scenario_land_mobiles land_mobile;
    orr_scenario_clocks clocks;
    orr_scenario_site site;
    orr_scenario_scintillations scintillation;
    orr_scenario_disturbance disturbance;
    orr_scenario_multipath multipath;
    orr_scenario_faults faults;
    orr_scenario_replay replay;
    bool has_replay;
    orr_scenario_serve serve;
    orr_marks marks;            // where in the file its keys stand
    const orr_leap_table *leap; // that its times were read by and its run goes by; borrowed; NULL: built-in
} orr_scenario;

// The root table of a scenario file.
const orr_schema *orr_scenario_schema(void);

// Reads and checks a scenario. Paths in it are relative to its folder. leap is the run's table of leap seconds and has
// to outlive the scenario; NULL, here and below: built-in. Errors: ORR_E_IO, ORR_E_FORMAT and
// ORR_E_KIND with line, column and path, ORR_E_LIMIT, ORR_E_MEMORY. Free with orr_scenario_free.
orr_status orr_scenario_read(const char *path, const orr_leap_table *leap, orr_scenario *out, orr_diag *diag);
// The same from memory.
// Given:
//   name    of the file, for messages
//   text    [n] its bytes
//   n       how many
//   folder  what relative paths in it refer to
//   leap    table of leap seconds, which has to outlive the scenario
// Returned:
//   out     the scenario; free with orr_scenario_free
//   diag    why it failed; may be NULL
// Errors: as of orr_scenario_read, without ORR_E_IO.
orr_status orr_scenario_parse(const char *name, const char *text, size_t n, const char *folder,
                              const orr_leap_table *leap, orr_scenario *out, orr_diag *diag);
// A product alone, the rest as the tables' defaults have it.
orr_status orr_scenario_of_product(const char *path, const orr_leap_table *leap, orr_scenario *out,
                                   orr_diag *diag);
// What a replay is made of on a command line.
typedef struct orr_scenario_replay_files {
    const char *observations, *sinex, *station, *field, *antex,
        *bias;           // NULL: none, but for observations and field
    const char *product; // or
    const char *const *sp3, *const *clk, *const *erp, *const *nav;
    size_t n_sp3, n_clk, n_erp, n_nav;
    orr_time from, to; // ORR_TIME_NONE: all
    bool no_residuals;
} orr_scenario_replay_files;
// A replay alone, the rest as the tables' defaults have it. Errors: ORR_E_MEMORY.
orr_status orr_scenario_of_replay(const orr_scenario_replay_files *f, const orr_leap_table *leap,
                                  orr_scenario *out, orr_diag *diag);
// A trajectory of logs alone, the rest as the tables' defaults have it.
// Given:
//   file     [n] paths of the logs
//   columns  [n] what their columns are; NULL where a log says that itself
//   n        1 to ORR_TRAJECTORY_MAX_LOGS
//   leap     table of leap seconds, which has to outlive the scenario
// Returned:
//   out      the scenario; free with orr_scenario_free
//   diag     why it failed; may be NULL
// Errors: ORR_E_ARG, ORR_E_MEMORY.
orr_status orr_scenario_of_telemetry(const char *const *file, const char *const *columns, size_t n,
                                     const orr_leap_table *leap, orr_scenario *out, orr_diag *diag);
// Frees all that a scenario holds; zeroed scenarios may be freed.
void orr_scenario_free(orr_scenario *s);

#endif
