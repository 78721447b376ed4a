// SPDX-License-Identifier: GPL-3.0-or-later
// What every command of the program stands on. A command is one file cmd_<name>.c that defines one
// `orr_command` (its words, its options, its run function) and one line in commands.def; options are parsed,
// checked and documented from the same table. The binary is build/<preset>/bin/orrery.
//
// The manners of the program: stdout is data, stderr is talk; `--format json` where a script may listen; exit status
// 0 done, 1 it could not be done, 2 a usage error; progress on a terminal only; an interrupt leaves no
// half file.
#ifndef ORR_CLI_FRAME_CLI_H
#define ORR_CLI_FRAME_CLI_H

#include "core/earth.h"
#include "core/log.h"
#include "core/sat.h"
#include "core/status.h"
#include "core/time.h"
#include "src/config/schema.h"

enum { ORR_EXIT_OK = 0, ORR_EXIT_FAILED = 1, ORR_EXIT_USAGE = 2 };

// How an option's value is read; a value that cannot be read ends the program with a sentence and status 2.
typedef enum orr_option_kind {
    ORR_OPT_FLAG,     // no value
    ORR_OPT_TEXT,     // as it stands
    ORR_OPT_INT,      // whole number within [min, max]
    ORR_OPT_REAL,     // finite number within [min, max]
    ORR_OPT_TIME,     // orr_time_parse
    ORR_OPT_INTERVAL, // TIME/TIME, the second not before the first
    ORR_OPT_DURATION, // orr_duration_parse, positive
    ORR_OPT_SATS,     // orr_sat_set_parse
    ORR_OPT_PLACE,    // LAT,LON[,H] in degrees (geodetic) and metres, or ecef:X,Y,Z in metres
    ORR_OPT_CHOICE,   // one of the words of `value`, which are divided by '|'
} orr_option_kind;

typedef struct orr_option {
    const char *name; // long name without the dashes
    char letter;      // short name, or 0
    orr_option_kind kind;
    const char *value; // how help shows the value: "FILE", "T", "csv|json"; NULL for a flag
    const char *help;  // one sentence or two; the default belongs in it
    bool required, repeated;
    bool writes; // of TEXT: the name of a file that is written; looked at before the command runs
    bool fills;  // of TEXT: the name of a folder that files are written into (orr_cli_file_check)
    // Where the option applies, as conditions that all have to hold, divided by commas; elsewhere it is refused, and help
    // says so. "bits": --bits is given; "el|az": one of them is; "!grid": --grid is not; "method=mean|state": so says
    // --method, or its fallback. NULL: everywhere.
    const char *applies;
    const char
        *fallback; // of a CHOICE that conditions ask for: its value where it is not given; NULL: not known
    // before the inputs are read (orr_cli_settle). Of a file that is written in any case: its name
    double min, max; // of INT and REAL; both 0: no bounds
} orr_option;

typedef struct orr_cli orr_cli;

typedef struct orr_command {
    const char *name;     // as typed: "states"
    const char *group;    // heading in `orrery --help`, e.g. "Orbits"; commands of a group are neighbours in
                          // commands.def
    const char *summary;  // one line, no full stop
    const char *operands; // how usage shows them: "PRODUCT TRUTH..."; NULL where there are none
    int min_operands, max_operands; // max -1: any number
    const char *about;              // paragraphs divided by a blank line; help wraps them. May be NULL
    const char *example;            // command lines, each of them on a line of its own; shown as they stand
    size_t n_options;
    const orr_option *option;
    int (*run)(orr_cli *c); // returns an exit status
} orr_command;

// Every command gets --help, --quiet and --verbose besides its own options; c->log follows the latter two.
struct orr_cli {
    const orr_command *command;
    const orr_log *log;
    const char *call; // the command line as typed, for a product's history
    int n_operands;
    char *const *operand;
    const orr_leap_table
        *leap;  // that UTC is converted by: --leap-seconds, ORRERY_LEAP_SECONDS, the system's, built in
    bool quiet; // no summaries and no progress on stderr: errors and warnings alone
    struct orr_cli_values *values;
};

// --- What was asked (`name` must be one of the command's options, of that kind) ---
bool orr_cli_given(const orr_cli *c, const char *name);
size_t orr_cli_count(const orr_cli *c, const char *name); // of a repeated option
const char *orr_cli_text(const orr_cli *c, const char *name,
                         const char *otherwise); // TEXT and CHOICE; the last given
