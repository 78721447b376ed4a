// SPDX-License-Identifier: GPL-3.0-or-later
// The orbit section of a scenario as an ephemeris: SP3 files read, smoothed jointly, fitted.
#ifndef ORR_MAKE_ORBIT_SOURCE_H
#define ORR_MAKE_ORBIT_SOURCE_H

#include "core/astro.h"
#include "core/log.h"
#include "orbit/ephemeris/ephemeris.h"
#include "src/config/scenario.h"

// Errors: those of the SP3 reader (file, line, column), of the smoother and of the fit. *eop is the Earth
// orientation that was used, n = 0 without orbit.erp; free it with orr_erp_series_free.
orr_status orr_orbit_source_smooth(const orr_scenario_orbit *o, const orr_log *log,
                                   const volatile int *cancel, orr_warnings *warnings, orr_ephemeris **out,
                                   orr_eop_series *eop, orr_diag *diag);

#endif
