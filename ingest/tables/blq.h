// SPDX-License-Identifier: GPL-3.0-or-later
// BLQ: ocean tide loading of stations, by eleven constituents, as the loading providers of Onsala and others write it.
#ifndef ORR_INGEST_TABLES_BLQ_H
#define ORR_INGEST_TABLES_BLQ_H

#include "core/status.h"

enum { ORR_BLQ_TIDES = 11 }; // M2 S2 N2 K2 K1 O1 P1 Q1 Mf Mm Ssa

// A station's loading: up, West and South.
typedef struct orr_blq {
    double amplitude_m[3][ORR_BLQ_TIDES], lag_deg[3][ORR_BLQ_TIDES];
} orr_blq;

// Reads one station of such a file.
// Given:
//   path     of the file, which may be compressed
//   station  its name as it stands in the file, whatever the case
// Returned:
//   out      its loading
//   diag     why it failed, with the line
// Errors: those of orr_input_read_all; ORR_E_FORMAT (a station without its six lines of eleven numbers); ORR_E_NODATA (the file does
// not have the station; the sentence lists those that it has).
// Reference: header of the files of holt.oso.chalmers.se/loading.
orr_status orr_blq_read(const char *path, const char *station, orr_blq *out, orr_diag *diag);

#endif
