// SPDX-License-Identifier: GPL-3.0-or-later
// What the smaller readers share: arrays that grow under a limit, dates as these formats write them, header
// labels. Private to the ingest room.
#ifndef ORR_INGEST_INPUT_TEXT_RECORDS_H
#define ORR_INGEST_INPUT_TEXT_RECORDS_H

#include "core/cursor.h"
#include "core/time.h"
#include "ingest/input/input.h"
#include "ingest/input/limits.h"

// Makes room for one more element of an array (core/array.h) under a limit.
//   Given:    array         address of the pointer to the elements
//             n             elements so far
//             element_size  of one, bytes
//             limit, what   the most elements, and their name in the plural for messages
//             at            the line that they come from, for messages
//   Returned: diag          ORR_E_LIMIT or ORR_E_MEMORY at that line
orr_status orr_records_grow(void *array, size_t n, size_t element_size, size_t limit, const char *what,
                            const orr_cursor *at, orr_diag *diag);

// Reads a file whole.
//   Given:    path          of the file
//             limits        max_bytes of them; NULL: the defaults
//             kinds         that it may be of, as of orr_input_limits
//   Returned: out           the text; free with orr_bytes_free
//             diag          as of orr_input_read_all
orr_status orr_records_load(const char *path, const orr_read_limits *limits, uint64_t kinds, orr_bytes *out,
                            orr_diag *diag);

// One policy for lines that no record can be made of, in all readers: each is told and left out, and the file stands
// unless more was left out than read.
typedef struct orr_records_tally {
    size_t good, left_out;
    orr_diag first; // the first that was left out
} orr_records_tally;
// Leaves out the line returned last.
//   Given:    at          the walk, for the place
//             column      from 1; 0 where none is to blame
//             why         what is wrong with the line
//   Returned: tally       with the line counted
//             warnings    with a warning; may be NULL
void orr_records_leave_out(orr_records_tally *tally, const orr_cursor *at, int column, const char *why,
                           orr_warnings *warnings);
// After the last line: ORR_E_FORMAT, with the place of the first, where more was left out than read.
orr_status orr_records_verdict(const orr_records_tally *tally, orr_diag *diag);

// The label of a RINEX-like header line, columns 61-80, trimmed.
orr_view orr_records_label(orr_view line);
// Compares a label with its name, blind to case, to underscores for blanks and to repeated blanks.
bool orr_records_label_is(orr_view label, const char *name);

// "YYYY:DDD:SSSSS" or "YY:DDD:SSSSS" of the SINEX family. All zeros (or blank) is "open": ORR_TIME_NONE.
// False if it is no date. Two-digit years up to 50 are of this century, as SINEX says.
bool orr_records_sinex_time(orr_view v, orr_scale scale, const orr_leap_table *leap, orr_time *out);
// Six blank-separated numbers, year month day hour minute second(.fraction); 24:00:00 is the next day. Fewer
// than six are refused. False if it is no date.
bool orr_records_civil(orr_view v, orr_scale scale, const orr_leap_table *leap, orr_time *out);
// The same from six fields of one width, side by side (IONEX 6I6).
//   Given:    line        the line
//             col, width  column of the first field, and width of each
//             scale, leap   that the date is in, and the table of leap seconds (NULL: built-in)
//   Returned: out         the instant
//             (value)     false if it is no date
bool orr_records_civil_columns(orr_view line, int col, int width, orr_scale scale, const orr_leap_table *leap,
                               orr_time *out);

// Appends a copy of a text, without trailing blanks, to a list of texts.
//   Given:    list, n     the list, which grows, and its length
//             v           the text
//             limit       the most texts
//             at          the line that it comes from, for messages
//   Returned: list, n     one longer
//             diag        ORR_E_LIMIT or ORR_E_MEMORY at that line
orr_status orr_records_add_text(char ***list, size_t *n, orr_view v, size_t limit, const orr_cursor *at,
                                orr_diag *diag);
// Frees a list of n texts and the texts.
void orr_records_free_texts(char **list, size_t n);

// The most frequent step of ascending instants, seconds; of equally frequent ones the shortest. NAN for fewer
// than two. `scratch` has room for n.
double orr_records_usual_step_s(const orr_time *t, size_t n, int64_t *scratch);

// "program", "run by", "date" of a RINEX-like "PGM / RUN BY / DATE" line (20 characters each).
void orr_records_program_line(orr_view line, char program[21], char run_by[21], char date[21]);

#endif
