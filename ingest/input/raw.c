// SPDX-License-Identifier: GPL-3.0-or-later
// A file's bytes as they stand on disk or come out of a pipe.
#include <stdlib.h>

#include "ingest/input/input.h"
#include "ingest/input/sniff.h"
#include "ingest/input/stage.h"

// Whether what came so far is of a kind that is wanted.
static orr_status judge(const char *path, const orr_bytes *b, uint64_t kinds, orr_diag *diag)
{
    orr_input *in;
    orr_status s = orr_input_open_bytes(path, b->text, b->n, NULL, &in, diag);
    if (s != ORR_OK) return s;
    s = orr_sniff_expect(path, orr_input_head(in), kinds, diag);
    orr_input_close(in);
    return s;
}

orr_status orr_input_read_raw(const char *path, const orr_input_limits *limits, orr_bytes *out,
                              orr_diag *diag)
{
    const orr_input_limits l = limits != NULL ? *limits : orr_input_default_limits();
    bool judged = l.kinds == 0;
    *out = (orr_bytes){0};
    orr_stage *file = NULL;
    size_t hint = 0;
    orr_status s = orr_stage_file(path, &file, &hint, diag);
    if (s != ORR_OK) return s;
    size_t room = hint + 65536, got = 1;
    orr_bytes b = {.text = malloc(room)};
    if (b.text == NULL) s = orr_diag_set(diag, ORR_E_MEMORY, "no memory to read %s", path);
    while (s == ORR_OK && got > 0) {
        if (room - b.n < 2) {
            char *grown = realloc(b.text, 2 * room);
            if (grown == NULL) {
                s = orr_diag_set(diag, ORR_E_MEMORY, "no memory to read %s", path);
                break;
            }
            b.text = grown;
            room *= 2;
        }
        s = orr_stage_read(file, (uint8_t *)b.text + b.n, room - b.n - 1, &got, diag);
        b.n += got;
        if (s == ORR_OK && b.n > l.max_bytes)
            s = orr_diag_at(diag, ORR_E_LIMIT, path, 0, 0, "the file is longer than %zu bytes, the limit",
                            l.max_bytes);
        if (s == ORR_OK && !judged && b.n > ORR_INPUT_JUDGED) {
            s = judge(path, &b, l.kinds, diag);
            judged = true;
        }
    }
    file->close(file);
    if (s != ORR_OK) {
        free(b.text);
        return s;
    }
    b.text[b.n] = '\0';
    *out = b;
    return ORR_OK;
}
