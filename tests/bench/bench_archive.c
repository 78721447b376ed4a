// SPDX-License-Identifier: GPL-3.0-or-later
// What an archive costs a day: `orrery batch` on made days of 80 satellites (a month; ORRERY_DAYS=366: a year), beside single days made
// alone in the same run; two jobs beside one, and a bare computation on two cores beside one; memory of all its processes together.
#define _DEFAULT_SOURCE // wait4
#include <dirent.h>
#include <ftw.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/bench.h"
#include "bench/made_days.h"
#include "core/monotonic.h"
#include "core/robust.h"
#include "core/time.h"

enum { USUAL_DAYS = 30, SINGLES = 7, ARGUMENTS = 20 };
#define COST_LIMIT 1.2  // x days x median single day / jobs
#define SPEED_LIMIT 1.8 // from one job to two
#define MEMORY_LIMIT 150.0
#define DAY_LIMIT 2.0 // MB

// Proportional set size, MB, of a process; 0 where it is gone.
static double pss_mb(long pid)
{
    char path[64], line[128];
    double kb = 0;
    snprintf(path, sizeof path, "/proc/%ld/smaps_rollup", pid);
    FILE *f = fopen(path, "r");
    while (f != NULL && fgets(line, sizeof line, f) != NULL)
        if (sscanf(line, "Pss: %lf", &kb) == 1) break;
    if (f != NULL) fclose(f);
    return kb / 1024;
}

static double tree_mb(pid_t pid)
{
    char path[64];
    double sum = pss_mb(pid);
    long child;
    snprintf(path, sizeof path, "/proc/%ld/task/%ld/children", (long)pid, (long)pid);
    FILE *f = fopen(path, "r");
    while (f != NULL && fscanf(f, "%ld", &child) == 1) sum += pss_mb(child);
    if (f != NULL) fclose(f);
    return sum;
}

// What a run took: by the clock, and of the processors, which others on the machine do not lengthen.
typedef struct cost {
    double wall_s, cpu_s;
} cost;

// Runs the program; what it took, and the most memory that all its processes had together.
static cost run(const char *const *argv, double *most_mb)
{
    const double begin_s = orr_monotonic_s();
    const pid_t child = made_start(argv);
    int status = -1;
    struct rusage used;
    while (wait4(child, &status, WNOHANG, &used) == 0) {
        if (most_mb != NULL) *most_mb = fmax(*most_mb, tree_mb(child));
        usleep(20000);
    }
    made_must(WIFEXITED(status) && WEXITSTATUS(status) == 0, "orrery batch failed");
    return (cost){.wall_s = orr_monotonic_s() - begin_s,
                  .cpu_s = (double)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                           1e-6 * (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec)};
}

static int64_t bytes;
static int weigh(const char *path, const struct stat *st, int kind, struct FTW *at)
{
    (void)at;
    const size_t n = strlen(path);
    if (kind == FTW_F && n > 8 && strcmp(path + n - 8, "orbit.nc") == 0) bytes += st->st_size;
    return 0;
}
static int clear(const char *path, const struct stat *st, int kind, struct FTW *at)
{
    (void)st, (void)kind, (void)at;
    return remove(path);
}

// Days [first, first + n) of the inputs into an archive, which is weighed, in MB, and removed.
static cost batch(const char *folder, const char *jobs, size_t first, size_t n, double *most_mb, double *mb)
{
    char archive[ORR_MADE_PATH + 16], from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
    orr_time t0;
    made_must(orr_time_parse(MADE_FIRST, NULL, &t0, NULL) == ORR_OK, "the first day");
    snprintf(archive, sizeof archive, "%s-archive", folder);
    orr_time_text(orr_time_add_s(t0, 86400.0 * (double)first), from);
    orr_time_text(orr_time_add_s(t0, 86400.0 * (double)(first + n - 1)), to);
    const char *const argv[] = {ORR_PROGRAM, "batch", "-q",     "--archive", archive, "--inputs", folder,
                                "-j",        jobs,    "--from", from,        "--to",  to,         NULL};
    const cost taken = run(argv, most_mb);
    bytes = 0;
    (void)nftw(archive, weigh, 8, FTW_PHYS);
    if (mb != NULL) *mb = (double)bytes / 1e6;
    (void)nftw(archive, clear, 8, FTW_PHYS | FTW_DEPTH);
    return taken;
}

