// SPDX-License-Identifier: GPL-3.0-or-later
// Code and phase biases: Bias-SINEX 1.00 (Schaer 2018) with absolute (OSB), differential (DSB) and
// inter-system (ISB) lines, and CODE's older DCB texts (P1-P2, P1-C1, P2-C2). Sign: true observation =
// measurement - bias.
#ifndef ORR_INGEST_TABLES_BIAS_H
#define ORR_INGEST_TABLES_BIAS_H

#include "core/sat.h"
#include "core/status.h"
#include "core/time.h"
#include "ingest/input/limits.h"

typedef enum orr_bias_kind { ORR_BIAS_OSB, ORR_BIAS_DSB, ORR_BIAS_ISB } orr_bias_kind;

typedef struct orr_bias {
    orr_bias_kind kind;
    orr_sat sat;      // ORR_SAT_NONE for a station's bias of a whole system
    char system;      // 'G', ...
    char svn[5];      // "G063"; empty if not told
    char station[17]; // "BOR1", "BOR100POL", or name and DOMES in the older texts; empty for a satellite
    // RINEX 3 codes ("C1W"); obs2 is empty for an OSB. The older texts' P1, P2 and C1 are C1W, C2W and C1C
    // for GPS, C1P, C2P and C1C for GLONASS; their C2 stays "C2", because it names no one signal.
    char obs1[4], obs2[4];
    orr_time from, until; // GPS scale, until exclusive; ORR_TIME_NONE where open
    bool in_cycles;       // unit "cyc" (phase): value_s and the rest are cycles then
    double value_s, sdev_s, slope_sps, slope_sdev_sps; // seconds at `from`...; NAN if not told (slope: NAN)
} orr_bias;

typedef struct orr_bias_set {
    char format[16]; // "BIAS-SINEX" or "CODE DCB"
    double version;  // 1.00; 0 for the older texts
    char agency[4];
    bool absolute;        // header says absolute ('A') rather than relative ('R')
    orr_scale scale;      // TIME_SYSTEM of the labels
    orr_time from, until; // of the file
    size_t n;
    orr_bias *bias; // file order
} orr_bias_set;

// Reads a whole file. Lines that cannot be read are warned of one by one and left out; a file none of whose lines
// can be read is refused.
//   Given:    path        the file, plain, gzip or .Z by content
//             limits      what is refused; NULL: the defaults
//   Returned: out         the biases, to be freed with orr_bias_free; empty on failure
//             warnings    complaints that did not stop the reading; may be NULL
//             diag        ORR_E_IO, ORR_E_KIND, ORR_E_FORMAT, ORR_E_LIMIT, ORR_E_MEMORY
orr_status orr_bias_read(const char *path, const orr_read_limits *limits, orr_bias_set *out,
                         orr_warnings *warnings, orr_diag *diag);
// The same from memory.
//   Given:    name        of the file, for messages
//             text, n     its n bytes, decompressed
//             limits      what is refused; NULL: the defaults
//   Returned: out, warnings, diag   as of orr_bias_read, but for ORR_E_IO
orr_status orr_bias_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                          orr_bias_set *out, orr_warnings *warnings, orr_diag *diag);
// Frees all and leaves *x empty.
void orr_bias_free(orr_bias_set *x);

// The absolute bias of a satellite's observable.
//   Given:    x           the biases
//             sat, obs    the satellite and its observable, e.g. "C1C"
//             t           the instant; a slope is applied where there is one
//   Returned: bias_s      seconds; untouched where there is none
//   Notes:    ORR_E_NODATA if the file has none for that instant; biases in cycles are not looked at.
orr_status orr_bias_osb(const orr_bias_set *x, orr_sat sat, const char *obs, orr_time t, double *bias_s);
// The differential bias of two observables of a satellite: from a DSB line in either direction, else from two OSB
// lines, else by one intermediate observable (C1C-C2W = (C1C-C1W) + (C1W-C2W)).
//   Given:    x           the biases
//             sat         the satellite
//             obs1, obs2  its observables, e.g. "C1C", "C2W"
//             t           the instant; a slope is applied where there is one
//   Returned: bias_s      obs1 - obs2, seconds; untouched where there is none
//   Notes:    ORR_E_NODATA if the file does not tell it.
orr_status orr_bias_dsb(const orr_bias_set *x, orr_sat sat, const char *obs1, const char *obs2, orr_time t,
                        double *bias_s);

#endif
