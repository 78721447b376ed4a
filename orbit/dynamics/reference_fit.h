// SPDX-License-Identifier: GPL-3.0-or-later
// What a file of orbits tells by itself: orbits of satellites and the Earth's rotation beneath them, fitted
// together. Positions of an SP3 file are fixed to the Earth; the pole and the length of day that they were
// made with are seen in how they move, for all satellites alike. Per satellite and window of time: state and
// nine coefficients of ECOM. For all together: corrections of pole and UT1 at the windows' borders (UT1
// itself, a turn of the sky, is not visible; its rate is).
#ifndef ORR_ORBIT_DYNAMICS_REFERENCE_FIT_H
#define ORR_ORBIT_DYNAMICS_REFERENCE_FIT_H

#include "orbit/force/integrate.h"

typedef struct orr_reference_node {
    double t_s; // since the problem's begin
    orr_vec3 ecef_m;
} orr_reference_node;

// One satellite over one window.
typedef struct orr_reference_arc {
    size_t sat;    // which of the caller's satellites it is
    size_t window; // it lies between border_s[window] and border_s[window + 1]
    size_t n;
    const orr_reference_node *node; // ascending in time
    // returned
    bool fitted; // what follows is an orbit that its nodes agree with
    double t_s;  // of the state: the first node's time
    orr_vec3 r_m, v_mps;
    double ecom_nmps2[ORR_ECOM_TERMS];
    double rms_m;    // of the nodes used, 3-D
    size_t rejected; // nodes that disagree with the others
} orr_reference_arc;

typedef struct orr_reference_problem {
    orr_time from, to;
    size_t n_windows;
    const double *border_s; // n_windows + 1, ascending, from 0 to the span's length
    size_t n_arcs;
    orr_reference_arc *arc;
    const orr_eop_series *eop;  // start of the rotation; NULL: the secular pole and what leap seconds tell
    const orr_leap_table *leap; // these; NULL: built-in
    bool hold;                  // orbits are to be fitted with eop as it is; corrections are told beside
    // To be carried on beyond the nodes: border_s holds three times, the nodes' end the middle one; every arc's
    // window is 1, and it holds nodes of all the time before. The rotation is a polynomial of the whole span,
    // and a node weighs less by e for every forget_s of its age.
    bool forecast;
    double forget_s;
    int gravity_degree; // 2 to 21
    int jobs;
    const volatile int *cancel; // may be NULL; non-zero stops with ORR_E_INTERRUPTED
} orr_reference_problem;

typedef struct orr_reference_fit {
    orr_sky *sky;            // precise, turned by `rotation`
    orr_eop_series rotation; // every three hours, zonal tides in UT1 included, the ocean's not
    bool estimated;          // there were satellites enough to tell
    int passes;
    size_t fitted; // arcs
    double rms_m;  // their median
    // formal, in the middle of the span (of a forecast: at the nodes' end), scaled by the residuals
    double pole_sigma_rad, lod_sigma_s;
    // estimate minus start, there (whether held or not)
    double xp_rad, yp_rad, lod_s;
} orr_reference_fit;

// Gauss-Newton about integrated orbits, satellites eliminated from the normal equations; nodes that disagree
// with their satellite are set aside, satellites count by the inverse square of their residuals. Results do
// not depend on jobs. Errors: ORR_E_ARG (span), ORR_E_MEMORY, ORR_E_INTERRUPTED. With fewer than four
// satellites that can be fitted the rotation stays as it was (estimated is false), save in a forecast, whose orbits it
// serves even where it is poor. Free with orr_reference_fit_free.
orr_status orr_reference_fit_run(const orr_reference_problem *problem, orr_reference_fit *out,
                                 orr_diag *diag);
// Frees sky and rotation and zeroes the fit.
void orr_reference_fit_free(orr_reference_fit *f);

#endif
