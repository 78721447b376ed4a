// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/generator/feed/subscription.h"

static void hand(orr_gen_subscription *s, const orr_frame *f)
{
    if (f->type == s->answer) {
        if (!s->keep(s->user, f)) s->bad = true;
    } else if (f->type == ORR_MSG_TYPE_STREAM_END) {
        orr_msg_stream_end end;
        s->ended = true;
        if (orr_msg_stream_end_decode(f->payload, f->size, &end) == ORR_WIRE_OK)
            orr_wire_text_copy(end.sentence, s->end, sizeof s->end);
    } else
        s->bad = true; // a gap, which a stream at no clock's pace has none of
}

// Frames of all streams. The client keeps the first of the subscriptions that are on its connection; a frame of a stream that has been given
// up is passed over.
static void take(void *user, const orr_frame *f)
{
    for (orr_gen_subscription *s = user; s != NULL; s = s->next)
        if (f->sequence == s->stream) hand(s, f);
}

static bool on_connection(const orr_gen_subscription *s)
{
    const orr_client *c = orr_gen_link_client(s->link);
    if (c->stream != take) return false;
    for (const orr_gen_subscription *k = c->stream_user; k != NULL; k = k->next)
        if (k == s) return true;
    return false;
}

bool orr_gen_subscribed(const orr_gen_subscription *s)
{
    return on_connection(s) && s->stream != 0 && !s->ended && !s->bad;
}

orr_wire_status orr_gen_subscribe(orr_gen_subscription *s, const orr_wire_writer *poll, uint32_t credit)
{
    orr_client *c = orr_gen_link_client(s->link);
    const orr_msg_subscribe request = {.request = s->request,
                                       .pacing = ORR_MSG_PACING_FREE,
                                       .credit = credit,
                                       .poll = {poll->data, (uint16_t)poll->size}};
    if (!on_connection(s)) {
        s->next = c->stream == take ? c->stream_user : NULL;
        c->stream = take;
        c->stream_user = s;
    }
    s->stream = 0;
    s->ended = s->bad = false;
    s->end[0] = '\0';
    orr_msg_subscribed answer;
    const orr_wire_status ws = orr_client_subscribe(c, &request, &answer);
    if (ws == ORR_WIRE_OK) s->stream = c->sequence;
    return ws;
}

bool orr_gen_no_streams(const orr_gen_subscription *s, orr_wire_status status)
{
    const uint16_t code = orr_gen_link_client(s->link)->error_code;
    return status == ORR_WIRE_REFUSED && s->stream == 0 &&
           (code == ORR_MSG_ERROR_CODE_UNKNOWN_TYPE || code == ORR_MSG_ERROR_CODE_NOT_SERVED);
}

orr_wire_status orr_gen_subscription_credit(orr_gen_subscription *s, size_t answers)
{
    const orr_msg_credit credit = {.stream = s->stream, .blocks = (uint32_t)answers};
    return answers == 0 || s->ended ? ORR_WIRE_OK : orr_client_credit(orr_gen_link_client(s->link), &credit);
}

orr_wire_status orr_gen_subscription_wait(orr_gen_subscription *s)
{
    orr_client *c = orr_gen_link_client(s->link);
    orr_frame f;
    const orr_wire_status ws = orr_client_next(c, &f);
    if (ws == ORR_WIRE_OK) take(c->stream_user, &f);
    return ws;
}
