// SPDX-License-Identifier: GPL-3.0-or-later
// What happens when in a scenario: satellites that rise and set, arcs, broadcast data that change, leap seconds. What has a date is
// gathered once; rises and sets are looked for where somebody asks. A pure function of (scenario, interval).
#ifndef ORR_SCENARIO_ENGINE_TIMELINE_H
#define ORR_SCENARIO_ENGINE_TIMELINE_H

#include "src/scenario/engine/engine.h"

typedef enum orr_happening_kind { // as the wire's event_kind
    ORR_HAPPENS_RISE = 1,         // an antenna sees the satellite from then on
    ORR_HAPPENS_SET,              // and from then on it does not
    ORR_HAPPENS_ARC_BEGIN,        // first instant of an arc of its orbit
    ORR_HAPPENS_ARC_END,          // and the last one
    ORR_HAPPENS_EPHEMERIS,        // another set of a message goes on the air; value: its issue
    ORR_HAPPENS_HEALTH,           // with another health; value: the health that is sent
    ORR_HAPPENS_LEAP_SECOND,      // value: GPS less UTC from then on, s
    ORR_HAPPENS_ECLIPSE_BEGIN,    // it comes into the Earth's shadow
    ORR_HAPPENS_ECLIPSE_END,      // and out of it
    ORR_HAPPENS_MANOEUVRE_BEGIN,  // its orbit is being changed
    ORR_HAPPENS_MANOEUVRE_END,    // and is not any more
    ORR_HAPPENS_MOTION_BEGIN,     // the scenario's body is there from then on
    ORR_HAPPENS_MOTION_END,       // and last at
    ORR_HAPPENS_FAULT_BEGIN,      // value: which of the scenario's faults, from 0
    ORR_HAPPENS_FAULT_END,        // and is over
} orr_happening_kind;

enum { ORR_NO_ANTENNA = 0xffff };

typedef struct orr_happening {
    orr_time t;
    orr_happening_kind kind;
    orr_sat sat;             // ORR_SAT_NONE: of no satellite
    uint16_t antenna;        // of a rise or set; ORR_NO_ANTENNA otherwise
    orr_nav_message message; // of EPHEMERIS and HEALTH
    int64_t value;           // see kind; 0 where it has none
} orr_happening;

typedef struct orr_timeline orr_timeline;

// Gathers what has a date. The engine must outlive it; free with orr_timeline_close. Errors: ORR_E_MEMORY.
orr_status orr_timeline_open(const orr_engine *e, orr_timeline **out, orr_diag *diag);
// Frees it; NULL may be closed.
void orr_timeline_close(orr_timeline *l);

// What happens in a stretch of time, ascending; of one instant by kind, satellite and antenna.
// Given:
//   l         the timeline
//   from, to  the stretch, its end not in it
//   max       room for so many
// Returned:
//   out       [at most max] what happens
//   n         how many
// Returns false where there is more than `max`.
// Notes: rises and sets are looked for between instants 1 s apart of an antenna that rides on a body, 10 s apart of others (multiples of
// these in scenario time); one that lasts less may be passed over. Their instants are exact to the nanosecond.
bool orr_timeline_between(const orr_timeline *l, orr_time from, orr_time to, orr_happening *out, size_t max,
                          size_t *n);

#endif
