// SPDX-License-Identifier: GPL-3.0-or-later
// Datagrams of every dialect: the first byte chooses which, the rest is the datagram. Whatever comes, a sample is one that the vehicle may
// judge, and a reply fits.
#include <stdlib.h>

#include "src/service/dialect/dialect.h"
#include "src/service/live/vehicle.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const names[] = {"orrery", "skydel", "lines", "nmea"};
    uint8_t reply[ORR_DIALECT_REPLY];
    orr_dialect_state s = {.begin = 1000, .now = 2000};
    orr_vehicle *v;
    const orr_vehicle_options o = {.join_s = 0.065, .length_ns = 5000000};
    if (size == 0 || orr_vehicle_open(&o, &v, NULL) != ORR_OK) return 0;
    const orr_dialect *d = orr_dialect_of(names[data[0] & 3]);
    for (int k = 0; k < 2; k++) { // what is kept of the first changes the second
        size_t n_reply = 0;
        orr_msg_motion m = {.order = 0};
        orr_server_refusal why;
        if (d->take(&s, data + 1, size - 1, &m, reply, &n_reply) == ORR_DIALECT_SAMPLE)
            (void)orr_vehicle_take(v, &m, s.now, &why);
        if (n_reply > ORR_DIALECT_REPLY) abort();
        s.greeted = true;
        s.now += 10000000;
    }
    orr_vehicle_close(v);
    return 0;
}
