// SPDX-License-Identifier: GPL-3.0-or-later
// orrery iq: the service and the generator as one command, for people who want a file of samples. Two programs that speak
// over a socket of their own; nothing is done here that `orrery serve` and `orrery-generator` do not do.
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "src/cli/frame/options.h"

#define PATH_TEXT 1024
#define TURN_NS 20000000 // between looks at the children

extern char **environ; // NOLINT: POSIX has it declared by the program

typedef struct iq {
    orr_cli *c;
    char folder[64], url[PATH_TEXT]; // of the socket
    pid_t serve, generator;          // 0: not running
    int said;                        // what the service says; -1
    char line[2048];                 // of it, as far as it has come
    size_t n;
    bool ready;
} iq;

// The file beside this program, or the name alone, which is then looked up in PATH.
static void beside(const char *name, char path[PATH_TEXT])
{
    char self[PATH_TEXT];
    const ssize_t n = readlink("/proc/self/exe", self, sizeof self - 1);
    snprintf(path, PATH_TEXT, "%s", name);
    if (n <= 0) return;
    self[n] = '\0';
    char *slash = strrchr(self, '/');
    if (slash == NULL || strlen(name) + (size_t)(slash - self) + 2 > PATH_TEXT) return;
    snprintf(slash + 1, sizeof self - (size_t)(slash + 1 - self), "%s", name);
    if (access(self, X_OK) == 0) memcpy(path, self, sizeof self);
}

static int start(iq *q, char *const argv[], int err, pid_t *pid)
{
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (err >= 0) posix_spawn_file_actions_adddup2(&actions, err, STDERR_FILENO);
    const int bad = posix_spawnp(pid, argv[0], &actions, NULL, argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    if (bad == 0) return ORR_EXIT_OK;
    *pid = 0;
    return orr_cli_failf(q->c, "%s cannot be started: %s", argv[0], strerror(bad));
}

static int start_service(iq *q)
{
    char program[PATH_TEXT];
    int ends[2];
    beside("orrery", program);
    snprintf(q->folder, sizeof q->folder, "/tmp/orrery-iq-XXXXXX");
    if (mkdtemp(q->folder) == NULL) {
        const int why = errno;
        q->folder[0] = '\0';
        return orr_cli_failf(q->c, "a folder for the socket cannot be made in /tmp: %s", strerror(why));
    }
    snprintf(q->url, sizeof q->url, "unix:%s/socket", q->folder);
    if (pipe(ends) != 0) return orr_cli_failf(q->c, "a pipe cannot be made: %s", strerror(errno));
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFD, FD_CLOEXEC);
    fcntl(ends[0], F_SETFL, O_NONBLOCK);
    q->said = ends[0];
    char *argv[] = {program, "serve", (char *)q->c->operand[0], "--listen", q->url, NULL};
    const int code = start(q, argv, ends[1], &q->serve);
    close(ends[1]);
    return code;
}

// A line of the service: that it is ready is for us, anything else for the user.
static void take_line(iq *q)
{
    q->line[q->n] = '\0';
    if (strstr(q->line, "ready on ") != NULL)
        q->ready = true;
    else if (!q->c->quiet || q->serve == 0 || strstr(q->line, "error") != NULL)
        fprintf(stderr, "%s\n", q->line);
    q->n = 0;
}

static void listen_to_service(iq *q)
{
    char text[512];
    ssize_t n;
    while ((n = read(q->said, text, sizeof text)) > 0)
        for (ssize_t k = 0; k < n; k++) {
            if (text[k] == '\n' || q->n + 1 == sizeof q->line) take_line(q);
            if (text[k] != '\n') q->line[q->n++] = text[k];
        }
}

// An option that is handed on as it was written.
static size_t hand_on(const orr_cli *c, const char *name, const char *as, char **argv, size_t n)
{
    if (!orr_cli_given(c, name)) return n;
    argv[n++] = (char *)as;
    argv[n++] = (char *)orr_cli_text(c, name, "");
    return n;
}

static int start_generator(iq *q)
{
    char program[PATH_TEXT], output[PATH_TEXT];
    const char *folder = orr_cli_text(q->c, "output", "."), *name = q->c->operand[0],
               *slash = strrchr(name, '/');
    if (slash != NULL) name = slash + 1;
    const char *dot = strrchr(name, '.');
    const int length = dot != NULL && dot > name ? (int)(dot - name) : (int)strlen(name);
    beside("orrery-generator", program);
    if ((size_t)snprintf(output, sizeof output, "%s/%.*s", folder, length, name) >= sizeof output)
        return orr_cli_failf(q->c, "%s: the path is too long", folder);
    if (mkdir(folder, 0777) != 0 && errno != EEXIST)
        return orr_cli_failf(q->c, "%s: the folder cannot be made: %s", folder, strerror(errno));
    char *argv[32] = {program, q->url, "--output", output};
    size_t n = 4;
    static const struct {
        const char *name, *as;
    } handed[] = {{"rate", "--rate"},     {"centre", "--centre"},   {"signals", "--signals"},
                  {"format", "--format"}, {"antenna", "--antenna"}, {"cn0", "--cn0"},
                  {"seed", "--seed"}};
    for (size_t k = 0; k < sizeof handed / sizeof handed[0]; k++)
        n = hand_on(q->c, handed[k].name, handed[k].as, argv, n);
    char from[ORR_TIME_TEXT];
    if (orr_cli_given(q->c, "from")) {
        argv[n++] = "--from";
        argv[n++] = orr_time_text(orr_cli_time(q->c, "from", 0), from);
    }
    argv[n++] = "--seconds";
    argv[n++] = (char *)orr_cli_text(q->c, "seconds", "60");
    if (!orr_cli_given(q->c, "no-noise")) argv[n++] = "--noise";
    if (q->c->quiet) argv[n++] = "--quiet";
    argv[n] = NULL;
    return start(q, argv, -1, &q->generator);
}

