// SPDX-License-Identifier: GPL-3.0-or-later
// The way back: broadcast parameters that stand for the precise orbit over a window, quantised as they are
// transmitted, so that a generator modulates data that agree with its ranges.
#ifndef ORR_ORBIT_NAVFIT_H
#define ORR_ORBIT_NAVFIT_H

#include "ingest/rinex_nav.h"
#include "orbit/ephemeris.h"

// Where a satellite's antenna is at an instant: fits go through this, so that a caller may add the
// phase-centre offset. Returns ORR_OK and fills pos (ecef, m), or says that there is nothing.
typedef orr_status (*orr_navfit_source)(void *user, orr_time t, orr_vec3 *pos_m);

typedef struct orr_navfit_report {
    size_t n;            // positions compared
    double rms_m, max_m; // 3-D, model from the quantised parameters against the source, over the window
    double fit_rms_m;    // the same before quantisation
} orr_navfit_report;

// LNAV: the fifteen Kepler parameters at toe by least squares over [toe - window/2, toe + window/2]
// (IS-GPS-200N table 20-III), positions every 300 s or 1/24 of the window, whichever is less, each parameter
// rounded in turn to its LSB and the rest fitted again. On success eph holds kepler (quantised), toe, toc,
// week, fit_interval_h (the window), kind and message; the caller sets clock, issue, health. window_s: 7200
// or 14400 as the fit interval flag knows them, any from 1800 to 21600. ORR_E_NODATA if the source has fewer
// than 9 positions in the window; ORR_E_RANGE if a parameter does not fit its field.
orr_status orr_navfit_lnav(orr_sat sat, orr_time toe, double window_s, orr_navfit_source source, void *user,
                           orr_nav_eph *eph, orr_navfit_report *report, orr_diag *diag);

// GLONASS: position and velocity at tb by least squares over tb +- window/2 (1800 s), with the lunisolar
// acceleration of Sun and Moon at tb, all on their LSBs (2^-11 km, 2^-20 km/s, 2^-30 km/s^2); of the lattice
// points next to the solution the one that fits best. Positions are PZ-90.11 (taken equal to ITRF). The
// caller sets clock, channel, health.
orr_status orr_navfit_glonass(orr_sat sat, orr_time tb, double window_s, orr_navfit_source source, void *user,
                              orr_nav_eph *eph, orr_navfit_report *report, orr_diag *diag);

// Clock polynomial of the product about t0 over +- window/2: af0 and af1 (af2 = 0), rounded to LNAV's or
// GLONASS' LSBs. GLONASS' parameters get the periodic relativity that its message has to hold. *rms_s is what
// is left. ORR_E_NODATA with fewer than two clock values in the window.
orr_status orr_navfit_clock(const orr_ephemeris *e, orr_sat sat, orr_time t0, double window_s,
                            orr_nav_eph *eph, double *rms_s, orr_diag *diag);

// The product's satellite as a source: its centre of mass plus a constant offset in body axes of nominal
// attitude (zero, or the antenna's; X, Y, Z in metres).
typedef struct orr_navfit_product {
    const orr_ephemeris *ephemeris;
    orr_sat sat;
    double offset_m[3];
} orr_navfit_product;
orr_status orr_navfit_from_product(void *product, orr_time t, orr_vec3 *pos_m);

#endif
