// SPDX-License-Identifier: GPL-3.0-or-later
// A product against precise orbits that it was not made from: how far apart, per system and per kind of
// place.
#ifndef ORR_ORBIT_JUDGE_COMPARE_H
#define ORR_ORBIT_JUDGE_COMPARE_H

#include "ingest/sp3/sp3.h"
#include "orbit/ephemeris/ephemeris.h"

// Where in the satellite's input nodes an epoch lies.
typedef enum orr_compare_place {
    ORR_COMPARE_INNER, // at least 2 h from the first and the last node
    ORR_COMPARE_EDGE,  // within 45 min of one of them
    ORR_COMPARE_GAP,   // between nodes further apart than twice the usual (wherever that is)
    ORR_COMPARE_PLACES,
} orr_compare_place;

typedef struct orr_compare_stats {
    size_t n, satellites;           // samples and satellites that have any
    double rms_m, p95_m, max_m;     // of the 3-D difference; NAN where n is 0
    orr_vec3 mean_m;                // product minus truth, ecef: a datum difference shows here
    orr_vec3 rac_rms_m, rac_mean_m; // radial, along-track, cross-track, by the truth's orbit
    size_t n_vel;                   // samples with a velocity of the truth
    double vel_rms_mps;             // 3-D; NAN where n_vel is 0
    // RMS of what the product claims at the same samples, and of what the truth itself is good to: its rounding to a
    // millimetre (0.5 mm in space), or the noise that the product found in its nodes where that is more, for positions of the
    // same centre; for velocities derived from positions what the filter makes of it. NAN where n (n_vel) is 0 or the
    // product claims nothing.
    double sigma_rms_m, vel_sigma_rms_mps, truth_rms_m, vel_truth_rms_mps;
    // RMS of the difference over that of the two together: 1 where sigma is honest
    double error_over_sigma, vel_error_over_sigma;
} orr_compare_stats;

// Satellites that pass the Earth's shadow within the product are harder to know.
typedef enum orr_compare_light {
    ORR_COMPARE_SUNLIT,
    ORR_COMPARE_ECLIPSING,
    ORR_COMPARE_LIGHTS,
} orr_compare_light;

typedef struct orr_compare_system {
    char system;
    orr_compare_stats place[ORR_COMPARE_PLACES];
    orr_compare_stats light[ORR_COMPARE_LIGHTS][ORR_COMPARE_PLACES]; // the same, apart
} orr_compare_system;

typedef struct orr_compare_satellite { // over all places
    orr_sat sat;
    size_t n;
    double rms_m, max_m;
    orr_time worst;
} orr_compare_satellite;

typedef struct orr_comparison {
    size_t n_systems, n_sats;
    orr_compare_system system[ORR_N_SYSTEMS]; // those with samples, in the order of ORR_SYSTEMS
    orr_compare_satellite *sat;               // descending rms
    size_t inputs; // truth's positions at epochs that the product was made from: left out, or not with_inputs
    size_t no_orbit; // left out because the product has no orbit there
    size_t between;  // compared, but in no place: between 45 min and 2 h from an end, or beyond it
    // Epochs of the truth that are off as dynamics/epoch_time.h tells, all satellites alike along their orbits; RMS and most
    size_t late_epochs;
    double late_rms_s, late_most_s;
    bool vel_derived; // some velocities of the truth came from its positions (orbit/judge/velocity_filter.h)
} orr_comparison;

// One epoch of one satellite: product minus truth.
typedef struct orr_compare_difference {
    orr_sat sat;
    int place; // an orr_compare_place; ORR_COMPARE_PLACES: in none
    orr_time t;
    orr_vec3 pos_m, vel_mps; // ecef; vel_mps.x NAN where there is no velocity of one of them
    orr_vec3 rac_m;          // pos_m as radial, along-track, cross-track
    bool eclipsing;
    orr_vec3 motion_mps,
        motion_rac_mps; // velocity of the truth in space, ecef's axes and likewise; NAN: not known
    double truth_gain;  // of its velocity: what an error of its positions is multiplied by
    double sigma_m, sigma_mps, truth_m, truth_mps; // claimed, and of the truth; NAN: not known
} orr_compare_difference;

typedef struct orr_compare_options {
    const orr_sat_set *sats; // NULL: all
    // Takes every difference, a satellite after the other in each of the truth's files; NULL: nobody wants them.
    void (*sink)(void *user, const orr_compare_difference *d);
    void *user;
    bool derive_velocity; // from the truth's positions, whatever V records it has
    bool
        remove_times; // the truth's positions are moved to its epochs; else what they are off is the truth's noise
    bool with_inputs; // also at epochs that the product was made from: for a truth that is another centre's
} orr_compare_options;

// Compares a product with precise orbits.
// Given:
//   e         product
//   truth     [n_truths] precise orbits
//   n_truths  how many
//   options   velocities of the truth, epochs of the input
// Returned:
//   out       sums by system, place and satellite; free with orr_comparison_free
//   diag      why it failed; may be NULL
// Errors: ORR_E_NODATA where not one epoch can be compared, ORR_E_MEMORY.
// Notes: velocities of the truth are its V records, else (or with derive_velocity everywhere) derived from its positions
// within each file. V records are not always the derivatives of the positions beside them: NGA's of 2015 differ from those
// by 6e-5 m/s, a rotation of 2.8e-12 rad/s about an axis fixed in inertial space (precession and nutation).
orr_status orr_compare(const orr_ephemeris *e, const orr_sp3 *truth, size_t n_truths,
                       const orr_compare_options *options, orr_comparison *out, orr_diag *diag);
// Compares precise orbits with others, epoch by epoch where both have a position; places are told by the satellite's own
// first and last positions.
// Given:
//   subject   [n] precise orbits that are judged
//   n         how many
//   truth     [n_truths] precise orbits
//   n_truths  how many
//   options   with_inputs has no effect
// Returned:
//   out       sums by system, place and satellite; free with orr_comparison_free
//   diag      why it failed; may be NULL
// Errors: ORR_E_NODATA where not one epoch is in both, ORR_E_MEMORY.
orr_status orr_compare_sp3(const orr_sp3 *subject, size_t n, const orr_sp3 *truth, size_t n_truths,
                           const orr_compare_options *options, orr_comparison *out, orr_diag *diag);
// Frees what orr_compare allocated; c is empty afterwards.
void orr_comparison_free(orr_comparison *c);

#endif
