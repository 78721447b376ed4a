// SPDX-License-Identifier: GPL-3.0-or-later
// The channels of a scenario among their parts: how they are prepared (open.c), what is kept while they are evaluated (work.c),
// slow terms (slow.h) and their sums (channel.c).
#ifndef ORR_SCENARIO_CHANNEL_CHANNELS_PRIVATE_H
#define ORR_SCENARIO_CHANNEL_CHANNELS_PRIVATE_H

#include "ingest/tables/satellite_metadata.h"
#include <stdatomic.h>

#include "orbit/spacecraft/attitude_laws.h"
#include "orbit/spacecraft/signal_delay.h"
#include "src/scenario/channel/block.h"
#include "src/scenario/channel/channel.h"
#include "src/scenario/channel/satellite_cell.h"
#include "src/scenario/channel/site_track.h"
#include "src/scenario/channel/sun_track.h"
#include "src/scenario/channel/windup.h"
#include "src/scenario/effect/clock_noise.h"
#include "src/scenario/effect/disturbance.h"
#include "src/scenario/effect/echo.h"
#include "src/scenario/effect/fault.h"
#include "src/scenario/effect/jammer.h"
#include "src/scenario/effect/land_mobile.h"
#include "src/scenario/effect/obstacle.h"
#include "src/scenario/effect/replay.h"
#include "src/scenario/effect/scintillation.h"
#include "src/scenario/effect/terrain.h"
#include "src/scenario/troposphere/troposphere.h"
#include "src/scenario/troposphere/turbulence.h"

// A signal that a satellite sends.
typedef struct channel_sent {
    uint16_t signal; // place in orr_signals
    double carrier_hz;
    double phase_bias_m;           // 0 where no file tells it
    double power_dbw;              // least received power, of the satellite's block
    const orr_replay_track *track; // what was recorded of it; NULL: no replay
    int64_t start; // the integer of its carrier: up to 8191 cycles, the same for all antennas and for ever
} channel_sent;

enum { CHANNEL_MAX_SENT = 8 }; // signals of a system

// What the scenario says of a satellite, found once.
typedef struct channel_satellite {
    orr_sat sat;
    bool sends;            // satellites.use and exclude
    uint32_t flags;        // UNHEALTHY, NOMINAL_FREQUENCY
    int frequency_channel; // GLONASS
    double power_db;
    orr_attitude_law law;         // of its block, by ANTEX
    bool orbit_normal;            // geostationary satellites of BeiDou and QZSS
    orr_series clock_noise;       // empty: none
    const orr_replay_sat *record; // NULL: no replay
    size_t n_sent;
    channel_sent sent[CHANNEL_MAX_SENT];
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
    orr_troposphere *troposphere;    // NULL: none
    orr_turbulence *turbulence;      // NULL: none
    orr_scenario_channel options;    // antex and bias are not kept
    orr_scenario_mask mask;          // its horizon is owned
    const orr_antex *antex;          // NULL: none
    const orr_bias_set *bias;        // NULL: none
    orr_satellite_metadata metadata; // empty where the scenario names none
    size_t n_antennas;
    orr_antenna antenna[ORR_MAX_ANTENNAS];
    orr_windup windup[ORR_MAX_ANTENNAS];
    uint64_t signals;
    size_t n_sats, max_channels;
    channel_satellite *satellite;            // as orr_source_orbit_satellites
    orr_faults *faults;                      // NULL: none
    orr_echoes *echoes;                      // NULL: none
    const orr_replay *replay;                // borrowed; NULL: none
    orr_disturbance *disturbance;            // NULL: none
    orr_scintillation *scintillation;        // NULL: none
    orr_series oscillator[ORR_MAX_ANTENNAS]; // of receivers; empty: none
    orr_site_track ground[ORR_MAX_ANTENNAS]; // below fixed antennas
    orr_obstacles *obstacles;                // NULL: none
    orr_terrain *terrain;                    // NULL: none
    orr_jammers *jammers;                    // NULL: none
    orr_land_mobile *land_mobile;            // NULL: none
    struct spoofed *spoofed;                 // NULL: none
    double spacing_chips;                    // 0: by the signal
    orr_sun_track sun;
    orr_magnetic *magnetic; // of the second order; NULL: a dipole
    double begin_days;      // of the span, after 2000.0
    orr_span span;
    size_t n_cells;
    channel_cell *cell; // [n_antennas][n_cells]
};

