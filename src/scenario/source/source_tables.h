// SPDX-License-Identifier: GPL-3.0-or-later
// Files that several parts of a scenario look things up in, read once: antennas, biases, broadcast records.
#ifndef ORR_SCENARIO_SOURCE_SOURCE_TABLES_H
#define ORR_SCENARIO_SOURCE_SOURCE_TABLES_H

#include "ingest/rinex/rinex_nav.h"
#include "ingest/tables/antex.h"
#include "ingest/tables/bias.h"
#include "src/config/scenario.h"

typedef struct orr_source_tables {
    bool has_antex, has_bias;
    orr_antex antex;   // navdata.antex, else channel.antex
    orr_bias_set bias; // navdata.bias, else channel.bias
    orr_nav nav;       // navdata.nav
} orr_source_tables;

// Reads what a scenario names.
// Given:
//   s         the scenario
// Returned:
//   warnings  of the readers; may be NULL
//   out       the tables; free with orr_source_tables_close whatever this returned
//   diag      why it failed; may be NULL
// Errors: those of the readers.
orr_status orr_source_tables_open(const orr_scenario *s, orr_warnings *warnings, orr_source_tables *out,
                                  orr_diag *diag);
void orr_source_tables_close(orr_source_tables *t); // leaves *t empty

#endif
