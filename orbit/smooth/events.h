// SPDX-License-Identifier: GPL-3.0-or-later
// Happenings along a smoothed satellite: eclipses, gaps, joints of files, and the instant of a manoeuvre.
// Room-internal.
#ifndef ORR_ORBIT_SMOOTH_EVENTS_H
#define ORR_ORBIT_SMOOTH_EVENTS_H

#include "orbit/smooth/track.h"

// A growing list.
typedef struct orr_event_list {
    size_t n;
    orr_orbit_event *item;
} orr_event_list;

// Appends an event.
// Given:
//   l       the list
//   kind    of the event
//   t0, t1  first and last instant
//   value   as orbit/smooth/solution.h says for the kind; 0 where it has none
// Returned:
//   l       one longer
// Errors: ORR_E_MEMORY.
orr_status orr_event_add(orr_event_list *l, orr_event_kind kind, orr_time t0, orr_time t1, double value);
void orr_events_sort(orr_event_list *l); // by t0

// Umbra and penumbra of the Earth along an arc of ecef samples, boundaries to a tenth of a second.
orr_status orr_events_eclipses(const orr_sky *sky, const orr_orbit_arc *arc, orr_event_list *l);

// Where two orbits, one known up to a_s, the other from b_s on, come nearest between: the instant of the manoeuvre that
// joins them.
// Given:
//   c              context
//   a_s, before    instant and state (integration axes) at which the first orbit ends
//   b_s, after     likewise where the second one begins
// Returned:
//   when_s         the instant, in a_s..b_s
//   apart_m        distance of the two orbits then
//   dv_mps         change of velocity
// Errors: those of orr_integrate.
orr_status orr_events_manoeuvre(const orr_track_context *c, double a_s, orr_reference before, double b_s,
                                orr_reference after, double *when_s, double *apart_m, double *dv_mps);

#endif
