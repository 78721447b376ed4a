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

orr_status orr_event_add(orr_event_list *l, orr_event_kind kind, orr_time t0, orr_time t1, double value);
void orr_events_sort(orr_event_list *l); // by t0

// Umbra and penumbra of the Earth along an arc of ecef samples, boundaries to a tenth of a second.
orr_status orr_events_eclipses(const orr_sky *sky, const orr_orbit_arc *arc, orr_event_list *l);

// Where two orbits, one known up to a_s, the other from b_s on, come nearest between: the instant of the
// manoeuvre that joins them, how far apart they are then, and the change of velocity. States in integration
// axes at a_s and b_s.
orr_status orr_events_manoeuvre(const orr_track_context *c, double a_s, orr_reference before, double b_s,
                                orr_reference after, double *when_s, double *apart_m, double *dv_mps);

#endif
