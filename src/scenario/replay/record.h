// SPDX-License-Identifier: GPL-3.0-or-later
// A station's observations as the tracks of a replay: which of a file's codes stand for which signal, and what was recorded when.
#ifndef ORR_SCENARIO_REPLAY_RECORD_H
#define ORR_SCENARIO_REPLAY_RECORD_H

#include "src/scenario/effect/replay.h"
#include "src/scenario/source/source_orbit.h"

// Place in orr_signals of an observation code ("1C", "5Q": band and attribute) of a system; -1 where there is no such signal.
// Given:
//   system   letter
//   code     band and attribute
//   version  of RINEX: 3.02 called BeiDou's B1I band 1
// Notes: the components of a signal, alone or together, stand for it.
int orr_record_signal(char system, const char *code, double version);

// Reads observations.
// Given:
//   path      file, of any version of RINEX, Hatanaka or not
//   orbits    satellites that they lack are left out
//   span      and so are epochs outside it
//   wanted    signals, bits of orr_signals
//   leap      table of leap seconds; NULL: built-in
// Returned:
//   warnings  of the reader, codes and epochs that are left out; may be NULL
//   out       tracks without residuals, clocks zero; free with orr_replay_free
//   diag      why it failed
// Errors: those of the reader; ORR_E_NODATA (nothing recorded in the span), ORR_E_UNSUPPORTED (the antenna moves).
// Notes: of several codes of a signal that is taken which was recorded most often.
orr_status orr_record_read(const char *path, const orr_source_orbit *orbits, orr_span span, uint64_t wanted,
                           const orr_leap_table *leap, orr_warnings *warnings, orr_replay **out,
                           orr_diag *diag);

#endif
