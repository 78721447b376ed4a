// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the data of samples/ again: three days of 15-minute SP3, and the middle day every 5 minutes to
// compare with.
#include <stdio.h>
#include <string.h>

#include "samples/make/sp3_print.h"

static int fail(const orr_diag *d)
{
    char text[1024];
    fprintf(stderr, "make-samples: %s\n", orr_diag_format(d, text, sizeof text));
    return 1;
}

static orr_status print_day(const orr_sample_truth *t, int day, int interval_s, const char *what,
                            const char *folder, orr_diag *diag)
{
    orr_time from = orr_sample_start() + (orr_time)day * ORR_S_PER_DAY * ORR_NS_PER_S;
    orr_civil c;
    char path[1024];
    orr_time_to_civil(from, ORR_SCALE_GPS, NULL, &c);
    snprintf(path, sizeof path, "%s/ORR0TSTFIN_%04d%03d0000_01D_%02dM_ORB.SP3.gz", folder, c.year,
             orr_day_of_year(c.year, c.month, c.day), interval_s / 60);
    // with the 24:00 epoch, as the IGS has it since 2017
    orr_status s =
        orr_sample_sp3_print(t, from, interval_s, ORR_S_PER_DAY / interval_s + 1, what, path, diag);
    if (s == ORR_OK) printf("%s\n", path);
    return s;
}

int main(int argc, char **argv)
{
    orr_diag diag = {0};
    if (argc != 2 || argv[1][0] == '-') {
        fprintf(stderr,
                "usage: make-samples FOLDER\nWrites the made SP3 files of the samples into FOLDER.\n");
        return argc == 2 && strcmp(argv[1], "--help") == 0 ? 0 : 2;
    }
    orr_sample_truth *truth;
    if (orr_sample_truth_new(NULL, ORR_SAMPLE_DAYS, &truth, &diag) != ORR_OK) return fail(&diag);
    orr_status s = ORR_OK;
    for (int day = 0; s == ORR_OK && day < ORR_SAMPLE_DAYS; day++)
        s = print_day(truth, day, 900, "Sample: every 15 minutes, as an analysis centre publishes.", argv[1],
                      &diag);
    if (s == ORR_OK)
        s = print_day(truth, 1, 300, "Sample: truth of the middle day every 5 minutes, to compare with.",
                      argv[1], &diag);
    orr_sample_truth_free(truth);
    return s == ORR_OK ? 0 : fail(&diag);
}
