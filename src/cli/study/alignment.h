// SPDX-License-Identifier: GPL-3.0-or-later
// The two kinds of `orrery alignment`.
#ifndef ORR_CLI_STUDY_ALIGNMENT_H
#define ORR_CLI_STUDY_ALIGNMENT_H

#include "src/cli/study/study.h"
#include "src/config/study_alignment.h"

// Makes and reports a transfer alignment. An exit status.
int orr_cli_transfer(orr_cli *c, const orr_study_alignment *study, orr_inputs *inputs);

#endif
