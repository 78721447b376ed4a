// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the made truth as a gzipped SP3-d file (Hilla 2016). Not the program's own writer, so that what its
// reader reads was not written by its kin.
#ifndef ORR_SAMPLES_SP3_PRINT_H
#define ORR_SAMPLES_SP3_PRINT_H

#include "samples/make/truth.h"

// Epochs from `from` every interval_s, n of them. `what` is one comment line (at most 77 bytes) about this
// file.
orr_status orr_sample_sp3_print(const orr_sample_truth *t, orr_time from, int interval_s, int n,
                                const char *what, const char *path, orr_diag *diag);

#endif
