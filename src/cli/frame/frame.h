// SPDX-License-Identifier: GPL-3.0-or-later
// Between main.c and the files of this room; commands do not need it.
#ifndef ORR_CLI_FRAME_FRAME_PRIVATE_H
#define ORR_CLI_FRAME_FRAME_PRIVATE_H

#include <stdio.h>

#include "src/cli/frame/cli.h"

#define ORR_CLI_COMMON_OPTIONS 5
extern const orr_option orr_cli_common_options[ORR_CLI_COMMON_OPTIONS];
// How many of them a command has: the last, --force, only where it writes files.
size_t orr_cli_n_common(const orr_command *cmd);

typedef enum orr_cli_parse_result {
    ORR_CLI_RUN,
    ORR_CLI_HELP,
    ORR_CLI_WRONG,
    ORR_CLI_FAILED
} orr_cli_parse_result;

// Reads the words after the command's name. On ORR_CLI_WRONG and, without memory, ORR_CLI_FAILED the sentence has been printed. words[] is
// reordered (operands to the front). Free with orr_cli_args_free whatever it returned.
orr_cli_parse_result orr_cli_args_parse(orr_cli *c, int n_words, char **words);
// Frees what orr_cli_args_parse made; c may be parsed again.
void orr_cli_args_free(orr_cli *c);

// Whether everything that was given applies (orr_option.applies); an exit status, with its sentence.
int orr_cli_applies_check(const orr_cli *c);
// Whether the files that the command will write may be: none is an input or another output, none is read-only or somebody
// else's without --force, and every folder can be written to. An exit status, with its sentence.
int orr_cli_outputs_check(const orr_cli *c);
// Warns of NetCDF files that are read and have no seal, so that damage to them is not noticed.
void orr_cli_seals_warn(const orr_cli *c);
// The conditions in words: "only with --bits, not with --grid".
void orr_cli_applies_words(const char *applies, char *out, size_t n);

// Once, at the begin of main.
void orr_cli_signals_take(void);

// Texts that help and manual pages share.
#define ORR_CLI_ABOUT_TEXT                                                                                   \
    "Orrery is the back end of a GNSS signal generator. It turns IGS products into satellite states, "       \
    "ionospheric delays and matching inertial readings, and serves them by time tag."
#define ORR_CLI_TIMES_TEXT                                                                                   \
    "2024-02-04T00:15:00 (GPS scale), 2024-02-04T00:14:42Z (UTC), 2300:900 (GPS week:seconds), 2024-035 "    \
    "(year-day), 2024:035:00900 (SINEX), \"2024 2 4 0 15 0\", MJD60344.25."
#define ORR_CLI_STATUS_TEXT                                                                                  \
    "0: done. 1: it could not be done. 2: usage error. A signal ends a command at once (130 after SIGINT, "  \
    "143 after SIGTERM in a shell); unfinished output files are removed."

// A command's manual page in section 1, as troff source.
void orr_cli_man_command(FILE *f, const orr_command *command);
// The program's own manual page, which lists the commands of `list` (it ends with NULL).
void orr_cli_man_program(FILE *f, const orr_command *const *list);
// A completion script for bash, or for zsh, of all commands of `list` (it ends with NULL).
void orr_cli_completion(FILE *f, const orr_command *const *list, bool zsh);
// Release number; with `verbose` commit, compiler and libraries too.
void orr_cli_version(FILE *f, bool verbose);

// What `orrery COMMAND --help` prints.
void orr_cli_help_command(FILE *f, const orr_command *command);
// What `orrery --help` prints; `list` ends with NULL.
void orr_cli_help_program(FILE *f, const orr_command *const *list);

#endif
