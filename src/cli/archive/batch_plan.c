// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/archive/batch_plan.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/outfile.h"
#include "src/archive/store.h"

#define HEAD "# orrery batch plan 1, by orrery " ORR_VERSION "\n"
#define LONGEST 512

int batch_plan_write(const orr_cli *c, int32_t first, int32_t last, size_t chunks)
{
    orr_outfile f;
    orr_diag diag = {0};
    const size_t n = (size_t)(last - first + 1);
    if (chunks > n) chunks = n;
    if (orr_outfile_open(orr_cli_text(c, "plan", NULL), &f, &diag) != ORR_OK) return orr_cli_fail(c, &diag);
    fprintf(f.stream, HEAD "# first and last day of each chunk\n");
    for (size_t i = 0; i < chunks; i++) {
        char from[ORR_ARCHIVE_DAY_TEXT], to[ORR_ARCHIVE_DAY_TEXT];
        fprintf(f.stream, "%s %s\n", orr_archive_day_text(first + (int32_t)(n * i / chunks), from),
                orr_archive_day_text(first + (int32_t)(n * (i + 1) / chunks) - 1, to));
    }
    if (orr_outfile_commit(&f, &diag) != ORR_OK) return orr_cli_fail(c, &diag);
    orr_cli_say(c, "%zu days in %zu chunks", n, chunks);
    return ORR_EXIT_OK;
}

static bool day_of(const char *text, int32_t *mjd)
{
    orr_time t;
    if (orr_time_parse(text, NULL, &t, NULL) != ORR_OK) return false;
    *mjd = orr_archive_day_of(t);
    return true;
}

int batch_plan_read(const orr_cli *c, const char *which, int32_t *first, int32_t *last)
{
    const char *colon = strrchr(which, ':');
    char path[ORR_ARCHIVE_PATH], line[LONGEST], from[32], to[32], *end = NULL;
    const long wanted = colon != NULL ? strtol(colon + 1, &end, 10) : 0;
    if (colon == NULL || colon == which || wanted < 1 || *end != '\0')
        return orr_cli_usage(c, "--chunk is FILE:N, a plan and the number of a chunk from 1 on");
    snprintf(path, sizeof path, "%.*s", (int)(colon - which), which);
    FILE *f = fopen(path, "r");
    if (f == NULL) return orr_cli_failf(c, "%s: cannot be opened: %s", path, strerror(errno));
    int status = ORR_EXIT_OK;
    long chunk = 0;
    if (fgets(line, sizeof line, f) == NULL || strncmp(line, "# orrery batch plan ", 20) != 0)
        status = orr_cli_failf(c, "%s: is no plan of 'orrery batch --plan'", path);
    else if (strcmp(line, HEAD) != 0)
        status =
            orr_cli_failf(c, "%s: is a plan of another program (%.60s): make it anew, or days are made twice",
                          path, line + 2);
    while (status == ORR_EXIT_OK && chunk < wanted && fgets(line, sizeof line, f) != NULL) {
        if (line[0] == '#') continue;
        chunk++;
        if (chunk == wanted && (sscanf(line, "%31s %31s", from, to) != 2 || !day_of(from, first) ||
                                !day_of(to, last) || *last < *first))
            status = orr_cli_failf(c, "%s: chunk %ld is no pair of days", path, wanted);
    }
    if (status == ORR_EXIT_OK && chunk < wanted)
        status = orr_cli_failf(c, "%s: has %ld chunks, not %ld", path, chunk, wanted);
    fclose(f);
    return status;
}
