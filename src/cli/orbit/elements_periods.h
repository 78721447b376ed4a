// SPDX-License-Identifier: GPL-3.0-or-later
// `orrery elements --periods`: the periods in the elements of each satellite, as a spectrum by least squares.
#ifndef ORR_CLI_ORBIT_ELEMENTS_PERIODS_H
#define ORR_CLI_ORBIT_ELEMENTS_PERIODS_H

#include "src/cli/frame/cli.h"
#include "src/make/elements.h"

typedef struct elements_periods {
    bool keeps;             // rows; otherwise they are handed on alone
    orr_elements_sink next; // that takes each row, too
    void *user;
    orr_elements_row *row; // [n]
    size_t n, room;
} elements_periods;

// An orr_elements_sink, user an elements_periods: keeps the row and hands it on.
orr_status elements_periods_take(void *user, const orr_elements_row *row, orr_diag *diag);
// Writes the spectra of a, e and i as CSV, and says each satellite's largest periods of the inclination.
//   Given:    c        the command, for its messages
//             x        rows that were taken
//             step_d   the shortest time between rows of a satellite
//             path     where to
//   Returned: diag     ORR_E_IO, ORR_E_MEMORY; ORR_E_NODATA where no satellite has rows enough
orr_status elements_periods_write(const orr_cli *c, elements_periods *x, double step_d, const char *path,
                                  orr_diag *diag);
// Frees the rows.
void elements_periods_free(elements_periods *x);

#endif
