// SPDX-License-Identifier: GPL-3.0-or-later
// What a signal generator does with a block: code phase, whole code periods and carrier phase of one satellite's signal at any
// instant of the block, from its two cubics. C99 and proto/gen/firmware alone.
//
//   cc -I proto/gen/firmware samples/block/play.c proto/gen/firmware/orrery_client.c -o play -lm
//   ./play 127.0.0.1 15754 T_NS G 5 L1CA COUNT STEP_NS      T_NS: nanoseconds of GPS time since 1980-01-06
//
// A line an instant: t_ns, chips, period, cycles, fraction.
#include <arpa/inet.h>
#include <inttypes.h>
#include <math.h>
#include <netinet/in.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "orrery_client.h"

#define LIGHT_MPS 299792458.0
#define NS INT64_C(1000000000)

static double cubic(const double c[4], double s) { return c[0] + s * (c[1] + s * (c[2] + s * c[3])); }

// Position in the ranging code `s` seconds after the block's begin: chips in [0, period), and how many periods of it the second
// has had. The code is read off the satellite's clock, which shows t - code / c: the reading at the begin stands in the block, to a
// fraction of a nanosecond, and from there it advances by s less what the pseudorange grows. A second holds whole periods.
static void code_phase(const orr_msg_sat_channel *x, const orr_msg_signal *signal, double s, double *chips,
                       int64_t *period)
{
    const double since_second_s = 1e-9 * ((double)(x->transmit % NS) + x->transmit_fraction_ns);
    const double advance_s = s - (cubic(x->code, s) - x->code[0]) / LIGHT_MPS;
    const double reading_s = fmod(since_second_s + advance_s, 1); // the block may reach into the next second
    const double all = reading_s * signal->chips_per_s, length = (double)signal->chips;
    const double whole = floor(all / length);
    *period = (int64_t)whole;
    *chips = all - whole * length;
}

// Phase of the carrier's range then, cycles: whole ones, and the rest in [0, 1). What the antenna receives has the phase
// f t less this; its frequency is `carrier_hz` plus the Doppler, -(c1 + 2 c2 s + 3 c3 s^2).
static void carrier_phase(const orr_msg_sat_channel *x, double s, int64_t *cycles, double *fraction)
{
    const double all = cubic(x->carrier, s), whole = floor(all);
    *cycles = x->carrier_cycles + (int64_t)whole;
    *fraction = all - whole;
}

// --- How the block comes: a client over a socket ---
static ptrdiff_t take(void *user, uint8_t *data, size_t n) { return recv(*(int *)user, data, n, 0); }
static ptrdiff_t put(void *user, const uint8_t *data, size_t n)
{
    return send(*(int *)user, data, n, MSG_NOSIGNAL);
}

static int give_up(const orr_client *c, const char *what, orr_wire_status s)
{
    fprintf(stderr, "play: %s: %s %s\n", what, orr_wire_status_text(s),
            s == ORR_WIRE_REFUSED ? c->sentence : "");
    return 1;
}

static bool find_signal(const orr_msg_caps *caps, char system, const char *name, orr_msg_signal *out)
{
    orr_wire_iter it = {0, 0};
    while (orr_msg_signal_next(&caps->signals, &it, out))
        if (out->system == (uint8_t)system && out->name.size == strlen(name) &&
            memcmp(out->name.data, name, out->name.size) == 0)
            return true;
    return false;
}

// The block that holds t, of one signal; false with a sentence where the satellite is not in it.
static bool get_block(orr_client *c, int64_t t, uint16_t signal, char system, unsigned number,
                      orr_msg_channels *m, orr_msg_sat_channel *out)
{
    const orr_msg_poll_channels poll = {.epochs = {.t = t, .count = 1},
                                        .signals = {.count = 1, .item = &signal}};
    orr_wire_status s = orr_client_poll_channels(c, &poll);
    if (s == ORR_WIRE_OK) s = orr_client_channels(c, m);
    if (s != ORR_WIRE_OK) return give_up(c, "POLL_CHANNELS", s), false;
    orr_wire_iter it = {0, 0};
    while (orr_msg_sat_channel_next(&m->channels, &it, out))
        if (out->sat.system == (uint8_t)system && out->sat.number == number) return true;
    fprintf(stderr, "play: %c%02u is not in view at %" PRId64 "\n", system, number, t);
    return false;
}

int main(int argc, char **argv)
{
    static uint8_t buffer[1 << 16];
    if (argc != 9) {
        fprintf(stderr, "usage: play HOST PORT T_NS SYSTEM NUMBER SIGNAL COUNT STEP_NS\n");
        return 2;
    }
    struct sockaddr_in a = {.sin_family = AF_INET, .sin_port = htons((uint16_t)atoi(argv[2]))};
    int fd = socket(AF_INET, SOCK_STREAM, 0);
    if (inet_pton(AF_INET, argv[1], &a.sin_addr) != 1 || connect(fd, (struct sockaddr *)&a, sizeof a) != 0) {
        fprintf(stderr, "play: cannot connect to %s port %s\n", argv[1], argv[2]);
        return 1;
    }
    orr_client c;
    orr_msg_caps caps;
    orr_msg_signal signal;
    orr_client_init(&c, (orr_client_io){&fd, take, put}, buffer, sizeof buffer);
    const orr_wire_status s = orr_client_open(&c, "play", "1", &caps);
    if (s != ORR_WIRE_OK) return give_up(&c, "HELLO", s);
    if (!find_signal(&caps, argv[4][0], argv[6], &signal)) {
        fprintf(stderr, "play: the scenario sends no signal %s of %s\n", argv[6], argv[4]);
        return 1;
    }
    const int64_t first = strtoll(argv[3], NULL, 10), step = strtoll(argv[8], NULL, 10);
    const long count = strtol(argv[7], NULL, 10);
    orr_msg_channels m = {.block = INT64_MIN};
    orr_msg_sat_channel x = {0};
    for (long k = 0; k < count; k++) {
        const int64_t t = first + k * step;
        if (m.block == INT64_MIN ||
            t >= m.block + m.length) // the next block: its values and rates go on from this one's
            if (!get_block(&c, t, signal.signal, argv[4][0], (unsigned)atoi(argv[5]), &m, &x)) return 1;
        const double in_block_s = (double)(t - m.block) / 1e9;
        double chips, fraction;
        int64_t period, cycles;
        code_phase(&x, &signal, in_block_s, &chips, &period);
        carrier_phase(&x, in_block_s, &cycles, &fraction);
        printf("%" PRId64 " %.9f %" PRId64 " %" PRId64 " %.9f\n", t, chips, period, cycles, fraction);
    }
    close(fd);
    return 0;
}
