// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/answers.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

_Static_assert((int)ORR_ANSWER_OK == ORR_MSG_ANSWER_OK &&
                   (int)ORR_ANSWER_OUTSIDE_SPAN == ORR_MSG_ANSWER_OUTSIDE_SPAN &&
                   (int)ORR_ANSWER_NO_ARC == ORR_MSG_ANSWER_NO_ARC &&
                   (int)ORR_ANSWER_NOT_SERVED == ORR_MSG_ANSWER_NOT_SERVED,
               "the engine's answers are the wire's");
_Static_assert(ORR_EPH_CLOCK_VALID == 1u << 0 && ORR_EPH_PREDICTED == 1u << 1 &&
                   ORR_EPH_MANOEUVRE == 1u << 2 && ORR_EPH_CLOCK_EVENT == 1u << 3 &&
                   ORR_EPH_ECLIPSE == 1u << 4 && ORR_EPH_GAP == 1u << 5,
               "the ephemeris' flags are the wire's");

struct orr_answers {
    const orr_engine *engine;
    orr_server server;
    orr_msg_sat_id id[ORR_MSG_MAX_SATELLITES]; // of all served
    uint16_t n_ids;
    // Room for one epoch; the loop is one thread's, so one room is enough.
    orr_sat sat[ORR_MSG_MAX_SATELLITES];
    orr_sat_state state[ORR_MSG_MAX_SATELLITES];
    orr_answer answer[ORR_MSG_MAX_SATELLITES];
    orr_msg_sat_state wire[ORR_MSG_MAX_SATELLITES];
};

orr_msg_sat_id orr_answers_sat_id(orr_sat sat)
{
    return (orr_msg_sat_id){(uint8_t)orr_sat_system(sat), (uint8_t)orr_sat_number(sat)};
}

static uint16_t refuse(orr_server_refusal *why, uint16_t code, const char *sentence)
{
    snprintf(why->sentence, sizeof why->sentence, "%s", sentence);
    return code;
}

static uint16_t begin_poll(void *user, const orr_frame *request, uint32_t *frames, orr_server_refusal *why)
{
    (void)user;
    orr_msg_poll poll;
    orr_wire_status ws = orr_msg_poll_decode(request->payload, request->size, &poll);
    if (ws == ORR_WIRE_LIMIT)
        return refuse(why, ORR_MSG_ERROR_CODE_LIMIT, "POLL: more satellites than a list may have");
    if (ws != ORR_WIRE_OK) {
        snprintf(why->sentence, sizeof why->sentence, "POLL: %s", orr_wire_status_text(ws));
        return ORR_MSG_ERROR_CODE_BAD_PAYLOAD;
    }
    if (poll.count == 0)
        return refuse(why, ORR_MSG_ERROR_CODE_BAD_REQUEST, "POLL: count is 0, no epoch is asked for");
    if (poll.count > ORR_MSG_MAX_EPOCHS) {
        snprintf(why->sentence, sizeof why->sentence, "POLL: %lu epochs, at most %u may be asked for at once",
                 (unsigned long)poll.count, ORR_MSG_MAX_EPOCHS);
        return ORR_MSG_ERROR_CODE_LIMIT;
    }
    if (poll.count > 1 && poll.step == 0)
        return refuse(why, ORR_MSG_ERROR_CODE_BAD_REQUEST, "POLL: step is 0, but count is more than 1");
    int64_t last;
    if (__builtin_mul_overflow(poll.step, (int64_t)poll.count - 1, &last) ||
        __builtin_add_overflow(poll.t, last, &last))
        return refuse(why, ORR_MSG_ERROR_CODE_BAD_REQUEST,
                      "POLL: its last epoch is beyond what a time can be");
    orr_msg_sat_id id;
    orr_wire_iter it = {0};
    while (orr_msg_sat_id_next(&poll.satellites, &it, &id)) {
        if (orr_sat_make((char)id.system, id.number) != ORR_SAT_NONE) continue;
        snprintf(why->sentence, sizeof why->sentence,
                 "POLL: satellite %u of the list (system 0x%02x, number %u) is none", (unsigned)it.index,
                 (unsigned)id.system, (unsigned)id.number);
        return ORR_MSG_ERROR_CODE_BAD_REQUEST;
    }
    *frames = poll.count;
    return 0;
}

