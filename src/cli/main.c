// SPDX-License-Identifier: GPL-3.0-or-later
// The program: finds the command, reads its options, runs it.
#include <gsl/gsl_errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/ncfile.h"
#include "core/suggest.h"
#include "src/cli/frame/frame.h"

#define ORR_COMMAND(name) extern const orr_command orr_cmd_##name;
#include "src/cli/commands.def"
#undef ORR_COMMAND

#define ORR_COMMAND(name) &orr_cmd_##name,
static const orr_command *const commands[] = {
#include "src/cli/commands.def"
    NULL};
#undef ORR_COMMAND
enum { N_SLOTS = sizeof commands / sizeof commands[0] };

static void write_log(void *user, orr_log_level level, const char *line)
{
    const orr_cli *c = user;
    fprintf(stderr, "orrery %s: %s%s\n", c->command->name,
            level == ORR_LOG_ERROR  ? "error: "
            : level == ORR_LOG_WARN ? "warning: "
                                    : "",
            line);
}

static const orr_command *find_command(const char *name)
{
    for (size_t i = 0; commands[i] != NULL; i++)
        if (strcmp(commands[i]->name, name) == 0) return commands[i];
    return NULL;
}

static int unknown_command(const orr_cli *c, const char *name)
{
    const char *names[N_SLOTS];
    size_t n = 0;
    for (; commands[n] != NULL; n++) names[n] = commands[n]->name;
    names[n++] = "help";
    const char *near = orr_suggest_nearest(name, names, n);
    if (near != NULL) return orr_cli_usage(c, "there is no command '%s'; did you mean '%s'?", name, near);
    return orr_cli_usage(c, "there is no command '%s'", name);
}

static int help(const orr_cli *c, const char *name)
{
    const orr_command *cmd = name != NULL ? find_command(name) : NULL;
    if (name != NULL && cmd == NULL && strcmp(name, "help") != 0) return unknown_command(c, name);
    if (cmd != NULL)
        orr_cli_help_command(stdout, cmd);
    else
        orr_cli_help_program(stdout, commands);
    return orr_cli_flush(c);
}

// The manual page of a command, or of the program; the build makes pages by it.
static int man(const orr_cli *c, const char *name)
{
    const orr_command *cmd = name != NULL ? find_command(name) : NULL;
    if (name != NULL && cmd == NULL) return unknown_command(c, name);
    if (cmd != NULL)
        orr_cli_man_command(stdout, cmd);
    else
        orr_cli_man_program(stdout, commands);
    return orr_cli_flush(c);
}

static int completion(const orr_cli *c, const char *shell)
{
    const bool zsh = strcmp(shell, "zsh") == 0;
    if (!zsh && strcmp(shell, "bash") != 0) return orr_cli_usage(c, "--completion goes with bash or zsh");
    orr_cli_completion(stdout, commands, zsh);
    return orr_cli_flush(c);
}

// "orrery orbit -o day.nc day.sp3", cut if it is very long.
static void join_call(int argc, char *const *argv, char *call, size_t n)
{
    size_t at = (size_t)snprintf(call, n, "orrery");
    for (int i = 1; i < argc && at < n; i++) at += (size_t)snprintf(call + at, n - at, " %s", argv[i]);
}

// The file of leap seconds that the words name, or the environment; NULL: none. It is looked for before the other words
// are read, because times among them are converted by it.
static const char *leap_file(int n_words, char *const *words)
{
    static const char option[] = "--leap-seconds";
    const size_t n = sizeof option - 1;
    const char *file = getenv("ORRERY_LEAP_SECONDS");
    if (file != NULL && file[0] == '\0') file = NULL;
    for (int i = 0; i < n_words && strcmp(words[i], "--") != 0; i++) {
        if (strncmp(words[i], option, n) != 0) continue;
        if (words[i][n] == '=') file = words[i] + n + 1;
        if (words[i][n] == '\0' && i + 1 < n_words) file = words[i + 1];
    }
    return file;
}

static int run_command(orr_cli *c, int n_words, char **words);

static int run(orr_cli *c, int n_words, char **words)
{
    orr_leap_table leap;
    orr_diag diag = {0};
    if (orr_leap_choose(leap_file(n_words, words), &leap, &diag) != ORR_OK) return orr_cli_fail(c, &diag);
    c->leap = &leap;
    const int status = run_command(c, n_words, words);
    c->leap = NULL;
    orr_leap_free(&leap);
    return status;
}

static int run_command(orr_cli *c, int n_words, char **words)
{
    orr_log log = {.level = ORR_LOG_WARN, .write = write_log, .user = c};
    switch (orr_cli_args_parse(c, n_words, words)) {
    case ORR_CLI_WRONG:
        return ORR_EXIT_USAGE;
    case ORR_CLI_FAILED:
        return ORR_EXIT_FAILED;
    case ORR_CLI_HELP:
        orr_cli_help_command(stdout, c->command);
        return orr_cli_flush(c);
    case ORR_CLI_RUN:
        break;
    }
    if (orr_cli_applies_check(c) != ORR_EXIT_OK) return ORR_EXIT_USAGE;
    const int writable = orr_cli_outputs_check(c);
    if (writable != ORR_EXIT_OK) return writable;
    c->quiet = orr_cli_given(c, "quiet");
    if (orr_cli_given(c, "verbose")) log.level = ORR_LOG_DEBUG;
    c->log = &log;
    orr_cli_seals_warn(c);
    int status = c->command->run(c);
    int flushed = orr_cli_flush(c);
    return status != ORR_EXIT_OK ? status : flushed;
}

int main(int argc, char **argv)
{
    orr_cli c = {0};
    gsl_set_error_handler_off(); // its default one aborts; every result is checked instead
    orr_cli_signals_take();
    if (argc < 2) {
        orr_cli_help_program(stderr, commands);
        return ORR_EXIT_USAGE;
    }
    const char *word = argv[1];
    if (strcmp(word, "--version") == 0 || strcmp(word, "-V") == 0) {
        const char *more = argc > 2 ? argv[2] : "";
        const bool verbose = strcmp(more, "--verbose") == 0 || strcmp(more, "-v") == 0;
        if (argc > (verbose ? 3 : 2)) return orr_cli_usage(&c, "--version goes with --verbose alone");
        orr_cli_version(stdout, verbose);
        return orr_cli_flush(&c);
    }
    if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0) return help(&c, NULL);
    if (strcmp(word, "help") == 0) return help(&c, argc > 2 ? argv[2] : NULL);
    if (strcmp(word, "--man") == 0) return man(&c, argc > 2 ? argv[2] : NULL);
    if (strcmp(word, "--completion") == 0) return completion(&c, argc > 2 ? argv[2] : "");
    if (word[0] == '-') return orr_cli_usage(&c, "there is no option %s before a command", word);
    c.command = find_command(word);
    if (c.command == NULL) return unknown_command(&c, word);
    char call[4096];
    join_call(argc, argv, call, sizeof call);
    c.call = call;
    int status = run(&c, argc - 2, argv + 2);
    orr_cli_args_free(&c);
    if (orr_nc_left_open()) {
        fflush(NULL);
        _exit(status);
    }
    return status;
}
