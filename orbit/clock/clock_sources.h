// SPDX-License-Identifier: GPL-3.0-or-later
// Clocks of several files made one: a stretch of a satellite's clock comes from one file alone, never from two
// in turn, and files that refer their clocks to different reference clocks are aligned by the medians over the
// satellites of a system, epoch by epoch.
#ifndef ORR_ORBIT_CLOCK_CLOCK_SOURCES_H
#define ORR_ORBIT_CLOCK_CLOCK_SOURCES_H

#include "core/status.h"
#include "orbit/clock/clock_node.h"

// The clocks of many satellites.
typedef struct orr_clock_table {
    size_t n;
    orr_clock_list *list; // ascending in sat, owned
} orr_clock_table;

// The clocks of one file.
typedef struct orr_clock_source {
    const char *name; // for what is told of it
    orr_time first,
        observed;  // its first epoch, and the last one that was observed (the first where none was)
    double step_s; // the usual distance of its clocks; 0: it has none
    orr_clock_table table;
} orr_clock_source;

// Takes the clocks of several files of one kind together.
// Given:
//   source     [n] files, in any order: what comes out does not depend on it
//   n          how many
//   max_gap_s  a file's stretch goes on over holes of so much
// Returned:
//   out        clocks; nodes' source is 0, and 1 for the second of two at one instant; free with orr_clock_table_free
//   warnings   files that were aligned, and by how much; may be NULL
// Errors: ORR_E_MEMORY.
// Notes: what one file observed comes before what another predicted; among observations the file that begins later, among
// predictions the one that rests on later observations, comes first. A file that comes later gives only what lies outside
// the stretches taken before; where two stretches meet at one instant both nodes stay, left and right of a jump. Files
// that share more than one instant are aligned to those taken before; files that only meet are not.
orr_status orr_clock_sources_join(const orr_clock_source *source, size_t n, double max_gap_s,
                                  orr_clock_table *out, orr_warnings *warnings);

// Puts clocks (of RINEX CLK files) in the place of others (of the orbits' files) wherever they exist.
// Given:
//   name       of the first, for what is told
//   max_gap_s  a stretch goes on over holes of so much
//   better     clocks that come first; they are aligned to the reference of the others
//   base       clocks that fill what the first do not have
// Returned:
//   base       both
//   better     changed, and still the caller's
//   warnings   how the two differ, where they do; may be NULL
// Errors: ORR_E_MEMORY.
orr_status orr_clock_table_replace(const char *name, double max_gap_s, orr_clock_table *better,
                                   orr_clock_table *base, orr_warnings *warnings);

// Frees the lists and their nodes; the table is empty afterwards.
void orr_clock_table_free(orr_clock_table *t);

#endif
