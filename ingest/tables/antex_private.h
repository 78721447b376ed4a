// SPDX-License-Identifier: GPL-3.0-or-later
// The ANTEX reader's parts among themselves. Private to the ingest room.
#ifndef ORR_INGEST_TABLES_ANTEX_PRIVATE_H
#define ORR_INGEST_TABLES_ANTEX_PRIVATE_H

#include "core/cursor.h"
#include "ingest/tables/antex.h"

typedef struct antex_reader {
    orr_cursor c;
    orr_antex *out;
    orr_warnings *warnings;
    orr_diag *diag;
    orr_read_limits limits;
    size_t values, left_out;
    orr_diag first_reason;
    bool ended;             // the file ended inside the antenna
    bool at_end_of_antenna; // the complaint was about the END OF ANTENNA line or found there
} antex_reader;

// From the line behind START OF ANTENNA to END OF ANTENNA. On failure *a still holds what is to be freed.
orr_status antex_read_antenna(antex_reader *r, orr_antex_antenna *a, orr_diag *why);

#endif
