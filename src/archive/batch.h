// SPDX-License-Identifier: GPL-3.0-or-later
// Days made side by side, each in a process of its own: a day that fails, or is killed, takes nothing with it.
#ifndef ORR_ARCHIVE_BATCH_H
#define ORR_ARCHIVE_BATCH_H

#include "src/archive/day.h"

typedef enum orr_batch_outcome {
    ORR_BATCH_MADE,
    ORR_BATCH_FRESH, // was there, made from the same
    ORR_BATCH_FAILED,
} orr_batch_outcome;

typedef struct orr_batch_day {
    int32_t mjd;
    orr_batch_outcome outcome;
    double seconds;   // of making
    orr_diag failure; // where it failed
} orr_batch_day;

typedef struct orr_batch {
    orr_archive_settings settings;
    int32_t first, last; // days, both included
    int jobs;
    bool again; // make days that are fresh, too
    // Called after every day, in the order in which they end; may be NULL.
    void (*done)(void *user, const orr_batch_day *day, size_t n_done, size_t n_days);
    // Looked at ten times a second and more: true ends the batch. Days in the making are given up. May be NULL.
    bool (*stop)(void *user);
    void *user;
} orr_batch;

typedef struct orr_batch_report {
    size_t made, fresh, failed;
    size_t n; // days in order
    orr_batch_day *day;
} orr_batch_report;

// Runs a batch.
// Given:
//   b         what to do
//   index     input files
// Returned:
//   index     with the hashes of its files
//   out       every day's outcome; free with orr_batch_report_free whatever this returned
//   diag      why it could not go on; failures of days are none
// Errors: ORR_E_INTERRUPTED (finished days stay), ORR_E_IO (no process can be made, the archive cannot be written to), ORR_E_MEMORY.
orr_status orr_batch_run(const orr_batch *b, orr_archive_index *index, orr_batch_report *out, orr_diag *diag);
// Frees it; it is empty then.
void orr_batch_report_free(orr_batch_report *r);

#endif
