// SPDX-License-Identifier: GPL-3.0-or-later
// A session of the text twin gets bytes, cut where the first of them says: SCPI and JSON lines against a made-up answerer. Whatever
// comes, it answers whole lines, and the queue of errors stays what it is.
#include <stdlib.h>
#include <string.h>

#include "src/service/text/session.h"
#include "unit/proto/fake.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void must(bool holds)
{
    if (!holds) abort();
}

static void host(void *user, orr_host *h)
{
    (void)user;
    *h = (orr_host){1000, 1000, INT64_C(1700000000000000000), INT64_C(1700000037000000000)};
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static uint8_t room[ORR_MSG_LARGEST];
    fake f = {.n_sats = 3};
    const orr_server server = fake_server(&f);
    const orr_vehicle_options live = {.join_s = 0.065, .length_ns = 5000000};
    orr_vehicle *vehicle;
    if (size == 0 || orr_vehicle_open(&live, &vehicle, NULL) != ORR_OK) return 0;
    const orr_streams_options o = {.maker = &server, .host = host, .vehicle = vehicle, .processor = -1};
    orr_streams *streams;
    if (orr_streams_open(&o, &streams, NULL) != ORR_OK) {
        orr_vehicle_close(vehicle);
        return 0;
    }
    const orr_asked asked = {
        .server = &server, .streams = streams, .may = data[0] & 1 ? ORR_MAY_READ : ORR_MAY_ALL, .room = room};
    orr_text_session s;
    char *answer = NULL;
    size_t n = 0;
    const size_t step = data[0] / 2 + 1u;
    FILE *out = open_memstream(&answer, &n);
    if (out != NULL && orr_text_session_open(&s, &asked)) {
        for (size_t at = 1; at < size; at += step)
            orr_text_session_take(&s, (const char *)data + at, size - at < step ? size - at : step, out);
        orr_text_session_take(&s, "\n", 1, out);
        must(s.scpi.n_errors <= ORR_SCPI_QUEUE);
        orr_text_session_close(&s);
    }
    if (out != NULL) fclose(out);
    must(n == 0 || answer[n - 1] == '\n');
    free(answer);
    orr_streams_close(streams);
    orr_vehicle_close(vehicle);
    return 0;
}
