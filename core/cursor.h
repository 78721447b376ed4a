// SPDX-License-Identifier: GPL-3.0-or-later
// Text as the readers see it: views of bytes that someone else owns, lines of a block in memory, and the
// fields of fixed-column formats. None of it copies or allocates, and none depends on the locale.
// Columns count from 1 as the formats' own descriptions do; a field that reaches over the end of its line
// reads as if padded with blanks.
#ifndef ORR_CORE_CURSOR_H
#define ORR_CORE_CURSOR_H

#include "core/status.h"

// n bytes at p, not NUL-terminated.
typedef struct orr_view {
    const char *p;
    size_t n;
} orr_view;

#define ORR_LINE_MAX ((size_t)65536) // the longest line a reader takes unless it says otherwise

// Walks the lines of a block. A line ends at LF, CR LF or the end of the block; the ends are not part of it.
typedef struct orr_cursor {
    const char *name; // of the file, for messages
    const char *at, *end;
    int64_t line;      // number of the line returned last, from 1; 0 before the first
    size_t max_line;   // longer lines stop the walk
    bool unterminated; // the line returned last ended with the block, without LF
    bool too_long;     // the walk stopped at a line over max_line
} orr_cursor;

// Starts before the first line of text[n], with max_line = ORR_LINE_MAX. `name` is kept, not copied.
void orr_cursor_init(orr_cursor *c, const char *name, const char *text, size_t n);
// The next line; false at the end and where a line is too long. Ask orr_cursor_status which of them it was.
bool orr_cursor_next(orr_cursor *c, orr_view *line);
// ORR_OK, or ORR_E_LIMIT with a sentence when the walk stopped at a line that is too long.
orr_status orr_cursor_status(const orr_cursor *c, orr_diag *diag);
// An error at the line returned last.
//   Given:    c          the walk; its file name and line number go into the diagnostic
//             s          class of the failure
//             column     from 1; 0 where none is to blame
//             fmt, ...   the sentence, as of printf
//   Returned: diag       class, place and sentence; may be NULL
//             (value)    s
orr_status orr_cursor_error(const orr_cursor *c, orr_diag *diag, orr_status s, int column, const char *fmt,
                            ...) ORR_PRINTF(5, 6);
// A warning about the line returned last.
//   Given:    c          the walk; its file name and line number go into the warning
//             column     from 1; 0 where none is to blame
//             fmt, ...   the sentence, as of printf
//   Returned: w          with the warning counted and, if there is room, kept; may be NULL
void orr_cursor_warn(const orr_cursor *c, orr_warnings *w, int column, const char *fmt, ...) ORR_PRINTF(4, 5);

// Views. Blanks are space and tab.
orr_view orr_view_of(const char *nul_terminated);
// Columns col .. col + width - 1, clipped to the line.
orr_view orr_view_cols(orr_view line, int col, int width);
// Without trailing blanks.
orr_view orr_view_rtrim(orr_view v);
// Without leading and trailing blanks.
orr_view orr_view_trim(orr_view v);
// Empty or blanks alone.
bool orr_view_is_blank(orr_view v);
// Whether v is s, byte for byte (case matters).
bool orr_view_equals(orr_view v, const char *s);
// Whether v begins with s.
bool orr_view_starts(orr_view v, const char *s);
// Whether s stands somewhere in v.
bool orr_view_contains(orr_view v, const char *s);
// The character in a column; a blank for a tab and past the end.
static inline char orr_view_char(orr_view line, int col)
{
    char c = (size_t)col <= line.n ? line.p[col - 1] : ' ';
    return c == '\t' ? ' ' : c;
}
// Copies into buf of n bytes, NUL-terminated, cut if need be; control characters become '?', so that a file
// cannot talk to a terminal. Returns buf.
char *orr_view_copy(orr_view v, char *buf, size_t n);
// The same into fresh memory (free with free()); NULL when there is none.
char *orr_view_dup(orr_view v);
// Cuts the next blank-separated word off *rest; false when only blanks are left.
bool orr_view_word(orr_view *rest, orr_view *word);
// Cuts the text before the next `separator` off *rest (all of it when there is none); false when nothing is
// left, that is after the text behind the last separator was given. Start with rest->p not NULL.
bool orr_view_split(orr_view *rest, char separator, orr_view *part);

// What a numeric field held. On BLANK and BAD the output is untouched.
typedef enum orr_field { ORR_FIELD_OK, ORR_FIELD_BLANK, ORR_FIELD_BAD } orr_field;

// The number in columns col .. col + width - 1. Blanks (tabs too) may stand on both sides, not inside, except
// as the sign of an exponent ("1.5D 02"). Exponent letters are D, d, E, e; Fortran drops the letter before three digits
// ("0.5-269"). The result is correctly rounded.
// Fortran's asterisks, "nan", "inf" and numbers past the range of double are BAD. Fields over 128 characters
// are BAD.
orr_field orr_field_real(orr_view line, int col, int width, double *out);
// An integer: optional sign and digits; BAD past int64.
orr_field orr_field_int(orr_view line, int col, int width, int64_t *out);
// An integer within a range, for fields that are used as counts or indices.
//   Given:    line, col, width   the field: columns col .. col + width - 1 of the line
//             lo, hi             the range, both ends included
//   Returned: out                the number; untouched unless the field is OK
//             (value)            BLANK, BAD (no integer, or outside the range) or OK
orr_field orr_field_int_in(orr_view line, int col, int width, int lo, int hi, int *out);
// The number that a whole view holds, by the rules of orr_field_real: for words.
orr_field orr_view_real(orr_view v, double *out);
// number * 10^power, rounded once: for fields in other units than ours (1e-6 s, km).
orr_field orr_view_real_e(orr_view v, int power, double *out);
// An integer as of orr_field_int.
orr_field orr_view_int(orr_view v, int64_t *out);

#endif
