// SPDX-License-Identifier: GPL-3.0-or-later
// What a receiver would write down: observations of an antenna's channels as RINEX, and the truth behind them as a table.
#ifndef ORR_SCENARIO_OBSERVABLES_OBSERVE_H
#define ORR_SCENARIO_OBSERVABLES_OBSERVE_H

#include "src/scenario/observables/observer.h"

typedef struct orr_observe_plan {
    orr_time from, to; // both ends are observed
    int64_t step_ns;
    const orr_replay *replay; // of channels that have one; NULL: none
    bool recorded;            // its epochs in place of steps, and of them what was recorded
    double rinex;             // version, 3.05 or 4.02
    bool noise;               // thermal, by C/N0
    uint64_t seed;
    const volatile int *cancel;                              // may be NULL
    void (*progress)(void *user, size_t done, size_t total); // may be NULL
    void *user;
} orr_observe_plan;

typedef struct orr_observe_count {
    size_t epochs, observations; // observations: channels written
} orr_observe_count;

// Observations of an antenna, RINEX: code, phase, Doppler and C/N0 of every signal; receiver clock zero; LLI 1 where an
// arc begins.
// Given:
//   c        channels
//   antenna  which
//   plan     when, and with what noise
//   path     file
// Returned:
//   count    what was written
// Errors: those of the writer, ORR_E_RANGE (an epoch outside the channels' span), ORR_E_INTERRUPTED.
orr_status orr_observe_rinex(const orr_channels *c, size_t antenna, const orr_observe_plan *plan,
                             const char *path, orr_observe_count *count, orr_diag *diag);

// The same channels with all their terms as CSV, without noise.
// Given:
//   c        the channels
//   antenna  which of the scenario's
//   plan     when
//   path     file
// Returned:
//   count    what was written
//   diag     why it failed; may be NULL
orr_status orr_observe_truth(const orr_channels *c, size_t antenna, const orr_observe_plan *plan,
                             const char *path, orr_observe_count *count, orr_diag *diag);
// Where the antenna is, and how it moves and stands, as CSV.
// Given:
//   c        the channels
//   antenna  which of the scenario's
//   plan     when
//   path     file
// Returned:
//   diag     why it failed; may be NULL
orr_status orr_observe_track(const orr_channels *c, size_t antenna, const orr_observe_plan *plan,
                             const char *path, orr_diag *diag);

#endif
