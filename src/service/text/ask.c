// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/text/ask.h"

#include <stdio.h>

#include "proto/fields.h"

static uint16_t refuse(orr_server_refusal *why, uint16_t code, const char *sentence)
{
    snprintf(why->sentence, sizeof why->sentence, "%s", sentence);
    return code;
}

orr_msg_epochs *orr_ask_epochs(uint16_t type, orr_msg_any *request)
{
    const orr_message_info *info = orr_message_of(type);
    const orr_field *f = info != NULL ? orr_record_field(info->record, "epochs") : NULL;
    return f != NULL ? (orr_msg_epochs *)(void *)((char *)request + f->offset) : NULL;
}

// Messages of the clock and of motion.
static uint16_t ask_lane(const orr_asked *a, uint16_t type, const orr_msg_any *request, orr_msg_any *m,
                         orr_server_refusal *why)
{
    if (a->streams == NULL) return refuse(why, ORR_MSG_ERROR_CODE_NOT_SERVED, "this server has no clock");
    orr_wire_writer w = {a->room, 0, ORR_MSG_LARGEST, ORR_WIRE_OK};
    switch (type) {
    case ORR_MSG_TYPE_GET_MODES:
        orr_streams_modes(a->streams, request->get_modes.after, &w);
        return orr_msg_modes_decode(w.data, w.size, &m->modes) == ORR_WIRE_OK ? 0
                                                                              : ORR_MSG_ERROR_CODE_INTERNAL;
    case ORR_MSG_TYPE_GET_TIME:
        orr_streams_time(a->streams, &m->time);
        return 0;
    case ORR_MSG_TYPE_CONTROL:
        return orr_streams_control(a->streams, &request->control, &m->time, why);
    case ORR_MSG_TYPE_RADIO_TIME:
        return orr_streams_radio(a->streams, &request->radio_time, ORR_TIME_NONE, &m->pace, why);
    case ORR_MSG_TYPE_MOTION:
        return orr_streams_motion(a->streams, &request->motion, why);
    case ORR_MSG_TYPE_GET_MOTION_STATS:
        if (orr_streams_motion_stats(a->streams, request->get_motion_stats.reset != 0, &m->motion_stats))
            return 0;
        return refuse(why, ORR_MSG_ERROR_CODE_NOT_SERVED, "this server takes no motion (serve --motion)");
    default:
        return refuse(why, ORR_MSG_ERROR_CODE_NOT_SERVED, "streams are not served as text");
    }
}

// What a request asks for.
static unsigned needed(uint16_t type, const orr_msg_any *request)
{
    switch (type) {
    case ORR_MSG_TYPE_GET_TIME:
    case ORR_MSG_TYPE_GET_MODES:
        return ORR_MAY_NOTHING;
    case ORR_MSG_TYPE_GET_MOTION_STATS:
        return request->get_motion_stats.reset != 0 ? ORR_MAY_MOTION : ORR_MAY_NOTHING;
    case ORR_MSG_TYPE_MOTION:
        return ORR_MAY_MOTION;
    case ORR_MSG_TYPE_CONTROL:
    case ORR_MSG_TYPE_RADIO_TIME:
        return ORR_MAY_CONTROL;
    default:
        return ORR_MAY_READ;
    }
}

uint16_t orr_ask(const orr_asked *a, uint16_t type, const orr_msg_any *request, uint32_t k,
                 const orr_message_info **answer, orr_msg_any *m, orr_server_refusal *why)
{
    const orr_message_info *info = orr_message_of(type);
    if (info == NULL || !info->from_client)
        return refuse(why, ORR_MSG_ERROR_CODE_UNKNOWN_TYPE, "there is no such request");
    *answer = info->answer != 0 ? orr_message_of(info->answer) : NULL;
    if ((needed(type, request) & ~a->may) != 0)
        return refuse(why, ORR_MSG_ERROR_CODE_NOT_PERMITTED, "you have no permission to do that");
    if (orr_msg_is_lane(type)) return ask_lane(a, type, request, m, why);
    const orr_server *s = a->server;
    if (orr_msg_handled(s->handlers, type) == 0)
        return refuse(why, ORR_MSG_ERROR_CODE_NOT_SERVED, "this server does not answer that as text");
    uint16_t code = orr_msg_begin(s->handlers, s->user, type, request, why);
    orr_server_part part = {.index = k};
    orr_wire_writer w = {a->room, 0, ORR_MSG_LARGEST, ORR_WIRE_OK};
    do {
        part.more = false;
        if (code == 0) code = orr_msg_answer(s->handlers, s->user, type, request, &part, &w, why);
    } while (code == 0 && part.more);
    if (code != 0) return code;
    if (w.status != ORR_WIRE_OK || (*answer)->decode(w.data, w.size, m) != ORR_WIRE_OK)
        return refuse(why, ORR_MSG_ERROR_CODE_INTERNAL, "the answer could not be made");
    return 0;
}
