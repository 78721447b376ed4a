// SPDX-License-Identifier: GPL-3.0-or-later
// The firmware client from C++: its header is read as C++17 and its functions are linked as C.
#include <cstdio>

#include "orrery_client.h"

static_assert(sizeof(orr_msg_sat_state) >= ORR_MSG_SAT_STATE_SIZE,
              "a record in memory holds that of the wire");

static ptrdiff_t closed(void *, uint8_t *, size_t) { return 0; }
static ptrdiff_t swallow(void *user, const uint8_t *data, size_t n)
{
    orr_frame frame;
    size_t used;
    if (orr_frame_parse(data, n, ORR_MSG_MAX_PAYLOAD, &frame, &used) != ORR_WIRE_OK) return -1;
    *static_cast<uint16_t *>(user) = frame.type;
    return static_cast<ptrdiff_t>(n);
}

int main()
{
    static uint8_t buffer[1000];
    uint16_t sent = 0;
    orr_client client;
    orr_client_init(&client, orr_client_io{&sent, closed, swallow}, buffer, sizeof buffer);
    orr_msg_poll poll = {};
    poll.epochs = {1, 0, 1};
    orr_msg_states states;
    bool asked = orr_client_poll(&client, &poll) == ORR_WIRE_OK && sent == ORR_MSG_TYPE_POLL;
    bool ended = orr_client_states(&client, &states) == ORR_WIRE_CLOSED;
    if (!asked || !ended) std::fprintf(stderr, "a POLL was to be sent, and the end of the connection told\n");
    return asked && ended ? 0 : 1;
}
