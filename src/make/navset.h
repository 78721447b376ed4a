// SPDX-License-Identifier: GPL-3.0-or-later
// An orbit product, tables and options to broadcast data: what `orrery navfit` writes and what a scenario's satellites send.
#ifndef ORR_MAKE_NAVSET_H
#define ORR_MAKE_NAVSET_H

#include "core/log.h"
#include "orbit/navdata/navset.h"
#include "src/config/scenario.h"
#include "src/make/inputs.h"

typedef struct orr_navset_plan {
    const char *antex, *bias; // NULL: none
    const char *const *nav;   // navigation files for GLONASS' channels and Klobuchar's coefficients
    size_t n_nav;
    const char *
        field; // of an ionosphere: where it is a navigation file, it stands in for what `nav` lacks; NULL: none
    orr_navset_options options; // antex, bias and nav are set by orr_navset_make
} orr_navset_plan;

// A plan without files, on all cores.
orr_navset_plan orr_navset_plan_default(void);
// What a scenario asks for; it borrows from the scenario. False where it wants no broadcast data.
bool orr_navset_plan_of(const orr_scenario *s, orr_navset_plan *out);

// Reads the files once and fits the sets (0.4 s of one core a day of orbits). *inputs (may be NULL) gets the names and
// SHA-256 of what was read. Errors: those of the readers and of orr_navset_build. Free with orr_navset_free.
orr_status orr_navset_make(const orr_ephemeris *e, const orr_navset_plan *plan, orr_navset **out,
                           orr_inputs *inputs, orr_warnings *warnings, orr_diag *diag);

#endif
