// SPDX-License-Identifier: GPL-3.0-or-later
// How far a predicted orbit is off after some time. Room-internal.
#ifndef ORR_ORBIT_PREDICT_PREDICT_SIGMA_H
#define ORR_ORBIT_PREDICT_PREDICT_SIGMA_H

#include "core/sat.h"
#include "core/vec.h"

// What is known of a satellite when it is predicted.
typedef struct orr_predict_known {
    orr_sat sat;
    orr_vec3 r_m, v_mps; // inertial state: geosynchronous orbits are apart
    bool eclipses;       // it passes through the Earth's shadow
    double history_s;    // of positions that the orbit was fitted to
    double rms_ratio;    // residual of its fit over the median of its system
    double joint_m;      // what orbits of its system step from file to file, 3-D median; NAN: not seen
} orr_predict_known;

typedef struct orr_predict_growth {
    double joint_m;         // the next file's orbit is another from its first position on
    double early_m, late_m; // of the hours after, and a day after
} orr_predict_growth;

// The growth that was measured on days left out, by system and kind of orbit (docs/orbit.md).
orr_predict_growth orr_predict_growth_of(const orr_predict_known *k);
// 1-sigma of position, 3-D, m, against what the same centre will say.
double orr_predict_sigma(const orr_predict_growth *g, double age_s);

#endif
