// SPDX-License-Identifier: GPL-3.0-or-later
// The inside of the navigation reader: a record as lines and numbers, and who turns it into what.
#ifndef ORR_INGEST_RINEX_RINEX_NAV_PRIVATE_H
#define ORR_INGEST_RINEX_RINEX_NAV_PRIVATE_H

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
    size_t n;     // lines that came, may exceed NAV_MAX_LINES
    nav_line tag; // "> EPH G01 LNAV"; text.p NULL before RINEX 4
    bool cut;     // the last line ends with the file, without a line end
} nav_lines;

// What is wrong with a record, for the one warning it gets.
typedef struct nav_fault {
    int64_t line;
    int column;
    char text[160];
} nav_fault;
bool orr_nav_fault(nav_fault *f, int64_t line, int column, const char *fmt, ...)
    ORR_PRINTF(4, 5); // returns false

// The columns of a version's records.
typedef struct nav_layout {
    int first; // column of the first field of continuation lines: 4 in RINEX 2, 5 later
    int clock; // of the fields on the epoch's line: 23 in RINEX 2, 24 later
} nav_layout;

// Number k of a line (0-based) in its column; blank is NAN. False with a fault where it is bad or cut off.
bool orr_nav_field(const nav_lines *r, size_t line, int column, double *out, nav_fault *f);

// The scale that a system's records are dated in.
orr_scale orr_nav_scale_of(char system);
// "yyyy mm dd hh mm ss" in columns 5-23 (RINEX 3, 4) or "yy mm dd hh mm ss.s" in 4-22 (RINEX 2).
bool orr_nav_epoch(const nav_lines *r, size_t line, bool v2, orr_scale scale, orr_time *t, nav_fault *f);
// The instant with `sow_s` seconds of the system's week that is nearest to `near`.
orr_time orr_nav_of_week(double sow_s, char system, orr_time near);

// Nanoseconds since a week of the system began.
int64_t orr_nav_ns_of_week(orr_time t, char system);

// One ephemeris; message NONE: find it from the system. Warnings take what does not spoil the record.
bool orr_nav_take_eph(const nav_lines *r, bool v2, char system, orr_nav_message message, orr_nav_eph *e,
                      nav_fault *f);
// Records of RINEX 4.
bool orr_nav_take_iono(const nav_lines *r, orr_nav_iono *out, nav_fault *f);
bool orr_nav_take_sto(const nav_lines *r, orr_nav_sto *out, nav_fault *f);
bool orr_nav_take_eop(const nav_lines *r, orr_nav_eop *out, nav_fault *f);
orr_nav_message orr_nav_message_parse(orr_view name);

// Header lines (iono, time corrections, leap seconds) into nav; appends.
orr_status orr_nav_header_line(orr_nav *nav, orr_view line, const char *name, int64_t number, orr_warnings *w,
                               orr_diag *diag);
// Appends an element of `size` bytes to *array of *n (capacity doubles). ORR_E_MEMORY.
orr_status orr_nav_append(void *array, size_t *n, size_t size, const void *element, orr_diag *diag);

#endif
