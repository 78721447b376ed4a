// SPDX-License-Identifier: GPL-3.0-or-later
// The SP3 reader's state, shared by its header, record and finishing parts. Private to the ingest room.
#ifndef ORR_INGEST_SP3_SP3_PRIVATE_H
#define ORR_INGEST_SP3_SP3_PRIVATE_H

#include "core/cursor.h"
#include "ingest/sp3/sp3.h"

// Faults that are counted and told once, with the place of the first.
typedef enum sp3_fault {
    SP3_UNLISTED,     // record of a satellite that the header does not list
    SP3_BLANK_SYSTEM, // satellite without letter in version c or d
    SP3_DUPLICATE,    // second record of a satellite in an epoch
    SP3_STRAY_EP,     // EP or EV that follows no P or V
    SP3_ODD_FLAG,     // a letter that is no flag in columns 75-80
    SP3_ODD_SDEV,     // unreadable standard deviation or correlation
    SP3_NO_BASE,      // exponents, but no base in the header
    SP3_IMPLAUSIBLE,  // a position inside the Earth or beyond the Moon
    SP3_TAIL,         // text beyond column 80
    SP3_JUNK,         // line without a letter or digit: dots, blanks
    SP3_STRAY_RECORD, // record after a line that cannot be read, before the next epoch
    SP3_UNKNOWN_SAT,  // a satellite of a system that has no letter here
    SP3_BETWEEN,      // something between the fields of columns 61-80, or of EP and EV
    SP3_FREE,         // numbers not in the columns of F14.6, in a file that begins so
    SP3_MINUTE_60,    // 16:60 for 17:00
    SP3_DAY_0,        // day 0 of a month: the last of the one before
    SP3_SHIFTED,      // an epoch line a column off
    SP3_N_FAULTS
} sp3_fault;

typedef struct sp3_parser {
    orr_cursor c;
    orr_sp3_limits limits;
    orr_sp3 *out;
    orr_warnings *warnings;
    orr_diag *diag;

    // The header's own words.
    int64_t header_epochs, header_sats; // -1 if not told
    orr_time header_start;              // ORR_TIME_NONE if not told
    int64_t header_start_line, header_week_line, header_sats_line;
    double header_week, header_sow; // NAN if not told
    bool header_says_velocity, has_time_system, has_bases;
    orr_civil start;
    size_t n_listed, n_accuracies; // places in the + and ++ lists
    int16_t *listed;               // satellite index of each place of the + list

    size_t stride, epoch_capacity, sat_capacity; // cells are [epoch * stride + satellite]
    int16_t index[ORR_N_SYSTEMS][100];           // satellite index, -1 for none
    float pos_sdev[100], clock_sdev[1000];       // of the exponents, in mm and ps

    // Where we are.
    orr_sp3_record *row; // of the epoch now, NULL before the first and after a line that cannot be read
    ptrdiff_t last_sat;  // of the record before, for EP and EV; -1 for none
    bool last_is_velocity, seen_velocity;
    bool ended;                 // EOF was seen
    bool has_style, in_columns; // of the first record: its numbers stand as F14.6 has them
    int epoch_shift;            // of the first epoch line: columns that all its fields stand too far right
    size_t n_good, n_bad;       // records
    orr_diag first_bad;
    size_t fault_count[SP3_N_FAULTS];
    int64_t fault_line[SP3_N_FAULTS];
} sp3_parser;

enum { SP3_SEEN_P = 1 << 7, SP3_SEEN_V = 1 << 6 }; // orr_sp3_record.flags while reading

// sp3.c: the file from the first line to the last. Below it, in this order: the records, the header, the cells.
orr_status sp3_parse_header(sp3_parser *p, orr_view *first_epoch_line);
orr_status sp3_read_comment(sp3_parser *p, orr_view line);
orr_status sp3_parse_body(sp3_parser *p, orr_view first_epoch_line);
orr_status sp3_finish(sp3_parser *p);

// Counts a fault, with the line of the first.
void sp3_fault_note(sp3_parser *p, sp3_fault f);
// Lays the rows out with another distance, which the cells beyond the old one find empty.
orr_status sp3_set_stride(sp3_parser *p, size_t stride);
// Index of a satellite, added if it is new; -1 with a diagnostic in p->diag when that is refused.
int sp3_sat_index(sp3_parser *p, orr_sat sat, orr_status *st);
// A fresh row of missing records for an epoch.
orr_status sp3_add_epoch(sp3_parser *p, orr_time t);
orr_status sp3_add_correlations(sp3_parser *p);
// The date of a line: year, month, day, hour, minute in columns 4-7, 9-10, ... and seconds in 21-31, as lines 1 and *
// have them.
//   Given:    line     the line
//             shift    how many columns further right the fields stand, -1 to 1
//             day0     whether day 0 is allowed
//   Returned: out      the date; the minute may be 60
//             column   where it cannot be read
//             (value)  false then
bool sp3_read_civil(orr_view line, int shift, bool day0, orr_civil *out, int *column);
// A letter and two digits, whatever system the letter may stand for.
bool sp3_is_sat_like(const char three[3]);
void sp3_clear_records(orr_sp3_record *r, size_t n);

#endif
