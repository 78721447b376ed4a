// SPDX-License-Identifier: GPL-3.0-or-later
// Earth rotation parameters: IGS ERP files version 2 (Kouba 1997, "IGS Earth Rotation Parameter file format
// version 2"), whose columns centres write in their own order and words, read by the file's own header and unit lines;
// and the IERS' own finals.all and finals2000A (Bulletin A's values) and EOP C04 of 08, 14 and 20.
#ifndef ORR_INGEST_TABLES_ERP_H
#define ORR_INGEST_TABLES_ERP_H

#include <stdio.h>

#include "core/astro.h"
#include "core/status.h"
#include "ingest/input/limits.h"

// What a line says beside the four parameters; NAN where the file has no such column.
typedef struct orr_erp_detail {
    double xp_sdev_rad, yp_sdev_rad, ut1_sdev_s, lod_sdev_s;
    double xp_rate_radps, yp_rate_radps; // rad/s
    double xp_rate_sdev_radps, yp_rate_sdev_radps;
    double dpsi_rad, deps_rad; // celestial pole: dpsi and deps, or dX and dY, as the file has them

    int n_receivers, n_fixed, n_satellites; // -1 where not told
} orr_erp_detail;

typedef struct orr_erp {
    int version;            // of the IGS files; 0 of those of the IERS
    char title[161];        // first line that says what it is; empty if none does
    orr_eop_series series;  // ascending MJD UTC; pole rad, UT1 - UTC s, LOD s: what core/astro.h evaluates
    orr_erp_detail *detail; // [series.n]
} orr_erp;

// Reads a whole file in memory. Of two lines of one instant the later in the file is kept, with a warning.
//   Given:    name        of the file, for messages
//             text, n     its n bytes, decompressed
//             leap        turns UT1 - TAI columns into UT1 - UTC; NULL: built-in
//             limits      what is refused; NULL: the defaults
//   Returned: out         the parameters, to be freed with orr_erp_free; empty on failure
//             warnings    complaints that did not stop the reading; may be NULL
//             diag        ORR_E_KIND, ORR_E_FORMAT, ORR_E_LIMIT, ORR_E_UNSUPPORTED (UT1R: zonal tides
//                         taken out), ORR_E_MEMORY
orr_status orr_erp_parse(const char *name, const char *text, size_t n, const orr_leap_table *leap,
                         const orr_read_limits *limits, orr_erp *out, orr_warnings *warnings, orr_diag *diag);
// Frees all and leaves *x empty.
void orr_erp_free(orr_erp *x);

// Writes a file of version 2. What a detail does not know (NAN, -1) is written as 0, as the format has it.
// Given:
//   x          series and details; instants are whole hundredths of a day, as the format writes them
//   remark     lines of text that stand between the title and the columns' names; none begins with "MJD"
//   n_remarks  how many
//   stream     where it goes
// Returned:
//   diag       ORR_E_ARG (an instant that the format cannot hold), ORR_E_IO
orr_status orr_erp_print(const orr_erp *x, const char *const *remark, size_t n_remarks, FILE *stream,
                         orr_diag *diag);
// The same to a file, which appears whole or not at all; "-" is standard output.
// Given:
//   x, remark, n_remarks  as above
//   path                  of the file
// Returned:
//   diag                  as above
orr_status orr_erp_write(const orr_erp *x, const char *const *remark, size_t n_remarks, const char *path,
                         orr_diag *diag);

// One series from several files (daily ones of a campaign): ascending; of two values at one instant that of
// the later file in the list. Free the series with orr_erp_series_free.
orr_status orr_erp_merge(const orr_erp *in, size_t n, orr_eop_series *out, orr_diag *diag);
// Frees a series and leaves it empty.
void orr_erp_series_free(orr_eop_series *s);

#endif
