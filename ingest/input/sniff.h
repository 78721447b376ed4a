// SPDX-License-Identifier: GPL-3.0-or-later
// What kind of file some bytes are, judged by the bytes alone. Names of files lie; first lines rarely do.
#ifndef ORR_INGEST_INPUT_SNIFF_H
#define ORR_INGEST_INPUT_SNIFF_H

#include "core/cursor.h"
#include "core/status.h"

// In the order of the table in sniff.c.
typedef enum orr_kind {
    ORR_KIND_UNKNOWN, // text of no format that is known here
    ORR_KIND_EMPTY,
    ORR_KIND_BINARY, // not text
    ORR_KIND_WEB_PAGE,
    ORR_KIND_SP3,
    ORR_KIND_RINEX_NAV,
    ORR_KIND_RINEX_OBS,
    ORR_KIND_RINEX_MET,
    ORR_KIND_RINEX_CLK,
    ORR_KIND_CRINEX, // Hatanaka's compact RINEX
    ORR_KIND_IONEX,
    ORR_KIND_ION, // Bernese spherical harmonics
    ORR_KIND_ERP,
    ORR_KIND_SINEX,
    ORR_KIND_BIAS_SINEX,
    ORR_KIND_TROPO_SINEX,
    ORR_KIND_DCB, // CODE's older differential code biases
    ORR_KIND_ANTEX,
    ORR_KIND_GPT3,      // grid of the weather over the year
    ORR_KIND_VMF3_GRID, // mapping coefficients and zenith delays of an instant at points of the Earth
    ORR_KIND_VMF3_SITE, // of stations
    ORR_KIND_ESRI_GRID, // ESRI's ASCII grid: heights of terrain
    ORR_KIND_NMEA,
    ORR_KIND_TABLE,  // numbers or words in columns (CSV, blanks): telemetry
    ORR_KIND_NETCDF, // NetCDF or HDF5: a product of ours
    ORR_KIND_LEAPS,  // IERS leap-seconds.list
    ORR_KIND_ZIP,    // an archive of files; told of, not read through
    ORR_KIND_N
} orr_kind;

typedef struct orr_sniffed {
    orr_kind kind;
    char version[8]; // as the format writes it: "d", "3.05", "1.0"; empty where there is none
} orr_sniffed;

// `head` is the start of the (decompressed) text; some KiB are enough. Never fails.
orr_sniffed orr_sniff(orr_view head);
const char *orr_kind_name(orr_kind k);  // "SP3 orbits", "RINEX navigation data", ...
const char *orr_kind_token(orr_kind k); // for scripts: "sp3", "rinex-nav", ...

// A set of kinds.
#define ORR_KIND_BIT(kind) (UINT64_C(1) << (kind))
// Every kind that Orrery has a reader of.
#define ORR_KINDS_KNOWN (~(ORR_KIND_BIT(ORR_KIND_WEB_PAGE + 1) - 1))
// ORR_E_KIND, with the file's name, where the start of its text is of none of `kinds`.
orr_status orr_sniff_expect(const char *name, orr_view head, uint64_t kinds, orr_diag *diag);

// Whether this is the first line of an SP3 file as it was before versions had letters:
// "#  1992  8 23  0  0  0.00000000      96 ...", or with P or V in column 3.
bool orr_sp3_is_unversioned(orr_view line);

#endif
