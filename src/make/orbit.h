// SPDX-License-Identifier: GPL-3.0-or-later
// SP3 files and options to an orbit product: what `orrery orbit` writes and what a scenario's `orbit.sp3` is served from.
#ifndef ORR_MAKE_ORBIT_H
#define ORR_MAKE_ORBIT_H

#include "core/log.h"
#include "orbit/ephemeris/ephemeris.h"
#include "orbit/predict/predict.h"
#include "orbit/smooth/smoother.h"
#include "src/config/scenario.h"

typedef struct orr_orbit_plan {
    const char *const *sp3; // of consecutive days, in any order
    size_t n_sp3;
    const char *const *erp; // Earth rotation parameters; n_erp 0: a secular pole, UT1 by the leap seconds
    size_t n_erp;
    const char *const *nav; // navigation files for the a-priori orbit; n_nav 0: from the nodes alone
    size_t n_nav;
    const char *const *clk; // RINEX CLK files, whose clocks come before those of SP3
    size_t n_clk;
    const char
        *gravity_model; // of low orbits, in GeographicLib's format (orr_gravity_model_open_to); NULL: EGM96
    const char *gravity_dir;    // where its files are; NULL: GeographicLib's own folder
    int gravity_degree;         // of it
    const orr_leap_table *leap; // for labels in UTC; NULL: built-in
    bool predict;           // go on to `predict_after`, or the last observed position if that is later, ..
    orr_time predict_after; // ORR_TIME_NONE: to that position
    double predict_s;       // .. and so long beyond it
    // Where a file without a name may lie that holds what is done with, so that of a long span (100000 positions and
    // more) one satellite at a time is in memory; NULL: all are. A prediction needs all.
    const char *folder;
    orr_smoother_options smoother; // eop, nav, clk, n_clk, also and n_also are set by orr_orbit_make
} orr_orbit_plan;

// A plan without files and with the smoother's defaults on all cores.
orr_orbit_plan orr_orbit_plan_default(void);
// What a scenario asks for. The plan borrows from it.
orr_orbit_plan orr_orbit_plan_of(const orr_scenario *s);

typedef struct orr_orbit_made {
    orr_ephemeris *ephemeris;    // carries the names and SHA-256 of all inputs and the smoother's options
    orr_orbit_solution solution; // may be without satellites where the plan has a folder
    orr_smoother_report report;
    orr_predict_report prediction;  // where plan->predict asks for one
    double read_s, smooth_s, fit_s; // wall clock
} orr_orbit_made;

#define ORR_ORBIT_MAX_FILES 400
// Reads every input once, smooths jointly, fits.
// Given:
//   plan      files and options
//   log       progress; may be NULL
//   cancel    ends the smoothing with ORR_E_INTERRUPTED once it is not 0; may be NULL
// Returned:
//   out       product, solution and report; free with orr_orbit_made_free whatever this returned
//   warnings  of readers and smoother; may be NULL
//   diag      why it failed, with file, line and column; may be NULL
// Errors: those of the readers, of the smoother and of the fit; ORR_E_LIMIT for more than ORR_ORBIT_MAX_FILES files of a kind.
orr_status orr_orbit_make(const orr_orbit_plan *plan, const orr_log *log, const volatile int *cancel,
                          orr_orbit_made *out, orr_warnings *warnings, orr_diag *diag);
// The same without the product: out->ephemeris is NULL.
// Given:
//   plan      files and options
//   log       progress; may be NULL
//   cancel    as of orr_orbit_make
// Returned:
//   out       solution and report; free with orr_orbit_made_free whatever this returned
//   warnings  of readers and smoother; may be NULL
//   diag      why it failed; may be NULL
// Errors: those of orr_orbit_make but of the fit.
orr_status orr_orbit_solve(const orr_orbit_plan *plan, const orr_log *log, const volatile int *cancel,
                           orr_orbit_made *out, orr_warnings *warnings, orr_diag *diag);
// Frees all that was made; it is zero then.
void orr_orbit_made_free(orr_orbit_made *m);

#endif
