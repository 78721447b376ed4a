// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of the streams' modes: noted by whoever looks, asked for, and streamed. All but orr_streams_modes under the lock.
#include <string.h>

#include "src/service/live/streams_private.h"

_Static_assert((int)ORR_MSG_MODE_PAUSED == ORR_MSG_CLOCK_STATE_PAUSED &&
                   ORR_MSG_MODE_RADIO - ORR_MSG_MODE_WALL == ORR_MSG_CLOCK_REFERENCE_RADIO &&
                   ORR_MSG_MODE_SNAPPED - ORR_MSG_MODE_SCENARIO == ORR_MSG_MOTION_STATE_SNAPPED,
               "modes are numbered as the states that they name");

void streams_note_modes(orr_streams *s, int64_t now_ns)
{
    const orr_pace *p = &s->pace;
    const orr_time t = orr_clock_at(&p->clock, now_ns);
    orr_time at[ORR_MODES_KINDS] = {t, t, t, t};
    const uint8_t motion = s->options.vehicle != NULL
                               ? orr_vehicle_state(s->options.vehicle, &at[ORR_MSG_MODE_KIND_MOTION])
                               : ORR_MSG_MOTION_STATE_SCENARIO;
    const uint8_t now[ORR_MODES_KINDS] = {
        [ORR_MSG_MODE_KIND_CLOCK] = orr_pace_state(p, t),
        [ORR_MSG_MODE_KIND_REFERENCE] = (uint8_t)(ORR_MSG_MODE_WALL + p->reference),
        [ORR_MSG_MODE_KIND_GENERATOR] = orr_pace_lock(p, now_ns),
        [ORR_MSG_MODE_KIND_MOTION] = (uint8_t)(ORR_MSG_MODE_SCENARIO + motion)};
    if (memcmp(now, s->modes.now, sizeof now) == 0) return;
    const orr_host h = streams_host(s);
    // A start that was fixed is when it was to be, not when somebody looked.
    if (s->modes.now[ORR_MSG_MODE_KIND_CLOCK] == ORR_MSG_MODE_WAITING && p->start_t != ORR_TIME_NONE &&
        now[ORR_MSG_MODE_KIND_CLOCK] == ORR_MSG_MODE_RUNNING)
        at[ORR_MSG_MODE_KIND_CLOCK] = p->start_t;
    for (size_t k = 0; k < ORR_MODES_KINDS; k++)
        orr_modes_note(&s->modes, (uint8_t)k, now[k], at[k], orr_pace_wall(p, &h));
}

static uint64_t tell(orr_streams *s, int64_t now_ns, uint64_t after, orr_wire_writer *w)
{
    orr_msg_mode_change room[ORR_MSG_MAX_CHANGES];
    orr_msg_modes told;
    orr_modes_tell(&s->modes, after, orr_clock_at(&s->pace.clock, now_ns), room, &told);
    orr_msg_modes_encode(&told, w);
    return told.last;
}

void orr_streams_modes(orr_streams *s, uint64_t after, orr_wire_writer *w)
{
    const int64_t now_ns = streams_now_ns(s);
    pthread_mutex_lock(&s->lock);
    streams_note_modes(s, now_ns);
    (void)tell(s, now_ns, after, w);
    pthread_mutex_unlock(&s->lock);
}

void streams_begin_modes(orr_streams *s, orr_stream *x)
{
    const int64_t now_ns = streams_now_ns(s);
    pthread_mutex_lock(&s->lock);
    streams_note_modes(s, now_ns);
    const uint64_t after = x->request.get_modes.after;
    x->known = after < s->modes.n ? after : s->modes.n;
    x->next = orr_clock_at(&s->pace.clock, now_ns);
    pthread_mutex_unlock(&s->lock);
    x->last = INT64_MAX;
    x->left = UINT64_MAX;
}

bool streams_has_modes(const orr_stream *x) { return x->known < x->all->modes.n; }

void streams_make_modes(orr_stream *x)
{
    orr_streams *s = x->all;
    orr_wire_writer w = {s->room, 0, ORR_MSG_LARGEST, ORR_WIRE_OK};
    const int64_t now_ns = streams_now_ns(s);
    x->known = tell(s, now_ns, x->known, &w);
    x->next = x->made = orr_clock_at(&s->pace.clock, now_ns);
    x->credit--;
    x->blocks++;
    if (x->way != NULL) { // 100 changes fit into any
        (void)x->way->put(x->way, ORR_MSG_TYPE_MODES, w.data, w.size);
        return;
    }
    orr_payload *b = orr_payload_new(&s->payloads, ORR_MSG_TYPE_MODES, w.data, w.size);
    if (b != NULL)
        streams_push(x, b);
    else
        streams_finish(x, ORR_MSG_END_REASON_FAILED, "out of memory");
}
