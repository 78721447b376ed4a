// SPDX-License-Identifier: GPL-3.0-or-later
// Events of an orbit in words: what `orrery orbit` tells of a run and `orrery inspect` of a product.
#ifndef ORR_CLI_ORBIT_ORBIT_EVENTS_H
#define ORR_CLI_ORBIT_ORBIT_EVENTS_H

#include <stddef.h>

#include "orbit/ephemeris/ephemeris.h"

// Short name of a kind: "manoeuvre", "outlier" ...
const char *orbit_event_name(orr_event_kind kind);
// A sentence of one manoeuvre, outlier or gap.
// Given:
//   sat    satellite
//   e      the event
//   orbit  the product, which tells what became of a gap; NULL: not said
//   n      size of buf
// Returned:
//   buf    the sentence
// Returns false for what needs none (eclipses, joints of files).
bool orbit_event_text(orr_sat sat, const orr_orbit_event *e, const orr_ephemeris *orbit, char *buf, size_t n);
// "2 manoeuvres, 8 outliers, 40 eclipses" of a number of satellites' events, kinds that are there alone;
// "none".
typedef struct orbit_event_counts {
    size_t manoeuvres, outliers, gaps, jumps, eclipses;
} orbit_event_counts;
// Adds one satellite's events, which ascend; penumbra, umbra and penumbra in a row are one eclipse.
void orbit_events_count(const orr_orbit_event *e, size_t n, orbit_event_counts *counts);
const char *orbit_events_summary(const orbit_event_counts *counts, char *buf, size_t n);

#endif
