// SPDX-License-Identifier: GPL-3.0-or-later
// How a routine says that it could not do its work: a class (orr_status) for the program and a
// sentence (orr_diag) for the person. Every fallible routine returns the first and fills the second.
#ifndef ORR_CORE_STATUS_H
#define ORR_CORE_STATUS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define ORR_PRINTF(fmt, args) __attribute__((format(printf, fmt, args)))
#define ORR_NODISCARD __attribute__((warn_unused_result))
#else
#define ORR_PRINTF(fmt, args)
#define ORR_NODISCARD
#endif

typedef enum orr_status {
    ORR_OK = 0,
    ORR_E_ARG,     // an argument outside its documented domain
    ORR_E_IO,      // open, read, write, rename, socket
    ORR_E_KIND,    // readable, but not the kind of file (or message) that was expected
    ORR_E_FORMAT,  // the right kind, but bytes that its format does not allow
    ORR_E_LIMIT,   // an explicit limit was passed (satellites, epochs, line length, expansion)
    ORR_E_RANGE,   // an instant or place outside what the data cover
    ORR_E_NODATA,  // covered, but there is no value (no such satellite, no valid arc)
    ORR_E_NUMERIC, // singular, or no convergence
    ORR_E_MEMORY,
    ORR_E_UNSUPPORTED, // understood and not offered
    ORR_E_INTERRUPTED, // the user asked to stop
} orr_status;

// A short name, e.g. "format error"; never NULL.
const char *orr_status_name(orr_status s);

// What went wrong, where. Zero-initialise; `file` is empty and `line` 0 where they make no sense.
typedef struct orr_diag {
    orr_status status;
    char file[256];
    int64_t line;   // from 1
    int column;     // from 1, in bytes
    char text[512]; // a sentence a user can act on, without a final newline
} orr_diag;

// The class and the sentence, without a place in a file. Too long a sentence is cut with "...".
//   Given:    s          class of the failure
//             fmt, ...   the sentence, as of printf
//   Returned: d          class and sentence, without a place; may be NULL
//             (value)    s, so that a caller writes `return orr_diag_set(diag, ORR_E_ARG, "...")`
orr_status orr_diag_set(orr_diag *d, orr_status s, const char *fmt, ...) ORR_PRINTF(3, 4);
// The class and the sentence, with the place in a file.
//   Given:    s          class of the failure
//             file       its name; of one that is too long the end is kept. NULL: none
//             line, column   from 1; 0 leaves them out
//             fmt, ...   the sentence, as of printf
//   Returned: d          class, place and sentence; may be NULL
//             (value)    s
orr_status orr_diag_at(orr_diag *d, orr_status s, const char *file, int64_t line, int column, const char *fmt,
                       ...) ORR_PRINTF(6, 7);

// Writes "file:line:column: sentence" (parts that are missing are left out) into buf of n bytes,
// NUL-terminated, cut if need be. Returns buf.
char *orr_diag_format(const orr_diag *d, char *buf, size_t n);

// Complaints that did not stop the work. The first ORR_WARNINGS_KEPT are kept, all are counted.
#define ORR_WARNINGS_KEPT 64
typedef struct orr_warnings {
    size_t count;   // how many were raised
    size_t kept;    // how many are in item[]
    orr_diag *item; // grown on demand; freed by orr_warnings_free
} orr_warnings;

// Counts a warning, and keeps it if there is room.
//   Given:    file       the file to blame; NULL: none
//             line, column   from 1; 0 leaves them out
//             fmt, ...   the sentence, as of printf
//   Returned: w          with the warning; may be NULL
void orr_warnings_add(orr_warnings *w, const char *file, int64_t line, int column, const char *fmt, ...)
    ORR_PRINTF(5, 6);
// Frees the items and leaves the list empty.
void orr_warnings_free(orr_warnings *w);

#endif
