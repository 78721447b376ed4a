// SPDX-License-Identifier: GPL-3.0-or-later
// Observations of a station read: of each satellite the pair of signals that is used, and its samples.
#ifndef ORR_IONO_PHASE_PHASE_READ_H
#define ORR_IONO_PHASE_PHASE_READ_H

#include "iono/phase/phase_tec.h"

// The pair of signals of a satellite.
typedef struct phase_choice {
    char phase[2][4], range[2][4];
    double freq_hz[2];
    int at[4]; // columns of phase 1, 2, range 1, 2 in the header in force; -1: not there
} phase_choice;

// Samples of one satellite as they are read.
typedef struct phase_raw {
    size_t n;
    orr_time *t;
    double (*value)[4]; // phases in cycles, ranges in metres
    uint8_t *lost;
    bool lost_next;
} phase_raw;

typedef struct phase_reading {
    const char *data; // the file's bytes
    size_t n_data;
    const orr_phase_options *o;
    struct phase_tally *tally[ORR_SAT_SLOTS]; // NULL: not seen
    phase_choice *choice[ORR_SAT_SLOTS];      // NULL: no phases on two frequencies
    phase_raw raw[ORR_SAT_SLOTS];
    char marker[64];
    orr_iono_site site;
    int8_t channel[100];
    double version;
    uint64_t n_samples;
    size_t n_epochs;
    orr_time *epoch;
} phase_reading;

// Reads observations.
//   Given:    name      of the file, for messages
//             data, n   its bytes, decompressed; borrowed
//             o         options; borrowed
//   Returned: out       samples by satellite; free with phase_reading_free; NULL on failure
//             warnings  of the reader, and satellites that are left out; may be NULL
//             diag      why it failed
//   Notes:    two passes: which signals each satellite has, then those of the chosen pair. So memory follows what is used,
//             whatever a receiver writes.
orr_status phase_read(const char *name, const void *data, size_t n, const orr_phase_options *o,
                      phase_reading **out, orr_warnings *warnings, orr_diag *diag);
void phase_reading_free(phase_reading *r); // NULL too

#endif
