// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of orrery-generator.
#ifndef ORR_GENERATOR_OPTIONS_H
#define ORR_GENERATOR_OPTIONS_H

#include "src/generator/kernel/output.h"

#define ORR_GEN_STREAMS 8

typedef struct orr_gen_stream_options {
    const char *output;        // path, or "-"
    double rate_hz, centre_hz; // centre 0: that of the first signal
    orr_gen_format format;
    const char *signals; // NULL: all that fit
} orr_gen_stream_options;

typedef struct orr_gen_options {
    const char *url;
    const char *antenna; // name or number
    int64_t from_ns;     // INT64_MIN: the begin of what is served
    double seconds;      // <= 0: to the end of what is served
    bool noise, pace, quiet;
    uint64_t seed;
    double cn0_dbhz, amplitude; // ORR_GEN_NO_LEVEL where not given
    double patience_s;
    unsigned threads;
    size_t n_streams;
    orr_gen_stream_options stream[ORR_GEN_STREAMS];
} orr_gen_options;

// Reads the command line. Returns -1 to go on, else the status to end with: what had to be said has been said. argv's texts are
// taken apart and must stay.
int orr_gen_options_read(int argc, char **argv, orr_gen_options *options);

#endif
