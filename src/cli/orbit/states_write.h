// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of `orrery states`: CSV and JSON as a stream, SP3 through its writer.
#ifndef ORR_CLI_ORBIT_STATES_WRITE_H
#define ORR_CLI_ORBIT_STATES_WRITE_H

#include "orbit/ephemeris/ephemeris.h"
#include "src/cli/frame/cli.h"

typedef struct states_request {
    const char *product, *path; // path "-": stdout
    orr_time from, to;          // within the product's span
    int64_t step_ns;
    const orr_sat_set *sats; // NULL: all
} states_request;

typedef struct states_count {
    size_t written, missing; // states, and (satellite, instant) pairs without one
} states_count;

orr_status states_write_table(const orr_ephemeris *e, const states_request *q, bool json, states_count *count,
                              orr_diag *diag);
orr_status states_write_sp3(const orr_ephemeris *e, const states_request *q, states_count *count,
                            orr_diag *diag);

#endif
