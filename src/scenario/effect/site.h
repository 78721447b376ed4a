// SPDX-License-Identifier: GPL-3.0-or-later
// Where the ground below a fixed antenna is at an instant, against where the scenario says that it stands.
#ifndef ORR_SCENARIO_EFFECT_SITE_H
#define ORR_SCENARIO_EFFECT_SITE_H

#include "core/astro.h"
#include "src/config/section_site.h"
#include "src/scenario/effect/ocean_loading.h"

typedef struct orr_site_moved {
    orr_vec3 solid_m, pole_m, ocean_m; // ecef; zero where the scenario does not want them
} orr_site_moved;

// Displacements of a station.
// Given:
//   o      section `site`
//   eop    Earth's rotation; NULL: the secular pole, about which no tide is
//   ocean  the station's ocean loading; NULL: none
//   r_m    station, ecef
//   enu    rows: its East, North and Up
//   sun_m  the Sun, ecef
//   t      instant
orr_site_moved orr_site_at(const orr_scenario_site *o, const orr_eop_series *eop,
                           const orr_ocean_loading *ocean, orr_vec3 r_m, const orr_mat3 *enu, orr_vec3 sun_m,
                           orr_time t);

#endif
