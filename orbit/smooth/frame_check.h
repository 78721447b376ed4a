// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the positions of a file turn with the Earth, as those of SP3 do. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_FRAME_CHECK_H
#define ORR_ORBIT_SMOOTH_FRAME_CHECK_H

#include "ingest/sp3/sp3.h"

// Tells inertial coordinates by how fast satellites turn in them: as Kepler's third law has it, and not slower by the
// Earth's own turn. Errors: ORR_E_FORMAT for a file that is inertial; one with too few positions to tell is let pass.
orr_status orr_frame_check(const orr_sp3 *sp3, const char *name, orr_diag *diag);

#endif
