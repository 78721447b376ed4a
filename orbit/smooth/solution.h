// SPDX-License-Identifier: GPL-3.0-or-later
// What the smoother hands to the product: per satellite, arcs of equally spaced states, clock nodes, the
// input nodes with their residuals, and events. Plain memory; no file knows of it. orbit/smooth/smoother.h
// makes it, orbit/ephemeris/ephemeris.h turns it into Chebyshev segments.
#ifndef ORR_ORBIT_SMOOTH_SOLUTION_H
#define ORR_ORBIT_SMOOTH_SOLUTION_H

#include "core/sat.h"
#include "core/time.h"
#include "core/vec.h"
#include "orbit/clock/clock_judge.h"
#include "orbit/clock/clock_noise.h"
#include "orbit/dynamics/earth_rotation.h"

// State in ecef (ITRS) at one instant. acc is the second derivative of the ecef coordinates (what a
// receiver's polynomial needs), not the specific force.
typedef struct orr_orbit_sample {
    orr_vec3 pos_m, vel_mps, acc_mps2;
    // 1-sigma, scaled by what the data tell, relative to the orbit that the input file has: of position, 3-D; along the
    // radial, along-track and cross-track axes; of velocity, 3-D
    float sigma_m, sigma_rtn_m[3], sigma_mps;
    uint32_t flags; // ORR_EPH_* that hold from this sample to the next
} orr_orbit_sample;

// An unbroken stretch: within it position and velocity are continuous. n >= 2 samples, step_s apart.
typedef struct orr_orbit_arc {
    orr_time t0;
    double step_s;
    size_t n;
    size_t samples_per_segment; // n - 1 is a multiple of it: the segments the product should fit
    orr_orbit_sample *sample;
} orr_orbit_arc;

// An input node and how well the solution meets it.
typedef struct orr_orbit_node {
    orr_time t;
    orr_vec3 residual_m; // solution minus input, ecef
    uint16_t source;     // index of the input file
    uint16_t used;       // 0: rejected as an outlier, or superseded at a day joint
} orr_orbit_node;

typedef enum orr_event_kind {
    ORR_EVENT_MANOEUVRE =
        1, // velocity and f0 restarted within [t0, t1]; value: change of velocity, m/s (0: not known)
    ORR_EVENT_UMBRA = 2,
    ORR_EVENT_PENUMBRA = 3, // partial shadow of the Earth
    ORR_EVENT_OUTLIER = 4,  // a node not used; value: its distance from the orbit, m (0: no orbit there)
    ORR_EVENT_GAP = 5,      // nodes further apart than twice the usual
    ORR_EVENT_DAY_JUMP = 6, // value: jump between input files at a joint, m
    // The file's orbits are noisier near the Earth's shadow: value: by what factor the random walk is larger there
    ORR_EVENT_SHADOW_NOISE = 7,
    ORR_EVENT_NOON_STEP = 8, // the file's orbits have a step of velocity; value: its size, m/s
} orr_event_kind;
typedef struct orr_orbit_event {
    orr_event_kind kind;
    orr_time t0, t1;
    double value; // see kind; 0 where it has none
} orr_orbit_event;

typedef struct orr_orbit_sat {
    orr_sat sat;
    double
        node_noise_m; // 1-sigma of a coordinate of a node about the smooth orbit, as the data tell it; 0: they do not
    size_t n_arcs, n_clocks, n_nodes, n_events;
    orr_orbit_arc *arc;          // ascending, not overlapping
    orr_clock_node *clock;       // ascending; two at one instant where files join: it jumps there
    orr_clock_noise clock_noise; // how it wanders between its nodes; NAN: not known
    orr_orbit_node *node;        // ascending in t
    orr_orbit_event *event;      // ascending in t0
} orr_orbit_sat;

typedef struct orr_orbit_source {
    char name[256]; // base name of the input
    char sha256[65];
} orr_orbit_source;

typedef struct orr_orbit_solution {
    size_t n_sats, n_sources;
    orr_orbit_sat *sat; // ascending
    orr_orbit_source *source;
    double node_step_s;            // the usual step of input nodes
    double clock_max_gap_s;        // longest interval that a clock is interpolated over
    orr_clock_events clock_events; // of all satellites
    orr_time from, to;             // span of the input nodes
    char options[1024];            // the settings in words, for provenance
    orr_earth_rotation rotation;   // that the frame turns with
    char frame[64];                // input's coordinate system, e.g. "IGS20"
} orr_orbit_solution;

// Frees what the solution owns and zeroes it.
void orr_orbit_solution_free(orr_orbit_solution *s);

#endif
