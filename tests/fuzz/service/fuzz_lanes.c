// SPDX-License-Identifier: GPL-3.0-or-later
// Payloads of the messages that belong to a connection (streams, clock, motion), each behind its type and length: whatever they say,
// what is answered are whole frames, and all streams can be closed. Once a ring for motion is open, they stand in its memory too, as a
// client that means no good might write them.
#include <event2/event.h>
#include <stdlib.h>
#include <unistd.h>

#include "src/service/serve/lanes.h"
#include "unit/proto/fake.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void must(bool holds)
{
    if (!holds) abort();
}

static void host(void *user, orr_host *h)
{
    const int64_t now = *(const int64_t *)user;
    *h = (orr_host){now, now, INT64_C(1700000000000000000) + now, INT64_C(1700000037000000000) + now};
}

static void check_frames(const uint8_t *data, size_t n)
{
    for (size_t at = 0, used; at < n; at += used) {
        orr_frame f;
        must(orr_frame_parse(data + at, n - at, ORR_MSG_MAX_PAYLOAD, &f, &used) == ORR_WIRE_OK);
    }
}

// Bytes of anyone's anywhere in the ring, and its bell.
static void write_ring(const orr_motion_ring *r, uint8_t where, const uint8_t *data, size_t n)
{
    static const uint64_t once = 1;
    const size_t size = orr_ring_size(ORR_MOTION_RING_SLOTS, ORR_MOTION_RING_STRIDE);
    size_t at = ORR_RING_SLOTS_AT + where / 4 * (size_t)ORR_MOTION_RING_STRIDE + where % 4 * (size_t)8;
    if (where >= 240) at = (where - 240u) * 8; // its head
    if (at >= size) return;
    memcpy(r->made.ring.memory + at, data, n < size - at ? n : size - at);
    must(write(r->bell, &once, sizeof once) == sizeof once);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static uint8_t room[64 << 10];
    int64_t now_ns = 1000;
    fake f = {.n_sats = 3};
    const orr_server server = fake_server(&f);
    orr_vehicle *vehicle = NULL;
    orr_streams *streams = NULL;
    const orr_vehicle_options live = {.join_s = 0.065, .length_ns = 5000000};
    if (orr_vehicle_open(&live, &vehicle, NULL) != ORR_OK) return 0;
    const orr_streams_options o = {
        .maker = &server, .host = host, .host_user = &now_ns, .vehicle = vehicle, .processor = -1};
    if (orr_streams_open(&o, &streams, NULL) != ORR_OK) {
        orr_vehicle_close(vehicle);
        return 0;
    }
    struct event_base *base = event_base_new();
    orr_lanes lanes = {.streams = streams,
                       .judge = &server,
                       .owner = &lanes,
                       .may = ORR_MAY_ALL,
                       .passes = true,
                       .base = base};
    uint32_t sequence = 0;
    for (size_t at = 0; at + 3 <= size;) {
        size_t n = data[at + 1];
        const uint8_t *payload = data + at + 2;
        orr_wire_writer out = {room, 0, sizeof room, ORR_WIRE_OK};
        if (n > size - at - 2) n = size - at - 2;
        const uint16_t type = (uint16_t)(data[at] < 240 ? 20 + data[at] % 20 : 40 + data[at] % 16);
        const orr_frame frame = {1, 0, type, ++sequence, payload, (uint32_t)n};
        if (orr_msg_is_lane(frame.type)) must(orr_lanes_take(&lanes, &frame, &out));
        orr_lanes_passed(&lanes); // the descriptor of a ring has gone
        if (lanes.motion != NULL && n > 0) {
            write_ring(lanes.motion, data[at], payload, n);
            event_base_loop(base, EVLOOP_NONBLOCK);
        }
        for (int k = 0; k < 8; k++) (void)orr_streams_turn(streams, now_ns);
        (void)orr_lanes_fill(&lanes, &out);
        check_frames(room, out.size);
        orr_vehicle_block b;
        (void)orr_vehicle_block_at(vehicle, now_ns / 5000000 * 5000000, now_ns / 5000000 * 5000000 + 5000000,
                                   &b);
        now_ns += (int64_t)data[at] << 17;
        at += 2 + n;
    }
    orr_lanes_close(&lanes);
    event_base_free(base);
    orr_streams_close(streams);
    orr_vehicle_close(vehicle);
    return 0;
}
