// SPDX-License-Identifier: GPL-3.0-or-later
// What the section `faults` does to broadcast data: sets that are wrong, old or marked, and bits that are inverted on their way.
#ifndef ORR_SCENARIO_SOURCE_NAVDATA_FAULTS_H
#define ORR_SCENARIO_SOURCE_NAVDATA_FAULTS_H

#include "orbit/navdata/navframe.h"
#include "src/config/scenario.h"

// The faults of sets, for orr_navset_options.
// Given:
//   s     scenario
//   span  time of the orbits: where faults without an end do end
// Returned:
//   list  the faults; free with free
//   n     how many
//   diag  out of memory
orr_status orr_navdata_faults_of(const orr_scenario *s, orr_interval span, orr_navset_fault **list, size_t *n,
                                 orr_diag *diag);

typedef struct orr_navdata_bits orr_navdata_bits; // inverted bits
// Prepares them.
// Given:
//   s     scenario
//   set   broadcast data, borrowed
//   span  as orr_navdata_faults_of
// Returned:
//   out   NULL without such faults; free with orr_navdata_bits_free
//   diag  why it failed
// Errors: ORR_E_FORMAT with the key's line (no such message, bits that no piece of it has), ORR_E_MEMORY.
orr_status orr_navdata_bits_open(const orr_scenario *s, const orr_navset *set, orr_interval span,
                                 orr_navdata_bits **out, orr_diag *diag);
void orr_navdata_bits_free(orr_navdata_bits *b); // NULL is allowed
// Inverts what is sent in the time of the wrong bits, bits or symbols. b NULL: nothing.
void orr_navdata_bits_invert(const orr_navdata_bits *b, orr_navframe *frame);

#endif
