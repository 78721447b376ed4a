// SPDX-License-Identifier: GPL-3.0-or-later
// Sections `scintillation` and `disturbance`: what the ionosphere does besides its maps.
#ifndef ORR_CONFIG_SECTION_FAST_IONOSPHERE_H
#define ORR_CONFIG_SECTION_FAST_IONOSPHERE_H

#include "src/config/schema.h"

// Where and when rays scintillate: at the pierce point.
typedef struct orr_scenario_scintillation {
    orr_sat_set sats;
    bool has_sats, has_from, has_to;
    orr_time from, to;
    orr_real_list latitude_deg, longitude_deg, local_time_h; // from and to; none: anywhere, always
    double s4, tau0_s, sigma_phi_rad, slope;                 // at 1575.42 MHz
    int64_t seed;
} orr_scenario_scintillation;
typedef struct orr_scenario_scintillations {
    size_t n;
    orr_scenario_scintillation *item;
} orr_scenario_scintillations;

// A plane wave of vertical content.
typedef struct orr_scenario_tec_wave {
    double amplitude_tecu, length_km, speed_mps, azimuth_deg, phase_deg;
    orr_real_list position; // where and
    orr_time time;          // when its phase is that
} orr_scenario_tec_wave;

// A front: a wedge of slant content that moves.
typedef struct orr_scenario_front {
    double gradient_mmpkm, width_km, speed_mps, azimuth_deg;
    orr_real_list position; // of its foremost edge
    orr_time time;          // then
} orr_scenario_front;

typedef struct orr_scenario_disturbance {
    struct {
        size_t n;
        orr_scenario_tec_wave *item;
    } waves;
    struct {
        size_t n;
        orr_scenario_front *item;
    } fronts;
} orr_scenario_disturbance;

extern const orr_schema orr_section_scintillation, orr_section_disturbance;

#endif
