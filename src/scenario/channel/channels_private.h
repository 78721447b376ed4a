// SPDX-License-Identifier: GPL-3.0-or-later
// The channels of a scenario among their parts: how they are prepared (open.c) and evaluated (channel.c).
#ifndef ORR_SCENARIO_CHANNEL_CHANNELS_PRIVATE_H
#define ORR_SCENARIO_CHANNEL_CHANNELS_PRIVATE_H

#include <stdatomic.h>

#include "orbit/spacecraft/attitude_laws.h"
#include "orbit/spacecraft/signal_delay.h"
#include "src/scenario/channel/channel.h"
#include "src/scenario/channel/sun_track.h"
#include "src/scenario/channel/windup.h"

// What the scenario says of a satellite, found once.
typedef struct channel_satellite {
    orr_sat sat;
    bool sends;            // satellites.use and exclude
    uint32_t flags;        // UNHEALTHY, NOMINAL_FREQUENCY
    int frequency_channel; // GLONASS
    double power_db;
    orr_attitude_law law; // of its block, by ANTEX
    bool orbit_normal;    // geostationary satellites of BeiDou and QZSS
} channel_satellite;

// Length of the blocks of 10 s, once somebody has asked. It depends on the scenario alone, so whoever decides it first writes
// what all others would.
typedef struct channel_cell {
    _Atomic int64_t length_ns;
    _Atomic double error_m;
    _Atomic int decided;
} channel_cell;

struct orr_channels {
    const orr_source_orbit *orbits;
    const orr_source_iono *iono;
    orr_scenario_troposphere troposphere;
    bool has_troposphere;
    orr_scenario_channel options; // antex and bias are not kept
    orr_scenario_mask mask;       // its horizon is owned
    orr_antex antex;
    bool has_antex;
    orr_bias_set bias;
    bool has_bias;
    size_t n_antennas;
    orr_antenna antenna[ORR_MAX_ANTENNAS];
    orr_windup windup[ORR_MAX_ANTENNAS];
    uint64_t signals;
    size_t n_sats, max_channels;
    channel_satellite *satellite; // as orr_source_orbit_satellites
    orr_sun_track sun;
    orr_span span;
    size_t n_cells;
    channel_cell *cell; // [n_antennas][n_cells]
};

// As orr_channels_at; where `want` is given ([n_sats]) of the satellites that it marks, seen or not.
orr_answer channels_evaluate(const orr_channels *c, size_t antenna, orr_time t, uint64_t signals,
                             const bool *want, orr_channel *out, size_t *n);

#endif
