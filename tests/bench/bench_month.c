// SPDX-License-Identifier: GPL-3.0-or-later
// What a month of 80 satellites takes: `orrery orbit` on thirty made days of 15-minute positions, its peak memory (the most that
// was resident, wait4) and its time.
#define _DEFAULT_SOURCE // wait4
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/bench.h"
#include "bench/made_days.h"
#include "core/monotonic.h"

enum { DAYS = 30 };
#define MB_LIMIT 100.0

static void smooth(bench *b, const char *name, const char *jobs, const char *product,
                   char (*path)[ORR_MADE_PATH])
{
    const char *argv[DAYS + 8] = {ORR_PROGRAM, "orbit", "-q", "--jobs", jobs, "-o", product};
    for (size_t i = 0; i < DAYS; i++) argv[7 + i] = path[i];
    const double begin_s = orr_monotonic_s();
    const pid_t child = made_start(argv);
    int status;
    struct rusage used;
    made_must(wait4(child, &status, 0, &used) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0,
              "orrery orbit failed");
    char text[64];
    snprintf(text, sizeof text, "peak memory, %s", name);
    bench_row(b, text, (double)used.ru_maxrss / 1e3, MB_LIMIT, "MB", "the bar");
    snprintf(text, sizeof text, "SP3 to product, %s", name);
    bench_row(b, text, orr_monotonic_s() - begin_s, 0, "s", "");
    unlink(product);
}

void bench_month(bench *b)
{
    char folder[] = "/tmp/orr-bench-XXXXXX", path[DAYS][ORR_MADE_PATH], product[ORR_MADE_PATH];
    made_must(mkdtemp(folder) != NULL, "no temporary folder");
    snprintf(product, sizeof product, "%s/month.nc", folder);
    made_days(folder, DAYS, path);
    bench_group(b, "A month of 80 satellites, nodes every 15 min, orrery orbit");
    smooth(b, "one thread", "1", product, path);
    smooth(b, "two threads", "2", product, path);
    for (size_t i = 0; i < DAYS; i++) unlink(path[i]);
    rmdir(folder);
}
