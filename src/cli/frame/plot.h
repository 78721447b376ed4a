// SPDX-License-Identifier: GPL-3.0-or-later
// Figures as SVG: lines and marks over two axes, linear or logarithmic. Every browser and word processor shows them,
// and no library is needed.
#ifndef ORR_CLI_FRAME_PLOT_H
#define ORR_CLI_FRAME_PLOT_H

#include <stdbool.h>
#include <stddef.h>

#include "core/status.h"

// One line. Points that are not finite, or not positive on a logarithmic axis, interrupt it.
typedef struct orr_plot_line {
    const char *label;   // in the legend; NULL: none
    const double *x, *y; // [n]
    size_t n;
    const double *low, *high; // [n] of error bars; NULL: none
    bool marks;               // points alone, without a line between them
    bool dashed;
    int colour; // of the palette, from 0; lines of one kind may share one
} orr_plot_line;

typedef struct orr_plot {
    const char *title, *x_label, *y_label;
    bool log_x, log_y;
    const orr_plot_line *line;
    size_t n;
} orr_plot;

// Writes a figure.
//   Given:    path          where to; "-" is standard output
//             plot          what it shows
//   Returned: diag          why it failed; may be NULL
//   Notes:    ORR_E_NODATA where no point can be shown; those of orr_outfile_open and orr_outfile_commit.
orr_status orr_plot_write(const char *path, const orr_plot *plot, orr_diag *diag);

#endif
