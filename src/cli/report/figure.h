// SPDX-License-Identifier: GPL-3.0-or-later
// A figure: commands of this program, and how their table is drawn.
#ifndef ORR_CLI_REPORT_FIGURE_H
#define ORR_CLI_REPORT_FIGURE_H

#include <sys/types.h>

#include "src/cli/frame/cli.h"

typedef enum figure_needs { FIGURE_NEEDS_NOTHING, FIGURE_NEEDS_DATA, FIGURE_NEEDS_ARCHIVE } figure_needs;

typedef enum figure_kind {
    FIGURE_LINES,
    FIGURE_MARKS, // points alone
    FIGURE_SKY,   // x azimuth, y elevation, deg
    FIGURE_MAP,   // x longitude, y latitude; `line` is the column of the value
} figure_kind;

// What few figures want.
typedef struct figure_extras {
    bool centred;      // each line less its mean
    bool days;         // instants as days of the table, not hours
    const char *marks; // "name=x|name=x": upright lines, where x is within the others
    bool stairs;       // each value over the whole of its step, as a histogram's
} figure_extras;

typedef struct figure_plot {
    // File and columns; `line` NULL: one line. Several files, a line each, are "name=file|name=file:column"; `y` may name several
    // columns, "name=a|name=b", a line each. A column is taken as it is, with '-' before it negative, with '+' its size. Of `line`
    // the first letter alone counts where '.' follows its name: satellites by system.
    const char *csv, *x, *y, *line;
    const char *x_label, *y_label;
    double from, to; // of x; both 0: all
    bool log_x, log_y;
    double factor; // of y
    figure_kind kind;
    const char *where; // "column=value|value,...": rows that are drawn; NULL: all
    figure_extras more;
} figure_plot;

typedef struct figure {
    const char *name;
    figure_needs needs;
    const char *title, *text, *steps; // figures.def
    figure_plot plot;
} figure;

extern const figure figures[];
extern const size_t n_figures;

// Where things are: absolute paths.
typedef struct figure_places {
    const char *out, *samples, *data, *archive; // data and archive NULL where they were not given
} figure_places;

// Runs one step of a figure in the output folder; what it prints stands in NAME.txt, its messages in NAME.log.
// Given:
//   f       the figure
//   step    its command as figures.def has it
//   p       the folders
// Returned:
//   service the process of a step that stays, once it serves; else as it was
//   diag    the last message of a step that failed
// Errors: ORR_E_IO (no process), ORR_E_NODATA (the step failed).
orr_status figure_run_step(const figure *f, const char *step, const figure_places *p, pid_t *service,
                           orr_diag *diag);
// Ends the process of a step that stayed; 0: there is none.
void figure_end_service(pid_t service);
// The command as a reader types it in the checkout's root, into out[n].
void figure_step_text(const char *step, char *out, size_t n);
// Draws NAME.svg from its table, and a script of gnuplot, NAME.gp. ORR_E_IO, ORR_E_FORMAT (a column is missing), ORR_E_NODATA, ORR_E_MEMORY.
orr_status figure_draw(const figure *f, const char *folder, orr_diag *diag);

// The k-th field of a row of CSV, from 0, into out[n]; empty where there are not so many.
void figure_field(const char *row, int k, char *out, size_t n);
// Which column of a table's first row has that name; -1: none, or NULL.
int figure_column(const char *head, const char *name);

// Runs gnuplot on NAME.gp for NAME.png; false where there is no gnuplot, or it could not.
bool figure_picture(const figure *f, const char *folder);

#endif
