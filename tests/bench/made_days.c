// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/made_days.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "core/parallel.h"

void made_must(bool good, const char *what)
{
    if (good) return;
    fprintf(stderr, "bench: %s\n", what);
    abort();
}

void made_days(const char *folder, size_t days, char (*path)[ORR_MADE_PATH])
{
    orr_diag d = {0};
    orr_made_plan p = {
        .folder = folder, .days = days, .step_ns = 900 * ORR_NS_PER_S, .jobs = orr_parallel_cores()};
    made_must(orr_time_parse(MADE_FIRST, NULL, &p.from, &d) == ORR_OK, d.text);
    made_must(orr_made_days(&p, &d) == ORR_OK, d.text);
    for (size_t k = 0; k < days; k++) made_must(orr_made_path(&p, k, path[k], &d) == ORR_OK, d.text);
}

pid_t made_start(const char *const *argv)
{
    const pid_t child = fork();
    made_must(child >= 0, "fork");
    if (child == 0) {
        const int nowhere = open("/dev/null", O_WRONLY);
        (void)dup2(nowhere, STDERR_FILENO);
        execv(ORR_PROGRAM, (char *const *)argv);
        _exit(127);
    }
    return child;
}
