// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/predict/predict_sigma.h"

#include <math.h>

#include "core/constants.h"
#include "orbit/force/orbit_class.h"

#define DAY_S 86400.0
#define JOIN_S 600.0
#define EARLY_S (4 * 3600.0) // the end state's error unfolds within a third of a revolution
#define LATE_POWER 1.3       // and the accelerations' over the first day
#define BEYOND_POWER 2.0     // and after it
#define FULL_HISTORY_S (2 * DAY_S)
#define HISTORY_POWER 0.4
#define SHORT_LATE_M 0.9 // a day after half a day of positions
#define SHORT_POWER 0.6
#define ECLIPSE_EARLY 1.8
#define ECLIPSE_LATE 2.2
#define LEAST_RATIO 0.8
#define MOST_RATIO 4.0
#define MEDIAN_TO_SIGMA 1.2

// Sunlit satellites, two days of positions: {joint where none is seen, early, late}, m.
static orr_predict_growth usual(char system, orr_orbit_class orbit)
{
    if (orbit != ORR_ORBIT_MEO) return (orr_predict_growth){0.15, 0.3, 0.8};
    switch (system) {
    case 'G':
        return (orr_predict_growth){0.013, 0.055, 0.105};
    case 'R':
        return (orr_predict_growth){0.028, 0.070, 0.220};
    case 'E':
        return (orr_predict_growth){0.018, 0.090, 0.160};
    default:
        return (orr_predict_growth){0.15, 0.120, 0.250};
    }
}

orr_predict_growth orr_predict_growth_of(const orr_predict_known *k)
{
    orr_predict_growth g = usual(orr_sat_system(k->sat), orr_orbit_class_of(k->r_m, k->v_mps));
    const double history = fmax(1, pow(FULL_HISTORY_S / fmax(k->history_s, 1), HISTORY_POWER));
    double own = sqrt(k->rms_ratio);
    own = own > LEAST_RATIO ? fmin(own, MOST_RATIO) : LEAST_RATIO; // no number is none
    if (isfinite(k->joint_m)) g.joint_m = MEDIAN_TO_SIGMA * k->joint_m;
    g.early_m *= history * own * (k->eclipses ? ECLIPSE_EARLY : 1);
    g.late_m *= history * own * (k->eclipses ? ECLIPSE_LATE : 1);
    if (k->history_s < DAY_S) g.late_m += SHORT_LATE_M * pow(DAY_S / fmax(k->history_s, 1) - 1, SHORT_POWER);
    return g;
}

double orr_predict_sigma(const orr_predict_growth *g, double age_s)
{
    if (!(age_s > 0)) return 0;
    const double days = age_s / DAY_S, joined = age_s / JOIN_S;
    const double joint = g->joint_m * (1 - exp(-joined * joined)),
                 early = g->early_m * (1 - exp(-age_s / EARLY_S)),
                 late = g->late_m * pow(days, days < 1 ? LATE_POWER : BEYOND_POWER);
    return sqrt(joint * joint + early * early + late * late);
}
