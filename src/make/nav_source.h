// SPDX-License-Identifier: GPL-3.0-or-later
// The navdata section of a scenario as broadcast data fitted to its orbits.
#ifndef ORR_MAKE_NAV_SOURCE_H
#define ORR_MAKE_NAV_SOURCE_H

#include "core/log.h"
#include "orbit/navdata/navset.h"
#include "src/config/scenario.h"

#define ORR_NAV_SOURCE_WHY 512

// Fits the sets of all GPS and GLONASS satellites (0.4 s of one core a day of orbits; `cancel` may be NULL).
// Where the scenario wants none, or the orbits have nothing to fit, *out is NULL, `why` a sentence, and the
// status ORR_OK. Errors: those of the readers, ORR_E_INTERRUPTED, ORR_E_MEMORY. Free with orr_navset_free.
orr_status orr_nav_source_build(const orr_scenario *s, const orr_ephemeris *e, const orr_log *log,
                                const volatile int *cancel, orr_warnings *warnings, orr_navset **out,
                                char why[ORR_NAV_SOURCE_WHY], orr_diag *diag);

#endif
