// SPDX-License-Identifier: GPL-3.0-or-later
// The section `orbit` as states and elements of satellites at any instant.
#ifndef ORR_SCENARIO_SOURCE_ORBIT_H
#define ORR_SCENARIO_SOURCE_ORBIT_H

#include "core/log.h"
#include "orbit/elements/elements.h"
#include "src/config/scenario.h"
#include "src/scenario/source.h"

typedef struct orr_source_orbit orr_source_orbit;

// Loads the product, or reads and smooths the SP3 files. Errors: those of the readers, with file and line,
// ORR_E_INTERRUPTED. Free with orr_source_orbit_close.
orr_status orr_source_orbit_open(const orr_scenario *s, const orr_log *log, const volatile int *cancel,
                                 orr_warnings *warnings, orr_source_orbit **out, orr_diag *diag);
// Of an ephemeris, which it takes over (also when it fails).
orr_status orr_source_orbit_of_ephemeris(orr_ephemeris *e, orr_source_orbit **out, orr_diag *diag);
void orr_source_orbit_close(orr_source_orbit *o);

bool orr_source_orbit_span(const orr_source_orbit *o, orr_span *out); // false without orbits
const orr_ephemeris *orr_source_orbit_ephemeris(const orr_source_orbit *o);
size_t orr_source_orbit_satellites(const orr_source_orbit *o, const orr_sat **list); // ascending
bool orr_source_orbit_has(const orr_source_orbit *o, orr_sat sat);

// As orr_engine_states, orr_engine_axes and orr_engine_elements.
orr_answer orr_source_orbit_states(const orr_source_orbit *o, orr_time t, const orr_sat *sats, size_t n,
                                   orr_sat_state *state, orr_answer *answer);
orr_answer orr_source_orbit_axes(const orr_source_orbit *o, orr_time t, orr_elements_frame frame,
                                 orr_elements_method method, orr_elements_axes *out);
orr_answer orr_source_orbit_elements(const orr_source_orbit *o, const orr_elements_axes *axes,
                                     const orr_sat *sats, size_t n, orr_kepler *out, uint32_t *flags,
                                     orr_answer *answer);

#endif
