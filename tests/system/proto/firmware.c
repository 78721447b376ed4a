// SPDX-License-Identifier: GPL-3.0-or-later
// A signal generator's side in miniature: proto's client, built as for firmware, over callbacks of its own.
// Asks a service for all states at its span's start and in the middle, and for what else it serves in the
// middle, and prints what a test can compare.
//   firmware HOST PORT
#include <arpa/inet.h>
#include <inttypes.h>
#include <netinet/in.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include "orrery_client.h"

static ptrdiff_t take(void *user, uint8_t *data, size_t n) { return recv(*(int *)user, data, n, 0); }
static ptrdiff_t put(void *user, const uint8_t *data, size_t n)
{
    return send(*(int *)user, data, n, MSG_NOSIGNAL);
}

static int give_up(const orr_client *c, const char *what, orr_wire_status s)
{
    fprintf(stderr, "%s: %s %s\n", what, orr_wire_status_text(s), s == ORR_WIRE_REFUSED ? c->sentence : "");
    return 1;
}

int main(int argc, char **argv)
{
    if (argc != 3) return 2;
    struct sockaddr_in a = {.sin_family = AF_INET, .sin_port = htons((uint16_t)atoi(argv[2]))};
    struct timeval patience = {.tv_sec = 20};
    int fd = socket(AF_INET, SOCK_STREAM, 0);
    if (inet_pton(AF_INET, argv[1], &a.sin_addr) != 1 || connect(fd, (struct sockaddr *)&a, sizeof a) != 0)
        return 1;
    setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);

    static uint8_t buffer[32768];
    orr_client c;
    orr_client_init(&c, (orr_client_io){&fd, take, put}, buffer, sizeof buffer);
    orr_msg_caps caps;
    orr_wire_status s = orr_client_open(&c, "firmware", "1", &caps);
    if (s != ORR_WIRE_OK) return give_up(&c, "HELLO", s);
    int64_t from = caps.span.first, to = caps.span.last;
    printf("satellites %u\n", (unsigned)caps.satellites.count);
    s = orr_client_check(&c, 99);
    if (s != ORR_WIRE_OK) return give_up(&c, "PING", s);
    orr_msg_poll poll = {.epochs = {from, (to - from) / 2, 2}};
    s = orr_client_poll(&c, &poll);
    if (s != ORR_WIRE_OK) return give_up(&c, "POLL", s);
    for (uint32_t k = 0; k < poll.epochs.count; k++) {
        orr_msg_states m;
        s = orr_client_states(&c, &m);
        if (s != ORR_WIRE_OK) return give_up(&c, "STATES", s);
        orr_msg_sat_state x;
        orr_wire_iter it = {0, 0};
        while (orr_msg_sat_state_next(&m.satellites, &it, &x))
            printf("%" PRId64 " %c%02u %a %a %a\n", m.epoch.t, x.sat.system, (unsigned)x.sat.number,
                   x.pos_m[0], x.vel_mps[1], x.acc_mps2[2]);
    }
    orr_msg_poll_elements ask = {.epochs = {.t = from + (to - from) / 2, .count = 1}};
    s = orr_client_poll_elements(&c, &ask);
    if (s != ORR_WIRE_OK) return give_up(&c, "POLL_ELEMENTS", s);
    orr_msg_elements e;
    s = orr_client_elements(&c, &e);
    if (s != ORR_WIRE_OK) return give_up(&c, "ELEMENTS", s);
    orr_msg_sat_elements k;
    orr_wire_iter it = {0, 0};
    while (orr_msg_sat_elements_next(&e.satellites, &it, &k))
        printf("elements %c%02u %a %a %a\n", k.sat.system, (unsigned)k.sat.number, k.a_m, k.i_rad, k.u_rad);
    orr_msg_poll_navdata which = {.epochs = ask.epochs};
    s = orr_client_poll_navdata(&c, &which);
    if (s != ORR_WIRE_OK) return give_up(&c, "POLL_NAVDATA", s);
    orr_msg_navdata n;
    s = orr_client_navdata(&c, &n);
    if (s != ORR_WIRE_OK) return give_up(&c, "NAVDATA", s);
    orr_msg_sat_navdata b;
    it = (orr_wire_iter){0, 0};
    while (orr_msg_sat_navdata_next(&n.satellites, &it, &b)) {
        orr_msg_nav_page p;
        orr_wire_iter in = {0, 0};
        while (orr_msg_nav_page_next(&b.pages, &in, &p)) {
            printf("navdata %c%02u %u ", b.sat.system, (unsigned)b.sat.number, (unsigned)p.number);
            for (uint16_t i = 0; i < p.data.size; i++) printf("%02x", p.data.data[i]);
            putchar('\n');
        }
    }
    close(fd);
    return 0;
}
