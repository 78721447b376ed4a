// SPDX-License-Identifier: GPL-3.0-or-later
// The replay in the making, among its parts: levels of the content (level.c), observations less channels (model.c), the estimate
// (solve.c), and what is left (residuals.c).
#ifndef ORR_SCENARIO_REPLAY_REPLAY_PRIVATE_H
#define ORR_SCENARIO_REPLAY_REPLAY_PRIVATE_H

#include "src/scenario/channel/sun_track.h"
#include "src/scenario/replay/record.h"
#include "src/scenario/replay/replay_make.h"

typedef struct replay_maker {
    const orr_scenario *s;
    const orr_source_orbit *orbits;
    const orr_source_iono *iono;
    const orr_source_tables *tables;
    const orr_log *log;
    const volatile int *cancel;
    orr_warnings *warnings;
    orr_replay *r;
    orr_channels *c;
    orr_vec3 prior_m, site_m; // antenna reference point as it was given, and where it is taken now
    bool known_site;          // by SINEX
    orr_scenario_troposphere view_troposphere; // as the channels have it
    orr_sun_track sun;
    double clock_step_s; // between nodes of the orbits' clocks: the usual
    size_t n_arcs;       // of pairs
    double **fused_tecu; // [n_sats][sights] content by the fused session; NAN: not levelled
    orr_replay_report *report;
} replay_maker;

// Reads the station's phases and levels them: position, pairs, arcs and fused contents of the maker. Errors: those of
// orr_station_open.
orr_status replay_level(replay_maker *m, orr_diag *diag);

// Opens the channels of the station where it stands now.
orr_status replay_channels(replay_maker *m, orr_diag *diag);

// Observations less channels, with the maker's channels as they are.
// Given:
//   m       maker, its receiver clocks known to a millisecond or not at all
//   every   of so many epochs one
//   settle  whether the clock is found by the codes; else it is kept
// Returned:
//   m       of these epochs residuals code_m and carrier_m of a receiver with a perfect clock, directions, base contents, true
//           instants
// Errors: ORR_E_INTERRUPTED, ORR_E_MEMORY.
orr_status replay_model(replay_maker *m, size_t every, bool settle, orr_diag *diag);
// Finds epochs at which the clock stepped, and what carriers do not follow of it.
orr_status replay_clock_steps(replay_maker *m, orr_diag *diag);

// Least squares over the pairs.
// Given:
//   m       maker after replay_model of the same epochs
//   every   with codes: of so many epochs one
//   codes   codes alone, for a first position
// Returned:
//   m       clocks of these epochs, zenith delays, rejected sights
//   shift_m of the position, ecef
//   diag    why it failed
// Errors: ORR_E_NODATA (fewer than four satellites), ORR_E_NUMERIC, ORR_E_MEMORY.
orr_status replay_solve(replay_maker *m, size_t every, bool codes, orr_vec3 *shift_m, orr_diag *diag);

// Contents by the pairs' geometry-free residuals, levelled.
void replay_contents(replay_maker *m);
// Delays, arcs and residuals of all tracks after the last replay_model. Errors: ORR_E_MEMORY.
orr_status replay_residuals(replay_maker *m, orr_diag *diag);

// Ionosphere-free combination of a sight's pair: a[0] x1 - a[1] x2.
void replay_free_of_ionosphere(const replay_maker *m, const orr_replay_sat *x, double a[2]);
// How far below the centre of mass the phase centres of a system's satellites usually are, m.
double replay_usual_offset_m(char system);
// How far each sight is from the nodes of its satellite's clock. Errors: ORR_E_MEMORY.
orr_status replay_bridges(replay_maker *m, orr_diag *diag);
// Satellites' clocks between their nodes, by what is left of the pairs' phases after the last replay_model. Errors: ORR_E_MEMORY.
orr_status replay_clocks(replay_maker *m, orr_diag *diag);
// Both nodes of a sight's pair; false where it has not both.
bool replay_pair_of(const orr_replay *r, const orr_replay_sat *x, const orr_replay_sight *g,
                    const orr_replay_node *out[2]);
// Variance of its ionosphere-free phase, m^2, without that of the satellite's clock.
double replay_variance_m2(const orr_replay_sight *g);
// Carrier of a satellite's track, Hz.
double replay_carrier_hz(const orr_replay *r, const orr_replay_track *x);

#endif
