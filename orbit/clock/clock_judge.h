// SPDX-License-Identifier: GPL-3.0-or-later
// Clocks that cannot be, judged after what all clocks of a system do together is taken away: one value far off
// its neighbours is left out, a jump of one satellite is marked so that nobody interpolates across it, and a step
// or ramp of all satellites is told once, as the reference clock's.
#ifndef ORR_ORBIT_CLOCK_CLOCK_JUDGE_H
#define ORR_ORBIT_CLOCK_CLOCK_JUDGE_H

#include "core/status.h"
#include "orbit/clock/clock_sources.h"

typedef enum orr_clock_event_kind {
    ORR_CLOCK_EVENT_WRONG = 1, // a lone value that was left out; value: how far it is off its neighbours
    ORR_CLOCK_EVENT_JUMP = 2,  // between t0 and t1; value: its size, roughly
    ORR_CLOCK_EVENT_FLAG = 3,  // the input's own flag at t1; nothing is interpolated from t0
    ORR_CLOCK_EVENT_REFERENCE =
        4, // all clocks of `systems` step (one epoch to the next) or ramp; value: by how much
} orr_clock_event_kind;

typedef struct orr_clock_event {
    orr_clock_event_kind kind;
    orr_sat sat; // ORR_SAT_NONE for the reference's
    orr_time t0, t1;
    double value_s;
    char systems[ORR_N_SYSTEMS + 1]; // letters; the reference's alone, "" otherwise
} orr_clock_event;

typedef struct orr_clock_events {
    size_t n;
    orr_clock_event *item; // ascending in t0, then in sat
} orr_clock_events;

// Judges all clocks.
// Given:
//   max_gap_s         neighbours are nodes up to so far apart
//   detect            look for wrong values and jumps; otherwise flags of the input alone are told
//   remove_reference  the steps and ramps of the reference are taken out: clocks go on as they are after the last of them
//   clocks            clocks of all satellites
// Returned:
//   clocks            without wrong values; the node after a jump has ORR_EPH_CLOCK_EVENT
//   events            what was found; free its item
// Errors: ORR_E_MEMORY.
// Notes: what is usual is judged per satellite, from how far its nodes are off the line between their neighbours: thirty
// times the median of that, and 30 ns (9 m of range) at least, is looked at. A lone error leaves its neighbours on the
// line of what is left when it is left out; a corner or a step leaves at least a third of itself, which is the bound.
// The reference steps where the shared part of an epoch is more than 5 ns and ten times the usual; steps that follow
// each other with one sign are one ramp.
orr_status orr_clock_judge(double max_gap_s, bool detect, bool remove_reference, orr_clock_table *clocks,
                           orr_clock_events *events);

#endif