// Whether a CHOICE is this word, given or by its fallback.
bool orr_cli_says(const orr_cli *c, const char *name, const char *word);
// The i-th value of a repeated TEXT or CHOICE option, from 0; NULL where there are not so many.
const char *orr_cli_text_at(const orr_cli *c, const char *name, size_t i);
// All values of a repeated option as a list of *n, to be freed with free(); NULL without memory.
const char **orr_cli_texts(const orr_cli *c, const char *name, size_t *n);
// The last value of an INT option; `otherwise` where it was not given.
int64_t orr_cli_int(const orr_cli *c, const char *name, int64_t otherwise);
// The same of a REAL option.
double orr_cli_real(const orr_cli *c, const char *name, double otherwise);
// The i-th value of a repeated REAL option, from 0; it must exist (orr_cli_count).
double orr_cli_real_at(const orr_cli *c, const char *name, size_t i);
// The same of a TIME option.
orr_time orr_cli_time(const orr_cli *c, const char *name, orr_time otherwise);
// A place as geodetic coordinates (height 0 where none was given); *out is left alone where it was not given.
bool orr_cli_place(const orr_cli *c, const char *name, orr_geodetic *out);
bool orr_cli_backward(const orr_cli *c); // --from and --to are both given, and --to is before --from
// The last value of a DURATION option, in ns; `otherwise_ns` where it was not given.
int64_t orr_cli_duration_ns(const orr_cli *c, const char *name, int64_t otherwise_ns);
// One value of an INTERVAL option.
// Given:
//   c     the call
//   name  the option's long name
//   i     which value, from 0; it must exist (orr_cli_count)
// Returned:
//   from  begin of the interval
//   to    its end, not before `from`
void orr_cli_interval_at(const orr_cli *c, const char *name, size_t i, orr_time *from, orr_time *to);
const orr_sat_set *orr_cli_sats(const orr_cli *c,
                                const char *name); // NULL where it was not given: all satellites

// Finite numbers that commas divide and that are the whole text, into v[0..most); how many, 0 where it is something else.
int orr_cli_numbers(const char *text, double *v, int most);

// Tells the value of an option that was not given and has no fallback, once the inputs told it: whatever was given and
// does not apply with it is refused. An exit status.
int orr_cli_settle(const orr_cli *c, const char *name, const char *value);

// --- Talk (stderr) ---
// "orrery states: <the diagnostic>"; returns ORR_EXIT_FAILED, so that a command can `return orr_cli_fail(c,
// &diag);`.
int orr_cli_fail(const orr_cli *c, const orr_diag *diag);
// The same from a format; for what a reader did not say itself.
int orr_cli_failf(const orr_cli *c, const char *fmt, ...) ORR_PRINTF(2, 3);
// A call that makes no sense: the sentence, and where help is. Returns ORR_EXIT_USAGE.
int orr_cli_usage(const orr_cli *c, const char *fmt, ...) ORR_PRINTF(2, 3);
// Prints the first warnings and how many more there were.
void orr_cli_warnings(const orr_cli *c, const orr_warnings *w);
// A line of a summary; nothing with --quiet.
void orr_cli_say(const orr_cli *c, const char *fmt, ...) ORR_PRINTF(2, 3);
// One line that is redrawn, on a terminal only; `done` = `total` removes it.
void orr_cli_progress(const orr_cli *c, const char *what, size_t done, size_t total);

// --- Signals ---

// SIGINT, SIGTERM, SIGHUP and SIGQUIT end a command at once, wherever it is, by the signal itself (130 and
// 143 in a shell); the temporary files of unfinished outputs (core/outfile.h) are removed first. A command
// need do nothing. One that has more to tidy up holds them: it asks orr_cli_interrupted() at least ten times
// a second and ends; after 0.2 s, or at a second signal, it is ended as above.
void orr_cli_hold(orr_cli *c);
// Whether a signal has come since signals were held.
bool orr_cli_interrupted(const orr_cli *c);
// Ends the holding: a signal that came meanwhile now ends the program.
void orr_cli_release(orr_cli *c);

// Flushes stdout and says so if what was printed could not be written (a full disk); ORR_EXIT_OK otherwise.
// The program calls it after every command; a command needs it only before it says that something is done.
int orr_cli_flush(const orr_cli *c);

// Outputs never destroy inputs that a scenario or a study names: whether no file of it is one that the command was told to
// write, or ORR_E_ARG. base is what orr_schema_read filled.
orr_status orr_cli_tree_check(const orr_cli *c, const orr_schema *schema, const void *base, orr_diag *diag);
// The same of a file in a folder that the command fills, before it is written.
//   Given:    c             the command
//             path          of the file
//             schema, base  the tree whose files it reads, as above; NULL: the operands alone
//   Returned: diag          ORR_E_ARG where the file is an input, read-only, or not ours without --force; ORR_E_IO
orr_status orr_cli_file_check(const orr_cli *c, const char *path, const orr_schema *schema, const void *base,
                              orr_diag *diag);

#endif
