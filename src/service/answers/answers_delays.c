// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/answers/answers_delays.h"

#include <math.h>
#include <stdio.h>

#include "core/nan.h"
#include "src/service/answers/answers_private.h"

_Static_assert((int)ORR_ORIGIN_FIELD == ORR_MSG_TEC_ORIGIN_FIELD &&
                   (int)ORR_ORIGIN_FUSED == ORR_MSG_TEC_ORIGIN_FUSED &&
                   (int)ORR_ORIGIN_TRANSFERRED == ORR_MSG_TEC_ORIGIN_TRANSFERRED &&
                   (int)ORR_ORIGIN_NOISE == ORR_MSG_TEC_ORIGIN_NOISE &&
                   ORR_TEC_CLIPPED == ORR_MSG_DELAY_FLAGS_CLIPPED,
               "origins and flags of delays are the wire's");
_Static_assert(ORR_MSG_MAX_SATELLITES <= ORR_SESSION_MAX_SATS, "one question holds as many as a message");

// The receiver of a question at t: its own, or the scenario's.
static orr_answer receiver_of(const orr_answers *a, const orr_msg_poll_delays *poll, orr_time t,
                              orr_vec3 *out)
{
    const double *r = poll->receiver_m;
    if (isnan(r[0]) && isnan(r[1]) && isnan(r[2])) return orr_engine_receiver(a->engine, t, out);
    *out = (orr_vec3){r[0], r[1], r[2]};
    return ORR_ANSWER_OK;
}

// Where a receiver may be: on the Earth, or in space as far as its high orbits go.
static uint16_t check_receiver(orr_vec3 receiver, orr_server_refusal *why)
{
    if (!isfinite(receiver.x) || !isfinite(receiver.y) || !isfinite(receiver.z))
        return orr_answers_refuse(why, ORR_MSG_ERROR_CODE_BAD_REQUEST,
                                  "POLL_DELAYS: receiver_m has a coordinate that is no finite number; three "
                                  "finite ones name a receiver, three NAN the scenario's own");
    double r = hypot(hypot(receiver.x, receiver.y), receiver.z); // does not overflow
    if (r > 6.2e6 && r < 5e8) return 0;
    snprintf(why->sentence, sizeof why->sentence,
             "POLL_DELAYS: a receiver %.6g km from the Earth's centre; between 6200 and 500 000 km one is "
             "possible",
             r / 1e3);
    return ORR_MSG_ERROR_CODE_BAD_REQUEST;
}

uint16_t orr_answers_begin_delays(void *user, const orr_msg_poll_delays *poll, orr_server_refusal *why)
{
    const orr_answers *a = user;
    uint16_t code = orr_answers_check_epochs("POLL_DELAYS", &poll->epochs, why);
    if (code != 0) return code;
    if (!orr_engine_has_ionosphere(a->engine))
        return orr_answers_refuse(
            why, ORR_MSG_ERROR_CODE_NOT_SERVED,
            "POLL_DELAYS: this scenario has no ionosphere (ionosphere.field, ionosphere.session)");
    orr_vec3 receiver;
    orr_answer where = receiver_of(a, poll, poll->epochs.t, &receiver);
    if (where == ORR_ANSWER_NOT_SERVED)
        return orr_answers_refuse(why, ORR_MSG_ERROR_CODE_BAD_REQUEST,
                                  "POLL_DELAYS: it names no receiver, and neither does the scenario "
                                  "(receiver.position, or a trajectory)");
    if (where == ORR_ANSWER_OK) code = check_receiver(receiver, why);
    if (code != 0) return code;
    double hz;
    orr_wire_iter it = {0};
    while (orr_msg_f64_next(&poll->carriers_hz, &it, &hz))
        if (!(hz >= 1e8 && hz <= 3e10))
            return orr_answers_refuse(
                why, ORR_MSG_ERROR_CODE_BAD_REQUEST,
                "POLL_DELAYS: a carrier outside 100 MHz to 30 GHz, for which 40.3 TEC/f^2 does not hold");
    return 0;
}

