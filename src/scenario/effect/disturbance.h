// SPDX-License-Identifier: GPL-3.0-or-later
// Travelling disturbances and storm fronts: electron content beside that of the ionosphere's field.
#ifndef ORR_SCENARIO_EFFECT_DISTURBANCE_H
#define ORR_SCENARIO_EFFECT_DISTURBANCE_H

#include "iono/field/pierce.h"
#include "src/config/scenario.h"

typedef struct orr_disturbance orr_disturbance;
// Prepares the section; *out NULL without it. ORR_E_MEMORY. Free with orr_disturbance_close.
orr_status orr_disturbance_open(const orr_scenario *s, orr_disturbance **out, orr_diag *diag);
void orr_disturbance_close(orr_disturbance *d); // NULL is allowed

// Slant content that they add, TECU: a wave's by the thin shell's mapping, a front's as it is. Corners of a front are rounded over
// 2 km.
double orr_disturbance_tecu(const orr_disturbance *d, orr_time t, const orr_pierce *p);

#endif
