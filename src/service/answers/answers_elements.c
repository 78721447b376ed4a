// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/answers/answers_elements.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "src/service/answers/answers_private.h"

_Static_assert((int)ORR_ELEMENTS_DATE == ORR_MSG_ELEMENTS_FRAME_DATE &&
                   (int)ORR_ELEMENTS_J2000 == ORR_MSG_ELEMENTS_FRAME_J2000 &&
                   (int)ORR_ELEMENTS_ECEF == ORR_MSG_ELEMENTS_FRAME_ECEF &&
                   (int)ORR_ELEMENTS_STATE == ORR_MSG_ELEMENTS_METHOD_STATE &&
                   (int)ORR_ELEMENTS_THREE_POSITIONS == ORR_MSG_ELEMENTS_METHOD_THREE_POSITIONS &&
                   (int)ORR_ELEMENTS_MEAN == ORR_MSG_ELEMENTS_METHOD_MEAN,
               "frames and methods are the wire's");

uint16_t orr_answers_begin_elements(void *user, const orr_msg_poll_elements *poll, orr_server_refusal *why)
{
    const orr_answers *a = user;
    uint16_t code = 0;
    if (a->n_ids == 0)
        code =
            orr_answers_refuse(why, ORR_MSG_ERROR_CODE_NOT_SERVED,
                               "POLL_ELEMENTS: this scenario has no satellites (orbit.product, orbit.sp3)");
    if (code == 0) code = orr_answers_check_epochs("POLL_ELEMENTS", &poll->epochs, why);
    if (code != 0) return code;
    if (orr_msg_elements_frame_name(poll->frame) == NULL) {
        snprintf(why->sentence, sizeof why->sentence,
                 "POLL_ELEMENTS: there is no frame %u; frames are 0 (DATE), 1 (J2000) and 2 (ECEF)",
                 (unsigned)poll->frame);
        return ORR_MSG_ERROR_CODE_BAD_REQUEST;
    }
    if (orr_msg_elements_method_name(poll->method) == NULL) {
        snprintf(
            why->sentence, sizeof why->sentence,
            "POLL_ELEMENTS: there is no method %u; methods are 0 (STATE), 1 (THREE_POSITIONS) and 2 (MEAN)",
            (unsigned)poll->method);
        return ORR_MSG_ERROR_CODE_BAD_REQUEST;
    }
    return 0;
}

static void fill(orr_msg_sat_id sat, orr_answer answer, const orr_kepler *k, uint32_t flags,
                 orr_msg_sat_elements *m)
{
    *m = (orr_msg_sat_elements){.sat = sat, .answer = (uint8_t)answer};
    m->a_m = m->e = m->i_rad = m->raan_rad = m->argp_rad = m->m_rad = m->u_rad = (double)NAN;
    if (answer != ORR_ANSWER_OK) return; // never a number where there is none
    m->flags = flags;
    m->a_m = k->a_m;
    m->e = k->e;
    m->i_rad = k->i_rad;
    m->raan_rad = k->raan_rad;
    m->argp_rad = k->argp_rad;
    m->m_rad = k->m_rad;
    m->u_rad = k->u_rad;
}

uint16_t orr_answers_elements(void *user, const orr_msg_poll_elements *poll, orr_server_part *part,
                              orr_wire_writer *w, orr_server_refusal *why)
{
    (void)why;
    orr_answers *a = user;
    uint16_t n;
    const orr_sat *sats = orr_answers_asked(a, &poll->satellites, &n);
    orr_msg_elements m = {.epoch = orr_answers_epoch(&poll->epochs, part->index),
                          .frame = poll->frame,
                          .method = poll->method,
                          .satellites = {n, NULL, orr_answers_promise(ORR_MSG_SAT_ELEMENTS_SIZE)}};
    orr_elements_axes axes;
    _Static_assert(sizeof axes <= sizeof part->kept, "the axes are kept between two pieces of a frame");
    // Piece 0 is the axes and the message without its records, then comes one a satellite.
    bool another = true;
    if (part->done == 0) {
        orr_answer answer = orr_engine_axes(a->engine, m.epoch.t, (orr_elements_frame)poll->frame,
                                            (orr_elements_method)poll->method, &axes);
        m.epoch.answer = (uint8_t)answer;
        if (answer != ORR_ANSWER_OK) m.satellites = (orr_msg_sat_elements_list){0};
        orr_msg_elements_encode(&m, w);
        if (answer != ORR_ANSWER_OK) return 0;
        memcpy(part->kept, &axes, sizeof axes);
        another = orr_server_next_piece(part, 1 + (uint32_t)n);
    } else
        memcpy(&axes, part->kept, sizeof axes);
    for (; another; another = orr_server_next_piece(part, 1 + (uint32_t)n)) {
        uint32_t i = part->done - 1, flags;
        orr_kepler kepler;
        orr_answer answer;
        orr_msg_sat_elements one;
        orr_engine_elements(a->engine, &axes, &sats[i], 1, &kepler, &flags, &answer);
        fill(a->asked[i], answer, &kepler, flags, &one);
        orr_msg_sat_elements_records_encode(&(orr_msg_sat_elements_list){.count = 1, .item = &one}, w);
    }
    return 0;
}
