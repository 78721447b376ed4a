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
    int dash;   // 0: a whole line; 1, 2, 3: patterns that black print tells apart; of marks: their shape
    int colour; // of the palette, from 0; lines of one kind may share one
} orr_plot_line;

// Values over a lattice, as colours: cells of one size about their middles. Not finite: left white.
typedef struct orr_plot_cells {
    const double *x, *y, *value; // [n]
    size_t n;
    double width, height; // of a cell, in units of the axes
    const char *label;    // of the scale of colours
} orr_plot_cells;

typedef struct orr_plot {
    const char *title, *x_label, *y_label;
    bool log_x, log_y;
    bool sky; // x is azimuth and y elevation in degrees: North up, East to the right, the horizon without
    const orr_plot_line *line;
    size_t n;
    const orr_plot_cells *cells; // under the lines; NULL: none
} orr_plot;

// Writes a figure.
//   Given:    path          where to; "-" is standard output
//             plot          what it shows
//   Returned: diag          why it failed; may be NULL
//   Notes:    ORR_E_NODATA where no point can be shown; those of orr_outfile_open and orr_outfile_commit.
orr_status orr_plot_write(const char *path, const orr_plot *plot, orr_diag *diag);

// Writes the same figure as a script of gnuplot with its numbers in it, which makes a PNG of 1800 by 1120 pixels.
//   Given:    path          of the script
//             png           name of the picture that it makes, as seen from where gnuplot runs
//             plot          what it shows
//   Returned: diag          why it failed; may be NULL
//   Notes:    errors of orr_outfile_open and orr_outfile_commit.
orr_status orr_plot_write_gnuplot(const char *path, const char *png, const orr_plot *plot, orr_diag *diag);

// Colours that readers with any sight tell apart, and gnuplot's and SVG's have in common: the k-th, repeated.
const char *orr_plot_colour(size_t k);
// The middle of a sky plot is 0, 0, its horizon 90 away: where a direction stands.
void orr_plot_sky_place(double az_deg, double el_deg, double *x, double *y);
// Where a track of a sky plot bears its name: the middle point of its longest stretch above the horizon; l->n where there is none.
size_t orr_plot_sky_name(const orr_plot_line *l);
// Of a scale from 0 to 1 that grows lighter all the way (also in grey), red, green and blue 0 to 255.
void orr_plot_shade(double part, int rgb[3]);

#endif
