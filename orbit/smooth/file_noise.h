// SPDX-License-Identifier: GPL-3.0-or-later
// What a centre's orbits have beside a random walk, found from all satellites of a file together: more noise near the Earth's
// shadow, by one factor a file, and a step of velocity at noon, which some centres leave where they join half-day arcs. Both
// are judged by the likelihood of the filter's innovations. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_FILE_NOISE_H
#define ORR_ORBIT_SMOOTH_FILE_NOISE_H

#include "orbit/smooth/segmentation.h"

enum { ORR_SHADOW_FACTORS = 4 };
extern const double
    orr_shadow_factor[ORR_SHADOW_FACTORS]; // 1, 30, 1e3, 3e4: of qf within 15 min of the shadow

// What one satellite tells of one file: logarithms of likelihoods. Zero where it tells nothing.
typedef struct orr_file_evidence {
    bool eclipsing, noon; // it tells of the shadow; of a step at noon
    double shadow[ORR_SHADOW_FACTORS];
    double noon_gain; // with a step less without
} orr_file_evidence;

// What is known of a file.
typedef struct orr_file_noise {
    double shadow_factor; // 1: no more noise than elsewhere
    bool noon_step;
    size_t eclipsing, telling;     // satellites that told
    double shadow_gain, noon_gain; // logarithms of likelihood, of all together
} orr_file_noise;

// Filters a track with each hypothesis and adds up what its innovations say, file by file, beside what they say without.
// Given:
//   c            context, its noise chosen; c->file is not looked at
//   list         nodes of the satellite
//   verdict      of each node
//   t            the track, its sums those of the noise chosen (orr_noise_choose)
//   node_step_s  usual distance of nodes, s
//   n_files      input files
// Returned:
//   evidence     [n_files], added to
//   t            its sums of squares are of no use any more
void orr_file_evidence_add(orr_track_context *c, const orr_node *list, const orr_verdict *verdict,
                           orr_track *t, double node_step_s, size_t n_files, orr_file_evidence *evidence);

// The decision for each file from the evidence of all satellites. A satellite alone cannot outvote the others.
// Given:
//   evidence  [n_sats][n_files]
//   n_sats, n_files
// Returned:
//   file      [n_files]
void orr_file_noise_decide(const orr_file_evidence *evidence, size_t n_sats, size_t n_files,
                           orr_file_noise *file);

#endif
