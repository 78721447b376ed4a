// SPDX-License-Identifier: GPL-3.0-or-later
// What lies below the handlers, over bytes of anyone: payloads decoded, a stream cut anywhere, the client. The
// first byte chooses what is done with the rest. Requests that are well made meet the real table of handlers in
// tests/fuzz/service/fuzz_handlers.c.
#include <stdlib.h>

#include "proto/client.h"
#include "proto/server.h"
#include "tests/unit/proto/fake.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

#define MUST(condition)                                                                                      \
    do {                                                                                                     \
        if (!(condition)) abort();                                                                           \
    } while (0)

// What decodes encodes, and decodes to the same bytes again.
#define AGAIN(name)                                                                                          \
    static void again_##name(const uint8_t *data, size_t n)                                                  \
    {                                                                                                        \
        static uint8_t one[1 << 20], two[1 << 20];                                                           \
        orr_msg_##name m;                                                                                    \
        if (orr_msg_##name##_decode(data, n, &m) != ORR_WIRE_OK) return;                                     \
        orr_wire_writer a = {one, 0, sizeof one, ORR_WIRE_OK}, b = {two, 0, sizeof two, ORR_WIRE_OK};        \
        MUST(orr_msg_##name##_encode(&m, &a) == ORR_WIRE_OK && a.size <= n);                                 \
        MUST(orr_msg_##name##_decode(one, a.size, &m) == ORR_WIRE_OK);                                       \
        MUST(orr_msg_##name##_encode(&m, &b) == ORR_WIRE_OK && b.size == a.size);                            \
        MUST(memcmp(one, two, a.size) == 0);                                                                 \
    }
ORR_MSG_EACH(AGAIN)

static void decode_all(const uint8_t *data, size_t n)
{
#define CALL(name) again_##name(data, n);
    ORR_MSG_EACH(CALL)
    orr_msg_states m;
    if (orr_msg_states_decode(data, n, &m) != ORR_WIRE_OK) return;
    orr_msg_sat_state s;
    orr_wire_iter it = {0, 0};
    uint16_t seen = 0;
    while (orr_msg_sat_state_next(&m.satellites, &it, &s)) seen++;
    MUST(seen == m.satellites.count);
}

static uint8_t stream[1 << 17], out[ORR_SERVER_OUT];

// Whole frames alone may come out, however the input is cut.
static void serve(const uint8_t *data, size_t n, size_t chunk)
{
    fake f = {.n_sats = 2};
    orr_server s = fake_server(&f);
    orr_server_conn c = {0};
    size_t have = 0, from = 0;
    for (int rounds = 0, busy = 0; rounds < 5000 && busy < 5;
         rounds++) { // a request for many epochs would take long
        size_t more = n - from < chunk ? n - from : chunk;
        memcpy(stream + have, data + from, more);
        have += more;
        from += more;
        orr_wire_writer w = {out, 0, sizeof out, ORR_WIRE_OK};
        orr_server_step step;
        orr_server_run(&s, &c, stream, have, &w, &step);
        MUST(step.consumed <= have && w.size <= w.capacity && w.status == ORR_WIRE_OK);
        MUST(step.need <= ORR_FRAME_OVERHEAD + ORR_MSG_MAX_REQUEST);
        for (size_t at = 0, used; at < w.size; at += used) {
            orr_frame fr;
            MUST(orr_frame_parse(out + at, w.size - at, ORR_MSG_MAX_PAYLOAD, &fr, &used) == ORR_WIRE_OK);
        }
        busy += step.busy;
        have -= step.consumed;
        memmove(stream, stream + step.consumed, have);
        if (step.closing != 0 || (from == n && !step.busy)) return;
    }
}

typedef struct source {
    const uint8_t *data;
    size_t n;
} source;

static ptrdiff_t give(void *user, uint8_t *data, size_t n)
{
    source *s = user;
    size_t m = s->n < n ? s->n : n;
    if (m > 7) m = 7;
    memcpy(data, s->data, m);
    s->data += m;
    s->n -= m;
    return (ptrdiff_t)m;
}

static ptrdiff_t swallow(void *user, const uint8_t *data, size_t n)
{
    (void)user;
    (void)data;
    return (ptrdiff_t)n;
}

static void answer_client(const uint8_t *data, size_t n)
{
    static uint8_t buffer[2048];
    source s = {data, n};
    orr_client c;
    orr_client_init(&c, (orr_client_io){&s, give, swallow}, buffer, sizeof buffer);
    orr_msg_caps caps;
    (void)orr_client_open(&c, "fuzz", "1", &caps);
    orr_msg_poll poll = {.epochs = {.step = 1, .count = 2}};
    orr_msg_states m;
    (void)orr_client_poll(&c, &poll);
    while (orr_client_states(&c, &m) == ORR_WIRE_OK) continue;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    if (n < 1 || n > 60000) return 0;
    uint8_t what = data[0];
    data++;
    n--;
    switch (what % 4) {
    case 0:
        decode_all(data, n);
        break;
    case 1:
        serve(data, n, (size_t)what + 1);
        break;
    default:
        answer_client(data, n);
        break;
    }
    return 0;
}
