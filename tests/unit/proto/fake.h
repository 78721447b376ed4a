// SPDX-License-Identifier: GPL-3.0-or-later
// A made-up answerer behind proto's handler table: n satellites whose numbers are simple functions of time.
#ifndef ORR_TESTS_UNIT_PROTO_FAKE_H
#define ORR_TESTS_UNIT_PROTO_FAKE_H

#include "proto/server.h"
#include <stdio.h>

typedef struct fake {
    uint16_t n_sats;
    unsigned begun, answered; // how often the handlers were called
} fake;

static inline orr_msg_sat_state fake_state(uint8_t number, int64_t t)
{
    orr_msg_sat_state s = {
        .sat = {'G', number}, .flags = 1, .sigma_m = 0.5f, .valid_from = 0, .valid_to = 1000};
    s.pos_m[0] = (double)t + number;
    s.vel_mps[1] = number * 0.25;
    return s;
}

static inline uint16_t fake_begin(void *user, const orr_msg_poll *poll, orr_server_refusal *why)
{
    fake *f = user;
    f->begun++;
    if (poll->epochs.count == 0) {
        snprintf(why->sentence, sizeof why->sentence, "no epochs asked for");
        return ORR_MSG_ERROR_CODE_BAD_REQUEST;
    }
    return 0;
}

static inline uint16_t fake_answer(void *user, const orr_msg_poll *poll, orr_server_part *part,
                                   orr_wire_writer *w, orr_server_refusal *why)
{
    fake *f = user;
    const uint32_t index = part->index;
    f->answered++;
    int64_t t =
        (int64_t)((uint64_t)poll->epochs.t + index * (uint64_t)poll->epochs.step); // of anyone: may wrap
    if (t == 666) {
        snprintf(why->sentence, sizeof why->sentence, "broken at 666");
        return ORR_MSG_ERROR_CODE_INTERNAL;
    }
    orr_msg_sat_state sats[99];
    for (uint16_t i = 0; i < f->n_sats; i++) sats[i] = fake_state((uint8_t)(i + 1), t);
    orr_msg_states m = {{t, index, poll->epochs.count, ORR_MSG_ANSWER_OK}, {f->n_sats, sats, {NULL, 0, 0}}};
    orr_msg_states_encode(&m, w);
    return 0;
}

static inline void fake_caps(void *user, orr_msg_caps *caps)
{
    (void)user;
    caps->name = orr_wire_text("fake");
    caps->title = orr_wire_text("made up");
    caps->span = (orr_msg_span){-5, 1000};
}

static const orr_msg_handlers fake_handlers = {.begin_poll = fake_begin, .poll = fake_answer};

static inline orr_server fake_server(fake *f)
{
    return (orr_server){.handlers = &fake_handlers, .caps = fake_caps, .user = f};
}

#endif
