// SPDX-License-Identifier: GPL-3.0-or-later
// The questions and pieces that the handlers of all kinds of request share; below all of them.
#include <stdio.h>
#include <string.h>

#include "src/service/answers/answers_private.h"

const orr_engine *orr_answers_engine(const void *user) { return ((const orr_answers *)user)->engine; }

orr_msg_sat_id orr_answers_sat_id(orr_sat sat)
{
    return (orr_msg_sat_id){(uint8_t)orr_sat_system(sat), (uint8_t)orr_sat_number(sat)};
}

uint16_t orr_answers_refuse(orr_server_refusal *why, uint16_t code, const char *sentence)
{
    snprintf(why->sentence, sizeof why->sentence, "%s", sentence);
    return code;
}

uint16_t orr_answers_check_epochs(const char *name, const orr_msg_epochs *epochs, orr_server_refusal *why)
{
    const char *wrong = NULL;
    int64_t last;
    if (epochs->count == 0)
        wrong = "count is 0, no epoch is asked for";
    else if (epochs->count > ORR_MSG_MAX_EPOCHS) {
        snprintf(why->sentence, sizeof why->sentence, "%s: %lu epochs, at most %u may be asked for at once",
                 name, (unsigned long)epochs->count, ORR_MSG_MAX_EPOCHS);
        return ORR_MSG_ERROR_CODE_LIMIT;
    } else if (epochs->count > 1 && epochs->step == 0)
        wrong = "step is 0, but count is more than 1";
    else if (__builtin_mul_overflow(epochs->step, (int64_t)epochs->count - 1, &last) ||
             __builtin_add_overflow(epochs->t, last, &last))
        wrong = "its last epoch is beyond what a time can be";
    if (wrong == NULL) return 0;
    snprintf(why->sentence, sizeof why->sentence, "%s: %s", name, wrong);
    return ORR_MSG_ERROR_CODE_BAD_REQUEST;
}

orr_msg_epoch orr_answers_epoch(const orr_msg_epochs *epochs, uint32_t index)
{
    return (orr_msg_epoch){epochs->t + epochs->step * (int64_t)index, index, epochs->count, 0};
}

const orr_sat *orr_answers_asked(orr_answers *a, const orr_msg_sat_id_list *satellites, uint16_t *n)
{
    *n = satellites->count;
    for (uint16_t i = 0; i < *n; i++) {
        orr_msg_sat_id_at(satellites, i, &a->asked[i]);
        a->sat[i] = orr_sat_make((char)a->asked[i].system, a->asked[i].number);
    }
    if (*n > 0) return a->sat;
    *n = a->n_ids;
    memcpy(a->asked, a->id, *n * sizeof a->id[0]);
    return a->all;
}

orr_wire_records orr_answers_promise(uint16_t stride)
{
    static const uint8_t none;
    return (orr_wire_records){.data = &none, .size = 0, .stride = stride};
}
