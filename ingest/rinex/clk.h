// SPDX-License-Identifier: GPL-3.0-or-later
// RINEX clock files, versions 2.00 to 3.04 (Ray and Gurtner 2010, "RINEX Extensions to Handle Clock
// Information"; Coleman 2017 for 3.04): satellite and receiver clocks, 5-min to 5-s. Records are read by
// fields, not columns, because 3.04 moved them.
#ifndef ORR_INGEST_RINEX_CLK_H
#define ORR_INGEST_RINEX_CLK_H

#include "core/sat.h"
#include "core/status.h"
#include "core/time.h"
#include "ingest/input/limits.h"

// Values as the product gives them: the periodic relativity of satellites is NOT in them (IGS convention).
// NAN: not told.
typedef struct orr_clk_record {
    orr_time t;
    double bias_s, bias_sdev_s;
    double rate_sps, rate_sdev_sps; // s/s
} orr_clk_record;

typedef struct orr_clk_series {
    orr_sat sat;   // ORR_SAT_NONE for a receiver
    char name[12]; // "G05", "BOR1", "BOR100POL"
    size_t n;
    orr_clk_record *record; // strictly ascending in t
} orr_clk_series;

typedef struct orr_clk {
    double version;
    char system;                // file's, 'M' for mixed, ' ' if not told
    orr_scale scale;            // of the file's labels; record times are GPS scale whatever it is
    const orr_leap_table *leap; // of labels in UTC and GLONASS time; borrowed; NULL: built-in
    int leap_seconds;           // -1 if not told
    char program[21], run_by[21], date[21], agency[61],
        reference[61]; // reference clock or its name; empty if not told
    size_t n_sats, n_receivers;
    orr_clk_series *sat;      // ascending in sat
    orr_clk_series *receiver; // in order of appearance
    orr_time from, to;        // of all records; ORR_TIME_NONE where there are none
    // Most frequent step of satellite clocks (of receivers without satellites); NAN if none
    double interval_s;
    size_t n_epochs;
    orr_time *epoch; // distinct instants of satellite clocks (of receivers without satellites), ascending
    size_t n_other;  // records of other types (CR, DR, MS), counted and passed over
} orr_clk;

// Reads a whole file in memory. Of two records of one clock at one instant the first is kept, with a warning; unordered ones
// are sorted, with one.
//   Given:    name        of the file, for messages
//             text, n     its n bytes, decompressed
//             limits      what is refused; NULL: the defaults
//   Returned: out         the clocks, to be freed with orr_clk_free; empty on failure
//             warnings    complaints that did not stop the reading; may be NULL
//             diag        ORR_E_KIND, ORR_E_FORMAT, ORR_E_LIMIT, ORR_E_MEMORY
orr_status orr_clk_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                         orr_clk *out, orr_warnings *warnings, orr_diag *diag);
void orr_clk_free(orr_clk *x); // leaves *x empty
// Writes the satellites' clocks as RINEX 3.00 (the layout that every reader knows), "-" is stdout. Of x are used: system, scale,
// program, run_by, date, agency, sat, epoch; standard deviations above zero are written beside the clocks. Errors: ORR_E_IO.
orr_status orr_clk_write(const orr_clk *x, const char *path, orr_diag *diag);
const orr_clk_series *orr_clk_find(const orr_clk *x, orr_sat sat); // NULL if none

#endif
