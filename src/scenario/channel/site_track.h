// SPDX-License-Identifier: GPL-3.0-or-later
// Where the ground below a fixed antenna is over the scenario's time: prepared at nodes, since it takes the Earth's rotation and
// hundreds of tides to say, and changes slowly.
#ifndef ORR_SCENARIO_CHANNEL_SITE_TRACK_H
#define ORR_SCENARIO_CHANNEL_SITE_TRACK_H

#include "src/scenario/channel/sun_track.h"
#include "src/scenario/effect/series.h"
#include "src/scenario/effect/site.h"
#include "src/scenario/source/source.h"

enum { SITE_AXES = 9 }; // three of each kind
typedef struct orr_site_track {
    bool moves; // false: nothing does
    orr_series axis[SITE_AXES];
} orr_site_track;

// Prepares the displacements of a station.
// Given:
//   o      section `site`
//   eop    Earth's rotation; NULL: the secular pole
//   ocean  the station's ocean loading; NULL: none
//   r_m    station, ecef
//   enu    rows: its East, North and Up
//   sun    the Sun over the span
//   span   of time
//   spare  nodes that may still be made
// Returned:
//   spare  less those that were
//   out    the track; free with orr_site_track_free, also after an error
// Errors: ORR_E_LIMIT, ORR_E_MEMORY.
// Notes: nodes are a minute apart. Of 0.5 m that turn twice a day cubics by central differences lose 5e-9 m.
orr_status orr_site_track_open(const orr_scenario_site *o, const orr_eop_series *eop,
                               const orr_ocean_loading *ocean, orr_vec3 r_m, const orr_mat3 *enu,
                               const orr_sun_track *sun, orr_span span, size_t *spare, orr_site_track *out);
// Frees its nodes; of a zeroed track too.
void orr_site_track_free(orr_site_track *s);
// Displacements at an instant of the span.
orr_site_moved orr_site_track_at(const orr_site_track *s, orr_time t);

#endif
