// SPDX-License-Identifier: GPL-3.0-or-later
// The ionosphere section of a scenario: a TEC field, or a fused session.
#ifndef ORR_SCENARIO_IONO_SOURCE_H
#define ORR_SCENARIO_IONO_SOURCE_H

#include "iono/fusion/session.h"
#include "src/config/scenario.h"

typedef struct orr_iono_source orr_iono_source;

// *out NULL where the scenario names neither field nor session. Errors: those of the readers.
orr_status orr_iono_source_open(const orr_scenario *s, orr_iono_source **out, orr_warnings *warnings,
                                orr_diag *diag);
void orr_iono_source_close(orr_iono_source *i);

// Where the session's station is (ecef); false where there is a field alone.
bool orr_iono_source_station(const orr_iono_source *i, orr_vec3 *out);

// orr_session_realise or orr_field_realise, whichever it is.
orr_status orr_iono_source_realise(const orr_iono_source *i, orr_time t, orr_vec3 site_m, const orr_sat *sat,
                                   const orr_vec3 *sat_m, size_t n, orr_realisation *out, size_t *n_out,
                                   orr_diag *diag);

#endif
