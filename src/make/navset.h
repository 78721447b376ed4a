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
    // The same where they have been read already (of the paths above, which are then told alone); NULL: not yet.
    const orr_antex *antex_read;
    const orr_bias_set *bias_read;
    const orr_nav *nav_read;
    const char *
        field; // of an ionosphere: where it is a navigation file, it stands in for what `nav` lacks; else, where `nav` has no
               // Klobuchar of GPS, coefficients are fitted to it; NULL: none
    const char *nequick;        // folder of NeQuick-G's tables, to fit its coefficients; NULL: none are
    orr_navset_options options; // antex, bias and nav are set by orr_navset_make
} orr_navset_plan;

// A plan without files, on all cores.
orr_navset_plan orr_navset_plan_default(void);
// What a scenario asks for; it borrows from the scenario. False where it wants no broadcast data.
bool orr_navset_plan_of(const orr_scenario *s, orr_navset_plan *out);

// Reads a plan's files once and fits the broadcast data (0.4 s of one core a day of orbits).
// Given:
//   e         orbit product; not needed afterwards
//   plan      files and options
// Returned:
//   out       the broadcast data; free with orr_navset_free
//   inputs    names and SHA-256 of what was read are appended; may be NULL
//   warnings  of readers and fit; may be NULL
//   diag      why it failed; may be NULL
// Errors: those of the readers and of orr_navset_build; ORR_E_LIMIT (navigation files).
orr_status orr_navset_make(const orr_ephemeris *e, const orr_navset_plan *plan, orr_navset **out,
                           orr_inputs *inputs, orr_warnings *warnings, orr_diag *diag);

#endif
