// SPDX-License-Identifier: GPL-3.0-or-later
// Broadcast ephemerides judged against a precise orbit: errors along the radius, the track and across it, of
// the clock, and their weighting in a ranging signal (signal-in-space ranging error, Montenbruck et al. 2015,
// GPS Solutions 19:321).
#ifndef ORR_ORBIT_JUDGE_SISRE_H
#define ORR_ORBIT_JUDGE_SISRE_H

#include "ingest/sp3/sp3.h"
#include "orbit/broadcast/broadcast.h"
#include "orbit/force/orbit_class.h"
#include "orbit/spacecraft/attitude.h"

typedef struct orr_sisre_sample {
    orr_sat sat;
    orr_time t;
    double radial_m, along_m, cross_m; // broadcast minus precise, centres of mass
    double clock_m; // c times the clock difference less the system's median at that epoch; NAN without, and
                    // where fewer than four of the system's satellites have one
    double sisre_m; // NAN without a clock
    double age_s;   // t - toe
    orr_orbit_class orbit;
    bool antenna; // its phase centre was known; otherwise the offset is in the errors, mostly in the radial
                  // one
} orr_sisre_sample;

typedef struct orr_sisre_sum { // of one system, or of one kind of orbit in it; all RMS but the mean
    char system;
    orr_orbit_class orbit;                 // ORR_ORBIT_CLASSES: all of the system
    size_t n_sats, n, n_clock, n_outliers; // outliers (above outlier_m) are counted and kept out of the rest
    size_t n_antennas;                     // satellites whose phase centre was known throughout
    double radial_m, along_m, cross_m, clock_m, orbit_3d_m, sisre_m, sisre_95_m, radial_mean_m;
    orr_sat worst;
    double worst_m; // 3-D RMS of the worst satellite
} orr_sisre_sum;

typedef struct orr_sisre_options {
    orr_broadcast_choice choice;
    const orr_antex *antex; // NULL: offsets are taken as zero, and the radial error carries them
    double outlier_m;       // 3-D orbit error above which a sample is an outlier; 0: 50 m (here and below)
} orr_sisre_options;

// Judges broadcast ephemerides by a precise orbit, at every epoch of the SP3 file at which both exist.
// Given:
//   nav      broadcast records
//   truth    precise orbit
//   o        choice of records, antennas, outliers
// Returned:
//   samples  [n] allocated; free it
//   n        how many
//   sums     by system, in the order of ORR_SYSTEMS
//   diag     why it failed; may be NULL
// Errors: ORR_E_NODATA when nothing matches, ORR_E_MEMORY.
// Notes: GLONASS is transformed to ITRF.
// Reference: Montenbruck et al. 2015, GPS Solutions 19:321.
orr_status orr_sisre_run(const orr_nav *nav, const orr_sp3 *truth, const orr_sisre_options *o,
                         orr_sisre_sample **samples, size_t *n, orr_sisre_sum sums[ORR_N_SYSTEMS],
                         orr_diag *diag);
// Sums the samples of one kind of orbit.
// Given:
//   samples    [n]
//   n          how many
//   system     letter of the system
//   orbit      kind of orbit
//   outlier_m  3-D error above which a sample is an outlier, m; 0: 50 m
// Returned:
//   out        the sum; out->n is 0 where there is no such sample
// Errors: ORR_E_MEMORY.
orr_status orr_sisre_sum_orbit(const orr_sisre_sample *samples, size_t n, char system, orr_orbit_class orbit,
                               double outlier_m, orr_sisre_sum *out);

#endif
