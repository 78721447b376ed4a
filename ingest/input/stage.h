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

// Reads from a stage, first what was read ahead, and counts the bytes.
//   Given:    s           the stage
//             capacity    bytes that `buf` has room for
//   Returned: buf, got    the next bytes and how many; 0 at the end alone
//             diag        as the stage's own read
orr_status orr_stage_read(orr_stage *s, uint8_t *buf, size_t capacity, size_t *got, orr_diag *diag);
// Looks at up to 8 first bytes, before anything was read.
orr_status orr_stage_peek(orr_stage *s, const uint8_t **bytes, size_t *n, orr_diag *diag);

// Opens a file or pipe; "-" is standard input. *size is what the file system says, at most 256 MiB: a first guess at the room needed, never a promise.
orr_status orr_stage_file(const char *path, orr_stage **out, size_t *size, orr_diag *diag);
// A stage of bytes in memory.
//   Given:    name        of the file, for messages; kept, not copied
//             data, n     n bytes, which must outlive the stage
//   Returned: out         the stage
//             diag        ORR_E_MEMORY
orr_status orr_stage_memory(const char *name, const void *data, size_t n, orr_stage **out, orr_diag *diag);
// Decompresses gzip, any number of members, with their check sums. `below` stays the caller's to close.
// ORR_E_MEMORY here, ORR_E_FORMAT on reading what is damaged or cut.
orr_status orr_stage_gzip(orr_stage *below, orr_stage **out, orr_diag *diag);
// All members of a gzip file at one go, check sums verified.
//   Given:    packed, n_packed   the file in memory
//             limit       most bytes of text
//   Returned: text, n_text   the text, with room for one byte more, to be freed with free()
//             (value)     false where anything is unusual: damage, text beyond the limit, no memory; the stage
//                         above then finds out what it is
bool orr_gzip_whole(const uint8_t *packed, size_t n_packed, size_t limit, char **text, size_t *n_text);
// Decompresses Unix compress (.Z). `below` stays the caller's to close. ORR_E_MEMORY here, ORR_E_FORMAT on reading
// what is damaged.
orr_status orr_stage_lzw(orr_stage *below, orr_stage **out, orr_diag *diag);

#endif
