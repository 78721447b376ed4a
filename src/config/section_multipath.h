// SPDX-License-Identifier: GPL-3.0-or-later
// Section `multipath`: the ground and other reflectors, as further channels of a signal.
#ifndef ORR_CONFIG_SECTION_MULTIPATH_H
#define ORR_CONFIG_SECTION_MULTIPATH_H

#include "src/config/schema.h"

#define ORR_MAX_ECHOES 5 // of a signal

// Gains of an antenna by elevation above its own horizon, for both circular polarisations.
typedef struct orr_scenario_gain {
    double elevation_deg, rhcp_db, lhcp_db;
} orr_scenario_gain;

typedef struct orr_scenario_ground {
    double height_m; // of antennas above it, or
    double level_m;  // its height above the ellipsoid
    bool has_height, has_level;
    double permittivity, conductivity_spm;
} orr_scenario_ground;

// A reflector by what it does (delay and phase), or by where it is (position).
typedef struct orr_scenario_reflector {
    orr_sat_set sats;
    bool has_sats, has_from, has_to, has_delay;
    orr_time from, to;
    double delay_m, doppler_hz, phase_deg, power_db;
    orr_real_list position, velocity_mps; // latitude, longitude, height; East, North, Up
} orr_scenario_reflector;

typedef struct orr_scenario_multipath {
    orr_scenario_ground ground;
    bool has_ground;
    struct {
        size_t n;
        orr_scenario_reflector *item;
    } reflectors;
    struct {
        size_t n;
        orr_scenario_gain *item;
    } pattern;
    double spacing_chips; // of the correlator that observations are made with; 0: by the signal
} orr_scenario_multipath;

extern const orr_schema orr_section_multipath;

#endif