// Whether a child has ended, and how: its exit status, or 128 and the signal.
static bool ended(pid_t *pid, int *status)
{
    int how;
    if (*pid == 0 || waitpid(*pid, &how, WNOHANG) != *pid) return false;
    *pid = 0;
    *status = WIFEXITED(how) ? WEXITSTATUS(how) : 128 + (WIFSIGNALED(how) ? WTERMSIG(how) : 0);
    return true;
}

static void stop(pid_t *pid, bool wait)
{
    if (*pid == 0) return;
    kill(*pid, SIGTERM);
    if (wait) waitpid(*pid, NULL, 0);
    *pid = 0;
}

static int conduct(iq *q)
{
    int code = start_service(q), status = 0;
    while (code == ORR_EXIT_OK) {
        const struct timespec turn = {0, TURN_NS};
        if (orr_cli_interrupted(q->c)) return ORR_EXIT_FAILED;
        listen_to_service(q);
        if (q->ready && q->generator == 0) code = start_generator(q);
        if (ended(&q->serve, &status)) {
            listen_to_service(q); // its last words
            return status != 0 && status < 128 ? status : orr_cli_failf(q->c, "the service has ended");
        }
        if (ended(&q->generator, &status)) return status;
        nanosleep(&turn, NULL);
    }
    return code;
}

static int run(orr_cli *c)
{
    iq q = {.c = c, .said = -1};
    orr_cli_hold(c);
    const int code = conduct(&q);
    const bool wait = !orr_cli_interrupted(c);
    stop(&q.generator, wait);
    stop(&q.serve, wait);
    if (q.said >= 0) close(q.said);
    if (q.folder[0] != '\0') {
        unlink(q.url + strlen("unix:"));
        rmdir(q.folder);
    }
    orr_cli_release(c);
    return code;
}

static const orr_option options[] = {
    ORR_OPTION_FOLDER(.help = "Folder of the recording, which is named as the scenario: .sigmf-data and "
                              ".sigmf-meta; made if "
                              "it is not "
                              "there."),
    {.name = "seconds", .kind = ORR_OPT_TEXT, .value = "S", .help = "How long; 60 by default."},
    {.name = "rate", .kind = ORR_OPT_TEXT, .value = "HZ", .help = "Samples a second, e.g. 5M, the default."},
    {.name = "centre",
     .kind = ORR_OPT_TEXT,
     .value = "HZ",
     .help = "Centre frequency, e.g. 1575.42M; by default the carrier of the first signal."},
    {.name = "signals",
     .kind = ORR_OPT_TEXT,
     .value = "LIST",
     .help = "Signals, e.g. G:L1CA,E:E1; by default all that fit between the edges."},
    {.name = "format",
     .kind = ORR_OPT_CHOICE,
     .value = "i8|i16|i2|f32",
     .fallback = "i8",
     .help = "The format of samples; i8 by default."},
    {.name = "antenna",
     .kind = ORR_OPT_TEXT,
     .value = "NAME",
     .help = "Name or number of the antenna; the first by default."},
    ORR_OPTION_FROM(.help = "Begin; by default the first whole second of the channels."),
    {.name = "no-noise", .kind = ORR_OPT_FLAG, .help = "The signals alone."},
    {.name = "seed",
     .kind = ORR_OPT_TEXT,
     .value = "N",
     .applies = "!no-noise",
     .help = "Seed of the noise; 1 by default."},
    {.name = "cn0",
     .kind = ORR_OPT_TEXT,
     .value = "DBHZ",
     .help = "Every signal at this C/N0 in place of its own power; its echoes are as much weaker as "
             "they are."},
};

const orr_command orr_cmd_iq = {
    .name = "iq",
    .group = "Scenarios",
    .summary = "baseband samples of a scenario's signals as a file that receivers read",
    .operands = "SCENARIO",
    .min_operands = 1,
    .max_operands = 1,
    .about =
        "Starts `orrery serve` on a socket of its own and `orrery-generator` beside it, and ends both. The "
        "recording is "
        "SigMF: samples, and a description with rate, centre, begin and satellites. Of several streams, "
        "pipes and the "
        "pace of a clock the generator itself knows more (`orrery-generator --help`, docs/generator.md).\n\n"
        "For files and conducted tests only: to radiate such signals is forbidden nearly everywhere.",
    .example = "orrery iq samples/rooftop.yaml -o iq --seconds 60 --rate 5M",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};
