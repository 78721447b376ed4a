// SPDX-License-Identifier: GPL-3.0-or-later
// How long a service took to answer, poll by poll: the histogram of `orrery poll --realtime --latency`.
#ifndef ORR_CLI_SERVICE_POLL_LATENCY_H
#define ORR_CLI_SERVICE_POLL_LATENCY_H

#include "src/cli/frame/cli.h"

#define POLL_LATENCY_BINS 256 // eight an octave, from a microsecond on: beyond an hour

typedef struct poll_latency {
    const char *path; // NULL: nothing is counted
    uint64_t n, bin[POLL_LATENCY_BINS];
    int64_t begun_ns, most_ns;
} poll_latency;

// A request is about to be sent; its answer has been taken.
void poll_latency_begin(poll_latency *l);
void poll_latency_end(poll_latency *l);
// Writes the histogram as CSV, a row a bin from the first that has something to the last, and says median, 99th percentile and maximum. Nothing
// where nothing was counted.
// Given:
//   c     the call
//   l     what was counted
// Returned:
//   diag  why it could not be written: errors of core/outfile.h
orr_status poll_latency_write(const orr_cli *c, const poll_latency *l, orr_diag *diag);

#endif
