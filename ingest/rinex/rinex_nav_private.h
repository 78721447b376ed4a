// SPDX-License-Identifier: GPL-3.0-or-later
// The inside of the navigation reader: a record as lines and numbers, and who turns it into what.
#ifndef ORR_INGEST_RINEX_RINEX_NAV_PRIVATE_H
#define ORR_INGEST_RINEX_RINEX_NAV_PRIVATE_H

#include <stdio.h>

#include "core/cursor.h"
#include "ingest/rinex/rinex_labels.h"
#include "ingest/rinex/rinex_nav.h"

#define NAV_MAX_LINES 10 // of a record, its "> EPH" line not counted
#define NAV_MAX_FIELDS (4 * NAV_MAX_LINES)

typedef struct nav_line {
    orr_view text;
    int64_t number;
} nav_line;

// The lines of one record. In RINEX 4 the "> " line is apart.
typedef struct nav_lines {
    nav_line line[NAV_MAX_LINES];
    size_t n;                   // lines that came, may exceed NAV_MAX_LINES
    nav_line tag;               // "> EPH G01 LNAV"; text.p NULL before RINEX 4
    bool cut;                   // the last line ends with the file, without a line end
    const orr_leap_table *leap; // for dates of GLONASS; NULL: built-in
} nav_lines;

// What is wrong with a record, for the one warning it gets.
typedef struct nav_fault {
    int64_t line;
    int column;
    char text[160];
} nav_fault;
// Says what is wrong with a record.
//   Given:    line, column   where, from 1
//             fmt, ...    the sentence, as of printf
//   Returned: f           all of them
//             (value)     false, so that a caller writes `return orr_nav_fault(...)`
bool orr_nav_fault(nav_fault *f, int64_t line, int column, const char *fmt, ...) ORR_PRINTF(4, 5);

// The columns of a version's records.
typedef struct nav_layout {
    int first; // column of the first field of continuation lines: 4 in RINEX 2, 5 later
    int clock; // of the fields on the epoch's line: 23 in RINEX 2, 24 later
} nav_layout;

// The number in a field of 19 columns.
//   Given:    r, line     the record, and the line in it from 0
//             column      of the field's begin, from 1
//   Returned: out         the number; NAN where the field is blank
//             f           what is wrong
//             (value)     false where it is no number, or cut off
bool orr_nav_field(const nav_lines *r, size_t line, int column, double *out, nav_fault *f);

// The scale that a system's records are dated in.
orr_scale orr_nav_scale_of(char system);
// The date of a record.
//   Given:    r, line     the record, and the line in it from 0
//             v2          "yy mm dd hh mm ss.s" in columns 4-22 (RINEX 2), else "yyyy mm dd hh mm ss" in 5-23
//             scale       that it is in
//   Returned: t           the instant
//             f           what is wrong
//             (value)     false where it is no date
bool orr_nav_epoch(const nav_lines *r, size_t line, bool v2, orr_scale scale, orr_time *t, nav_fault *f);
// The instant with `sow_s` seconds of the system's week that is nearest to `near`.
orr_time orr_nav_of_week(double sow_s, char system, orr_time near);

// Nanoseconds since a week of the system began.
int64_t orr_nav_ns_of_week(orr_time t, char system);

// Turns a record into an ephemeris.
//   Given:    r           its lines
//             v2          whether the file is RINEX 2
//             system      of the satellite, where the record does not say it itself
//             message     NONE: found from the system and the record
//   Returned: e           the ephemeris
//             f           what is wrong
//             (value)     false where the record cannot be used
bool orr_nav_take_eph(const nav_lines *r, bool v2, char system, orr_nav_message message, orr_nav_eph *e,
                      nav_fault *f);
// An ionosphere record of RINEX 4; false with a fault where it cannot be used.
bool orr_nav_take_iono(const nav_lines *r, orr_nav_iono *out, nav_fault *f);
// A time offset record of RINEX 4, likewise.
bool orr_nav_take_sto(const nav_lines *r, orr_nav_sto *out, nav_fault *f);
// An Earth orientation record of RINEX 4, likewise.
bool orr_nav_take_eop(const nav_lines *r, orr_nav_eop *out, nav_fault *f);
// The message of a name as RINEX 4 writes it; NONE if there is none.
orr_nav_message orr_nav_message_parse(orr_view name);

// Takes one header line (ionosphere, time corrections, leap seconds and others) into nav.
//   Given:    line        the line
//             name, number   of the file, and of the line in it, for messages
//   Returned: nav         with what the line says
//             w           complaints; may be NULL
//             diag        ORR_E_FORMAT, ORR_E_MEMORY: the file is refused
orr_status orr_nav_header_line(orr_nav *nav, orr_view line, const char *name, int64_t number, orr_warnings *w,
                               orr_diag *diag);
// Whether two records give the same orbit and clock, to the twelve digits that programs write.
bool orr_nav_same_orbit(const orr_nav_eph *a, const orr_nav_eph *b);
// Whether they agree in all else that is used: delays, health, issues, accuracy, channel.
bool orr_nav_same_rest(const orr_nav_eph *a, const orr_nav_eph *b);
// Warns of records of one issue whose orbit or clock differ; eph[n] in the order of orr_nav.eph, name NULL for several
// files.
void orr_nav_tell_conflicts(const orr_nav_eph *eph, size_t n, const char *name, orr_warnings *w);
// ---- writing ----

// A number as D19.12, NAN as blanks.
void orr_nav_put_number(FILE *f, double v);
// Four of them as a continuation line.
//   Given:    f           the file
//             a, b, c, d  the numbers
//   Returned: nothing; the file's error indicator tells of what was not written
void orr_nav_put_line(FILE *f, double a, double b, double c, double d);
// An ephemeris as its lines, without the "> EPH" of RINEX 4.
void orr_nav_put_eph(FILE *f, const orr_leap_table *leap, const orr_nav_eph *e);
// Whether RINEX 3 has records of a message.
bool orr_nav_in_version_3(uint8_t message);
// Writes all records behind the header of RINEX 4; returns how many it has no form for.
size_t orr_nav_put_records4(FILE *f, const orr_nav *nav);

// Appends an element to an array that grows.
//   Given:    array       address of the pointer to the elements
//             n           elements so far
//             size        of one, bytes
//             element     the new one, copied
//   Returned: array, n    one longer
//             diag        ORR_E_MEMORY
orr_status orr_nav_append(void *array, size_t *n, size_t size, const void *element, orr_diag *diag);

#endif
