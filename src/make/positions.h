// SPDX-License-Identifier: GPL-3.0-or-later
// Positions of satellites for rooms that do not know orbits: from an orbit product, or from broadcast
// ephemerides.
#ifndef ORR_MAKE_POSITIONS_H
#define ORR_MAKE_POSITIONS_H

#include "iono/phase/phase_tec.h"
#include "orbit/ephemeris/ephemeris.h"
#include "src/make/inputs.h"

typedef struct orr_positions orr_positions;

// Opens a product of `orrery orbit`, or a RINEX navigation file, by content.
// Given:
//   path      the file
//   messages  of a navigation file to insist on (orr_broadcast_choice.messages); 0: the usual ones
// Returned:
//   out       the source, to be closed with orr_positions_close
//   inputs    with the file appended; may be NULL
//   warnings  of the reader; may be NULL
//   diag      errors of the readers; ORR_E_KIND for other kinds of files
orr_status orr_positions_open(const char *path, uint32_t messages, orr_positions **out, orr_inputs *inputs,
                              orr_warnings *warnings, orr_diag *diag);
// Its navigation file; NULL where it is a product.
const orr_nav *orr_positions_nav(const orr_positions *p);
// Its orbit product; NULL where it is a navigation file.
const orr_ephemeris *orr_positions_product(const orr_positions *p);
// Frees it; NULL may be closed.
void orr_positions_close(orr_positions *p);
// An orr_position_fn; user is the source.
bool orr_positions_at(void *user, orr_sat sat, orr_time t, orr_vec3 *pos_m);

#endif
