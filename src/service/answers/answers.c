// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/answers/answers.h"

#include "src/service/answers/answers_caps.h"
#include "src/service/answers/answers_delays.h"
#include "src/service/answers/answers_elements.h"
#include "src/service/answers/answers_events.h"
#include "src/service/answers/answers_motion.h"
#include "src/service/answers/answers_navdata.h"
#include "src/service/answers/answers_private.h"

#include <math.h>
#include <stdlib.h>

_Static_assert((int)ORR_ANSWER_OK == ORR_MSG_ANSWER_OK &&
                   (int)ORR_ANSWER_OUTSIDE_SPAN == ORR_MSG_ANSWER_OUTSIDE_SPAN &&
                   (int)ORR_ANSWER_NO_ARC == ORR_MSG_ANSWER_NO_ARC &&
                   (int)ORR_ANSWER_NOT_SERVED == ORR_MSG_ANSWER_NOT_SERVED &&
                   (int)ORR_ANSWER_BELOW_HORIZON == ORR_MSG_ANSWER_BELOW_HORIZON &&
                   (int)ORR_ANSWER_NO_VALUE == ORR_MSG_ANSWER_NO_VALUE,
               "the engine's answers are the wire's");
_Static_assert(ORR_EPH_CLOCK_VALID == 1u << 0 && ORR_EPH_PREDICTED == 1u << 1 &&
                   ORR_EPH_MANOEUVRE == 1u << 2 && ORR_EPH_CLOCK_EVENT == 1u << 3 &&
                   ORR_EPH_ECLIPSE == 1u << 4 && ORR_EPH_GAP == 1u << 5 &&
                   ORR_EPH_JOINT == ORR_MSG_STATE_FLAGS_JOINT &&
                   ORR_EPH_SHADOW_NOISE == ORR_MSG_STATE_FLAGS_SHADOW_NOISE,
               "the ephemeris' flags are the wire's");

static uint16_t begin_poll(void *user, const orr_msg_poll *poll, orr_server_refusal *why)
{
    const orr_answers *a = user;
    uint16_t code = 0;
    if (a->n_ids == 0)
        code = orr_answers_refuse(why, ORR_MSG_ERROR_CODE_NOT_SERVED,
                                  "POLL: this scenario has no satellites (orbit.product, orbit.sp3)");
    if (code == 0) code = orr_answers_check_epochs("POLL", &poll->epochs, why);
    return code;
}

static void fill(const orr_sat_state *s, orr_msg_sat_id sat, orr_answer answer, orr_msg_sat_state *m)
{
    m->sat = sat;
    m->answer = (uint8_t)answer;
    m->reserved = 0;
    if (answer != ORR_ANSWER_OK) { // never a number where there is none
        m->flags = 0;
        const double none = (double)NAN;
        for (int k = 0; k < 3; k++) m->pos_m[k] = m->vel_mps[k] = m->acc_mps2[k] = none;
        m->clock_s = m->clock_rate_sps = none;
        m->sigma_m = m->clock_sigma_s = NAN;
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
    m->clock_sigma_s = s->clock_sigma_s;
    m->valid_from = s->valid_from;
    m->valid_to = s->valid_to;
}

// The records of all that was evaluated, a few at a time, so that none leaves the processor's nearest memory before it is encoded.
static void put_states(const orr_answers *a, uint16_t n, orr_wire_writer *w)
{
    enum { PIECE = 8 };
    orr_msg_sat_state m[PIECE];
    for (uint16_t first = 0; first < n; first = (uint16_t)(first + PIECE)) {
        const uint16_t few = n - first < PIECE ? (uint16_t)(n - first) : PIECE;
        for (uint16_t k = 0; k < few; k++)
            fill(&a->state[first + k], a->asked[first + k], a->answer[first + k], &m[k]);
        orr_msg_sat_state_records_encode(&(orr_msg_sat_state_list){.count = few, .item = m}, w);
    }
}

static uint16_t answer_poll(void *user, const orr_msg_poll *poll, orr_server_part *part, orr_wire_writer *w,
                            orr_server_refusal *why)
{
    (void)why;
    orr_answers *a = user;
    uint16_t n;
    const orr_sat *sats = orr_answers_asked(a, &poll->satellites, &n);
    orr_msg_states m = {.epoch = orr_answers_epoch(&poll->epochs, part->index)};
    orr_answer answer = orr_engine_states(a->engine, a->slice, m.epoch.t,
                                          poll->satellites.count > 0 ? sats : NULL, n, a->state, a->answer);
    m.epoch.answer = (uint8_t)answer;
    if (answer == ORR_ANSWER_OK)
        m.satellites = (orr_msg_sat_state_list){n, NULL, orr_answers_promise(ORR_MSG_SAT_STATE_SIZE)};
    orr_msg_states_encode(&m, w);
    if (answer == ORR_ANSWER_OK) put_states(a, n, w);
    return 0;
}

static const orr_msg_handlers handlers = {
    .begin_poll = begin_poll,
    .poll = answer_poll,
    .begin_poll_elements = orr_answers_begin_elements,
    .poll_elements = orr_answers_elements,
    .begin_poll_navdata = orr_answers_begin_navdata,
    .poll_navdata = orr_answers_navdata,
    .begin_poll_delays = orr_answers_begin_delays,
    .poll_delays = orr_answers_delays,
    .begin_poll_channels = orr_answers_begin_channels,
    .poll_channels = orr_answers_channels,
    .begin_poll_imu = orr_answers_begin_imu,
    .poll_imu = orr_answers_imu,
    .begin_poll_truth = orr_answers_begin_truth,
    .poll_truth = orr_answers_truth,
    .begin_poll_events = orr_answers_begin_events,
    .poll_events = orr_answers_events,
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
    a->all = sats;
    a->n_ids = (uint16_t)n;
    for (size_t i = 0; i < n; i++) a->id[i] = orr_answers_sat_id(sats[i]);
    a->server = (orr_server){.handlers = &handlers,
                             .caps = orr_answers_caps,
                             .served = orr_answers_served,
                             .user = a,
                             .lanes = true};
    orr_status s = orr_answers_channels_open(orr_engine_channels(engine), &a->channels, diag);
    if (s == ORR_OK) s = orr_timeline_open(engine, &a->timeline, diag);
    if (s == ORR_OK && n > 0) s = orr_ephemeris_slice_open(orr_engine_ephemeris(engine), &a->slice, diag);
    if (s != ORR_OK) {
        orr_answers_close(a);
        return s;
    }
    *out = a;
    return ORR_OK;
}

orr_status orr_answers_ride(orr_answers *a, orr_vehicle *vehicle, orr_diag *diag)
{
    return orr_answers_channels_ride(orr_engine_channels(a->engine), vehicle, &a->channels, diag);
}

orr_status orr_answers_look_ahead(orr_answers *a, orr_diag *diag)
{
    const orr_channels *c = orr_engine_channels(a->engine);
    return c != NULL ? orr_ahead_open(c, &a->channels.ahead, diag) : ORR_OK;
}

void orr_answers_expect(void *user, uint16_t type, const orr_msg_any *request)
{
    orr_answers *a = user;
    if (type == ORR_MSG_TYPE_POLL_CHANNELS)
        orr_answers_channels_expect(orr_engine_channels(a->engine), &a->channels, &request->poll_channels);
}

const orr_server *orr_answers_server(const orr_answers *a) { return &a->server; }
void orr_answers_close(orr_answers *a)
{
    if (a == NULL) return;
    orr_answers_channels_close(&a->channels);
    orr_timeline_close(a->timeline);
    orr_ephemeris_slice_close(a->slice);
    free(a);
}
