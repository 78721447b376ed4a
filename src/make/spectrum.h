// SPDX-License-Identifier: GPL-3.0-or-later
// A spectrum of vibration as a table: a frequency in Hz and a density a row.
#ifndef ORR_MAKE_SPECTRUM_H
#define ORR_MAKE_SPECTRUM_H

#include "src/make/inputs.h"

typedef struct orr_spectrum_table {
    size_t n;
    double *frequency_hz, *density;
} orr_spectrum_table;

// Reads two numbers a row, divided by commas, semicolons or blanks; lines of '#' and a first row without any number are
// skipped.
//   Given:    inputs        what has been read so far
//             path          of the table
//   Returned: out           the table; free with orr_spectrum_free, whatever was returned
//   Notes:    ORR_E_FORMAT with the line, ORR_E_NODATA, ORR_E_LIMIT (10000 rows), ORR_E_MEMORY, those of reading. Whether
//             frequencies ascend is for orr_vibration_psd_check to say.
orr_status orr_spectrum_read(orr_inputs *inputs, const char *path, orr_spectrum_table *out, orr_diag *diag);
// Frees all; an empty table is allowed.
void orr_spectrum_free(orr_spectrum_table *t);

#endif
