// SPDX-License-Identifier: GPL-3.0-or-later
// The orbit product: Chebyshev segments per satellite in ecef, clock nodes, events, provenance. Built once
// (seconds), then evaluated at any instant (nanoseconds) as a pure function of (product, time): no
// allocation, no lock, no I/O. Where there is no valid arc it says so and gives no number.
#ifndef ORR_ORBIT_EPHEMERIS_EPHEMERIS_H
#define ORR_ORBIT_EPHEMERIS_EPHEMERIS_H

#include "core/sat.h"
#include "core/status.h"
#include "core/time.h"
#include "core/vec.h"
#include "orbit/smooth/solution.h"

// State of one satellite at one instant, ecef.
typedef struct orr_sat_state {
    orr_sat sat;
    uint32_t flags;
    orr_vec3 pos_m, vel_mps, acc_mps2;
    double clock_s,
        clock_rate_sps; // NAN without ORR_EPH_CLOCK_VALID; without periodic relativity (add -2 r.v / c^2)
    // 1-sigma of position: 3-D; along the radial, along-track and cross-track axes; of velocity, 3-D. Relative to the orbit
    // that the input has, whose own errors they do not hold. NAN in the last two where a product of an earlier program does
    // not tell them.
    float sigma_m, sigma_rtn_m[3], sigma_mps;
    // Of clock_s against the input's own clock at that instant, what all clocks of a system share apart; NAN: not known.
    float clock_sigma_s;
    orr_time valid_from, valid_to; // the arc that was evaluated
} orr_sat_state;

typedef struct orr_ephemeris orr_ephemeris;

// Fits the segments: the degree is what the arc needs for 0.1 mm and 1e-6 m/s at its samples; an arc too
// rough for any degree (as the literal smoother makes them) gets shorter segments, down to one a sample. Ends
// of neighbouring segments agree in position, velocity and acceleration. Errors: ORR_E_ARG (a solution that
// contradicts itself), ORR_E_NUMERIC (samples that are no numbers), ORR_E_NODATA, ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_ephemeris_build(const orr_orbit_solution *s, orr_ephemeris **out, orr_diag *diag);
// NetCDF-4, CF-style (see docs/product.md). Writing is atomic.
orr_status orr_ephemeris_save(const orr_ephemeris *e, const char *path, const char *history, orr_diag *diag);
// Reads such a file; every count and index is checked. Errors: ORR_E_KIND (no orbit product), ORR_E_UNSUPPORTED (of another version), ORR_E_FORMAT, ORR_E_NODATA, ORR_E_IO, ORR_E_MEMORY. Free
// with orr_ephemeris_free.
orr_status orr_ephemeris_load(const char *path, orr_ephemeris **out, orr_diag *diag);
// Two products of different satellites as one: frame, rotation and what else is of a whole product is a's. Both stay as they
// are. Errors: ORR_E_FORMAT (a satellite is in both), ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_ephemeris_join(const orr_ephemeris *a, const orr_ephemeris *b, orr_ephemeris **out,
                              orr_diag *diag);
// Frees a product; NULL is allowed.
void orr_ephemeris_free(orr_ephemeris *e);

// Satellites of the product, ascending: *list stays valid as long as e.
size_t orr_ephemeris_satellites(const orr_ephemeris *e, const orr_sat **list);
// First and last instant at which at least one satellite has an arc.
void orr_ephemeris_span(const orr_ephemeris *e, orr_time *from, orr_time *to);

// ORR_OK; ORR_E_RANGE outside the product's span; ORR_E_NODATA if the satellite is unknown or has no arc at
// t. *out is untouched unless ORR_OK.
orr_status orr_ephemeris_eval(const orr_ephemeris *e, orr_sat sat, orr_time t, orr_sat_state *out);
// All satellites that have an arc at t, ascending, into out[0..max); returns how many were written.
size_t orr_ephemeris_eval_all(const orr_ephemeris *e, orr_time t, orr_sat_state *out, size_t max);

// What is kept beside the orbit, for reports (borrowed from e): input nodes of a satellite with their residuals.
size_t orr_ephemeris_nodes(const orr_ephemeris *e, orr_sat sat, const orr_orbit_node **list);
// Events of a satellite, ascending in t0.
size_t orr_ephemeris_events(const orr_ephemeris *e, orr_sat sat, const orr_orbit_event **list);
// An arc of a satellite. False where it has not so many.
// Given:
//   e         the product
//   sat       satellite
//   k         which, ascending, from 0
// Returned:
//   from, to  its ends, which belong to it
bool orr_ephemeris_arc(const orr_ephemeris *e, orr_sat sat, size_t k, orr_time *from, orr_time *to);
// Clocks left out, jumps, steps of the reference: of all satellites, ascending in t0.
size_t orr_ephemeris_clock_events(const orr_ephemeris *e, const orr_clock_event **list);
// Clock nodes of a satellite, ascending.
size_t orr_ephemeris_clocks(const orr_ephemeris *e, orr_sat sat, const orr_clock_node **list);
// Files that the product was made of.
size_t orr_ephemeris_sources(const orr_ephemeris *e, const orr_orbit_source **list);
// Noise of a coordinate of the satellite's input nodes about the smooth orbit, 1-sigma, as the data told it: the rounding of
// the file, and what its orbit has beyond. NAN where it is not known.
double orr_ephemeris_node_noise_m(const orr_ephemeris *e, orr_sat sat);
// Usual distance of the input's nodes.
double orr_ephemeris_node_step_s(const orr_ephemeris *e);
// The Earth's rotation that the orbits were made with; its series has n 0 where a product keeps none.
const orr_earth_rotation *orr_ephemeris_rotation(const orr_ephemeris *e);
// The same as orr_eop_at takes it: NULL for the secular pole.
const orr_eop_series *orr_ephemeris_eop(const orr_ephemeris *e);
// Settings of the smoother in words.
const char *orr_ephemeris_options(const orr_ephemeris *e);
// The input's coordinate system, e.g. "IGS20".
const char *orr_ephemeris_frame(const orr_ephemeris *e);
// Largest difference between the segments and the samples that they were fitted to.
void orr_ephemeris_representation(const orr_ephemeris *e, double *pos_m, double *vel_mps);
// Arcs whose segments orr_ephemeris_build had to make shorter than asked (0 for a product from a file).
size_t orr_ephemeris_shortened(const orr_ephemeris *e);

#endif
