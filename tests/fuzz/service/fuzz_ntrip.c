// SPDX-License-Identifier: GPL-3.0-or-later
// An NTRIP caster's reader gets bytes, a growing part of them each time as a socket brings them: a verdict stands once it is reached, texts end, and
// every answer to what was understood fits its room.
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "src/service/ports/ntrip.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void must(bool holds)
{
    if (!holds) abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const size_t n = size < ORR_NTRIP_REQUEST ? size : ORR_NTRIP_REQUEST, step = n / 16 + 1;
    orr_ntrip_verdict before = ORR_NTRIP_MORE;
    orr_ntrip_request r, whole;
    char *copy = malloc(n + 1); // of its own size, so that reading beyond it is seen
    must(copy != NULL);
    for (size_t k = step; k <= n + step; k += step) {
        const size_t part = k < n ? k : n;
        memcpy(copy, data, part);
        const orr_ntrip_verdict v = orr_ntrip_read(copy, part, &r);
        must(before == ORR_NTRIP_MORE || v == before);
        must(v != ORR_NTRIP_MORE || part < ORR_NTRIP_REQUEST);
        if (before == ORR_NTRIP_WHOLE) must(memcmp(&r, &whole, sizeof r) == 0);
        before = v, whole = r;
        if (v != ORR_NTRIP_WHOLE) continue;
        must(memchr(r.mount, '\0', sizeof r.mount) != NULL && memchr(r.login, '\0', sizeof r.login) != NULL);
        must(r.revision == 1 || r.revision == 2);
        must(!orr_ntrip_login(r.login, "nobody:\x01nothing"));
        for (int answer = ORR_NTRIP_STREAM; answer <= ORR_NTRIP_NO_SOURCES; answer++) {
            char head[ORR_NTRIP_HEAD];
            must(orr_ntrip_head(&r, (orr_ntrip_answer)answer, 1000, head) == strlen(head));
        }
    }
    free(copy);
    return 0;
}
