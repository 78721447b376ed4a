// SPDX-License-Identifier: GPL-3.0-or-later
// The smoothed track as equally spaced samples: states in ecef with their flags and sigma, from which the product's
// segments are fitted. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_SAMPLES_H
#define ORR_ORBIT_SMOOTH_SAMPLES_H

#include "orbit/smooth/segmentation.h"

// Flags (ORR_EPH_*) of what lies between two neighbouring nodes; node_step_s is the usual distance of nodes.
uint32_t orr_samples_flags(const orr_track_context *c, double node_step_s, const orr_node *a,
                           const orr_node *b);

// Samples of a track that filter and smoother have gone over.
// Given:
//   c            context; the reference of each window is taken into use as the samples go by
//   list         nodes of the satellite
//   node_step_s  usual distance of nodes, s
//   t            the track; of a long one steps are made again
//   verdict      of each node: rejected ones bound no flags
//   scale        real to formal sigma
//   arc          its sample holds t->n_samples, zeroed, of which arc->n are filled
// Returned:
//   arc          samples and n
// Errors: ORR_E_MEMORY, ORR_E_NUMERIC.
orr_status orr_samples_make(orr_track_context *c, const orr_node *list, double node_step_s, orr_track *t,
                            const orr_verdict *verdict, double scale, orr_orbit_arc *arc);

#endif
