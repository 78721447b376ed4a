// SPDX-License-Identifier: GPL-3.0-or-later
// make-days FOLDER DAYS [SATELLITES]: made days as SP3 files, for an archive of a year without real data (docs/figures.md).
#include <stdio.h>
#include <stdlib.h>

#include "bench/made_days.h"

int main(int argc, char **argv)
{
    orr_sat_set only;
    orr_diag d = {0};
    const long days = argc >= 3 ? strtol(argv[2], NULL, 10) : 0;
    if (argc < 3 || argc > 4 || days < 1 || days > 4000) {
        fprintf(stderr, "usage: make-days FOLDER DAYS [SATELLITES], DAYS from 1 to 4000\n");
        return 2;
    }
    if (argc == 4 && orr_sat_set_parse(argv[3], &only, &d) != ORR_OK) {
        fprintf(stderr, "make-days: %s\n", d.text);
        return 2;
    }
    char(*path)[MADE_PATH] = calloc((size_t)days, sizeof *path);
    made_must(path != NULL, "memory");
    made_days(argv[1], (size_t)days, argc == 4 ? &only : NULL, path);
    printf("%s to %s\n", path[0], path[days - 1]);
    free(path);
    return 0;
}
