// SPDX-License-Identifier: GPL-3.0-or-later
// The main work of the room: sparse precise positions in, a continuous orbit out. Per satellite, an a-priori
// trajectory (numerical integration, restarted at every node), the variational equations about it, and a
// Rauch-Tung-Striebel smoother with state x = (d_eta, d_V, f0) (Bogdanov 2015, section 6, eqs. (33)-(34)).
#ifndef ORR_ORBIT_SMOOTH_SMOOTHER_H
#define ORR_ORBIT_SMOOTH_SMOOTHER_H

#include "core/earth.h"
#include "core/interval.h"
#include "core/log.h"
#include "ingest/rinex/clk.h"
#include "ingest/rinex/rinex_nav.h"
#include "ingest/sp3/sp3.h"
#include "orbit/force/sky.h"
#include "orbit/smooth/solution.h"

typedef enum orr_f0_axes { // axes in which the empirical acceleration f0 is (nearly) constant
    ORR_F0_RTN,            // radial, along-track, cross-track: the default
    ORR_F0_INERTIAL,
    ORR_F0_ECEF, // as (33) is written
} orr_f0_axes;

typedef struct orr_smoother_clk {
    const orr_clk *clk;
    char name[256];
} orr_smoother_clk;

typedef struct orr_smoother_options {
    // a-priori force
    orr_sky_frame frame;
    int gravity_degree;     // 0 central term alone .. 21
    int low_gravity_degree; // the same of low orbits, below 15000 km of radius, which feel more of the field
    // A field with more of them for low orbits, to the degree that it was opened to; NULL: EGM96 as above
    const orr_gravity_model *low_gravity;
    bool zonal_only; // with degree 2: J2 alone
    bool sun_moon;
    double srp_mps2; // plain radiation pressure at 1 au with the Earth's shadow
    // All satellites are fitted first, together with the Earth's rotation beneath them
    // (dynamics/reference_fit.h); the smoother then works about these orbits, with ECOM's coefficients in its
    // state. Without, or where there is nothing to fit, about what the nodes tell one by one, with `plain`
    // noise.
    bool reference;
    // noise about the reference, and without it
    double sigma_m; // of a node's coordinate, 1-sigma; its ratio to qf matters, the scale comes from the data
    double sigma_predicted_m; // of a node flagged as predicted
    double qf_m2ps5;          // random walk of f0; 0: a constant, as the source has it
    double f0_sigma_mps2;     // a-priori of f0 at an arc's start
    struct {
        double sigma_m, sigma_predicted_m, qf_m2ps5, f0_sigma_mps2;
        double qv_m2ps3; // white noise q1..q3 of (33)
        bool choose_qf;  // of low orbits, by likelihood: qf is where the search begins
    } plain;
    orr_f0_axes f0_axes;
    // input
    double node_step_s; // keep only epochs that are multiples of it from midnight of the first file, in the
                        // files' own time systems; 0: all
    bool observed_only; // nodes and clocks that a file flags as predicted are not used
    const orr_interval *exclude; // nodes inside are not used
    size_t n_exclude;
    const orr_sat_set *sats;    // NULL: all
    double max_gap_s;           // longest stretch without nodes that is bridged; an arc ends at a longer one
    const orr_eop_series *eop;  // NULL: IERS' secular pole, UT1 by the leap seconds
    const orr_leap_table *leap; // the run's; NULL: built-in
    // broadcast orbits
    const orr_nav *nav; // a-priori variant A: states at the nodes from broadcast ephemerides where there are
                        // any; NULL: variant B, from the nodes alone
    bool bridge; // with nav: hours without nodes are bridged at broadcast quality, flagged as predicted
    orr_time extend_to; // with bridge: how far beyond the last node; ORR_TIME_NONE: not
    // clocks
    const orr_smoother_clk *clk; // [n_clk] RINEX CLK files, which come before the clocks of SP3
    size_t n_clk;
    double clock_gap_s; // a clock is bridged over so much, and over 1.5 of its steps wherever they are longer
    bool clock_remove_reference; // steps and ramps that all clocks of a system share are taken out
    // provenance: files that the options came from (ERP, navigation); they follow the inputs in the
    // solution's sources
    const orr_orbit_source *also;
    size_t n_also;
    // working
    int passes;    // linearisations: 0 until converged (at most 8), else exactly so many
    bool detect;   // outliers and manoeuvres by innovation, wrong clocks (flags are always heeded)
    double grid_s; // longest step of the filter
    int jobs;      // threads; 1 and more. Results do not depend on it
    // For long spans, of which little is to be in memory at a time; `user` is handed to both.
    struct {
        void *user;
        // The nodes have been taken from the input: its files may be freed. NULL: they stay.
        void (*read)(void *user);
        // A satellite is done with, in no order, by several threads at once; a later call with the same satellite
        // takes the place of an earlier one. It is freed after the call, and the solution has no satellites. NULL: they are in
        // the solution. What it returns ends the run unless it is ORR_OK.
        orr_status (*done)(void *user, const orr_orbit_sat *sat);
    } stream;
} orr_smoother_options;

// The settings that the measured facts call for: a reference fit, 8x8 + Sun + Moon + all that is known of the
// rest, f0 as a random walk in RTN with qf = 10^-14.5 sigma^2/s^5. Without a reference: 1e-7 m/s^2 of
// radiation pressure with shadow, qf = 1e-16 m^2/s^5 beside sigma = 0.025 m.
orr_smoother_options orr_smoother_defaults(void);
// The dissertation to the letter: (33)-(34) in uniformly turning ecef, two-body a-priori, constant f0 beside
// white noise q1..q3, sigma 2.5 cm, one pass, no detection.
orr_smoother_options orr_smoother_literal(void);

typedef struct orr_smoother_input {
    const orr_sp3 *sp3;
    char name[256];
    char sha256[65];
} orr_smoother_input;

// What a run did, in numbers, for the summary.
typedef struct orr_smoother_report {
    size_t satellites; // smoothed
    size_t nodes_used, nodes_rejected, manoeuvres, arcs;
    int passes_max;
    bool eop_known;     // Earth orientation came from the caller's series for the whole span
    bool eop_estimated; // and otherwise from the orbits themselves
    // In the middle of the span, where the orbits tell it: the pole, the excess length of day, the pole's formal sigma;
    // and what it is off the given series.
    bool eop_told;
    double xp_rad, yp_rad, lod_s, pole_sigma_rad, xp_off_rad, yp_off_rad, lod_off_s;
    bool eop_carried_on;   // there is a series, but it does not cover the whole span
    double residual_rms_m; // of used nodes, 3-D
} orr_smoother_report;

// Smooths all satellites of all files jointly.
// Given:
//   input, n_inputs  SP3 files: in any order; they may join at midnight with different values, may overlap
//   options          see orr_smoother_defaults
//   log              progress; may be NULL
//   cancel           looked at between satellites, non-zero stops; may be NULL
// Returned:
//   out              the solution; free with orr_orbit_solution_free
//   report           what the run did, in numbers; may be NULL
//   warnings         satellites that cannot be smoothed (one node alone) are left out with a warning, never silently
// Errors: ORR_E_ARG (options), ORR_E_NODATA (no node left), ORR_E_INTERRUPTED, ORR_E_MEMORY.
orr_status orr_smoother_run(const orr_smoother_input *input, size_t n_inputs,
                            const orr_smoother_options *options, const orr_log *log,
                            const volatile int *cancel, orr_orbit_solution *out, orr_smoother_report *report,
                            orr_warnings *warnings, orr_diag *diag);

#endif
