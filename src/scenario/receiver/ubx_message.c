// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of UBX, and its numbers of systems, satellites and signals (UBX-18010854, 1.5; UBX-23002975 for L5, B1C and B2a).
#include <string.h>

#include "src/scenario/receiver/port_private.h"

static const struct {
    char system;
    int8_t number;
} systems[] = {{'G', 0}, {'S', 1}, {'E', 2}, {'C', 3}, {'J', 5}, {'R', 6}, {'I', 7}};

// sigId of the components that are told for a signal: G L2 CL, L5 Q; E1 C, E5a Q, E5b Q; B1C and B2a pilot; of B1I that of D1, D2's
// is one more.
static const struct {
    char name[4];
    uint8_t number;
} signals[] = {{"G1C", 0}, {"G2X", 3}, {"G5X", 7}, {"S1C", 0}, {"E1X", 0}, {"E5X", 4},
               {"E7X", 6}, {"C2I", 0}, {"C6I", 4}, {"C1X", 5}, {"C5X", 7}, {"J1C", 0},
               {"J2X", 5}, {"J5X", 9}, {"R1C", 0}, {"R2C", 2}, {"I5A", 0}};

int port_ubx_system(char system)
{
    for (size_t k = 0; k < sizeof systems / sizeof *systems; k++)
        if (systems[k].system == system) return systems[k].number;
    return -1;
}

int port_ubx_satellite(orr_sat sat) { return orr_sat_number(sat) + (orr_sat_system(sat) == 'S' ? 100 : 0); }

// BeiDou's geostationary satellites send D2.
bool port_ubx_sends_d2(orr_sat sat)
{
    const int number = orr_sat_number(sat);
    return orr_sat_system(sat) == 'C' && (number <= 5 || number >= 59);
}

int port_ubx_signal(const orr_signal *s, orr_sat sat)
{
    for (size_t k = 0; k < sizeof signals / sizeof *signals; k++)
        if (signals[k].name[0] == s->system && strcmp(signals[k].name + 1, s->observation) == 0) {
            if (!port_ubx_sends_d2(sat)) return signals[k].number;
            return strcmp(s->observation, "2I") == 0   ? 1
                   : strcmp(s->observation, "6I") == 0 ? 10
                                                       : signals[k].number;
        }
    return -1;
}

int port_ubx_channel(const orr_port *p, orr_sat sat)
{
    int channel;
    return orr_channels_frequency_channel(p->plan.channels, sat, &channel) ? channel + 7 : 0;
}

void port_ubx_message(const uint8_t type[2], const uint8_t *payload, size_t n, orr_port_bytes *out)
{
    const uint8_t head[6] = {0xb5, 0x62, type[0], type[1], (uint8_t)n, (uint8_t)(n >> 8)};
    uint8_t sum[2] = {0, 0};
    for (size_t k = 2; k < sizeof head; k++)
        sum[0] = (uint8_t)(sum[0] + head[k]), sum[1] = (uint8_t)(sum[1] + sum[0]);
    for (size_t k = 0; k < n; k++)
        sum[0] = (uint8_t)(sum[0] + payload[k]), sum[1] = (uint8_t)(sum[1] + sum[0]);
    orr_port_bytes_add(out, head, sizeof head);
    orr_port_bytes_add(out, payload, n);
    orr_port_bytes_add(out, sum, sizeof sum);
}
