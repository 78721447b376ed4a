// SPDX-License-Identifier: GPL-3.0-or-later
// The section `orbit` as states and elements of satellites at any instant.
#ifndef ORR_SCENARIO_SOURCE_SOURCE_ORBIT_H
#define ORR_SCENARIO_SOURCE_SOURCE_ORBIT_H

#include "core/log.h"
#include "orbit/elements/elements.h"
#include "orbit/ephemeris/ephemeris_slice.h"
#include "src/config/scenario.h"
#include "src/scenario/source/source.h"

typedef struct orr_source_orbit orr_source_orbit;

// Loads the product, or reads and smooths the SP3 files; satellites that these do not have come from orbit.nav and orbit.geo.
// Given:
//   s         the scenario
//   log       progress; may be NULL
//   cancel    ends the smoothing with ORR_E_INTERRUPTED once it is not 0; may be NULL
// Returned:
//   warnings  of readers and smoother; may be NULL
//   out       the source, NULL where the scenario has no orbits; free with orr_source_orbit_close
//   diag      why it failed, with file and line; may be NULL
// Errors: those of the readers, ORR_E_INTERRUPTED.
orr_status orr_source_orbit_open(const orr_scenario *s, const orr_log *log, const volatile int *cancel,
                                 orr_warnings *warnings, orr_source_orbit **out, orr_diag *diag);
// Of an ephemeris, which it takes over (also when it fails).
orr_status orr_source_orbit_of_ephemeris(orr_ephemeris *e, orr_source_orbit **out, orr_diag *diag);
// Frees it; NULL may be closed.
void orr_source_orbit_close(orr_source_orbit *o);

// The span of the orbits; false without orbits.
bool orr_source_orbit_span(const orr_source_orbit *o, orr_span *out);
// The orbits themselves, borrowed; NULL without orbits.
const orr_ephemeris *orr_source_orbit_ephemeris(const orr_source_orbit *o);
// All satellites, ascending, borrowed; how many.
size_t orr_source_orbit_satellites(const orr_source_orbit *o, const orr_sat **list);
// Whether the orbits have a satellite, at whatever instant.
bool orr_source_orbit_has(const orr_source_orbit *o, orr_sat sat);

// States of satellites at an instant, as orr_engine_states.
// Given:
//   o       the source
//   slice   room for all of them at once, of its ephemeris; may be NULL
//   t       the instant
//   sats    [n] which; NULL: all
//   n       how many
// Returned:
//   state   [n] states
//   answer  [n] of each satellite
orr_answer orr_source_orbit_states(const orr_source_orbit *o, orr_ephemeris_slice *slice, orr_time t,
                                   const orr_sat *sats, size_t n, orr_sat_state *state, orr_answer *answer);
// The axes of elements at an instant, as orr_engine_axes.
// Given:
//   o       the source
//   t       the instant
//   frame   the axes
//   method  how elements are made
// Returned:
//   out     the axes
orr_answer orr_source_orbit_axes(const orr_source_orbit *o, orr_time t, orr_elements_frame frame,
                                 orr_elements_method method, orr_elements_axes *out);
// Kepler elements of satellites at the axes' instant, as orr_engine_elements.
// Given:
//   o       the source
//   axes    by orr_source_orbit_axes
//   sats    [n] which; NULL: all
//   n       how many
// Returned:
//   out     [n] elements
//   flags   [n] flags of the states
//   answer  [n] of each satellite
orr_answer orr_source_orbit_elements(const orr_source_orbit *o, const orr_elements_axes *axes,
                                     const orr_sat *sats, size_t n, orr_kepler *out, uint32_t *flags,
                                     orr_answer *answer);

#endif
