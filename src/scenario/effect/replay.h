// SPDX-License-Identifier: GPL-3.0-or-later
// A recorded day as what channels need of it beside their models: which satellite's signals were observed when, the content of the
// ionosphere and the zenith delay that the station's own phases tell, what is left of code and carrier at the recorded epochs,
// and the receiver's clock. Made by src/scenario/replay; here it is evaluated, a pure function of time.
#ifndef ORR_SCENARIO_EFFECT_REPLAY_H
#define ORR_SCENARIO_EFFECT_REPLAY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/sat.h"
#include "core/signal.h"
#include "core/time.h"
#include "core/vec.h"

// One satellite at one epoch.
typedef struct orr_replay_sight {
    uint32_t epoch;
    uint32_t arc;     // of the pair's carriers, counted over all satellites
    int32_t at[2];    // nodes of the pair's tracks; -1: none
    bool begins;      // the content does not join that of the sight before
    uint8_t rejected; // outliers of the estimate: 1 the carriers, 2 the codes
    float az_rad, el_rad;
    float body[3];    // direction from the antenna to the satellite in the satellite's own axes
    double base_tecu; // slant content of the scenario's ionosphere
    double more_tecu; // what the station's phases add to it
    double clock_m;   // and to the satellite's clock between nodes of the orbits': its delay
    float bridge_s;   // product of the times to the nodes before and behind, by their sum
} orr_replay_sight;

// A satellite of the record.
typedef struct orr_replay_sat {
    orr_sat sat;
    size_t n;
    orr_replay_sight *sight; // by epoch
    int pair[2];             // tracks of the two carriers that tell the content; -1: none
    double walk_m2ps;        // of the clock between its nodes: variance a second
    bool estimated;          // ANTEX does not know its antenna:
    orr_vec3 offset_m;       // phase centre from the centre of mass in its own axes, for all signals
} orr_replay_sat;

// One signal of one satellite at one epoch.
typedef struct orr_replay_node {
    uint32_t epoch, sight;
    uint32_t arc;               // of the carrier, in its track
    double code, carrier;       // as recorded, m and cycles; NAN: not
    double code_m, carrier_m;   // residuals, m; where nothing was recorded those of a neighbour
    float doppler_hz, cn0_dbhz; // as recorded; NAN: not
    uint8_t lli[2], ssi[2];     // of code and carrier
    bool modelled;              // there is a channel at its epoch
    bool begins;                // there is no channel between the node before and this one
} orr_replay_node;

// What is constant along an arc of a carrier.
typedef struct orr_replay_arc {
    int64_t start; // whole cycles
    double bias_m; // the ambiguity's fraction
} orr_replay_arc;

typedef struct orr_replay_track {
    size_t sat; // in the replay's list
    uint16_t signal;
    size_t n, n_arcs;
    orr_replay_node *node; // by epoch
    orr_replay_arc *arc;
    double delay_m; // of the code: the receiver's, and the satellite's where no file tells it
} orr_replay_track;

// Values at nodes of time; between them cubics, before the first and behind the last held.
typedef struct orr_replay_curve {
    orr_time from; // of node 0
    int64_t step_ns;
    size_t n; // none, or at least two
    double *node;
} orr_replay_curve;