static void fill(const orr_sat_state *s, orr_answer answer, orr_msg_sat_state *m)
{
    m->sat = orr_answers_sat_id(s->sat);
    m->answer = (uint8_t)answer;
    m->reserved = 0;
    if (answer != ORR_ANSWER_OK) { // never a number where there is none
        m->flags = 0;
        for (int k = 0; k < 3; k++) m->pos_m[k] = m->vel_mps[k] = m->acc_mps2[k] = NAN;
        m->clock_s = m->clock_rate_sps = NAN;
        m->sigma_m = NAN;
        m->valid_from = m->valid_to = ORR_TIME_NONE;
        return;
    }
    m->flags = s->flags;
    m->pos_m[0] = s->pos_m.x, m->pos_m[1] = s->pos_m.y, m->pos_m[2] = s->pos_m.z;
    m->vel_mps[0] = s->vel_mps.x, m->vel_mps[1] = s->vel_mps.y, m->vel_mps[2] = s->vel_mps.z;
    m->acc_mps2[0] = s->acc_mps2.x, m->acc_mps2[1] = s->acc_mps2.y, m->acc_mps2[2] = s->acc_mps2.z;
    m->clock_s = s->clock_s;
    m->clock_rate_sps = s->clock_rate_sps;
    m->sigma_m = s->sigma_m;
    m->valid_from = s->valid_from;
    m->valid_to = s->valid_to;
}

static uint16_t answer_poll(void *user, const orr_frame *request, uint32_t index, orr_wire_writer *w,
                            orr_server_refusal *why)
{
    (void)why;
    orr_answers *a = user;
    orr_msg_poll poll;
    orr_msg_poll_decode(request->payload, request->size, &poll); // begin_poll has seen that it decodes
    uint16_t n = poll.satellites.count;
    for (uint16_t i = 0; i < n; i++) {
        orr_msg_sat_id id;
        orr_msg_sat_id_at(&poll.satellites, i, &id);
        a->sat[i] = orr_sat_make((char)id.system, id.number);
    }
    const orr_sat *sats = n > 0 ? a->sat : NULL;
    if (n == 0) n = a->n_ids;
    orr_msg_states m = {.t = poll.t + poll.step * (int64_t)index, .index = index, .count = poll.count};
    orr_answer answer = orr_engine_states(a->engine, m.t, sats, n, a->state, a->answer);
    m.answer = (uint8_t)answer;
    if (answer == ORR_ANSWER_OK) {
        for (uint16_t i = 0; i < n; i++) fill(&a->state[i], a->answer[i], &a->wire[i]);
        m.satellites.count = n;
        m.satellites.item = a->wire;
    }
    orr_msg_states_encode(&m, w);
    return 0;
}

static void fill_caps(void *user, orr_msg_caps *caps)
{
    const orr_answers *a = user;
    orr_engine_span(a->engine, &caps->span_from, &caps->span_to);
    caps->name = orr_wire_text("orrery");
    caps->version = orr_wire_text(ORR_VERSION);
    caps->title = orr_wire_text(orr_engine_title(a->engine));
    caps->frame = orr_wire_text(orr_engine_frame(a->engine));
    caps->satellites.count = a->n_ids;
    caps->satellites.item = a->id;
}

static const orr_server_route routes[] = {
    {ORR_MSG_TYPE_POLL, ORR_MSG_TYPE_STATES, begin_poll, answer_poll},
};

orr_status orr_answers_open(const orr_engine *engine, orr_answers **out, orr_diag *diag)
{
    const orr_sat *sats;
    size_t n = orr_engine_satellites(engine, &sats);
    if (n > ORR_MSG_MAX_SATELLITES)
        return orr_diag_set(diag, ORR_E_LIMIT, "the product has %zu satellites, a message lists at most %u",
                            n, ORR_MSG_MAX_SATELLITES);
    orr_answers *a = calloc(1, sizeof *a);
    if (a == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    a->engine = engine;
    a->n_ids = (uint16_t)n;
    for (size_t i = 0; i < n; i++) a->id[i] = orr_answers_sat_id(sats[i]);
    a->server = (orr_server){routes, sizeof routes / sizeof routes[0], fill_caps, a};
    *out = a;
    return ORR_OK;
}

const orr_server *orr_answers_server(const orr_answers *a) { return &a->server; }
void orr_answers_close(orr_answers *a) { free(a); }
