// SPDX-License-Identifier: GPL-3.0-or-later
// What a centre's orbits have beside a random walk, found from all satellites of a file together: more noise near the Earth's
// shadow, by one factor a file, and a step of velocity at noon, which some centres leave where they join half-day arcs. Both
// are judged by the likelihood of the filter's innovations. And whether a file's first or last record holds the orbit that the
// others do: some begin with the end of the day before. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_FILE_NOISE_H
#define ORR_ORBIT_SMOOTH_FILE_NOISE_H

#include "orbit/smooth/nodes.h"
#include "orbit/smooth/segmentation.h"

enum { ORR_SHADOW_FACTORS = 4 };
extern const double
    orr_shadow_factor[ORR_SHADOW_FACTORS]; // 1, 30, 1e3, 3e4: of qf within 15 min of the shadow

enum { ORR_FILE_ENDS = 2 }; // first, last

// A satellite's node at an end of a file against the orbit through its others: by how much, and in units of sigma.
typedef struct orr_end_evidence {
    bool told;
    orr_time t;
    double off_m, ratio;
} orr_end_evidence;

// What one satellite tells of one file: logarithms of likelihoods. Zero where it tells nothing.
typedef struct orr_file_evidence {
    bool eclipsing, noon; // it tells of the shadow; of a step at noon
    double shadow[ORR_SHADOW_FACTORS];
    double noon_gain; // with a step less without
    orr_end_evidence end[ORR_FILE_ENDS];
} orr_file_evidence;

// A record at an end of a file that holds another orbit than those after or before it.
typedef struct orr_foreign_record {
    bool foreign;
    orr_time t;
    size_t n;     // satellites that told
    double off_m; // median of their distances
} orr_foreign_record;

// What is known of a file.
typedef struct orr_file_noise {
    double shadow_factor; // 1: no more noise than elsewhere
    bool noon_step;
    size_t eclipsing, telling;     // satellites that told
    double shadow_gain, noon_gain; // logarithms of likelihood, of all together
    orr_foreign_record end[ORR_FILE_ENDS];
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

// What a satellite's first and last node of each file are off the orbit through its others.
// Given:
//   c         context, its noise chosen
//   list, n   nodes of the satellite
//   verdict   of each node
//   t         the track, smoothed
//   scale     real to formal sigma
//   n_files   input files
// Returned:
//   evidence  [n_files], their ends
void orr_file_ends_add(const orr_track_context *c, const orr_node *list, size_t n, const orr_verdict *verdict,
                       const orr_track *t, double scale, size_t n_files, orr_file_evidence *evidence);

// The decision for each file from the evidence of all satellites. A satellite alone cannot outvote the others.
// Given:
//   evidence  [n_sats][n_files]
//   n_sats, n_files
// Returned:
//   file      [n_files]
// Errors: ORR_E_MEMORY.
orr_status orr_file_noise_decide(const orr_file_evidence *evidence, size_t n_sats, size_t n_files,
                                 orr_file_noise *file);

#endif
