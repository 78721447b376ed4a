// SPDX-License-Identifier: GPL-3.0-or-later
// What the handlers of the service share: the engine, room for one epoch, and the questions that every POLL
// by satellites is asked alike.
#ifndef ORR_SERVICE_ANSWERS_PRIVATE_H
#define ORR_SERVICE_ANSWERS_PRIVATE_H

#include "src/scenario/engine/timeline.h"
#include "src/service/answers/answers.h"
#include "src/service/answers/answers_channels.h"

struct orr_answers {
    const orr_engine *engine;
    orr_server server;
    orr_msg_sat_id id[ORR_MSG_MAX_SATELLITES]; // of all served
    const orr_sat *all;                        // the same
    uint16_t n_ids;
    orr_msg_inertial_unit unit[ORR_MSG_MAX_UNITS];
    orr_answers_channels_room channels;
    orr_timeline *timeline;
    orr_ephemeris_slice *slice; // NULL without satellites
    // Room for one epoch; the loop is one thread's, so one room is enough.
    orr_sat sat[ORR_MSG_MAX_SATELLITES];
    orr_msg_sat_id asked[ORR_MSG_MAX_SATELLITES];
    orr_answer answer[ORR_MSG_MAX_SATELLITES];
    orr_sat_state state[ORR_MSG_MAX_SATELLITES];
    orr_happening happening[ORR_MSG_MAX_EVENTS];
    orr_msg_event event[ORR_MSG_MAX_EVENTS];
};

// Writes the sentence and returns the code.
uint16_t orr_answers_refuse(orr_server_refusal *why, uint16_t code, const char *sentence);
// Whether epochs can be: 0 or a code. `name` is for the sentence.
uint16_t orr_answers_check_epochs(const char *name, const orr_msg_epochs *epochs, orr_server_refusal *why);
// Epoch number `index` of a request, its answer still open.
orr_msg_epoch orr_answers_epoch(const orr_msg_epochs *epochs, uint32_t index);
// Stands for the records of a message's last list, which will come in pieces; `stride` as in
// orr_wire_records.
orr_wire_records orr_answers_promise(uint16_t stride);
// The satellites that a list names, all served for an empty list; *n of them. What the list names otherwise
// than IGS files do is ORR_SAT_NONE, which nothing serves; a->asked[0..n) has the names as they came, for the
// answer.
const orr_sat *orr_answers_asked(orr_answers *a, const orr_msg_sat_id_list *satellites, uint16_t *n);

// A vector as a message's array.
static inline void orr_answers_put(double to[3], orr_vec3 v)
{
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
}

#endif
