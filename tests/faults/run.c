// SPDX-License-Identifier: GPL-3.0-or-later
// The program with calls that can be made to fail: `run_faults COMMAND ARGUMENTS...` reads numbers from its input and for each runs the
// command in a child whose call of that number fails (0: none), with stdout and stderr in files of these names. It answers with a line
// each: the child's exit status or minus its signal, calls counted, how many failed, the name of the call, and where it was. With
// ORRERY_FAULTS_FILE the command runs at once, and whoever maps that file makes its calls fail.
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "wrap.h"

enum { SECONDS = 300 };

int orrery_main(int argc, char **argv);
void faults_count_stdout(void);

static void into(const char *name, int fd)
{
    const int f = open(name, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (f < 0 || dup2(f, fd) < 0) _exit(126);
    close(f);
}

static int run_once(faults *f, long long fail, int argc, char **argv)
{
    atomic_store(&f->calls, 0);
    atomic_store(&f->hits, 0);
    atomic_store(&f->fail, 0);
    f->name[0] = '\0';
    f->from = 0;
    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        const int none = open("/dev/null", O_RDONLY);
        dup2(none, 0);
        into("stdout", 1);
        into("stderr", 2);
        alarm(SECONDS);
        faults_count_stdout();
        atomic_store(&f->calls, 0); // ours do not count
        atomic_store(&f->fail, fail);
        const int status = orrery_main(argc, argv);
#ifdef ORR_COVERAGE
        atomic_store(&f->fail, -1); // gcov's calls as it writes what it counted are not the program's
#endif
        exit(status);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child) exit(125);
    return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

int main(int argc, char **argv)
{
    const char *file = getenv("ORRERY_FAULTS_FILE");
    faults *f = faults_share(file);
    if (file != NULL) return orrery_main(argc, argv);
    char line[64];
    while (fgets(line, sizeof line, stdin) != NULL) {
        const int status = run_once(f, atoll(line), argc, argv);
        printf("%d %lld %d %s %#lx\n", status, (long long)atomic_load(&f->calls), atomic_load(&f->hits),
               f->name[0] != '\0' ? f->name : "-", (unsigned long)(f->from - (uintptr_t)main));
        fflush(stdout);
    }
    return 0;
}
