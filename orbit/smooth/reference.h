// SPDX-License-Identifier: GPL-3.0-or-later
// The reference fit of a run's nodes: windows of about a day, one arc a satellite and window, and the
// a-priori states and coefficients that the smoother takes from it. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_REFERENCE_H
#define ORR_ORBIT_SMOOTH_REFERENCE_H

#include "orbit/dynamics/reference_fit.h"
#include "orbit/smooth/track.h"

typedef struct orr_run_reference {
    orr_reference_fit fit;
    size_t n_windows;
    double *border_s;
    orr_satellite_reference *sat; // per list of the table
    // what sat points into
    bool *fitted;
    double (*ecom_nmps2)[ORR_ECOM_TERMS];
    orr_vec3 *state;
    double *t_s;
} orr_run_reference;

// Fits the table's nodes.
// Given:
//   o        options: the given Earth rotation, degree of gravity, threads
//   table    nodes of all satellites
//   hold     o->eop covers the span and is not to be changed
//   cancel   non-zero stops with ORR_E_INTERRUPTED; may be NULL
// Returned:
//   out      the fit, and what each satellite takes from it; free with orr_run_reference_free
// Errors: as orr_reference_fit_run.
orr_status orr_run_reference_make(const orr_smoother_options *o, const orr_node_table *table, bool hold,
                                  const volatile int *cancel, orr_run_reference *out, orr_diag *diag);
// Frees what orr_run_reference_make filled; a zeroed one is allowed.
void orr_run_reference_free(orr_run_reference *r);

// Puts the fitted states in the place of what the nodes alone told (orr_prior_sparse): in a fitted window the
// trajectory starts once and is not restarted.
void orr_reference_use(const orr_track_context *c, const orr_node *list, size_t n, orr_reference *reference);
// The state of a fitted window at node i, where the trajectory is to start anew.
orr_status orr_reference_start_at(const orr_track_context *c, const orr_node *node, orr_reference *reference);

#endif
