// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/answers/answers_events.h"

#include <stdio.h>
#include <string.h>

#include "src/service/answers/answers_private.h"

#define SAME(name) (int)ORR_HAPPENS_##name == (int)ORR_MSG_EVENT_KIND_##name
_Static_assert(SAME(RISE) && SAME(SET) && SAME(ARC_BEGIN) && SAME(ARC_END) && SAME(EPHEMERIS) &&
                   SAME(HEALTH) && SAME(LEAP_SECOND) && SAME(ECLIPSE_BEGIN) && SAME(ECLIPSE_END) &&
                   SAME(MANOEUVRE_BEGIN) && SAME(MANOEUVRE_END) && SAME(MOTION_BEGIN) && SAME(MOTION_END) &&
                   SAME(FAULT_BEGIN) && SAME(FAULT_END),
               "what happens is what the wire calls an event");

static const int64_t LONGEST_NS = 3600 * ORR_NS_PER_S, PIECE_NS = 60 * ORR_NS_PER_S;
enum { LIST_HEAD = 4 }; // bytes before a list's records, the count first

static int64_t length_of(const orr_msg_epochs *q) { return q->step != 0 ? q->step : LONGEST_NS; }

uint16_t orr_answers_begin_events(void *user, const orr_msg_poll_events *poll, orr_server_refusal *why)
{
    (void)user;
    const orr_msg_epochs *q = &poll->epochs;
    if (q->step < 0 || q->step > LONGEST_NS)
        return orr_answers_refuse(why, ORR_MSG_ERROR_CODE_BAD_REQUEST,
                                  "POLL_EVENTS: an interval has a length of 0 to an hour");
    const orr_msg_epochs ends = {q->t, length_of(q), q->count};
    const uint16_t code = orr_answers_check_epochs("POLL_EVENTS", &ends, why);
    if (code == 0 && q->t > INT64_MAX - ends.step * (int64_t)q->count)
        return orr_answers_refuse(why, ORR_MSG_ERROR_CODE_BAD_REQUEST,
                                  "POLL_EVENTS: its last interval ends beyond what a time can be");
    return code;
}

static void fill(const orr_happening *h, orr_msg_event *m)
{
    *m = (orr_msg_event){.at = h->t,
                         .kind = (uint8_t)h->kind,
                         .sat = h->sat != ORR_SAT_NONE ? orr_answers_sat_id(h->sat) : (orr_msg_sat_id){0, 0},
                         .message = (uint8_t)h->message,
                         .antenna = h->antenna,
                         .value = h->value};
}

// The count stands before the records, and is known behind them.
static void set_count(orr_wire_writer *w, uint16_t n)
{
    if (w->status == ORR_WIRE_OK)
        orr_wire_store_u16(w->data + w->size - (size_t)n * ORR_MSG_EVENT_SIZE - LIST_HEAD, n);
}

uint16_t orr_answers_events(void *user, const orr_msg_poll_events *poll, orr_server_part *part,
                            orr_wire_writer *w, orr_server_refusal *why)
{
    orr_answers *a = user;
    const int64_t length = length_of(&poll->epochs);
    const orr_msg_epochs q = {poll->epochs.t, length, poll->epochs.count};
    orr_msg_events m = {.epoch = orr_answers_epoch(&q, part->index)};
    orr_span span;
    uint16_t n = 0;
    m.t1 = m.epoch.t + length;
    if (part->done == 0) {
        orr_engine_span(a->engine, &span.from, &span.to);
        m.epoch.answer = orr_span_holds(span, m.epoch.t) ? ORR_MSG_ANSWER_OK : ORR_MSG_ANSWER_OUTSIDE_SPAN;
        orr_msg_events_encode(&m, w);
        if (m.epoch.answer != ORR_MSG_ANSWER_OK) return 0;
    } else {
        memcpy(&n, part->kept, sizeof n);
    }
    const uint32_t pieces = (uint32_t)((length + PIECE_NS - 1) / PIECE_NS);
    bool another = true;
    while (another) {
        const orr_time from = m.epoch.t + part->done * PIECE_NS;
        size_t more;
        const bool all =
            orr_timeline_between(a->timeline, from, from + PIECE_NS < m.t1 ? from + PIECE_NS : m.t1,
                                 a->happening, ORR_MSG_MAX_EVENTS - n, &more);
        if (!all) {
            snprintf(why->sentence, sizeof why->sentence,
                     "POLL_EVENTS: more than %u events in one interval; ask for a shorter one",
                     ORR_MSG_MAX_EVENTS);
            return ORR_MSG_ERROR_CODE_LIMIT;
        }
        for (size_t k = 0; k < more; k++) fill(&a->happening[k], &a->event[k]);
        orr_msg_event_records_encode(&(orr_msg_event_list){.count = (uint16_t)more, .item = a->event}, w);
        n = (uint16_t)(n + more);
        another = orr_server_next_piece(part, pieces);
    }
    set_count(w, n);
    memcpy(part->kept, &n, sizeof n);
    return 0;
}