// Space vehicle and block of a satellite, as ANTEX or else satellites.metadata name them; "" without.
void channels_vehicle(const orr_channels *c, orr_sat sat, const char **svn, const char **block);

// The orbits that are evaluated.
static inline const orr_ephemeris *channels_ephemeris(const orr_channels *c)
{
    return orr_source_orbit_ephemeris(c->orbits);
}

// Group delays of a satellite's signals, which change between cells of the lattice alone.
typedef struct channel_delays {
    orr_time cell; // ORR_TIME_NONE: none yet
    double delay_m[CHANNEL_MAX_SENT];
    bool unknown[CHANNEL_MAX_SENT];
} channel_delays;

// Channels of an antenna at an instant.
typedef struct channel_list {
    orr_time t;     // ORR_TIME_NONE: none yet
    orr_time as_of; // whose faults there are
    uint64_t signals;
    size_t n;
    orr_channel *channel;
    uint16_t *place; // [n] satellites, as c->satellite
    bool *seen;      // [n] by the mask
    int64_t *start;  // [n] integers of their carriers
} channel_list;

enum { SLOW_GROUPS = 10 }; // of satellites, whose cells of slow terms begin at different seconds

// What is kept of an antenna.
typedef struct channel_antenna_work {
    struct slow_cell *slow; // [n_sats]
    orr_time candidates_of; // cell of the lattice, ORR_TIME_NONE: none yet
    size_t n_candidates;
    uint16_t *candidate; // [n_sats] satellites that may come above the mask in it
    orr_span leaf
        [SLOW_GROUPS]; // of each group of satellites: stretch in which the antenna's place is a cubic, nearly
    orr_scintillation_cell *fading; // [n_sats], NULL without scintillation
    channel_list end, begin;        // of blocks
} channel_antenna_work;

struct orr_channel_work {
    const orr_channels *c;
    satellite_cell (*satellite)[2];   // [n_sats]
    orr_sat_state *state;             // [n_sats]
    channel_delays *delays;           // [n_sats]
    struct slow_node *node[4];        // [n_sats] each, while cells are made
    struct slow_values *values[2];    // [n_sats] each
    uint16_t *todo, *stale, *missing; // [n_sats]
    uint16_t *chosen;                 // [n_sats] satellites of an epoch, and
    struct seen_direction *direction; // where they stand
    bool *also;                       // [n_sats] those of a block's begin
    channel_antenna_work antenna[ORR_MAX_ANTENNAS];
    orr_channel_work *spoofed; // of the false sky; NULL: none
};

// The channels at t of all satellites that the antenna sees into *list, of which t, signals and n are set.
// Given:
//   c, antenna  channels, and which antenna
//   work        workspace
//   t           instant of reception, of the span
//   as_of       instant whose faults there are: t, or the begin of the block that ends at t
//   at          the antenna then
//   signals     those that are wanted
//   also        [n_sats] satellites that are wanted whether they are seen or not; NULL: none
// Returned:
//   list        channels, by satellite and signal; room for orr_channels_max
void channels_evaluate(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                       orr_time as_of, const orr_antenna_state *at, uint64_t signals, const bool *also,
                       channel_list *list);

// The same, and behind them the false ones of spoofers. Given and Returned: as channels_evaluate.
void channels_receive(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                      orr_time as_of, const orr_antenna_state *at, uint64_t signals, const bool *also,
                      channel_list *list);

// Code, carrier and instant of emission of a channel from its terms.
// Given:
//   t      instant of reception
//   start  integer of its carrier
//   out    channel with its terms and carrier
// Returned:
//   out    with the sums
void channels_sum(orr_time t, int64_t start, orr_channel *out);

// Both ends of a block, and the antenna there.
typedef struct blocks_ends {
    orr_time t0, t1;
    orr_antenna_state at0, at1;
} blocks_ends;
// The blocks between two instants: the begin is the end of those before where they follow each other.
// Given:
//   c, antenna  channels, and which antenna
//   work        workspace
//   e           the ends
//   signals     those that are wanted
// Returned:
//   block, n    as orr_blocks_at
void blocks_between(const orr_channels *c, size_t antenna, orr_channel_work *work, const blocks_ends *e,
                    uint64_t signals, orr_block *block, size_t *n);

#endif
