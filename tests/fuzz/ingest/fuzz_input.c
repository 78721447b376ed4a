// SPDX-License-Identifier: GPL-3.0-or-later
// Anything as a file: both faces of the input must agree on what is in it, or both refuse.
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "ingest/input/input.h"
#include "ingest/input/sniff.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    orr_input_limits limits = {
        .max_bytes = 1 << 22, .max_line = 1 << 16, .max_ratio = 300, .ratio_grace = 1 << 20};
    orr_bytes whole;
    orr_diag diag = {0};
    orr_status read = orr_input_read_bytes("fuzz", data, n, &limits, &whole, &diag);
    if (read == ORR_OK) (void)orr_sniff((orr_view){whole.text, whole.n});

    orr_input *in = NULL;
    orr_status st = orr_input_open_bytes("fuzz", data, n, &limits, &in, &diag);
    size_t at = 0;
    if (st == ORR_OK) {
        orr_view line;
        (void)orr_sniff(orr_input_head(in));
        while (orr_input_line(in, &line)) {
            if (orr_input_line_number(in) % 5 == 0) {
                orr_input_unline(in);
                if (!orr_input_line(in, &line)) abort();
            }
            if (read != ORR_OK) continue;
            if (line.n > whole.n - at || memcmp(line.p, whole.text + at, line.n) != 0) abort();
            at += line.n;
            if (at < whole.n && whole.text[at] == '\r') at++;
            if (at < whole.n && whole.text[at] == '\n') at++;
        }
        st = orr_input_status(in, &diag);
        orr_input_close(in);
    }
    if (read == ORR_OK && st == ORR_OK && at != whole.n) abort();
    if (read == ORR_OK && st != ORR_OK && st != ORR_E_LIMIT)
        abort(); // a line may be too long for the stream alone
    if (read != ORR_OK && st == ORR_OK) abort();
    if (read == ORR_OK) orr_bytes_free(&whole);
    return 0;
}
