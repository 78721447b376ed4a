// SPDX-License-Identifier: GPL-3.0-or-later
// What the RINEX readers share: header labels, the first line, calendar fields. Private to the ingest room.
#ifndef ORR_INGEST_RINEX_RINEX_LABELS_H
#define ORR_INGEST_RINEX_RINEX_LABELS_H

#include "core/cursor.h"
#include "core/time.h"

// The label of a header line: columns 61-80 without trailing blanks.
orr_view orr_rinex_label(orr_view line);

typedef struct orr_rinex_first {
    double version;
    char type;   // 'O', 'N', 'G' (GLONASS nav of 2.x), 'H' (GEO nav of 2.x), as the file has it, upper case
    char system; // column 41, upper case; blank where it is blank
} orr_rinex_first;
// Reads "RINEX VERSION / TYPE". ORR_E_KIND with a sentence if it is none.
orr_status orr_rinex_first_line(const char *name, orr_view line, orr_rinex_first *out, orr_diag *diag);

// Warns of a version that nobody has published; it is read as the last before it.
void orr_rinex_check_version(const char *name, double version, orr_warnings *warnings);
// Warns of a header line with text behind column 80, which is not read; once a file.
//   Given:    name          of the file
//             line_number   from 1
//             line          the line
//             told          whether that has been told
//   Returned: told          true once it has
//             warnings      may be NULL
void orr_rinex_check_width(const char *name, int64_t line_number, orr_view line, bool *told,
                           orr_warnings *warnings);

// A date and time in fields of fixed columns: year (two digits: 80-99 are 1980-1999, 00-79 are 2000-2079),
// month, day, hour, minute and seconds as picoseconds of the minute. Seconds 60.0 are the next minute, or the
// leap second where the scale has one.
typedef struct orr_rinex_date {
    int year, month, day, hour, minute;
    int64_t second_ps;
} orr_rinex_date;
// The instant of such a date. ORR_E_ARG or ORR_E_RANGE, without a message, if it is none.
orr_status orr_rinex_time(const orr_rinex_date *d, orr_scale scale, const orr_leap_table *leap,
                          orr_time *out);
// Seconds of a field as picoseconds; false if it is no number in [0, 61).
bool orr_rinex_seconds(orr_view line, int col, int width, int64_t *ps);

#endif
