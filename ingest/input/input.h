// SPDX-License-Identifier: GPL-3.0-or-later
// Opens a file by what is in it, never by its name: plain, gzip (any number of members), Unix compress (.Z),
// one inside the other. Two faces: the whole text in memory (most formats are small), or a stream of lines
// (observation files). A web page saved under a data file's name, a zip archive and other things that are no
// text are refused by their name.
#ifndef ORR_INGEST_INPUT_INPUT_H
#define ORR_INGEST_INPUT_INPUT_H

#include "core/cursor.h"
#include "core/status.h"

// Compressed input is a number we did not check: these say how much of it we follow.
typedef struct orr_input_limits {
    size_t max_bytes; // after decompression
    size_t max_line;  // of orr_input_line
    size_t max_ratio; // expansion, once more than ratio_grace bytes came out
    size_t ratio_grace;
    uint64_t
        kinds; // that the text may be of (ORR_KIND_BIT): what is read whole and is of none of them is refused by its
    // first lines once ORR_INPUT_JUDGED bytes came, be it an endless pipe; shorter ones are left to their
    // readers. 0: any
} orr_input_limits;
#define ORR_INPUT_JUDGED ((size_t)1 << 20)
orr_input_limits orr_input_default_limits(void); // 2 GiB, ORR_LINE_MAX, 300, 64 MiB, any kind

// A text in memory. text[n] is a NUL that does not count, so text is never NULL.
typedef struct orr_bytes {
    char *text;
    size_t n;
} orr_bytes;
// Reads a whole file, decompressed. limits may be NULL. Errors: ORR_E_IO, ORR_E_KIND (empty, a directory, a web
// page, an archive), ORR_E_FORMAT (damaged or cut compressed data), ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_input_read_all(const char *path, const orr_input_limits *limits, orr_bytes *out,
                              orr_diag *diag);
// The same for bytes in memory.
//   Given:    name        of the file, for messages
//             data, n     its n bytes, which may be compressed
//             limits      NULL: the defaults
//   Returned: out         the text, to be freed with orr_bytes_free
//             diag        as of orr_input_read_all, but for ORR_E_IO
orr_status orr_input_read_bytes(const char *name, const void *data, size_t n, const orr_input_limits *limits,
                                orr_bytes *out, orr_diag *diag);
// Frees the text and leaves *b empty.
void orr_bytes_free(orr_bytes *b);
// The bytes as they are, compressed or not, of a file or a pipe; text[n] is a NUL that does not count. Of the limits (may
// be NULL) max_bytes, here before decompression, and kinds count. ORR_E_IO, ORR_E_KIND (a folder, another kind),
// ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_input_read_raw(const char *path, const orr_input_limits *limits, orr_bytes *out,
                              orr_diag *diag);

// The stream face: memory use does not grow with the file.
typedef struct orr_input orr_input;
// Opens a file for reading line by line; close it with orr_input_close. limits may be NULL. Errors as of
// orr_input_read_all; damage further on is told by orr_input_status.
orr_status orr_input_open(const char *path, const orr_input_limits *limits, orr_input **out, orr_diag *diag);
// The same from memory.
//   Given:    name        of the file, for messages
//             data, n     its n bytes, which may be compressed and must outlive the input
//             limits      NULL: the defaults
//   Returned: out         the input, to be closed with orr_input_close
//             diag        as of orr_input_open, but for ORR_E_IO
orr_status orr_input_open_bytes(const char *name, const void *data, size_t n, const orr_input_limits *limits,
                                orr_input **out, orr_diag *diag);
void orr_input_close(orr_input *in);                // NULL is allowed
const char *orr_input_name(const orr_input *in);    // for messages
int64_t orr_input_line_number(const orr_input *in); // of the line returned last, from 1

// The first bytes of the text (up to 64 KiB, as many as there are), without consuming them: for orr_sniff.
// Valid until the next call. Only before the first line is read.
orr_view orr_input_head(orr_input *in);
// The next line, without its end; valid until the next call. False at the end and on failure: ask
// orr_input_status.
bool orr_input_line(orr_input *in, orr_view *line);
// Puts the line returned last back: the next call returns it again.
void orr_input_unline(orr_input *in);
// ORR_OK while all is well (so also at the true end), else what happened, again and again.
orr_status orr_input_status(const orr_input *in, orr_diag *diag);

#endif
