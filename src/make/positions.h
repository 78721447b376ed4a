// SPDX-License-Identifier: GPL-3.0-or-later
// Positions of satellites for rooms that do not know orbits: from an orbit product, or from broadcast
// ephemerides.
#ifndef ORR_MAKE_POSITIONS_H
#define ORR_MAKE_POSITIONS_H

#include "iono/phase/phase_tec.h"
#include "src/make/inputs.h"

typedef struct orr_positions orr_positions;

// Opens a product of `orrery orbit`, or a RINEX navigation file; its content decides.
// Given:
//   path      the file
// Returned:
//   out       the source of positions; free with orr_positions_close
//   inputs    the file appended; may be NULL
//   warnings  of the reader; may be NULL
//   diag      why it failed; may be NULL
// Errors: those of the readers; ORR_E_KIND for any other file.
orr_status orr_positions_open(const char *path, orr_positions **out, orr_inputs *inputs,
                              orr_warnings *warnings, orr_diag *diag);
// Frees it; NULL may be closed.
void orr_positions_close(orr_positions *p);
// An orr_position_fn; user is the source.
bool orr_positions_at(void *user, orr_sat sat, orr_time t, orr_vec3 *pos_m);

#endif
