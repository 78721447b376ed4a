// SPDX-License-Identifier: GPL-3.0-or-later
// Positions of satellites for rooms that do not know orbits: from an orbit product, or from broadcast
// ephemerides.
#ifndef ORR_CLI_IONO_POSITION_SOURCE_H
#define ORR_CLI_IONO_POSITION_SOURCE_H

#include "iono/phase/phase_tec.h"

typedef struct orr_position_source orr_position_source;

// A product of `orrery orbit`, or a RINEX navigation file, by content.
orr_status orr_position_source_open(const char *path, orr_position_source **out, orr_warnings *warnings,
                                    orr_diag *diag);
void orr_position_source_close(orr_position_source *p);
// An orr_position_fn; user is the source.
bool orr_position_source_at(void *user, orr_sat sat, orr_time t, orr_vec3 *pos_m);

#endif
