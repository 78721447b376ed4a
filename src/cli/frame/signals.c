// SPDX-License-Identifier: GPL-3.0-or-later
// How the program takes signals. A command that is told to stop has nothing to save: outputs are written
// beside their place and renamed when they are whole. So the handler removes what is unfinished and lets the
// signal end the program, whatever it is doing, be it a long computation or a read of a pipe that nobody
// writes to. A command that must tidy up by itself (fetch) holds signals for a while, and is ended all the
// same if it takes too long.
#include <signal.h>
#include <sys/time.h>

#include "core/outfile.h"
#include "src/cli/frame/frame.h"

enum { HELD_MS = 200 }; // what a command that holds signals has to end by itself

static const int stopping[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};
enum { N_STOPPING = sizeof stopping / sizeof stopping[0] };

// Signals act on the whole process, so this is the process's.
static volatile sig_atomic_t held;    // a command wants to end by itself
static volatile sig_atomic_t arrived; // the signal that came meanwhile

static void end_by(int sig)
{
    orr_outfile_remove_unfinished();
    struct sigaction usual = {.sa_handler = SIG_DFL};
    sigaction(sig, &usual, NULL);
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, sig);
    raise(sig);
    sigprocmask(SIG_UNBLOCK, &set, NULL); // blocked while its handler runs: it acts now
}

static void on_signal(int sig)
{
    if (!held || arrived != 0) end_by(sig);
    arrived = sig;
    const struct itimerval soon = {.it_value = {.tv_usec = HELD_MS * 1000}};
    setitimer(ITIMER_REAL, &soon, NULL);
}

static void on_alarm(int sig)
{
    (void)sig;
    if (arrived != 0) end_by(arrived);
}

void orr_cli_signals_take(void)
{
    struct sigaction act = {.sa_handler = on_signal}, before;
    sigemptyset(&act.sa_mask);
    for (int i = 0; i < N_STOPPING; i++) {
        // What a parent wants ignored (nohup, a shell's background job) stays ignored.
        if (sigaction(stopping[i], NULL, &before) == 0 && before.sa_handler != SIG_IGN)
            sigaction(stopping[i], &act, NULL);
    }
    act.sa_handler = on_alarm;
    sigaction(SIGALRM, &act, NULL);
    // A file that grows beyond the user's limit is a failed write, which is told and cleaned up.
    act.sa_handler = SIG_IGN;
    sigaction(SIGXFSZ, &act, NULL);
}

void orr_cli_hold(orr_cli *c)
{
    (void)c;
    held = 1;
}

bool orr_cli_interrupted(const orr_cli *c)
{
    (void)c;
    return arrived != 0;
}

void orr_cli_release(orr_cli *c)
{
    (void)c;
    held = 0;
    if (arrived != 0) end_by(arrived);
}
