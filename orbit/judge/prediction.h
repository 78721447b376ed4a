// SPDX-License-Identifier: GPL-3.0-or-later
// The predicted part of a product against precise orbits of later days: errors of orbits and clocks by system, sunlight
// and age, and their ratio to sigma.
#ifndef ORR_ORBIT_JUDGE_PREDICTION_H
#define ORR_ORBIT_JUDGE_PREDICTION_H

#include "ingest/sp3/sp3.h"
#include "orbit/ephemeris/ephemeris.h"

enum { ORR_PREDICTION_AGES = 8 };
extern const double orr_prediction_age_h[ORR_PREDICTION_AGES]; // 1, 3, 6, 12, 24, 48, 72, 120

// Over satellites: of the RMS error of each about an age.
typedef struct orr_prediction_stats {
    size_t satellites;
    double median, p95; // m or s; NAN without satellites
    double ratio;       // median of error over sigma; NAN where there is no sigma
} orr_prediction_stats;

typedef struct orr_prediction_row {
    char system;
    bool eclipses; // satellites that pass through shadow within what is compared
    double age_h;
    orr_prediction_stats orbit, clock;
} orr_prediction_row;

typedef struct orr_prediction_judgement {
    size_t n;
    orr_prediction_row *row; // in the order of systems, sunlit first, ascending age; those with satellites
    size_t n_moved;
    orr_sat *moved;   // left out: by the truth's flag of a manoeuvre, or 20 m off: no prediction knows a push
    size_t predicted; // positions of the truth that are themselves predictions: left out
} orr_prediction_judgement;

// Judges what the product flags as predicted after each satellite's last node that was used.
// Given:
//   e         product
//   truth     [n_truths] precise orbits
//   n_truths  how many
// Returned:
//   out       rows, none where nothing is predicted; free with orr_prediction_judgement_free
//   diag      ORR_E_MEMORY
// Notes: an orbit's error is the RMS of the 3-D differences within half an hour of an age. A clock's is that within 46 min,
// the median of its system at every epoch taken away: what all clocks do together is the reference's.
orr_status orr_prediction_judge(const orr_ephemeris *e, const orr_sp3 *truth, size_t n_truths,
                                orr_prediction_judgement *out, orr_diag *diag);
// Frees what orr_prediction_judge returned.
void orr_prediction_judgement_free(orr_prediction_judgement *j);

#endif
