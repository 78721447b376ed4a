// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of `orrery states`: CSV and JSON as a stream, SP3 through its writer; other programs' forms in states_export.c.
#ifndef ORR_CLI_ORBIT_STATES_WRITE_H
#define ORR_CLI_ORBIT_STATES_WRITE_H

#include "src/cli/frame/cli.h"
#include "src/make/products.h"

typedef struct states_request {
    const char *product, *path; // path "-": stdout
    orr_time from, to;          // within the product's span
    int64_t step_ns;
    const orr_sat_set *sats; // NULL: all
    bool inertial;           // axes of the GCRS instead of ecef
} states_request;

typedef struct states_count {
    size_t written, missing; // states, and (satellite, instant) pairs without one
} states_count;

// The states of the asked satellites at an instant.
// Given:
//   p      orbit products
//   q      what is asked for
//   t      the instant
// Returned:
//   out    [p->n_sats] room; as many as are returned, ascending by satellite
//   count  counted on
// Returns how many there are.
size_t states_at(const orr_products *p, const states_request *q, orr_time t, orr_sat_state *out,
                 states_count *count);
// Writes the states as CSV or as JSON.
// Given:
//   p      orbit products
//   q      what is asked for
//   json   JSON; otherwise CSV
// Returned:
//   count  how many states were written, and how many there were not
//   diag   why it failed; may be NULL
orr_status states_write_table(const orr_products *p, const states_request *q, bool json, states_count *count,
                              orr_diag *diag);
// Writes the states as SP3-d; with count and errors as above.
orr_status states_write_sp3(const orr_products *p, const states_request *q, states_count *count,
                            orr_diag *diag);

// Writes the clocks as RINEX CLK 3.00, with sigmas where they are known; with count and errors as above.
orr_status states_write_clk(const orr_products *p, const states_request *q, states_count *count,
                            orr_diag *diag);
// Writes the satellites' attitude as ORBEX 0.09: quaternions from the terrestrial to the body's axes, as IGS has them.
orr_status states_write_orbex(const orr_products *p, const states_request *q, states_count *count,
                              orr_diag *diag);
// Writes the states as an Orbit Ephemeris Message (CCSDS 502.0-B, version 2.0): a segment for each stretch of each satellite.
orr_status states_write_oem(const orr_products *p, const states_request *q, states_count *count,
                            orr_diag *diag);
// Writes the states as NetCDF-4 with CF attributes: dimensions time, satellite, axis.
orr_status states_write_netcdf(const orr_products *p, const states_request *q, states_count *count,
                               orr_diag *diag);

#endif
