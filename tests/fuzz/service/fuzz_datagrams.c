// SPDX-License-Identifier: GPL-3.0-or-later
// Datagrams of clients' channels: pieces of a length and bytes, of which the first byte says by which channel, whether from this machine,
// and whether we put the seal that the sender would. What is taken is a whole frame with a number that has not been taken before.
#include <stdlib.h>

#include "src/service/net/datagrams.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { CHANNELS = 2, MOST = 64 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const uint8_t key[ORR_SEAL_KEY] = {1, 2, 3};
    uint8_t room[ORR_DATAGRAM_HEAD + 256 + ORR_DATAGRAM_SEAL];
    uint64_t had[CHANNELS][MOST];
    size_t n_had[CHANNELS] = {0, 0};
    orr_datagrams *d = orr_datagrams_open();
    orr_seal *seal = orr_seal_open(key);
    if (d == NULL || seal == NULL) abort();
    const uint32_t channel[CHANNELS] = {orr_datagrams_admit(d, key, true),
                                        orr_datagrams_admit(d, NULL, true)};
    for (size_t at = 0; at + 2 <= size;) {
        const uint8_t how = data[at];
        size_t n = data[at + 1];
        if (n > size - at - 2) n = size - at - 2;
        memcpy(room, data + at + 2, n);
        at += 2 + n;
        const size_t which = how & 1;
        if ((how & 2) != 0 && n >= ORR_DATAGRAM_HEAD) orr_wire_store_u32(room + 4, channel[which]);
        if ((how & 4) != 0) {
            if (!orr_seal_put(seal, room, n)) abort();
            n += ORR_DATAGRAM_SEAL;
        }
        orr_frame f;
        if (orr_datagrams_take(d, room, n, (how & 8) != 0, &f) != ORR_DATAGRAM_TAKEN) continue;
        const uint32_t to = orr_datagram_channel(room, n);
        const uint64_t number = orr_wire_load_u64(room + 8);
        if (to != channel[0] && to != channel[1]) abort();
        if (f.payload + f.size > room + n || number == 0) abort();
        const size_t k = to == channel[1];
        if (k == 1 && (how & 8) == 0) abort(); // unsealed from elsewhere
        for (size_t i = 0; i < n_had[k]; i++)
            if (had[k][i] == number) abort();
        if (n_had[k] < MOST) had[k][n_had[k]++] = number;
    }
    orr_datagrams_leave(d, channel[0]);
    orr_seal_close(seal);
    orr_datagrams_close(d);
    return 0;
}
