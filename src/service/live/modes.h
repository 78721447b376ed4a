// SPDX-License-Identifier: GPL-3.0-or-later
// Which modes a service has been in: the clock's states, what paces it, the lock to a generator, where live motion comes from. What was
// last is kept, as many changes as are of use to somebody who asks now and then; who misses some is told how many.
#ifndef ORR_SERVICE_LIVE_MODES_H
#define ORR_SERVICE_LIVE_MODES_H

#include "core/time.h"
#include "proto/gen/messages.h"

enum { ORR_MODES_KINDS = ORR_MSG_MODE_KIND_MOTION + 1, ORR_MODES_KEPT = 1024 };

typedef struct orr_modes {
    uint64_t n;                   // changes so far; number k stands at (k - 1) % ORR_MODES_KEPT
    uint8_t now[ORR_MODES_KINDS]; // ORR_MSG_MODE_*
    orr_msg_mode_change change[ORR_MODES_KEPT];
} orr_modes;

// A clock that stands, paced by the wall, no generator, the scenario's own motion.
void orr_modes_init(orr_modes *m);
// Notes the mode that something is in now, if that is another one than before.
// Given:
//   m     the modes
//   kind  ORR_MSG_MODE_KIND_*
//   mode  ORR_MSG_MODE_*
//   at    the scenario's instant
//   wall  the wall's
void orr_modes_note(orr_modes *m, uint8_t kind, uint8_t mode, orr_time at, orr_time wall);
// MODES, as an answer to who knows the changes up to number `after`.
// Given:
//   m      the modes
//   after  number of the last change that is known; one that has not come yet: the last there is
//   t      what the scenario's clock shows
// Returned:
//   room   the changes that are told
//   told   the message; its list borrows `room`
void orr_modes_tell(const orr_modes *m, uint64_t after, orr_time t,
                    orr_msg_mode_change room[ORR_MSG_MAX_CHANGES], orr_msg_modes *told);

#endif
