// SPDX-License-Identifier: GPL-3.0-or-later
// The section `ionosphere` as delays: a field (maps, harmonics, Klobuchar) or a session made by 'orrery
// iono', asked the same way.
#ifndef ORR_SCENARIO_SOURCE_IONO_H
#define ORR_SCENARIO_SOURCE_IONO_H

#include "iono/fusion/session.h"
#include "src/scenario/source_orbit.h"

typedef struct orr_source_iono orr_source_iono;

// *out NULL where the scenario names neither field nor session. `orbits` are borrowed and have to outlive
// it. Errors: those of the readers. Free with orr_source_iono_close.
orr_status orr_source_iono_open(const orr_scenario *s, const orr_source_orbit *orbits, orr_warnings *warnings,
                                orr_source_iono **out, orr_diag *diag);
void orr_source_iono_close(orr_source_iono *i);

// Of the field; a session's own field goes on where its station's observations end. False without an
// ionosphere.
bool orr_source_iono_span(const orr_source_iono *i, orr_span *out);
// Where the session's station is (ecef); false where there is a field alone.
bool orr_source_iono_station(const orr_source_iono *i, orr_vec3 *out);

// As orr_engine_delays.
orr_answer orr_source_iono_evaluate(const orr_source_iono *i, orr_time t, orr_vec3 receiver_m,
                                    const orr_sat *sats, size_t n, orr_realisation *delay,
                                    orr_answer *answer);

#endif
