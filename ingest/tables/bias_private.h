// SPDX-License-Identifier: GPL-3.0-or-later
// The two kinds of bias files among themselves. Private to the ingest room.
#ifndef ORR_INGEST_TABLES_BIAS_PRIVATE_H
#define ORR_INGEST_TABLES_BIAS_PRIVATE_H

#include "core/cursor.h"
#include "ingest/tables/bias.h"

typedef struct bias_reader {
    orr_cursor c;
    orr_bias_set *out;
    orr_warnings *warnings;
    orr_diag *diag;
    orr_read_limits limits;
    size_t left_out;
    orr_diag first_reason; // why the first line that was left out was
} bias_reader;

// Appends, or reports the limit.
orr_status bias_add(bias_reader *r, const orr_bias *b);
// Notes a line that cannot be read: a warning, and the verdict should nothing else be readable. Always
// ORR_OK.
orr_status bias_leave_out(bias_reader *r, int column, const char *why);

orr_status bias_read_sinex(bias_reader *r, orr_view first);
orr_status bias_read_dcb(bias_reader *r, orr_view title);

#endif
