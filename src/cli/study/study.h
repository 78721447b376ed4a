// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands on studies share: a YAML file as operand, tables as CSV or NetCDF, a figure, a report.
#ifndef ORR_CLI_STUDY_STUDY_H
#define ORR_CLI_STUDY_STUDY_H

#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"
#include "src/cli/frame/plot.h"
#include "src/make/study.h"

// Options for the tables of such commands.
#define ORR_STUDY_OPTIONS                                                                                    \
    ORR_OPTION_OUTPUT_AS(                                                                                    \
            .help =                                                                                          \
                "Write the results as NetCDF-4, or as CSV (the first table) where the name ends in .csv "    \
                "or is -."),                                                                                 \
        {.writes = true,                                                                                     \
         .name = "plot",                                                                                     \
         .kind = ORR_OPT_TEXT,                                                                               \
         .value = "FILE",                                                                                    \
         .help = "Draw the results as a figure (SVG); where the name ends in .gp, as a script of gnuplot "   \
                 "that makes a PNG."},                                                                       \
        {.name = "help-study",                                                                               \
         .kind = ORR_OPT_FLAG,                                                                               \
         .help = "Print all keys of the study's file, and end."},                                            \
        ORR_OPTION_REPORT

// Reads the operand into `base` by its table, and its bytes' hash into `inputs`. With --help-study it prints the keys.
//   Given:    c             the call
//             schema        root table of the study
//   Returned: base          schema->size bytes; free with orr_schema_free where *go is true
//             inputs        the file appended
//             go            whether there is a study to make
//   Notes:    an exit status.
int orr_cli_study_open(orr_cli *c, const orr_schema *schema, void *base, orr_inputs *inputs, bool *go);

typedef struct orr_study_column {
    const char *name;        // with its unit: "heading_arcsec"
    const char *unit;        // for NetCDF; NULL: none
    const char *help;        // what it is
    const char *const *word; // values are indices into these words, which end with NULL; NULL: numbers
} orr_study_column;

// Three columns of a vector in East, North, up.
#define ORR_STUDY_COLUMNS_ENU(name, unit, help)                                                              \
    {name "_east", unit, help ", East", NULL}, {name "_north", unit, help ", North", NULL},                  \
    {                                                                                                        \
        name "_up", unit, help ", up", NULL                                                                  \
    }

typedef struct orr_study_table {
    const char
        *name; // of the NetCDF dimension; with several tables the prefix of variables: "track_heading_arcsec"
    const orr_study_column *column;
    size_t n_columns;
    size_t n;            // rows
    const double *value; // [n][n_columns]
} orr_study_table;

// Writes --output, where it was given.
//   Given:    c             the call
//             title         of the study
//             inputs        what it was made from
//             table         [n_tables] the first alone goes into CSV
//             n_tables      how many
//   Returned: diag          why it failed; may be NULL
//   Notes:    those of core/outfile.h and core/ncfile.h; ORR_E_MEMORY.
orr_status orr_study_write(const orr_cli *c, const char *title, const orr_inputs *inputs,
                           const orr_study_table *table, size_t n_tables, orr_diag *diag);
// Writes a table to --csv, of commands that have it, where it was given. Errors as of core/outfile.h.
orr_status orr_study_write_series(const orr_cli *c, const orr_study_table *table, orr_diag *diag);
// Whether the results go to standard output, which then has no report.
bool orr_study_to_stdout(const orr_cli *c);
// Draws --plot, where it was given.
orr_status orr_study_plot(const orr_cli *c, const orr_plot *plot, orr_diag *diag);

#endif
