// SPDX-License-Identifier: GPL-3.0-or-later
// The section `navdata` as what satellites send at any instant.
#ifndef ORR_SCENARIO_SOURCE_SOURCE_NAVDATA_H
#define ORR_SCENARIO_SOURCE_SOURCE_NAVDATA_H

#include "orbit/navdata/navframe.h"
#include "src/scenario/source/source_orbit.h"
#include "src/scenario/source/source_tables.h"

typedef struct orr_source_navdata orr_source_navdata;

// Fits broadcast data to the orbits.
// Given:
//   s         the scenario
//   orbits    borrowed; they have to outlive the source
//   tables    antennas, biases and records that were read
//   log       progress; may be NULL
//   cancel    ends the fit with ORR_E_INTERRUPTED once it is not 0; may be NULL
// Returned:
//   warnings  of readers and fit; may be NULL
//   out       the source; where the scenario wants no such data, or the orbits have nothing to fit, it has no sets but
//             tells why; NULL without orbits. Free with orr_source_navdata_close
//   diag      why it failed; may be NULL
// Errors: those of the readers, ORR_E_INTERRUPTED, ORR_E_MEMORY.
orr_status orr_source_navdata_open(const orr_scenario *s, const orr_source_orbit *orbits,
                                   const orr_source_tables *tables, const orr_log *log,
                                   const volatile int *cancel, orr_warnings *warnings,
                                   orr_source_navdata **out, orr_diag *diag);
// Frees it; NULL may be closed.
void orr_source_navdata_close(orr_source_navdata *v);

// The span of the sets; false without sets.
bool orr_source_navdata_span(const orr_source_navdata *v, orr_span *out);
// NULL where there are sets, else a sentence that tells why there are none.
const char *orr_source_navdata_none(const orr_source_navdata *v);
// The sets themselves; NULL where there are none.
const orr_navset *orr_source_navdata_set(const orr_source_navdata *v);
// Whether the data describe the antennas' phase centres; else the centres of mass.
bool orr_source_navdata_phase_centres(const orr_source_navdata *v);

// The streams of a satellite whose messages are asked for, as orr_engine_navdata_streams.
size_t orr_source_navdata_streams(const orr_source_navdata *v, orr_sat sat, uint32_t messages,
                                  const orr_nav_stream *list[ORR_NAVSET_STREAMS]);
// What a satellite sends at an instant, as orr_engine_navdata.
// Given:
//   v       the source
//   t       the instant
//   sat     satellite
//   stream  one of its streams; NULL: it has none
//   coded   symbols, not bits
// Returned:
//   set     the set on the air, borrowed
//   frame   the frame of its message that holds t
orr_answer orr_source_navdata_evaluate(const orr_source_navdata *v, orr_time t, orr_sat sat,
                                       const orr_nav_stream *stream, bool coded, const orr_navset_item **set,
                                       orr_navframe *frame);

#endif
