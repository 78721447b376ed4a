// SPDX-License-Identifier: GPL-3.0-or-later
// The clock reader's parts among themselves. Private to the ingest room.
#ifndef ORR_INGEST_RINEX_CLK_PRIVATE_H
#define ORR_INGEST_RINEX_CLK_PRIVATE_H

#include "core/cursor.h"
#include "ingest/input/text_records.h"
#include "ingest/rinex/clk.h"

// One clock while it is read.
typedef struct clk_build {
    orr_clk_series s;
} clk_build;

typedef struct clk_list {
    size_t n;
    size_t guess; // files name their clocks in the same order again and again
    clk_build *item;
} clk_list;

// Distinct instants in the order of the file.
typedef struct clk_epochs {
    size_t n;
    orr_time *t;
} clk_epochs;

typedef struct clk_reader {
    orr_cursor c;
    orr_clk *out;
    orr_warnings *warnings;
    orr_diag *diag;
    orr_read_limits limits;
    size_t records;
    orr_records_tally tally;
    clk_list sats, receivers;
    clk_epochs sat_epochs, receiver_epochs;
    char last_epoch[40]; // text of the last date, and what it meant
    size_t last_epoch_n;
    orr_time last_time;
} clk_reader;

orr_status clk_read_records(clk_reader *r);

#endif
