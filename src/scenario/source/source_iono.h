// SPDX-License-Identifier: GPL-3.0-or-later
// The section `ionosphere` as delays: a field (maps, harmonics, Klobuchar) or a session made by 'orrery
// iono', asked the same way.
#ifndef ORR_SCENARIO_SOURCE_SOURCE_IONO_H
#define ORR_SCENARIO_SOURCE_SOURCE_IONO_H

#include "iono/field/tec_files.h"
#include "iono/fusion/session.h"
#include "src/scenario/source/source_orbit.h"

typedef struct orr_source_iono orr_source_iono;

// How the section `ionosphere` has a field read.
orr_tec_options orr_source_iono_options(const orr_scenario *s);

// Opens the section `ionosphere`.
// Given:
//   s         the scenario
//   orbits    borrowed; they have to outlive the source
// Returned:
//   warnings  of the readers; may be NULL
//   out       the source, NULL where the scenario names neither field nor session; free with orr_source_iono_close
//   diag      why it failed; may be NULL
// Errors: those of the readers.
orr_status orr_source_iono_open(const orr_scenario *s, const orr_source_orbit *orbits, orr_warnings *warnings,
                                orr_source_iono **out, orr_diag *diag);
// Frees it; NULL may be closed.
void orr_source_iono_close(orr_source_iono *i);

// Of the field; a session's own field goes on where its station's observations end. False without an
// ionosphere.
bool orr_source_iono_span(const orr_source_iono *i, orr_span *out);
// Where the session's station is (ecef); false where there is a field alone.
bool orr_source_iono_station(const orr_source_iono *i, orr_vec3 *out);

// Ionospheric delays from a receiver to satellites, as orr_engine_delays.
// Given:
//   i           the source
//   t           the instant
//   receiver_m  place of the receiver (ecef)
//   sats        [n] which; NULL: all
//   n           at most ORR_SESSION_MAX_SATS
// Returned:
//   delay       [n] delays
//   answer      [n] of each satellite
orr_answer orr_source_iono_evaluate(const orr_source_iono *i, orr_time t, orr_vec3 receiver_m,
                                    const orr_sat *sats, size_t n, orr_realisation *delay,
                                    orr_answer *answer);
// Slant contents alone, to satellites whose places are known.
// Given:
//   i           the source
//   t           the instant
//   receiver_m  place of the receiver (ecef)
//   sat         [n] which, and
//   sat_m       [n] where they are at t (ecef)
//   n           at most ORR_SESSION_MAX_SATS
// Returned:
//   stec_tecu   [n] contents; NAN below the horizon, and where the source has no value
// Answers: ORR_ANSWER_OK; ORR_ANSWER_OUTSIDE_SPAN, then nothing is written.
orr_answer orr_source_iono_contents(const orr_source_iono *i, orr_time t, orr_vec3 receiver_m,
                                    const orr_sat *sat, const orr_vec3 *sat_m, size_t n, double *stec_tecu);

#endif