static void fill_delay(const orr_realisation *d, orr_msg_sat_id sat, orr_answer answer, const double *hz,
                       uint16_t n_hz, orr_msg_sat_delay *m)
{
    *m = (orr_msg_sat_delay){.sat = sat, .answer = (uint8_t)answer};
    m->az_rad = m->el_rad = m->pierce_lat_rad = m->pierce_lon_rad = m->mapping = m->stec_tecu =
        m->model_stec_tecu = (double)NAN;
    m->sigma_tecu = NAN;
    for (int k = 0; k < 4; k++) m->delay_m[k] = (double)NAN;
    if (answer != ORR_ANSWER_OK) return; // never a number where there is none
    m->origin = (uint8_t)d->origin;
    m->flags = (uint8_t)d->flags;
    m->az_rad = d->pierce.az_rad;
    m->el_rad = d->pierce.el_rad;
    m->pierce_lat_rad = d->pierce.lat_rad;
    m->pierce_lon_rad = d->pierce.lon_rad;
    m->mapping = d->mapping;
    m->stec_tecu = d->stec_tecu;
    m->model_stec_tecu = d->model_stec_tecu;
    m->sigma_tecu = (float)d->sigma_tecu;
    for (uint16_t k = 0; k < n_hz; k++)
        m->delay_m[k] = orr_iono_delay_m(d->stec_tecu, hz[k], ORR_MEASURES_CODE);
}

uint16_t orr_answers_delays(void *user, const orr_msg_poll_delays *poll, orr_server_part *part,
                            orr_wire_writer *w, orr_server_refusal *why)
{
    orr_answers *a = user;
    double hz[ORR_MSG_MAX_CARRIERS] = {1575.42e6};
    uint16_t n_hz = poll->carriers_hz.count, n;
    for (uint16_t k = 0; k < n_hz; k++) orr_msg_f64_at(&poll->carriers_hz, k, &hz[k]);
    if (n_hz == 0) n_hz = 1;
    const orr_sat *sats = orr_answers_asked(a, &poll->satellites, &n);
    orr_msg_delays m = {.epoch = orr_answers_epoch(&poll->epochs, part->index),
                        .carriers_hz = {.count = n_hz, .item = hz},
                        .satellites = {n, NULL, orr_answers_promise(ORR_MSG_SAT_DELAY_SIZE)}};
    orr_vec3 receiver = {ORR_NAN, ORR_NAN, ORR_NAN};
    orr_answer answer = receiver_of(a, poll, m.epoch.t, &receiver);
    uint16_t code = answer == ORR_ANSWER_OK ? check_receiver(receiver, why) : 0;
    if (code != 0) return code; // it has flown up there since the first epoch
    m.receiver_m[0] = receiver.x;
    m.receiver_m[1] = receiver.y;
    m.receiver_m[2] = receiver.z;
    // Of a session each call costs as much as some twenty satellites, so a piece is not too few of them.
    enum { PIECE = 64 };
    const uint32_t pieces = n == 0 ? 1 : (n + PIECE - 1u) / PIECE;
    do {
        orr_realisation delay[PIECE];
        orr_answer each[PIECE];
        orr_msg_sat_delay wire[PIECE];
        size_t from = (size_t)part->done * PIECE, k = n - from < PIECE ? n - from : PIECE;
        if (answer == ORR_ANSWER_OK)
            answer = orr_engine_delays(a->engine, m.epoch.t, receiver, &sats[from], k, delay, each);
        if (part->done == 0) {
            m.epoch.answer = (uint8_t)answer;
            if (answer != ORR_ANSWER_OK) m.satellites = (orr_msg_sat_delay_list){0};
            orr_msg_delays_encode(&m, w);
        }
        if (answer != ORR_ANSWER_OK) return 0;
        for (size_t i = 0; i < k; i++) fill_delay(&delay[i], a->asked[from + i], each[i], hz, n_hz, &wire[i]);
        orr_msg_sat_delay_records_encode(&(orr_msg_sat_delay_list){.count = (uint16_t)k, .item = wire}, w);
    } while (orr_server_next_piece(part, pieces));
    return 0;
}
