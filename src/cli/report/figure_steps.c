// SPDX-License-Identifier: GPL-3.0-or-later
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "src/cli/report/figure.h"

#define NOTHING FIGURE_NEEDS_NOTHING
#define DATA FIGURE_NEEDS_DATA
#define ARCHIVE FIGURE_NEEDS_ARCHIVE
#define FIGURE(name, needs, title, text, steps, ...) {name, needs, title, text, steps, __VA_ARGS__},
const figure figures[] = {
#include "src/cli/report/figures.def"
};
const size_t n_figures = sizeof figures / sizeof figures[0];

#define MOST_WORDS 32
#define WORD 1200

// A word of a step as it is passed on.
static void put_word(const char *word, size_t n, const figure_places *p, char out[WORD])
{
    if (word[0] == '@')
        snprintf(out, WORD, "%s/%.*s", p->samples, (int)n - 1, word + 1);
    else if (word[0] == '#')
        snprintf(out, WORD, "%s/%.*s", p->data != NULL ? p->data : "", (int)n - 1, word + 1);
    else if (n == 1 && word[0] == '*')
        snprintf(out, WORD, "%s", p->archive != NULL ? p->archive : "");
    else
        snprintf(out, WORD, "%.*s", (int)n, word);
}

static size_t split(const char *step, const figure_places *p, char (*word)[WORD])
{
    size_t n = 0;
    while (*step != '\0' && n < MOST_WORDS) {
        const size_t length = strcspn(step, " ");
        if (length > 0) put_word(step, length, p, word[n++]);
        step += length + (step[length] == ' ');
    }
    return n;
}

// In the child: output and messages to files of the folder, then the program itself.
static _Noreturn void become(const figure *f, char (*word)[WORD], size_t n, const figure_places *p,
                             bool stays, pid_t parent)
{
    prctl(PR_SET_PDEATHSIG, SIGTERM); // it ends with us
    if (getppid() != parent) _exit(126);
    char name[64];
    char *argument[MOST_WORDS + 2] = {(char[]){"orrery"}};
    for (size_t i = 0; i < n; i++) argument[i + 1] = word[i];
    if (chdir(p->out) != 0) _exit(126);
    snprintf(name, sizeof name, "%s%s.txt", f->name, stays ? "-service" : "");
    const int out = open(name, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    snprintf(name, sizeof name, "%s%s.log", f->name, stays ? "-service" : "");
    const int log = open(name, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (out < 0 || log < 0 || dup2(out, STDOUT_FILENO) < 0 || dup2(log, STDERR_FILENO) < 0) _exit(126);
    execv("/proc/self/exe", argument);
    _exit(127);
}

// The last line of the log.
static void last_message(const figure *f, const figure_places *p, char *line, size_t n)
{
    char path[WORD], text[512];
    line[0] = '\0';
    snprintf(path, sizeof path, "%s/%s.log", p->out, f->name);
    FILE *log = fopen(path, "r");
    if (log == NULL) return;
    while (fgets(text, sizeof text, log) != NULL) snprintf(line, n, "%.*s", (int)strcspn(text, "\n"), text);
    fclose(log);
}

// Waits until the service has the socket file "unix:NAME" of its words; false where it ended, or took longer than anybody waits.
static bool is_serving(const figure_places *p, char (*word)[WORD], size_t n, pid_t pid)
{
    enum { WAITS = 1200, WAIT_NS = 50000000 };
    char path[2 * WORD] = "";
    for (size_t i = 0; i < n; i++)
        if (strncmp(word[i], "unix:", 5) == 0) snprintf(path, sizeof path, "%s/%s", p->out, word[i] + 5);
    for (int k = 0; k < WAITS; k++) {
        if (access(path, F_OK) == 0) return true;
        if (waitpid(pid, NULL, WNOHANG) == pid) return false;
        nanosleep(&(struct timespec){0, WAIT_NS}, NULL);
    }
    figure_end_service(pid);
    return false;
}

void figure_end_service(pid_t pid)
{
    if (pid <= 0 || kill(pid, SIGTERM) != 0) return;
    while (waitpid(pid, NULL, 0) < 0 && errno == EINTR) {
    }
}

orr_status figure_run_step(const figure *f, const char *step, const figure_places *p, pid_t *service,
                           orr_diag *diag)
{
    char(*word)[WORD] = calloc(MOST_WORDS, sizeof *word);
    if (word == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a command");
    const bool stays = step[0] == '&';
    const size_t n = split(step + stays, p, word);
    const pid_t parent = getpid(), pid = fork();
    if (pid == 0) become(f, word, n, p, stays, parent);
    const bool serves = pid > 0 && stays && is_serving(p, word, n, pid);
    free(word);
    if (pid < 0) return orr_diag_set(diag, ORR_E_IO, "no further process: %s", strerror(errno));
    int status = -1;
    if (serves) {
        *service = pid;
        return ORR_OK;
    }
    while (!stays && waitpid(pid, &status, 0) < 0 && errno == EINTR) {
    }
    if (!stays && WIFEXITED(status) && WEXITSTATUS(status) == 0) return ORR_OK;
    char why[400];
    last_message(f, p, why, sizeof why);
    return orr_diag_set(diag, ORR_E_NODATA, "%s", why[0] != '\0' ? why : "the command could not be run");
}

bool figure_picture(const figure *f, const char *folder)
{
    char script[WORD];
    snprintf(script, sizeof script, "%s/%s.gp", folder, f->name);
    if (access(script, R_OK) != 0) return false;
    const pid_t parent = getpid(), pid = fork();
    if (pid == 0) {
        char name[64];
        prctl(PR_SET_PDEATHSIG, SIGTERM);
        const int log = chdir(folder) == 0 ? open("/dev/null", O_WRONLY) : -1;
        snprintf(name, sizeof name, "%s.gp", f->name);
        if (getppid() != parent || log < 0 || dup2(log, STDERR_FILENO) < 0) _exit(126);
        execlp("gnuplot", "gnuplot", name, (char *)NULL);
        _exit(127);
    }
    int status = -1;
    while (pid > 0 && waitpid(pid, &status, 0) < 0 && errno == EINTR) {
    }
    if (pid > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0) return true;
    char picture[WORD];
    snprintf(picture, sizeof picture, "%s/%s.png", folder, f->name);
    (void)unlink(picture); // what it had begun
    return false;
}

void figure_step_text(const char *step, char *out, size_t n)
{
    const figure_places typed = {".", "samples", "$D", "ARCHIVE"};
    const bool stays = step[0] == '&';
    size_t at = (size_t)snprintf(out, n, "orrery");
    step += stays;
    while (*step != '\0' && at < n) {
        char word[WORD];
        const size_t length = strcspn(step, " ");
        put_word(step, length, &typed, word);
        const char *quote = strpbrk(word, "[]<>") != NULL ? "'" : "";
        at += (size_t)snprintf(out + at, n - at, " %s%s%s", quote, word, quote);
        step += length + (step[length] == ' ');
    }
    if (stays && at < n) snprintf(out + at, n - at, " &");
}
