// SPDX-License-Identifier: GPL-3.0-or-later
// A generator's loop: subscribes to an antenna's blocks as they follow each other, 20 ms ahead of the scenario's clock, and plays N of them.
// No allocation: one buffer. Build: cc -I proto/gen/firmware samples/live_loop.c proto/gen/firmware/orrery_client.c -lm
#include "orrery_client.h"

#include <arpa/inet.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <unistd.h>

static ptrdiff_t take(void *user, uint8_t *data, size_t n) { return recv(*(int *)user, data, n, 0); }
static ptrdiff_t give(void *user, const uint8_t *data, size_t n) { return send(*(int *)user, data, n, 0); }

// What a generator would modulate: the code of one channel s seconds after the block's begin, m.
static double code_m(const orr_msg_sat_channel *c, double s)
{
    return c->code[0] + s * (c->code[1] + s * (c->code[2] + s * c->code[3]));
}

int main(int argc, char **argv)
{
    static uint8_t buffer[65536];
    if (argc != 3) return 2;
    struct sockaddr_in at = {.sin_family = AF_INET, .sin_port = htons((uint16_t)atoi(argv[1]))};
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    int fd = socket(AF_INET, SOCK_STREAM, 0);
    if (fd < 0 || connect(fd, (struct sockaddr *)&at, sizeof at) != 0) return 1;
    orr_client c;
    orr_client_init(&c, (orr_client_io){&fd, take, give}, buffer, sizeof buffer);
    uint8_t poll[64];
    orr_wire_writer w = {poll, 0, sizeof poll, ORR_WIRE_OK};
    const orr_msg_poll_channels every_block = {
        .epochs = {INT64_MIN, 0, (uint32_t)atoi(argv[2])}}; // from now on, step 0
    orr_msg_poll_channels_encode(&every_block, &w);
    const orr_msg_subscribe asked = {.request = ORR_MSG_TYPE_POLL_CHANNELS,
                                     .pacing = ORR_MSG_PACING_CLOCK,
                                     .credit = 100,
                                     .lead = 20000000,
                                     .poll = {poll, (uint16_t)w.size}};
    orr_msg_subscribed told;
    if (orr_client_subscribe(&c, &asked, &told) != ORR_WIRE_OK) return 1;
    const uint32_t stream = c.sequence;
    double end_m = NAN,
           worst_m =
               0; // of the first channel: where the block before ended, and how far the next began from there
    orr_msg_sat_id last = {0, 0};
    unsigned long blocks = 0;
    orr_frame f;
    while (orr_client_next(&c, &f) == ORR_WIRE_OK && f.type != ORR_MSG_TYPE_STREAM_END) {
        orr_msg_channels m;
        orr_msg_sat_channel x;
        if (f.type != ORR_MSG_TYPE_CHANNELS || orr_msg_channels_decode(f.payload, f.size, &m) != ORR_WIRE_OK)
            continue;
        if (orr_msg_sat_channel_at(&m.channels, 0, &x)) {
            if (x.sat.system == last.system && x.sat.number == last.number)
                worst_m = fmax(worst_m, fabs(x.code[0] - end_m));
            end_m = code_m(&x, (double)m.length * 1e-9);
            last = x.sat;
        }
        if (++blocks % 50 == 0) orr_client_credit(&c, &(orr_msg_credit){stream, 50});
    }
    printf("%lu blocks, joints within %.1e m\n", blocks, worst_m);
    close(fd);
    return f.type == ORR_MSG_TYPE_STREAM_END ? 0 : 1;
}