typedef struct orr_replay {
    char marker[64], receiver_type[24], antenna_type[24];
    double antenna_h_m, antenna_e_m, antenna_n_m; // reference point from the marker, as the header has it
    double version;                               // of RINEX
    char code[ORR_MAX_SIGNALS][3]; // RINEX band and attribute of each of orr_signals; "": not observed
    bool has_doppler, has_cn0;
    int8_t glonass_channel[100]; // by slot, as the header tells it; ORR_OBS_NO_CHANNEL
    double interval_s;
    size_t n_epochs;
    orr_time *tag;   // by the receiver's clock
    orr_time *t;     // true, tag - clock
    double *clock_s; // of ranges
    double *held_s;  // of it, what carriers do not follow: steps of whole milliseconds
    uint8_t *flag;   // of the epoch, orr_obs_flag
    bool *steps;     // the clock stepped since the epoch before
    size_t n_sats, n_tracks;
    orr_replay_sat *sat; // ascending
    orr_replay_track *track;
    // Beyond the model's, m: hydrostatic and wet delay of the zenith, and the wet one's gradients.
    orr_replay_curve dry, zenith, north, east;
    bool ready;       // residuals are in use
    double bend_mps2; // greatest jump of a residual carrier's second derivative, that of a code by a hundred
    size_t n_changes;
    orr_time *change; // [n_changes] instants at which channels begin, end, or begin another arc, ascending
} orr_replay;

void orr_replay_free(orr_replay *r); // and what it holds; NULL is allowed

// A satellite's record; NULL: none.
const orr_replay_sat *orr_replay_sat_of(const orr_replay *r, orr_sat sat);
// That of one of its signals (place in orr_signals) likewise.
const orr_replay_track *orr_replay_track_of(const orr_replay *r, orr_sat sat, size_t signal);
// What was recorded of a track at an epoch; NULL: nothing.
const orr_replay_node *orr_replay_node_of(const orr_replay_track *x, size_t epoch);

// A track at an instant.
typedef struct orr_replay_now {
    double code_m, code_mps, carrier_m, carrier_mps; // residuals; 0 until the replay is ready
    double bias_m;
    int64_t start;
    double cn0_dbhz; // NAN: not recorded
} orr_replay_now;
// Given:
//   r, x   replay and its track
//   t      true instant of reception
//   as_of  instant whose arc it is: t, or the begin of the block that ends at t
// Returned:
//   out    the track then
// Returns false where the station did not observe it.
// Notes: between epochs that follow each other cubics through their values with central differences as slopes; a carrier's arc
// holds its last value up to the first epoch of the next.
bool orr_replay_at(const orr_replay *r, const orr_replay_track *x, orr_time t, orr_time as_of,
                   orr_replay_now *out);
// A satellite at an instant.
typedef struct orr_replay_ray {
    double tecu, tecu_ps;      // content beyond the scenario's ionosphere, and its rate
    double clock_m, clock_mps; // delay by the satellite's clock beyond the orbits', and its rate
} orr_replay_ray;
// Given:
//   r, x     replay and its satellite
//   t        true instant of reception
//   as_of    instant whose stretch it is, as orr_replay_at
// Returned:
//   out      the satellite then; before the first and behind the last epoch of a stretch held
void orr_replay_ray_at(const orr_replay *r, const orr_replay_sat *x, orr_time t, orr_time as_of,
                       orr_replay_ray *out);
// A curve at t; 0 without nodes.
double orr_replay_curve_at(const orr_replay_curve *x, orr_time t);
// Weights of nodes at t: the curve is the sum of node[first + k] w[k].
void orr_replay_curve_weights(const orr_replay_curve *x, orr_time t, size_t *first, double w[4]);
// Error of the receiver's clock when it reads `tag`, s, and its rate by that reading.
// Given:
//   r     replay
//   tag   reading
// Returned:
//   rate  of the error
//   held  of the error, what carriers do not follow
double orr_replay_clock_s(const orr_replay *r, orr_time tag, double *rate, double *held);

// Whether a channel begins, ends or begins another arc in (after, until].
bool orr_replay_change(const orr_replay *r, orr_time after, orr_time until);
// Whether blocks of a length may be used: residuals bend where cubics meet, and not on the blocks' edges.
bool orr_replay_allow(const orr_replay *r, int64_t length_ns, double error_m);
// Finds what change and allow need of a finished record; its residuals are in use then, if they are wanted. ORR_E_MEMORY.
orr_status orr_replay_seal(orr_replay *r, bool residuals, orr_diag *diag);

#endif
