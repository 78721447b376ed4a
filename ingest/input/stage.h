// SPDX-License-Identifier: GPL-3.0-or-later
// How input is layered: each stage gives bytes, drawn from the stage below it. Private to the ingest room.
#ifndef ORR_INGEST_INPUT_STAGE_H
#define ORR_INGEST_INPUT_STAGE_H

#include "core/status.h"

typedef struct orr_stage orr_stage;
struct orr_stage {
    // Fills buf with up to capacity bytes; *got is 0 at the end alone. After an error it is not called again.
    orr_status (*read)(orr_stage *self, uint8_t *buf, size_t capacity, size_t *got, orr_diag *diag);
    void (*close)(orr_stage *self); // frees self, not the stage below
    const char *name;               // of the file, for messages
    orr_stage *below;
    // Bytes read ahead to look at: [ahead_from, ahead_to) come before what read() gives.
    uint8_t ahead[8];
    size_t ahead_from, ahead_to;
    uint64_t total; // bytes handed out
};

// Through the bytes read ahead; counts.
orr_status orr_stage_read(orr_stage *s, uint8_t *buf, size_t capacity, size_t *got, orr_diag *diag);
// Looks at up to 8 first bytes, before anything was read.
orr_status orr_stage_peek(orr_stage *s, const uint8_t **bytes, size_t *n, orr_diag *diag);

// *size is what the file system says, at most 256 MiB: a first guess at the room needed, never a promise.
orr_status orr_stage_file(const char *path, orr_stage **out, size_t *size, orr_diag *diag);
orr_status orr_stage_memory(const char *name, const void *data, size_t n, orr_stage **out, orr_diag *diag);
orr_status orr_stage_gzip(orr_stage *below, orr_stage **out, orr_diag *diag);
// All members of a gzip file in memory, check sums verified, into *text (n_text bytes and room for one more;
// free()). False where anything is unusual: damage, text beyond `limit` bytes, no memory. The stage above
// then finds out what it is.
bool orr_gzip_whole(const uint8_t *packed, size_t n_packed, size_t limit, char **text, size_t *n_text);
orr_status orr_stage_lzw(orr_stage *below, orr_stage **out, orr_diag *diag);

#endif
