// SPDX-License-Identifier: GPL-3.0-or-later
// A fused session: what a station saw, levelled, with the field it was levelled to. Made once, kept in one
// NetCDF file that needs no other, then evaluated at any instant as a pure function: for the station's own
// antenna, or for another one near it (the station's residuals carried over by collocation, seeded noise for
// what they do not tell).
#ifndef ORR_IONO_FUSION_SESSION_H
#define ORR_IONO_FUSION_SESSION_H

#include "core/ncfile.h"
#include "iono/fusion/fusion.h"

#define ORR_SESSION_MAX_SATS 800 // of one question

typedef struct orr_session_arc {
    orr_sat sat;
    size_t first, n; // samples
    double bias_tecu, sigma_tecu;
    double freq1_hz; // first carrier
} orr_session_arc;

// One satellite at one epoch.
typedef struct orr_session_sample {
    orr_time t;
    double stec_tecu;       // fused: phase minus the arc's bias
    double model_stec_tecu; // the field's own, without correction
    double residual_tecu;   // vertical: stec / mapping - (field + correction); what is carried over
    double mapping;
    orr_vec3 pierce; // unit vector
    double az_rad, el_rad;
} orr_session_sample;

// The small-scale structure that field and correction leave, vertical: its sigma, how it fades with the distance of
// pierce points and with time, both exponential, and the sigma of that part of it that belongs to single satellites
// (errors of their arcs' biases) and not to places.
typedef struct orr_small_scale {
    double sigma_tecu, length_m, time_s, own_tecu;
} orr_small_scale;

typedef struct orr_session {
    char station[64];
    orr_iono_site site;
    char method[16];
    double interval_s, max_gap_s;
    orr_time from, to;
    orr_tec_field *field; // owned
    orr_correction correction;
    size_t n_arcs, n_samples;
    orr_session_arc *arc; // ascending in satellite, then time; samples follow each other likewise
    orr_session_sample *sample;
    orr_small_scale small;
} orr_session;

// Makes a session of a fusion and learns its small-scale structure.
// Given:
//   phase      the station's phases
//   fusion     made of them
//   field      the field of the fusion; the session takes it over, also when this fails
//   max_gap_s  longer gaps between samples of an arc are not bridged
// Returned:
//   out        the session; free with orr_session_free
//   diag       why it failed; may be NULL
// Errors: ORR_E_MEMORY.
orr_status orr_session_make(const orr_phase_tec *phase, const orr_fusion *fusion, orr_tec_field *field,
                            double max_gap_s, orr_session *out, orr_diag *diag);
// Frees what a session holds, its field included.
void orr_session_free(orr_session *s);

// Writes a session as a NetCDF-4 file.
// Given:
//   s                the session
//   path             where to
//   history          the command that made it
//   input, n_inputs  what it was made from; NULL with n_inputs 0
// Returned:
//   diag             why it failed; may be NULL
// Errors: those of core/ncfile.h.
orr_status orr_session_save(const orr_session *s, const char *path, const char *history,
                            const orr_nc_input *input, size_t n_inputs, orr_diag *diag);
// Reads it back, its field to go by a table of leap seconds (NULL: built-in; it has to outlive the session); free with
// orr_session_free. ORR_E_KIND when the file is no session.
orr_status orr_session_load(const char *path, const orr_leap_table *leap, orr_session *out, orr_diag *diag);

// Where a delay came from. The wire uses the same numbers.
typedef enum orr_tec_origin {
    ORR_ORIGIN_FIELD = 0,       // the field alone
    ORR_ORIGIN_FUSED = 1,       // the station's own phase, levelled
    ORR_ORIGIN_TRANSFERRED = 2, // field, and the station's residual of this satellite carried over
    ORR_ORIGIN_NOISE = 3,       // no arc of this satellite now: field, what other rays tell, and seeded noise
} orr_tec_origin;

typedef struct orr_realisation {
    orr_sat sat;
    orr_pierce pierce;
    double mapping, stec_tecu, vtec_tecu;
    double model_stec_tecu; // the field's part
    double sigma_tecu;      // of the slant; NAN where unknown
    orr_tec_origin origin;
    unsigned flags; // ORR_TEC_CLIPPED
} orr_realisation;

typedef struct orr_transfer_options {
    uint64_t seed;
    bool noise; // off: the expectation
} orr_transfer_options;

// Slant TEC from a receiver to satellites.
//   Given:    s        the session
//             t        instant; beyond the session's ends its part tapers off within half an hour, then the field
//                      alone is used
//             site_m   receiver, ecef
//             sat      [n] satellites, and
//             sat_m    [n] their positions, ecef
//             n        at most ORR_SESSION_MAX_SATS
//             options  seed and noise; NULL: seed 1, with noise
//   Returned: out      [n] in the order given, without those below the horizon or where the field has no
//             value
//             n_out    how many were written
//   Notes:    ORR_E_RANGE where the field does not cover t, ORR_E_ARG for a site that is none, ORR_E_LIMIT,
//             ORR_E_NUMERIC.
//             The same call with the same seed always gives the same bytes.
orr_status orr_session_realise(const orr_session *s, orr_time t, orr_vec3 site_m, const orr_sat *sat,
                               const orr_vec3 *sat_m, size_t n, const orr_transfer_options *options,
                               orr_realisation *out, size_t *n_out, orr_diag *diag);
// Slant TEC of a field alone from a receiver to satellites.
// Given:
//   f       the field
//   t       instant
//   site_m  receiver, ecef
//   sat     [n] satellites, and
//   sat_m   [n] their positions, ecef
//   n       number of satellites
// Returned:
//   out     [n] in the order given, without those below the horizon or where the field has no value
//   n_out   how many were written
//   diag    why it failed; may be NULL
// Errors: ORR_E_RANGE where the field does not cover t, ORR_E_ARG for a site that is none.
orr_status orr_field_realise(const orr_tec_field *f, orr_time t, orr_vec3 site_m, const orr_sat *sat,
                             const orr_vec3 *sat_m, size_t n, orr_realisation *out, size_t *n_out,
                             orr_diag *diag);

// Seeded coloured noise of unit variance: a pure function of (seed, satellite, t) whose correlation falls to
// 1/e in about time_s; a cubic B-spline of independent numbers on a lattice, divided by its own standard
// deviation at t.
double orr_coloured_noise(uint64_t seed, orr_sat sat, orr_time t, double time_s);
// The same over a plane and time: places that are alike see the same.
// Given:
//   seed         any number
//   east, north  place, in units of the distance at which the correlation is about 1/e
//   t            instant
//   time_s       time after which the correlation is about 1/e
// Returned: a number of mean 0 and variance 1, continuous in place and time.
double orr_shell_noise(uint64_t seed, double east, double north, orr_time t, double time_s);

#endif
