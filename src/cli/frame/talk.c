// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says on stderr.
#include <errno.h>
#include <stdarg.h>
#include <string.h>
#include <unistd.h>

#include "src/cli/frame/frame.h"

// "orrery states"
static void speaker(const orr_cli *c)
{
    fflush(stdout); // what was printed so far stands before the complaint where both go to one terminal
    fputs("orrery", stderr);
    if (c->command != NULL) fprintf(stderr, " %s", c->command->name);
    fputs(": ", stderr);
}

int orr_cli_fail(const orr_cli *c, const orr_diag *diag)
{
    char text[1024];
    speaker(c);
    fprintf(stderr, "%s\n", orr_diag_format(diag, text, sizeof text));
    return ORR_EXIT_FAILED;
}

int orr_cli_failf(const orr_cli *c, const char *fmt, ...)
{
    va_list ap;
    speaker(c);
    va_start(ap, fmt);
    vfprintf(stderr, fmt, ap);
    va_end(ap);
    fputc('\n', stderr);
    return ORR_EXIT_FAILED;
}

int orr_cli_usage(const orr_cli *c, const char *fmt, ...)
{
    va_list ap;
    speaker(c);
    va_start(ap, fmt);
    vfprintf(stderr, fmt, ap);
    va_end(ap);
    if (c->command != NULL)
        fprintf(stderr, "\nTry 'orrery %s --help'.\n", c->command->name);
    else
        fputs("\nTry 'orrery --help'.\n", stderr);
    return ORR_EXIT_USAGE;
}

void orr_cli_warnings(const orr_cli *c, const orr_warnings *w)
{
    enum { SHOWN = 10 };
    char text[1024];
    size_t n = w->kept < SHOWN ? w->kept : SHOWN;
    for (size_t i = 0; i < n; i++) {
        speaker(c);
        fprintf(stderr, "warning: %s\n", orr_diag_format(&w->item[i], text, sizeof text));
    }
    if (w->count > n) {
        speaker(c);
        fprintf(stderr, "warning: and %zu more like these\n", w->count - n);
    }
}

void orr_cli_say(const orr_cli *c, const char *fmt, ...)
{
    if (c->quiet) return;
    va_list ap;
    va_start(ap, fmt);
    vfprintf(stderr, fmt, ap);
    va_end(ap);
    fputc('\n', stderr);
}

void orr_cli_progress(const orr_cli *c, const char *what, size_t done, size_t total)
{
    if (c->quiet || !isatty(STDERR_FILENO)) return;
    if (done >= total)
        fputs("\r\033[K", stderr);
    else
        fprintf(stderr, "\r\033[K%s %zu/%zu", what, done, total);
    fflush(stderr);
}

int orr_cli_flush(const orr_cli *c)
{
    // ferror alone tells that some earlier write failed; errno is then only known if this flush fails too.
    bool earlier = ferror(stdout) != 0;
    if (fflush(stdout) == 0 && !earlier) return ORR_EXIT_OK;
    if (errno == EPIPE) return ORR_EXIT_FAILED; // the reader has seen enough: nothing to tell anyone
    return orr_cli_failf(c, "could not write to stdout: %s", strerror(errno != 0 ? errno : EIO));
}