// Seconds that `n` processes need for the same computation each.
static double compute(int n)
{
    const double begin_s = orr_monotonic_s();
    for (int k = 0; k < n; k++)
        if (fork() == 0) {
            double x = 1;
            for (long i = 0; i < 400000000; i++) x = x * 0.999999 + 1e-7;
            _exit(x > 2);
        }
    while (wait(NULL) > 0) {
    }
    return orr_monotonic_s() - begin_s;
}

void bench_archive(bench *b)
{
    const char *asked = getenv("ORRERY_DAYS");
    const size_t days = asked != NULL && atol(asked) > SINGLES ? (size_t)atol(asked) : USUAL_DAYS;
    char folder[] = "/tmp/orr-bench-XXXXXX", text[96];
    char(*path)[ORR_MADE_PATH] = calloc(days, sizeof *path);
    double single_s[SINGLES], single_cpu_s[SINGLES], one_mb = 0, two_mb = 0, few_mb = 0, mb;
    made_must(path != NULL && mkdtemp(folder) != NULL, "no temporary folder");
    made_days(folder, days, path);
    snprintf(text, sizeof text, "An archive of %zu days of 80 satellites, orrery batch", days);
    bench_group(b, text);
    for (size_t k = 0; k < SINGLES; k++) // days with both neighbours
    {
        const cost c = batch(folder, "1", 1 + k * (days - 2) / SINGLES, 1, NULL, NULL);
        single_s[k] = c.wall_s;
        single_cpu_s[k] = c.cpu_s;
    }
    const double day_s = orr_median(single_s, SINGLES), day_cpu_s = orr_median(single_cpu_s, SINGLES);
    const double bare = compute(1), bare2 = compute(2);
    (void)batch(folder, "2", 0, SINGLES, &few_mb, NULL);
    const cost two = batch(folder, "2", 0, days, &two_mb, NULL);
    const cost one = batch(folder, "1", 0, days, &one_mb, &mb);
    bench_row(b, "a single day, median", day_s, 0, "s", "");
    bench_row(b, "one job", one.wall_s, COST_LIMIT * (double)days * day_s, "s", "1.2 x days x a single day");
    bench_row(b, "two jobs", two.wall_s, COST_LIMIT * (double)days * day_s / 2, "s", "the same / 2");
    bench_row(b, "one job, processor time", one.cpu_s, COST_LIMIT * (double)days * day_cpu_s, "s",
              "1.2 x days x a single day");
    bench_row(b, "two jobs, processor time", two.cpu_s, COST_LIMIT * (double)days * day_cpu_s, "s",
              "the same");
    bench_row(b, "from one job to two", one.wall_s / two.wall_s, SPEED_LIMIT, "x", "the bar");
    bench_row(b, "a bare computation on two cores", 2 * bare / bare2, 2, "x", "two cores");
    bench_row(b, "memory of two jobs, a week", few_mb, MEMORY_LIMIT, "MB", "the bar");
    bench_row(b, "memory of two jobs, all days", two_mb, MEMORY_LIMIT, "MB", "the bar");
    bench_row(b, "memory of one job, all days", one_mb, MEMORY_LIMIT, "MB", "the bar");
    bench_row(b, "orbit product of a day", mb / (double)days, DAY_LIMIT, "MB", "the bar");
    (void)nftw(folder, clear, 8, FTW_PHYS | FTW_DEPTH);
    free(path);
}
