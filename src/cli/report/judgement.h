// SPDX-License-Identifier: GPL-3.0-or-later
// What a report says in words before it shows anything: what was processed, how good it is, and what is suspicious.
#ifndef ORR_CLI_REPORT_JUDGEMENT_H
#define ORR_CLI_REPORT_JUDGEMENT_H

#include "src/cli/report/figure.h"

#define JUDGEMENT_MOST 64

typedef struct judgement {
    size_t n_processed, n_good, n_suspicious;
    char processed[JUDGEMENT_MOST][320], good[JUDGEMENT_MOST][320], suspicious[JUDGEMENT_MOST][320];
} judgement;

// Judges the tables of a figure that was made: what is measured of them, against what it ought to be.
//   Given:    f       the figure
//             p       the folders
//   Returned: out     with sentences; none where the figure's tables are only shown
void judgement_of_figure(const figure *f, const figure_places *p, judgement *out);
// Judges an archive by its catalogue: its days, how they join, and which look unusual.
//   Given:    archive    its folder
//   Returned: out        with sentences
//             diag       ORR_E_IO, ORR_E_MEMORY
orr_status judgement_of_archive(const char *archive, judgement *out, orr_diag *diag);

// Further sentences, each as printf has it; beyond JUDGEMENT_MOST of a kind they are left out.
__attribute__((format(printf, 2, 3))) void judgement_processed(judgement *j, const char *words, ...);
__attribute__((format(printf, 2, 3))) void judgement_good(judgement *j, const char *words, ...);
__attribute__((format(printf, 2, 3))) void judgement_suspicious(judgement *j, const char *words, ...);

#endif
