// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/live/modes.h"

void orr_modes_init(orr_modes *m)
{
    *m = (orr_modes){.now = {[ORR_MSG_MODE_KIND_CLOCK] = ORR_MSG_MODE_STOPPED,
                             [ORR_MSG_MODE_KIND_REFERENCE] = ORR_MSG_MODE_WALL,
                             [ORR_MSG_MODE_KIND_GENERATOR] = ORR_MSG_MODE_SILENT,
                             [ORR_MSG_MODE_KIND_MOTION] = ORR_MSG_MODE_SCENARIO}};
}

void orr_modes_note(orr_modes *m, uint8_t kind, uint8_t mode, orr_time at, orr_time wall)
{
    if (m->now[kind] == mode) return;
    orr_msg_mode_change *c = &m->change[m->n % ORR_MODES_KEPT];
    *c = (orr_msg_mode_change){
        .number = ++m->n, .at = at, .kind = kind, .before = m->now[kind], .mode = mode, .wall = wall};
    m->now[kind] = mode;
}

void orr_modes_tell(const orr_modes *m, uint64_t after, orr_time t,
                    orr_msg_mode_change room[ORR_MSG_MAX_CHANGES], orr_msg_modes *told)
{
    const uint64_t gone = m->n > ORR_MODES_KEPT ? m->n - ORR_MODES_KEPT : 0;
    const uint64_t known = after < m->n ? after : m->n, first = known > gone ? known : gone;
    const uint64_t most = m->n - first < ORR_MSG_MAX_CHANGES ? m->n - first : ORR_MSG_MAX_CHANGES;
    for (uint64_t k = 0; k < most; k++) room[k] = m->change[(first + k) % ORR_MODES_KEPT];
    *told = (orr_msg_modes){.t = t,
                            .last = first + most,
                            .lost = first - known,
                            .more = first + most < m->n,
                            .changes = {.count = (uint16_t)most, .item = room}};
}
