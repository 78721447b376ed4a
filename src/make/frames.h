// SPDX-License-Identifier: GPL-3.0-or-later
// Whether inputs that meet belong to one reference frame: centimetres of difference look like errors of an orbit.
#ifndef ORR_MAKE_FRAMES_H
#define ORR_MAKE_FRAMES_H

#include "core/status.h"
#include "ingest/tables/antex.h"

// Whether two names ("IGS20", "IGb14", "IGS20_2247", "ITRF2020") tell of different realisations; names without a number
// differ from none.
bool orr_frames_differ(const char *a, const char *b);
// Warns where the antennas of satellites belong to another frame than the orbit (named `orbit_frame`); `path` is of the
// antennas' file.
void orr_frames_check_antex(const orr_antex *antex, const char *path, const char *orbit_frame,
                            orr_warnings *warnings);

#endif
