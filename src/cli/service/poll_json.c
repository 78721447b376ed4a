// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/service/poll_json.h"

#include <stdio.h>

json_t *orr_poll_json_vector(const double *v, int n)
{
    json_t *a = json_array();
    for (int k = 0; k < n; k++) json_array_append_new(a, orr_json_number(v[k]));
    return a;
}

json_t *orr_poll_json_sat(orr_msg_sat_id id)
{
    char text[8];
    return json_string(orr_poll_sat_name(id, text));
}

json_t *orr_poll_json_bits(uint32_t bits, const char *(*name)(unsigned bit))
{
    json_t *a = json_array();
    for (unsigned bit = 0; bit < 32; bit++)
        if ((bits >> bit & 1u) != 0 && name(bit) != NULL) json_array_append_new(a, json_string(name(bit)));
    return a;
}

void orr_poll_json_print(json_t *j) { (void)orr_json_put(j, JSON_COMPACT | JSON_REAL_PRECISION(17)); }

const char *orr_poll_sat_name(orr_msg_sat_id id, char buf[8])
{
    snprintf(buf, 8, "%c%02u", id.system >= ' ' && id.system <= '~' ? id.system : '?', (unsigned)id.number);
    return buf;
}

const char *orr_poll_answer_words(uint8_t answer)
{
    switch (answer) {
    case ORR_MSG_ANSWER_OK:
        return "ok";
    case ORR_MSG_ANSWER_OUTSIDE_SPAN:
        return "outside the served span";
    case ORR_MSG_ANSWER_NO_ARC:
        return "no valid arc";
    case ORR_MSG_ANSWER_NOT_SERVED:
        return "not served";
    case ORR_MSG_ANSWER_BELOW_HORIZON:
        return "below the horizon";
    case ORR_MSG_ANSWER_NO_VALUE:
        return "no value there";
    default:
        return "unknown answer";
    }
}
