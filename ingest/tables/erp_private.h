// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of Earth rotation files among themselves. Private to the ingest room.
#ifndef ORR_INGEST_TABLES_ERP_PRIVATE_H
#define ORR_INGEST_TABLES_ERP_PRIVATE_H

#include "ingest/input/text_records.h"
#include "ingest/tables/erp.h"

#define ERP_MAX_COLUMNS 64
// 1962 (the first pole of the IERS) to 2200.
#define ERP_FIRST_MJD 37000
#define ERP_LAST_MJD 125000

// One line of a file: what it says of an instant.
typedef struct erp_row {
    double mjd;
    size_t order; // in the file
    orr_eop eop;
    orr_erp_detail detail;
} erp_row;

typedef struct erp_reader {
    orr_cursor c;
    orr_erp *out;
    orr_warnings *warnings;
    orr_diag *diag;
    orr_read_limits limits;
    const orr_leap_table *leap;
    int column[ERP_MAX_COLUMNS]; // erp_column of the IGS files
    size_t n_columns;
    bool other_count_said;
    orr_records_tally tally;
    erp_row *row;
    size_t n;
} erp_reader;

// Says that a date is none: ORR_E_FORMAT.
orr_status erp_bad_date(erp_reader *r, double mjd);
// Keeps a line's values if they can be: date, pole, UT1 - UTC. ORR_E_FORMAT with a sentence where they cannot,
// ORR_E_LIMIT, ORR_E_MEMORY.
orr_status erp_add_row(erp_reader *r, const erp_row *row);

// Which of the IERS' own files a line belongs to, by what is in it.
typedef enum erp_iers_kind { ERP_NOT_IERS, ERP_FINALS, ERP_C04 } erp_iers_kind;
erp_iers_kind erp_iers_line(orr_view line);
// Reads such a file from its first line of values to its end; lines of text are passed over.
orr_status erp_read_iers(erp_reader *r, orr_view first, erp_iers_kind kind);

#endif
