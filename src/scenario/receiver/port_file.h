// SPDX-License-Identifier: GPL-3.0-or-later
// What a receiver's ports put out, as files.
#ifndef ORR_SCENARIO_RECEIVER_PORT_FILE_H
#define ORR_SCENARIO_RECEIVER_PORT_FILE_H

#include "src/scenario/observables/observe.h"
#include "src/scenario/receiver/port.h"

#define ORR_PORT_FILES 3

typedef struct orr_port_file {
    orr_port_plan plan; // all of the same channels and antenna
    const char *path;
    size_t bytes; // returned
} orr_port_file;

// Writes the epochs of a plan by all ports, in one pass: those of orr_observe_rinex with the same plan.
// Given:
//   plan     when, and with what noise
//   file, n  [n], 1 to ORR_PORT_FILES
// Returned:
//   file     bytes of each
//   diag     why it failed
// Errors: those of orr_observe_rinex and orr_port_epoch; ORR_E_ARG where epochs do not lie on whole milliseconds and RTCM is asked
// for. No file is left then.
orr_status orr_port_files(const orr_observe_plan *plan, orr_port_file *file, size_t n, orr_diag *diag);

#endif
