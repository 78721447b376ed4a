// SPDX-License-Identifier: GPL-3.0-or-later
// The files of `orrery simulate`, beside the observations: what satellites send, their true orbits and clocks, readings, and
// the manifest.
#ifndef ORR_CLI_SCENARIO_SIMULATE_FILES_H
#define ORR_CLI_SCENARIO_SIMULATE_FILES_H

#include <jansson.h>

#include "src/cli/frame/cli.h"
#include "src/scenario/engine/engine.h"
#include "src/scenario/observables/observe.h"

// What is being written, and the list of it for the manifest.
typedef struct simulation {
    const orr_cli *c;
    const char *folder;
    const orr_engine *engine;
    orr_scenario *scenario;
    orr_inputs inputs; // the scenario itself
    json_t *files;
} simulation;

#define SIMULATE_PATH 4096
// FOLDER/NAME into path. ORR_E_LIMIT where it is too long; errors of orr_cli_file_check where it may not be written.
orr_status simulate_path(const simulation *s, const char *name, char path[SIMULATE_PATH], orr_diag *diag);
// Adds a file that was written to the manifest's list, with its SHA-256 and a note.
orr_status simulate_note(simulation *s, const char *name, const char *note, orr_diag *diag);

// NAME.rtcm3, NAME.ubx and NAME.nmea of antenna k, those that are asked for: the epochs of its observations.
orr_status simulate_ports(simulation *s, size_t k, const orr_observe_plan *plan, orr_diag *diag);
// NAME-residuals.csv and NAME-residuals.json of a replay.
orr_status simulate_residuals(simulation *s, const char *antenna, orr_diag *diag);
// broadcast.rnx; nothing where the scenario has no broadcast data.
orr_status simulate_broadcast(simulation *s, orr_diag *diag);
// truth.sp3 every 5 min and truth.clk every 30 s, over the orbits' span.
orr_status simulate_orbits(simulation *s, orr_diag *diag);
// imu-N.nc of every unit; nothing without a trajectory.
orr_status simulate_readings(simulation *s, orr_diag *diag);
// manifest.json: versions, scenario, inputs, options, files. `options` is taken over.
orr_status simulate_manifest(simulation *s, json_t *options, orr_diag *diag);

#endif
