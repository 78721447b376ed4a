// SPDX-License-Identifier: GPL-3.0-or-later
// A recorded day made ready for replay: the station's observations less the channels that models make of orbits, clocks, antennas,
// biases and the fused ionosphere give the receiver's clock, the zenith wet delay and the carriers' ambiguities; what is left is
// kept as residuals.
#ifndef ORR_SCENARIO_REPLAY_REPLAY_MAKE_H
#define ORR_SCENARIO_REPLAY_REPLAY_MAKE_H

#include "core/log.h"
#include "src/scenario/channel/channel.h"

// What the estimation told, beside the residuals themselves.
typedef struct orr_replay_report {
    const char *position_from;         // "SINEX" or "header"
    orr_vec3 prior_m, site_m;          // antenna reference point, ecef: as it was given, and as it is used
    orr_vec3 shift_enu_m, sigma_enu_m; // from one to the other; NAN where it was not estimated
    double zenith_wet_m, zenith_least_m,
        zenith_most_m; // estimated wet delay of the zenith: mean, least, greatest
    double clock_least_s, clock_most_s;
    size_t n_clock_steps, n_used, n_rejected, n_arcs; // samples of pairs of carriers, and arcs of ambiguities
    double clock_step_s,
        clock_between_m; // of the satellites' clocks: between nodes, and RMS of what is estimated in between
    double phase_rms_m, code_rms_m; // of the ionosphere-free combinations that were fitted
} orr_replay_report;

// Makes the replay of a scenario's section `replay`, and the channels of its station.
// Given:
//   s         scenario
//   orbits    satellites, borrowed
//   iono      delays, borrowed
//   tables    antennas, biases and records, borrowed
//   log       progress; may be NULL
//   cancel    ends it; may be NULL
// Returned:
//   warnings  what was left out or is not known; may be NULL
//   out       the replay; free with orr_replay_free, after the channels
//   channels  with it; free with orr_channels_close
//   report    what was estimated
//   diag      why it failed
// Errors: those of the readers, of orr_fuse and of orr_channels_open; ORR_E_NODATA (no orbits of the recorded satellites, no
// time in common), ORR_E_NUMERIC, ORR_E_INTERRUPTED, ORR_E_MEMORY.
// Notes: clock and zenith delay follow from ionosphere-free combinations by least squares: each epoch a clock, each arc an
// ambiguity, zenith delays an hour apart, the position, a code delay of each system (of each satellite of GLONASS). The
// content is the field's, carried by the geometry-free phases along each arc and levelled as `orrery iono` levels it.
orr_status orr_replay_make(const orr_scenario *s, const orr_source_orbit *orbits, const orr_source_iono *iono,
                           const orr_source_tables *tables, const orr_log *log, const volatile int *cancel,
                           orr_warnings *warnings, orr_replay **out, orr_channels **channels,
                           orr_replay_report *report, orr_diag *diag);

// Sizes of residuals.
typedef struct orr_replay_rms {
    size_t n_code, n_carrier, n_arcs, n_slips; // slips: as the file's LLI tells them
    double code_m, carrier_m, carrier_cycles;  // RMS; NAN where nothing was recorded
    double code_max_m, carrier_max_m;
} orr_replay_rms;
// Of one track.
orr_replay_rms orr_replay_rms_of(const orr_replay *r, const orr_replay_track *x);
// Of all tracks together.
orr_replay_rms orr_replay_rms_all(const orr_replay *r);

#endif
