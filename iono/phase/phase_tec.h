// SPDX-License-Identifier: GPL-3.0-or-later
// Slant TEC up to one constant an arc, from the carrier phases of an observation file (Bogdanov 2015, eqs.
// (37)-(39)): the best pair of signals of every satellite, wind-up taken out, cycle slips found and where
// possible repaired.
#ifndef ORR_IONO_PHASE_PHASE_TEC_H
#define ORR_IONO_PHASE_PHASE_TEC_H

#include "core/sat.h"
#include "core/time.h"
#include "ingest/tables/antex.h"
#include "iono/field/pierce.h"
#include "iono/phase/arcs.h"

// Where satellites are (ecef, at t): false where it is not known. This room does not know orbits.
typedef bool (*orr_position_fn)(void *user, orr_sat sat, orr_time t, orr_vec3 *pos_m);

typedef struct orr_phase_options {
    const orr_sat_set *sats; // NULL: all
    orr_time from, to;       // ORR_TIME_NONE: open
    double step_s;           // leave out epochs less than this after the last one taken; 0: all
    double mask_rad;         // elevation mask (where positions are given)
    const orr_vec3 *site_m;  // NULL: the header's position
    double shell_radius_m;
    bool windup;
    // Phase centres of the satellites' antennas, which stand metres apart for different carriers on some: measurements
    // are referred to one point. NULL: not.
    const orr_antex *antex;
    orr_position_fn position; // NULL: no geometry (no mask, no wind-up)
    void *user;
    orr_arc_options arcs;
    const orr_leap_table *leap;
    uint64_t max_samples; // of all satellites together
    // Frequency channels of GLONASS by slot where the header does not tell them (ORR_OBS_NO_CHANNEL: not known
    // either); NULL: none
    const int8_t *glonass_channel;
} orr_phase_options;
orr_phase_options orr_phase_default_options(void); // 10 degrees, 6821 km, wind-up, 50 million samples

// One satellite; all arrays have n entries in time order.
typedef struct orr_phase_sat {
    orr_sat sat;
    char phase[2][4], range[2][4]; // codes in use; range empty where there is no code on a carrier
    double freq_hz[2];
    size_t n;
    orr_time *t;
    double *gf_tecu; // (38) after wind-up and repairs: slant TEC + one constant an arc
    double
        *code_tecu; // K (P2 - P1): slant TEC + biases of satellite and receiver; NAN where a code is missing
    double *windup; // cycles taken out
    orr_pierce *pierce; // zeroes without positions
    orr_arcs arcs;      // arc_of[i] = -1: not in use
} orr_phase_sat;

typedef struct orr_phase_tec {
    char marker[64];
    orr_iono_site site;
    bool has_geometry;
    double interval_s; // median of the epochs
    orr_time from, to;
    size_t n_epochs, n_sats;
    orr_phase_sat *sat;       // ascending; satellites with at least one sample
    size_t n_without_antenna; // satellites whose antenna (or one of its carriers) was asked for and not found
    size_t n_clock_steps;     // epochs at which the receiver's clock stepped by whole milliseconds
    size_t n_single,
        n_unknown; // satellites left out: without a second carrier; without a position at any epoch
} orr_phase_tec;

// Slant TEC along the arcs of an observation file.
// Given:
//   name      of the observation file, for messages
//   data, n   its n bytes: RINEX 2 to 4, Hatanaka or plain, compressed or not
//   options   may be NULL
// Returned:
//   out       satellites with their samples and arcs; free with orr_phase_tec_free
//   warnings  of the reader, and satellites left out; may be NULL
//   diag      why it failed; may be NULL
// Errors: those of the reader; ORR_E_NODATA (no position in the header and none given; no satellite with two carriers;
// nothing left), ORR_E_UNSUPPORTED (the antenna moves), ORR_E_LIMIT.
// Reference: Bogdanov 2015, eqs. (37) to (39).
orr_status orr_phase_tec_make(const char *name, const void *data, size_t n, const orr_phase_options *options,
                              orr_phase_tec *out, orr_warnings *warnings, orr_diag *diag);
// Frees what a reading made.
void orr_phase_tec_free(orr_phase_tec *p);

// The same satellite seen from two receivers (Bogdanov 2015, Fig. 10).
typedef struct orr_curve_point {
    orr_time t;
    double a_tecu, b_tecu; // centred
} orr_curve_point;
typedef struct orr_curve {
    orr_sat sat;
    size_t first, n; // in the point array
    double rms_tecu; // of a - b
} orr_curve;
typedef struct orr_curves {
    size_t n_curves, n_points;
    orr_curve *curve;
    orr_curve_point *point;
    double rms_tecu; // pooled
    double baseline_m;
} orr_curves;
// Compares the curves of two receivers, each centred over the epochs that both have.
// Given:
//   a, b         phases of the two
//   match_s      epochs count as one within this
//   min_samples  curves of fewer common epochs are left out
// Returned:
//   out          curves, their differences and the baseline; free with orr_curves_free
//   diag         why it failed; may be NULL
// Errors: ORR_E_NODATA when there are no common arcs; ORR_E_MEMORY.
orr_status orr_phase_compare(const orr_phase_tec *a, const orr_phase_tec *b, double match_s,
                             size_t min_samples, orr_curves *out, orr_diag *diag);
// Frees what a comparison made.
void orr_curves_free(orr_curves *c);

#endif
