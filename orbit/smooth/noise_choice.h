// SPDX-License-Identifier: GPL-3.0-or-later
// How large the noise really is. Only the ratio of f0's random walk to the nodes' variance shapes an orbit;
// the common scale has to come from the data, and where nodes are sparse the ratio as well. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_NOISE_CHOICE_H
#define ORR_ORBIT_SMOOTH_NOISE_CHOICE_H

#include "orbit/smooth/segmentation.h"

typedef struct orr_noise_choice {
    double scale;            // real to formal sigma
    orr_noise_factor factor; // of the filter
    size_t nodes;            // that told
} orr_noise_choice;

// Chooses scale and ratio of the noise. Nodes up to half an hour apart: the scale by the mean square of the innovations,
// the ratio as it is. Sparser ones: both by the largest likelihood of the innovations with priors (ln s about the
// rounding of SP3, 0.30 mm, 0.35; log10 qf in nm^2/s^5 about -3.7, 1.2).
// Given:
//   c            context; its noise factor is what the choice multiplies
//   list         nodes of the satellite
//   verdict      of each node
//   t            the track
//   filtered     the track is filtered already, as context and verdicts say
//   node_step_s  usual distance of nodes, s
// Returned:
//   value        the choice
//   t            its instants' sums of squares are those of the choice; states as before
orr_noise_choice orr_noise_choose(orr_track_context *c, const orr_node *list, const orr_verdict *verdict,
                                  orr_track *t, bool filtered, double node_step_s);

// The same for an orbit that is ruled by what no model here tells (drag, the field's details): ratio and scale by the
// largest likelihood of the innovations, with a wide prior of the scale (ln s about 0.30 mm, 1.5). Few nodes leave it as
// it is. The context's factor is set to the choice.
orr_noise_choice orr_noise_choose_freely(orr_track_context *c, const orr_node *list,
                                         const orr_verdict *verdict, orr_track *t);

// What sigma is made of beside the formal one.
typedef struct orr_claim {
    double times, least_m; // formal sigma times that, in space this at least
} orr_claim;

// Two-hour nodes do not tell what is between them: pressure and attitude near the Earth's shadow err by centimetres that no
// innovation shows. There sigma is a floor and no estimate (docs/orbit.md has what it was measured on).
orr_claim orr_noise_claim(const orr_track_context *c, double node_step_s, bool eclipsing);

// Whether the ratio of the noise is sought from the data where nodes are so far apart.
bool orr_noise_ratio_is_sought(double node_step_s);

// Logarithm of the likelihood of innovations at the scale that suits them best, priors included.
// Given:
//   c            context, its noise as it was filtered with
//   chi2         sum of the innovations' normalised squares, for a scale of one
//   log_det      sum of half the logarithms of their covariances' determinants
//   n            coordinates
//   node_step_s  usual distance of nodes: the ratio has a prior where it was sought
// Returned:
//   value        0 where n is
double orr_noise_evidence(const orr_track_context *c, double chi2, double log_det, size_t n,
                          double node_step_s);

#endif
